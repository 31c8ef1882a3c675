"""What the printed greedy algorithm leaves: the cover of the disk, the quadgraph."""

import math
from collections import Counter
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

from checks.evidence import Evidence, Setting
from checks.printed.greedy_algorithm import PrintedRun
from checks.printed.greedy_sector import PrintedSector, inside
from checks.verify.printed_nodes import held_points
from checks.verify.printed_runs import CASES, cut_sectors, found, node, place_of, run_of
from checks.verify.quads_in_space import edges_of
from discrete.point_cover import contained

#: Random points of a disk.
POINTS = 5000

#: Distance within which nodes of two sectors are one node, in units of Delta.
ONE_NODE = 1e-6


def _random(setting: Setting) -> np.random.Generator:
    return np.random.default_rng(int.from_bytes(setting.seed.encode()[:8], "big"))


def covers(
    setting: Setting, *, variant: str = "letter", short: str = "0", level: str = "1"
) -> Evidence:
    """Whether the disk of radius R - short Delta is covered once, with |phi| <= level phi*."""
    failures, random = [], _random(setting)
    for case in CASES:
        run = run_of(case, variant)
        held, _ = held_points(run, POINTS, random, float(Fraction(short)))
        lost, twice = float((held == 0).mean()), float((held > 1).mean())
        widest = max(
            float(np.nanmax(np.abs(np.where(near, sector.angles, 0.0)), initial=0.0))
            for sector in run.sectors
            if (near := sector.kept & inside(sector.zeta, run.parameters.radius)).any()
        )
        told = f"R = {case[0]}, M = {case[1]}"
        if run.end != "step 25":
            failures.append(f"{told}: the run ends by {run.end}")
        if lost or twice:
            failures.append(f"{told}: {lost:.2%} of the disk in no quad, {twice:.2%} in several")
        if widest > run.parameters.cutoff * float(Fraction(level)):
            failures.append(f"{told}: an angle of {widest / math.pi:.4f} pi")
    return found(
        failures,
        shown=f"{POINTS} random points of each of {len(CASES)} disks, each in one quad",
        tried=len(CASES),
    )


def around_branch_points(
    setting: Setting, *, left_out: str = "", radius: str = "1", variant: str = "meant"
) -> Evidence:
    """Whether the four sectors at each branch point cover a disk around it, once.

    left_out: of parent, u, A, v; radius: of the disk, in units of Delta.
    """
    failures, random, tried, count = [], _random(setting), 0, 200
    for case in CASES:
        run = run_of(case, variant)
        modulus = math.tanh(run.parameters.step * float(Fraction(radius)) / 2)
        around = modulus * np.sqrt(random.random(count)) * np.exp(2j * np.pi * random.random(count))
        for parent, cut, (u, middle, v) in cut_sectors(run):
            tried += 1
            points = place_of(node(parent, *cut), around)
            four = {"parent": parent, "u": u, "A": middle, "v": v}
            held = sum(contained(points, _near(four[name], points)) for name in four
                       if name != left_out)  # fmt: skip
            if (np.asarray(held) != 1).any():
                failures.append(
                    f"sector {parent.path}: {int((np.asarray(held) != 1).sum())} of {count} points "
                    "not in one quad"
                )
    return found(
        failures, shown=f"{count} points around each of {tried} branch points", tried=tried
    )


def _near(sector: PrintedSector, points: npt.NDArray[np.complex128]) -> Any:
    """Corners of the kept quads that are not far from the points."""
    corners = sector.corners()
    reach = 6 * np.abs(points - points.mean()).max()
    return corners[np.abs(corners.mean(axis=1) - points.mean()) < reach]


def welded(run: PrintedRun, *, share: bool = True) -> npt.NDArray[np.int64]:
    """Quads (Q, 4) of all sectors by the numbers of their nodes; share: at one place, one node."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    corners = np.concatenate([sector.corners() for sector in run.sectors])
    near = (2 * np.arctanh(np.abs(corners)) <= run.parameters.radius).any(axis=1)
    places = corners[near].ravel()
    if not share:
        sizes = [len(sector.corners()) for sector in run.sectors]
        owner = np.repeat(np.repeat(np.arange(len(sizes)), sizes)[near], 4)
        keys = np.round(places, 9) + 10 * owner
        return np.unique(keys, return_inverse=True)[1].reshape(-1, 4)
    scaled = places / (1 - np.abs(places) ** 2)
    tree = cKDTree(np.column_stack([scaled.real, scaled.imag]))
    pairs = tree.query_pairs(ONE_NODE * run.parameters.step, output_type="ndarray")
    ones = np.ones(len(pairs))
    graph = coo_matrix((ones, (pairs[:, 0], pairs[:, 1])), shape=(len(places), len(places)))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64).reshape(-1, 4)


def quadgraph(
    setting: Setting, *, share: bool = True, degree: int = 6, variant: str = "meant"
) -> Evidence:
    """Whether the nodes of all sectors make one disk of quads, with the branch points inside.

    share: whether nodes on common axes are one; degree: of the branch points.
    """
    del setting
    failures, told = [], []
    for case in CASES:
        run = run_of(case, variant)
        quads = welded(run, share=share)
        edges, count = edges_of(quads)
        nodes = np.unique(quads)
        euler = len(nodes) - len(edges) + len(quads)
        rim = np.unique(edges[count == 1])
        degrees = Counter(np.bincount(edges.ravel())[np.setdiff1d(nodes, rim)].tolist())
        cuts = len(cut_sectors(run))
        wanted = Counter({degree: cuts}) + Counter({case[1]: 1} if case[1] != 4 else {})
        wanted[4] = degrees[4]
        if count.max() > 2 or euler != 1 or degrees != wanted:
            failures.append(
                f"R = {case[0]}, M = {case[1]}: V - E + F = {euler}, degrees {dict(degrees)}"
            )
        told.append(f"{len(quads)} quads with {cuts} cuts")
    return found(failures, shown=", ".join(told), tried=len(CASES))
