r"""The angle of a branched surface on an m-star, for every surface there is.

Rays 0, ..., 2m - 1 leave the branch point p counter-clockwise, those of even number u-curves;
sector j lies between the rays j and j + 1, its coordinates (s, t) the lengths along them. With
sigma_j = (-1)^j the sine-Gordon equation phi_st = sigma_j sin phi integrates to

    phi(s, t) = phi_j + H_j(s) + H_(j+1)(t) + sigma_j W_j(s, t),

H_k(0) = 0, W_j the area of [0, s] x [0, t]. That H_k, the increment of phi along ray k, is the same
from both sides is the geodesic curvature of the ray; matched=False drops it.
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp

Corner = tuple[int, Any, Any]
"""Sector j and the coordinates s, t in it."""


@dataclass(frozen=True, kw_only=True)
class StarField:
    """Unknown surface over an m-star.

    order: m; turns: the angles at p add up to 2 pi turns; alternating: whether sigma changes from
    sector to sector; matched: whether both sides of a ray agree on its geodesic curvature.
    """

    order: int
    turns: Any = 1
    alternating: bool = True
    matched: bool = True

    @property
    def size(self) -> int:
        """Number of sectors, and of rays."""
        return 2 * self.order

    def sector_angle(self, j: int) -> Any:
        """Angle at p between the rays that bound sector j; the last one makes up the sum."""
        known = sp.symbols(f"alpha_0:{self.size - 1}", positive=True)
        return known[j] if j < self.size - 1 else 2 * sp.pi * self.turns - sum(known)

    def sigma(self, j: int) -> int:
        """Sign of the orientation of (r_u, r_v), both leaving p, in sector j."""
        return 1 if j % 2 == 0 or not self.alternating else -1

    def centre(self, j: int) -> Any:
        """Angle phi in (0, pi) at p from sector j: cos phi = sigma r_u . r_v."""
        alpha = self.sector_angle(j)
        return alpha if self.sigma(j) == 1 else sp.pi - alpha

    def angle(self, corner: Corner) -> Any:
        """Angle phi at a point of a closed sector, the limit from within it."""
        j, s, t = corner
        along = self._increment(j, s, side=1) + self._increment((j + 1) % self.size, t, side=-1)
        return self.centre(j) + along + self.sigma(j) * self.area_from_p(j, s, t)

    def area_from_p(self, j: int, s: Any, t: Any) -> Any:
        """Area of [0, s] x [0, t] in sector j."""
        if s == 0 or t == 0:
            return sp.Integer(0)
        return sp.Function(f"W_{j}", positive=True)(s, t)

    def area(self, j: int, first: tuple[Any, Any], second: tuple[Any, Any]) -> Any:
        """Area of a rectangle of sector j: the ends of its ranges of s and of t."""
        (a, b), (c, d) = first, second
        w = self.area_from_p
        return w(j, b, d) - w(j, a, d) - w(j, b, c) + w(j, a, c)

    def _increment(self, ray: int, place: Any, *, side: int) -> Any:
        if place == 0:
            return sp.Integer(0)
        name = f"H_{ray}" if self.matched or side == 1 else f"K_{ray}"
        return sp.Function(name, real=True)(place)

    def family(self, ray: int) -> str:
        """Family of a ray and of the lines that run along it in its two sectors."""
        return "uv"[ray % 2]

    def arc_family(self, start: Corner, end: Corner) -> str:
        """Family of the asymptotic arc between two neighbouring corners of a polygon.

        In one sector that of the coordinate that changes; from sector k - 1 to sector k the arc
        crosses ray k and is of the other family. Raises ValueError if no arc joins them.
        """
        (j, s, t), (k, x, y) = start, end
        if j == k and (s == x) != (t == y):
            return self.family(j if t == y else j + 1)
        if k == (j + 1) % self.size and t == x:
            return self.family(k + 1)
        if j == (k + 1) % self.size and s == y:
            return self.family(j + 1)
        raise ValueError(f"no asymptotic arc joins {start} and {end}")

    def alternating_sum(self, polygon: list[Corner], *, last: str = "") -> Any:
        """Sum of phi over the corners in order, + where a u-arc begins and - where one ends.

        last: family of the arc from the last corner to the first, if it passes through p.
        """
        return sum(
            (1 if family == "u" else -1) * self.angle(corner)
            for corner, family in zip(polygon, self.arc_families(polygon, last=last), strict=True)
        )

    def arc_families(self, polygon: list[Corner], *, last: str = "") -> list[str]:
        """Families of the arcs that leave the corners of a polygon."""
        pairs = list(zip(polygon, polygon[1:] + polygon[:1], strict=True))
        found = [self.arc_family(*pair) for pair in (pairs[:-1] if last else pairs)]
        return [*found, last] if last else found

    def star(self, lengths: list[Any]) -> list[Corner]:
        """Boundary of the star whose ray k has the length lengths[k], counter-clockwise."""
        return [(j, lengths[j], lengths[(j + 1) % self.size]) for j in range(self.size)]

    def star_area(self, lengths: list[Any]) -> Any:
        """Area of that star."""
        return sum(self.area_from_p(*corner) for corner in self.star(lengths))

    def fan(self, count: int, lengths: list[Any]) -> list[Corner]:
        """Boundary of the first count sectors, p excepted, from the end of ray 0 to ray count."""
        outer = self.star(lengths)[:count]
        return [(0, lengths[0], 0), *outer, (count - 1, 0, lengths[count])]

    def strip(self, ray: int, ends: tuple[Any, Any], width: Any) -> list[Corner]:
        """Thin rectangle about ray k: the corners q-, r-, r+, q+, counter-clockwise.

        ends: the distances from p of the q's and of the r's; width: on either side of the ray.
        """
        near, far = ends
        before = (ray - 1) % self.size
        return [
            (before, width, near),
            (before, width, far),
            (ray, far, width),
            (ray, near, width),
        ]

    def strip_area(self, ray: int, ends: tuple[Any, Any], width: Any) -> Any:
        """Area of that thin rectangle."""
        left = self.area(ray, ends, (0, width))
        return left + self.area((ray - 1) % self.size, (0, width), ends)

    def rectangle(self, j: int, first: tuple[Any, Any], second: tuple[Any, Any]) -> list[Corner]:
        """Boundary of a rectangle of sector j, counter-clockwise on the surface."""
        (a, b), (c, d) = first, second
        return [(j, a, c), (j, b, c), (j, b, d), (j, a, d)]


def lengths(order: int) -> list[Any]:
    """Unknown lengths of the rays of an m-star."""
    return list(sp.symbols(f"l_0:{2 * order}", positive=True))
