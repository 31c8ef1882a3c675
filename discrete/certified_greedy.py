"""The greedy algorithm (alg:greedy-cuts) in ball arithmetic: every comparison is proved.

The algorithm of discrete.greedy. Where balls do not decide a comparison, the run begins anew with
twice the bits; that it ends is thereby proved for its parameters.
"""

from collections import deque
from collections.abc import Callable
from fractions import Fraction

from discrete.certified_cut import cut_sector
from discrete.certified_sides import BallConstants, UndecidedError, initial_ball_sector
from discrete.certified_tree import CertifiedSector, CertifiedTree
from discrete.enclosure import fraction_of
from discrete.errors import InsufficientPrecisionError, ShapeError
from discrete.greedy_parameters import GreedyParameters
from discrete.sector_cutter import TooNarrowError

#: Bits of the first try: the radii grow by a few bits in a sector.
BITS = 128

#: Largest radius of an enclosure: with a wider one the run begins anew as well.
WIDE = Fraction(1, 2**64)

#: Width of the ring swept around the disk at first, its growth when it was too narrow, its limit.
MARGIN, GROWTH, WIDEST = Fraction(1, 5), 2, 8


def certified_tree(
    parameters: GreedyParameters,
    *,
    bits: int = BITS,
    limit: int = 4096,
    max_cuts: int = 10**5,
    progress: Callable[[int, int], None] | None = None,
) -> CertifiedTree:
    """Tree of sectors that covers the disk, with every comparison decided by balls.

    bits: of the first try; limit: the most bits tried. max_cuts: of one sector of the initial star
    and up to its symmetry. progress is told the sectors done and waiting. Raises
    InsufficientPrecisionError where the limit does not decide a comparison; ShapeError where the
    cuts outnumber max_cuts; SurgeryError where rows and columns of a sector disagree.
    """
    from flint import ctx

    if not 16 <= bits <= limit:
        raise ShapeError(f"{bits} bits: expected at least 16 and at most the limit, {limit}")
    margin, told = MARGIN, progress or (lambda done, waiting: None)
    while True:
        try:
            with ctx.workprec(bits):
                sectors = _swept(parameters, margin, max_cuts, told)
            return CertifiedTree(parameters=parameters, sectors=sectors, bits=bits)
        except TooNarrowError:
            if margin >= WIDEST:
                raise ShapeError(
                    f"a ring of {margin} around the disk is too narrow for the lines of its net"
                ) from None
            margin *= GROWTH
        except UndecidedError:
            if 2 * bits > limit:
                raise InsufficientPrecisionError(
                    f"{bits} bits leave a comparison undecided or a number within more than "
                    f"2^-64, and {limit} are the limit"
                ) from None
            bits *= 2


def _swept(
    parameters: GreedyParameters,
    margin: Fraction,
    max_cuts: int,
    progress: Callable[[int, int], None],
) -> tuple[CertifiedSector, ...]:
    """Sectors of the tree, a daughter before the other sectors that wait."""
    constants = BallConstants.of(parameters, margin)
    waiting = deque([initial_ball_sector(constants)])
    done: list[CertifiedSector] = []
    cuts = 0
    while waiting:
        found, daughters = cut_sector(constants, waiting.popleft())
        if any(fraction_of(part.radius) > WIDE for part in found.enclosures()):
            raise UndecidedError
        done.append(found)
        cuts += found.cut is not None
        if cuts > max_cuts:
            raise ShapeError(f"more than {max_cuts} cuts were made")
        waiting.extendleft(reversed(daughters))
        progress(len(done), len(waiting))
    return tuple(done)
