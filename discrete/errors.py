"""Errors of the nets: each says which vertex, edge or angle is at fault, and what to do."""


class DiscreteError(ValueError):
    """Base of the errors of this package; a caller that handles bad input catches this one."""


class NotFiniteError(DiscreteError):
    """A coordinate, length or angle is NaN or infinite."""


class OffSpaceError(DiscreteError):
    """A triple lies neither on S^2 nor on H^2, as far as its digits tell."""


class AntipodalError(DiscreteError):
    """Two vertices are antipodal, or nearly: no half-turn or geodesic is determined by them."""


class EdgeLengthError(DiscreteError):
    """An edge length is not positive, or too long for the space."""


class AngleError(DiscreteError):
    """An angle lies outside its range, or angles at a corner have the wrong sum."""


class ShapeError(DiscreteError):
    """Data of a rectangle do not fit together: too short, of unequal lengths, without a corner."""


class CoincidentVerticesError(DiscreteError):
    """Two vertices coincide: there is no direction from one to the other."""


class InsufficientPrecisionError(ArithmeticError):
    """A comparison of balls stayed undecided up to the limit of bits; no bad input."""
