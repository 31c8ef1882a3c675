"""Claims of appendix A, asymptotics of Painleve III."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
