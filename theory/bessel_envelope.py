"""Two-sided bounds of I_0(y) sqrt(y) e^-y for all y >= 1, from the integral of e^(y cos t).

pi I_0(y) is the integral over 0 < t < pi. There cos t <= 1 - 2 t^2/pi^2, since sin(t/2) >= t/pi,
and the Gaussian over t > 0 has the integral (pi/2) sqrt(pi/(2 y)): the upper bound is
sqrt(pi/8). Where t^2 <= 1/y, y cos t >= y - y t^2/2 >= y - 1/2: the lower bound is e^(-1/2)/pi.
"""

from typing import Any

from flint import arb


def upper() -> Any:
    """Ball of sqrt(pi/8), a bound of I_0(y) sqrt(y) e^-y from above for y > 0."""
    return (arb.pi() / 8).sqrt()


def lower() -> Any:
    """Ball of 1/(pi sqrt e), a bound of I_0(y) sqrt(y) e^-y from below for y >= 1."""
    return (-arb(1) / 2).exp() / arb.pi()


def log_bounds(y: Any) -> tuple[Any, Any]:
    """Balls below and above log I_0(y), for a ball y >= 1."""
    middle = y - y.log() / 2
    return middle + lower().log(), middle + upper().log()
