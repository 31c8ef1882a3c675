"""Claims of section 4.1, Chebyshev nets in the Poincare disk."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
