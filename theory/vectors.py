"""Euclidean vectors of R^3 as triples of sympy expressions."""

from typing import Any

Vector = tuple[Any, Any, Any]


def dot(a: Vector, b: Vector) -> Any:
    """Inner product of two triples."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Cross product of two triples, right-handed."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def triple(a: Vector, b: Vector, c: Vector) -> Any:
    """Triple product a . (b x c)."""
    return dot(a, cross(b, c))


def scaled(factor: Any, a: Vector) -> Vector:
    """Multiple of a triple."""
    return (factor * a[0], factor * a[1], factor * a[2])


def added(a: Vector, b: Vector) -> Vector:
    """Sum of two triples."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def derivative(a: Vector, *variables: Any) -> Vector:
    """Partial derivative of a triple of sympy expressions by the variables in turn."""
    return (a[0].diff(*variables), a[1].diff(*variables), a[2].diff(*variables))
