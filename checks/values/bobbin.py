"""Values of Minding's bobbin (ex:bobbin, eq:c2energy)."""

from checks.values.value import Key, Value

RADIUS = Key(
    name="radius", meaning="radius of the geodesic disk", low="0", high="1000", low_open=True
)
KAPPA = Key(name="kappa", meaning="curvature of the throat", low="0", high=None, low_open=True)
XI = Key(name="xi", meaning="u + v along the asymptotic lines", low=None, high=None)

VALUES = (
    Value(
        name="bobbin.max_curvature",
        meaning="least of the largest curvatures of the bobbins that contain the disk",
        keys=(RADIUS,),
        certified="theory.bobbin_values:max_curvature",
        reference="theory.bobbin_reference:max_curvature",
    ),
)
