"""Run a search and store what it found: `python -m checks.searches NAME [SEED]`."""

import sys
from importlib import import_module

from checks.stored import StoredRun, hashes, store

NAMES = (
    "amsler_bounds",
    "efimov",
    "greedy_certificates",
    "greedy_limits",
    "greedy_runs",
    "hilbert",
    "john",
    "nash_kuiper",
    "normal_map",
    "smooth_disks",
    "smooth_near_star",
    "star_normals",
)
USAGE = f"usage: python -m checks.searches NAME [SEED], NAME one of {', '.join(NAMES)}\n"


def main(arguments: list[str]) -> int:
    """Run the search named first, with the seed named second (0 if left out); the exit code."""
    seed_text = arguments[1] if len(arguments) == 2 else "0"
    known = bool(arguments) and arguments[0] in NAMES
    if not (known and len(arguments) <= 2 and seed_text.isdecimal()):
        sys.stderr.write(USAGE)
        return 2
    name, seed = arguments[0], int(seed_text)
    module = import_module(f"checks.searches.{name}")
    sources = hashes(module.SOURCES)  # before the run, which a change meanwhile must make stale
    try:
        result = dict(module.search(seed=seed, progress=lambda text: sys.stderr.write(text + "\n")))
    except KeyboardInterrupt:
        sys.stderr.write("interrupted: nothing was stored\n")
        return 130
    run = StoredRun(
        name=name,
        seed=seed,
        evaluations=result.pop("evaluations"),
        result=result,
        sources=sources,
    )
    sys.stdout.write(f"{store(run)}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
