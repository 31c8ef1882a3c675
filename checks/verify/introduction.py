"""The informal statements of the introduction that can be decided as they are worded."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import introduction as printed
from theory import hyperbolic_plane, star_saddle, tangent_curves
from theory.amsler import chebyshev_metric
from theory.bobbin import KAPPA, THETA, S, bobbin, largest_on_disk, squared_curvatures
from theory.curvature import intrinsic_curvature
from theory.sectors import count_sectors
from theory.surface_of_revolution import first_form

U, V = sp.symbols("u v", real=True)
PHI = sp.Function("phi")(U, V)


def regular_sectors(setting: Setting, *, per_order: int = 2, curvature: int = -1) -> Evidence:
    """Sectors of quadratic forms whose determinant has the sign of the curvature."""
    forms = {
        -1: ((1, 0, -1), (2, 3, 4), (0, 1, 3)),
        0: ((1, 2, 4),),
        1: ((1, 0, 1), (2, 1, 1)),
    }[curvature]
    claimed = printed.sectors(2, per_order=per_order)
    wrong = []
    for form in forms:
        above, below = count_sectors(tuple(sp.Integer(k) for k in form))
        if (above, below) != (claimed // 2, claimed // 2):
            wrong.append(f"{form} has {above} sectors above and {below} below")
    return statement(
        not wrong,
        shown="three forms of negative determinant are positive on two sectors and negative on "
        "two; by Sylvester's law of inertia a linear map takes any such form to any other",
        witness=f"expected {claimed} sectors: {'; '.join(wrong)}",
    )


def branch_sectors(setting: Setting, *, per_order: int = 2, smallest: int = 3) -> Evidence:
    """Sectors of the quadratic saddles over regular stars, counted by the sign of the height."""
    wrong = []
    for order in (*range(smallest, 5), 6):
        above, below = star_saddle.count_sides(star_saddle.regular_star(order))
        claimed = printed.sectors(order, per_order=per_order)
        if above + below != claimed or above != below or above + below <= 4:
            wrong.append(f"order {order}: {above} sectors above, {below} below")
    return statement(
        not wrong,
        shown="the saddles of order 3, 4 and 6 have 2m > 4 sectors, half above the tangent plane",
        witness="; ".join(wrong),
    )


def rigidity(setting: Setting, *, reading: str = "sectors", smooth_sectors: int = 4) -> Evidence:
    """Isometric immersions of one metric, by what the word rigid is to mean.

    reading: `sectors` for a fixed number of sectors, `unique` for determined by the metric;
    smooth_sectors: that number for C^2 surfaces.
    """
    if reading == "unique":
        e, _, g = first_form(bobbin(), THETA)
        tau = sp.Symbol("tau")
        in_tau = (e, g * sp.diff(KAPPA * tau, tau) ** 2)
        throat = sp.simplify(squared_curvatures()[1].subs(S, 0))
        same = all(entry.diff(KAPPA) == 0 for entry in map(sp.simplify, in_tau))
        return statement(
            not (same and sp.diff(throat, KAPPA) != 0),
            shown="",
            witness="with theta = kappa tau the bobbins all have the metric ds^2 + cosh^2(s) "
            f"d tau^2 near their throat, whose squared curvature {throat} differs with kappa",
        )
    smooth = regular_sectors(setting, per_order=smooth_sectors // 2)
    branched = branch_sectors(setting)
    return combined(
        {"C^2": smooth, "C^{1,1}": branched},
        shown="at every point a C^2 surface with K < 0 has 4 sectors, whatever the metric; a "
        "C^{1,1} one can have any even number from 4 on",
    )


def bounded_discontinuous(setting: Setting, *, order: int = 3, degree: int = 2) -> Evidence:
    """Second derivatives of a saddle over a star, homogeneous of this degree, near the centre.

    Along a ray at distance r they scale like r^(degree - 2).
    """
    r = sp.Symbol("r", positive=True)
    angles = star_saddle.regular_star(order)
    sizes = [star_saddle.hessian_jump(angles, i) for i in range(len(angles))]
    limit = sp.limit(r ** (degree - 2), r, 0)
    return statement(
        limit == 1 and any(size != 0 for size in sizes),
        shown="the quadratic monkey saddle has bounded second derivatives that jump: it is C^{1,1} "
        "and its curvature is not continuous",
        witness=f"with order {order} and degree {degree} the second derivatives "
        f"{'do not jump' if limit == 1 else 'behave like r^' + str(degree - 2)}",
    )


def balance(setting: Setting, *, ratio: int = 1, weight: int = 1) -> Evidence:
    """Minimum over k of k^2 + weight/k^2 and of the larger of k and 1/k, where K = -1.

    ratio: the claimed quotient of the principal curvatures in size at the minimum.
    """
    k, t = sp.symbols("k t", positive=True)
    bending = k**2 + weight / k**2
    (best,) = sp.solve(sp.diff(bending, k), k)
    beyond = bending.subs(k, best * (1 + t)) - bending.subs(k, best)
    short = bending.subs(k, best / (1 + t)) - bending.subs(k, best)
    growing = all(
        c >= 0
        for part in (beyond, short)
        for c in sp.Poly(sp.expand(sp.fraction(sp.together(part))[0]), t).coeffs()
    )
    phi = sp.pi / 2
    return combined(
        {
            "bending": statement(growing, shown="", witness="no minimum at the stationary point"),
            "quotient": identities(setting, {"quotient - ratio": best**2 - ratio}, shown=""),
            "maximum": identities(
                setting,
                {"larger curvature at best/(1 + t)": 1 / (best / (1 + t)) - best * (1 + t)},
                shown="",
            ),
            "not everywhere": statement(
                printed.sine_gordon(phi) != 0,
                shown="",
                witness="phi = pi/2 would solve the sine-Gordon equation",
            ),
        },
        shown="both energies are least where the principal curvatures have the same size, phi = "
        "pi/2; the sine-Gordon equation excludes this on an open set, so it is approximate",
    )


def mean_against_maximum(
    setting: Setting, *, quantity: str = "mean", absolute: bool = True
) -> Evidence:
    """Whether |H| grows with the larger principal curvature k >= 1 in size.

    The derivative in k = 1 + t, written as a quotient of polynomials with coefficients >= 0.
    """
    t = sp.Symbol("t", nonnegative=True)
    k = sp.Symbol("k", positive=True)
    slope = sp.diff(printed.objective(k, quantity=quantity, absolute=absolute), k).subs(k, 1 + t)
    top, bottom = (sp.Poly(sp.expand(part), t) for part in sp.fraction(sp.together(slope)))
    positive = all(c >= 0 for c in top.coeffs() + bottom.coeffs()) and not top.is_zero
    return statement(
        positive,
        shown="2 |H| = k - 1/k increases strictly with k = max(|kappa_1|, |kappa_2|) >= 1, so that "
        "the two min-max problems have the same minimisers",
        witness=f"the derivative in k = 1 + t is {sp.factor(slope)}, at t = 1 {slope.subs(t, 1)}",
    )


def sine_gordon(setting: Setting, *, sign: int = 1, factor: int = 1, sigma: int = 1) -> Evidence:
    """Gauss curvature of the metric of unit-speed asymptotic lines under the printed equation."""
    metric = chebyshev_metric(PHI, sigma=sigma)
    curvature = intrinsic_curvature(metric, (U, V))
    value = curvature.subs(sp.diff(PHI, U, V), printed.sine_gordon(PHI, sign=sign, factor=factor))
    return identities(
        setting,
        {"K + 1": value + 1},
        shown="where phi is the angle from r_u to r_v, phi_uv = sin phi is K = -1",
    )


def branched_smooth(
    setting: Setting, *, orientation: str = "surface", denominator: int = 2, sign_u: int = -1
) -> Evidence:
    """Generalised equation where there is no branch point, by Stokes, for both sigma.

    With K the curvature of the metric of asymptotic lines, the boundary form has the differential
    -K sin phi du dv whatever phi is. orientation: of the boundary, `surface` for that of omega =
    sigma du dv, `coordinates` for that of du dv.
    """
    residuals = {}
    for sigma in (1, -1):
        curvature = intrinsic_curvature(chebyshev_metric(PHI, sigma=sigma), (U, V))
        along_u, along_v = printed.boundary_form(
            sp.diff(PHI, U), sp.diff(PHI, V), denominator=denominator, sign_u=sign_u
        )
        stokes = sp.diff(along_v, U) - sp.diff(along_u, V)
        turn = sigma if orientation == "surface" else 1
        area = printed.area_integrand(PHI)
        residuals[f"sigma = {sigma}"] = turn * stokes + curvature * area
    return identities(
        setting,
        residuals,
        shown="with the boundary oriented by omega, K = -1 makes the boundary integral the area, "
        "for both signs of sigma",
    )


_STARS: tuple[tuple[Any, ...], ...] = (
    star_saddle.regular_star(3),
    star_saddle.regular_star(5),
    tuple(sp.pi * sp.Rational(k, 12) for k in (2, 5, 3, 4, 6, 4)),
    tuple(sp.pi * sp.Rational(k, 12) for k in (2, 5, 9, 8)),
)


def branched_star(
    setting: Setting, *, jumps: bool = False, sign: int = -1, regular: int = 2, denominator: int = 2
) -> Evidence:
    """Generalised equation on a star that shrinks to its centre: only the centre is left.

    jumps: whether the jumps of phi across the rays belong to the boundary integral; its other
    part and the area tend to 0.
    """
    residuals = {}
    for n, angles in enumerate(_STARS):
        phi = star_saddle.asymptotic_angles(angles)
        steps = [phi[i] - phi[i - 1] for i in range(len(phi))]
        total = sum((1 if i % 2 == 0 else -1) * step for i, step in enumerate(steps))
        left = sp.sympify(total) / denominator if jumps else sp.Integer(0)
        right = printed.correction(len(angles) // 2, sign=sign, regular=regular)
        residuals[f"star {n} of order {len(angles) // 2}"] = left - right
    return identities(
        setting,
        residuals,
        shown="the jumps of phi across the rays of a star of order m contribute -pi (m - 2)",
    )


def charge(setting: Setting, *, reading: str = "excess", regular: int = 2) -> Evidence:
    """Charges whose sum times -pi is the correction, from the winding number of the normal."""
    residuals = {}
    for n, angles in enumerate(_STARS):
        index = star_saddle.winding_number(angles)
        correction = printed.correction(len(angles) // 2, regular=regular)
        residuals[f"star {n} of order {len(angles) // 2}"] = correction + sp.pi * printed.charge(
            index, reading=reading
        )
    return identities(
        setting,
        residuals,
        shown="the correction of a point is -pi times -(1 + J_p), which is 0 at a regular point",
    )


def index(setting: Setting, *, offset: int = 1, slope: int = -1) -> Evidence:
    """Winding number of the normal of the quadratic saddles over four stars.

    The direction of the gradient on a ray is confirmed for sectors of arbitrary angles a, b.
    """
    arbitrary = sp.symbols("a b", positive=True)
    residuals: dict[str, Any] = {
        f"gradient on ray {i}": star_saddle.sector_hessian(arbitrary, i)
        * star_saddle.direction(star_saddle.ray_angle(arbitrary, i))
        - star_saddle.direction(star_saddle.gradient_angle(arbitrary, i))
        for i in (0, 1)
    }
    # Up to whole turns both sectors turn the gradient by their angle less pi.
    residuals |= {
        f"turning on sector {i}": star_saddle.gradient_angle(arbitrary, i + 1)
        - star_saddle.gradient_angle(arbitrary, i)
        - (arbitrary[i] - sp.pi)
        - 2 * sp.pi * (1 - i)
        for i in (0, 1)
    }
    residuals |= {
        f"star {n}": star_saddle.winding_number(angles) - (offset + slope * len(angles) // 2)
        for n, angles in enumerate(_STARS)
    }
    return identities(
        setting,
        residuals,
        shown="a sector of angle a turns the gradient by a - pi, and the 2m angles add up to 2 pi: "
        "the index is 1 - m, -1 at regular points and below at branch points",
    )


_QUARTERS = tuple(sp.pi * sp.Rational(k, 2) for k in range(4))


def assembly(
    setting: Setting,
    *,
    osculating: bool = False,
    cyclic: bool = False,
    alternating: bool = True,
    gap: int = 3,
) -> Evidence:
    """Curves through a point with torsions 1 and -1, and what they ask of a surface there.

    osculating: whether the osculating planes must be the common plane; cyclic: whether the
    tangents must follow each other round the point with gaps below pi; alternating: whether the
    torsions must alternate. gap: the tangents are else at 0, 1, 2 and gap quarters of a half-turn.
    """
    tilts = [0, 0, 0, 0] if osculating else [1, -1, 1, -1]
    rises = [tangent_curves.rise(sp.Integer(2), sp.pi * sp.Rational(k, 2)) for k in tilts]
    angle = sp.Symbol("a", positive=True)
    rays = _QUARTERS if cyclic else tuple(sp.pi * sp.Rational(k, 4) for k in (0, 1, 2, gap))
    height = sp.tan(angle / 2) / 2 - tangent_curves.largest_height(angle)
    parts = {
        "largest height in a sector": identities(setting, {"height": height}, shown=""),
        "room": _room(tangent_curves.total_angle_needed(rises)),
    }
    if osculating:
        torsions = (-1, 1) if alternating else (-1, -1)
        parts["sectors"] = _star_through(rays)
        parts["corners"] = identities(
            setting, tangent_curves.corner_residuals(angle, torsions), shown=""
        )
    return combined(
        parts,
        shown="curves whose tangents follow each other with gaps below pi are the rays of a "
        "quadratic saddle, and their Frenet frames are data for the Lelieuvre formulae in each "
        "sector, consistent at the corner; that these have a solution see (prop:assembly)",
    )


def _room(needed: Any) -> Evidence:
    """Whether sectors of these least angles, their sum being needed, fit round a point."""
    return statement(
        bool(needed < 2 * sp.pi),
        shown="",
        witness="four curves of curvature 2, torsions 1, -1, 1, -1, tangents at 0, pi/2, pi, "
        "3 pi/2, osculating planes normal to the common plane, bending up, down, up, down: "
        f"they lie in four sectors, which need angles of sum {sp.N(needed, 5)} > 2 pi",
    )


def _star_through(rays: tuple[Any, ...]) -> Evidence:
    """Whether the quadratic saddle with these rays has sectors of angles below pi and is C^1."""
    angles = [(b - a) % (2 * sp.pi) for a, b in zip(rays, [*rays[1:], rays[0]], strict=True)]
    wide = [angle for angle in angles if not angle < sp.pi]
    above, below = star_saddle.count_sides(angles)
    smooth = all(
        entry == 0 for i in range(len(angles)) for entry in star_saddle.gradient_jump(angles, i)
    )
    return statement(
        not wide and smooth and (above, below) == (2, 2),
        shown="",
        witness=f"the tangents leave a gap {wide} of pi or more, that no sector can fill",
    )


def bending_growth(setting: Setting, *, growth: str = "root") -> Evidence:
    """Bounds of the least bending energy of a disk of radius R, branched or not.

    Below: kappa_1^2 + kappa_2^2 >= 2 |K| = 2, times the area. Above: a disk in the cover of the
    bobbin of throat curvature k = cosh R, where it is at most k^2 + 1/k^2.
    """
    r = sp.Symbol("R", positive=True)
    k = sp.Symbol("k", positive=True)
    excess = sp.factor(k**2 + 1 / k**2 - 2 - (k - 1 / k) ** 2)
    claimed = printed.energy_growth(r, growth=growth)
    ends = largest_on_disk(sp.cosh(r), sp.Integer(0), r)
    below, above = _limits_of_bounds(r)
    quotient = sp.limit(r / claimed, r, sp.oo)
    return combined(
        {
            "density": identities(setting, {"k^2 + k^-2 - 2 - (k - 1/k)^2": excess}, shown=""),
            "bobbin": identities(
                setting,
                {"largest curvatures": [k_max - sp.cosh(r) ** 2 for k_max in ends]},
                shown="",
            ),
            "exponents": statement(
                all(bool(0 < bound < sp.oo) for bound in (below, above)),
                shown="",
                witness=f"the bounds over exp(R) and exp(3R) tend to {below} and {above}",
            ),
            "growth": statement(
                bool(quotient > 0) and bool(quotient < sp.oo),
                shown="",
                witness="2 area = 4 pi (cosh R - 1) <= inf E_2 <= C exp(3R), so that log inf E_2 "
                f"grows like R, and R/({claimed}) tends to {quotient}",
            ),
        },
        shown="the least bending energy of a disk, over branched or over smooth immersions, lies "
        "between 4 pi (cosh R - 1) and 2 pi (cosh R - 1)(cosh^2 R + 1/cosh^2 R)",
    )


def _limits_of_bounds(radius: sp.Symbol) -> tuple[Any, Any]:
    """Limits of twice the area over exp(R), and of area (cosh^2 R + 1/cosh^2 R) over exp(3R)."""
    e = sp.Symbol("e", positive=True)
    size = sp.cancel(hyperbolic_plane.area(radius).rewrite(sp.exp).subs(radius, sp.log(e)))
    cosh = (e + 1 / e) / 2
    worst = size * (cosh**2 + 1 / cosh**2)
    return sp.limit(sp.cancel(2 * size / e), e, sp.oo), sp.limit(sp.cancel(worst / e**3), e, sp.oo)


def star_centres(setting: Setting, *, per_order: int = 2, smallest: int = 2) -> Evidence:
    """Count the sectors at the centres of the regular stars of order smallest to 4, and 6."""
    return branch_sectors(setting, per_order=per_order, smallest=smallest)
