"""Claims of section 2, isometric immersions and their regularity."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
