"""Steps 16 to 22 of the printed greedy algorithm: the three sectors at a cut."""

import math
from fractions import Fraction

import numpy as np

from checks.evidence import Evidence, Setting
from checks.printed import poincare_disk
from checks.printed.disk_net import ARRAYS
from checks.printed.greedy_sector import (
    inside,
)
from checks.verify.printed_runs import (
    CASES,
    cut_sectors,
    found,
    node,
    run_of,
    seen_from,
)


def middle_axes(setting: Setting, *, variant: str = "argument", part: str = "1/3") -> Evidence:
    """Whether the axes of Omega_{M+2} divide the angle left at the cut into three equal ones.

    part: of the angle, from w_1 to the v-axis and from the u-axis to w_2.
    """
    del setting
    failures, tried = [], 0
    for case in CASES:
        for sector, cut, daughters in cut_sectors(run_of(case, variant)):
            j, k = cut
            centre = node(sector, j, k)
            w1 = seen_from(centre, node(sector, j + 1, k))
            w2 = seen_from(centre, node(sector, j, k + 1))
            middle = daughters[1]
            v_axis, u_axis = (seen_from(centre, node(middle, *at)) for at in ((0, 1), (1, 0)))
            whole = float(np.angle(w2 / w1))
            shares = [float(np.angle(v_axis / w1)), float(np.angle(w2 / u_axis))]
            tried += 1
            if max(abs(share - whole * float(Fraction(part))) for share in shares) > 1e-9:
                told = " and ".join(f"{share / math.pi:.4f} pi" for share in shares)
                failures.append(
                    f"R = {case[0]}, sector {sector.path}: of {whole / math.pi:.4f} pi the outer "
                    f"sectors take {told}"
                )
    return found(failures, shown=f"{tried} cuts", tried=tried)


def side_axes(setting: Setting, *, shift: int = 0, variant: str = "meant") -> Evidence:
    """Whether each side sector has one axis on the line of its parent and one of the middle sector.

    shift: of the parent's node at which the axis begins. The nodes are compared in number and
    place, up to where both are kept.
    """
    del setting
    failures, tried = [], 0
    for case in CASES:
        for sector, cut, (u, middle, v) in cut_sectors(run_of(case, variant)):
            j, k = cut
            pairs = (
                ("u-axis of M+1", u.zeta[:, :, 0], sector.zeta[:, j + shift :, k]),
                ("v-axis of M+3", v.zeta[:, 0, :], sector.zeta[:, j, k + shift :]),
                ("v-axis of M+1", u.zeta[:, 0, :], middle.zeta[:, 0, :]),
                ("u-axis of M+3", v.zeta[:, :, 0], middle.zeta[:, :, 0]),
            )
            for name, own, other in pairs:
                tried += 1
                common = min(own.shape[1], other.shape[1])
                if common < 2 or not np.array_equal(own[:, :common], other[:, :common]):
                    failures.append(f"sector {sector.path}: {name} is not the line")
    return found(failures, shown=f"{tried} axes", tried=tried)


def rhombi(
    setting: Setting, *, sign: int = 1, weight: str = "1", variant: str = "meant"
) -> Evidence:
    """Whether the nodes that (poincare-ddg) closes in the daughters make rhombi of side Delta."""
    del setting
    failures, tried = [], 0
    for case in CASES:
        run = run_of(case, variant)
        for sector in run.sectors[case[1] :]:
            z = sector.zeta
            corners = tuple(z[:, :-1, :-1]), tuple(z[:, 1:, :-1]), tuple(z[:, :-1, 1:])
            fourth = poincare_disk.closed(*corners, ARRAYS, sign=sign, weight=weight)
            quads = sector.quads
            for neighbour in corners[1:]:
                first = (fourth[0] + 1j * fourth[1])[quads]
                second = (neighbour[0] + 1j * neighbour[1])[quads]
                distance = 2 * np.arctanh(np.abs(seen_from(second, first)))
                tried += len(distance)
                gap = np.abs(distance - run.parameters.step).max(initial=0.0)
                if gap > 1e-9:
                    failures.append(f"sector {sector.path}: a side differs by {gap:.2g}")
    return found(failures, shown=f"{tried} sides", tried=tried)


def daughter_angles(setting: Setting, *, variant: str = "sign", most: str = "1") -> Evidence:
    """Whether the angles of the daughters in the disk lie between 0 and `most` times phi*."""
    del setting
    failures, tried = [], 0
    for case in CASES:
        run = run_of(case, variant)
        for sector in run.sectors[case[1] :]:
            near = sector.kept & inside(sector.zeta, run.parameters.radius)
            values = sector.angles[near & np.isfinite(sector.angles)]
            if not len(values):
                continue
            tried += len(values)
            low, high = float(values.min()), float(values.max())
            if low <= 0 or high > run.parameters.cutoff * float(Fraction(most)):
                failures.append(
                    f"sector {sector.path}: phi from {low / math.pi:.4f} pi to "
                    f"{high / math.pi:.4f} pi"
                )
    return found(failures, shown=f"{tried} nodes of daughters", tried=tried)
