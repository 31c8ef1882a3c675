"""Checks of Minding's bobbin near its turning points: height, expansions, cusp (eq:zprime)."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.order import order_of_zero
from checks.positivity import positivity
from checks.printed import bobbin_orbit as printed
from checks.verify.bobbin_branches import BRANCHES, SIGNS, solved_rate
from checks.zero import vanishes
from theory.bobbin import KAPPA, S, arc_length, bobbin_flow, half_length
from theory.pseudospherical_revolution import PSI, Flow, Z

TURNS = {"s = +L": sp.Integer(0), "s = -L": sp.pi}


def height_rate(setting: Setting, *, power: int = 2) -> Evidence:
    """Both equalities of eq:zprime along the lines, and from the energy equation."""
    flow = bobbin_flow()
    middle, right = printed.height_rate_squared(arc_length(), flow.s_rate, KAPPA, power=power)
    ds = solved_rate(printed.energy(S, sp.Integer(0), KAPPA), 1)
    by_energy = printed.height_rate_squared(S, ds, KAPPA, power=power)
    return identities(
        setting,
        {
            "z'^2 = s'^2 - rho'^2": flow.s_rate**2 - flow.along(flow.rho) ** 2 - middle,
            "right": middle - right,
            "z'": flow.z_rate**2 - right,
            "by the energy equation": by_energy[0] - by_energy[1],
        },
        shown="z'^2 = s'^2 - rho'^2 is both printed expressions, through the edges",
    )


def vanishing_order(setting: Setting, *, order: int = 2) -> Evidence:
    """Order in L^2 - s^2 of the right side at s = +-L, and z' = z'' = 0 there."""
    _, right = printed.height_rate_squared(S, sp.Integer(0), KAPPA)
    for side in SIGNS:
        found = order_of_zero(right, S, side * half_length())
        if found != order:
            return statement(
                False, shown="", witness=f"the order at s = {side:+d} L is {found}, not {order}"
            )
    flow = bobbin_flow()
    residuals = {}
    for name, psi in TURNS.items():
        residuals[f"z' at {name}"] = flow.z_rate.subs(PSI, psi)
        residuals[f"z'' at {name}"] = flow.along(flow.z_rate).subs(PSI, psi)
    return identities(
        setting, residuals, shown="a double zero at s = L and at s = -L; z' = z'' = 0 there"
    )


def rising(setting: Setting, *, root: str = "nonnegative") -> Evidence:
    """Root of eq:zprime that is smooth and never negative; root: or the one with sgn s'."""
    flow = bobbin_flow()
    room = KAPPA**2 - sp.sinh(arc_length()) ** 2
    smooth = room / (KAPPA * sp.sqrt(KAPPA**2 + 1))
    signs, values = {}, {}
    for branch in BRANCHES:
        factor = 1 if root == "nonnegative" else branch.slope
        value = branch.value(factor * flow.z_rate)
        signs[branch.name] = value * sp.sqrt(KAPPA**2 + 1)
        values[f"root ({branch.name})"] = value - branch.value(factor * smooth)
    values["everywhere"] = flow.z_rate - smooth
    return combined(
        {
            "root": identities(setting, values, shown="a root of the right side"),
            "sign": positivity(setting, signs, shown="positive between the turning points"),
        },
        shown="z' = (kappa^2 - sinh^2 s)/(kappa sqrt(kappa^2 + 1)) = alpha sin^2 psi is smooth for "
        "all xi and positive between turning points",
    )


def _derivatives(flow: Flow, expr: sp.Expr, most: int) -> list[sp.Expr]:
    """Successive rates by xi of an expression of psi and z, from order 0."""
    found = [expr]
    for _ in range(most):
        found.append(flow.along(found[-1]))
    return found


def expansions(
    setting: Setting, *, radius: int = 2, height: int = 3, radius_shift: int = 1
) -> Evidence:
    """Leading terms of rho and z at the turning points, from derivatives along the flow."""
    flow = bobbin_flow()
    root = sp.sqrt(KAPPA**2 + 1)
    orders = printed.expansion_orders(radius=radius, height=height)
    residuals, leading = {}, {}
    for name, psi in TURNS.items():
        rho = [d.subs(PSI, psi) for d in _derivatives(flow, flow.rho, orders[0] + 1)]
        z = [d.subs(PSI, psi) for d in _derivatives(flow, Z, orders[1] + 1)]
        residuals[f"rho_c at {name}"] = rho[0] - printed.edge_radius(KAPPA, shift=radius_shift)
        for order in (*range(1, orders[0]), orders[0] + 1):
            residuals[f"rho, order {order} at {name}"] = rho[order]
        for order in (*range(1, orders[1]), orders[1] + 1):
            residuals[f"z, order {order} at {name}"] = z[order]
        leading[f"c_1 at {name}"] = -rho[orders[0]] / sp.factorial(orders[0]) * root
        leading[f"c_2 at {name}"] = z[orders[1]] / sp.factorial(orders[1]) * root
    values = {f"{n}, value": c - KAPPA / (2 if "c_1" in n else 3) for n, c in leading.items()}
    return combined(
        {
            "orders": identities(setting, residuals, shown="the orders before and after vanish"),
            "signs": positivity(setting, leading, shown="c_1, c_2 > 0"),
            "values": identities(setting, values, shown="values"),
        },
        shown="at s = +L and at s = -L c_1 = kappa/(2 sqrt(kappa^2 + 1)), c_2 = kappa/(3 "
        "sqrt(kappa^2 + 1)), and the next terms vanish: the errors are O(4) and O(5)",
    )


def cusp(setting: Setting, *, at: str = "edge", second: int = 2, third: int = 3) -> Evidence:
    """Ordinary cusp of the meridian, so a cuspidal edge of the surface.

    at: `edge` or `throat`; second, third: the derivatives that must be independent, 2 and 3.
    """
    flow = bobbin_flow()
    places = TURNS if at == "edge" else {"s = 0": sp.pi / 2}
    rho, z = _derivatives(flow, flow.rho, third), _derivatives(flow, Z, third)
    residuals = {}
    for name, psi in places.items():
        residuals[f"rho' at {name}"] = rho[1].subs(PSI, psi)
        residuals[f"z' at {name}"] = z[1].subs(PSI, psi)
    determinant = rho[second] * z[third] - rho[third] * z[second]
    independent = {f"-det at {name}": -determinant.subs(PSI, psi) for name, psi in places.items()}
    stopped = identities(setting, residuals, shown="the meridian stops")
    if stopped.outcome != "pass":
        return stopped
    if any(vanishes(value) for value in independent.values()):
        return statement(
            False, shown="", witness=f"derivatives {second} and {third} are parallel at the edge"
        )
    return combined(
        {"stops": stopped, "cusp": positivity(setting, independent, shown="independent")},
        shown="at both edges the meridian (rho, z)(xi) has velocity 0 and independent second and "
        "third derivatives: an ordinary cusp, which turns about the axis into a cuspidal edge",
    )
