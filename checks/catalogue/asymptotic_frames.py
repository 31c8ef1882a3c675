"""Claims of section 3.1, items (A) to (F): asymptotic coordinates, frames, Lelieuvre, the normal."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
