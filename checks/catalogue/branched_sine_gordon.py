"""Claims of section 3.5, the sine-Gordon equation with branch points."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
