"""Claims of section 3.1, items (G) to (J): angle, fundamental forms, Moutard, sine-Gordon."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
