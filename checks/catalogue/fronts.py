"""Claims of section 3.1, C^1M functions, weakly harmonic maps, fronts."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
