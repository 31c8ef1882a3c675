"""J_p = 1 - m_p and the turning of the normal from ray to ray of a saddle (section 3.3)."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import normal_map as printed
from theory import star_normal, star_saddle
from theory.asymptotic_net import general_net
from theory.fronts import at_azimuth_0, front_rates, generic_normal
from theory.vectors import added, cross, derivative, dot, scaled

PI = sp.pi


def _star(*shares: str) -> tuple[Any, ...]:
    """Angles of a star from its shares of pi, of sum 2."""
    return tuple(sp.Rational(share) * PI for share in shares)


#: Regular stars, kinked ones, and stars near the edge of the hypotheses.
STARS: dict[str, tuple[Any, ...]] = {
    **{f"regular, m = {m}": star_saddle.regular_star(m) for m in (2, 3, 4, 5, 6)},
    "kinked, m = 2": _star("1/3", "1/2", "3/4", "5/12"),
    "smooth, m = 2": _star("1/3", "2/3", "1/3", "2/3"),
    "thin, m = 2": _star("99/100", "99/100", "1/100", "1/100"),
    "irregular, m = 3": _star("1/6", "1/3", "1/2", "1/4", "5/12", "1/3"),
    "thin, m = 3": _star("9/10", "1/20", "9/10", "1/20", "1/20", "1/20"),
    "irregular, m = 4": _star("1/8", "3/8", "1/8", "3/8", "1/5", "3/10", "1/7", "5/14"),
}


def normal_derivatives(setting: Setting, *, u_sign: int = 1, v_sign: int = -1) -> Evidence:
    """N_u and N_v from (eq:lelieuvre), for an arbitrary unit normal."""
    normal = generic_normal()
    r_u, r_v = front_rates(normal)
    found = printed.normal_rates(normal, r_u, r_v, u_sign=u_sign, v_sign=v_sign)
    return identities(
        setting,
        {
            f"N_{along} - printed": at_azimuth_0(
                added(derivative(normal, symbol), scaled(-1, rate))
            )
            for along, symbol, rate in zip("uv", sp.symbols("u v", real=True), found, strict=True)
        },
        shown="N x (N_u x N) = N_u for every unit normal, hence N_u = N x r_u and N_v = -N x r_v",
    )


def normal_cross_product(setting: Setting, *, sign: int = -1) -> Evidence:
    """N_u x N_v from r_u x r_v, on a net of either orientation."""
    residuals = {}
    for sigma in (1, -1):
        net = general_net(sigma)
        calculus = net.calculus
        left = calculus.cross(net.d(net.normal, "u"), net.d(net.normal, "v"))
        product = calculus.cross(net.r_u, net.r_v)
        residuals[f"sigma = {sigma}"] = [a - sign * b for a, b in zip(left, product, strict=True)]
    a, b = sp.symbols("a b", real=True)
    rays = star_normal.ray(a), star_normal.ray(b)
    at_centre = cross(star_normal.image_of_ray(a, 0), star_normal.image_of_ray(b, 1))
    residuals["at the centre"] = list(
        added(at_centre, scaled(-1, printed.rates_product(*rays, sign=sign)))
    )
    return identities(
        setting,
        residuals,
        shown="both from the fundamental forms (Weingarten) and at the centre of a saddle",
    )


def lifted_tangents(setting: Setting, *, even: int = 1, odd: int = -1) -> Evidence:
    """Tangents t_i of the images of u- and v-curves, and their angles modulo 2 pi."""
    beta = sp.Symbol("beta", real=True)
    residuals = {}
    for i, name in ((0, "u"), (1, "v")):
        image = star_normal.image_of_ray(beta, i)
        theta = printed.image_angle(beta, i, even=even, odd=odd)
        residuals[f"t_i of {name}-curves"] = list(added(image, scaled(-1, star_normal.ray(theta))))
    return identities(
        setting,
        residuals,
        shown="N_u = e_3 x s_i and N_v = -e_3 x s_i are the unit vectors at the printed angles",
    )


def theta_lift(setting: Setting, *, sense: int = 1, shift: int = 0) -> Evidence:
    """Lift of the angles: theta_i - theta_{i+1} lies in (0, pi) for a sector of any angle.

    sense: -1 asks for theta_{i+1} - theta_i instead; shift: of the parity of the first ray.
    """
    beta, t = sp.Symbol("beta", real=True), sp.Symbol("t", positive=True)
    alpha = sp.Symbol("alpha", positive=True)
    residuals: dict[str, Any] = {}
    for i in (0, 1):
        first = printed.image_angle(beta, i + shift)
        last = printed.image_angle(beta + alpha, i + 1)
        step = sense * (first - last)
        residuals[f"sine, i = {i}"] = sp.sin(step) - sp.sin(alpha)
        residuals[f"cosine, i = {i}"] = sp.cos(step) + sp.cos(alpha)
        product = cross(
            star_normal.image_of_ray(beta, i), star_normal.image_of_ray(beta + alpha, i + 1)
        )
        residuals[f"third component of N_u x N_v, i = {i}"] = product[2] + sp.sin(alpha)
    weight = sp.sin(alpha / 2) ** 2 + (1 - 2 * t) ** 2 * sp.cos(alpha / 2) ** 2
    mixed = added(
        scaled(1 - t, star_normal.image_of_ray(0, 0)), scaled(t, star_normal.image_of_ray(alpha, 1))
    )
    residuals["|(1 - t) t_i + t t_{i+1}|^2"] = dot(mixed, mixed) - weight
    return identities(
        setting,
        residuals,
        shown="theta_i - theta_{i+1} has the sine and cosine of pi - alpha, which lies in (0, pi): "
        "of its values modulo 2 pi one lies there; the image of a sector is the cone "
        "between its rays, and no mixture of the two vanishes",
    )


def theta_two_steps(setting: Setting, *, turns: int = -2) -> Evidence:
    """theta_{i+2} - theta_i, each step being the lift alpha - pi."""
    a, b, first = sp.symbols("alpha_1 alpha_2 beta_0", positive=True)
    steps = (a - PI) + (b - PI)
    residuals: dict[str, Any] = {
        "theta_2 - theta_0": printed.two_steps(first, first + a + b, turns=turns) - steps
    }
    for i in (0, 1):
        change = printed.image_angle(first + a + b, i + 2) - printed.image_angle(first, i)
        residuals[f"modulo 2 pi, i = {i}"] = sp.sin((change - steps) / 2)
    return identities(
        setting,
        residuals,
        shown="two lifts add up to beta_{i+2} - beta_i - 2 pi, for both parities",
    )


def theta_sum(setting: Setting, *, offset: int = 1, slope: int = -1) -> Evidence:
    """Sum of the lifts along a circuit, for any angles (m = 2 to 6) and for equal ones (any m)."""
    residuals: dict[str, Any] = {}
    for order in range(2, 7):
        angles = sp.symbols(f"alpha_1:{2 * order}", positive=True)
        closed = (*angles, 2 * PI - sum(angles))
        single = sum(a - PI for a in closed)
        pairs = sum(
            printed.two_steps(sum(closed[: 2 * k]), sum(closed[: 2 * k + 2])) for k in range(order)
        )
        total = printed.angle_total(order, offset=offset, slope=slope)
        residuals |= {
            f"sum by pairs, m = {order}": sp.expand(single - pairs),
            f"total, m = {order}": sp.expand(single - total),
        }
    m = sp.Symbol("m", integer=True, positive=True)
    regular = 2 * m * (2 * PI / (2 * m) - PI)
    residuals["equal angles, any m"] = regular - printed.angle_total(m, offset=offset, slope=slope)
    return identities(
        setting,
        residuals,
        shown="the lifts add up to 2 (1 - m) pi, all angles being free, m = 2 to 6",
    )


def covering_number(setting: Setting, *, offset: int = 1, slope: int = -1) -> Evidence:
    """(lem:covering-number) on stars: turning of the rays, gradient of the saddle, sheets of N.

    The turning of N is that of its tangent map, which turns by alpha - pi on each sector, being
    linear there of determinant -1; N differs from it by less than its length near p.
    """
    wrong = []
    for name, angles in STARS.items():
        order = len(angles) // 2
        lifts = sum((a - PI for a in angles), sp.Integer(0)) / (2 * PI)
        routes = {
            "from the lifts": sp.nsimplify(lifts),
            "from the gradient": star_saddle.winding_number(angles),
            "from the preimages": -_sheets(angles),
        }
        expected = printed.index(order, offset=offset, slope=slope)
        wrong += [f"{name}: {value} {told}" for told, value in routes.items() if value != expected]
    a, b = sp.symbols("a b", positive=True)
    free = (a, b)
    agree = {
        f"tangent map minus Hessian on sector {i}": list(
            star_normal.sector_map(free, i) - star_saddle.sector_hessian(free, i)
        )
        for i in (0, 1)
    }
    agree |= {f"det + 1 on sector {i}": star_normal.sector_map(free, i).det() + 1 for i in (0, 1)}
    return combined(
        {
            "tangent map": identities(setting, agree, shown="tangent map"),
            "stars": statement(
                not wrong, shown="stars", witness=f"J_p is not the printed index: {wrong}"
            ),
        },
        shown=f"for sectors of any angles the tangent map of N by Lelieuvre is the Hessian of the "
        f"quadratic saddle, of determinant -1; on {len(STARS)} stars, m = 2 to 6, the lifts, the "
        "winding number of the gradient and the number of preimages agree with 1 - m; by hand: N "
        "turns as its tangent map, from which it differs by less than its length near p",
    )


_TARGETS = tuple(sp.Rational(n, 97) for n in (1, 13, 29, 40, 58, 77, 91))


def _sheets(angles: tuple[Any, ...]) -> int:
    """Number of preimages under the tangent map, the same for all directions tried.

    It is also the total opening pi - alpha of the images of the sectors, in turns.
    """
    counts = {len(star_normal.preimages(angles, target)) for target in _TARGETS}
    openings = sum((PI - a for a in angles), sp.Integer(0)) / (2 * PI)
    counts.add(int(sp.nsimplify(openings)))
    if len(counts) != 1:
        raise ArithmeticError(f"numbers of preimages {counts} on one star")
    return counts.pop()


def sheets(setting: Setting, *, shift: int = -1, only: int = 0, least: int = 1) -> Evidence:
    """Preimages of each direction under the tangent map of N over stars of several orders.

    shift: they are claimed to be m_p + shift; only: order of the stars taken, 0 for all above 2;
    least: number of preimages that the claim asks for at least.
    """
    stars = {
        name: angles
        for name, angles in STARS.items()
        if (len(angles) // 2 == only if only else len(angles) > 4)
    }
    counts = {name: _sheets(angles) for name, angles in stars.items()}
    wrong = [
        f"{name}: {count} preimages"
        for name, count in counts.items()
        if count != len(stars[name]) // 2 + shift or count < least
    ]
    return statement(
        bool(counts) and not wrong,
        shown=f"on {len(counts)} stars every direction tried has |J_p| = m_p - 1 preimages "
        f"(from {min(counts.values())} to {max(counts.values())}); by hand: N differs from its "
        "tangent map by a map whose Lipschitz constant tends to 0 at p, so it has the same number "
        "near p",
        witness="; ".join(wrong),
    )


def sheets_of_order_two(setting: Setting, *, only: int = 2, shift: int = -1) -> Evidence:
    """Where J_p = -1, that is m_p = 2, every direction has one preimage.

    only, shift: see sheets; one preimage is asked for.
    """
    counts = {name: _sheets(angles) for name, angles in STARS.items() if len(angles) // 2 == only}
    wrong = [f"{name}: {count} preimages" for name, count in counts.items() if count != 2 + shift]
    return statement(
        bool(counts) and not wrong,
        shown=f"on {len(counts)} stars of order 2, thin and kinked ones among them, every "
        "direction tried has one preimage under the tangent map, the cones onto which it sends the "
        "sectors fill one turn; by hand: so it is one-to-one with a Lipschitz inverse, and N "
        "differs by a map whose Lipschitz constant tends to 0 at p",
        witness="; ".join(wrong),
    )


def several_sheets(setting: Setting, *, only: int = 0, shift: int = -1) -> Evidence:
    """At a branch point some normals occur at two points at least, however near to p."""
    return sheets(setting, only=only, shift=shift, least=2)
