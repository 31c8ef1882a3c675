"""Sine, cosine and arc tangent as plain polynomials, which a compiler runs on many lanes at once.

The functions of a mathematical library are calls, and a loop with a call in it is not vectorised.
"""

from typing import Any

#: Taylor coefficients of sin(y)/y and of cos(y) in powers of y^2; at y = pi/2 the first term left
#: out is 1e-18 of the sum.
SINE = tuple((-1) ** k / f for k, f in enumerate((
    1, 6, 120, 5040, 362880, 39916800, 6227020800, 1307674368000, 355687428096000,
    121645100408832000, 51090942171709440000,
)))  # fmt: skip
COSINE = tuple((-1) ** k / f for k, f in enumerate((
    1, 2, 24, 720, 40320, 3628800, 479001600, 87178291200, 20922789888000, 6402373705728000,
    2432902008176640000, 1124000727777607680000,
)))  # fmt: skip

#: Largest argument of `small_arc_tangent`: there the first term left out is 1e-19 of the sum.
SMALL = 1 / 16


def sine(y: Any) -> Any:
    """Sine of y in [0, pi/2], to the last places."""
    z = y * y
    found = SINE[10]
    found = SINE[9] + z * found
    found = SINE[8] + z * found
    found = SINE[7] + z * found
    found = SINE[6] + z * found
    found = SINE[5] + z * found
    found = SINE[4] + z * found
    found = SINE[3] + z * found
    found = SINE[2] + z * found
    found = SINE[1] + z * found
    return y + y * (z * found)


def cosine(y: Any) -> Any:
    """Cosine of y in [0, pi/2], to the last places of 1."""
    z = y * y
    found = COSINE[11]
    found = COSINE[10] + z * found
    found = COSINE[9] + z * found
    found = COSINE[8] + z * found
    found = COSINE[7] + z * found
    found = COSINE[6] + z * found
    found = COSINE[5] + z * found
    found = COSINE[4] + z * found
    found = COSINE[3] + z * found
    found = COSINE[2] + z * found
    found = COSINE[1] + z * found
    return 1 + z * found


def small_arc_tangent(x: Any) -> Any:
    """Arc tangent of |x| <= SMALL, to the last places."""
    z = x * x
    found = 1 / 13 - z / 15
    found = 1 / 11 - z * found
    found = 1 / 9 - z * found
    found = 1 / 7 - z * found
    found = 1 / 5 - z * found
    found = 1 / 3 - z * found
    return x - x * (z * found)
