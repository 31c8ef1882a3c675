"""The greedy algorithm (alg:greedy-cuts) in the limit of edge length 0, over radii.

Whole trees on small disks; on larger ones the least angle only, by generations. No search for a
counterexample: margin is the least distance of a sector without a cut to the cutoff, in radians.
"""

from collections.abc import Callable
from fractions import Fraction
from math import pi
from typing import Any

from theory.greedy_least_angle import least_angles
from theory.greedy_limit import limit_tree

SOURCES = (
    "checks/searches/greedy_limits.py",
    "theory/goursat_rows.py",
    "theory/greedy_least_angle.py",
    "theory/greedy_limit.py",
    "theory/sector_side.py",
)

#: Initial sectors, and cutoff in half turns.
SETS = (("4", "3/4"), ("8", "4/5"))

#: Largest radius of a whole tree, and of a least angle.
LARGEST_TREE, LARGEST = 7, 16

WIDTH = 32


def nodes(radius: Fraction) -> int:
    """Nodes of the Chebyshev series: they grow with the length of a side."""
    return 32 + int(2 * radius)


def angles(radius: Fraction, sectors: str, cutoff: str) -> tuple[float, float, float]:
    """Radius, phi0 and cutoff as floats."""
    return float(radius), 2 * pi / int(sectors), float(Fraction(cutoff)) * pi


def whole_tree(radius: Fraction, sectors: str, cutoff: str) -> dict[str, Any]:
    """What is kept of a tree: for each cut the path, place and angle."""
    tree = limit_tree(*angles(radius, sectors, cutoff), nodes=nodes(radius))
    return {
        "radius": str(radius),
        "initial": sectors,
        "cutoff": cutoff,
        "min_angle": tree.min_angle,
        "slack": tree.slack,
        "cuts": [[cut.path, cut.rho, cut.theta, cut.angle] for cut in tree.cuts],
    }


def generations(radius: Fraction, sectors: str, cutoff: str) -> dict[str, Any]:
    """Least angle of each generation, and the path of its sector."""
    found = least_angles(*angles(radius, sectors, cutoff), width=WIDTH, nodes=nodes(radius))
    return {
        "radius": str(radius),
        "initial": sectors,
        "cutoff": cutoff,
        "least": [[one.angle, one.path, one.cuts] for one in found],
    }


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """All trees and least angles; the seed is not used."""
    del seed
    trees, least = [], []
    for sectors, cutoff in SETS:
        for half in range(2, 2 * LARGEST_TREE + 1):
            trees.append(whole_tree(Fraction(half, 2), sectors, cutoff))
            progress(f"tree {sectors} {cutoff} R = {half / 2}: {len(trees[-1]['cuts'])} cuts")
        for whole in range(2, LARGEST + 1):
            least.append(generations(Fraction(whole), sectors, cutoff))
            progress(f"least angle {sectors} {cutoff} R = {whole}: {least[-1]['least'][-1:]}")
    return {
        "evaluations": len(trees) + len(least),
        "margin": min(tree["slack"] for tree in trees),
        "trees": trees,
        "least": least,
    }
