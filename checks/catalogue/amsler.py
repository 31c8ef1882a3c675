"""Claims of section 3.1, Amsler sectors and Painleve III."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
