"""Random tiled disks with branch points, and evidence from relations that all surfaces satisfy."""

from collections.abc import Iterable, Iterator
from random import Random

from checks.evidence import Evidence, Setting
from theory.asymptotic_tiling import Tiling, star
from theory.tiling_angles import TilingAngles

WANTED = 30
TRIED = 4000
MOST_FACES = 90


def random_tiling(rng: Random, *, only_off_rays: bool, most_faces: int) -> Tiling | None:
    """Star of order 2 to 6, quadrants of its blocks replaced by fans, its rim trimmed at random.

    Branch points stay inside; only_off_rays: whether the curves that leave them do too. None where
    it has more than most_faces faces.
    """
    depth, longest = rng.randint(0, 2), rng.randint(2, 4)
    whole = star(rng.choice((2, 2, 3, 3, 4, 6)), rng, longest=longest, depth=depth)
    if len(whole.faces) > most_faces * 3 // 2:
        return None
    spare = whole.branch_rays() if only_off_rays else frozenset()
    times = rng.randint(0, len(whole.faces) // 3)
    tiling = whole.trimmed(rng, times, spare=spare | set(whole.branch_points))
    return tiling if len(tiling.faces) <= most_faces else None


def off_rays(tiling: Tiling) -> bool:
    """Whether no reflex corner of the rim lies on a curve that leaves a branch point."""
    rays = tiling.branch_rays()
    return not any(tiling.degrees[vertex] > 2 and vertex in rays for vertex in tiling.rim)


def random_tilings(
    setting: Setting,
    *,
    wanted: int = WANTED,
    only_off_rays: bool = True,
    smallest_charge: int = 0,
    most_faces: int = MOST_FACES,
    tries: int = TRIED,
) -> tuple[list[Tiling], int]:
    """Tilings that meet the hypotheses, and how many were tried.

    only_off_rays: whether to refuse reflex corners on branch rays; smallest_charge: least sum of
    m - 2; most_faces: bound on their size. At least a third have three branch points or more, and
    a third have reflex corners: ValueError if the tries do not do.
    """
    rng = setting.random()
    found: list[Tiling] = []
    for tried in range(1, tries + 1):
        tiling = random_tiling(rng, only_off_rays=only_off_rays, most_faces=most_faces)
        if tiling is None or charge(tiling) < smallest_charge:
            continue
        if (not only_off_rays or off_rays(tiling)) and _needed(tiling, found, wanted):
            found.append(tiling)
        if len(found) == wanted:
            return found, tried
    raise ValueError(f"{tries} tilings tried, {len(found)} of {wanted} found")


def _needed(tiling: Tiling, found: list[Tiling], wanted: int) -> bool:
    """Whether the tiling leaves room for the shares that are promised."""
    many = sum(len(t.branch_points) >= 3 for t in found)
    reflex = sum(has_reflex(t) for t in found)
    left = wanted - len(found)
    short = wanted // 3 - many >= left and len(tiling.branch_points) < 3
    flat = wanted // 3 - reflex >= left and not has_reflex(tiling)
    return not (short or flat)


def has_reflex(tiling: Tiling) -> bool:
    """Whether the boundary has a reflex corner."""
    return any(tiling.degrees[vertex] > 2 for vertex in tiling.rim)


def charge(tiling: Tiling) -> int:
    """Sum of m - 2 over the branch points inside."""
    return sum(order - 2 for order in tiling.branch_points.values())


def described(tiling: Tiling) -> str:
    """Tiling in words, for a witness."""
    orders = ", ".join(map(str, sorted(tiling.branch_points.values()))) or "none"
    return f"a tiling of {len(tiling.faces)} faces, branch points of order {orders}"


Claimed = tuple[Tiling, bool]


def implied(rows: Iterable[Claimed], *, tried: int, met: int, what: str, shown: str) -> Evidence:
    """Evidence that a relation follows on every tiling; the first where it does not refutes it."""
    for tiling, follows in rows:
        if not follows:
            return Evidence(
                outcome="fail",
                grade="exact",
                tried=tried,
                met=met,
                shown=shown,
                witness=f"{what} does not follow on {described(tiling)}",
            )
    return Evidence(outcome="pass", grade="exact", residual="0", tried=tried, met=met, shown=shown)


def over(tilings: Iterable[Tiling], *, matched: bool, continuous: bool) -> Iterator[TilingAngles]:
    """Relations of the surfaces over each tiling."""
    for tiling in tilings:
        yield TilingAngles(tiling=tiling, matched=matched, continuous=continuous)
