"""Checks of the sectors at a point: their number, what they contain, how their normals wind."""

from fractions import Fraction
from random import Random

import numpy as np
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import asymptotic_complexes as printed
from checks.verify.asymptotic_complexes_samples import samples
from checks.verify.exact_winding import cross, winding
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import SurgeryError
from discrete.complex_surgery import quadrant
from discrete.vertex_fan import vertex_fan
from theory import star_saddle

_ORDERS = (2, 3, 4, 5, 6)


def angle_sum(setting: Setting, *, per_order: int = 1, offset: int = 0) -> Evidence:
    """Number and sum of the angles of the sectors at a point of order m_p.

    The faces at each interior vertex of complexes are counted; the angles are those of the regular
    m-star and of random ones.
    """
    wanted = {"per_order": per_order, "offset": offset}
    rng = setting.random()
    for m in _ORDERS:
        count = printed.sector_count(m, **wanted)
        for angles in (star_saddle.regular_star(m), _random_star(m, rng)):
            total = sum(angles[:count], sp.Integer(0))
            if len(angles) != count or total != 2 * sp.pi:
                return statement(
                    False,
                    shown="",
                    witness=f"an m-star with m_p = {m} has the {len(angles)} angles "
                    f"{', '.join(map(str, angles))}: {count} of them add up to {total}",
                )
    found = samples(setting, simply_connected=False)
    for name, complex_ in found.items():
        for vertex in np.flatnonzero(~complex_.is_boundary):
            order, faces = int(complex_.saddle_order[vertex]), int(complex_.face_count[vertex])
            if faces != printed.sector_count(order, **wanted):
                return statement(
                    False, shown="", witness=f"{name}: {faces} sectors where m_p = {order}"
                )
    return Evidence(
        outcome="pass",
        grade="exact",
        residual="0",
        tried=len(found) + 2 * len(_ORDERS),
        met=len(found) + 2 * len(_ORDERS),
        shown="a point of order m_p has 2 m_p sectors, one between neighbouring asymptotic curves "
        "of which m_p are of either family; their angles fill the full turn",
    )


def _random_star(m: int, rng: Random) -> tuple[sp.Expr, ...]:
    """Angles of a random m-star: 2m rational multiples of pi below pi, of sum 2 pi."""
    while True:
        parts = [rng.randint(1, 20) for _ in range(2 * m)]
        if 2 * max(parts) < sum(parts):
            return tuple(sp.Rational(2 * part, sum(parts)) * sp.pi for part in parts)


def _line(complex_: AsymptoticComplex, start: int, edge: int) -> set[int]:
    """Vertices of the asymptotic line that leaves a vertex along an edge, up to where it ends."""
    line, at = {start}, start
    while True:
        ends = complex_.edges[edge].tolist()
        at = ends[1] if ends[0] == at else ends[0]
        if at in line:
            return line
        line.add(at)
        fan = vertex_fan(complex_, at)
        if not fan.closed or len(fan.edges) != 4:
            return line
        edge = fan.edges[(fan.edges.index(edge) + 2) % 4]


def no_other_curve(setting: Setting, *, sectors: int = 1) -> Evidence:
    """Asymptotic lines from a vertex that meet the quadrant at one of its faces.

    sectors: how many neighbouring quadrants are taken together.
    """
    met = tried = 0
    for name, complex_ in samples(setting, simply_connected=True, random=6).items():
        for vertex in np.flatnonzero(~complex_.is_boundary).tolist():
            fan = vertex_fan(complex_, vertex)
            for place in range(len(fan.faces)):
                chosen = [fan.faces[(place + k) % len(fan.faces)] for k in range(sectors)]
                tried += 1
                try:
                    inside = set().union(*(_vertices(complex_, vertex, face) for face in chosen))
                except SurgeryError:
                    continue
                met += 1
                if witness := _curves(complex_, vertex, fan.edges, inside):
                    return statement(False, shown="", witness=f"{name}: {witness}")
    return Evidence(
        outcome="pass" if met else "undecided",
        grade="exact",
        residual="0",
        tried=tried,
        met=met,
        shown="of all the asymptotic lines from the vertex just one u- and one v-line meet the "
        "quadrant, along its two sides",
    )


def _vertices(complex_: AsymptoticComplex, vertex: int, face: int) -> set[int]:
    return set(complex_.faces[quadrant(complex_, vertex, face)].ravel().tolist())


def _curves(
    complex_: AsymptoticComplex, vertex: int, edges: tuple[int, ...], inside: set[int]
) -> str:
    """What is wrong with the lines from a vertex that meet a set of vertices; else empty."""
    meeting = [edge for edge in edges if len(_line(complex_, vertex, edge) & inside) > 1]
    families = sorted("u" if complex_.edge_is_u[edge] else "v" for edge in meeting)
    if families != ["u", "v"]:
        return f"lines of the families {' '.join(families)} from vertex {vertex} meet its sector"
    return ""


def _rays(m: int, rng: Random) -> list[tuple[int, int]]:
    """Random directions of the 2m rays of a star, counterclockwise, of gaps below a half turn."""
    while True:
        around = sorted(
            (Fraction(rng.randint(0, 399), 100) for _ in range(2 * m)),
        )
        rays = [_on_square(t) for t in around]
        gaps = zip(rays, rays[1:] + rays[:1], strict=True)
        if all(cross(one, other) > 0 for one, other in gaps):
            return rays


def _on_square(t: Fraction) -> tuple[int, int]:
    """Integer point of the square of half side 100, at t of its four sides."""
    side, along = int(t), int(200 * (t - int(t))) - 100
    return ((100, along), (-along, 100), (-100, -along), (along, -100))[side]


def normal_winds(
    setting: Setting, *, dual: str = "alternate", order: int = 1, add: int = 0
) -> Evidence:
    """Times that the images of the sectors wind around N(p), for stars and for graphs of Re z^m.

    From the Lelieuvre equations N_u = N x r_u and N_v = -N x r_v; dual: whether the sign of the
    second is kept; the winding claimed is order + add - m.
    """
    rng = setting.random()
    tried, most = 0, 0
    for m in _ORDERS:
        claimed = order + add - m
        for _ in range(8):
            rays = _rays(m, rng)
            signs = [1 if i % 2 == 0 or dual == "same" else -1 for i in range(2 * m)]
            images = [(-s * y, s * x) for s, (x, y) in zip(signs, rays, strict=True)]
            tried += 1
            if (found := winding(images)) != claimed:
                return statement(
                    False,
                    shown="",
                    witness=f"m_p = {m}, rays along {rays}: the images of the sectors wind "
                    f"{found} times around N(p), not {claimed}",
                )
            most = max(most, -found)
        if (found := winding(_gradients(m))) != claimed:
            return statement(
                False, shown="", witness=f"graph of Re z^{m}: the normal winds {found} times"
            )
    return Evidence(
        outcome="pass" if most > 1 else "fail",
        grade="exact",
        residual="0",
        tried=tried,
        met=tried,
        witness="" if most > 1 else "no image winds more than once",
        shown="the images of the 2 m_p sectors wind m_p - 1 times clockwise around N(p), their "
        "angles pi - alpha_i adding up to 2 pi (m_p - 1): several times where m_p > 2",
    )


def _gradients(m: int, *, size: int = 20) -> list[tuple[int, int]]:
    """Gradients of Re z^m, up to the factor m, on a closed path of Gaussian integers around 0."""
    steps = range(-size, size)
    path = [(size, y) for y in steps] + [(-x, size) for x in steps]
    path += [(-size, -y) for y in steps] + [(x, -size) for x in steps]
    gradients = []
    for x, y in path:
        a, b = 1, 0
        for _ in range(m - 1):
            a, b = a * x + b * y, b * x - a * y
        gradients.append((a, b))
    return gradients
