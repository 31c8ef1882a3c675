"""Area in balls of the part of a hyperbolic rhombus that lies in a disk around the centre.

The decomposition of discrete.clipped_quads, with no case left to decide: an edge runs over t in
[t_a, t_b] from the foot of the perpendicular and is in the disk for |t| <= t_r. Both ends are moved
into [-t_r, t_r]; between the moved ends lies a triangle with the centre, from each end to where it
was moved a circular sector, signed. All that is continuous, so that a ball around a tie does no
harm.
"""

from dataclasses import dataclass
from typing import Any

from discrete.clipped_quads import Heights, slopes


def root(x: Any) -> Any:
    """Square root of a number that is known to be at least 0, though its ball may reach below."""
    if x > 0:
        return x.sqrt()
    upper = x.abs_upper().sqrt()
    return upper.union(-upper)


@dataclass(frozen=True, kw_only=True, eq=False)
class ClippingDisk:
    """Disk of a run and its edge length, by hyperbolic cosines and sines in balls."""

    rim: Any
    cosh_length: Any
    sinh_length: Any

    def clipped_area(self, s: Any, c: Any, heights: Heights) -> Any:
        """Area in the disk of a rhombus p, p1, p12, p2; s, c: sine and cosine of its angle at p."""
        ends = (*heights, heights[0])
        found = 0
        for n, slope in enumerate(slopes(self.cosh_length, self.sinh_length, s, c, heights)):
            found = found + self.edge_area(slope, ends[n], ends[n + 1])
        return found

    def edge_area(self, sinh_d: Any, a: Any, b: Any) -> Any:
        """Area in the disk of the triangle of the centre and an edge, signed like sinh d.

        sinh_d: distance of the edge from the centre; a, b: heights of its ends.
        """
        cosh_d = (1 + sinh_d * sinh_d).sqrt()
        scale = self.sinh_length * cosh_d
        t_a = ((b - a * self.cosh_length) / scale).asinh()
        t_b = ((b * self.cosh_length - a) / scale).asinh()
        t_r = 2 * root(((self.rim / cosh_d).max(1) - 1) / 2).asinh()
        low, high = (t if -t_r < t < t_r else t.max(-t_r).min(t_r) for t in (t_a, t_b))
        found = triangle_area(sinh_d, cosh_d, low, high)
        for t, moved, sign in ((t_a, low, 1), (t_b, high, -1)):
            if moved is not t:
                found = found + sign * (self.rim - 1) * seen_angle(sinh_d, t, moved)
        return found


def triangle_area(sinh_d: Any, cosh_d: Any, low: Any, high: Any) -> Any:
    """Area of the triangle of the centre and the piece of a geodesic from `low` to `high`."""
    sinh, cosh = (high - low).sinh_cosh()
    return 2 * (sinh_d * sinh / (1 + cosh_d * (low.cosh() + high.cosh()) + cosh)).atan()


def seen_angle(sinh_d: Any, start: Any, end: Any) -> Any:
    """Angle at the centre under which the piece of a geodesic is seen, signed like sinh d.

    Below a right angle: the piece lies on one side of the foot of the perpendicular.
    """
    along = sinh_d * sinh_d * start.cosh() * end.cosh() + start.sinh() * end.sinh()
    return (sinh_d * (end - start).sinh() / along).atan()
