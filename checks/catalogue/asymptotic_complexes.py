"""Claims of section 3.3, branched immersions and asymptotic complexes."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
