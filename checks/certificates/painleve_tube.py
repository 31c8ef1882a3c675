r"""A family of solutions of PIII by an interval Taylor method in its integral form.

With K = z phi' the equation phi'' + phi'/z = sin phi gives, from a place a to a + h (eq:integral),

    K(a + h) = K(a) + integral of (a + t) sin phi dt,
    phi(a + h) = phi(a) + K(a) log(1 + h/a) + integral of (a + t) log((a + h)/(a + t)) sin phi dt,

both over 0 < t < h, with weights that are positive: nothing is subtracted, so that the balls of a
family grow no faster than the family itself. sin phi is replaced by its Taylor polynomial at a
with Lagrange's remainder over a box that Picard's iteration has shown to hold the family. This is
the checker's own rule; theory.painleve bounds remainders by Cauchy's estimate on complex disks.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import acb, arb, ctx, fmpq

ORDER = 4
TRIES = 12
REFINEMENTS = 3
START = Fraction(1, 8)
END = Fraction(20)
GUARD_BITS = 64


class NotEnclosedError(ArithmeticError):
    """Picard's iteration found no box: the step is too wide for the family."""


@dataclass(frozen=True, kw_only=True)
class Step:
    """Step from low to high = low + h: log(1 + h/low), and the integrals of t^k by both weights."""

    low: Any
    high: Any
    log: Any
    of_rate: tuple[Any, ...]
    of_angle: tuple[Any, ...]


@dataclass(frozen=True, kw_only=True)
class Stretch:
    """Family on low <= z <= high: boxes of phi, phi - phi(0) and (phi - phi(0))/x, x = z^2/4.

    phi, growth, rate: phi, phi - phi(0) and K = z phi' at high.
    """

    low: Any
    high: Any
    box: Any
    grown: Any
    rise: Any
    phi: Any
    growth: Any
    rate: Any


def rational(value: Fraction) -> Any:
    """Ball around a rational number."""
    return arb(fmpq(value.numerator, value.denominator))


def grid(width: Fraction) -> tuple[Step, ...]:
    """Steps of this width from 1/8 on, to 20: the same for every family."""
    with ctx.workprec(ctx.prec + GUARD_BITS):
        count = int((END - START) / width)
        return tuple(_step(START + k * width, width) for k in range(count))


def _step(low: Fraction, width: Fraction) -> Step:
    a, h = rational(low), rational(width)

    def weight(k: int) -> Any:
        return acb.integral(
            lambda t, _: (a + t) * ((a + h) / (a + t)).log() * t**k, acb(0), acb(h)
        ).real

    orders = range(ORDER + 1)
    return Step(
        low=a,
        high=rational(low + width),
        log=(1 + h / a).log(),
        of_rate=tuple(a * h ** (k + 1) / (k + 1) + h ** (k + 2) / (k + 2) for k in orders),
        of_angle=tuple(weight(k) for k in orders),
    )


def tube(phi0: Any, steps: Sequence[Step]) -> Iterator[Stretch]:
    """Stretches for every phi(0) of the ball phi0: [0, 1/8], then one for each step.

    Raises NotEnclosedError.
    """
    current = _first(phi0)
    yield current
    for step in steps:
        current = _next(current, step)
        yield current


def _first(phi0: Any) -> Stretch:
    """Stretch at the origin: phi = F(x), x = z^2/4, (x F')' = sin F = G, K = 2 x F'.

    F' = integral of G(x t) dt and F'' = integral of t G'(x t) dt over 0 < t < 1.
    """
    x = rational(START) ** 2 / 4
    way = arb(0).union(x)
    box = phi0 * (1 + 2 * (-x).union(x))
    if phi0 + way * box.sin() not in box:
        raise NotEnclosedError("no box at the origin")
    for _ in range(REFINEMENTS):
        box = phi0 + way * box.sin()
    bend = box.cos() * box.sin() / 2
    growth = x * (phi0.sin() + x / 2 * bend)
    return Stretch(
        low=arb(0),
        high=rational(START),
        box=box,
        grown=way * box.sin(),
        rise=box.sin(),
        phi=phi0 + growth,
        growth=growth,
        rate=2 * x * (phi0.sin() + x * bend),
    )


def _next(last: Stretch, step: Step) -> Stretch:
    box, rates = _picard(last, step)
    sines = _sines(last.phi, last.rate, step.low, ORDER)
    sines.append(_sines(box, rates, step.low.union(step.high), ORDER + 1)[ORDER])
    by_rate = sum((s * w for s, w in zip(sines, step.of_rate, strict=True)), arb(0))
    by_angle = sum((s * w for s, w in zip(sines, step.of_angle, strict=True)), arb(0))
    increment = last.rate * step.log + by_angle
    grown = last.growth + arb(0).union(step.log) * rates
    return Stretch(
        low=step.low,
        high=step.high,
        box=box,
        grown=grown,
        rise=_rise(last, step, box, grown),
        phi=last.phi + increment,
        growth=last.growth + increment,
        rate=last.rate + by_rate,
    )


def _rise(last: Stretch, step: Step, box: Any, grown: Any) -> Any:
    """Box of (phi - phi(0))/x on the step, the smaller of two.

    F' is a mean of F' at low and of sin F on the step; so is the rise, of itself at low and of F'.
    """
    x = step.low**2 / 4
    as_mean = (last.growth / x).union(last.rate / (2 * x)).union(box.sin())
    as_quotient = grown / x.union(step.high**2 / 4)
    return as_mean if as_mean.rad() < as_quotient.rad() else as_quotient


def _picard(last: Stretch, step: Step) -> tuple[Any, Any]:
    """Boxes of phi and K on the step that Picard's operator maps into themselves."""
    clock, weight = arb(0).union(step.log), arb(0).union(step.of_rate[0])
    box, rates = last.phi, last.rate
    for _ in range(TRIES):
        new_box, new_rates = last.phi + clock * rates, last.rate + weight * box.sin()
        if new_box in box and new_rates in rates:
            return new_box, new_rates
        box, rates = _wider(box.union(new_box)), _wider(rates.union(new_rates))
    raise NotEnclosedError("Picard's iteration does not close")


def _wider(ball: Any) -> Any:
    return arb(ball.mid(), (ball.rad() * rational(Fraction(101, 100))).upper())


def _sines(phi: Any, rate: Any, z: Any, order: int) -> list[Any]:
    """Taylor coefficients s_0, ..., s_(order - 1) of sin phi at z, where z phi' = rate.

    From (z phi')' = z sin phi: (k + 1) K_(k+1) = z s_k + s_(k-1), and those of phi by
    z (k + 1) a_(k+1) = K_k - k a_k.
    """
    sine, cosine = phi.sin_cos()
    sines, cosines, weighted = [sine], [cosine], []
    a, rates = phi, rate
    for k in range(order - 1):
        a = (rates - k * a) / (z * (k + 1)) if k else rates / z
        weighted.append((k + 1) * a)
        with_c = sum((w * c for w, c in zip(weighted, reversed(cosines), strict=True)), arb(0))
        with_s = sum((w * s for w, s in zip(weighted, reversed(sines), strict=True)), arb(0))
        rates = (z * sines[k] + (sines[k - 1] if k else 0)) / (k + 1)
        sines.append(with_c / (k + 1))
        cosines.append(-with_s / (k + 1))
    return sines
