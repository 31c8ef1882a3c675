"""Section 3.1, items (G) to (J), as printed: angle, fundamental forms, Moutard, sine-Gordon.

Vectors are triples, in R^3 or by coefficients in a moving basis, so the products are handed in.
"""

from typing import Any

import sympy as sp

from checks.printed.asymptotic_frames import Cross, Rows
from theory.vectors import Vector, added, scaled


def naive_cosine(product: Any) -> Any:
    """Item (G): cos phi = r_u.r_v, the definition that is discarded; product: r_u.r_v."""
    return product


def cosine(product: Any, sigma: Any, *, sigma_power: int = 1) -> Any:
    """First line of (eq:def_phi): cos phi = sigma r_u.r_v; product: r_u.r_v."""
    return sigma**sigma_power * product


def cosine_of_normals(product: Any, sigma: Any, *, sign: int = -1, sigma_power: int = 1) -> Any:
    """First line of (eq:def_phi): cos phi = -sigma N_u.N_v; product: N_u.N_v."""
    return sign * sigma**sigma_power * product


def sine(triple: Any, sigma: Any, *, sign: int = 1, sigma_power: int = 1) -> Any:
    """Second line of (eq:def_phi): sin phi = sigma (r_u x r_v).N; triple: (r_u x r_v).N."""
    return sign * sigma**sigma_power * triple


def sine_squared(norm_squared: Any, *, power: int = 1) -> Any:
    """Third line of (eq:def_phi), squared: sin phi = |r_u x r_v|."""
    return norm_squared**power


def mixed_derivative(
    sin_phi: Any, normal: Vector, sigma: Any, *, sign: int = -1, sigma_power: int = 1
) -> Vector:
    """Fourth line of (eq:def_phi): r_uv = -sigma sin phi N."""
    return scaled(sign * sigma**sigma_power * sin_phi, normal)


def first_form(cos_phi: Any, sigma: Any, *, factor: int = 2, sigma_power: int = 1) -> Any:
    """First line of (eq:metrics): coefficients of du^2, du dv, dv^2 in g."""
    return (sp.Integer(1), factor * sigma**sigma_power * cos_phi, sp.Integer(1))


def second_form(sin_phi: Any, sigma: Any, *, factor: int = -2, sigma_power: int = 1) -> Any:
    """Second line of (eq:metrics): coefficients of du^2, du dv, dv^2 in h."""
    return (sp.Integer(0), factor * sigma**sigma_power * sin_phi, sp.Integer(0))


def second_form_definition(uu: Any, uv: Any, vu: Any, vv: Any, *, sign: int = 1) -> Any:
    """Second line of (eq:metrics): coefficients of du^2, du dv, dv^2 in dN.dr.

    uu, uv, vu, vv: N_u.r_u, N_u.r_v, N_v.r_u, N_v.r_v.
    """
    return (sign * uu, sign * (uv + vu), sign * vv)


def turned(normal: Vector, a: Vector, cross: Cross, *, quarters: int = 1) -> Vector:
    """Item (I): a tangent vector turned by quarters of pi/2 about N, by Rodrigues' formula."""
    angle = quarters * sp.pi / 2
    return added(scaled(sp.cos(angle), a), scaled(sp.sin(angle), cross(normal, a)))


def moutard_chain(
    r_u: Vector,
    r_v: Vector,
    normal: Vector,
    n_v: Vector,
    products: dict[str, Any],
    sigma: Any,
    cross: Cross,
    *,
    first: int = 1,
    second: int = -1,
    third: int = -1,
    fourth: int = 1,
    fifth: int = -1,
    swapped: bool = False,
) -> tuple[Vector, ...]:
    """Return the five right sides of (eq:moutard), in the order in which they are printed.

    products: the scalars r_u.r_v, r_u.N, N_u.N_v and cos phi under these names; the integers are
    the printed signs; swapped: sin phi in place of cos phi.
    """
    angle = products["sin phi"] if swapped else products["cos phi"]
    return (
        scaled(first, cross(n_v, r_u)),
        scaled(second, cross(cross(normal, r_v), r_u)),
        added(
            scaled(products["r_u.r_v"], normal),
            scaled(third * products["r_u.N"], r_v),
        ),
        scaled(fourth * sigma * angle, normal),
        scaled(fifth * products["N_u.N_v"], normal),
    )


def cross_derivative_u(
    cos_phi: Any,
    sin_phi: Any,
    sigma: Any,
    *,
    upper_sine: int = -1,
    upper_cosine: int = 1,
    lower_sine: int = 1,
    lower_cosine: int = -1,
    sigma_power: int = 1,
) -> Rows:
    """Display of item (J): the matrix of d/dv on (r_u, N x r_u, N)."""
    s = sigma**sigma_power
    return (
        (0, 0, s * upper_sine * sin_phi),
        (0, 0, s * upper_cosine * cos_phi),
        (s * lower_sine * sin_phi, s * lower_cosine * cos_phi, 0),
    )


def zero_curvature(
    a: sp.Matrix,
    b: sp.Matrix,
    a_v: sp.Matrix,
    b_u: sp.Matrix,
    *,
    derivative: int = -1,
    commutator: int = 1,
) -> sp.Matrix:
    """Item (J): left side A_v - B_u + [A, B] of the zero-curvature condition."""
    return a_v + derivative * b_u + commutator * (a * b - b * a)


def curvature_u(phi_u: Any, *, sign: int = -1) -> Any:
    """First line of (eq:sg): kappa^u = -phi_u."""
    return sign * phi_u


def curvature_v(phi_v: Any, *, sign: int = 1) -> Any:
    """First line of (eq:sg): kappa^v = phi_v."""
    return sign * phi_v


def sine_gordon(
    sin_phi: Any,
    cos_phi: Any,
    sigma: Any,
    *,
    sign: int = 1,
    sigma_power: int = 1,
    swapped: bool = False,
) -> Any:
    """Second line of (eq:sg): phi_uv = sigma sin phi, its right side; swapped: cos for sin."""
    return sign * sigma**sigma_power * (cos_phi if swapped else sin_phi)
