"""Rank of a matrix over the field of two elements, its rows given as bits of integers."""

from collections.abc import Iterable


def binary_rank(rows: Iterable[int]) -> int:
    """Number of rows that are no sum of others, by elimination on the leading bit."""
    leading: dict[int, int] = {}
    for row in rows:
        rest = row
        while rest and (top := rest.bit_length()) in leading:
            rest ^= leading[top]
        if rest:
            leading[top] = rest
    return len(leading)


def bits(places: Iterable[int]) -> int:
    """Row with ones at these places, modulo 2."""
    row = 0
    for place in places:
        row ^= 1 << place
    return row
