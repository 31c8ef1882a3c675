"""Section 4.1, before item 1: the order m_0 that one branch point at the centre of a disk needs.

The paper leaves open what is needed: m_0(R) is the least m whose Amsler sectors of angle pi/m have
their singular edge farther than R (level 1), or the least for which the angle is at most phi* =
level pi in the disk. For real m the distance up to which the angle is below level pi is the length
of the mirror line, so that m is a function of R by way of phi_0 = pi/m. While phi <= pi/2 the least
m >= 2 I_0(R + 7/20) does, for R >= 1 (theory.periodic_amsler_bounds).
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from typing import Any

from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined
from checks.printed import greedy_dual as printed
from checks.verify import periodic_amsler_growth
from checks.verify.ball_bounds import Row, bounded
from checks.verify.convergence import order as observed_order
from checks.verify.initial_angles import fraction
from theory import painleve_reference, periodic_amsler
from theory.errors import SingularEdgeError

#: phi_0 = 10^-j; the edge is then 12, 22, 40, 77 and 151 away, and phi = pi/2 about 1 nearer.
_EXPONENTS = (4, 8, 16, 32, 64)
_RADII = (Fraction(1, 2), Fraction(1), Fraction(2), Fraction(3), Fraction(5), Fraction(10))


@cache
def _edge(exponent: int, level: Fraction) -> Any:
    """Distance of phi = level pi, the edge at level 1, for phi_0 = 10^-exponent; mpf, 20 digits."""
    with mp.workdps(40 + exponent):
        corner = mp.mpf(10) ** -exponent
        place = painleve_reference.crossing(corner, _angle(level), digits=25)
        # The integrand cos(phi/2) is 0 at the edge: the last 1e-30 of the way adds nothing.
        return +painleve_reference.diagonal(corner, place * (1 - mp.mpf(10) ** -30), digits=20)


def _angle(level: Fraction) -> Callable[[], Any]:
    return lambda: mp.pi * level.numerator / level.denominator


def orders(level: str = "1") -> list[tuple[Any, Any]]:
    """Pairs of R and the real m whose angle reaches level pi at that distance; mpf."""
    return [(_edge(j, Fraction(level)), mp.pi * mp.mpf(10) ** j) for j in _EXPONENTS]


@cache
def least_order(radius: Fraction, level: Fraction = Fraction(1)) -> int:
    """Least m >= 2 whose angle reaches level pi farther out than R, by mpmath."""

    def reaches(m: int) -> bool:
        if Fraction(1, m) >= level:
            return False
        with mp.workdps(30):
            corner = mp.pi / m
            place = painleve_reference.crossing(corner, _angle(level), digits=20)
            far = painleve_reference.diagonal(corner, place * (1 - mp.mpf(10) ** -20), digits=12)
            return bool(far > mp.mpf(radius.numerator) / radius.denominator)

    low, high = 1, 2
    while not reaches(high):
        low, high = high, 2 * high
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if reaches(middle) else (middle, high)
    return high


def exists(setting: Setting, *, offset: int = 0) -> Evidence:
    """Whether m_0 + offset sectors on either side keep phi < pi on the disk, and so for all R.

    m_0 by mpmath, the angle at the rim by balls; for all R >= 1 by the bound of E_inf.
    """

    def rows() -> Iterator[Row]:
        for radius in _RADII:
            half = least_order(radius) + offset
            try:
                rim = periodic_amsler.rim_angle(radius, 2 * max(half, 2), digits=15).ball()
            except SingularEdgeError:
                rim = arb.pi() + 1  # past the edge
            yield f"phi at the rim, R = {radius}, m = {half}", rim, arb.pi()

    return combined(
        {
            "radii": bounded(rows(), shown=""),
            "all R from 1 on": periodic_amsler_growth.constant_bound(setting),
        },
        shown="m_0 = "
        + ", ".join(str(least_order(r)) for r in _RADII)
        + " at R = 1/2, 1, 2, 3, 5, 10; for every R >= 1 a number of sectors with finite E_inf",
    )


def scale(setting: Setting, *, power: str = "0", level: str = "1") -> Evidence:
    """Order in R of (m_0/(e^R R^power))^2, which is 0 where m_0 ~ C e^R R^power; R up to 151.

    The square, so that the tolerance 0.1 of an order means 0.05 in the power.
    """
    del setting
    with mp.workdps(30):
        pairs = orders(level)
        values = [(m / printed.saddle_order_scale(r, mp.exp, power=power)) ** 2 for r, m in pairs]
        roots = ", ".join(mp.nstr(mp.sqrt(v), 5) for v in values)
        radii = ", ".join(f"{float(r):.0f}" for r, _ in pairs)
        return observed_order(
            [r for r, _ in pairs], values, 0, digits=15,
            shown=f"m_0 e^-R R^-({power}) at R = {radii} is {roots}",
        )  # fmt: skip


def constant(setting: Setting, *, factor: str = "1") -> Evidence:
    """Order in R of m_0/(factor (pi/2) I_0(R)) - 1, where (pi/2) I_0 ~ sqrt(pi/8) e^R R^(-1/2)."""
    del setting
    with mp.workdps(30):
        c = mp.mpf(Fraction(factor).numerator) / Fraction(factor).denominator
        pairs = orders()
        errors = [m / (c * mp.pi / 2 * mp.besseli(0, r)) - 1 for r, m in pairs]
        return observed_order(
            [r for r, _ in pairs], errors, -1, digits=15,
            shown="m_0 e^-R sqrt(R) tends to sqrt(pi/8) = 0.6267",
        )  # fmt: skip


def bound_above(setting: Setting, *, most: str = "43/20") -> Evidence:
    """Bound m_0 <= most R^(-1/2) e^R for all R >= 1, by m_0 < 2 I_0(R + 7/20) + 1.

    With I_0(x) <= sqrt(pi/(8 x)) e^x and sqrt(R) e^-R <= 1/e; refuted where m_0 itself is larger.
    """

    def rows() -> Iterator[Row]:
        for radius, m in orders():
            ball, found = (arb(mp.nstr(x, 20)) for x in (radius, m))
            yield f"R = {mp.nstr(radius, 6)}", found * (-ball).exp() * ball.sqrt(), fraction(most)
        proof = 2 * (arb.pi() / 8).sqrt() * (arb(7) / 20).exp() + arb(-1).exp()
        yield "constant of the proof", proof, fraction(most)

    return combined(
        {"constant": bounded(rows(), shown=""),
         "proof of the bound": periodic_amsler_growth.constant_bound(setting)},
        shown=f"m_0 <= {most} R^(-1/2) e^R for all R >= 1: no multiple of e^R is below m_0",
    )  # fmt: skip


def depth_growth(setting: Setting, *, rate: str = "1") -> Evidence:
    """Slope of log m_0 in R, that of g log 3, over the last stretch from R = 77 to 151."""
    del setting

    def rows() -> Iterator[Row]:
        (r1, m1), (r2, m2) = orders()[-2:]
        slope = arb(mp.nstr(mp.log(m2 / m1) / (r2 - r1), 15))
        yield "slope against rate", abs(slope - fraction(rate)), fraction("1/200")

    return bounded(rows(), shown="log m_0 grows by R but for (log R)/2: g ~ R/log 3", sampled=True)


def energy(setting: Setting, *, most: str = "21/5", rate: str = "1") -> Evidence:
    """Bound (2/pi) 3^g m < most e^(rate R) for all R >= 1, by 3^g m < 3 m_0.

    m_0 keeps phi <= pi/2 in the disk, and so is not below that which keeps phi < pi. Refuted where
    (2/pi) m_0, which is not above the left side, is larger.
    """

    def rows() -> Iterator[Row]:
        c = arb(637) / 1000
        for radius, m in orders("1/2"):
            ball, found = (arb(mp.nstr(x, 20)) for x in (radius, m))
            yield (
                f"R = {mp.nstr(radius, 6)}",
                c * found * (-fraction(rate) * ball).exp(),
                fraction(most),
            )
        root = 2 * (arb.pi() / 8).sqrt() * (arb(7) / 20).exp() + arb(-1).exp()
        yield "constant of the proof", 3 * c * root, fraction(most)

    return combined(
        {"constant": bounded(rows(), shown=""),
         "proof of the bound": periodic_amsler_growth.constant_bound(setting)},
        shown=f"(2/pi) 3^g m < {most} e^R for all R >= 1, and even times R^(-1/2)",
    )  # fmt: skip
