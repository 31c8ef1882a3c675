"""Checks of the topology of asymptotic complexes: disks, spheres, the two grids of the figure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.printed import asymptotic_complexes as printed
from checks.verify.asymptotic_complexes_samples import operated_star, samples
from checks.verify.binary_rank import binary_rank, bits
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import ComplexError
from discrete.complex_maps import isomorphism
from discrete.complex_surgery import restricted
from discrete.gluing import star
from discrete.quad_graph import sides
from discrete.refinement import refined
from discrete.signed_graph import signs
from discrete.vertex_fan import vertex_fan

SPHERES: Mapping[str, tuple[tuple[int, ...], ...]] = MappingProxyType(
    {
        "two rectangles glued along all four sides": ((0, 1, 2, 3), (0, 1, 2, 3)),
        "the cube": (
            (0, 1, 3, 2),
            (4, 5, 7, 6),
            (0, 1, 5, 4),
            (2, 3, 7, 6),
            (0, 2, 6, 4),
            (1, 3, 7, 5),
        ),
    }
)
"""Spheres of quads: the first has two families and is not regular, the second the reverse."""


@dataclass(frozen=True, kw_only=True)
class Homology:
    """Euler characteristic and first Betti number modulo 2 of a quad-graph, by ranks."""

    euler: int
    betti: int
    parts: int


def homology(complex_: AsymptoticComplex) -> Homology:
    """Homology modulo 2 from the two boundary matrices."""
    faces = binary_rank(bits(edges) for edges in complex_.sides.edge_of.tolist())
    edges = binary_rank(bits(ends) for ends in complex_.edges.tolist())
    return Homology(
        euler=complex_.vertex_count - len(complex_.edges) + len(complex_.faces),
        betti=len(complex_.edges) - edges - faces,
        parts=complex_.vertex_count - edges,
    )


def _no_disk(complex_: AsymptoticComplex) -> str:
    """Why a complex without first homology is no disk: its boundary, capped, is no sphere."""
    found = homology(complex_)
    circles = complex_.boundary_circles
    if complex_.orientation is None or circles != 1 or found.euler + circles != 2:
        return f"Euler characteristic {found.euler}, {circles} boundary circles"
    return ""


def simply_connected_disk(setting: Setting, *, simply_connected: bool = True) -> Evidence:
    """Complexes without first homology modulo 2, against orientation, boundary and capped sphere.

    simply_connected: whether only those are meant, or all that are connected.
    """
    met = tried = 0
    for name, complex_ in samples(setting, simply_connected=False).items():
        tried += 1
        if simply_connected and homology(complex_).betti:
            if complex_.is_disk:
                return statement(False, shown="", witness=f"{name} has homology, yet is a disk")
            continue
        met += 1
        if witness := _no_disk(complex_):
            return statement(False, shown="", witness=f"{name}: {witness}")
    return Evidence(
        outcome="pass",
        grade="exact",
        residual="0",
        tried=tried,
        met=met,
        shown="every connected complex without first homology is orientable, has one boundary "
        "circle, and becomes a sphere when this is capped: it lies in the plane as a disk",
    )


def has_families(faces: Sequence[Sequence[int]]) -> bool:
    """Whether the edges fall into two families that alternate around each face."""
    found = sides(np.array(faces))
    following = np.roll(found.edge_of, -1, axis=1)
    links = np.stack([found.edge_of.ravel(), following.ravel()], axis=1)
    return signs(len(found.keys), links, np.ones(len(links), dtype=np.bool_)) is not None


def no_sphere(setting: Setting, *, regular: bool = True, families: bool = True) -> Evidence:
    """Whether an asymptotic complex can be a sphere, which has no embedding into the plane.

    On a sphere of quads the sum of 4 - degree is 8; two families make degrees even, and strong
    regularity at least 3. regular, families: whether the definition asks for them.
    """
    v, e, f = sp.symbols("V E F")
    solved = sp.solve([v - e + f - 2, 2 * e - 4 * f], [e, f], dict=True)[0]
    missing = sp.expand(4 * v - 2 * solved[e])
    for name, faces in SPHERES.items():
        found = sides(np.array(faces))
        euler = found.vertices - len(found.keys) + len(faces)
        admitted = printed.is_quad_graph(faces, regular=regular)
        if euler == 2 and admitted and (has_families(faces) or not families):
            degree = int(np.bincount(found.edges.ravel()).min())
            return statement(
                False,
                shown="",
                witness=f"{name}: a sphere with vertices of degree {degree}, simply connected and "
                "in no plane",
            )
    return statement(
        bool(missing == 8),
        shown="on a sphere the sum of 4 - degree is 8, so that a vertex has degree 2 or 3; two "
        "families make degrees even, and at a vertex of degree 2 two faces have two common edges",
        witness=f"the sum of 4 - degree over a sphere is {missing}",
    )


def disk(
    setting: Setting, *, simply_connected: bool = True, regular: bool = True, families: bool = True
) -> Evidence:
    """Remark: a simply connected asymptotic complex is a disk, and no sphere."""
    return combined(
        {
            "disk": simply_connected_disk(setting, simply_connected=simply_connected),
            "sphere": no_sphere(setting, regular=regular, families=families),
        },
        shown="without first homology a complex with a boundary is a disk (classification of "
        "surfaces), seen on every sample; one without a boundary would be a sphere, which the "
        "degrees forbid",
    )


def links_span(setting: Setting, *, simply_connected: bool = True) -> Evidence:
    """Rank modulo 2 of the links of interior vertices among the cycles of the dual graph."""
    found = samples(setting, simply_connected=simply_connected)
    for tried, (name, complex_) in enumerate(found.items(), start=1):
        inside = np.flatnonzero(~complex_.is_boundary)
        spanned = binary_rank(bits(vertex_fan(complex_, int(v)).edges) for v in inside)
        cycles = len(complex_.dual_links) - len(complex_.faces) + 1
        if spanned != cycles:
            return Evidence(
                outcome="fail",
                grade="exact",
                tried=tried,
                met=tried,
                witness=f"{name}: the links span {spanned} of {cycles} dimensions of dual cycles",
            )
    return Evidence(
        outcome="pass",
        grade="exact",
        residual="0",
        tried=len(found),
        met=len(found),
        shown="in a disk every cycle of the dual graph is a sum modulo 2 of links: they are "
        "independent, and Euler's formula counts as many interior vertices as dimensions",
    )


def skeleton(setting: Setting, *, rays: int = 6, inserted: int = 3, hole: bool = False) -> Evidence:
    """The two grids of the figure: a star of six sectors, and a star of four after surgery.

    rays: of the star; inserted: sectors for the one cut out; hole: whether the faces at the
    centre are taken away.
    """
    try:
        grids = {"assembly": star([3] * rays), "surgery": operated_star(inserted, length=3, new=3)}
    except ComplexError as error:
        return statement(False, shown="", witness=str(error))
    for name, complex_ in grids.items():
        kept, _ = restricted(complex_, (complex_.faces != 0).all(axis=1)) if hole else (complex_, 0)
        if kept.checkerboard is None or homology(kept).betti or _no_disk(kept):
            return statement(
                False,
                shown="",
                witness=f"{name}: first Betti number {homology(kept).betti}, "
                f"{kept.boundary_circles} boundary circles",
            )
        if kept.saddle_order[kept.branch_points].tolist() != [3]:
            orders = kept.saddle_order[kept.branch_points].tolist()
            return statement(False, shown="", witness=f"{name}: branch points of orders {orders}")
    return statement(
        True,
        shown="both grids are asymptotic complexes, disks with a checkerboard, with one branch "
        "point, of order 3",
        witness="",
    )


def grids_equivalent(
    setting: Setting, *, inserted: int = 3, length: int = 2, new: int = 2, rays: int = 6
) -> Evidence:
    """Isomorphism of the assembled star with the star after surgery, verified edge by edge."""
    assembled, operated = star([length] * rays), operated_star(inserted, length=length, new=new)
    images = isomorphism(operated, assembled)
    if images is None:
        return statement(
            False,
            shown="",
            witness=f"{len(operated.faces)} faces after surgery, {len(assembled.faces)} in the "
            "star: no isomorphism keeps the families",
        )
    edges = {frozenset(edge) for edge in images[operated.edges].tolist()}
    families = (
        operated.edge_is_u == assembled.edge_is_u[assembled.edge_between(*images[operated.edges].T)]
    )
    return statement(
        edges == {frozenset(edge) for edge in assembled.edges.tolist()}
        and bool(families.all() or not families.any()),
        shown="the star of six sectors is the star of four with one sector replaced by three, by "
        "an isomorphism of graphs that keeps faces and families",
        witness="the map found does not take edges to edges",
    )


def branch_points(setting: Setting, *, regular: int = 2, rounds: int = 2) -> Evidence:
    """Points of order m_p other than 2, on finer and finer divisions of a complex.

    Every point with rational coordinates in its face becomes a vertex at last; the branch points,
    old vertices, stay what they are.
    """
    for name, complex_ in samples(setting, simply_connected=True, random=6).items():
        counts, found = [], complex_
        for _ in range(rounds + 1):
            order = found.saddle_order[~found.is_boundary]
            counts.append(sum(printed.is_branch_point(int(m), regular=regular) for m in order))
            found = refined(found)
        if len(set(counts)) > 1:
            return statement(
                False,
                shown="",
                witness=f"{name}: {', '.join(map(str, counts))} branch points, the more the finer "
                "the faces are divided",
            )
        if counts[0] != len(complex_.branch_points):
            return statement(False, shown="", witness=f"{name}: {counts[0]} branch points")
    return statement(
        True,
        shown="m_p = 2 inside faces and edges of a complex, so that the branch points are among "
        "the finitely many vertices, and none in a grid",
        witness="",
    )
