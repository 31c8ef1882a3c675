"""Claims of section 3.1, items (A) to (F): coordinates, frames, Lelieuvre formulae, the normal."""

from checks.catalogue import (
    asymptotic_coordinates,
    frenet_frames,
    lelieuvre_consistency,
    oriented_normal,
    symmetries,
)
from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *asymptotic_coordinates.CLAIMS,
    *frenet_frames.CLAIMS,
    *lelieuvre_consistency.CLAIMS,
    *symmetries.CLAIMS,
    *oriented_normal.CLAIMS,
)
