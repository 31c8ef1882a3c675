"""Frames along curves and surfaces: curvature and torsion of a space curve, and connections."""

from typing import Any

import sympy as sp

from theory.asymptotic_net import AsymptoticNet, VectorCalculus
from theory.vectors import Vector

Frame = tuple[Vector, Vector, Vector]


def curvature_squared(calculus: VectorCalculus, first: Vector, second: Vector) -> Any:
    """Square of the curvature of a curve from its first two derivatives, the first not 0."""
    binormal = calculus.cross(first, second)
    return calculus.dot(binormal, binormal) / calculus.dot(first, first) ** 3


def torsion(calculus: VectorCalculus, first: Vector, second: Vector, third: Vector) -> Any:
    """Torsion of a curve from its first three derivatives, positive for a right-handed helix.

    Undefined where the curvature vanishes.
    """
    binormal = calculus.cross(first, second)
    return calculus.dot(binormal, third) / calculus.dot(binormal, binormal)


def line_torsion(net: AsymptoticNet, along: str) -> Any:
    """Torsion of the "u"- or "v"-lines of a net as space curves, from three derivatives of r."""
    first = net.r_u if along == "u" else net.r_v
    second = net.d(first, along)
    return torsion(net.calculus, first, second, net.d(second, along))


def u_frame(net: AsymptoticNet) -> Frame:
    """Frame (r_u, N x r_u, N) that the surface gives to the u-lines."""
    return (net.r_u, net.calculus.cross(net.normal, net.r_u), net.normal)


def v_frame(net: AsymptoticNet) -> Frame:
    """Frame (r_v, N x r_v, N) that the surface gives to the v-lines."""
    return (net.r_v, net.calculus.cross(net.normal, net.r_v), net.normal)


def gram(calculus: VectorCalculus, frame: Frame) -> sp.Matrix:
    """Matrix of the inner products of the vectors of a frame."""
    return sp.Matrix(3, 3, lambda i, j: calculus.dot(frame[i], frame[j]))


def handedness(calculus: VectorCalculus, frame: Frame) -> Any:
    """Triple product of a frame: 1 for a right-handed orthonormal one, -1 for a left-handed one."""
    return calculus.dot(calculus.cross(frame[0], frame[1]), frame[2])


def connection(net: AsymptoticNet, frame: Frame, along: str) -> sp.Matrix:
    """Matrix A with d(frame) = A frame along "u" or "v", for an orthonormal frame."""
    return sp.Matrix(3, 3, lambda i, j: net.calculus.dot(net.d(frame[i], along), frame[j]))
