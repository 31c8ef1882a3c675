"""Signs of numbers in closed form, by balls."""

from typing import Any

import sympy as sp
from flint import ctx

from checks.ball import enclosure


def sign(number: Any, *, bits: int = 128) -> int:
    """Sign -1 or 1 of a real number in closed form, 0 only for an exact zero.

    Raises ArithmeticError where a ball of this precision does not decide it.
    """
    with ctx.workprec(bits):
        ball = enclosure(sp.sympify(number), {})
        if ball > 0:
            return 1
        if ball < 0:
            return -1
        if ball == 0:
            return 0
        raise ArithmeticError(f"the sign is not decided at {bits} bits: {ball}")
