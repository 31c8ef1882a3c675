"""Claims of section 1, the introduction."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
