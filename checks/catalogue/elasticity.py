"""Claims of section 2, energies of plates and their limits."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
