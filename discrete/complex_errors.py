"""Errors of asymptotic complexes: what in a gluing, a polygon or its angles cannot be."""

from discrete.errors import AngleError, DiscreteError


class ComplexError(DiscreteError):
    """The faces are those of no asymptotic complex."""


class FaceError(ComplexError):
    """A face is no quadrilateral, or data are not one to a face."""


class MemberError(ComplexError):
    """What is named as a vertex, a face or a number of edges is none."""


class SurfaceError(ComplexError):
    """The faces form no surface: three meet in an edge, or a vertex joins separate fans."""


class LabelError(ComplexError):
    """An edge belongs to the u-family in one face and to the v-family in another."""


class RegularityError(ComplexError):
    """Two faces meet in more than one vertex or one edge."""


class GluingError(ComplexError):
    """Two sides cannot be glued: their lengths or families differ, or one is not free."""


class SurgeryError(ComplexError):
    """A sector cannot be cut out or put in where it is asked for."""


class PolygonError(DiscreteError):
    """A closed path of edges is no Hamburger polygon of the complex."""


class AngleSumError(AngleError):
    """The angles around an interior vertex do not add up to a full turn."""


class NormalError(DiscreteError):
    """The normal does not wind around a vertex: a neighbour's is the same or antipodal."""


class UndecidedError(DiscreteError):
    """A ball is too wide to decide a condition at a vertex: more bits may do."""
