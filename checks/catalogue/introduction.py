"""Claims of the introduction."""

from checks.catalogue import announced_equations, announced_results, hyperbolic_growth, regularity
from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *hyperbolic_growth.CLAIMS,
    *regularity.CLAIMS,
    *announced_results.CLAIMS,
    *announced_equations.CLAIMS,
)
