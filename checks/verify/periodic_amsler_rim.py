"""Checks of the periodic Amsler surfaces of a disk: where phi is largest, the best sectors."""

from collections.abc import Iterator
from fractions import Fraction
from math import pi, sqrt
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import identities, statement
from checks.verify.ball_bounds import Row, bounded
from checks.verify.initial_angles import fraction
from theory import amsler_ray, periodic_amsler, periodic_amsler_reference
from theory.amsler import U, V
from theory.amsler_ray import RATE, A, B
from theory.amsler_ray_float import rim_point
from theory.painleve_float import angle

_RADII = (Fraction(1, 2), Fraction(1), Fraction(2), Fraction(3), Fraction(5), Fraction(10))


def largest_on_mirror(setting: Setting, *, sense: int = 1, turning: str = "v") -> Evidence:
    """Steps of the proof that on the rim phi is largest on the mirror lines, as identities.

    sense: sign in the rate of b - a; turning: the line along which the angle a turns.
    """
    slope_u, slope_v = amsler_ray.angle_slopes()
    z, phi = amsler_ray.place(), A + B
    rates = amsler_ray.rates(slope_u, slope_v)
    if turning == "u":
        rates |= {A: slope_v * rates[V], B: slope_u * rates[U]}
    n_u, n_v = amsler_ray.unit_normal()
    wedge = U * rates[V] - V * rates[U]
    logs = rates[A] / sp.tan(A) - rates[B] / sp.tan(B)
    claimed_logs = V * sp.sin(B) / sp.tan(A) - U * sp.sin(A) / sp.tan(B)
    along_u, along_v = amsler_ray.velocity()
    turned = sp.diff(z, U) * n_u + sp.diff(z, V) * n_v
    return identities(
        setting,
        {
            "geodesic": list(amsler_ray.geodesic_defects()),
            "unit speed": along_u**2 + 2 * sp.cos(phi) * along_u * along_v + along_v**2 - 1,
            "unit normal": n_u**2 + 2 * sp.cos(phi) * n_u * n_v + n_v**2 - 1,
            "normal to the ray": n_u * along_u
            + sp.cos(phi) * (n_u * along_v + n_v * along_u) + n_v * along_v,
            "(b - a)'": rates[B] - rates[A] - sense * 2 * RATE / z * wedge,
            "(log v'/u')'": logs - 2 * RATE / (z * sp.sin(phi)) * claimed_logs,
            "B' where B = 0": (_wedge_rate(slope_u, slope_v) - U * along_u
                               * amsler_ray.along(along_v / along_u, slope_u, slope_v)
                               ).subs(V, U * along_v / along_u),
            "dz/da_0": turned - 2 / (z * sp.sin(phi)) * (U * sp.cos(A) - V * sp.cos(B)),
            "final bound": U * sp.cos(A) - U * sp.sin(A) * sp.cos(B) / sp.sin(B)
            - U * sp.sin(B - A) / sp.sin(B),
        },
        shown="the ray's equations are those of geodesics; with them b > a and u v' > v u' on "
        "every ray below the mirror line, and z grows at a fixed distance as the ray turns to it",
    )  # fmt: skip


def _wedge_rate(slope_u: Any, slope_v: Any) -> Any:
    """Rate of u v' - v u' along the ray: u v'' - v u''."""
    second = [amsler_ray.along(rate, slope_u, slope_v) for rate in amsler_ray.velocity()]
    return U * second[1] - V * second[0]


def rim_samples(setting: Setting, *, part: str = "1", per_unit: int = 16) -> Evidence:
    """Points of disks, the middle of the rim and others at random, against part of the rim's angle.

    Rays by the Runge-Kutta method with this number of steps per unit of length, good to 1e-4 in
    phi; the reference route gives the angle at the rim of the mirror line.
    """
    rng = setting.random()
    samples = 0
    for radius, sectors in ((1, 6), (2, 8), (3, 16)):
        corner = 2 * pi / sectors
        rim = float(periodic_amsler_reference.rim_angle(radius, sectors, digits=15))
        most = float(Fraction(part)) * rim
        drawn = [(rng.uniform(0.02, 0.98), radius * sqrt(rng.uniform(0.3, 1))) for _ in range(5)]
        for share, depth in [(0.5, float(radius)), *drawn]:
            u, v = rim_point(corner, share, depth, steps=per_unit * radius)
            found = angle(corner, 2 * sqrt(u * v))
            samples += 1
            if found > most + 1e-4:
                return Evidence(
                    outcome="fail", grade="experiment", tried=samples, met=samples,
                    witness=f"2m = {sectors}: phi = {found:.5f} > {most:.5f} at the distance "
                    f"{depth:.3f} on the ray at {share:.3f} of the sector",
                )  # fmt: skip
    return Evidence(
        outcome="pass", grade="experiment", digits=4, tried=samples, met=samples,
        shown="at points drawn on the disks phi is at most its value at the rim of the mirror line",
    )  # fmt: skip


def best_number(setting: Setting, *, shift: int = 0) -> Evidence:
    """Best number of sectors by balls and by mpmath, plus a shift, at R = 1/2, 1, 2, 3, 5, 10."""
    del setting
    found = []
    for radius in _RADII:
        certified = periodic_amsler.best_sectors(radius)
        other = periodic_amsler_reference.best_sectors(radius) + shift
        found.append(str(certified))
        if certified != other:
            return statement(
                False, shown="", witness=f"R = {radius}: {certified} sectors, not {other}"
            )
    return Evidence(
        outcome="pass", grade="certified", tried=len(_RADII), met=len(_RADII),
        shown=f"best numbers of sectors {', '.join(found)} at R = 1/2, 1, 2, 3, 5, 10",
    )  # fmt: skip


def two_routes(setting: Setting, *, shift: str = "0") -> Evidence:
    """Least max curvature by balls against mpmath, relative to 1e-18, at R = 1/2 to 10."""
    del setting

    def rows() -> Iterator[Row]:
        for radius in _RADII:
            with mp.workdps(30):
                other = periodic_amsler_reference.max_curvature(radius, digits=25)
                text = mp.nstr(other, 25)
            gap = (
                periodic_amsler.max_curvature(radius, digits=22).ball() / arb(text)
                - 1
                - fraction(shift)
            )
            yield f"relative gap at R = {radius}", abs(gap), fraction("1e-18")

    return bounded(
        rows(), shown="both routes agree to 18 digits at R = 1/2, 1, 2, 3, 5, 10", sampled=True
    )
