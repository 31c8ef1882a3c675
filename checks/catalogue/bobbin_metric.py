"""Claims of section 3.1, Minding's bobbin: metric, curvature, the largest disk."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
