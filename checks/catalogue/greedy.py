"""Claims of section 4.1, the greedy algorithm and its dual."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
