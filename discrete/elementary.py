"""Elementary functions of each kind of number, under one set of names.

A body of geometry takes such a set as its argument `functions` and so runs on every kind:
`math` (floats), `mpmath.mp`, `sympy` serve as they are; arrays and balls need the adaptors below.
The names are those of `math`: pi, sqrt, exp, log, sin, cos, tan, atan, atan2, sinh, cosh, tanh,
asinh. flint takes the number of bits from its context: set it by `with ctx.workprec(bits)`.
"""

from types import SimpleNamespace
from typing import Any, Protocol, cast


class Functions(Protocol):
    """What a set of elementary functions has to offer; each function takes and gives scalars."""

    @property
    def pi(self) -> Any: ...  # noqa: D102
    def sqrt(self, x: Any, /) -> Any: ...  # noqa: D102
    def exp(self, x: Any, /) -> Any: ...  # noqa: D102
    def log(self, x: Any, /) -> Any: ...  # noqa: D102
    def sin(self, x: Any, /) -> Any: ...  # noqa: D102
    def cos(self, x: Any, /) -> Any: ...  # noqa: D102
    def tan(self, x: Any, /) -> Any: ...  # noqa: D102
    def atan(self, x: Any, /) -> Any: ...  # noqa: D102
    def atan2(self, y: Any, x: Any, /) -> Any: ...  # noqa: D102
    def sinh(self, x: Any, /) -> Any: ...  # noqa: D102
    def cosh(self, x: Any, /) -> Any: ...  # noqa: D102
    def tanh(self, x: Any, /) -> Any: ...  # noqa: D102
    def asinh(self, x: Any, /) -> Any: ...  # noqa: D102


def array_functions() -> Functions:
    """Elementary functions of numpy arrays, entry by entry."""
    import numpy as np

    same = ("pi", "sqrt", "exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh")
    named = {name: getattr(np, name) for name in same}
    renamed = {"atan": np.arctan, "atan2": np.arctan2, "asinh": np.arcsinh}
    found: Any = SimpleNamespace(**named, **renamed)
    return cast("Functions", found)


def _ball(x: Any) -> Any:
    """Ball around an exact number; a float that is no integer seldom is the number meant."""
    from flint import arb

    if isinstance(x, arb):
        return x
    if isinstance(x, float) and not x.is_integer():
        raise TypeError(f"{x} is a float: give an integer, a fraction (fmpq) or a ball")
    return arb(x)


_OF_ONE = ("sqrt", "exp", "log", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "asinh")


class BallFunctions:
    """Elementary functions of arb balls, at the precision in force; TypeError for other floats."""

    @property
    def pi(self) -> Any:
        """Ball around pi."""
        from flint import arb

        return arb.pi()

    def atan2(self, y: Any, x: Any) -> Any:
        """Argument of x + i y."""
        return type(_ball(y)).atan2(_ball(y), _ball(x))  # static in python-flint

    def __getattr__(self, name: str) -> Any:
        if name not in _OF_ONE:
            raise AttributeError(name)
        # flint's methods called through the class do not look at the type of their argument.
        return lambda x: getattr(_ball(x), name)()


def ball_functions() -> Functions:
    """Elementary functions of arb balls, at the precision in force."""
    return cast("Functions", BallFunctions())
