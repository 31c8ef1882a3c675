"""The statements of the abstract that can be decided as they are worded."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import abstract as printed
from checks.verify.finite_pieces import disk_in_bobbin
from theory import star_saddle
from theory.amsler import edge_of_regularity
from theory.bobbin import largest_on_disk
from theory.curvature import principal_curvatures

R = sp.Symbol("R", positive=True)


def no_concentration(setting: Setting, *, degree: int = 2, order: int = 3) -> Evidence:
    """Bending energy near a branch point of a surface whose height is homogeneous of this degree.

    Its second derivatives scale like r^(degree - 2); for 2 they are those of sectors at the angles
    of the star, where the density is finite.
    """
    r, size = sp.symbols("r epsilon", positive=True)
    corner = star_saddle.regular_star(order)[0]
    larger, smaller = principal_curvatures(corner)
    density = sp.simplify(larger**2 + smaller**2)
    energy = sp.integrate(density * r ** (2 * (degree - 2)) * r, (r, 0, size))
    rest = sp.limit(energy, size, 0) if energy.is_finite is not False else sp.oo
    return statement(
        bool(density.is_finite) and rest == 0,
        shown=f"with the density {density} at the corners of a monkey saddle the energy within "
        "epsilon of the branch point is O(epsilon^2)",
        witness=f"with heights of degree {degree} the energy within epsilon is {energy}",
    )


def sub_exponential(setting: Setting, *, tenths: int = 5) -> Evidence:
    """Limit of the ratio of the two exponents, for arbitrary positive constants."""
    c, other = sp.symbols("c c_1", positive=True)
    ratio = printed.branched_exponent(R, c, tenths=tenths) / printed.smooth_exponent(R, other)
    limit = sp.limit(ratio, R, sp.oo)
    return statement(
        limit == 0,
        shown="c sqrt(R)/(c' R) tends to 0: exp(c sqrt R) grows less than every exp(c' R)",
        witness=f"the ratio of the exponents tends to {limit}",
    )


def one_branched_surface(setting: Setting, *, radius: int = 4, order: int = 3) -> Evidence:
    """Whether one branched surface is unbounded on the disk of this radius about its centre.

    It is glued of 2m Amsler sectors of angle pi/m. The point u = v = sqrt(x) is within 2 sqrt(x) of
    the centre; and as long as phi <= pi/2, u v <= R^2/2, so that phi <= pi/m + R^2/2.
    """
    corner = star_saddle.regular_star(order)[0]
    reach = edge_of_regularity(corner)[1]
    bounded = bool(corner + sp.Rational(radius**2, 2) <= sp.pi / 2)
    if not bounded and bool(2 * sp.sqrt(reach) > radius):
        return Evidence(outcome="undecided", grade="exact", shown="between the two bounds")
    return statement(
        not bounded,
        shown=f"the saddle of order {order} glued of Amsler sectors has a branch point, and its "
        f"angle is pi at a point within 2 sqrt({reach}) = {sp.N(2 * sp.sqrt(reach), 5)} of it: its "
        f"curvature is unbounded on the disk of radius {radius}",
        witness=f"on the disk of radius {radius} phi <= pi/2, and no curvature exceeds "
        f"cot({corner / 2})",
    )


def smooth_bound(setting: Setting, *, halves: int = 2, throat: str = "cosh") -> Evidence:
    """Largest curvature of a bobbin on the disk of radius R, against exp(halves R/2)."""
    kappa = {"cosh": sp.cosh(R), "sinh": sp.sinh(R), "half": sp.cosh(R / 2)}[throat]
    ends = largest_on_disk(kappa, sp.Integer(0), R)
    bound = printed.smooth_exponent(R, sp.Rational(halves, 2))
    ratio = sp.limit((kappa * sp.exp(-bound)).rewrite(sp.exp), R, sp.oo)
    return combined(
        {
            "disk": disk_in_bobbin(setting, throat=throat),
            "largest curvatures": identities(
                setting, {"at the edge and the throat": [e - kappa**2 for e in ends]}, shown=""
            ),
            "growth": statement(
                bool(ratio < sp.oo),
                shown="",
                witness=f"{kappa} exp(-{bound}) tends to {ratio}",
            ),
        },
        shown="on a disk of radius R in the cover of the bobbin of throat curvature cosh R both "
        "principal curvatures are at most cosh R = O(e^R)",
    )
