"""Claims of section 3.4, surgery."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
