"""Claims of section 3.1, Minding's bobbin as a front: its differential equation, normal, cusps."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
