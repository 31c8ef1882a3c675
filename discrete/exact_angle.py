"""Angles a + b pi with rational a and b: the parameters of the greedy algorithm are such."""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from discrete.errors import AngleError

#: Bits up to which the sign of a + b pi is searched; it is decided as soon as they outdo a and b.
MOST_BITS = 1 << 14


@dataclass(frozen=True, kw_only=True)
class ExactAngle:
    """The number radians + half_turns * pi, in radians; both parts are rational."""

    radians: Fraction = Fraction(0)
    half_turns: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        for name in ("radians", "half_turns"):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | Fraction):
                raise AngleError(f"{name} = {value!r}: give an integer or a Fraction, no float")
            object.__setattr__(self, name, Fraction(value))

    def __float__(self) -> float:
        if self.radians == 0:
            return float(self.half_turns) * math.pi
        from flint import ctx

        with ctx.workprec(128):
            return float(self.ball())

    def __sub__(self, other: "ExactAngle") -> "ExactAngle":
        return ExactAngle(
            radians=self.radians - other.radians, half_turns=self.half_turns - other.half_turns
        )

    def ball(self) -> Any:
        """Ball of flint around the angle, at the precision in force."""
        from flint import arb, fmpq

        radians, half_turns = (
            fmpq(part.numerator, part.denominator) for part in (self.radians, self.half_turns)
        )
        return arb(radians) + arb.pi() * arb(half_turns)

    def sign(self) -> int:
        """-1, 0 or 1: pi is irrational, so that the sum is 0 only where both parts are.

        Raises AngleError where MOST_BITS bits do not tell it from 0.
        """
        if self.half_turns == 0 or self.radians * self.half_turns > 0:
            leading = self.half_turns or self.radians
            return (leading > 0) - (leading < 0)
        from flint import ctx

        bits = 64
        while bits <= MOST_BITS:
            with ctx.workprec(bits):
                ball = self.ball()
            if ball > 0:
                return 1
            if ball < 0:
                return -1
            bits *= 2
        raise AngleError(f"{self} cannot be told from 0 with {MOST_BITS} bits")

    def __str__(self) -> str:
        if self.half_turns == 0:
            return str(self.radians)
        turns = self.half_turns
        top = "pi" if abs(turns.numerator) == 1 else f"{abs(turns.numerator)}*pi"
        text = f"{'-' if turns < 0 else ''}{top}"
        if turns.denominator != 1:
            text += f"/{turns.denominator}"
        return text if self.radians == 0 else f"{self.radians} + {text}"
