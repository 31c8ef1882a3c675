"""The lemma on the cut of an Amsler sector, over its whole range, from the Bessel bounds."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import amsler_recursion as printed
from checks.printed import painleve_asymptotics
from checks.verify.amsler_bounds import certificate
from checks.verify.recursion_angle import sine_quotient
from checks.verify.recursion_lemma import corner_inside

X, U_MAX, V_MAX = sp.symbols("X u_max v_max", positive=True)
P, Q, K = sp.symbols("p q k", positive=True)


def whole_range(
    setting: Setting,
    *,
    lower: str = "1",
    upper: str = "1",
    constant: str = "at phi",
    share: str = "1",
) -> Evidence:
    """Both parts of the lemma on the range of the certificate of (boundCphi*).

    The certificate has sin phi/phi in place of C^2 at each z: it is at least C(phi*)^2 up to z*.
    The exact implication goes first, so that a false one does not wait for the certificate.
    """
    parts = {
        "cut": angle_on_cut(setting),
        "corner": lower_bound_at_corner(setting, share=share),
        "C^2 <= sin phi/phi": sine_quotient(setting),
    }
    if all(part.outcome == "pass" for part in parts.values()):
        parts["bounds"] = certificate(setting, lower=lower, upper=upper, constant=constant)
    reach = parts["bounds"].shown if "bounds" in parts else "not reached"
    return combined(
        parts,
        shown="zeta_n <= X <= z* where X <= 2 sqrt(u_max v_max): part 1 is the upper bound of "
        f"(boundCphi*) at z <= X, part 2 the lower one at z = zeta_n. The bounds: {reach}",
    )


def growth(setting: Setting, *, sign: int = 1) -> Evidence:
    """That I_0 grows: quotient of the coefficients of z^(2 k) and z^(2 k - 2), and the first."""
    coefficients = [painleve_asymptotics.linear_coefficient(k, sign=sign) for k in (K, K - 1)]
    quotient = sp.gammasimp(coefficients[0] / coefficients[1])
    first = painleve_asymptotics.linear_coefficient(sp.Integer(0), sign=sign)
    return positivity(
        setting, {"quotient": quotient, "first": first}, shown="every coefficient of I_0 is > 0"
    )


def cut_before_threshold(setting: Setting, *, grown: str = "1", sign: int = 1) -> Evidence:
    """That grown X <= z*: a z* below would have phi_n I_0(z*) < phi_n I_0(X) = phi* = phi(z*)."""
    crossing = sp.Rational(grown) * X / (1 + P / 100)
    return combined(
        {
            "place": positivity(setting, {"X - z*": X - crossing}, shown=""),
            "growth": growth(setting, sign=sign),
        },
        shown="z* < X would give phi(z*) <= phi_n I_0(z*) < phi_n I_0(X) = phi*, so X <= z*: rests "
        "on the upper bound of (boundCphi*), certified there",
    )


def angle_on_cut(
    setting: Setting, *, factor: str = "4", swapped: bool = False, sign: int = 1
) -> Evidence:
    """That z <= X on both rectangles of the cut, hence phi <= phi_n I_0(z) <= phi*."""
    u, v = printed.cut(X, U_MAX, V_MAX, factor=factor, swapped=swapped)
    return combined(
        {
            "corners": identities(
                setting,
                {"(u_max, v_n*)": 4 * U_MAX * v - X**2, "(u_n*, v_max)": 4 * u * V_MAX - X**2},
                shown="",
            ),
            "inside": positivity(
                setting,
                {
                    "X^2 - z^2 along u": X**2 - 4 * U_MAX / (1 + P) * v / (1 + Q),
                    "X^2 - z^2 along v": X**2 - 4 * u / (1 + P) * V_MAX / (1 + Q),
                },
                shown="",
            ),
            "growth": growth(setting, sign=sign),
        },
        shown="z <= X <= z* on both rectangles and I_0 grows, so phi <= phi_n I_0(z) <= phi_n "
        "I_0(X) = phi*: rests on the upper bound of (boundCphi*), certified there",
    )


def lower_bound_at_corner(setting: Setting, *, factor: str = "4", share: str = "1") -> Evidence:
    """That the corner's z = 2 sqrt(u_n* v_n*) = zeta_n is at most X <= z*, where the cut fits."""
    u, v = printed.cut(X, U_MAX, V_MAX, factor=factor)
    zeta = printed.zeta(X, U_MAX, V_MAX, sp)
    return combined(
        {
            "corner": corner_inside(setting, factor=factor, share=share),
            "place": identities(setting, {"zeta_n^2 - z^2": zeta**2 - 4 * u * v}, shown=""),
            "X <= z*": cut_before_threshold(setting),
        },
        shown="the corner has z = zeta_n <= X <= z* where X <= 2 sqrt(u_max v_max), so phi there "
        "is at least phi_n I_0(C zeta_n): rests on both bounds of (boundCphi*), certified there",
    )


def first_inequality(
    setting: Setting, *, daughters: str = "3", factor: str = "2", power: int = 2
) -> Evidence:
    """Bound of the remark against a third of the lemma's, C zeta_n its argument."""
    c, angle = sp.symbols("C phi", positive=True)
    argument, under = printed.ratio_bound(
        c, X, sp.sqrt(U_MAX * V_MAX), daughters=daughters, factor=factor, power=power
    )
    return identities(
        setting,
        {
            "arguments of I_0": argument - c * printed.zeta(X, U_MAX, V_MAX, sp),
            "angles": printed.daughter_angle(angle) - angle / under,
        },
        shown="phi_{n+1} = phi(u_n*, v_n*)/3 >= phi_n/3 I_0(C zeta_n), and C zeta_n is the printed "
        "argument: rests on the lemma and the trisection",
    )
