"""The second fundamental form that a net of H^2 holds: exactly, from its lengths and angles."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.verify import planar_stars as stars
from discrete.geodesics import determinant, difference, sine_and_cosine_part
from discrete.space_forms import H2, dot_h2, dot_s2


def second_form(setting: Setting, *, factor: str = "1", power: int = 1, sign: int = 1) -> Evidence:
    """Second differences of a quad in space along its normal, against the quad of H^2 alone.

    h_uu and h_vv are dN . dr on the edges, as in (eq:metrics); h_uv = -N . (r_12 - r_1 - r_2 + r)
    is compared with sign factor sinh a sinh b sin A (cosh a + cosh b)/(cosh a cosh b (1 + cosh e)),
    A the angle, e the diagonal across; power: 1 for sin A, 0 for cos A in its place.
    """
    plane, normals = stars.plane_corners(), stars.quad_normals("1", -1, half_turn=True)
    space = stars.space_corners(normals)
    edges = {"h_uu": (0, 1), "h_vv": (0, 3), "h_vv, far": (1, 2), "h_uu, far": (3, 2)}
    found: dict[str, Any] = {
        name: dot_s2(difference(normals[b], normals[a]), difference(space[b], space[a]))
        for name, (a, b) in edges.items()
    }
    sine, cosine = sine_and_cosine_part(H2, plane[0], plane[1], plane[3])
    cosh_a, cosh_b = -dot_h2(plane[0], plane[1]), -dot_h2(plane[0], plane[3])
    across = 1 - dot_h2(plane[1], plane[3])
    angle = sine if power == 1 else cosine
    share = stars.FIELD(sp.QQ(sp.Rational(factor).p, sp.Rational(factor).q))
    held = share * angle * (cosh_a + cosh_b) / (cosh_a * cosh_b * across)
    mixed = [a - b - c + d for a, b, c, d in zip(*(space[k] for k in (2, 1, 3, 0)), strict=True)]
    found["h_uv"] = -dot_s2(normals[0], mixed) - sign * held
    one, other = difference(space[1], space[0]), difference(space[3], space[0])
    area = determinant(normals[0], one, other) * cosh_a * cosh_b - sine
    found["area of the first form"] = area
    positive = [sp.Symbol(name, positive=True) for name in ("t_1", "t_2")]
    unknown = (*positive, sp.Symbol("p", real=True))
    return identities(
        setting,
        {name: residual.as_expr(*unknown) for name, residual in found.items()},
        where=[1 - t for t in positive],
        shown="edges are asymptotic, h_uu = h_vv = 0, and h_uv is sin A tanh a tanh b (cosh a + "
        "cosh b)/(1 + cosh e) with the lengths a, b, e and the angle A of the quad of H^2: it "
        "tends to the area sin A ds^2 of the first form, so that K = -1",
    )
