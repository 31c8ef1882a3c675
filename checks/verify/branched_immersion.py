r"""Check of the definition of a branched immersion on the patched Amsler saddles of order m.

A sector of angle pi/m lies between straight asymptotic rays s_0 and s_1 through p, along which its
normal turns about the ray: N(t) = cos(t) e_3 +- sin(t) e_3 x s. The next sector is its image under
the half turn about their common ray, in the tangent plane and in H^2 the reflection in it.
"""

import numpy as np
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.verify.asymptotic_complexes_samples import samples
from discrete.asymptotic_complex import AsymptoticComplex

_ORDERS = (2, 3, 4, 6)
T = sp.Symbol("t", positive=True)
_E3 = sp.Matrix([0, 0, 1])


def _ray(angle: sp.Expr) -> sp.Matrix:
    return sp.Matrix([sp.cos(angle), sp.sin(angle), 0])


def _turn(ray: sp.Matrix, kind: str) -> sp.Matrix:
    """Half turn about a ray, or the reflection in the plane of the ray and e_3."""
    across = _E3.cross(ray)
    if kind == "half turn":
        return 2 * ray * ray.T - sp.eye(3)
    return sp.eye(3) - 2 * across * across.T


def _vanishes(matrix: sp.Matrix) -> bool:
    return all(sp.simplify(entry) == 0 for entry in matrix)


def _objection(m: int, share: sp.Rational, kind: str) -> str:
    """What keeps 2m copies of a sector of angle share pi/m from being an m-saddle; else empty."""
    angle = share * sp.pi / m
    if 2 * m * angle != 2 * sp.pi:
        return f"the {2 * m} angles {angle} of the sectors add up to {2 * m * angle}"
    whole = sp.eye(3)
    for i in range(1, 2 * m + 1):
        ray = _ray(i * angle)
        turn = _turn(ray, kind)
        normal = sp.cos(T) * _E3 + sp.sin(T) * _E3.cross(ray)
        if not _vanishes((turn * normal).cross(normal)):
            return f"along ray {i} the tangent planes of the two sectors differ: r is not C^1"
        # In the tangent plane both are the reflection that the next sector of H^2 is made by.
        plane = (turn - (2 * ray * ray.T - sp.eye(3)))[:2, :2]
        if not (_vanishes(plane) and _vanishes(turn * ray - ray)):
            return f"at ray {i} the map of the surface is not that of the hyperbolic sectors"
        whole = turn * whole
    if not _vanishes(whole - sp.eye(3)):
        return f"after {2 * m} sectors the surface does not close up"
    return ""


def _orders(complex_: AsymptoticComplex, vertex: int, *, centred: bool) -> set[int]:
    """Orders of the stars that contain an interior vertex: as their centre, or anywhere inside."""
    order = complex_.saddle_order
    if centred:
        return {int(order[vertex])}
    edges = complex_.edges[(complex_.edges == vertex).any(axis=1)]
    return {int(m) for m in order[np.unique(edges)] if m > 0}


def definition(
    setting: Setting, *, share: str = "1", turn: str = "half turn", centred: bool = True
) -> Evidence:
    """Build the m-saddles of Amsler sectors, and see that m_p belongs to the point.

    share: of the full turn that the sectors fill; turn: what takes one sector to the next;
    centred: whether tau_p(p) = 0, the centre of the star.
    """
    saddles = {}
    for m in _ORDERS:
        witness = _objection(m, sp.Rational(share), turn)
        saddles[f"order {m}"] = statement(not witness, shown="", witness=witness)
    ambiguous = ""
    for name, complex_ in samples(setting, simply_connected=True, random=4).items():
        for vertex in np.flatnonzero(~complex_.is_boundary).tolist():
            orders = _orders(complex_, vertex, centred=centred)
            if len(orders) > 1:
                ambiguous = f"{name}: vertex {vertex} lies in stars of the orders {sorted(orders)}"
                break
        if ambiguous:
            break
    return combined(
        {**saddles, "m_p": statement(not ambiguous, shown="", witness=ambiguous)},
        shown="2m sectors of angle pi/m, each the half turn of the last about their common ray, "
        "close up, with one tangent plane along each ray and as the reflections of a hyperbolic "
        "sector do: isometric and C^1 with m_p = m at p; other angles, or reflections in planes, "
        "do not",
    )
