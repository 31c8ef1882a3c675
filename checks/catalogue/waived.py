"""Labels of the paper that state nothing."""

from checks.claim import Waiver

WAIVED: tuple[Waiver, ...] = ()
