"""Labels of the paper that state nothing."""

from checks.claim import Waiver

_SECTION = "heading of a section: what it states is in the claims of the section"
_PHOTOGRAPH = "photograph of a plant, named as an illustration: nothing in it is measured"

WAIVED: tuple[Waiver, ...] = (
    Waiver(label="sec:intro", reason=_SECTION),
    Waiver(label="fig:enr2leaves", reason=_PHOTOGRAPH),
    Waiver(label="fig:purpleiris", reason=_PHOTOGRAPH),
    Waiver(label="fig:mustard", reason=_PHOTOGRAPH),
    Waiver(label="fig:examplesofnaturalobjects", reason="the figure of the three photographs"),
    Waiver(label="sec:noneuclideanelasticity", reason=_SECTION),
    Waiver(label="sec:branchedsurfaces", reason=_SECTION),
    Waiver(label="sec:geometry", reason=_SECTION),
    Waiver(label="sec:kminusonemonkeysaddle", reason=_SECTION),
    Waiver(label="sec:approximation", reason=_SECTION),
    Waiver(label="sec:introducingabranchpoint", reason=_SECTION),
    Waiver(label="sec:sinegordon", reason=_SECTION),
    Waiver(label="sec:ddg", reason=_SECTION),
    Waiver(label="sec:poincare-ddg", reason=_SECTION),
    Waiver(
        label="fig:shapeprocedure1",
        reason=(
            "set between the panels of figure (fig:shapeprocedure2) with no caption of its own, "
            "and referred to nowhere"
        ),
    ),
    Waiver(label="sec:applications", reason=_SECTION),
    Waiver(label="sec:amslerrecursion", reason=_SECTION),
    Waiver(
        label="fig:recursion",
        reason=(
            "set between the panels (fig:branch-tree) and (fig:cutsketch) with no caption of its "
            "own, and referred to nowhere"
        ),
    ),
    Waiver(label="sec:discussion", reason=_SECTION),
    Waiver(label="appndx:amsler", reason=_SECTION),
)
