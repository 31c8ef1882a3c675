"""Checks of section 3.4: the three inserted sectors as Taylor series at the point."""

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import surgery as printed
from checks.verify.nets import minus
from theory import surgery_sectors as sectors
from theory.amsler import C0, S0, U, V, similarity_series
from theory.moutard import ZERO, Series, goursat_series
from theory.surgery_sectors import NORMAL, Line, on_circle
from theory.vectors import Vector, added, dot, scaled

ORDER = 3
KAPPA_U = sp.symbols("k_0 k_1", real=True)
KAPPA_V = sp.symbols("l_0 l_1", real=True)
E_1: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
START = sp.symbols("z_1:4", real=True)
_SIDES: Mapping[int, tuple[tuple[Any, ...], tuple[Any, ...], int]] = {
    1: (KAPPA_U, (), 1),
    2: ((), (), -1),
    3: ((), KAPPA_V, 1),
}


def turned(sign: int) -> Vector:
    """Return the unit vector at the angle sign * omega from e_1."""
    return (C0, sign * S0, sp.Integer(0))


def _taylor(expr: Any, symbol: Any) -> list[Any]:
    polynomial = sp.series(expr, symbol, 0, ORDER + 1).removeO()
    return [sp.expand(polynomial).coeff(symbol, n) for n in range(ORDER + 1)]


def _coefficients(vector: Vector, symbol: Any) -> list[Vector]:
    """Taylor coefficients of a triple of functions of one coordinate."""
    x, y, z = (_taylor(entry, symbol) for entry in vector)
    return list(zip(x, y, z, strict=True))


def _entries(series: Mapping[Any, Any]) -> list[Any]:
    """Scalars of a series of vectors or scalars, as functions of the half-angle."""
    found: list[Any] = []
    for value in series.values():
        found += list(value) if isinstance(value, tuple) else [value]
    return [on_circle(entry) for entry in found]


def _moutard_defects(normal: Series) -> dict[str, Any]:
    """Unit length, Moutard equation and integrability, coefficient by coefficient."""
    r_u, r_v = sectors.front_rates(normal, order=ORDER)
    lengths = sectors.products(normal, normal, order=ORDER)
    lengths[0, 0] -= 1
    crossed, straight = sectors.rate(r_u, "v"), sectors.rate(r_v, "u")
    gap = {key: minus(crossed[key], straight[key]) for key in crossed if key in straight}
    return {"N.N - 1": _entries(lengths), "r_uv - r_vu": _entries(gap)}


def _edge_gap(found: Sequence[Vector], wanted: Sequence[Vector]) -> list[Any]:
    pairs = zip(found, wanted, strict=False)
    return [on_circle(entry) for a, b in pairs for entry in minus(a, b)]


def middle_sector(
    setting: Setting,
    *,
    sign_u: int = 1,
    sign_v: int = -1,
    tilt: int = 0,
    length: int = 1,
    start: bool = True,
) -> Evidence:
    """Amsler patch of (amsler-frame): two straight edges from z_1, at every angle omega.

    sign_u, sign_v: those of (amsler-frame); tilt: normal part of e_u; length: of e_u; start:
    whether r_2 starts from z_1.
    """
    e_u: Vector = (sp.Integer(length), sp.Integer(0), sp.Integer(tilt))
    e_v = turned(-1)
    on_u = printed.straight_normal_u(sp.cos(U), sp.sin(U), NORMAL, e_u, sign=sign_u)
    on_v = printed.straight_normal_v(sp.cos(V), sp.sin(V), NORMAL, e_v, sign=sign_v)
    normal = goursat_series(_coefficients(on_u, U), _coefficients(on_v, V))
    r_u, r_v = sectors.front_rates(normal, order=ORDER)
    first = START if start else ZERO
    straight_u = [START, e_u, ZERO, ZERO]
    straight_v = [START, e_v, ZERO, ZERO]
    angle = _amsler_cosine()
    products = sectors.products(r_u, r_v, order=ORDER)
    gap = {key: value - sectors.coefficient(angle, *key) for key, value in products.items()}
    return identities(
        setting,
        {
            **_moutard_defects(normal),
            "r(u, 0)": _edge_gap(sectors.edge_places(r_u, "u", first, order=ORDER), straight_u),
            "r(0, v)": _edge_gap(sectors.edge_places(r_v, "v", first, order=ORDER), straight_v),
            "r_u.r_v - cos F(uv)": _entries(gap),
        },
        shown="for every angle the Moutard solution is unit, its front has the edges z + u e_u, "
        "z + v e_v, and the angle of its lines solves x F'' + F' = sin F, to third order",
    )


def _amsler_cosine() -> Any:
    """Taylor polynomial of cos F(u v) from the similarity equation."""
    psi = similarity_series(ORDER, U * V)
    square, cube = sp.expand(psi**2), sp.expand(psi**3)
    return sp.expand(C0 * (1 - square / 2) - S0 * (psi - cube / 6))


def _lines(number: int, *, sign: int = 1) -> tuple[Line, Line]:
    """Two lines on the edges of the sector of this number, its u-line along e_1."""
    kappa_u, kappa_v, sigma = _SIDES[number]
    return (
        Line(direction=E_1, curvatures=kappa_u),
        Line(direction=turned(sigma * sign), curvatures=kappa_v),
    )


def _side(setting: Setting, number: int, *, sign_v: int, moves: bool) -> Evidence:
    """Series of a side sector: unit, harmonic, inherited edges, angle of the sine-Gordon equation.

    sign_v: of the second Lelieuvre equation; moves: whether the normal moves along the v-axis.
    """
    on_u, on_v = _lines(number)
    data_v = sectors.normals(on_v, torsion=1, order=ORDER)
    if not moves:
        data_v = [NORMAL] + [ZERO] * ORDER
    normal = goursat_series(sectors.normals(on_u, torsion=-1, order=ORDER), data_v)
    r_u, r_v = sectors.front_rates(normal, order=ORDER, sign_v=sign_v)
    products = sectors.products(r_u, r_v, order=ORDER)
    angle = sectors.angle_cosine(on_u.curvatures, on_v.curvatures, order=ORDER)
    gap = {key: value - sectors.coefficient(angle, *key) for key, value in products.items()}
    crossed, straight = sectors.rate(r_u, "v"), sectors.rate(r_v, "u")
    closed = {key: minus(crossed[key], straight[key]) for key in crossed if key in straight}
    speeds = {
        **{("u", *k): e for k, e in sectors.products(r_u, r_u, order=ORDER).items()},
        **{("v", *k): e for k, e in sectors.products(r_v, r_v, order=ORDER).items()},
    }
    speeds["u", 0, 0] -= 1
    speeds["v", 0, 0] -= 1
    return identities(
        setting,
        {
            "N.N - 1": _moutard_defects(normal)["N.N - 1"],
            "r_uv - r_vu": _entries(closed),
            "speeds - 1": _entries(speeds),
            "r_u, r_v at the point": _edge_gap(
                [r_u[0, 0], r_v[0, 0]], [on_u.direction, on_v.direction]
            ),
            "r_u.r_v - cos omega": _entries(gap),
        },
        shown="unit normal, closed Lelieuvre form, unit speeds, r_u and r_v at the point along the "
        "given lines, and an angle with omega_uv = sin "
        "omega, for every angle and curvatures k_0 + k_1 s of the inherited edge, to third order",
    )


def side_sector(setting: Setting, *, sign_v: int = -1, moves: bool = True) -> Evidence:
    """Omega_1: N_1 is weakly harmonic and r_1 a front; parameters as in the series."""
    return _side(setting, 1, sign_v=sign_v, moves=moves)


def opposite_side_sector(
    setting: Setting, *, sign_v: int = -1, moves: bool = True, chart: int = 2
) -> Evidence:
    """Omega_3: N_3 from N_2 on the u-axis and N_0 on the v-axis; chart: where chi_2 lands."""
    along = sectors.normals(Line(direction=E_1), torsion=-1, order=ORDER)
    data = {
        # Column v = 0 of the middle sector; of Omega_1 it would be the inherited, curved edge.
        2: sectors.sector_normal(*_lines(2), order=ORDER),
        1: sectors.sector_normal(*_lines(1), order=ORDER),
    }[chart]
    copied = identities(
        setting,
        {"N_3(u, 0)": _edge_gap([data[n, 0] for n in range(ORDER + 1)], along)},
        shown="the u-axis of Omega_3 carries the normals of the straight edge of Omega_2",
    )
    return combined(
        {"data": copied, "sector": _side(setting, 3, sign_v=sign_v, moves=moves)},
        shown="N_3 takes its normals from the straight edge of Omega_2 and from the v-line of r_0; "
        "it is unit and harmonic, its lines have unit speed and the angle of the sine-Gordon "
        "equation, to third order",
    )


def normal_along_v(
    setting: Setting, *, lands_in: int = 2, edge: str = "u = 0", direction: str = "e_v"
) -> Evidence:
    """N_1(0, v) against the solution on the rectangle in which chi_4 lands.

    lands_in: its number; edge: the edge on which the solution is read; direction: of the ray on
    which N_1 is prescribed, e_v or its opposite.
    """
    normal = sectors.sector_normal(*_lines(lands_in), order=ORDER)
    keys = [(0, n) if edge == "u = 0" else (n, 0) for n in range(ORDER + 1)]
    e_v = scaled(1 if direction == "e_v" else -1, turned(_SIDES[lands_in][2]))
    wanted = printed.straight_normal_v(sp.cos(V), sp.sin(V), NORMAL, e_v)
    return identities(
        setting,
        {"N_1(0, v)": _edge_gap([normal[key] for key in keys], _coefficients(wanted, V))},
        shown="the Moutard solution N_2 restricted to u = 0 is the normal of the straight ray "
        "along e_v, to third order",
    )


def _rays(inner: Sequence[Any]) -> tuple[Line, Line, Line, Line]:
    """Rays t_u, e_v, e_u, t_v: the inherited ones of any curvature, the new ones straight."""
    p, q = inner
    plane = [_unit(p), _unit(q)]
    t_v = _unit(sp.Symbol("t", positive=True))
    return (
        Line(direction=E_1, curvatures=KAPPA_U),
        Line(direction=plane[0]),
        Line(direction=plane[1]),
        Line(direction=t_v, curvatures=KAPPA_V),
    )


def _unit(t: Any) -> Vector:
    """Return the unit vector at the angle 2 atan t."""
    return ((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2), sp.Integer(0))


def _moved(places: Sequence[Vector]) -> list[Vector]:
    """Taylor coefficients of a line that starts from z_1 instead of the origin."""
    return [added(places[0], START), *places[1:]]


def edges_agree(setting: Setting, *, fourth: int = 2, starts: str = "1,2,3") -> Evidence:
    """Normals and places of the sectors on the edges at which they are attached, as series.

    fourth: number of the sector in which chi_4 lands; starts: the fronts that start from z_1.
    """
    order = 2
    rays = _rays(sp.symbols("p q", positive=True))
    along_u = {1: rays[0], 2: rays[2], 3: rays[2]}
    along_v = {1: rays[1], 2: rays[1], 3: rays[3]}
    normal = {k: sectors.sector_normal(along_u[k], along_v[k], order=order) for k in along_u}
    rates = {k: sectors.front_rates(a, order=order) for k, a in normal.items()}
    start = {k: START if str(k) in starts.split(",") else ZERO for k in rates}
    axis = range(order + 1)
    on_u = {k: [normal[k][n, 0] for n in axis] for k in normal}
    on_v = {k: [normal[k][0, n] for n in axis] for k in normal}
    at_u = {k: sectors.edge_places(rates[k][0], "u", start[k], order=order) for k in rates}
    at_v = {k: sectors.edge_places(rates[k][1], "v", start[k], order=order) for k in rates}
    inherited_u = _moved(sectors.places(rays[0], torsion=-1, order=order))
    inherited_v = _moved(sectors.places(rays[3], torsion=1, order=order))
    return identities(
        setting,
        {
            "chi_1, r": _edge_gap(at_u[1], inherited_u),
            "chi_2, N": _edge_gap(on_u[3], on_u[2]),
            "chi_2, r": _edge_gap(at_u[3], at_u[2]),
            "chi_3, r": _edge_gap(at_v[3], inherited_v),
            "chi_4, N": _edge_gap(on_v[1], on_v[fourth]),
            "chi_4, r": _edge_gap(at_v[1], at_v[fourth]),
        },
        shown="on each of the four edges the two fronts and the two normals have the same Taylor "
        "polynomials of second order, for all rays and curvatures of the inherited edges; the "
        "inherited places are integrated from the Frenet frame",
    )


def two_axes(setting: Setting, *, axes: str = "u,v", corner: str = "n_1") -> Evidence:
    """Which Taylor coefficients of N the data and the Moutard equation leave open.

    axes: those on which N is given; corner: value of the v-data in (0, 0), n_1 or its opposite.
    """
    first = sectors.normals(_lines(1)[0], torsion=-1, order=1)[0]
    second = scaled(
        1 if corner == "n_1" else -1, sectors.normals(_lines(1)[1], torsion=1, order=1)[0]
    )
    return combined(
        {
            "corner": identities(
                setting, {"N(0, 0) from both axes": minus(first, second)}, shown="one value"
            ),
            "coefficients": _determined(axes),
        },
        shown="the data agree in (0, 0), and each coefficient of u^(i+1) v^(j+1) is fixed by those "
        "of lower indices",
    )


def _determined(axes: str) -> Evidence:
    """Evidence that no coefficient of N up to second order is left open by data on these axes."""
    order = 2
    unknown = {
        (i, j): tuple(sp.Symbol(f"n{k}_{i}{j}", real=True) for k in range(3))
        for i in range(order + 1)
        for j in range(order + 1)
    }
    given = [key for key in unknown if (key[1] == 0 and "u" in axes) or
             (key[0] == 0 and "v" in axes)]  # fmt: skip
    fixed = set(given)
    for i, j in sorted(unknown, key=sum):
        if i == order or j == order:
            continue
        equation = _moutard_coefficient(unknown, i, j)
        rest = minus(equation, scaled((i + 1) * (j + 1), unknown[i + 1, j + 1]))
        inside = set().union(*(entry.free_symbols for entry in rest))
        allowed = {s for key in unknown if key in fixed for s in unknown[key]}
        if inside <= allowed:
            fixed.add((i + 1, j + 1))
    left = sorted(set(unknown) - fixed)
    return statement(
        not left,
        shown="all coefficients follow from those of the axes",
        witness=f"left open: the coefficients of u^i v^j for (i, j) in {left}",
    )


def _moutard_coefficient(normal: Series, i: int, j: int) -> Vector:
    """Coefficient of u^i v^j in N_uv + (N_u.N_v) N."""
    n_u, n_v = sectors.rate(normal, "u"), sectors.rate(normal, "v")
    total = scaled((i + 1) * (j + 1), normal[i + 1, j + 1])
    for a in range(i + 1):
        for b in range(j + 1):
            speed = sum(
                (dot(n_u[c, d], n_v[a - c, b - d]) for c in range(a + 1) for d in range(b + 1)),
                sp.Integer(0),
            )
            total = added(total, scaled(speed, normal[i - a, j - b]))
    x, y, z = (sp.expand(entry) for entry in total)
    return (x, y, z)
