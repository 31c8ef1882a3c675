"""What a named value is: a description, keys with their domains, a certified and a reference route.

The routes are named as "module:function" and imported only when a value is asked for. Both take
the keys in their order and `digits=`; the first returns a theory.enclosure.Enclosure, the second a
number of mpmath; those of an integer take no digits and return it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

MOST_DIGITS = 10_000


@dataclass(frozen=True, kw_only=True)
class Key:
    """Argument of a value, an exact real number or an integer in an interval.

    low, high: the ends, as expressions or as names of keys that come before; None for no bound.
    even: whether the number is an even integer; optional: whether it may be left out.
    """

    name: str
    meaning: str
    low: str | None
    high: str | None
    low_open: bool = False
    high_open: bool = False
    even: bool = False
    optional: bool = False

    @property
    def domain(self) -> str:
        """Domain as a chain of inequalities, or in words for an integer.

        >>> Key(name="phi0", meaning="initial angle", low="0", high="pi", low_open=True).domain
        '0 < phi0 <= pi'
        """
        left = "" if self.low is None else f"{self.low} {'<' if self.low_open else '<='} "
        right = "" if self.high is None else f" {'<' if self.high_open else '<='} {self.high}"
        chain = f"{left}{self.name}{right}"
        return f"{chain}, an even integer" if self.even else chain


@dataclass(frozen=True, kw_only=True)
class Value:
    """One number of the paper that can be asked for by name.

    certified, reference: "module:function"; reference_digits: most digits of the latter. integer:
    whether the value is an integer, which takes no digits and is exact.
    """

    name: str
    meaning: str
    keys: tuple[Key, ...]
    certified: str
    reference: str
    reference_digits: int = MOST_DIGITS
    integer: bool = False

    def __post_init__(self) -> None:
        for route in (self.certified, self.reference):
            module, _, function = route.partition(":")
            if not (module and function):
                raise ValueError(f"{self.name}: {route!r} is not of the form module:function")


def function_of(route: str) -> Callable[..., Any]:
    """Import the function named by "module:function"."""
    module, _, name = route.partition(":")
    function: Callable[..., Any] = getattr(import_module(module), name)
    return function
