"""Geodesics from a point of a disk of H^2 to the disk's rim (eq:cut-coordinates).

Hyperboloid model: triples X with -X0^2 + X1^2 + X2^2 = -1, the centre (1, 0, 0). The point lies at
distance d from the centre; a geodesic leaves it at an angle whose cosine c is taken against the
radius outwards, and after the length l is at distance R from the centre. The point is at distance
s = R - d from the rim.
"""

from typing import Any

import sympy as sp
from flint import arb

Triple = tuple[Any, Any, Any]


def point(offset: Any) -> Triple:
    """Point at this distance from the centre, on the first axis."""
    return (sp.cosh(offset), sp.sinh(offset), sp.Integer(0))


def direction(offset: Any, cosine: Any) -> Triple:
    """Unit vector at the point whose angle with the radius outwards has this cosine."""
    outward, sideways = sp.diff(sp.Matrix(point(_T)), _T).subs(_T, offset), (0, 0, 1)
    sine = sp.sqrt(1 - cosine**2)
    a, b, c = (cosine * o + sine * e for o, e in zip(outward, sideways, strict=True))
    return (a, b, c)


def along(offset: Any, cosine: Any, length: Any) -> Triple:
    """Point of the geodesic after this length: cosh(l) p + sinh(l) v."""
    p, v = point(offset), direction(offset, cosine)
    a, b, c = (sp.cosh(length) * x + sp.sinh(length) * y for x, y in zip(p, v, strict=True))
    return (a, b, c)


def cosh_radius(offset: Any, cosine: Any, length: Any) -> Any:
    """Cosh of the distance from the centre at which the geodesic of this length ends."""
    return along(offset, cosine, length)[0]


def axis_length(radius: Any, offset: Any, cosine: Any) -> Any:
    """Ball of the length of the geodesic to the rim of the disk of this radius, for offset < R.

    radius, offset, cosine: balls. e^l is the larger root of (A + B) x^2 - 2 cosh R x + A - B = 0,
    A = cosh d, B = c sinh d.
    """
    a, b, rim = offset.cosh(), cosine * offset.sinh(), radius.cosh()
    root: arb = (rim + (rim * rim - a * a + b * b).sqrt()) / (a + b)
    return root.log()


def least_cosine(radius: Any, offset: Any) -> Any:
    """Least cosine for which the geodesic is at most R long: -tanh(d/2)/tanh R."""
    c = sp.Symbol("c", real=True)
    return sp.solve(cosh_radius(offset, c, radius) - sp.cosh(radius), c)[0]


_T = sp.Symbol("t", real=True)
