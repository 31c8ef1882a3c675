"""Curvatures and bending energies of K-surfaces from the angles of their hyperbolic nets.

On a quad with the angles A, B, A, B the angle between the asymptotic lines is phi = (A + pi - B)/2
= A + D/2 to second order in the edges, and its area is 2 D. The principal curvatures are tan(phi/2)
and -cot(phi/2).
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from discrete.branched_net import BranchedNet
from discrete.errors import AngleError

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Energies:
    """Extremes of phi in radians, largest curvature, Willmore energy and area of a net.

    willmore: sum of area times (tan^2 + cot^2)(phi/2), the integral of the squared curvatures.
    """

    min_angle: float
    max_angle: float
    max_curvature: float
    willmore: float
    area: float


def quad_angles(net: BranchedNet) -> FloatArray:
    """Angle phi at the middle of each quad of the complex."""
    corners = net.corner_angles
    return np.asarray((corners[:, 0] + np.pi - corners[:, 1]) / 2)


def quad_areas(net: BranchedNet) -> FloatArray:
    """Area of each quad on H^2, by Gauss-Bonnet: 2 pi minus the sum of its angles."""
    return np.asarray(2 * np.pi - net.corner_angles.sum(axis=1))


def energies(net: BranchedNet) -> Energies:
    """Energies of the net. Raises AngleError where a quad is singular, with its number."""
    phi, area = quad_angles(net), quad_areas(net)
    singular = np.flatnonzero(~((phi > 0) & (phi < np.pi)))
    if len(singular):
        face = int(singular[0])
        raise AngleError(
            f"face {face} of the net has the angle {phi[face]}, not between 0 and pi: the net "
            "reaches beyond a singular edge; cut it before"
        )
    half = phi / 2
    return Energies(
        min_angle=float(phi.min()),
        max_angle=float(phi.max()),
        max_curvature=float(np.maximum(np.tan(half), 1 / np.tan(half)).max()),
        willmore=float((area * (np.tan(half) ** 2 + np.tan(half) ** -2)).sum()),
        area=float(area.sum()),
    )
