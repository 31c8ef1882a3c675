"""Taylor series of the regular solution of phi'' + phi'/z = sin phi (PIII), in mpmath.

At the singular origin phi is a power series in x = z^2/4, where x F'' + F' = sin F; elsewhere it is
one in h = z - start. This is the reference route: nothing here is proved, and nothing here is
shared with the ball arithmetic of the certified one.

A series in a variable t of order 1 is kept as integers, the coefficients times 2^bits: sums of
products of Python's integers are many times faster than those of mpmath's numbers.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from operator import mul
from typing import Any

from mpmath import mp


@dataclass(frozen=True, kw_only=True)
class Segment:
    """Taylor polynomial of phi on start <= z <= end, in t = z^2/(4 unit) or (z - start)/unit.

    The first where start is 0. coefficients: times 2^bits; start, end and unit: mpf.
    """

    start: Any
    end: Any
    unit: Any
    bits: int
    coefficients: Sequence[int]

    def _local(self, z: Any) -> tuple[Any, Any]:
        """Variable t at z, and its derivative by z."""
        if self.start == 0:
            return z**2 / (4 * self.unit), z / (2 * self.unit)
        return (z - self.start) / self.unit, 1 / self.unit

    def _sum(self, coefficients: Iterable[int], t: Any) -> Any:
        total, fixed = 0, fix(t, self.bits)
        for coefficient in reversed(list(coefficients)):
            total = (total * fixed >> self.bits) + coefficient
        return mp.ldexp(total, -self.bits)

    def angle(self, z: Any) -> Any:
        """Angle phi(z)."""
        return self._sum(self.coefficients, self._local(z)[0])

    def slope(self, z: Any) -> Any:
        """Slope phi'(z)."""
        t, rate = self._local(z)
        return rate * self._sum((k * c for k, c in enumerate(self.coefficients) if k), t)

    def bend(self, z: Any) -> Any:
        """Second derivative phi''(z), for z > 0, by the equation."""
        return mp.sin(self.angle(z)) - self.slope(z) / z

    def path(self, z: Any) -> Any:
        """Integral of cos(phi/2) from start to z, term by term."""
        sine = SineSeries(self.angle(self.start) / 2, self.bits)
        for coefficient in self.coefficients[1:]:
            sine.grow(coefficient // 2)
        # At the origin the terms t^k dz integrate to z t^k / (2 k + 1), else to h t^k / (k + 1).
        stride = 2 if self.start == 0 else 1
        terms = (c // (stride * k + 1) for k, c in enumerate(sine.cosine))
        return (z - self.start) * self._sum(terms, self._local(z)[0])


def fix(x: Any, bits: int) -> int:
    """Integer part of 2^bits x."""
    return int(mp.floor(mp.ldexp(x, bits)))


class SineSeries:
    """Series of sin a(t) and cos a(t), grown by one as each coefficient of a becomes known."""

    def __init__(self, constant: Any, bits: int) -> None:
        self.bits = bits
        self.sine = [fix(mp.sin(constant), bits)]
        self.cosine = [fix(mp.cos(constant), bits)]
        self._weighted: list[int] = []

    def grow(self, coefficient: int) -> None:
        """Take the next coefficient of a: k s_k and -k c_k are sums of j a_j times c and s."""
        k = len(self.sine)
        self._weighted.append(k * coefficient)
        sine = sum(map(mul, self._weighted, reversed(self.cosine)))
        cosine = -sum(map(mul, self._weighted, reversed(self.sine)))
        self.sine.append((sine >> self.bits) // k)
        self.cosine.append((cosine >> self.bits) // k)


def _order() -> int:
    """Order of least total work at the precision in force: half the natural logarithm of 1/eps."""
    return int(mp.prec * 0.35) + 6


def _bits(angle: Any) -> int:
    """Bits after the point that keep the angle to the precision in force, and some to spare."""
    return int(mp.prec - mp.floor(mp.log(angle, 2))) + 24


def _reach(coefficients: Sequence[int], angle: Any, bits: int) -> Any:
    """Largest t <= 1 at which the last terms fall below the precision, relative to the angle."""
    small = mp.ldexp(angle, bits - mp.prec)
    last = [(k, abs(c)) for k, c in enumerate(coefficients)][-4:]
    return min([mp.one, *((small / c) ** (mp.one / k) for k, c in last if c)])


def origin(phi0: Any, end: Any) -> Segment:
    """Segment from the origin, ending at end or before: (k + 1)^2 f_{k+1} is the kth of sin F."""
    bits = _bits(phi0)
    sine = SineSeries(phi0, bits)
    f = [fix(phi0, bits)]
    for k in range(1, _order() + 1):
        f.append(sine.sine[-1] // k**2)
        sine.grow(f[-1])
    furthest = 2 * mp.sqrt(_reach(f, phi0, bits))
    return Segment(start=mp.zero, end=min(end, furthest), unit=mp.one, bits=bits, coefficients=f)


def step(start: Any, angle: Any, slope: Any, end: Any, *, longest: Any) -> Segment:
    """Segment from start > 0 with the angle and slope there, ending at end or before.

    From (start + h) phi'' + phi' = (start + h) sin phi, coefficient by coefficient in t = h/unit.
    longest: bound on the step, for what was learnt from the segment before.
    """
    # Rounding excites the solution that is singular at 0, so that half the way there is the limit.
    bits, unit = _bits(angle), min(longest, start / 2)
    ratio, square = fix(unit / start, bits), fix(unit**2, bits)
    sine = SineSeries(angle, bits)
    a = [fix(angle, bits), fix(slope * unit, bits)]
    for k in range(_order() - 1):
        before = ratio * sine.sine[k - 1] >> bits if k else 0
        top = square * (sine.sine[k] + before) - (k + 1) ** 2 * ratio * a[k + 1]
        a.append((top >> bits) // ((k + 2) * (k + 1)))
        sine.grow(a[k + 1])
    furthest = start + unit * _reach(a, angle, bits)
    return Segment(start=start, end=min(end, furthest), unit=unit, bits=bits, coefficients=a)
