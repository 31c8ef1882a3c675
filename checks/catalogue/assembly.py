"""Claims of section 3.2, m-stars, m-saddles and assembly."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
