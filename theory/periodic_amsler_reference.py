"""Reference values of the periodic Amsler surfaces of a disk: 2m equal sectors about its centre.

Each sector has the angle phi0 = pi/m at the apex. Along its mirror line u = v = z/2 the length is
ds = cos(phi/2) dz, and on the disk of radius R the angle runs from phi0, on the edges, to the
angle phi_R where the mirror line leaves the disk. The largest curvature is
max(cot(phi0/2), tan(phi_R/2)); that phi is largest on the mirror line is taken for granted here.
"""

from typing import Any

from mpmath import mp

from theory.errors import DomainError, SingularEdgeError
from theory.painleve_segments import place_of_angle, place_of_path, rising
from theory.reference_precision import Magnified, Real, mpf_of, settled

MOST_DIGITS = 500
LARGEST_RADIUS = 50


def max_curvature(radius: Real, sectors: int | None = None, *, digits: int = 30) -> Any:
    """Largest curvature on the disk of the surface with this even number of sectors, or the best.

    0 < radius <= 50, sectors = 2m >= 4. Raises DomainError, SingularEdgeError where the disk
    reaches the singular edge, InsufficientPrecisionError.

    >>> print(mp.nstr(max_curvature(1, 6), 12), mp.nstr(mp.cot(mp.pi / 6), 12))
    1.73205080757 1.73205080757
    """
    if sectors is None:
        sectors = best_sectors(radius)
    half = _half(sectors)
    return settled(
        lambda: _curvature(_radius(radius), half), digits=digits, most_digits=MOST_DIGITS
    )


def rim_angle(radius: Real, sectors: int, *, digits: int = 30) -> Any:
    """Angle phi where the mirror line leaves the disk, in radians; arguments as above.

    >>> print(mp.nstr(rim_angle(1, 8), 12))
    1.01062380489
    """
    half = _half(sectors)

    def compute() -> tuple[Any, Any]:
        distance = _radius(radius)
        rim, rate = _rim(distance, mp.pi / half)
        return rim, 1 + rate * distance / rim

    return settled(compute, digits=digits, most_digits=MOST_DIGITS)


def best_sectors(radius: Real) -> int:
    """Even number of sectors with the least largest curvature on the disk of this radius.

    More sectors raise cot(phi0/2) and lower tan(phi_R/2): the best number is next to the real m
    where both are equal. Raises DomainError.

    >>> best_sectors(1)
    6
    """
    with mp.workdps(25 + int(_radius(radius))):
        r = _radius(radius)
        balanced = _balanced(r)
        lowest, highest = int(mp.floor(balanced - 0.001)), int(mp.ceil(balanced + 0.001))
        candidates = range(max(2, lowest), max(2, highest) + 1)
        return 2 * min(candidates, key=lambda m: _estimate(r, mp.pi / m))


def _radius(radius: Real) -> Any:
    found = mpf_of(radius)
    if not 0 < found <= LARGEST_RADIUS:
        raise DomainError(f"radius must lie in (0, {LARGEST_RADIUS}], not {mp.nstr(found, 15)}")
    return found


def _half(sectors: int) -> int:
    if isinstance(sectors, bool) or not isinstance(sectors, int) or sectors < 4 or sectors % 2:
        raise DomainError(f"sectors must be an even integer from 4 on, not {sectors!r}")
    return sectors // 2


def _rim(radius: Any, phi0: Any) -> tuple[Any, Any]:
    """Angle phi_R at distance R along the mirror line, and phi'/cos(phi/2) there: d phi_R/dR.

    mpf in and out. Raises SingularEdgeError where phi reaches pi before.
    """
    path = mp.zero
    for segment, end in rising(phi0):
        past = segment.angle(end) >= mp.pi
        if past:
            end = place_of_angle(segment, end, +mp.pi)
        total = path + segment.path(end)
        if total >= radius:
            z = place_of_path(segment, end, radius - path)
            return segment.angle(z), segment.slope(z) / mp.cos(segment.angle(z) / 2)
        if past:
            break
        path = total
    if radius - total < mp.ldexp(radius, 40 - mp.prec):
        raise Magnified
    raise SingularEdgeError(
        f"the disk of radius {mp.nstr(radius, 15)} reaches the singular edge, which lies "
        f"at distance {mp.nstr(total, 15)}"
    )


def _curvature(radius: Any, half: int) -> tuple[Any, Any]:
    phi0 = mp.pi / half
    rim, rate = _rim(radius, phi0)
    # tan(x/2) magnifies an absolute error of x by 1/sin x beside its own size.
    lost = (rim + rate * radius) / mp.sin(rim)
    return max(mp.cot(phi0 / 2), mp.tan(rim / 2)), max(lost, mp.one)


def _estimate(radius: Any, phi0: Any) -> Any:
    """Largest curvature to the precision in force; infinite where the edge is reached."""
    try:
        return max(mp.cot(phi0 / 2), mp.tan(_rim(radius, phi0)[0] / 2))
    except (SingularEdgeError, Magnified):
        return mp.inf


def _shortfall(radius: Any, log_angle: Any) -> Any:
    """R minus the distance along the mirror line at which phi = pi - phi0; it rises with phi0.

    Smooth, unlike phi_R + phi0 - pi, which is as steep as 1/phi0 next to the same zero.
    """
    phi0, path = mp.exp(log_angle), mp.zero
    level = mp.pi - phi0
    for segment, end in rising(phi0):
        if segment.angle(end) >= level:
            end = place_of_angle(segment, end, level)
            return radius - path - segment.path(end)
        path += segment.path(end)
    raise ArithmeticError("the angle never comes to pi - phi0")


def _balanced(radius: Any) -> Any:
    """Real m >= 2 at which cot(phi0/2) = tan(phi_R/2), that is phi_R = pi - phi0."""
    high = mp.log(mp.pi / 2) - mp.mpf(10) ** -12
    if _shortfall(radius, high) < 0:
        return mp.mpf(2)
    low = min(-radius, high - 1)
    while _shortfall(radius, low) > 0:
        low -= 1
    root = mp.findroot(
        lambda x: _shortfall(radius, x),
        (low, high),
        solver="anderson",
        tol=mp.exp(2 * low) * mp.mpf(10) ** -20,
        verify=False,
        maxsteps=200,
    )
    return mp.pi / mp.exp(root)
