"""Fields on the quads of a branched net: angle, principal curvatures, area by two rules, sector.

The asymptotic lines meet at the angle phi; the principal curvatures are tan(phi/2) and
-cot(phi/2), up to the orientation of the normal. Areas on H^2: by Gauss-Bonnet from the angles, or
by quadrature of sin(phi) du dv.
"""

from dataclasses import dataclass

import numpy as np

from discrete.branched_net import BranchedNet
from discrete.errors import AngleError
from discrete.sector import FloatArray
from discrete.signed_graph import IntArray


@dataclass(frozen=True, kw_only=True, eq=False)
class CurvatureFields:
    """Values on the F faces of a net, in their order: arrays (F,).

    angles: phi at the middle, in radians; first, second: tan(phi/2) and -cot(phi/2); areas: by
    Gauss-Bonnet, quadrature: the product of both edges and sin(phi); sectors: numbers in
    `net.placed`.
    """

    angles: FloatArray
    first: FloatArray
    second: FloatArray
    areas: FloatArray
    quadrature: FloatArray
    sectors: IntArray

    @property
    def max_curvatures(self) -> FloatArray:
        """Larger of the absolute principal curvatures."""
        return np.maximum(self.first, -self.second)

    @property
    def willmore_densities(self) -> FloatArray:
        """Sum of the squares of the principal curvatures."""
        return self.first**2 + self.second**2


def quad_angles(net: BranchedNet) -> FloatArray:
    """Angle phi at the middle of each quad: (A + pi - B)/2 for its angles A, B, A, B."""
    corners = net.corner_angles
    return np.asarray((corners[:, 0] + np.pi - corners[:, 1]) / 2)


def quad_areas(net: BranchedNet) -> FloatArray:
    """Area of each quad on H^2, by Gauss-Bonnet: 2 pi minus the sum of its angles."""
    return np.asarray(2 * np.pi - net.corner_angles.sum(axis=1))


def quad_edge_products(net: BranchedNet) -> FloatArray:
    """Product of the lengths of a u- and a v-edge of each quad."""
    return np.concatenate(
        [np.outer(p.sector.u_lengths, p.sector.v_lengths)[p.kept] for p in net.placed]
    )


def quad_sectors(net: BranchedNet) -> IntArray:
    """Number of the sector of each quad."""
    sizes = [int(place.kept.sum()) for place in net.placed]
    return np.repeat(np.arange(len(sizes)), sizes)


def curvature_fields(net: BranchedNet) -> CurvatureFields:
    """Fields of a net. Raises AngleError where a quad is singular, with its number."""
    phi = quad_angles(net)
    singular = np.flatnonzero(~((phi > 0) & (phi < np.pi)))
    if len(singular):
        face = int(singular[0])
        raise AngleError(
            f"face {face} of the net has the angle {phi[face]}, not between 0 and pi: the net "
            "reaches beyond a singular edge; cut it before"
        )
    first = np.tan(phi / 2)
    return CurvatureFields(
        angles=phi,
        first=first,
        second=-1 / first,
        areas=quad_areas(net),
        quadrature=quad_edge_products(net) * np.sin(phi),
        sectors=quad_sectors(net),
    )
