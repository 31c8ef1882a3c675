"""The shipped rule that closes a Chebyshev quad, run on symbols: a proof about that function."""

from collections.abc import Callable
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from discrete.quad_rule import close_quad
from discrete.space_forms import SPACE_FORMS, Product, Triple

Rule = Callable[[Product, Triple, Triple, Triple], Triple]


def _altered(factor: Any, sign: int, *, midpoint: bool = False) -> Rule:
    """Rule with another factor in k, or another sign of p, or without k."""

    def rule(dot: Product, p: Triple, p1: Triple, p2: Triple) -> Triple:
        s = tuple(a + b for a, b in zip(p1, p2, strict=True))
        k = 1 if midpoint else factor * dot(p, s) / dot(s, s)
        return tuple(k * a + sign * b for a, b in zip(s, p, strict=True))

    return rule


_RULES: dict[str, Rule] = {
    "shipped": close_quad,
    "plus p": _altered(2, 1),
    "no factor 2": _altered(1, -1),
    "factor 101/50": _altered(sp.Rational(101, 50), -1),
    "plain midpoint": _altered(2, -1, midpoint=True),
}


def closes(setting: Setting, *, rule: str = "shipped") -> Evidence:
    """Whether p12 lies on the space of p and opposite sides of p, p1, p12, p2 are equal.

    For any triples with <p1, p1> = <p2, p2>, so for every Chebyshev parallelogram of S^2 and H^2:
    each difference is shown to be <p, s> (<p1, p1> - <p2, p2>)/<s, s> with s = p1 + p2.
    """
    p, p1, p2 = (sp.symbols(f"{name}0:3", real=True) for name in ("p", "q", "r"))
    residuals: dict[str, Any] = {}
    for space in SPACE_FORMS:
        dot = space.dot
        p12 = _RULES[rule](dot, p, p1, p2)
        s = tuple(a + b for a, b in zip(p1, p2, strict=True))
        rest = dot(p, s) * (dot(p1, p1) - dot(p2, p2)) / dot(s, s)
        residuals |= {
            f"{space.name}: <p12, p12> - <p, p>": dot(p12, p12) - dot(p, p),
            f"{space.name}: <p1, p12> - <p, p2> - rest": dot(p1, p12) - dot(p, p2) - rest,
            f"{space.name}: <p2, p12> - <p, p1> + rest": dot(p2, p12) - dot(p, p1) + rest,
        }
    return identities(
        setting,
        residuals,
        shown="discrete.quad_rule.close_quad on symbols: p12 is on the space and opposite sides of "
        "the quad are equal, whatever the two lengths, on S^2 and on H^2",
    )
