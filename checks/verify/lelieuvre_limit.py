"""Checks of section 4: discrete equations against the differential ones, by Taylor polynomials."""

from itertools import product
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import asymptotic_frames, discrete_surfaces
from checks.verify.discrete_lelieuvre import minus
from checks.verify.unit_vectors import symbols
from theory.vectors import Vector, added, cross, derivative, dot, scaled

H = sp.Symbol("h", positive=True)
_ZERO: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(0))
#: Degree of the Taylor polynomials; the remainder of N is of order h^(degree + 1).
_DEGREE = 4


def _coefficients(vector: Vector, power: int) -> Vector:
    """Coefficient of h^power in a vector that is a polynomial in h."""
    x, y, z = (sp.expand(entry).coeff(H, power) for entry in vector)
    return x, y, z


def _curve(at: Any) -> Vector:
    """Taylor polynomial of an arbitrary vector along a line, with free coefficients."""
    found = _ZERO
    for k in range(_DEGREE + 1):
        found = added(found, scaled(at**k, symbols(f"n{k}")))
    return found


def lelieuvre_discretised(
    setting: Setting, *, vertex_order: int = 1, middle_order: int = 2
) -> Evidence:
    """Orders to which a step over h, divided by h, is the derivative in (eq:lelieuvre).

    At the vertex from which the step is made, and at the middle of the edge. N is a Taylor
    polynomial of degree 4 with free coefficients; an order is proved where the lower coefficients
    vanish identically and the next does not.
    """
    parts = {}
    for family, step, derived in (
        ("u", discrete_surfaces.step_u, asymptotic_frames.lelieuvre_u),
        ("v", discrete_surfaces.step_v, asymptotic_frames.lelieuvre_v),
    ):
        rate = derived(symbols("n1"), symbols("n0"), cross)
        places = {
            "vertex": (sp.Integer(0), H, vertex_order),
            "middle": (-H / 2, H / 2, middle_order),
        }
        for place, (start, end, order) in places.items():
            error = minus(step(_curve(start), _curve(end)), scaled(H, rate))
            lower = {
                f"{family}, {place}: h^{k}": _coefficients(error, k + 1) for k in range(-1, order)
            }
            parts[f"{family}, {place}, lower"] = identities(setting, lower, shown="")
            first = _coefficients(error, order + 1)
            parts[f"{family}, {place}, order {order}"] = statement(
                any(entry != 0 for entry in first),
                shown="",
                witness=f"{family}-step at the {place}: the coefficient of h^{order} vanishes too",
            )
    return combined(
        parts,
        shown="a step divided by h agrees with r_u = N_u x N or r_v = -N_v x N to the order h "
        "exactly at its start, and to the order h^2 exactly at the middle of the edge, for a "
        "Taylor polynomial of N with free coefficients",
    )


def _patch(i: int, j: int) -> Vector:
    """Taylor polynomial of an arbitrary vector at the corner (i, j)/2 h of a quad about 0."""
    found = _ZERO
    for a, b in product(range(_DEGREE + 1), repeat=2):
        if a + b <= _DEGREE:
            weight = (i * H / 2) ** a * (j * H / 2) ** b
            found = added(found, scaled(weight, symbols(f"n{a}{b}")))
    return found


def condition_discretised(
    setting: Setting, *, power: int = 2, next_power: int = 4, difference: int = -1
) -> Evidence:
    """Whether the first line of (eqn:discreteconstantcurvaturepde) is h^2 N_uv x N + O(h^4).

    power: of h in the leading term; next_power: of the next one; difference: as printed.
    """
    quad = _patch(-1, -1), _patch(1, -1), _patch(-1, 1), _patch(1, 1)
    stated = discrete_surfaces.discretised(*quad, quarter=sp.Rational(1, 4), difference=difference)
    leading = cross(symbols("n11"), symbols("n00"))
    error = minus(stated, scaled(H**power, leading))
    lower = {f"h^{k}": _coefficients(error, k) for k in range(next_power)}
    return combined(
        {
            "lower": identities(setting, lower, shown=""),
            "next": statement(
                any(entry != 0 for entry in _coefficients(error, next_power)),
                shown="",
                witness=f"the coefficient of h^{next_power} vanishes too",
            ),
        },
        shown="at the centre of the quad the first line is h^2 N_uv x N, and differs from it by a "
        "term of the order h^4 exactly, for a Taylor polynomial with free coefficients; so it "
        "discretises N_uv x N = 0 once the factor h^2 is left out",
    )


def _unknown_normal() -> tuple[Vector, sp.Symbol, sp.Symbol]:
    """Unit vector that is an unknown function of u and v, by its latitude and longitude."""
    u, v = sp.symbols("u v", real=True)
    a, b = (sp.Function(name, real=True)(u, v) for name in ("a", "b"))
    return (sp.cos(a) * sp.cos(b), sp.cos(a) * sp.sin(b), sp.sin(a)), u, v


def face_reduces_to_moutard(setting: Setting, *, sign: int = -1, unit: bool = True) -> Evidence:
    """Whether a solution of N_uv = -(N_u.N_v) N gives a PS-front by (eq:lelieuvre).

    For an unknown unit normal: N_uv + (N_u.N_v) N is tangent, so it vanishes with N x N_uv; the
    gap of the mixed derivatives of r is 2 N_uv x N; r_u x r_v is a multiple of N, the coordinate
    lines are asymptotic, and K = -1. sign: of the Moutard equation; unit: |N| = 1, else 2.
    """
    normal, u, v = _unknown_normal()
    if not unit:
        normal = scaled(2, normal)
    n_u, n_v, n_uv = derivative(normal, u), derivative(normal, v), derivative(normal, u, v)
    r_u = asymptotic_frames.lelieuvre_u(n_u, normal, cross)
    r_v = asymptotic_frames.lelieuvre_v(n_v, normal, cross)
    gap = minus(derivative(r_u, v), derivative(r_v, u))
    area = cross(r_u, r_v)
    determinant = dot(normal, cross(n_u, n_v))
    # N.r_uu = N.r_vv = 0, so K = -(N.r_uv)^2/|r_u x r_v|^2, and r_u x r_v = -det N.
    mixed = dot(normal, derivative(r_u, v))
    found: dict[str, Any] = {
        "normal part of the Moutard equation": dot(normal, n_uv) - sign * dot(n_u, n_v),
        "r_uv - r_vu": minus(
            gap, scaled(2, asymptotic_frames.lorentz_harmonic(n_uv, normal, cross))
        ),
        "N.r_u": dot(normal, r_u),
        "N.r_v": dot(normal, r_v),
        "r_u x r_v": added(area, scaled(determinant, normal)),
        "N.r_uu": dot(normal, derivative(r_u, u)),
        "N.r_vv": dot(normal, derivative(r_v, v)),
        "N.r_uv": mixed - determinant,
        "K + 1, times a square": determinant**2 * (dot(normal, normal) - 1),
    }
    return identities(
        setting,
        found,
        shown="for every unit normal the Moutard equation is N x N_uv = 0, since its normal part "
        "holds identically; then r_u = N_u x N, r_v = -N_v x N close, N is normal to r, the lines "
        "are asymptotic and K = -1 wherever det(N, N_u, N_v) is not 0",
    )
