"""The surfaces on which the checks of section 3.1 compare printed formulas with derived fields."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from theory.asymptotic_net import AsymptoticNet, general_net
from theory.surfaces import dini, kuen, pseudosphere
from theory.vectors import Vector, added, scaled


def general_nets() -> tuple[AsymptoticNet, ...]:
    """Nets of an unknown angle for both signs of sigma, from Gauss-Weingarten."""
    return (general_net(1), general_net(-1))


def explicit_nets() -> tuple[AsymptoticNet, ...]:
    """Pseudosphere, Dini's (a = 2) and Kuen's surface on both sides of their edges."""
    fronts = (pseudosphere(), dini(2), kuen())
    return tuple(front.net(side) for front in fronts for side in (1, -1))


def all_nets() -> tuple[AsymptoticNet, ...]:
    """The nets of an unknown angle, then the explicit ones."""
    return general_nets() + explicit_nets()


def minus(a: Vector, b: Vector) -> Vector:
    """Difference of two triples."""
    return added(a, scaled(-1, b))


def combination(row: Sequence[Any], frame: Sequence[Vector]) -> Vector:
    """Linear combination of the vectors of a frame."""
    total = scaled(row[0], frame[0])
    for factor, vector in zip(row[1:], frame[1:], strict=True):
        total = added(total, scaled(factor, vector))
    return total


def system_defects(
    derived: Sequence[Vector], matrix: Sequence[Sequence[Any]], frame: Sequence[Vector]
) -> dict[str, Vector]:
    """Each derived derivative of the vectors of a frame, minus matrix times frame."""
    return {
        f"row {i + 1}": minus(derived[i], combination(matrix[i], frame)) for i in range(len(frame))
    }


def over_nets(
    setting: Setting,
    nets: Sequence[AsymptoticNet],
    residuals: Callable[[AsymptoticNet], Mapping[str, Any]],
    *,
    shown: str,
) -> Evidence:
    """Evidence that the residuals vanish identically on every net, up to the first that fails."""
    found: dict[str, Evidence] = {}
    for net in nets:
        found[net.name] = identities(setting, residuals(net), shown=shown)
        if found[net.name].outcome == "fail":
            break
    return combined(found, shown=shown)


def squared_norm(net: AsymptoticNet, a: Vector) -> Any:
    """Square of the length of a vector field."""
    return net.calculus.dot(a, a)
