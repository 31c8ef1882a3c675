"""Runs of the greedy algorithm as the checks of section 5.1 read them: cuts, families, places."""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from checks.searches.greedy_runs import run_parameters
from discrete.greedy import grown
from discrete.greedy_tree import LETTERS, GreedyTree

Array = NDArray[np.float64]

#: Number of initial sectors and cutoff, in half turns, of (fig:branch-tree) and panel (b).
TREE = ("4", "3/4")

#: Radius, initial sectors, cutoff of the panels of (fig:frontier).
PANELS = {"a": ("8", "12", "4/5"), "b": ("8", *TREE), "c": ("10", "8", "4/5")}

#: More runs within the ranges of observation 1: phi0 from pi/6 on, phi* up to 4 pi/5, R >= 6.
OTHERS = (
    ("6", "12", "4/5"),
    ("6", *TREE),
    ("7", "8", "3/4"),
    ("8", "12", "1/2"),
    ("9", "6", "2/3"),
)

MIDDLE = LETTERS.index("A")


@dataclass(frozen=True, kw_only=True, eq=False)
class Cuts:
    """Cuts of a run, images counted by `weight`.

    opening: phi_n; daughter: phi_(n+1); distance: s_n, from the corner of the sector to the rim;
    amsler: whether the sector lies between two geodesics; path: letters of the sector cut.
    """

    level: float
    opening: Array
    daughter: Array
    distance: Array
    weight: NDArray[np.int64]
    amsler: NDArray[np.bool_]
    path: tuple[str, ...]

    @property
    def ratio(self) -> Array:
        """phi_(n+1)/phi_n."""
        return self.daughter / self.opening


@cache
def tree_of(radius: str, step: str, sectors: str, cutoff: str, most: int = 10**6) -> GreedyTree:
    """Tree of a run, the cutoff in half turns; most: cuts."""
    return grown(run_parameters(radius, step, sectors, cutoff), max_cuts=most)


@cache
def cuts_of(radius: str, step: str, sectors: str, cutoff: str) -> Cuts:
    """Cuts of a run."""
    tree = tree_of(radius, step, sectors, cutoff)
    where = np.flatnonzero(tree.sectors["cut"])
    rows = tree.sectors[where]
    return Cuts(
        level=float(Fraction(cutoff)) * pi,
        opening=rows["opening"],
        daughter=rows["cut_angle"] / 3,
        distance=float(Fraction(radius)) - rows["rho"],
        weight=rows["copies"],
        amsler=(rows["letter"] == MIDDLE) | (rows["parent"] < 0),
        path=tuple(tree.paths[k] for k in where),
    )


def inverse_i0(levels: Array) -> Array:
    """I_0^(-1) at levels of 1 or more, by bisection of log I_0 (scipy)."""
    from scipy.special import ive

    wanted = np.log(levels)
    low, high = np.zeros_like(wanted), 2 * wanted + 4
    for _ in range(80):
        middle = (low + high) / 2
        below = np.log(ive(0, middle)) + middle < wanted
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return np.asarray((low + high) / 2)


def positions(tree: GreedyTree) -> tuple[list[Any], Array]:
    """Branch points of the whole disk, and their points (n, 3) on the hyperboloid."""
    points = list(tree.branch_points())
    rho, theta = (np.array([getattr(p, name) for p in points]) for name in ("rho", "theta"))
    across = np.sinh(rho)
    return points, np.stack([np.cosh(rho), across * np.cos(theta), across * np.sin(theta)], axis=1)


def distances(first: Array, second: Array) -> Array:
    """Distances between points (..., 3) of the hyperboloid, without cancellation."""
    gap = first - second
    chord = np.maximum(-(gap[..., 0] ** 2) + gap[..., 1] ** 2 + gap[..., 2] ** 2, 0)
    return np.asarray(2 * np.arcsinh(np.sqrt(chord) / 2))
