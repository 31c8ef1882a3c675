"""Checker of certificates of the greedy algorithm: half-turns of triples, all decisions anew.

Positions are points of the hyperboloid and angles come from Minkowski products, while the run that
made the certificate advanced angles and heights without coordinates. The balls lose some ten bits
a step far out, and begin with thousands. Imports neither theory nor discrete.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb, ctx

from checks.certificates.greedy_format import Certificate, Sector
from checks.certificates.greedy_rows import Disk, OpenError, WrongError, decided, rational
from checks.certificates.greedy_sector import (
    Room,
    checked_sector,
    initial_room,
    matches,
    require,
)

LIMIT = 1 << 15


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """wrong: what was refuted, empty if the certificate is sound; open: no precision decided."""

    wrong: str = ""
    open: str = ""
    quads: int = 0
    bits: int = 0


def verdict(found: Certificate) -> Verdict:
    """Whether the certificate is sound, with more bits as long as a comparison stays open."""
    bits = _first_bits(found)
    while bits <= LIMIT:
        try:
            with ctx.workprec(bits):
                return Verdict(quads=_checked(found), bits=bits)
        except WrongError as error:
            return Verdict(wrong=str(error), bits=bits)
        except OpenError:
            bits += bits // 2
    return Verdict(open=f"{LIMIT} bits decide not every comparison")


def _first_bits(found: Certificate) -> int:
    """Precision of the first try, a guess: some R + 4 bits a step are lost for R = 3 to 6.

    Sectors u and v have a side of their parent, and its loss with it; half as much for the last.
    """
    inherited = max((sum(x != "A" for x in sector.path) for sector in found.tree), default=0)
    lost = (found.radius + 4) * found.radius / found.step * (inherited + Fraction(1, 2))
    return min(256 + int(lost), LIMIT)


def _checked(found: Certificate) -> int:
    """Number of quads checked. Raises WrongError, OpenError."""
    phi0 = rational(Fraction(2, found.sectors)) * arb.pi()
    cutoff = rational(found.cutoff[0]) + arb.pi() * rational(found.cutoff[1])
    require(decided(cutoff > phi0, cutoff <= phi0), "the cutoff is not above phi0")
    require(decided(cutoff < arb.pi(), cutoff >= arb.pi()), "the cutoff is not below pi")
    disk = Disk.of(found.radius, found.step, found.cutoff)
    sectors = {sector.path: sector for sector in found.tree}
    require(len(sectors) == len(found.tree), "a sector stands twice")
    waiting, seen, angles = [initial_room(disk, found.sectors, phi0)], [], []
    while waiting:
        room = waiting.pop()
        require(room.path in sectors, f"sector {room.path!r} is missing")
        sector = sectors[room.path]
        with ctx.workprec(_bits_left(room)):
            extremes, daughters = checked_sector(disk, room, sector)
        angles += extremes
        seen.append((room.copies, sector))
        waiting += daughters
    require(len(seen) == len(sectors), "there are sectors that no cut puts in")
    _totals(found, seen, angles)
    return sum(sector.quads for _, sector in seen)


def _bits_left(room: Room) -> int:
    """Precision that the points of a sector deserve."""
    accuracy = min(
        int(p[0].rel_accuracy_bits()) for p in (room.first.points[-1], room.second.points[-1])
    )
    if accuracy < 64:
        raise OpenError
    return min(int(ctx.prec), accuracy + 64)


def _totals(found: Certificate, seen: list[tuple[int, Sector]], cosines: list[Any]) -> None:
    cuts = [(copies, sector) for copies, sector in seen if sector.cut]
    counted = {
        "sectors": sum(copies for copies, _ in seen),
        "branch_points": sum(copies for copies, _ in cuts) + (found.sectors > 4),
        "quads": sum(copies * sector.quads for copies, sector in seen),
        "generations": max((len(sector.path) + 1 for _, sector in cuts), default=0),
    }
    for name, count in counted.items():
        require(found.counts[name] == count, f"totals: {name} are {count}")
    largest = smallest = cosines[0]
    for cosine in cosines[1:]:
        largest, smallest = largest.min(cosine), smallest.max(cosine)
    matches(largest.acos(), found.largest, "totals: largest angle")
    matches(smallest.acos(), found.smallest, "totals: smallest angle")
