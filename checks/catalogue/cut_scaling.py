"""Claims of section 5.1, all sectors: cut coordinates, observed bounds, the smallest angle."""

from checks.catalogue import cut_coordinates, frontier, smallest_angle
from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *cut_coordinates.CLAIMS,
    *frontier.CLAIMS,
    *smallest_angle.CLAIMS,
)
