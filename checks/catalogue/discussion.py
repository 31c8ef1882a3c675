"""Claims of section 6, the discussion."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
