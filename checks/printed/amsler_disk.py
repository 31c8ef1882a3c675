"""The Amsler net in the disk and its first cuts as printed (section 4.1)."""

from typing import Any

from checks.printed.poincare_disk import Pair, on_ray

#: What each panel of (fig:geodesicballs) shows, by its caption and by the text that cites it.
PANELS = {
    "caption": {"a": "asymptotic coordinates", "b": "disk"},
    "text": {"a": "disk", "b": "asymptotic coordinates"},
}


def boundary_data(
    j: Any, k: Any, spacing: Any, field: Any, *, rate: str = "1/2", quarter_turns: int = 1
) -> tuple[Pair, Pair]:
    """Nodes zeta_(j,0) and zeta_(0,k) (line 1198); quarter_turns: from the first to the second."""
    first, second = (on_ray(n, spacing, 0, field, rate=rate) for n in (j, k))
    turn = {1: (-second[1], second[0]), 2: (-second[0], -second[1]), 0: second}[quarter_turns]
    return first, turn
