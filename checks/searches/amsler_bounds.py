"""Certificate of the Bessel bounds on Amsler sectors over the whole range of phi_n and z.

The columns [low, high] of phi_n begin with a relative width of two percent and are halved, with
half the step in z, wherever a cell does not close; what has not closed at the last halving is kept
as open, with its share of the area in (log phi_n, z/z*).
"""

import hashlib
import multiprocessing
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict
from fractions import Fraction
from itertools import pairwise
from math import log
from typing import Any

from checks.searches.resumable import discard, swept
from checks.stored import hashes
from theory.amsler_bounds import column

SOURCES = (
    "checks/searches/amsler_bounds.py",
    "theory/amsler_bounds.py",
    "theory/bessel_kernel.py",
    "theory/bounded_series.py",
    "theory/enclosure.py",
    "theory/errors.py",
    "theory/majorant.py",
    "theory/painleve_origin.py",
    "theory/painleve_path.py",
    "theory/painleve_piece.py",
    "theory/painleve_step.py",
    "theory/precision.py",
    "theory/relaxed_sine.py",
    "theory/sinc_quotients.py",
)
LEAST = "1e-6"
#: Just above pi - 1/100.
TOP = "3.1316"
WIDTH = Fraction(2, 100)
STEP = Fraction(1, 20)
HALVINGS = 6


def columns() -> list[str]:
    """Columns that tile [LEAST, TOP] as texts: both ends as decimals, and 0 for never halved."""
    ends = [LEAST]
    while Fraction(ends[-1]) < Fraction(TOP):
        following = f"{float(Fraction(ends[-1]) * (1 + WIDTH)):.8g}"
        ends.append(following if Fraction(following) < Fraction(TOP) else TOP)
    return [f"{low} {high} 0" for low, high in pairwise(ends)]


def closed(text: str) -> dict[str, Any]:
    """Result of one column given as text, as plain data."""
    low, high, depth = text.split()
    step = STEP / 2 ** int(depth)
    found = column(Fraction(low), Fraction(high), top=Fraction(TOP), step=step)
    return {**asdict(found), "low": low, "high": high, "depth": int(depth)}


def halves(result: dict[str, Any]) -> list[str]:
    """Both halves of a column that did not close."""
    low, high, depth = result["low"], result["high"], result["depth"] + 1
    middle = f"{float((Fraction(low) + Fraction(high)) / 2):.12g}"
    return [f"{low} {middle} {depth}", f"{middle} {high} {depth}"]


def open_share(results: list[dict[str, Any]]) -> float:
    """Share of the area in (log phi_n, z/z*) whose cells are open."""
    total = log(Fraction(TOP) / Fraction(LEAST))
    return sum(
        log(Fraction(r["high"]) / Fraction(r["low"])) / total * _open_part(r) for r in results
    )


def _told(result: dict[str, Any]) -> str:
    """Where and why a column is open."""
    why = "open cells" if result["complete"] else "the enclosure of phi becomes too wide"
    return f"phi_n in [{result['low']}, {result['high']}]: {why} {result['open']}"


def _open_part(result: dict[str, Any]) -> float:
    """Part of [0, z*] that is open in a column: all of it where z* was not reached."""
    if not result["complete"]:
        return 1.0
    return float(sum(high - low for low, high in result["open"]) / result["reach"])


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Columns that close, with their bounds; margin is the least quotient minus 1 (seed unused)."""
    stamp = hashlib.sha256(str(hashes(SOURCES)).encode()).hexdigest()
    context = multiprocessing.get_context("forkserver")
    done: list[dict[str, Any]] = []
    keys = columns()
    with ProcessPoolExecutor(mp_context=context) as executor:
        for depth in range(HALVINGS + 1):
            progress(f"{len(keys)} columns, halved {depth} times")
            again: list[str] = []
            for _, result in swept(
                closed, keys, name="amsler_bounds", stamp=stamp, executor=executor,
                progress=progress,
            ):  # fmt: skip
                if depth < HALVINGS and (result["open"] or not result["complete"]):
                    again += halves(result)
                else:
                    done.append(result)
            if not (keys := again):
                break
    discard("amsler_bounds")
    done.sort(key=lambda result: Fraction(result["low"]))
    return {
        "evaluations": sum(result["cells"] for result in done),
        "margin": min(result["quotient"] for result in done) - 1,
        "top": TOP,
        "gap": min(result["gap"] for result in done),
        "open_share": open_share(done),
        "open": [_told(result) for result in done if result["open"] or not result["complete"]],
        "columns": [[result[name] for name in ("low", "high", "depth")] for result in done],
    }
