"""(lem:maximal) by the cone of (lem:injective): the disk must grow as k_max, and no faster."""

from typing import Any

import sympy as sp
from flint import ctx

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.positivity import positivity
from checks.verify.normal_map_lemma import BITS, refutation
from checks.verify.normal_separation import collar_claims
from theory import normal_bounds

_S, _X = sp.symbols("s x", positive=True)


def _claims(reach: str, share: str) -> dict[str, Any]:
    """What gives both items on B_{2 delta}, delta < s^2/16, from a disk of radius reach k delta.

    Two points of B_{2 delta} are less than 4 delta apart; the rectangle of asymptotic coordinates
    that they span keeps within 8 delta/s of the first, so within 2 delta + 8 delta/s of the centre.
    """
    slope = 1 / (1 + _S)
    delta = slope**2 / 16 * _X / (1 + _X)
    far = normal_bounds.farthest(4 * delta, slope)
    k = 1 + _X
    needed = sp.Rational(reach) * k - 2
    return {
        "room for the rectangle": needed**2 - 64 / normal_bounds.cone_slope(k) ** 2,
        "sign of that room": needed,
        "distance 4 delta where the rectangle is bounded": slope**2 / 2 - 4 * delta,
        "bound of |N(x) - N(w)| at the distance 4 delta": normal_bounds.floor(far, slope),
    } | collar_claims(share)


def linear_radius(
    setting: Setting, *, reach: str = "14", below: str = "3/16", share: str = "7/8"
) -> Evidence:
    """Both items on disks of radius reach k delta for all k >= 1, refuted on below k delta.

    share: |N(x) - N_0| >= share delta/sqrt(1 + k^2) on the collar.
    """
    with ctx.workprec(BITS):
        witness = refutation(below, "1")
    claims = _claims(reach, share)
    least = claims["room for the rectangle"].subs(_X, 0)
    return combined(
        {
            "cone": positivity(setting, claims, shown="cone"),
            # The room is least at k = 1, where random values of k may miss that it is short.
            "k = 1": statement(
                bool(least >= 0), shown="k = 1", witness=f"k = 1: the room is {least} delta^2"
            ),
            "folded corner": Evidence(
                outcome="pass" if witness else "fail",
                grade="certified",
                shown=witness,
                witness="" if witness else f"no surface refutes it on B_{{{below} k delta}}",
            ),
        },
        shown="for k >= 1 and delta < 1/(16 (1 + k^2)) the normal is one-to-one on B_{2 delta} and "
        f"|N(x) - N_0| >= 7 delta/(8 sqrt(1 + k^2)) on the collar, from B_{{{reach} k delta}}; "
        f"from B_{{{below} k delta}} it is not, for k = 20",
    )
