"""Bounds between the energies of isometries of section 2, and their singular edges."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import elasticity as plates
from checks.printed import isometries as printed
from checks.verify.closed_forms import sign
from theory import bobbin, curvature, singular_edge, weak_hessian

X, Y = sp.symbols("x y", real=True)
EXCESS = sp.Symbol("x", nonnegative=True)


def max_curvature(setting: Setting, *, absolute: bool = True) -> Evidence:
    """Whether E_infty is the largest normal curvature |h(v, v)| over unit vectors v.

    Normal curvature is kappa_1 c + kappa_2 (1 - c), c = cos^2 of the angle to a principal
    direction, linear in c; the shape operator is that of an asymptotic net of angle phi.
    """
    t = sp.Symbol("t", positive=True)
    residuals = {}
    for value in ("1/3", "1", "3"):
        first, second = (m.subs(t, sp.Rational(value)) for m in curvature.asymptotic_forms(t))
        pair = list(curvature.shape_operator(first, second).eigenvals())
        # |A| = sqrt of the largest eigenvalue of A^2, here rational.
        squares = (curvature.shape_operator(first, second) ** 2).eigenvals()
        largest = sp.sqrt(max(squares))
        residuals[f"tan(phi/2) = {value}"] = (
            printed.max_curvature(*pair, absolute=absolute) - largest
        )
    return identities(
        setting,
        residuals,
        shown="max(|kappa_1|, |kappa_2|) is the norm of the shape operator at angles on both sides "
        "of a right angle",
    )


def _strip(kappa: sp.Expr, sinh_length: sp.Expr, angle: sp.Expr) -> dict[str, sp.Expr]:
    """Area, E_2 and E_infty^2 of the part |sinh s| < sinh_length of a bobbin, of this angle."""
    y = sp.Symbol("y", real=True)
    density = bobbin.bending_density(y).subs(bobbin.KAPPA, kappa)
    squares = bobbin.largest_on_disk(kappa, 0, sp.asinh(sinh_length))
    return {
        "area": 2 * angle * sinh_length / kappa,
        "willmore": 2 * angle * sp.integrate(sp.apart(density, y), (y, 0, sinh_length)),
        "max squared": max(squares),
    }


def willmore_bound(setting: Setting, *, factor: str = "1", area_power: int = 0) -> Evidence:
    """Whether E_2 <= factor |Omega|^area_power E_infty^2.

    On a strip of the bobbin kappa = 1; and, where the area enters to the first power, pointwise:
    kappa_1^2 + kappa_2^2 = m^2 + m^-2 <= factor m^2 for every m = 1 + x >= 1.
    """
    strip = _strip(sp.Integer(1), sp.S.Half, 2 * sp.pi)
    right = printed.willmore_bound(
        strip["max squared"], strip["area"], factor=factor, area_power=area_power
    )
    shown = "kappa_1^2 + kappa_2^2 <= 2 max^2 at every point, so E_2 <= 2 |Omega| E_infty^2"
    parts = {
        "strip |sinh s| < 1/2 of the bobbin kappa = 1": statement(
            sign(right - strip["willmore"]) >= 0,
            shown=shown,
            witness=f"E_2 = {sp.N(strip['willmore'], 6)} > {sp.N(right, 6)}, with E_infty^2 = "
            f"{strip['max squared']} and area {strip['area']}",
        )
    }
    if area_power == 1:
        m = 1 + EXCESS
        margin = sp.Poly(sp.expand((sp.Rational(factor) - 1) * m**4 - 1), EXCESS)
        # m^2 + m^-2 grows from m to n, so its largest value is that at E_infty.
        n = m + Y
        growth = sp.Poly(sp.expand((n**4 + 1) * m**2 - (m**4 + 1) * n**2), EXCESS, Y)
        parts["pointwise"] = statement(
            all(c >= 0 for c in margin.all_coeffs()),
            shown=shown,
            witness=f"at kappa_1 = 1, kappa_2 = -1 the sum of squares is 2 > {factor}",
        )
        parts["growth"] = statement(
            all(c >= 0 for c in growth.coeffs()), shown=shown, witness="m^2 + m^-2 does not grow"
        )
    return combined(parts, shown=shown)


def finite_willmore(setting: Setting, *, area: str = "finite") -> Evidence:
    """Whether finite E_infty gives finite E_2, on strips of the bobbin kappa = 1.

    area: `finite`, or `infinite` where the strip winds about the axis without end.
    """
    angle = sp.Symbol("angle", positive=True)
    strip = _strip(sp.Integer(1), sp.S.Half, angle)
    turns = {"finite": 2 * sp.pi, "infinite": sp.oo}[area]
    willmore = sp.limit(strip["willmore"], angle, turns)
    bound = sp.limit(
        printed.willmore_bound(strip["max squared"], strip["area"], factor="2", area_power=1),
        angle,
        turns,
    )
    return statement(
        bool(willmore.is_finite) and bool(bound.is_finite) and sign(bound - willmore) >= 0,
        shown="E_2 <= 2 |Omega| E_infty^2 is finite on a strip of finite area",
        witness=f"E_infty^2 = {strip['max squared']}, but E_2 = {willmore} on a strip of infinite "
        "area",
    )


def curvature_product(setting: Setting, *, surface: str = "C11", product: str = "-1") -> Evidence:
    """Whether K = -1 means kappa_1 kappa_2 = -1 a.e., also where the surface is only C^1,1.

    Smooth: the product is the curvature of the metric on every graph. C^1,1: on six saddles joined
    around a branch point, the very weak determinant of the Hessian, which the metric determines,
    is the pointwise one. surface: `crease` joins two saddles along an edge instead.
    """
    r = (X, Y, sp.Function("w")(X, Y))
    first, second = curvature.first_form(r, (X, Y)), curvature.second_form(r, (X, Y))
    gauss = curvature.shape_operator(first, second).det()
    rays = ((1, 0), (1, 1), (-1, 1), (-1, 0), (-1, -1), (1, -1))
    pieces = {
        "C11": weak_hessian.sector_saddle(rays),
        "crease": weak_hessian.creased_saddle(),
    }[surface]
    bump = ((1 - weak_hessian.X**2) * (1 - weak_hessian.Y**2)) ** 2
    residuals: dict[str, sp.Expr] = {
        "smooth graph": gauss - curvature.intrinsic_curvature(first, (X, Y)),
    }
    for value in sorted(weak_hessian.pointwise_determinants(pieces)):
        residuals[f"pointwise determinant {value}"] = value - sp.Rational(product)
    for name, test in (("even", bump), ("skew", bump * (1 + weak_hessian.X))):
        total = sum(weak_hessian.triangle_integral(test, p.corners) for p in pieces)
        weak = weak_hessian.weak_determinant(pieces, test)
        residuals[f"{name} test function"] = weak - sp.Rational(product) * total
    return identities(
        setting,
        residuals,
        shown="det h / det g = K[g] on graphs, and at a branch point of order 3 the determinant "
        "holds no part beside its pointwise value -1",
    )


def curvature_inequality(
    setting: Setting, *, scale: str = "1", offset: str = "1", product: str = "-1"
) -> Evidence:
    """Whether scale 2|H| <= max(|kappa_1|, |kappa_2|) <= 2|H| + offset for this product.

    With m = max = 1 + x and product -1, 2|H| = m - 1/m; both differences, times m, are polynomials
    in x whose coefficients must not be negative. Elsewhere sampled at rational m >= 1.
    """
    rational = sp.Rational(product)

    def differences(m: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        mean = abs(m + rational / m) / 2 if m.is_number else (m + rational / m) / 2
        lower, upper = printed.curvature_bounds(mean, scale=scale, offset=offset)
        return m - lower, upper - m

    shown = "m - 2|H| = 1/m >= 0 and 2|H| + 1 - m = 1 - 1/m >= 0, an equality where kappa = 1, -1"
    for sample in (sp.Integer(n) for n in (1, 2, 3, 10, 1000)):
        if sample**2 >= abs(rational) and any(d < 0 for d in differences(sample)):
            values = ", ".join(str(d) for d in differences(sample))
            witness = f"kappa = {sample}, {rational / sample}: the two differences are {values}"
            return statement(False, shown=shown, witness=witness)
    m = 1 + EXCESS
    polynomials = [sp.Poly(sp.cancel(d * m), EXCESS) for d in differences(m)]
    proved = rational == -1 and all(c >= 0 for p in polynomials for c in p.all_coeffs())
    if not proved:
        return Evidence(outcome="undecided", grade="exact", shown="no proof and no witness found")
    return statement(True, shown=shown, witness="")


def _nonnegative(polynomial: sp.Poly, *, shown: str) -> Evidence:
    """Evidence that a polynomial in EXCESS is >= 0 there, by its coefficients or a sample."""
    if all(c >= 0 for c in polynomial.all_coeffs()):
        return statement(True, shown=shown, witness="")
    for place in (0, 1, 10, 1000):
        if (value := polynomial.eval(place)) < 0:
            witness = f"{polynomial.as_expr()} is {value} at x = {place}, curvature 1 + x"
            return statement(False, shown=shown, witness=witness)
    return Evidence(outcome="undecided", grade="exact", shown="no proof and no witness found")


def max_mean_equivalent(setting: Setting, *, factor: str = "2", product: str = "-1") -> Evidence:
    """Whether E_infty = |H| + sqrt(H^2 + 1), which grows with |H|, and is 0 to 1 above factor |H|.

    At curvatures m = 1 + x and product / m, x >= 0. As the function grows, the same holds between
    the largest values on a surface.
    """
    m = 1 + EXCESS
    mean = plates.mean_curvature(m, sp.Rational(product) / m)
    # m - H >= 0 and (m - H)^2 = H^2 + 1 together mean that m = H + sqrt(H^2 + 1).
    above = sp.Poly(sp.cancel(2 * m * (m - mean)), EXCESS)
    rate = sp.Poly(sp.cancel(2 * m**2 * mean.diff(EXCESS)), EXCESS)
    gap = m - printed.max_mean_energy(mean, factor=factor)
    lower, upper = (sp.Poly(sp.cancel(m * d), EXCESS) for d in (gap, 1 - gap))
    shown = "E_infty = |H| + sqrt(H^2 + 1) grows with |H|, and 0 <= E_infty - 2 |H| <= 1"
    signs = {"branch": above, "growth": rate, "gap from below": lower, "gap from above": upper}
    parts = {name: _nonnegative(polynomial, shown=shown) for name, polynomial in signs.items()}
    parts["closed form"] = identities(
        setting, {"(E - |H|)^2 - H^2 - 1": (m - mean) ** 2 - mean**2 - 1}, shown=shown
    )
    return combined(parts, shown=shown)


def cuspidal_edge(setting: Setting, *, point: str = "edge") -> Evidence:
    """Whether the bobbin and the pseudosphere have cuspidal edges, by the criterion for fronts.

    point: the `throat` of the bobbin, or the apex of a `cone` of curvature -1, in its place.
    """
    germs = {
        "edge": (
            (singular_edge.bobbin(), sp.pi / 2, "along"),
            (singular_edge.pseudosphere(), sp.pi / 2, "along"),
        ),
        "throat": ((singular_edge.bobbin(), sp.Integer(0), "along"),),
        "cone": ((singular_edge.cone(), sp.Integer(0), "around"),),
    }[point]
    shown = "lambda = 0, df(eta) = 0, d lambda(eta) = 1 and |dN(eta)| = 1 on both edges"
    parts = {}
    for number, (front, tau, null) in enumerate(germs):
        found = singular_edge.edge_invariants(front, tau, null)
        expected = {"area density": 0, "rate": 1, "step": 0, "turn of the normal": 1}
        parts[f"germ {number}"] = identities(
            setting, {name: found[name] - value for name, value in expected.items()}, shown=shown
        )
    return combined(parts, shown=shown)


def edge_curvatures(setting: Setting, *, diverging: int = 1, where: str = "edge") -> Evidence:
    """Whether this many principal curvatures diverge at the edge of the bobbin.

    By the forms of the bobbin, in y = sinh s -> kappa, and by the angle of an asymptotic net,
    phi -> pi. where: `throat` takes y -> 0 and phi -> pi/2 instead.
    """
    y, phi = sp.symbols("y phi", positive=True)
    squares = [
        sp.sympify(value).subs(bobbin.S, sp.asinh(y)) for value in bobbin.squared_curvatures()
    ]
    end = {"edge": (bobbin.KAPPA, sp.pi), "throat": (sp.Integer(0), sp.pi / 2)}[where]
    side = {"edge": "-", "throat": "+"}[where]
    limits = [sp.limit(value, y, end[0], side) for value in squares]
    angles = [sp.limit(value, phi, end[1], side) for value in curvature.principal_curvatures(phi)]
    shown = "one principal curvature tends to infinity at the edge, the other to 0"
    counts = {
        "forms of the bobbin": sum(value.is_infinite is True for value in limits),
        "angle of the net": sum(value.is_infinite is True for value in angles),
    }
    found = {
        name: statement(count == diverging, shown=shown, witness=f"{count} of them diverge")
        for name, count in counts.items()
    }
    found["product"] = identities(
        setting, {"product of the squares": squares[0] * squares[1] - 1}, shown=shown
    )
    return combined(found, shown=shown)


def edge_willmore(setting: Setting, *, power: str = "2") -> Evidence:
    """Whether the integral of |kappa|^power diverges at the edge of the bobbin, per unit angle.

    The integrand in y = sinh s behaves as (kappa - y)^-b with b found as a limit, and b >= 1
    diverges. For power 2 also for any angle that is Lipschitz and vanishes at an edge.
    """
    y, phi = sp.symbols("y phi", positive=True)
    square = sp.sympify(bobbin.squared_curvatures()[0]).subs(bobbin.S, sp.asinh(y))
    exponent = sp.Rational(power) / 2
    rate = sp.limit((bobbin.KAPPA - y) * square, y, bobbin.KAPPA, "-")
    shown = (
        "the square of the longitudinal curvature is c / (kappa - y) near the edge, whose integral "
        "is infinite; so is that of cot^2(phi/2) sin(phi) down to any edge where phi is Lipschitz"
    )
    # 4 log sin(phi/2) - 2 sin^2(phi/2) is the integral of cot^2(phi/2) sin(phi).
    primitive = 4 * sp.log(sp.sin(phi / 2)) - 2 * sp.sin(phi / 2) ** 2
    slope = primitive.diff(phi) - sp.cot(phi / 2) ** 2 * sp.sin(phi)
    return combined(
        {
            "rate": statement(
                bool(rate.is_positive) and bool(rate.is_finite), shown=shown, witness=f"rate {rate}"
            ),
            "primitive": identities(setting, {"derivative of the primitive": slope}, shown=shown),
            "any angle": statement(
                sp.limit(primitive, phi, 0, "+") == -sp.oo, shown=shown, witness="finite primitive"
            ),
            "bobbin": statement(
                exponent >= 1,
                shown=shown,
                witness=f"the integrand is O((kappa - y)^-{exponent}), which is integrable",
            ),
        },
        shown=shown,
    )
