"""Values of Minding's bobbin in elliptic functions (ex:bobbin, eq:econs, eq:c2energy)."""

from checks.values.value import Key, Value

RADIUS = Key(
    name="radius", meaning="radius of the geodesic disk", low="0", high="1000", low_open=True
)
KAPPA = Key(name="kappa", meaning="curvature of the throat", low="0", high="1000000", low_open=True)
XI = Key(name="xi", meaning="u + v along the asymptotic lines", low="-1000000", high="1000000")


def _value(name: str, meaning: str, keys: tuple[Key, ...], function: str) -> Value:
    return Value(
        name=f"bobbin.{name}",
        meaning=meaning,
        keys=keys,
        certified=f"theory.bobbin_values:{function}",
        reference=f"theory.bobbin_reference:{function}",
    )


VALUES = (
    _value(
        "max_curvature",
        "least of the largest curvatures of the bobbins that contain the disk",
        (RADIUS,),
        "least_max_curvature",
    ),
    _value(
        "disk_max_curvature",
        "largest curvature of one bobbin on a disk about a point of its throat",
        (KAPPA, RADIUS),
        "disk_max_curvature",
    ),
    _value("arc_length", "signed arc length s(xi) from the throat", (KAPPA, XI), "arc_length"),
    _value("radius", "distance rho(xi) from the axis", (KAPPA, XI), "radius"),
    _value("height", "height z(xi) along the axis", (KAPPA, XI), "height"),
    _value("turning_point", "least xi > 0 where s turns", (KAPPA,), "turning_point"),
    _value("period", "period of s(xi)", (KAPPA,), "period"),
    _value(
        "half_length", "arc length from the throat to the singular edge", (KAPPA,), "half_length"
    ),
)
