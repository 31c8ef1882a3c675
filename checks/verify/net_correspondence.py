"""Section 4.1: rhombi of S^2, rhombi of H^2 and the quads of a K-surface that belong together."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from discrete.geodesics import sine_and_cosine_part
from discrete.quad_rule import close_quad
from discrete.space_forms import H2, ORIGIN, S2, SpaceForm, Triple, cross_s2, dot_s2

# tanh(Delta/2), and the tangent of a quarter of the angle A of the hyperbolic rhombus.
T, Q = sp.symbols("t q", positive=True)
_COSH, _SINH = (1 + T**2) / (1 - T**2), 2 * T / (1 - T**2)
_COS, _SIN = (1 - Q**2) / (1 + Q**2), 2 * Q / (1 + Q**2)  # of A/2
_RANGE = (1 - T, 1 - Q)


def _circular(scale: str) -> tuple[Any, Any]:
    """Cosine and sine of delta for tan(delta/2) = scale tanh(Delta/2)."""
    s = sp.Rational(scale) * T
    return (1 - s**2) / (1 + s**2), 2 * s / (1 + s**2)


def _rhombus(space: SpaceForm, lengths: Any, half_angle: Any) -> tuple[Triple, Triple, Triple]:
    """Vertices p1, p2, p12 beside the origin, from cosine and sine of side and half angle."""
    c, s = lengths
    p1 = (c, s * half_angle[0], -s * half_angle[1])
    p2 = (c, s * half_angle[0], s * half_angle[1])
    p12 = close_quad(space.dot, ORIGIN, p1, p2)
    return p1, p2, (sp.cancel(p12[0]), sp.cancel(p12[1]), sp.cancel(p12[2]))


def _edge(first: Triple, second: Triple, sign: int) -> Triple:
    """Edge of the surface between the points with these normals: + on u-edges, - on v-edges."""
    product = cross_s2(second, first)
    return (sign * product[0], sign * product[1], sign * product[2])


def equivalence(setting: Setting, *, scale: str = "1", v_sign: int = -1) -> Evidence:
    """Whether a rhombus of normals, one of H^2 and a quad in space have the same angles.

    The hyperbolic one has sides Delta and the angle A, the spherical one sides delta and pi - A,
    tan(delta/2) = scale tanh(Delta/2). The quad has the edges N_1 x N_0 and v_sign (N_2 x N_0).
    """
    circular = _circular(scale)
    h1, _, h12 = _rhombus(H2, (_COSH, _SINH), (_COS, _SIN))
    n1, n2, n12 = _rhombus(S2, circular, (_SIN, _COS))
    beside = (
        sine_and_cosine_part(H2, h1, h12, ORIGIN),
        sine_and_cosine_part(S2, n1, n12, ORIGIN),
    )
    (sine_h, cosine_h), (sine_s, cosine_s) = beside
    u, v = _edge(ORIGIN, n1, 1), _edge(ORIGIN, n2, v_sign)
    far = _edge(n1, n12, v_sign), _edge(n2, n12, 1)
    around = [u[k] + far[0][k] - v[k] - far[1][k] for k in range(3)]
    place = {T: sp.Rational(1, 3), Q: sp.Rational(1, 4)}
    straight = (cosine_h * cosine_s - sine_h * sine_s).subs(place)
    return combined(
        {
            "identities": identities(
                setting,
                {
                    "the quad in space closes": around,
                    "its star is planar": [dot_s2(u, ORIGIN), dot_s2(v, ORIGIN)],
                    "its edges are tanh Delta": dot_s2(u, u) - (_SINH / _COSH) ** 2,
                    "cos delta cosh Delta - 1": circular[0] * _COSH - 1,
                    "its angle is A": dot_s2(u, v) - dot_s2(u, u) * (_COS**2 - _SIN**2),
                    "its angle beside is B": dot_s2(far[0], u) * _SINH**2 + dot_s2(u, u) * cosine_h,
                    "sine of the sum of the angles beside": sine_h * cosine_s + cosine_h * sine_s,
                },
                where=_RANGE,
                shown="",
            ),
            "sum of the angles beside": statement(
                bool(straight < 0),
                shown="",
                witness=f"at {place} the angles beside A and pi - A do not add up to pi",
            ),
        },
        shown="a rhombus of H^2 with the angles A, B and one of S^2 with pi - A, pi - B belong "
        "together for all A where cos delta cosh Delta = 1; the quad in space has the angles A, B "
        "and edges sin delta = tanh Delta",
    )
