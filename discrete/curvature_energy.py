"""Bending energies of K-surfaces from the angles of their hyperbolic nets, whole and by sector.

On a quad with the angles A, B, A, B the angle between the asymptotic lines is phi = (A + pi - B)/2
= A + D/2 to second order in the edges, and its area is 2 D.
"""

from dataclasses import dataclass

import numpy as np

from discrete.branched_net import BranchedNet
from discrete.curvature_fields import CurvatureFields, curvature_fields
from discrete.signed_graph import BoolArray


@dataclass(frozen=True, kw_only=True)
class Energies:
    """Extremes of phi in radians, largest curvature, Willmore energy and area of a net.

    willmore: sum of area times (tan^2 + cot^2)(phi/2), the integral of the squared curvatures;
    area: by Gauss-Bonnet; quadrature: the sum of sin(phi) du dv, the same to second order.
    """

    min_angle: float
    max_angle: float
    max_curvature: float
    willmore: float
    area: float
    quadrature: float


def _over(fields: CurvatureFields, where: BoolArray) -> Energies:
    """Energies of some quads, at least one."""
    phi, area = fields.angles[where], fields.areas[where]
    return Energies(
        min_angle=float(phi.min()),
        max_angle=float(phi.max()),
        max_curvature=float(fields.max_curvatures[where].max()),
        willmore=float((area * fields.willmore_densities[where]).sum()),
        area=float(area.sum()),
        quadrature=float(fields.quadrature[where].sum()),
    )


def energies(net: BranchedNet) -> Energies:
    """Energies of the net. Raises AngleError where a quad is singular, with its number."""
    fields = curvature_fields(net)
    return _over(fields, np.ones(len(fields.angles), dtype=np.bool_))


def sector_energies(net: BranchedNet) -> tuple[Energies, ...]:
    """Energies of each sector of `net.placed`, of the quads that it keeps.

    Raises AngleError where a quad is singular, with its number.
    """
    fields = curvature_fields(net)
    return tuple(_over(fields, fields.sectors == k) for k in range(len(net.placed)))
