"""Claims of section 4, discrete K-surfaces and spherical Chebyshev nets."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
