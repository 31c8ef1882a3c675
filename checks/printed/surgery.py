"""Section 3.4, surgery: the domains, the attaching maps and the data of lemma (lem:surgery)."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from theory.glued_rectangles import Place, Point, Segment
from theory.vectors import Vector, added, cross, dot, scaled


@dataclass(frozen=True, kw_only=True)
class Sizes:
    """Lengths of the lemma: u*, v*, u_max, v_max and the tilded u, v of the new rays."""

    u: Fraction
    v: Fraction
    u_max: Fraction
    v_max: Fraction
    u_new: Fraction
    v_new: Fraction


def new_domains(s: Sizes) -> dict[str, Point]:
    """Far corners of Omega_1, Omega_2, Omega_3, whose near corners are (0, 0)."""
    return {
        "Omega_1": (s.u_max - s.u, s.v_new),
        "Omega_2": (s.u_new, s.v_new),
        "Omega_3": (s.u_new, s.v_max - s.v),
    }


def in_star_domain(s: Sizes, point: Point, *, closed: bool = True) -> bool:
    """Whether a point is in Omega^*; closed: whether the quadrant taken away keeps its edges."""
    (u, v), inside = point, 0 <= point[0] <= s.u_max and 0 <= point[1] <= s.v_max
    cut = (u >= s.u and v >= s.v) if closed else (u > s.u and v > s.v)
    return inside and not cut


def attaching_maps(
    s: Sizes, *, second: int = 2, fourth: int = 3, shifts: str = "u,v", reverse: bool = False
) -> dict[str, tuple[str, str, Callable[[Fraction], Place]]]:
    """Maps chi_1 to chi_4 of (eq:attaching): the source, its axis, the image of a point on it.

    second, fourth: number of the rectangle in which chi_2 and chi_4 land; shifts: the axes whose
    maps into Omega^* add (u*, v*); reverse: whether chi_1 runs backwards.
    """
    u0, v0 = s.u if "u" in shifts else Fraction(0), s.v if "v" in shifts else Fraction(0)
    far = s.u_max
    return {
        "chi_1": ("Omega_1", "u", lambda t: ("Omega*", (far - t if reverse else u0 + t, s.v))),
        "chi_2": ("Omega_3", "u", lambda t: (f"Omega_{second}", (t, Fraction(0)))),
        "chi_3": ("Omega_3", "v", lambda t: ("Omega*", (s.u, v0 + t))),
        "chi_4": ("Omega_1", "v", lambda t: (f"Omega_{fourth}", (Fraction(0), t))),
    }


def attachments(s: Sizes, **changes: Any) -> dict[str, tuple[Segment, Segment]]:
    """Segment on which each attaching map is defined, and the segment between its values."""
    found = {}
    for name, (domain, axis, chi) in attaching_maps(s, **changes).items():
        width, height = new_domains(s)[domain]
        zero = Fraction(0)
        end = (width, zero) if axis == "u" else (zero, height)
        source = ((domain, (zero, zero)), (domain, end))
        found[name] = (source, (chi(zero), chi(width if axis == "u" else height)))
    return found


def trisecting(t_u: Vector, t_v: Vector, *, weight: Any = 2) -> tuple[Vector, Vector]:
    """Vectors whose directions are e_u and e_v of the middle sector, before normalisation."""
    return added(scaled(weight, t_v), t_u), added(scaled(weight, t_u), t_v)


def normalised(a: Vector, length: Callable[[Any], Any], *, by: int = 1) -> Vector:
    """Vector divided by its norm to the power by; length: square root."""
    return scaled(1 / length(dot(a, a)) ** by, a)


def straight_normal_v(cosine: Any, sine: Any, n: Vector, e_v: Vector, *, sign: int = -1) -> Vector:
    """Normal along the edge u = 0 of the middle sector, from cos v and sin v."""
    return added(scaled(cosine, n), scaled(sign * sine, cross(n, e_v)))


def straight_normal_u(cosine: Any, sine: Any, n: Vector, e_u: Vector, *, sign: int = 1) -> Vector:
    """Normal along the edge v = 0 of an Amsler sector, (amsler-frame)."""
    return added(scaled(cosine, n), scaled(sign * sine, cross(n, e_u)))
