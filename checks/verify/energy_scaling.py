"""Checks of the symbol ~, of the scaling of the bobbins, and of the rivals of the bobbin."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import curvature_energy as printed
from theory import bobbin, helicoidal_net
from theory.amsler import U, V
from theory.helicoidal_net import PITCH, SQUARE

RADIUS = sp.Symbol("R", positive=True)
_LOG_COSH = sp.log(sp.cosh(RADIUS))


def scaling_symbol(setting: Setting, *, least_radius: str = "0", side: str = "both") -> Evidence:
    """Pairs of functions sorted by the symbol: those meant to be comparable, and near-misses.

    least_radius: where the range of the radii begins; side: which bounds are asked for.
    """
    del setting
    root = sp.sqrt(RADIUS)
    pairs = (
        ("log cosh R ~ R, the energy of the bobbins", _LOG_COSH, RADIUS, True),
        ("R + tanh R ~ R", RADIUS + sp.tanh(RADIUS), RADIUS, True),
        ("3 sqrt(R) ~ sqrt(R)", 3 * root, root, True),
        ("sqrt(R) ~ R", root, RADIUS, False),
        ("R^(11/10) ~ R", RADIUS ** sp.Rational(11, 10), RADIUS, False),
        ("R log(1 + R) ~ R", RADIUS * sp.log(1 + RADIUS), RADIUS, False),
    )
    for name, a, b, meant in pairs:
        found = printed.is_comparable(a, b, RADIUS, least_radius=least_radius, side=side)
        if found != meant:
            verb = "refused" if meant else "accepted"
            why = (
                ": at R = 1/C, log cosh R < R^2/2 = R/(2C) < R/C, whatever C > 1"
                if meant and a == _LOG_COSH
                else ""
            )
            return statement(False, shown="", witness=f"{name} is {verb}{why}")
    return statement(
        True,
        shown=f"for R >= {least_radius} the symbol accepts log cosh R ~ R and two more pairs, and "
        "refuses other powers and a factor log R",
        witness="",
    )


def bobbin_scaling(setting: Setting, *, power: str = "1", throat: str = "cosh") -> Evidence:
    """Bounds (1 - log 2) R <= log E_inf <= R of the best bobbin on R >= 1, in place of R^power.

    throat: kappa as a function of R, for which E_inf is the larger of the two curvatures.
    """
    kappa = {"cosh": sp.cosh(RADIUS), "exp": sp.exp(RADIUS)}[throat]
    longitudinal, azimuthal = bobbin.largest_on_disk(kappa, sp.Integer(0), RADIUS)
    shown = "(1 - log 2) R <= log cosh R <= R for R >= 1"
    target = RADIUS ** sp.Rational(power)
    return combined(
        {
            "energy": identities(
                setting,
                {
                    "throat": azimuthal - sp.cosh(RADIUS) ** 2,
                    "rim": longitudinal - sp.cosh(RADIUS) ** 2,
                },
                shown=shown,
            ),
            "comparable": statement(
                printed.is_comparable(_LOG_COSH, target, RADIUS, least_radius="1"),
                shown=shown,
                witness=f"log cosh R over R^{power} tends to "
                f"{sp.limit(_LOG_COSH / target, RADIUS, sp.oo)}",
            ),
            "bounds": positivity(
                setting,
                {
                    "e^R > cosh R": sp.exp(RADIUS) - sp.cosh(RADIUS),
                    "cosh R > e^R/2": sp.cosh(RADIUS) - sp.exp(RADIUS) / 2,
                },
                shown=shown,
            ),
            "from R - log 2": identities(
                setting,
                {
                    "R >= 1": RADIUS
                    - sp.log(2)
                    - RADIUS * (1 - sp.log(2))
                    - sp.log(2) * (RADIUS - 1)
                },
                shown=shown,
            ),
        },
        shown=shown + "; the upper bound holds for all R > 0, and for every C^2 infimum",
    )


def helicoidal_rivals(setting: Setting, *, factor: str = "1", twist: int = 1) -> Evidence:
    """Least E_inf on a disk of radius R over all surfaces with a one-parameter group of motions.

    p, P: least and greatest square of the length of the generator on the disk, less the pitch.
    factor: E_inf >= factor cosh R is claimed; twist: sign of the pitch.
    """
    wave = sp.Function("f", positive=True)(helicoidal_net.phase())
    field = helicoidal_net.generator()
    shift = field[0] * sp.diff(wave, U) + field[1] * sp.diff(wave, V)
    length = helicoidal_net.squared_length()
    tangent = helicoidal_net.squared_half_tangent(SQUARE, PITCH)
    by_angle = tangent.subs({SQUARE: length, PITCH: helicoidal_net.pitch()})
    least, gap, x = sp.symbols("p g x", positive=True)
    claimed = sp.Rational(factor) ** 2 * sp.cosh(RADIUS) ** 2
    # q = p + d on the near side; with P + p = 4 + w or 4 - w one of the squares exceeds P/p.
    w, z = sp.symbols("w z", positive=True)
    top = least + gap
    pitch = sp.Symbol("d", positive=True)
    shown = "tan^2(phi/2) = (q - d)/(4 + d - q) for the squared length q of K"
    spread = (top + twist * pitch) / (least + twist * pitch)
    return combined(
        {
            "motion": identities(setting, {"phi is kept": shift}, shown=shown),
            "angle": identities(
                setting,
                {"half tangent": by_angle - sp.tan(helicoidal_net.ANGLE / 2) ** 2},
                shown=shown,
            ),
            "lengths": identities(
                setting,
                {
                    kind: sp.diff(root, x, 2) - root
                    for kind, root in (
                        (k, sp.sqrt(helicoidal_net.squared_profile(k, x)))
                        for k in ("axis", "horocycle", "point")
                    )
                },
                shown="x_ss = x",
            ),
            "far side": identities(
                setting,
                {"P/(4 - P) - P/p where P = 4 - p + w": (4 - least + w) / (least - w)
                 - (4 - least + w) / least - w * (4 - least + w) / (least * (least - w))},
                shown=shown,
            ),
            "near side": positivity(
                setting,
                {"(4 - p)/p - P/p where P = 4 - p - w": (4 - least) / least
                 - (4 - least - w) / least},
                shown=shown,
            ),
            "pitch": positivity(setting, {"P/p over Q/q": top / least - spread}, shown=shown),
            "disks": positivity(
                setting,
                {
                    "axis, off the throat": sp.cosh(RADIUS + z) ** 2 - claimed,
                    "axis missed": sp.cosh(2 * RADIUS + z) ** 2 - claimed * sp.cosh(z) ** 2,
                    "horocycle": sp.exp(4 * RADIUS) - claimed,
                    "point": sp.sinh(2 * RADIUS + z) ** 2 - claimed * sp.sinh(z) ** 2,
                },
                shown=shown,
            ),
            "attained": identities(
                setting,
                {"bobbin": bobbin.largest_on_disk(sp.cosh(RADIUS), 0, RADIUS)[1] - claimed},
                shown=shown,
            ),
        },
        shown="E_inf^2 is at least the quotient of the extreme squared lengths of the generator on "
        "the disk, hence E_inf >= cosh R on every pseudospherical surface with a one-parameter "
        "group of motions, attained by the bobbin (pitch 0, axis, centred)",
    )  # fmt: skip


def small_disks(setting: Setting, *, area: str = "2") -> Evidence:
    """Least E_inf to the second order in R from the square inscribed in a small disk.

    phi is near pi/2 there, so that the square has the area 2 R^2 in (u, v); the alternating sum of
    phi over its corners is the integral of sin phi, and at most 2 pi - 4 delta. With delta = pi/2 -
    x this is area R^2 cos x <= 4 x to leading order, and E_inf = tan(pi/4 + x/2).
    """
    x = sp.Symbol("x", positive=True)
    largest = sp.cot((sp.pi / 2 - x) / 2)
    offset = sp.Rational(area) * RADIUS**2 / 4
    bound = sp.series(largest, x, 0, 3).removeO().subs(x, offset)
    second = [sp.series(value, RADIUS, 0, 3).removeO().coeff(RADIUS, 2)
              for value in (bound, sp.cosh(RADIUS))]  # fmt: skip
    return combined(
        {
            "alternating sum": identities(
                setting,
                {"corners": 2 * (sp.pi - (sp.pi / 2 - x)) - 2 * (sp.pi / 2 - x) - 4 * x},
                shown="2 (pi - delta) - 2 delta",
            ),
            "second order": identities(
                setting, {"R^2": sp.Add(second[0], -second[1])}, shown="1/2"
            ),
        },
        shown="every C^2 immersion has E_inf >= 1 + R^2/2 + o(R^2), which is the energy of the "
        "best bobbin: it is optimal to leading order as R tends to 0",
    )


def rectangle_bound(setting: Setting, *, half: str = "1/2", factor: str = "1") -> Evidence:
    """Lower bound E_inf + 1/E_inf >= factor R^2/pi of every C^2 immersion, by a central square.

    The square |u|, |v| <= half R lies in the disk, each of its points being within |u| + |v| of the
    centre along asymptotic lines. Its alternating sum, at most 2 pi - 4 delta, is the integral of
    sin phi >= sin delta: R^2 sin delta <= 2 pi, and sin delta = 2/(E_inf + 1/E_inf).
    """
    reach = 2 * sp.Rational(half)
    delta = sp.Symbol("delta", positive=True)
    energy = sp.cot(delta / 2)
    most = 2 * (sp.pi - delta) - 2 * delta
    left = (2 * sp.Rational(half) * RADIUS) ** 2 * sp.sin(delta)
    shown = "R^2 sin delta <= 2 pi - 4 delta, sin delta = 2/(E_inf + 1/E_inf)"
    return combined(
        {
            "the square is in the disk": statement(
                bool(reach <= 1),
                shown=shown,
                witness=f"a corner is {reach} R from the centre along two asymptotic lines",
            ),
            "in E_inf": identities(
                setting, {"sum": left * (energy + 1 / energy) - 2 * sp.Rational(factor) * RADIUS**2,
                 "corners": most - (2 * sp.pi - 4 * delta)},
                shown=shown,
            ),
        },
        shown="(e2) lies between the proved bounds: log(R^2/pi - 1) <= log inf E_inf <= log cosh R",
    )  # fmt: skip


def separation(setting: Setting, *, power: str = "1/2") -> Evidence:
    """Limit of the log of the quotient of the two energies under (e2) and (ebs), any constants."""
    del setting
    first, second = sp.symbols("C_1 C_2", positive=True)
    exponent: Any = printed.separation_exponent(RADIUS, first, second, power=power)
    half = sp.Symbol("x", positive=True)
    limit = sp.limit(sp.expand(exponent.subs(RADIUS, half**2)), half, sp.oo)
    return statement(
        limit == sp.oo,
        shown="R/C - C' sqrt(R) tends to infinity, and is positive from R > (C C')^2 on",
        witness=f"for the power {power} the log of the quotient tends to {limit}",
    )
