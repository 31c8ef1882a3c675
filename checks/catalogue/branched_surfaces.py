"""Claims opening section 3: the isometry problem, branch points, the hyperbolic plane."""

from checks.catalogue import branched_saddles, hyperbolic_plane, isometry_problem
from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *isometry_problem.CLAIMS,
    *branched_saddles.CLAIMS,
    *hyperbolic_plane.CLAIMS,
)
