"""Table of the README's section on speed: `make speed` measures it and puts it in place.

Each row runs in a process of its own, so that its peak of memory is its own too: once to warm the
kernels, then so many times; the median counts. Nothing is decided by it.
"""

import json
import platform
import statistics
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path
from typing import Any

README = Path(__file__).resolve().parents[2] / "README.md"
BEGIN, END = "<!-- begin: built by `make speed` -->", "<!-- end: built by `make speed` -->"

#: Radius, edge length and rounds.
ROWS = ((4, "0.02", 9), (6, "0.02", 9), (8, "0.02", 5), (10, "0.02", 5), (12, "0.04", 3),
        (14, "0.04", 1))  # fmt: skip
THREADS = 2


def _run(radius: int, step: str) -> Any:
    from discrete.exact_angle import ExactAngle
    from discrete.greedy_parameters import GreedyParameters

    return GreedyParameters(
        radius=Fraction(radius),
        step=Fraction(step),
        sectors=4,
        cutoff=ExactAngle(half_turns=Fraction(3, 4)),
    )


def _timed(call: Any, rounds: int) -> tuple[Any, float]:
    seconds, found = [], None
    for _ in range(rounds):
        start = time.perf_counter()
        found = call()
        seconds.append(time.perf_counter() - start)
    return found, statistics.median(seconds)


def measured(radius: int, step: str, rounds: int) -> dict[str, Any]:
    """Seconds of a run, branch points, area, peak of the memory of this process in MB."""
    import resource

    from discrete.greedy import grown

    with ThreadPoolExecutor(THREADS) as threads:
        grown(_run(2, "0.05"), executor=threads)
        tree, seconds = _timed(
            lambda: grown(_run(radius, step), executor=threads, max_cuts=2 * 10**6), rounds
        )
    return {
        "radius": radius,
        "step": step,
        "seconds": seconds,
        "branch_points": tree.branch_point_count,
        "area": tree.parameters.area,
        "megabytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }


def surface(rounds: int = 9) -> tuple[float, int]:
    """Seconds for normals and surface of R = 4 at 0.02, and the number of vertices."""
    from discrete.greedy import grown
    from discrete.greedy_net import greedy_net

    tree = grown(_run(4, "0.02"))
    greedy_net(tree)
    net, seconds = _timed(lambda: greedy_net(tree), rounds)
    return seconds, len(net.disk)


def processor() -> str:
    """Name of the processor, as far as the system tells it."""
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def lines(rows: list[dict[str, Any]], net: tuple[float, int]) -> list[str]:
    """The section: machine, one line a run, the time per area against that of R = 6."""
    unit = next(row["seconds"] / row["area"] for row in rows if row["radius"] == 6)
    found = [
        f"Four initial sectors, cutoff 3 pi/4, {THREADS} threads, warm kernels, medians, on",
        f"{processor()} with Python {platform.python_version()}.",
        "The last column compares the time for a unit of area, at edges of one length, to R = 6.",
        "",
        "| R | edges | seconds | branch points | peak MB | time/area |",
        "| ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for row in rows:
        scale = (Fraction(row["step"]) / Fraction("0.02")) ** 2
        ratio = row["seconds"] / row["area"] / unit * float(scale)
        found.append(
            f"| {row['radius']} | {row['step']} | {row['seconds']:.3g} | {row['branch_points']} | "
            f"{row['megabytes']:.0f} | {ratio:.2f} |"
        )
    seconds, vertices = net
    found += [
        "",
        f"Net, normals and surface of R = 4 at 0.02, {vertices} vertices: {seconds:.2g} s.",
        "",
        "A run of more than 10^6 cuts stays partial unless `--max-cuts` is raised.",
    ]
    return found


def main() -> None:
    """Measure all rows and rewrite the section."""
    if len(sys.argv) == 4:
        sys.stdout.write(json.dumps(measured(int(sys.argv[1]), sys.argv[2], int(sys.argv[3]))))
        return
    rows = []
    for radius, step, rounds in ROWS:
        words = [sys.executable, "-m", "tests.benchmarks.speed_table", str(radius), step]
        done = subprocess.run([*words, str(rounds)], capture_output=True, text=True, check=True)
        rows.append(json.loads(done.stdout))
        sys.stderr.write(f"R = {radius}: {rows[-1]['seconds']:.3g} s\n")
    text = README.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    body = "\n".join([BEGIN, "", *lines(rows, surface()), "", END])
    README.write_text(before + body + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
