"""Area of the part of a hyperbolic quad that lies in a disk around the centre, from heights alone.

The height h of a point is the hyperbolic cosine of its distance from the centre. On a geodesic at
the signed distance d from the centre h is cosh d cosh t. The part of a triangle (centre, a, b) in
the disk is a triangle over the piece of the edge inside, and circular sectors over the pieces
outside; signed by the side on which the centre lies, these parts add up over the boundary of a quad
to its own part (the rule for Euclidean polygons and circles, carried over).
"""

import math

Heights = tuple[float, float, float, float]


def slopes(cosh_l: float, sinh_l: float, s: float, c: float, heights: Heights) -> Heights:
    """Distances sinh d of the edges of a rhombus p, p1, p12, p2 from the centre.

    Positive where the centre lies on its side. cosh_l, sinh_l: of the edge length; s, c: sine and
    cosine of the angle at p and p12; heights: of p, p1, p12, p2. At a vertex the derivatives of h
    along two edges give the one across each.
    """
    h, h1, h12, h2 = heights
    along, beside = (h1 - h * cosh_l) / sinh_l, (h2 - h * cosh_l) / sinh_l
    back, down = (h2 - h12 * cosh_l) / sinh_l, (h1 - h12 * cosh_l) / sinh_l
    return (
        (along * c - beside) / s,
        (down * c - back) / s,
        (back * c - down) / s,
        (beside * c - along) / s,
    )


def triangle_area(
    sinh_d: float, cosh_a: float, cosh_b: float, cosh_l: float, sinh_l: float
) -> float:
    """Area of the triangle (centre, a, b), signed like sinh d, from its angle sum."""
    return 2 * math.atan2(sinh_d * sinh_l, 1 + cosh_a + cosh_b + cosh_l)


def edge_area(
    cosh_l: float, sinh_l: float, cosh_r: float, sinh_d: float, cosh_a: float, cosh_b: float
) -> float:
    """Area of the part of the triangle (centre, a, b) in the disk, signed like sinh d.

    cosh_l, sinh_l: of the edge from a to b, cosh_a, cosh_b: heights of its ends. It runs over t in
    [t_a, t_b] from the foot of the perpendicular, and is inside for |t| <= t_r.
    """
    cosh_d = math.sqrt(1 + sinh_d * sinh_d)
    t_b = math.asinh((cosh_b * cosh_l - cosh_a) / (sinh_l * cosh_d))
    t_a = math.asinh((cosh_b - cosh_a * cosh_l) / (sinh_l * cosh_d))
    t_r = math.acosh(cosh_r / cosh_d) if cosh_r > cosh_d else 0.0
    lower, upper = max(t_a, -t_r), min(t_b, t_r)
    found = 0.0
    if upper > lower:
        low, high, step = math.cosh(lower), math.cosh(upper), upper - lower
        found = triangle_area(sinh_d, cosh_d * low, cosh_d * high, math.cosh(step), math.sinh(step))
    if t_a < -t_r:
        found += (cosh_r - 1) * seen_angle(sinh_d, t_a, min(-t_r, t_b))
    if t_b > t_r:
        found += (cosh_r - 1) * seen_angle(sinh_d, max(t_r, t_a), t_b)
    return found


def seen_angle(sinh_d: float, t: float, to: float) -> float:
    """Angle at the centre under which the piece from t to `to` is seen, signed like sinh d."""
    return math.atan2(
        sinh_d * math.sinh(to - t),
        sinh_d * sinh_d * math.cosh(t) * math.cosh(to) + math.sinh(t) * math.sinh(to),
    )


def clipped_area(
    cosh_l: float, sinh_l: float, cosh_r: float, s: float, c: float, heights: Heights
) -> float:
    """Area of the part of a rhombus in the disk of radius r; see `slopes` for the arguments."""
    h, h1, h12, h2 = heights
    first, second, third, fourth = slopes(cosh_l, sinh_l, s, c, heights)
    return (
        edge_area(cosh_l, sinh_l, cosh_r, first, h, h1)
        + edge_area(cosh_l, sinh_l, cosh_r, second, h1, h12)
        + edge_area(cosh_l, sinh_l, cosh_r, third, h12, h2)
        + edge_area(cosh_l, sinh_l, cosh_r, fourth, h2, h)
    )
