"""Run a search and store what it found: `python -m checks.searches NAME [SEED]`."""

import sys
from importlib import import_module

from checks.stored import StoredRun, hashes, store


def main(arguments: list[str]) -> int:
    """Run the search named first, with the seed named second (0 if left out)."""
    if not 1 <= len(arguments) <= 2:
        sys.stderr.write("usage: python -m checks.searches NAME [SEED]\n")
        return 2
    name, seed = arguments[0], int(arguments[1]) if len(arguments) == 2 else 0
    module = import_module(f"checks.searches.{name}")
    sources = hashes(module.SOURCES)  # before the run, which a change meanwhile must make stale
    result = dict(module.search(seed=seed, progress=lambda text: sys.stderr.write(text + "\n")))
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
