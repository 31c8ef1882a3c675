"""Section 4.1: an instance of a hyperbolic Chebyshev net, exactly, and near misses of it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import hyperbolic_nets as printed
from discrete import poincare_disk
from discrete.goursat_fill import fill
from discrete.space_forms import dot_h2

_COUNT = 3
_STEP = sp.Rational(1, 3)  # tanh(Delta/2), so that all nodes are rational
_SECOND_AXIS = (sp.Rational(3, 5), sp.Rational(4, 5))

Vertex = tuple[int, int]


@dataclass(frozen=True, kw_only=True)
class _Net:
    """Places of the vertices, faces, marks of the edges."""

    places: dict[Vertex, Any]
    faces: list[tuple[Vertex, ...]]
    marks: dict[frozenset[Vertex], str]


def _axis(direction: tuple[Any, Any]) -> list[Any]:
    """Triples of equally spaced points of a geodesic through 0; tanh adds rationally."""
    modulus, points = sp.Integer(0), []
    for _ in range(_COUNT + 1):
        points.append(poincare_disk.from_disk([modulus * part for part in direction]))
        modulus = (modulus + _STEP) / (1 + modulus * _STEP)
    return points


def _instance() -> _Net:
    """Rectangle between two geodesics, filled by half-turns of the hyperboloid."""
    nodes = fill(dot_h2, _axis((sp.Integer(1), sp.Integer(0))), _axis(_SECOND_AXIS))
    places = {(i, j): poincare_disk.to_disk(p) for i, row in enumerate(nodes)
              for j, p in enumerate(row)}  # fmt: skip
    faces: list[tuple[Vertex, ...]] = [
        ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
        for i in range(_COUNT)
        for j in range(_COUNT)
    ]
    marks: dict[frozenset[Vertex], str] = {}
    for i, j in places:
        for mark, other in (("u", (i + 1, j)), ("v", (i, j + 1))):
            if other in places:
                marks[frozenset(((i, j), other))] = mark
    return _Net(places=places, faces=faces, marks=marks)


def _near_misses(net: _Net) -> Iterator[tuple[str, _Net]]:
    corner: Vertex = (_COUNT, _COUNT)
    x, y = net.places[corner]
    moved = {**net.places, corner: (x + sp.Rational(1, 1000), y)}
    yield "one vertex moved by 1/1000", replace(net, places=moved)
    edge = frozenset(((1, 1), (2, 1)))
    yield "one u-edge marked v", replace(net, marks={**net.marks, edge: "v"})
    yield "all edges marked u", replace(net, marks=dict.fromkeys(net.marks, "u"))
    joined: tuple[Vertex, ...] = ((0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1))
    kept = [face for face in net.faces if not set(face) <= set(joined)]
    yield "two quads joined to a hexagon", replace(net, faces=[*kept, joined])
    first = net.faces[0]
    swapped = (first[0], first[2], first[1], first[3])
    marks = {**net.marks, frozenset((first[0], first[2])): "u",
             frozenset((first[1], first[3])): "u",
             frozenset((first[2], first[1])): "v"}  # fmt: skip
    yield "a side taken for a diagonal", replace(net, faces=[swapped, *net.faces[1:]], marks=marks)


def definition(setting: Setting, *, alternating: bool = True, rule: bool = True) -> Evidence:
    """Whether the definition accepts a net made by half-turns and refuses each near miss."""
    del setting
    net = _instance()
    options = {"alternating": alternating, "rule": rule}
    if not printed.is_chebyshev_net(net.places, net.faces, net.marks, sp, **options):
        return statement(False, shown="", witness="the net made by half-turns is refused")
    for name, other in _near_misses(net):
        if printed.is_chebyshev_net(other.places, other.faces, other.marks, sp, **options):
            return statement(False, shown="", witness=f"a near miss is accepted: {name}")
    return statement(
        True,
        shown="a rational net of nine quads made by half-turns of the hyperboloid is accepted; "
        "moved vertices, wrong marks, a hexagon and a crossed quad are refused",
        witness="",
    )
