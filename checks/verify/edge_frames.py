"""Frames of the lines of a front with an arbitrary angle, against the systems of (eq:frames).

The frame F = (r_u, N x r_u, N) obeys F_u = A F, F_v = B F with A, B the matrices of a weakly
harmonic normal for the angle theta from r_u to r_v, sigma its orientation.
"""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.printed import asymptotic_frames as frames
from theory import sector_series as series


def edge_frames(setting: Setting, *, torsion_v: int = 1, curvature_sign: int = 1) -> Evidence:
    """Both systems with the curvatures -sigma theta_u and sigma theta_v, theta a function of u, v.

    torsion_v: of the v-lines; curvature_sign: of both curvatures.
    """
    u, v = series.U, series.V
    theta = sp.Function("theta")(u, v)
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        sine, cosine = sigma * sp.sin(theta), sp.cos(theta)
        kappa_u = -sigma * sp.diff(theta, u)
        a = sp.Matrix([[0, kappa_u, 0], [-kappa_u, 0, -1], [0, 1, 0]])
        b = sp.Matrix([[0, 0, -sine], [0, 0, cosine], [sine, -cosine, 0]])
        turn = sp.Matrix([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]])
        moved = sp.diff(turn, v) * turn.T + turn * b * turn.T
        kappa_v = curvature_sign * sigma * sp.diff(theta, v)
        stated_v = sp.Matrix(frames.frenet_v(kappa_v, torsion=torsion_v, back=-torsion_v))
        stated_u = sp.Matrix(frames.frenet_u(curvature_sign * kappa_u))
        residuals[f"u-lines, sigma = {sigma}"] = list(a - stated_u)
        residuals[f"v-lines, sigma = {sigma}"] = list(moved - stated_v)
    return identities(
        setting,
        residuals,
        shown="for any angle theta the frames of u- and v-lines solve the systems of (eq:frames) "
        "with the curvatures -sigma theta_u and sigma theta_v: with theta's values on the edges "
        "taken from kappa_i, those of the edges are the prescribed ones, whatever the functions",
    )
