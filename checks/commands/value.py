"""`kminusone value`: a named number to any digits, certified or by the reference route."""

from dataclasses import dataclass
from typing import Any

import click

from checks.errors import BadInput
from checks.expression import Expression
from checks.output import STDOUT, require_writable, write_json
from checks.values.assignments import Numbers, numbers
from checks.values.registry import named, values
from checks.values.value import MOST_DIGITS, Key, Value, function_of


@dataclass(frozen=True, kw_only=True)
class Answer:
    """Decimal of a value; radius: bound on its distance from the value, None if uncertified."""

    decimal: str
    radius: str | None
    certified: bool
    route: str


def value_command(
    name: str | None,
    assignments: tuple[str, ...],
    *,
    digits: int,
    certified: bool,
    json_file: str | None,
    list_: bool,
) -> int:
    """Exit code: 0; 4 where the precision reached its cap."""
    require_writable(json_file)
    if list_:
        return _list(json_file)
    if name is None:
        raise BadInput("missing NAME: expected the name of a value, `kminusone value --list`")
    if not 1 <= digits <= MOST_DIGITS:
        raise BadInput(f"digits = {digits}: expected 1 to {MOST_DIGITS}")
    value = named(name)
    given = numbers(value, assignments)
    answer = _answered(value, given, digits, certified or digits > value.reference_digits)
    if isinstance(answer, str):
        click.echo(f"kminusone: undecided: {answer}", err=True)
        return 4
    write_json(json_file, _plain(value, given, digits, answer))
    if json_file != STDOUT:
        click.echo(answer.decimal)
        click.echo(_told(answer))
    return 0


def _answered(value: Value, given: Numbers, digits: int, certified: bool) -> Answer | str:
    """Give the answer, or why it is undecided; raises BadInput outside the function's domain."""
    from theory.errors import DomainError, InsufficientPrecisionError, UndecidedError

    route = value.certified if certified else value.reference
    arguments = _arguments(value.keys, given, certified)
    try:
        function = function_of(route)
        found = function(*arguments) if value.integer else function(*arguments, digits=digits)
    except DomainError as error:
        raise BadInput(f"{value.name}: {_said(error)}") from error
    except (InsufficientPrecisionError, UndecidedError) as error:
        return f"{value.name}: {_said(error)}"
    decimal, radius = _decimal(found, digits)
    return Answer(
        decimal=decimal, radius=radius if certified else None, certified=certified, route=route
    )


def _arguments(keys: tuple[Key, ...], given: Numbers, certified: bool) -> list[Any]:
    """Arguments of a route, None where a key is left out.

    Equal numbers become one object: a route can see that they are equal, which no ball decides.
    """
    numbers_seen: dict[Any, Any] = {}
    arguments: list[Any] = []
    for key in keys:
        number = given.get(key.name)
        if number is None:
            arguments.append(None)
        elif key.even:
            arguments.append(int(number.exact or 0))
        else:
            arguments.append(numbers_seen.setdefault(number.tree, _real(number, certified)))
    return arguments


def _real(number: Expression, certified: bool) -> Any:
    """Rational number, or a function that gives the number at the precision in force."""
    if number.exact is not None:
        return number.exact
    return number.ball if certified else number.mpf


def _said(error: Any) -> str:
    """Text of an error of theory, with the number that it is about."""
    about = error.enclosure and error.enclosure.decimal(12)
    return f"{error}, {about}" if about else str(error)


def _decimal(found: Any, digits: int) -> tuple[str, str]:
    """Decimal rounded to nearest, and a bound on its distance from every number enclosed."""
    from theory.enclosure import Enclosure

    if isinstance(found, int):
        return str(found), "0"
    if not isinstance(found, Enclosure):
        # The same rounding and the same form for a number of mpmath, taken as the point it is.
        sign, mantissa, exponent, _ = found._mpf_
        signed = -int(mantissa) if sign else int(mantissa)
        found = Enclosure(midpoint=(signed, int(exponent)), radius=(0, 0))
    decimal, radius = found.decimal(digits), found.decimal_error(digits)
    if decimal is None or radius is None:
        raise ArithmeticError(f"the enclosure does not decide {digits} digits")
    return decimal, radius


def _told(answer: Answer) -> str:
    if answer.certified:
        return f"certified: within {answer.radius} of the value ({answer.route}, ball arithmetic)"
    return f"not certified: {answer.route} (mpmath); --certified proves the digits"


def _plain(value: Value, given: Numbers, digits: int, answer: Answer) -> dict[str, Any]:
    return {
        "name": value.name,
        "keys": {name: number.text.strip() for name, number in given.items()},
        "value": answer.decimal,
        "radius": answer.radius,
        "certified": answer.certified,
        "digits": digits,
        "routes": [answer.route],
    }


def _list(json_file: str | None) -> int:
    known = values().values()
    write_json(
        json_file,
        {
            "values": [
                {
                    "name": value.name,
                    "meaning": value.meaning,
                    "keys": [
                        {
                            "name": k.name,
                            "meaning": k.meaning,
                            "domain": k.domain,
                            "optional": k.optional,
                        }
                        for k in value.keys
                    ],
                }
                for value in known
            ]
        },
    )
    if json_file != STDOUT:
        for value in known:
            click.echo(f"{value.name}: {value.meaning}")
            for k in value.keys:
                click.echo(f"    {k.domain}: {k.meaning}")
    return 0
