"""Checks of the metric of the normal map and of (eq:BLD)."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import bounded_distortion as printed
from theory import asymptotic_coframe, asymptotic_net, forms
from theory.vectors import added

PHI = sp.Symbol("phi", positive=True)
X, Y, D = sp.symbols("x y d", positive=True)
SIGNS = (1, -1)


def _forms(sigma: int) -> tuple[forms.Form, forms.Form, forms.Form]:
    net = asymptotic_net.general_net(sigma)
    calculus = net.calculus
    return (
        forms.first_form(calculus, net.r_u, net.r_v),
        forms.second_form(calculus, net.r_u, net.r_v, net.normal),
        forms.third_form(calculus, net.normal),
    )


def spherical_metric(setting: Setting, *, mixed: int = -1) -> Evidence:
    """Metric of the normal against dN.dN of the net of any angle, both signs of sigma."""
    residuals: dict[str, sp.Expr] = {}
    for sigma in SIGNS:
        net, third = asymptotic_net.general_net(sigma), _forms(sigma)[2]
        claimed = printed.spherical_metric(net.cos_phi, sigma, mixed=mixed)
        names = ("du^2", "du dv", "dv^2")
        residuals |= {
            f"{name}, sigma = {sigma:+d}": a - b
            for name, a, b in zip(names, claimed, third, strict=True)
        }
    return identities(
        setting, residuals, shown="dN.dN = du^2 - 2 sigma cos(phi) du dv + dv^2 for both sigma"
    )


def larger_curvature(setting: Setting, *, part: str = "1/2") -> Evidence:
    """Squares of both principal curvatures against the two candidates, both signs of sigma."""
    residuals = {}
    for sigma in SIGNS:
        first, second, _ = _forms(sigma)
        product = forms.determinant(second) / forms.determinant(first)
        trace = forms.twice_mean_curvature(first, second)
        a, b = printed.curvature_candidates(
            asymptotic_net.general_net(sigma).cos_phi.args[0], part=part
        )
        residuals[f"sum of squares, sigma = {sigma:+d}"] = trace**2 - 2 * product - a**2 - b**2
        residuals[f"product of squares, sigma = {sigma:+d}"] = product**2 - (a * b) ** 2
    return identities(
        setting,
        residuals,
        shown="the squares of the principal curvatures are tan^2(phi/2) and cot^2(phi/2)",
    )


def angle_range(setting: Setting, *, factor: str = "2") -> Evidence:
    """Ends of the range of phi: there, and not inside, the larger curvature is k_max."""
    k, angle = 1 + X, sp.Symbol("p", real=True)
    low, high = printed.angle_range(k, factor=factor)
    rates = {"tan": sp.diff(sp.tan(angle / 2), angle), "-cot": sp.diff(-sp.cot(angle / 2), angle)}
    return combined(
        {
            "ends": identities(
                setting,
                {
                    "cot(phi/2) at the least angle": sp.cot(low / 2) - k,
                    "tan(phi/2) at the largest angle": sp.cot((sp.pi - high) / 2) - k,
                    "symmetry": low + high - sp.pi,
                },
                shown="k_max",
            ),
            "monotone": positivity(
                setting,
                {
                    f"{name}(phi/2) grows": rate.subs(angle, 2 * sp.atan(X))
                    for name, rate in rates.items()
                },
                shown="both derivatives are positive at every phi = 2 arctan x",
            ),
        },
        shown="cot(phi/2) falls to k_max at 2 arctan(1/k_max), tan(phi/2) rises to it at the "
        "other end: both are at most k_max exactly between",
    )


def least_bound(setting: Setting, *, product: int = -1) -> Evidence:
    """Product of the principal curvatures, and what it leaves of a bound below 1."""
    residuals = {}
    for sigma in SIGNS:
        first, second, _ = _forms(sigma)
        gauss = forms.determinant(second) / forms.determinant(first)
        residuals[f"kappa_1 kappa_2, sigma = {sigma:+d}"] = gauss - product
    # kappa_1 = a <= k, |kappa_2| = 1/a <= k: k^2 >= 1.
    a = 1 / (1 + X)
    return combined(
        {
            "product": identities(setting, residuals, shown="-1"),
            "bound": positivity(
                setting,
                {"larger than 1 if the other is below 1": 1 / a - 1},
                shown="one of a, 1/a is at least 1",
            ),
        },
        shown="kappa_1 kappa_2 = -1, so the larger of |kappa_1|, |kappa_2| is at least 1",
    )


def _worst(cosine: sp.Expr, power: int) -> dict[int, sp.Expr]:
    """Smaller coefficient of G (1 + q)^(2 p) - g (1 - q)^(2 p), by the sign of cos phi.

    The form a (x^2 + y^2) + 2 b x y is at least (a - |b|) (x^2 + y^2), with equality at x = -+y.
    """
    bound = printed.distortion(cosine, power=power)
    top, bottom = sp.fraction(sp.together(bound**2))
    found = {}
    for sign in SIGNS:
        # G has -2 sign q, g has +2 sign q in front of x y; the mixed term has the sign -sign.
        diagonal, mixed = bottom - top, -sign * cosine * (bottom + top)
        found[sign] = sp.cancel(diagonal + sign * mixed)
    return found


def inner_bounds(setting: Setting, *, power: int = 1) -> Evidence:
    """Bounds on sqrt(G/g) by |cos phi| = q for all tangent vectors and both signs of cos phi."""
    q = 1 / (1 + Y)
    return positivity(
        setting,
        {f"lower bound, sign {sign:+d}": e for sign, e in _worst(q, power).items()},
        shown="G (1 + q)^2 - g (1 - q)^2 >= 2 q (1 - q^2) (w1^2 + w2^2) > 0; exchanging g and G, "
        "that is the sign of cos phi, gives the upper bound",
    )


def sharp_distortion(setting: Setting, *, half_power: int = 1) -> Evidence:
    """Sharp bounds on G/g, ((1 - q)/(1 + q))^half_power: attained at w1 = +-w2."""
    q = 1 / (1 + Y)
    bound = ((1 - q) / (1 + q)) ** half_power
    attained = (2 - 2 * q) / (2 + 2 * q)
    x = X / (1 + X)
    cosine = (1 - x**2) / (1 + x**2)
    return identities(
        setting,
        {
            "G/g at w1 = w2, sigma cos(phi) = q": bound - attained,
            "in terms of tan(phi/2)": ((1 - cosine) / (1 + cosine)) ** half_power - x**2,
        },
        shown="the extremes of sqrt(G/g) are tan(phi/2) and cot(phi/2): the bounds of (eq:BLD) are "
        "their squares, and k_max^2 may be replaced by k_max",
    )


def _cosines(x: sp.Expr) -> dict[str, sp.Expr]:
    """Values of |cos phi| for tan(phi/2) = 1/x and x, where x > 1."""
    low, high = 1 / x, x
    return {
        "phi < pi/2": sp.cancel((1 - low**2) / (1 + low**2)),
        "phi > pi/2": sp.cancel((high**2 - 1) / (high**2 + 1)),
    }


def outer_bound(setting: Setting, *, power: int = 2) -> Evidence:
    """Whether k_max^-power is at most the lower bound by |cos phi|, for angles in the range."""
    inside = {}
    for name, cosine in _cosines(1 + X).items():
        k_max = (1 + X) * (1 + D)
        inside[name] = sp.cancel(
            printed.distortion(cosine) - 1 / printed.distortion_constant(k_max, power=power)
        )
    return positivity(
        setting,
        inside,
        shown="for max(tan, cot)(phi/2) = 1 + x the bound is (1 + x)^-2 > k_max^-2, k_max larger",
    )


def outer_bound_attained(setting: Setting, *, power: int = 2) -> Evidence:
    """Whether the bound by k_max is attained at the ends of the range of phi."""
    return identities(
        setting,
        {
            name: printed.distortion(cosine) - 1 / printed.distortion_constant(1 + X, power=power)
            for name, cosine in _cosines(1 + X).items()
        },
        shown="equality at phi = 2 arctan(1/k_max) and pi minus that",
    )


def arc(setting: Setting, *, share: str = "1/6", power: int = 1, radius: int = 3) -> Evidence:
    """Length of the arc on the disk of radius `radius` delta, by sqrt(G/g) <= k_max^power."""
    k, short = 1 + X, 1 / (1 + D)
    bound = k**power * radius * short * printed.eta(k, share=share)
    return positivity(
        setting,
        {"pi/2 minus the length of the arc": sp.cancel((sp.pi / 2 - bound) / sp.pi)},
        shown="k_max * 3 delta < pi/2 for every delta < pi/(6 k_max) and every k_max > 1",
    )


def arc_at_one(setting: Setting, *, share: str = "1/6", radius: int = 3) -> Evidence:
    """The longest arc in the limit delta = eta is pi/2, whatever k_max: eta cannot be larger."""
    k = 1 + X
    length = k * radius * printed.eta(k, share=share)
    return identities(setting, {"length - pi/2": length - sp.pi / 2}, shown="k_max 3 eta = pi/2")


def hemisphere(
    setting: Setting, *, share: str = "1/6", power: int = 1, radius: int = 3
) -> Evidence:
    """Cosine of the arc: N.N_0 >= cos(k_max^power radius delta), positive below pi/2."""
    y = sp.Symbol("y", positive=True)
    half = arc(setting, share=share, power=power, radius=radius)
    # With arc = 2 arctan(t), t < 1: cosine (1 - t^2)/(1 + t^2), t = 1/(1 + y).
    t = 1 / (1 + y)
    cosine = positivity(
        setting, {"cosine": sp.cancel((1 - t**2) / (1 + t**2))}, shown="positive below pi/2"
    )
    return combined(
        {"arc": half, "cosine": cosine},
        shown="the angle of N and N_0 is at most the arc, below pi/2, so N.N_0 > 0 on B_{3 delta}",
    )


def _unit(a: sp.Symbol, b: sp.Symbol) -> sp.Matrix:
    """Unit vector by stereographic projection."""
    n = 1 + a**2 + b**2
    return sp.Matrix([2 * a / n, 2 * b / n, (1 - a**2 - b**2) / n])


def projection(setting: Setting, *, factor: int = 1) -> Evidence:
    """Whether the projected normal is at right angles to N_0, and its length."""
    a, b, c, d = sp.symbols("a b c d", real=True)
    normal, centre = _unit(a, b), _unit(c, d)
    flat = printed.projected_normal(normal, centre, factor=factor)
    return identities(
        setting,
        {
            "along N_0": flat.dot(centre),
            "squared length": flat.dot(flat) - 1 + normal.dot(centre) ** 2,
        },
        shown="the image lies in the plane normal to N_0, its squared length is 1 - (N.N_0)^2",
    )


def in_disk(setting: Setting, *, factor: int = 1) -> Evidence:
    """Whether the projected normal is shorter than 1, for normals in the open hemisphere."""
    # N_0 = e3; N = (sin a cos b, sin a sin b, cos a), cos a = z in (0, 1).
    z = 1 / (1 + X)
    normal = sp.Matrix([sp.sqrt(1 - z**2), 0, z])
    centre = sp.Matrix([0, 0, 1])
    flat = printed.projected_normal(normal, centre, factor=factor)
    room = sp.cancel(1 - flat.dot(flat))
    return positivity(
        setting, {"1 - |N_perp|^2": room}, shown="1 - |N_perp|^2 = (N.N_0)^2 > 0 in the hemisphere"
    )


def orientation(setting: Setting, *, conjugated: bool = True) -> Evidence:
    """Sign of the Jacobian of the projected, conjugated normal, both signs of sigma."""
    residuals = {}
    for sigma in SIGNS:
        net = asymptotic_net.general_net(sigma)
        n_u, n_v = net.d(net.normal, "u"), net.d(net.normal, "v")
        calculus = net.calculus
        turned, area = calculus.cross(n_u, n_v), calculus.cross(net.r_u, net.r_v)
        total = added(turned, area) if conjugated else added(turned, (-area[0], -area[1], -area[2]))
        residuals[f"N_u x N_v, sigma = {sigma:+d}"] = total
    a, b = (sp.Matrix(sp.symbols(f"{n}:3", real=True)) for n in "ab")
    centre = sp.Matrix([0, 0, 1])
    flat = [printed.projected_normal(w, centre) for w in (a, b)]
    residuals["projected area"] = (
        flat[0][0] * flat[1][1] - flat[0][1] * flat[1][0] - a.cross(b).dot(centre)
    )
    return identities(
        setting,
        residuals,
        shown="N_u x N_v = -r_u x r_v, so N reverses orientation, conjugation reverses it again, "
        "and the projection multiplies areas by N.N_0 > 0",
    )


def one_derivative(setting: Setting, *, power: int = 3) -> Evidence:
    """Derivative of the normal of z = sign(x) |x|^power at x = 0 from both sides.

    power 3: of class C^2, not C^3; power 2: of class C^{1,1} only.
    """
    x = sp.Symbol("x", real=True)
    sides = []
    for sign in (1, -1):
        height = sign * (sign * x) ** power
        slope = sp.diff(height, x)
        normal = sp.Matrix([-slope, 1]) / sp.sqrt(1 + slope**2)
        flat = printed.projected_normal(normal, sp.Matrix([0, 1]))
        sides.append(sp.diff(flat, x).subs(x, 0))
    return identities(
        setting,
        {"jump of the derivative": list(sides[0] - sides[1])},
        shown="the normal of a C^2 surface is made of first derivatives, so it is C^1; at the edge "
        "of C^2 its derivative is continuous, for a C^{1,1} surface it jumps",
    )


def definition(setting: Setting, *, constant: str = "2", oriented: bool = True) -> Evidence:
    """An instance of an L-BLD map with L = 2, and three near-misses."""
    del setting
    bound = sp.Rational(constant)
    cases = {
        "diag(2, 1/2)": (sp.diag(2, sp.Rational(1, 2)), True),
        "diag(2, 49/100)": (sp.diag(2, sp.Rational(49, 100)), False),
        "diag(201/100, 1/2)": (sp.diag(sp.Rational(201, 100), sp.Rational(1, 2)), False),
        "diag(2, -1/2)": (sp.diag(2, -sp.Rational(1, 2)), False),
    }
    wrong = [
        name
        for name, (matrix, expected) in cases.items()
        if printed.is_bounded_distortion(matrix, bound, oriented=oriented) is not expected
    ]
    return statement(
        not wrong,
        shown="diag(2, 1/2) is 2-BLD; a shorter, a longer and a reflected axis are refused",
        witness=f"L = {constant}: {', '.join(wrong)}",
    )


def coframe(setting: Setting, *, product: int = -1) -> Evidence:
    """Whether du and dv are closed, with principal curvatures tan(phi/2), product cot(phi/2).

    product: of the principal curvatures; only for -1 are both closed.
    """
    half = asymptotic_coframe.H
    first, second = sp.tan(half), product * sp.cot(half)
    residuals = {
        f"d({name})": asymptotic_coframe.exterior(factors, first, second)
        for name, factors in asymptotic_coframe.asymptotic_coframe().items()
    }
    names = ("du^2", "du dv", "dv^2")
    wanted = (1, sp.cos(2 * half), 1)
    residuals |= {
        name: a - b for name, a, b in zip(names, asymptotic_coframe.metric(), wanted, strict=True)
    }
    return identities(
        setting,
        residuals,
        shown="du and dv are closed by the equations of Codazzi, so on a ball they are the "
        "differentials of functions u, v, with du ^ dv never 0 and g = du^2 + 2 cos(phi) du dv + "
        "dv^2; that (u, v) is one-to-one on the ball is not shown, and not used",
    )
