"""All named values."""

from difflib import get_close_matches

from checks.errors import BadInput
from checks.values import amsler, bessel, bobbin, painleve
from checks.values.value import Value


def values() -> dict[str, Value]:
    """Named values by name, in the order of the listing.

    >>> list(values())[:2]
    ['painleve.angle', 'painleve.slope']
    """
    rooms = (painleve.VALUES, bessel.VALUES, bobbin.VALUES, amsler.VALUES)
    return {value.name: value for room in rooms for value in room}


def named(name: str) -> Value:
    """Value of this name; raises BadInput with the names close to it."""
    known = values()
    if name in known:
        return known[name]
    close = get_close_matches(name, known, n=3, cutoff=0.5)
    hint = f"did you mean {', '.join(close)}?" if close else "`kminusone value --list` lists them"
    raise BadInput(f"unknown value {name[:60]!a}: {hint}")
