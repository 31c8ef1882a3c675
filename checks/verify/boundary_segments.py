"""Checks of section 4: corners and boundary segments of asymptotic complexes."""

from collections.abc import Iterator

import numpy as np

from checks.evidence import Evidence, Setting
from checks.verify import quad_meshes
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import SurgeryError
from discrete.complex_surgery import boundary_segment


def _complexes(*, ring: bool = False) -> Iterator[tuple[str, AsymptoticComplex]]:
    yield from quad_meshes.corpus().items()
    if ring:
        yield "ring of 4 quads", AsymptoticComplex(faces=quad_meshes.ring(4))


def _outer(complex_: AsymptoticComplex, vertex: int) -> list[tuple[int, bool]]:
    """Edges of the boundary at a vertex, and whether each is a u-edge."""
    found = []
    for edge in np.flatnonzero(complex_.sides.counts == 1):
        if vertex in complex_.edges[edge]:
            found.append((int(edge), bool(complex_.edge_is_u[edge])))
    return found


def boundary_path(complex_: AsymptoticComplex) -> list[int]:
    """Vertices met on the boundary from its lowest one on, until the path closes."""
    after: dict[int, list[int]] = {}
    for one, other in complex_.boundary_edges.tolist():
        after.setdefault(one, []).append(other)
        after.setdefault(other, []).append(one)
    path = [min(after)]
    before = -1
    while True:
        step = next(v for v in after[path[-1]] if v != before)
        if step == path[0]:
            return path
        before = path[-1]
        path.append(step)


def _result(failed: str, met: int, shown: str) -> Evidence:
    if failed:
        return Evidence(outcome="fail", grade="exact", witness=failed, tried=met, met=met)
    return Evidence(outcome="pass", grade="exact", residual="0", shown=shown, tried=met, met=met)


def corner_definition(setting: Setting, *, where: str = "boundary") -> Evidence:
    """def:corner: the shipped corners are the vertices with a u- and a v-edge in the boundary.

    where: "boundary" or, a near-miss, "anywhere": a u- and a v-edge of the complex.
    """
    failed, met, near = "", 0, 0
    for name, complex_ in _complexes():
        for v in range(complex_.vertex_count):
            outer = {is_u for _, is_u in _outer(complex_, v)}
            all_edges = {
                bool(complex_.edge_is_u[e])
                for e in np.flatnonzero((complex_.edges == v).any(axis=1))
            }
            stated = len(outer if where == "boundary" else all_edges) == 2
            met += 1
            near += len(all_edges) == 2 and len(outer) < 2
            if stated != complex_.is_corner[v]:
                failed = failed or f"{name}, vertex {v}: {len(outer)} families in the boundary"
    return _result(
        failed,
        met,
        f"the definition, read off edge by edge, gives the shipped corners of six complexes; "
        f"{near} vertices with edges of both families, but not in the boundary, are none",
    )


def segment_definition(setting: Setting, *, families: int = 1) -> Evidence:
    """Boundary segments: the shipped maximal ones are chains of boundary edges of one family.

    Near-misses: a chain through a corner, of two families, and a chain inside. families: how many
    a segment may have.
    """
    failed, met = "", 0
    for name, complex_ in _complexes():
        path = boundary_path(complex_)
        for corner in np.flatnonzero(complex_.is_corner):
            for along_u in (True, False):
                segment = boundary_segment(complex_, int(corner), along_u=along_u)
                met += 1
                if not _is_segment(complex_, segment.tolist(), families):
                    failed = failed or f"{name}: the segment {segment.tolist()} is refused"
            at = path.index(int(corner))
            around = [path[at - 1], path[at], path[(at + 1) % len(path)]]
            if _is_segment(complex_, around, families):
                failed = failed or f"{name}: {around}, of two families, is accepted"
        inner = next(e for e in complex_.edges[complex_.sides.counts == 2].tolist())
        if _is_segment(complex_, inner, families):
            failed = failed or f"{name}: the inner edge {inner} is accepted"
    return _result(
        failed,
        met,
        f"{met} maximal segments of six complexes are accepted; chains of two boundary edges "
        "around each corner and edges inside are refused",
    )


def _is_segment(complex_: AsymptoticComplex, path: list[int], families: int) -> bool:
    """Whether a path consists of boundary edges of at most so many families."""
    vertices = np.array(path)
    edges = complex_.edge_between(vertices[:-1], vertices[1:])
    if (edges < 0).any() or (complex_.sides.counts[edges] != 1).any():
        return False
    return len(set(complex_.edge_is_u[edges].tolist())) <= families


def segments(setting: Setting, *, inside: bool = False) -> Evidence:
    """lem:segments, both halves, on every run of boundary edges of one family.

    A corner on a segment is an end of it; each corner has one maximal segment of each family, and
    it ends at corners. inside: claims that corners lie inside segments.
    """
    failed, met = "", 0
    for name, complex_ in _complexes():
        path = boundary_path(complex_)
        count = len(path)
        for start in range(count):
            for length in range(1, count):
                run = [path[(start + k) % count] for k in range(length + 1)]
                if not _is_segment(complex_, run, 1):
                    break
                met += 1
                on = [v for v in run if complex_.is_corner[v]]
                ends = [v for v in run[1:-1] if complex_.is_corner[v]] if inside else []
                if not set(on) <= {run[0], run[-1]} or (inside and on and not ends):
                    failed = failed or f"{name}: the segment {run} has the corners {on}"
        failed = failed or _maximal(name, complex_)
    return _result(
        failed,
        met,
        f"on all {met} boundary segments of six complexes the corners met are ends; every corner "
        "is the end of one maximal u- and one maximal v-segment, which end at corners",
    )


def _maximal(name: str, complex_: AsymptoticComplex) -> str:
    for corner in np.flatnonzero(complex_.is_corner):
        for along_u in (True, False):
            found = boundary_segment(complex_, int(corner), along_u=along_u)
            if not (complex_.is_corner[found[-1]] and found[0] == corner and len(found) > 1):
                return f"{name}: the segment {found.tolist()} does not end at a corner"
    for v in np.flatnonzero(complex_.is_boundary & ~complex_.is_corner):
        try:
            boundary_segment(complex_, int(v), along_u=True)
        except SurgeryError:
            continue
        return f"{name}: vertex {v}, no corner, has a maximal segment"
    return ""


def jordan_curve(setting: Setting, *, ring: bool = False) -> Evidence:
    """Whether the boundary is one simple closed curve; ring: adds a complex with a hole."""
    failed, met = "", 0
    for name, complex_ in _complexes(ring=ring):
        met += 1
        path = boundary_path(complex_)
        if len(path) != complex_.is_boundary.sum() or len(set(path)) != len(path):
            failed = failed or (
                f"{name}: one closed path has {len(path)} of {complex_.is_boundary.sum()} "
                "vertices of the boundary"
            )
    return _result(
        failed, met, "on six disks one closed path meets every vertex of the boundary once"
    )


def two_edges_at_a_corner(setting: Setting, *, number: int = 2) -> Evidence:
    """Whether each corner is on `number` boundary edges, one of each family."""
    failed, met = "", 0
    for name, complex_ in _complexes():
        for v in np.flatnonzero(complex_.is_corner):
            met += 1
            outer = [is_u for _, is_u in _outer(complex_, int(v))]
            if len(outer) != number or len(set(outer)) != 2:
                failed = failed or f"{name}, corner {v}: {len(outer)} boundary edges"
    return _result(
        failed, met, f"each of the {met} corners of six complexes has one of each family"
    )
