"""Cover of the disk by the kept quads of discrete.greedy: by area, and by random points."""

from fractions import Fraction

from checks.evidence import Evidence, Setting
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import tree_of
from discrete.point_cover import point_cover

#: Numbers of initial sectors and cutoffs in half turns.
SETS = (("4", "3/4"), ("8", "4/5"), ("12", "4/5"))
RADII = ("1", "2", "3", "4", "5", "6")

#: Share of the disk that rounding may leave out or count twice.
ROUNDING = 1e-9


def disk_cover(
    setting: Setting,
    *,
    step: str = "1/100",
    points: int = 100_000,
    most: int = 10**6,
    share: str = "1",
) -> Evidence:
    """Whether the kept quads have the area of the disk, and every random point is in one of them.

    most: cuts of a run; share: of the area of the disk.
    """
    failures: list[str] = []
    tried = 0
    for sectors, cutoff in SETS:
        for radius in RADII:
            tree = tree_of(radius, step, sectors, cutoff, most)
            told = f"R = {radius}, 2 m = {sectors}, phi* = {cutoff} pi"
            off = tree.area / (tree.parameters.area * float(Fraction(share))) - 1
            if abs(off) > ROUNDING:
                failures.append(f"{told}: the area is off by {off:.2g}")
            cover = point_cover(tree, points, seed=setting.random().randrange(2**32))
            tried += cover.points
            if cover.uncovered or cover.twice:
                failures.append(
                    f"{told}: of {points} points {cover.uncovered} in no quad, {cover.twice} in two"
                )
    return found(
        failures,
        shown=f"{len(SETS) * len(RADII)} disks of radius 1 to 6, edges {step}: areas to "
        f"{ROUNDING:g}, {tried} random points in one quad each",
        tried=tried,
    )
