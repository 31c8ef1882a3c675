"""Balls of I_0 and alpha* for the printed formulas of section 5.1, at the precision in force."""

from typing import Any

from theory import bessel


def i0(x: Any) -> Any:
    """Ball of I_0 at a ball."""
    return x.bessel_i(0)


def alpha_star(*, digits: int = 60) -> Any:
    """Ball of alpha*, good to this many digits whatever the precision in force."""
    return bessel.supporting_scale(digits=digits).ball()


def text(ball: Any, *, digits: int = 6) -> str:
    """Decimal of a ball's midpoint for a place or a witness."""
    return str(ball.str(digits, radius=False))
