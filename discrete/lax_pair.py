r"""K-surfaces from Hirota's discrete sine-Gordon equation, its Lax pair and Sym's formula.

A function theta at the vertices with A = theta_1 + theta_2 on each quad solves Hirota's equation

    theta_12 + theta = theta_1 + theta_2 + 2 arg(1 - q e^(-i A)),  q = tanh(a/2) tanh(b/2),

and along a side with turns t it obeys theta_(k+1) = theta_(k-1) + t. In frames where the u-edge
leaves at the angle -theta_1 and the v-edge at theta_2, the frames at the vertices are products of

    U = Z(-theta_1) X(-2 arctan(lambda t_u)) Z(theta),
    V = Z(theta_2) X(2 arctan(t_v/lambda)) Z(-theta)

in SU(2), t = tanh(a/2), Z and X turns about the normal and about the edge. The angles do not depend
on lambda: U V_1 = V U_2 for every lambda > 0 (an associated family). The surface is the derivative
of the frame by log lambda at 1, -Phi' Phi^-1, read as a vector. Where the v-edges lie to the right
of the u-edges, seen from the normal's tip, -theta takes the place of theta in both matrices.
"""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from discrete.sector import Sector
from discrete.space_frame import SpaceFrame, turned

FloatArray = npt.NDArray[np.float64]
ComplexArray = npt.NDArray[np.complex128]
#: Matrix of SU(2) and its derivative by log lambda.
Jet: TypeAlias = tuple[ComplexArray, ComplexArray]


def hirota(sector: Sector) -> FloatArray:
    """Solution theta of Hirota's equation at the vertices: an array (n + 1, m + 1).

    The freedom theta -> theta + c on one colour of the vertices is fixed by theta(0, 0) = 0 and
    theta(1, 0) = theta(0, 1).
    """
    n, m = sector.shape
    theta = np.zeros((n + 1, m + 1))
    theta[1, 0] = theta[0, 1] = sector.corner_angle / 2
    for k in range(1, n):
        theta[k + 1, 0] = theta[k - 1, 0] + sector.u_turns[k - 1]
    for k in range(1, m):
        theta[0, k + 1] = theta[0, k - 1] + sector.v_turns[k - 1]
    t_u, t_v = np.tanh(sector.u_lengths / 2), np.tanh(sector.v_lengths / 2)
    for i in range(n):
        for j in range(m):
            angle = theta[i + 1, j] + theta[i, j + 1]
            bend = np.angle(1 - t_u[i] * t_v[j] * np.exp(-1j * angle))
            theta[i + 1, j + 1] = angle - theta[i, j] + 2 * bend
    return theta


def _turn(angle: FloatArray) -> ComplexArray:
    """Matrices Z of turns about the normal."""
    found = np.zeros((*angle.shape, 2, 2), dtype=complex)
    found[..., 0, 0], found[..., 1, 1] = np.exp(-0.5j * angle), np.exp(0.5j * angle)
    return found


def _twist(t: float, power: int, sign: int) -> Jet:
    """Matrix X of the turn by sign 2 arctan(t lambda^power), with its derivative, at lambda = 1."""
    half = sign * np.arctan(t)
    rate = sign * power * t / (1 + t * t)
    c, s = np.cos(half), np.sin(half)
    matrix = np.array([[c, -1j * s], [-1j * s, c]], dtype=np.complex128)
    slope = rate * np.array([[-s, -1j * c], [-1j * c, -s]], dtype=np.complex128)
    return matrix, slope


def _followed(jet: Jet, before: FloatArray, twist: Jet, after: FloatArray) -> Jet:
    """Frames after an edge, with derivatives: Phi Z(before) X Z(after)."""
    head, tail = jet[0] @ _turn(before), _turn(after)
    slope = jet[1] @ _turn(before) @ twist[0] @ tail + head @ twist[1] @ tail
    return head @ twist[0] @ tail, slope


def lax_frames(sector: Sector, side: int) -> Jet:
    """Frames at the vertices and their derivatives by log lambda: arrays (n + 1, m + 1, 2, 2).

    side: +1 where the v-edges lie to the left of the u-edges, else -1.
    """
    n, m = sector.shape
    theta = side * hirota(sector)
    frames, slopes = (np.zeros((n + 1, m + 1, 2, 2), dtype=complex) for _ in range(2))
    frames[0, 0] = np.eye(2)
    t_u, t_v = np.tanh(sector.u_lengths / 2), np.tanh(sector.v_lengths / 2)
    for i in range(n):
        jet = (frames[i, 0], slopes[i, 0])
        step = _followed(jet, -theta[i + 1, 0], _twist(t_u[i], 1, -1), theta[i, 0])
        frames[i + 1, 0], slopes[i + 1, 0] = step
    for j in range(m):
        jet = (frames[:, j], slopes[:, j])
        step = _followed(jet, theta[:, j + 1], _twist(t_v[j], -1, 1), -theta[:, j])
        frames[:, j + 1], slopes[:, j + 1] = step
    return frames, slopes


def _vectors(matrices: ComplexArray) -> FloatArray:
    """Vectors (..., 3) of matrices -i/2 (x sigma_1 + y sigma_2 + z sigma_3)."""
    return np.stack(
        [
            -2 * matrices[..., 1, 0].imag,
            2 * matrices[..., 1, 0].real,
            -2 * matrices[..., 0, 0].imag,
        ],
        axis=-1,
    )


def sym_surface(sector: Sector, frame: SpaceFrame) -> tuple[FloatArray, FloatArray]:
    """Positions and normals of a sector, arrays (3, n + 1, m + 1), with the frame at its apex."""
    frames, slopes = lax_frames(sector, frame.side)
    inverse = np.conj(np.swapaxes(frames, -1, -2))
    third = np.array([[-0.5j, 0], [0, 0.5j]])
    local, normals = -_vectors(slopes @ inverse), _vectors(frames @ third @ inverse)
    # The frame of the apex has its first axis at the angle theta_1 to the u-edge.
    first = turned(frame.along_u, frame.normal, np.float64(frame.side * sector.corner_angle / 2))
    axes = np.stack([first, np.cross(frame.normal, first), frame.normal])
    return np.moveaxis(local @ axes + frame.point, -1, 0), np.moveaxis(normals @ axes, -1, 0)
