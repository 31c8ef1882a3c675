"""Readings of the lines of the greedy algorithm that the paper leaves open or misprints.

A reading takes each such line either to the letter or as it has to be meant for the disk to be
covered; a named variant takes one line to the letter and the others as meant.
"""

from dataclasses import dataclass, replace
from types import MappingProxyType


@dataclass(frozen=True, kw_only=True)
class Reading:
    """How the lines of (alg:greedy-cuts) are taken; the defaults are the letter of the paper.

    fill_to_number: step 5 fills j, k <= n, the number of the sector, and not j, k <= N;
    signed: the angle of steps 8 and 22 has the sign of (eq:angle); principal: arg in (eq:trisect)
    is a value in (-pi, pi], and not the sum of the arguments taken without a jump from w_1 to w_2;
    by_place: steps 6 and 20 look at the places of the predecessors only, so that a node beyond
    discarded ones can be kept; all_nodes: steps 11 to 13 and 25 look at every angle of a sector,
    and not only at nodes of the closed disk; lost_axes: step 17 takes over only nodes that were
    not discarded.
    """

    fill_to_number: bool = True
    signed: bool = True
    principal: bool = True
    by_place: bool = True
    all_nodes: bool = True
    lost_axes: bool = True


MEANT = Reading(
    fill_to_number=False,
    signed=False,
    principal=False,
    by_place=False,
    all_nodes=False,
    lost_axes=False,
)

#: Name of a variant: its reading. `letter` takes every line to the letter, `meant` none.
VARIANTS = MappingProxyType(
    {
        "letter": Reading(),
        "fill": replace(MEANT, fill_to_number=True),
        "sign": replace(MEANT, signed=True),
        "argument": replace(MEANT, principal=True),
        "discard": replace(MEANT, by_place=True),
        "nodes": replace(MEANT, all_nodes=True),
        "axes": replace(MEANT, lost_axes=True),
        "meant": MEANT,
    }
)
