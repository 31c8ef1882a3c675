"""Translation nets r = A(u) + B(v), N = i (A - B), with A and B broken lines: disks in them.

They are the pseudospherical surfaces in the limit of small size. A broken line of n sides has n
directions; the first and the last side go on for ever, and the lines begin and end at two points
whose normals differ by a given vector. Cell (i, j) is a parallelogram of angle phi = b_j - a_i. A
disk in the plane lifts to the net as far as it meets no cell with phi outside of (0, pi).
"""

import numba
import numpy as np

FAR = 1e5
LARGEST_LOG = 5.0


@numba.njit(cache=False)
def chord(directions: np.ndarray, lengths: np.ndarray) -> complex:
    """Vector from the start to the end of a broken line, as a complex number."""
    total: complex = np.sum(lengths * np.exp(1j * directions))
    return total


@numba.njit(cache=False)
def extended(directions: np.ndarray, lengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Directions of all sides with both rays, and the nodes, of which the second is 0."""
    n = len(directions)
    sides = np.empty(n + 2)
    sides[1:-1] = directions
    sides[0], sides[-1] = directions[0], directions[-1]
    nodes = np.zeros(n + 3, np.complex128)
    nodes[0] = -FAR * np.exp(1j * sides[0])
    for i in range(n):
        nodes[i + 2] = nodes[i + 1] + lengths[i] * np.exp(1j * directions[i])
    nodes[n + 2] = nodes[n + 1] + FAR * np.exp(1j * sides[-1])
    return sides, nodes


@numba.njit(cache=False)
def from_segment(point: complex, start: complex, end: complex) -> float:
    """Distance of a point from a segment."""
    side = end - start
    size = abs(side)
    if size == 0.0:
        away: float = abs(point - start)
        return away
    share = ((point - start) * np.conj(side)).real / size**2
    distance: float = abs(point - start - min(max(share, 0.0), 1.0) * side)
    return distance


@numba.njit(cache=False)
def cell_towards(a: float, b: float, to: complex, last: int, end: bool) -> int:
    """Index of the side at an end of A on which one starts in the direction `to` (0 if none)."""
    forward = np.imag(to * np.exp(-1j * b)) / np.sin(a - b)
    if end:
        return last if forward > 0 else last - 1
    return 1 if forward > 0 else 0


@numba.njit(cache=False)
def reached(
    a: np.ndarray, nodes_a: np.ndarray, b: np.ndarray, nodes_b: np.ndarray, centre: complex,
    i0: int, j0: int,
) -> np.ndarray:  # fmt: skip
    """Radius about the centre at which a disk lifted from cell (i0, j0) first meets each cell."""
    n, m = len(a), len(b)
    radius = np.full((n, m), np.inf)
    done = np.zeros((n, m), np.bool_)
    radius[i0, j0] = 0.0
    for _ in range(n * m):
        least, i, j = np.inf, -1, -1
        for p in range(n):
            for q in range(m):
                if not done[p, q] and radius[p, q] < least:
                    least, i, j = radius[p, q], p, q
        if i < 0:
            break
        done[i, j] = True
        if not 0.0 < b[j] - a[i] < np.pi:
            continue
        for p, q in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
            if not (0 <= p < n and 0 <= q < m):
                continue
            near = nodes_a[max(i, p)] + nodes_b[max(j, q)]
            far = nodes_a[min(i, p) + 1] + nodes_b[min(j, q) + 1]
            r = max(least, from_segment(centre, near, far))
            radius[p, q] = min(radius[p, q], r)
    return radius


@numba.njit(cache=False)
def inscribed(
    a: np.ndarray, la: np.ndarray, b: np.ndarray, lb: np.ndarray, gap: complex,
    offset: float, pull: float,
) -> tuple[np.ndarray, np.ndarray, float, float, bool]:  # fmt: skip
    """Angle and radius of first meeting of each cell, radius and distance of the two points.

    gap: chord of A minus chord of B, per chord of A; offset: distance of the centre from their
    midpoint, across, per distance; pull: 0 there, 1 at the first point. False where void.
    """
    nothing = (np.zeros((1, 1)), np.zeros((1, 1)), np.inf, np.inf, False)
    first, second = chord(a, la), chord(b, lb)
    if abs(first) < 1e-3 or abs(second) < 1e-3:
        return nothing
    ratio = first * (1 - gap) / second
    turn = np.angle(ratio)
    turn -= 2 * np.pi * np.round((b[0] + turn - a[0] - np.pi / 2) / (2 * np.pi))
    sides_a, nodes_a = extended(a, la)
    sides_b, nodes_b = extended(b + turn, lb * abs(ratio))
    between = first * (2 - gap)
    apart = abs(between)
    centre = (1 - pull) * (between / 2 + 1j * offset * between)
    radius = max(abs(centre), abs(between - centre))
    last_a, last_b = len(sides_a) - 1, len(sides_b) - 1
    towards = between if pull > 0.999 else centre
    if abs(np.sin(sides_a[0] - sides_b[0])) < 1e-9 or abs(np.sin(sides_a[-1] - sides_b[-1])) < 1e-9:
        return nothing
    i0 = cell_towards(sides_a[0], sides_b[0], towards, last_a, False)
    j0 = cell_towards(sides_b[0], sides_a[0], towards, last_b, False)
    back = centre - between
    i1 = cell_towards(sides_a[-1], sides_b[-1], back, last_a, True)
    j1 = cell_towards(sides_b[-1], sides_a[-1], back, last_b, True)
    first_met = reached(sides_a, nodes_a, sides_b, nodes_b, centre, i0, j0)
    met = first_met[i1, j1] <= radius * (1 + 1e-9)
    angles = np.empty((len(sides_a), len(sides_b)))
    for i in range(len(sides_a)):
        for j in range(len(sides_b)):
            phi = sides_b[j] - sides_a[i]
            angles[i, j] = min(phi, np.pi - phi)
    return angles, first_met, radius, apart, met


@numba.njit(cache=False)
def least_angle(angles: np.ndarray, met: np.ndarray, radius: float) -> float:
    """Least of phi and pi - phi over the cells that a disk of this radius meets."""
    least = np.pi
    for i in range(angles.shape[0]):
        for j in range(angles.shape[1]):
            if met[i, j] < radius:
                least = min(least, angles[i, j])
    return least


@numba.njit(cache=False)
def free_radius(angles: np.ndarray, met: np.ndarray, phi0: float) -> float:
    """Radius up to which a disk meets only cells with phi0 <= phi <= pi - phi0."""
    free = FAR / 4
    for i in range(angles.shape[0]):
        for j in range(angles.shape[1]):
            if angles[i, j] < phi0:
                free = min(free, met[i, j])
    return free


def split(point: np.ndarray, sides: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Directions and lengths of A and of B from the first 4 * sides coordinates."""
    parts = np.reshape(point[: 4 * sides], (4, sides))
    return parts[0], np.exp(parts[1]), parts[2], np.exp(parts[3])


def bounds(sides: int) -> tuple[tuple[float, float], ...]:
    """Ranges of the directions and of the logarithms of the lengths."""
    turn, size = ((-3.2, 3.2),) * sides, ((-LARGEST_LOG, LARGEST_LOG),) * sides
    return turn + size + turn + size


def folded_corner(steepness: float) -> tuple[float, ...]:
    """Coordinates of the net around a folded corner with tan(theta) = steepness, three sides."""
    theta = float(np.arctan(steepness))
    gamma, short = 3 * theta - float(np.pi), -4.0
    arm = float(np.log(np.sin(theta) / np.sin(gamma)))
    level = theta - float(np.pi) / 2
    a, la = (-theta, gamma, level), (0.0, arm, short)
    b, lb = (-level, -gamma, theta), (short, arm, 0.0)
    return (*a, *la, *b, *lb)
