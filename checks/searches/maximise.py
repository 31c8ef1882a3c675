"""Maximise a function over a box, starting from the box's faces: the optimiser of the searches."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import differential_evolution, minimize

Objective = Callable[[np.ndarray], float]


@dataclass(frozen=True, kw_only=True)
class Best:
    """Largest value found, where, and after how many evaluations of the objective."""

    point: tuple[float, ...]
    value: float
    evaluations: int


def _on_faces(
    low: np.ndarray, high: np.ndarray, population: int, rng: np.random.Generator
) -> np.ndarray:
    """Points of the box with about half of their coordinates at an end of the range."""
    inside = rng.uniform(low, high, size=(population, len(low)))
    faces = rng.random(inside.shape)
    return np.where(faces < 0.25, low, np.where(faces > 0.75, high, inside))


def from_the_faces(
    objective: Objective,
    bounds: tuple[tuple[float, float], ...],
    *,
    seed: int,
    known: tuple[tuple[float, ...], ...] = (),
    population: int = 60,
    generations: int = 200,
    polish: int = 2000,
    progress: Callable[[str], None],
) -> Best:
    """Maximum of the objective by differential evolution and a simplex search from its best point.

    Each of the first population's points, `known` among them, lies on random faces of the box, the
    edge of the admissible data. The result is the largest value of all evaluations, never an
    estimate; the count is of evaluations made.
    """
    low, high = np.array(bounds).T
    best = Best(point=(), value=-np.inf, evaluations=0)

    def cost(point: np.ndarray) -> float:
        nonlocal best
        inside = np.clip(point, low, high)
        value = float(objective(inside))
        kept = value > best.value
        best = Best(
            point=tuple(float(x) for x in inside) if kept else best.point,
            value=value if kept else best.value,
            evaluations=best.evaluations + 1,
        )
        return -value

    start = _on_faces(low, high, population, np.random.default_rng(seed))
    if known:
        start[: len(known)] = known
    differential_evolution(
        cost, list(bounds), init=start, maxiter=generations, tol=0.0, polish=False, seed=seed
    )
    progress(f"{best.evaluations} evaluations: {best.value:.9g}")
    minimize(
        cost,
        np.array(best.point),
        method="Nelder-Mead",
        options={"maxfev": polish, "xatol": 1e-12, "fatol": 1e-14, "adaptive": True},
    )
    progress(f"{best.evaluations} evaluations: {best.value:.9g}")
    return best
