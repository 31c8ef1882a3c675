"""Why a C^2 surface of negative curvature cannot refine: four sectors and index -1 everywhere."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from theory import star_saddle

_ANGLES = ("1/2", "1/3", "2/5", "1/50")


def cannot_refine(
    setting: Setting, *, sectors: int = 4, curvature: int = -1, smooth: bool = True
) -> Evidence:
    """Sectors above and below the tangent plane at any point of a C^2 surface, remainder included.

    The height is that of a quadratic form of determinant curvature w^2 plus a remainder of size
    e r^2, its gradient of size e r, e to 0 with r, since the surface is C^2. In coordinates along
    the null lines of the form it is r^2 sin(2 theta)/2 + remainder: where it vanishes, the sine is
    at most 2 e and the derivative by theta at least (sqrt(1 - 4 e^2) - e) r^2: four simple zeros.
    sectors: how many there are to be; smooth: whether the forms of all sectors are one.
    """
    a, b, w, e = sp.symbols("a b w e", positive=True)
    c = (curvature * w**2 + b**2) / a
    discriminant = sp.simplify(b**2 - a * c)
    lines = 2 if discriminant.is_positive else 0
    least = e / (1 + e) / sp.sqrt(5)
    counts = []
    for share in _ANGLES:
        angle = sp.Rational(share) * sp.pi
        star = (angle, sp.pi - angle) * 2 if smooth else star_saddle.regular_star(3)
        above, below = star_saddle.count_sides(star)
        counts.append((above + below, int(star_saddle.winding_number(star))))
    wanted = (sectors, 1 - sectors // 2)
    parts: dict[str, Any] = {
        "null lines": statement(
            2 * lines == sectors,
            shown="two null lines",
            witness=f"a form of determinant {curvature} w^2 has {lines} null lines",
        ),
        "simple zeros": positivity(
            setting, {"1 - 4 e^2 - e^2 for e < 1/sqrt 5": 1 - 5 * least**2}, shown="simple"
        ),
        "determinant": identities(
            setting, {"a c - b^2": a * c - b**2 - curvature * w**2}, shown=""
        ),
        "saddles": statement(
            all(count == wanted for count in counts),
            shown="sectors",
            witness=f"sectors and indices {counts}, expected {wanted}",
        ),
    }
    return combined(
        parts,
        shown="a C^2 surface of negative curvature has two null directions at each point, its "
        "height changes sign at exactly four simple zeros on small circles whatever the remainder, "
        "and its normal has the index -1: no point, near the boundary or not, has more than four "
        "sectors",
    )
