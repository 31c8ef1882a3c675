"""Which surfaces smooth isometries approximate, as printed (section 3.3)."""

from typing import Any


def is_branch_point(index: Any, *, least: int = 2, factor: int = 1) -> bool:
    """Whether a point of this index J is a branch point, by J >= least."""
    return bool(factor * index >= least)
