"""Unknown surfaces over stars, on which the checks of concentration are identities."""

from collections.abc import Callable, Iterable
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from theory.star_field import StarField

ORDERS = (2, 3, 4, 5)


def over_fields(
    setting: Setting,
    residuals: Callable[[StarField], dict[str, Any]],
    *,
    shown: str,
    orders: Iterable[int] = ORDERS,
    **hypotheses: Any,
) -> Evidence:
    """Identities on unknown surfaces over stars of these orders, under the hypotheses."""
    found: dict[str, Any] = {}
    for m in orders:
        for name, value in residuals(StarField(order=m, **hypotheses)).items():
            found[f"m = {m}, {name}"] = sp.expand(value)
    return identities(setting, found, shown=shown)
