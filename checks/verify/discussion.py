"""The results that section 6 lists: the generalised sine-Gordon equation and what it asks for."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import branched_sine_gordon as printed
from checks.verify import balanced_curvature
from checks.verify.branched_sine_gordon import sum_rule
from theory.star_field import StarField


def generalised(setting: Setting, *, regular: int = 2, sign: int = -1) -> Evidence:
    """(sg-global) without branch points is the classical equation; with them it has a new term.

    regular: order without charge; sign: of the charges. On a rectangle [u, u + a] x [v, v + b] with
    phi as its own function, the alternating sum divided by a b tends to phi_uv.
    """
    u, v, a, b = sp.symbols("u v a b", positive=True)
    phi = sp.Function("phi")
    corners = phi(u, v) - phi(u + a, v) + phi(u + a, v + b) - phi(u, v + b)
    small = corners.subs({a: 0}).doit()
    mixed = sp.diff(corners, a, b).subs({a: 0, b: 0}).doit()
    no_charge = sp.expand(printed.concentration(2, regular=regular, sign=sign))
    new = {
        f"charge of order {m}, from the angles at its centre": sp.expand(
            printed.concentration(m, regular=regular, sign=sign)
            - sum((-1) ** j * StarField(order=m).centre(j) for j in range(2 * m))
        )
        for m in (3, 4, 5)
    }
    return combined(
        {
            "classical": identities(
                setting,
                {
                    "no area, no sum": small,
                    "density of the sum": mixed - sp.diff(phi(u, v), u, v),
                    "regular points": no_charge,
                },
                shown="",
            ),
            "charges": identities(setting, new, shown=""),
            "domains": sum_rule(setting, regular=regular, sign=sign),
        },
        shown="on a small rectangle without branch points the rule is phi_uv = sin phi; a branch "
        "point adds -(m - 2) pi, the alternating sum of the angles at its centre, and with these "
        "terms the rule holds on random tilings with several branch points",
    )


def distributed(
    setting: Setting, *, order: int = 3, percent: int = 100, per_vertex: int = 100
) -> Evidence:
    """Number of branch points of order 3 that angles within delta of pi/2 ask for, by the area.

    Both energies are least at pi/2 at each point; |A - k pi| <= 2 j delta for k points of the order
    given, 2j vertices. percent: of the area pi for each; per_vertex: hundredths of delta that each
    vertex contributes.
    """
    area = sp.Symbol("A", positive=True)
    field = StarField(order=order)
    charge = sum((-1) ** j * field.centre(j) for j in range(field.size))
    count = area / printed.area_per_branch_point(3, percent=percent)
    parts = {
        "energies": balanced_curvature.right_angle_optimal(setting),
        "bound": balanced_curvature.near_cancellation(setting, per_vertex=per_vertex),
        "density": identities(
            setting,
            {"A and the charges of A/pi points": sp.expand(area + count * charge)},
            shown="",
        ),
    }
    return combined(
        parts,
        shown="both energies are least at pi/2; angles within delta of it at the 2 j vertices of a "
        "Hamburger polygon leave |A - k pi| <= 2 j delta for k branch points of order 3 inside: "
        "one for each area pi, wherever the polygon lies",
    )
