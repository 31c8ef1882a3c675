"""Claims of the opening of section 3."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
