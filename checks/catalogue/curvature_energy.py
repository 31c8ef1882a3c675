"""Claims of the opening of section 5, energies of the classes of immersions."""

from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = ()
