"""From the words KEY=EXPRESSION of the command line to exact numbers in the domain of a value."""

from collections.abc import Mapping, Sequence

from checks.errors import BadInput
from checks.expression import Expression, compare, parse
from checks.values.value import Key, Value

Numbers = dict[str, Expression]


def numbers(value: Value, assignments: Sequence[str]) -> Numbers:
    """Exact number of each key given, all in their domains; raises BadInput.

    >>> from checks.values.registry import named
    >>> {k: e.text for k, e in numbers(named("painleve.angle"), ["z=2", "phi0=pi/3"]).items()}
    {'phi0': 'pi/3', 'z': '2'}
    """
    given: Numbers = {}
    keys = {key.name: key for key in value.keys}
    for word in assignments:
        name, equals, text = word.partition("=")
        if not equals:
            raise BadInput(f"cannot use {word[:60]!a}: expected KEY=EXPRESSION, {_needs(value)}")
        if name not in keys:
            raise BadInput(f"unknown key {name[:60]!a}: {value.name} {_needs(value)}")
        if name in given:
            raise BadInput(f"{name} is given twice: expected it once")
        given[name] = _named(name, text)
    missing = [key.name for key in value.keys if not key.optional and key.name not in given]
    if missing:
        raise BadInput(f"missing {', '.join(missing)}: {value.name} {_needs(value)}")
    for key in value.keys:
        if key.name in given:
            _require(key, given)
    return {key.name: given[key.name] for key in value.keys if key.name in given}


def _named(name: str, text: str) -> Expression:
    try:
        return parse(text)
    except BadInput as error:
        raise BadInput(f"{name}: {error}") from None


def _needs(value: Value) -> str:
    if not value.keys:
        return "takes no key"
    return f"takes {'; '.join(key.domain + ' (optional)' * key.optional for key in value.keys)}"


def _require(key: Key, given: Mapping[str, Expression]) -> None:
    """Refuse a number outside the domain of its key, exactly where both are linear in pi."""
    number = given[key.name]
    low = high = 1
    if key.low is not None:
        low = compare(number, _bound(key.low, given))
    if key.high is not None:
        high = compare(_bound(key.high, given), number)
    outside = min(low, high) < 0 or (key.low_open and low == 0) or (key.high_open and high == 0)
    odd = key.even and (number.exact is None or number.exact % 2 != 0)
    if outside or odd:
        raise BadInput(f"{key.name} = {number.text.strip()}: expected {key.domain}")


def _bound(text: str, given: Mapping[str, Expression]) -> Expression:
    return given[text] if text in given else parse(text)
