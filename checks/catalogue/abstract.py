"""Claims of the abstract."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
