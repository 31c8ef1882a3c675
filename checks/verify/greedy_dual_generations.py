"""Section 4.1, items 1 to 3 and 6: how many branch points and sectors the dual has at each stage.

A vertex of degree 2 k has the charge k - 2 (discrete.charges). Where branch points part inside
the disk, the sum of their charges stays: it is settled by the angles and lengths along the rim.
"""

from collections.abc import Iterator
from fractions import Fraction

from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import greedy_dual as printed
from checks.verify.ball_bounds import Row, bounded
from checks.verify.initial_angles import fraction

_INDICES = range(2, 8)
_GENERATIONS = range(1, 6)
#: Degree of a branch point that three sectors were put in at.
_FINAL = 6


def _exactly(wrong: str, tried: int, shown: str) -> Evidence:
    found = statement(not wrong, shown=shown, witness=wrong)
    return Evidence(
        outcome=found.outcome, grade="exact", tried=tried, met=tried, shown=shown, witness=wrong,
        residual=found.residual,
    )  # fmt: skip


def generations(
    setting: Setting, *, shift: int = 0, closed: bool = False, base: int = 3
) -> Evidence:
    """Whether exactly one g meets the condition, and whether 3^g m sectors suffice and few more do.

    shift: of g in the condition; closed: both signs <=; base: of the order that is started from.
    """
    del setting
    tried, wrong = 0, ""
    for m in _INDICES:
        for needed in range(m // 3 + 1, 300):
            tried += 1
            found = [
                g
                for g in range(-3, 9)
                if printed.is_generations(g, m, needed, shift=shift, closed=closed)
            ]
            if len(found) != 1:
                wrong = f"m = {m}, m_0 = {needed}: {len(found)} numbers g, {found}"
                break
            start = printed.single_order(found[0], m, base=base) if found[0] >= 0 else 0
            if not needed <= start < 3 * needed:
                wrong = f"m = {m}, m_0 = {needed}: g = {found[0]}, m' = {start} not in [m_0, 3 m_0)"
                break
    return _exactly(
        wrong, tried, "for m_0 > m/3 one g >= 0 meets the condition, and m_0 <= m' < 3 m_0"
    )


def first_step(
    setting: Setting, *, daughters: int = 2, degree_shift: int = 0, added: int = 0
) -> Evidence:
    """Whether the charges of the origin and the daughters add up to that of the order 3^g m."""
    del setting
    tried, wrong = 0, ""
    for m in _INDICES:
        for g in _GENERATIONS:
            tried += 1
            number, degree = printed.first_step(
                g, m, daughters=daughters, degree_shift=degree_shift, added=added
            )
            charge = (m - 2) + number * (Fraction(degree, 2) - 2)
            if not wrong and charge != printed.single_order(g, m) - 2:
                parity = ", an odd number," if degree % 2 else ""
                wrong = (
                    f"m = {m}, g = {g}: {number} vertices of degree {degree}{parity} have with the "
                    f"origin the charge {charge}, not {printed.single_order(g, m) - 2}"
                )
    return _exactly(wrong, tried, "the charge of the one branch point is that of the pieces")


def stage(
    setting: Setting, *, degree_shift: int = 0, added: int = 0, number_shift: int = 0
) -> Evidence:
    """Whether at every stage the charges add up, the earlier generations having degree 6."""
    del setting
    tried, wrong = 0, ""
    for m in _INDICES:
        for g in _GENERATIONS:
            settled = Fraction(m - 2)
            for k in range(1, g + 1):
                tried += 1
                number, degree = printed.stage(
                    k, g, m, degree_shift=degree_shift, added=added, number_shift=number_shift
                )
                charge = settled + number * (Fraction(degree, 2) - 2)
                if not wrong and charge != printed.single_order(g, m) - 2:
                    wrong = (
                        f"m = {m}, g = {g}, k = {k}: {number} vertices of degree {degree} have "
                        f"with the others the charge {charge}, not {printed.single_order(g, m) - 2}"
                    )
                settled += number * (Fraction(_FINAL, 2) - 2)
    return _exactly(wrong, tried, "at every stage the charges add up to that of the start")


def carried(
    setting: Setting, *, degree_shift: int = 0, number_shift: int = 0, first_shift: int = 0
) -> Evidence:
    """Whether, read as sectors carried outward, the degrees of items 2 and 3 agree and use all.

    Each daughter takes the narrow sectors of one place; together they are the 2 3^g m of the start.
    """
    del setting
    tried, wrong = 0, ""
    for m in _INDICES:
        for g in _GENERATIONS:
            for k in range(1, g + 1):
                tried += 1
                number, degree = printed.stage(
                    k, g, m, degree_shift=degree_shift, number_shift=number_shift
                )
                first = printed.first_step(g, m, degree_shift=first_shift)
                whole = 2 * printed.single_order(g, m)
                if k == 1 and (number, degree) != first:
                    wrong = wrong or (
                        f"m = {m}, g = {g}: stage 1 has {number} daughters that carry {degree} "
                        f"sectors, the first step {first[0]} that carry {first[1]}"
                    )
                if number * degree != whole:
                    wrong = wrong or (
                        f"m = {m}, g = {g}, k = {k}: {number * degree} sectors, not {whole}"
                    )
    return _exactly(wrong, tried, "every stage carries all sectors, and stage 1 is the first step")


def six(setting: Setting, *, times: str = "6", strict: bool = True) -> Evidence:
    """Whether 2 3^g m < 6 m_0 for all m and m_0 that g belongs to; strict: the sign <."""
    del setting
    tried, wrong = 0, ""
    most = Fraction(0)
    for m in _INDICES:
        for needed in range(m // 3 + 1, 900):
            tried += 1
            (g,) = [g for g in range(9) if printed.is_generations(g, m, needed)]
            ratio = Fraction(printed.most_sectors(g, m), needed)
            most = max(most, ratio)
            bound = Fraction(times)
            if not wrong and not (ratio < bound if strict else ratio > bound):
                wrong = f"m = {m}, m_0 = {needed}, g = {g}: 2 3^g m = {float(ratio):.4f} m_0"
    return _exactly(
        wrong, tried, "2 3^g m = 6 (3^(g-1) m) < 6 m_0; the quotient comes near to 6: up to "
        f"{float(most):.4f}",
    )  # fmt: skip


def energy(setting: Setting, *, constant: str = "637/1000", least_index: int = 6) -> Evidence:
    """Bound max(cot(phi/2), tan(phi*/2)) < C 3^g m with phi = 3^-g pi/m, for phi* <= pi/2.

    constant: C, a little more than 2/pi by default; least_index: of m.
    """
    del setting

    def rows() -> Iterator[Row]:
        # x cot(x) < 1 settles the rest: cot(phi/2) < 2/phi = (2/pi) 3^g m: any C > 2/pi will do.
        yield "2/pi", 2 / arb.pi(), fraction(constant)
        for m in range(least_index, least_index + 4):
            for g in range(5):
                half = printed.least_angle(g, m, arb.pi()) / 2
                curvature = half.cot().max((arb.pi() / 4).tan())
                yield f"m = {m}, g = {g}", curvature, fraction(constant) * 3**g * m

    return bounded(rows(), shown="E_inf < 0.637 3^g m, given the bound on the angles", sampled=True)
