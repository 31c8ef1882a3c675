"""Claims of section 5.1, the recursion on Amsler sectors."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
