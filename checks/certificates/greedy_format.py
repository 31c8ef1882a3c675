"""Certificate of a run of the greedy algorithm, read from plain JSON data and refused in one line.

Keys: `format`; `parameters` (radius, step: rationals as text; sectors; cutoff: the rationals a, b
of a + b pi); `bits`; `sectors`, each with path, opening, quads, area, largest, smallest (null or
[angle, [i, j]]) and cut (null or i, k, angle, rho, theta, row, column); `totals` (sectors,
branch_points, quads, generations, area, largest, smallest). A ball is the text "m e r f" of four
integers: midpoint m 2^e, radius r 2^f.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

FORMAT = "kminusone greedy certificate 1"


class MalformedError(ValueError):
    """The data are no certificate; the message is one line."""


@dataclass(frozen=True, kw_only=True)
class Ball:
    """Closed interval from low to high, exact."""

    low: Fraction
    high: Fraction


@dataclass(frozen=True, kw_only=True)
class Extreme:
    """Angle at a vertex (i, j) of its sector."""

    angle: Ball
    vertex: tuple[int, int]


@dataclass(frozen=True, kw_only=True)
class Cut:
    """Cut at vertex (i, k); row, column: witnesses of angles beyond the cutoff."""

    i: int
    k: int
    angle: Ball
    rho: Ball
    theta: Ball
    row: Extreme
    column: Extreme


@dataclass(frozen=True, kw_only=True)
class Sector:
    """One sector up to symmetry."""

    path: str
    opening: Ball
    quads: int
    area: Ball
    largest: Extreme | None
    smallest: Extreme | None
    cut: Cut | None


@dataclass(frozen=True, kw_only=True)
class Certificate:
    """All that a run claims."""

    radius: Fraction
    step: Fraction
    sectors: int
    cutoff: tuple[Fraction, Fraction]
    tree: tuple[Sector, ...]
    counts: Mapping[str, int]
    area: Ball
    largest: Ball
    smallest: Ball


def certificate(data: Any) -> Certificate:
    """Certificate from JSON data. Raises MalformedError, which names what is wrong."""
    top = _fields(data, "certificate", ("format", "parameters", "bits", "sectors", "totals"))
    if top["format"] != FORMAT:
        raise MalformedError(f"format {top['format']!r}: expected {FORMAT!r}")
    _count(top["bits"], "bits")
    given = _fields(top["parameters"], "parameters", ("radius", "step", "sectors", "cutoff"))
    cutoff = _list(given["cutoff"], "cutoff")
    if len(cutoff) != 2:
        raise MalformedError("cutoff: expected two rationals")
    names = ("sectors", "branch_points", "quads", "generations")
    totals = _fields(top["totals"], "totals", (*names, "area", "largest", "smallest"))
    found = Certificate(
        radius=_rational(given["radius"], "radius"),
        step=_rational(given["step"], "step"),
        sectors=_count(given["sectors"], "sectors"),
        cutoff=(_rational(cutoff[0], "cutoff"), _rational(cutoff[1], "cutoff")),
        tree=tuple(_sector(entry) for entry in _list(top["sectors"], "sectors")),
        counts={name: _count(totals[name], name) for name in names},
        area=_ball(totals["area"], "area"),
        largest=_ball(totals["largest"], "largest"),
        smallest=_ball(totals["smallest"], "smallest"),
    )
    if not 0 < found.step <= found.radius <= 50 or found.sectors < 4 or found.sectors % 2:
        raise MalformedError("parameters: expected 0 < step <= radius <= 50, sectors even, >= 4")
    return found


def _sector(data: Any) -> Sector:
    names = ("path", "opening", "quads", "area", "largest", "smallest", "cut")
    entry = _fields(data, "sector", names)
    path = entry["path"]
    if not isinstance(path, str) or set(path) - set("uAv"):
        raise MalformedError(f"path {path!r}: expected letters u, A, v")
    return Sector(
        path=path,
        opening=_ball(entry["opening"], "opening"),
        quads=_count(entry["quads"], "quads"),
        area=_ball(entry["area"], "area"),
        largest=None if entry["largest"] is None else _extreme(entry["largest"]),
        smallest=None if entry["smallest"] is None else _extreme(entry["smallest"]),
        cut=None if entry["cut"] is None else _cut(entry["cut"]),
    )


def _cut(data: Any) -> Cut:
    entry = _fields(data, "cut", ("i", "k", "angle", "rho", "theta", "row", "column"))
    return Cut(
        i=_count(entry["i"], "i"),
        k=_count(entry["k"], "k"),
        angle=_ball(entry["angle"], "angle"),
        rho=_ball(entry["rho"], "rho"),
        theta=_ball(entry["theta"], "theta"),
        row=_extreme(entry["row"]),
        column=_extreme(entry["column"]),
    )


def _extreme(data: Any) -> Extreme:
    pair = _list(data, "extreme")
    if len(pair) != 2 or len(_list(pair[1], "vertex")) != 2:
        raise MalformedError(f"extreme {str(data)[:60]}: expected [angle, [i, j]]")
    i, j = (_count(n, "vertex") for n in pair[1])
    return Extreme(angle=_ball(pair[0], "angle"), vertex=(i, j))


def _fields(data: Any, what: str, names: tuple[str, ...]) -> Mapping[str, Any]:
    if not isinstance(data, Mapping):
        raise MalformedError(f"{what}: expected an object, not {type(data).__name__}")
    if set(data) != set(names):
        raise MalformedError(f"{what}: expected the keys {', '.join(names)}")
    return data


def _list(data: Any, what: str) -> list[Any]:
    if not isinstance(data, list | tuple):
        raise MalformedError(f"{what}: expected a list, not {type(data).__name__}")
    return list(data)


def _count(data: Any, what: str) -> int:
    if type(data) is not int or data < 0:
        raise MalformedError(f"{what} = {str(data)[:40]!r}: expected an integer of 0 or more")
    return data


def _rational(data: Any, what: str) -> Fraction:
    try:
        if isinstance(data, str) and len(data) < 100 and "e" not in data.lower():
            return Fraction(data)
    except (ValueError, ZeroDivisionError):
        pass
    raise MalformedError(f"{what} = {str(data)[:40]!r}: expected a rational as text")


def _ball(data: Any, what: str) -> Ball:
    parts = data.split(" ") if isinstance(data, str) else []
    try:
        m, e, r, f = (int(part) for part in parts)
    except ValueError:
        raise MalformedError(f"{what} = {str(data)[:40]!r}: expected four integers") from None
    if r < 0 or max(abs(e), abs(f)) > 10**5:
        raise MalformedError(f"{what}: a negative radius or an exponent out of range")
    middle, radius = m * Fraction(2) ** e, r * Fraction(2) ** f
    return Ball(low=middle - radius, high=middle + radius)
