"""The surfaces on which the checks of section 3.1 compare printed formulas with derived fields."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from theory.asymptotic_net import AsymptoticNet, general_net
from theory.surfaces import dini, kuen, pseudosphere
from theory.vectors import Vector, added, scaled

ROUTES = (
    "derived from Gauss-Weingarten for an unknown angle and either sign of sigma, and by "
    "differentiating the pseudosphere and Dini's surface on both sides of their edges"
)


def general_nets() -> Iterator[AsymptoticNet]:
    """Nets of an unknown angle for both signs of sigma, from Gauss-Weingarten."""
    yield general_net(1)
    yield general_net(-1)


def simple_nets() -> Iterator[AsymptoticNet]:
    """Pseudosphere and Dini's surface (a = 2) on both sides of their edges."""
    for front in (pseudosphere(), dini(2)):
        yield front.net(1)
        yield front.net(-1)


def explicit_nets() -> Iterator[AsymptoticNet]:
    """Pseudosphere and Dini's surface on both sides of their edges, Kuen's surface on one."""
    yield from simple_nets()
    yield kuen().net(-1)


def all_nets() -> Iterator[AsymptoticNet]:
    """Nets of an unknown angle, then pseudosphere and Dini's surface."""
    yield from general_nets()
    yield from simple_nets()


def every_net() -> Iterator[AsymptoticNet]:
    """Nets of an unknown angle, then all the explicit ones, Kuen's surface among them."""
    yield from general_nets()
    yield from explicit_nets()


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
    nets: Iterable[AsymptoticNet],
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
