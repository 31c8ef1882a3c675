"""Claims of section 3.3, the index of the normal map and the topological theorem."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
