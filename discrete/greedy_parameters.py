"""Parameters of the greedy algorithm (alg:greedy-cuts), exact numbers."""

from dataclasses import dataclass
from fractions import Fraction
from math import cosh, isfinite, sinh, tanh

import numpy as np
import numpy.typing as npt

from discrete.errors import AngleError, EdgeLengthError, ShapeError
from discrete.exact_angle import ExactAngle

#: Longest step: a coarser net resolves no cut, and the compiled arc tangent is made for it.
LONGEST_STEP = Fraction(1, 2)

#: Largest radius of a disk: the heights cosh(2 R) stay finite.
LARGEST_RADIUS = 300


@dataclass(frozen=True, kw_only=True)
class GreedyParameters:
    """Disk of this radius, edges of length `step`, an even number of initial sectors, a cutoff.

    The initial sectors open by phi0 = 2 pi/sectors; phi0 < cutoff < pi. Raises EdgeLengthError,
    ShapeError, AngleError.
    """

    radius: Fraction
    step: Fraction
    sectors: int
    cutoff: ExactAngle

    def __post_init__(self) -> None:
        for name in ("radius", "step"):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | Fraction):
                raise EdgeLengthError(f"{name} = {value!r}: give an integer or a Fraction")
            object.__setattr__(self, name, Fraction(value))
        if not 0 < self.radius <= LARGEST_RADIUS:
            raise EdgeLengthError(
                f"the radius is {float(self.radius):g}: expected more than 0 and at most "
                f"{LARGEST_RADIUS}"
            )
        if not 0 < self.step <= min(self.radius, LONGEST_STEP):
            raise EdgeLengthError(
                f"the step is {float(self.step):g}: expected more than 0, at most the radius "
                f"{float(self.radius):g} and at most {LONGEST_STEP}"
            )
        if isinstance(self.sectors, bool) or not isinstance(self.sectors, int):
            raise ShapeError(f"sectors = {self.sectors!r}: give an even integer of 4 or more")
        if self.sectors < 4 or self.sectors % 2:
            raise ShapeError(
                f"{self.sectors} initial sectors: expected an even number of 4 or more, since u- "
                "and v-lines alternate around the centre"
            )
        if (self.cutoff - self.phi0).sign() <= 0 or (_PI - self.cutoff).sign() <= 0:
            raise AngleError(
                f"the cutoff is {self.cutoff} = {float(self.cutoff):.6g}: expected an angle "
                f"between phi0 = {self.phi0} = {float(self.phi0):.6g} and pi"
            )

    @property
    def phi0(self) -> ExactAngle:
        """Angle of an initial sector."""
        return ExactAngle(half_turns=Fraction(2, self.sectors))

    @property
    def area(self) -> float:
        """Area 2 pi (cosh R - 1) of the disk."""
        return float(4 * np.pi * sinh(float(self.radius) / 2) ** 2)

    def run_constants(self, margin: float) -> npt.NDArray[np.float64]:
        """Constants of discrete.sector_sweep; margin: width of the ring swept around the disk.

        A quad meets the disk only if a vertex of it is less than half a step beyond the rim, by
        the height cosh(R) cosh(step/2) of the ends of an edge that touches it.
        """
        radius, step = float(self.radius), float(self.step)
        found = np.array(
            [
                tanh(step / 2) ** 2,
                cosh(radius),
                cosh(radius) * cosh(step / 2),
                cosh(radius + margin),
                float(self.cutoff),
                cosh(step),
                sinh(step),
            ]
        )
        if not isfinite(found.sum()):
            raise EdgeLengthError(f"a ring of {margin} around the radius {radius} overflows")
        return found


_PI = ExactAngle(half_turns=Fraction(1))
