"""Errors of the certified values: what was out of the domain, and what could not be decided."""

from __future__ import annotations

from theory.enclosure import Enclosure


class WithEnclosure:
    """Mixin of the errors that carry the enclosure they are about (None where there is none).

    It stays with the message in args, so that the error survives being sent between processes.
    """

    args: tuple[object, ...]

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""

    @property
    def enclosure(self) -> Enclosure | None:
        """Enclosure of the offending quantity."""
        found = self.args[1] if len(self.args) > 1 else None
        return found if isinstance(found, Enclosure) else None


class InsufficientPrecisionError(WithEnclosure, ArithmeticError):
    """The precision reached its stated cap, or an input has none to give, before a decision."""


class UndecidedError(WithEnclosure, ArithmeticError):
    """A ball is too wide at the precision in force to decide a comparison: more bits may do."""


class DomainError(WithEnclosure, ValueError):
    """An argument is certainly outside the domain of the function."""


class PastFirstMaximumError(DomainError):
    """The level is certainly above the first maximum of the angle, whose enclosure is carried."""


class PastFirstCrossingError(DomainError):
    """A family of initial angles is asked for beyond the first crossing of pi by its largest."""


class SingularEdgeError(DomainError):
    """The geodesic disk certainly reaches the singular edge phi = pi; its distance is carried."""
