"""Claims of section 3.1, items (G) to (J): angle, fundamental forms, Moutard, sine-Gordon."""

from checks.catalogue import forms_and_moutard, invariant_angle, zero_curvature
from checks.claim import Claim

CLAIMS: tuple[Claim, ...] = (
    *invariant_angle.CLAIMS,
    *forms_and_moutard.CLAIMS,
    *zero_curvature.CLAIMS,
)
