"""How far a quad of a K-surface is strained from its rhombus of H^2: exactly, at any vertex."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.verify import planar_stars as stars
from discrete.geodesics import difference
from discrete.space_forms import dot_h2, dot_s2


def uniform_strain(setting: Setting, *, cosh_power: int = 1, order: int = 2) -> Evidence:
    """Diagonals d in space and e on H^2 of a rhombus: d = 2 sinh(e/2)/cosh^cosh_power Delta.

    So d/e is sinh(x)/x at x = e/2 < Delta, between 1 and sinh(Delta)/Delta, over cosh Delta, at any
    angle; order: power of Delta by which its greatest and least deviation from 1 are divided.
    """
    plane, normals = stars.plane_corners(), stars.quad_normals("1", -1, half_turn=True)
    space = stars.space_corners(normals)
    positive = sp.Symbol("t_1", positive=True)
    angle = sp.Symbol("p", real=True)
    cosh = (1 + stars.T1**2) / (1 - stars.T1**2)
    residuals = {}
    for name, (a, b) in {"from p to p_uv": (0, 2), "from p_u to p_v": (1, 3)}.items():
        chord = difference(space[b], space[a])
        found = dot_s2(chord, chord) * cosh ** (2 * cosh_power) + 2 * (
            1 + dot_h2(plane[a], plane[b])
        )
        residuals[name] = found.as_expr(positive, positive, angle)
    step = sp.Symbol("Delta", positive=True)
    ends = {"short": 1 / sp.cosh(step), "long": sp.tanh(step) / step}
    limits = {name: sp.limit((1 - ratio) / step**order, step, 0) for name, ratio in ends.items()}
    parts = {
        "diagonals": identities(setting, residuals, where=(1 - positive,), shown="diagonals"),
        "order": statement(
            all(bool(value.is_finite and value.is_positive) for value in limits.values()),
            shown="order",
            witness=f"the deviations divided by Delta^{order} tend to {limits}",
        ),
    }
    return combined(
        parts,
        shown="both diagonals of every rhombus, whatever its angle and the degrees of its corners, "
        "become 2 sinh(e/2)/cosh Delta: the strain lies between 1 - tanh(Delta)/Delta and "
        "1 - 1/cosh Delta, of the order Delta^2 at branch points as elsewhere",
    )
