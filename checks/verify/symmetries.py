"""Checks of section 3.1, items (E) and (F): what u -> -u, v -> -v and N -> -N preserve."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import asymptotic_frames as printed
from checks.verify.nets import all_nets, combination, minus, over_nets
from theory.asymptotic_net import AsymptoticNet, VectorCalculus
from theory.reparametrisation import Change, changed, substituted
from theory.surfaces import pseudosphere
from theory.vectors import Vector, derivative

_CHANGES: Mapping[str, tuple[Change, int]] = {
    "N": (((1, 0), (0, 1)), -1),
    "u": (((-1, 0), (0, 1)), 1),
    "v": (((1, 0), (0, -1)), 1),
    "exchange": (((0, 1), (1, 0)), 1),
    "shear": (((1, 1), (0, 1)), 1),
    "double": (((2, 0), (0, 1)), 1),
}

Fields = tuple[VectorCalculus, Vector, Vector, Vector]
Residuals = Callable[[Fields], Mapping[str, Any]]


def _fields(net: AsymptoticNet) -> Fields:
    return net.calculus, net.r_u, net.r_v, net.normal


def _sources(change: Change, normal_sign: int) -> Iterator[tuple[str, Fields]]:
    """Fields after a change: by the chain rule on every net, and of the pseudosphere rewritten.

    The last has the change written into r(u, v) and N(u, v), which are differentiated in R^3.
    """
    for net in all_nets():
        yield net.name, _fields(changed(net, change, normal_sign=normal_sign))
    u, v = sp.symbols("u v", real=True)
    calculus, position, normal = substituted(pseudosphere(), change, u, v, normal_sign=normal_sign)
    tangents = derivative(position, u), derivative(position, v)
    yield "pseudosphere in R^3", (calculus, *tangents, normal)


def _after(setting: Setting, changes: str, residuals: Residuals, *, shown: str) -> Evidence:
    """Evidence that the residuals vanish on every net after each change, by two routes."""
    found: dict[str, Evidence] = {}
    for name in changes.split(","):
        change, normal_sign = _CHANGES[name]
        for where, fields in _sources(change, normal_sign):
            label = f"change {name}, {where}"
            found[label] = identities(setting, residuals(fields), shown=shown)
            if found[label].outcome == "fail":
                return combined(found, shown=shown)
    return combined(found, shown=shown)


def _lelieuvre(fields: Fields) -> Mapping[str, Any]:
    calculus, r_u, r_v, normal = fields
    n_u, n_v = calculus.derivative(normal, "u"), calculus.derivative(normal, "v")
    return {
        "r_u - N_u x N": minus(r_u, printed.lelieuvre_u(n_u, normal, calculus.cross)),
        "r_v + N_v x N": minus(r_v, printed.lelieuvre_v(n_v, normal, calculus.cross)),
    }


def _lorentz(fields: Fields) -> Mapping[str, Any]:
    calculus, _, _, normal = fields
    twice = calculus.derivative(calculus.derivative(normal, "u"), "v")
    return {"N x N_uv": printed.lorentz_harmonic(normal, twice, calculus.cross)}


def _torsions(fields: Fields) -> Mapping[str, Any]:
    """Last rows of the systems (eq:frames), where minus the torsion stands alone."""
    calculus, r_u, r_v, normal = fields
    found = {}
    systems = (("u", r_u, printed.frenet_u(0)), ("v", r_v, printed.frenet_v(0)))
    for along, tangent, matrix in systems:
        frame = printed.frame(tangent, normal, calculus.cross)
        turned = calculus.derivative(normal, along)
        found[f"N_{along}"] = minus(turned, combination(matrix[2], frame))
    return found


_SHOWN = (
    "after each of the three changes, for an unknown angle (chain rule), two explicit surfaces "
    "(chain rule) and the pseudosphere with the change written into r(u, v) and N(u, v)"
)


def lelieuvre_symmetries(setting: Setting, *, changes: str = "N,u,v") -> Evidence:
    """Item (E): (eq:lelieuvre) is invariant; changes: names of the changes, with commas between."""
    return _after(setting, changes, _lelieuvre, shown=f"both Lelieuvre formulae hold {_SHOWN}")


def lorentz_symmetries(setting: Setting, *, changes: str = "N,u,v") -> Evidence:
    """Item (E): (eq:lorentz_harmonic) is invariant; changes: names of the changes."""
    return _after(setting, changes, _lorentz, shown=f"the normal is Lorentz harmonic {_SHOWN}")


def torsion_symmetries(setting: Setting, *, changes: str = "N,u,v") -> Evidence:
    """Item (E): the torsions in (eq:frames) keep their signs; changes: names of the changes."""
    return _after(setting, changes, _torsions, shown=f"the torsions are -1 and +1 {_SHOWN}")


def _curvatures(fields: Fields) -> tuple[Any, Any]:
    """Entries kappa^u and kappa^v of (eq:frames), read off the derivatives."""
    calculus, r_u, r_v, normal = fields
    found = []
    for along, tangent in (("u", r_u), ("v", r_v)):
        bent = calculus.derivative(tangent, along)
        found.append(calculus.dot(bent, calculus.cross(normal, tangent)))
    return found[0], found[1]


def _reversal(setting: Setting, change: str, factors: tuple[int, int]) -> Evidence:
    """Evidence that a change multiplies kappa^u and kappa^v by these factors."""
    matrix, normal_sign = _CHANGES[change]

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        before = _curvatures(_fields(net))
        after = _curvatures(_fields(changed(net, matrix, normal_sign=normal_sign)))
        return {
            name: new - factor * old
            for name, old, new, factor in zip(
                ("kappa^u", "kappa^v"), before, after, factors, strict=True
            )
        }

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"{change} -> -{change} multiplies kappa^u "
        f"by {factors[0]:+d} and kappa^v by {factors[1]:+d}",
    )


def flip_u(
    setting: Setting, *, change: str = "u", factor_u: int = -1, factor_v: int = 1
) -> Evidence:
    """Item (E): u -> -u reverses kappa^u and nothing else."""
    return _reversal(setting, change, (factor_u, factor_v))


def flip_v(
    setting: Setting, *, change: str = "v", factor_u: int = 1, factor_v: int = -1
) -> Evidence:
    """Item (E): v -> -v reverses kappa^v and nothing else."""
    return _reversal(setting, change, (factor_u, factor_v))


def flip_normal(
    setting: Setting, *, change: str = "N", factor_u: int = -1, factor_v: int = -1
) -> Evidence:
    """Item (E): N -> -N reverses both kappa^u and kappa^v."""
    return _reversal(setting, change, (factor_u, factor_v))


def flipped_coordinates(setting: Setting, *, changes: str = "u,v") -> Evidence:
    """Item (F): -u and -v are asymptotic coordinates of unit speed as well as u and v."""

    def residuals(fields: Fields) -> Mapping[str, Any]:
        calculus, r_u, r_v, normal = fields
        return {
            "r_u.r_u - 1": calculus.dot(r_u, r_u) - 1,
            "r_v.r_v - 1": calculus.dot(r_v, r_v) - 1,
            "N.r_uu": calculus.dot(normal, calculus.derivative(r_u, "u")),
            "N.r_vv": calculus.dot(normal, calculus.derivative(r_v, "v")),
        }

    return _after(
        setting,
        changes,
        residuals,
        shown="the flipped coordinates are asymptotic and "
        "of unit speed, for an unknown angle and on explicit surfaces",
    )
