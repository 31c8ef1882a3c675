"""Values of the periodic Amsler surfaces: 2m equal Amsler sectors about the centre of a disk."""

from checks.values.value import Key, Value

RADIUS = Key(
    name="radius", meaning="radius of the geodesic disk", low="0", high="100", low_open=True
)
SECTORS = Key(
    name="sectors",
    meaning="number of sectors, the best where it is left out",
    low="4",
    high=None,
    even=True,
    optional=True,
)

VALUES = (
    Value(
        name="amsler.periodic_max_curvature",
        meaning="largest curvature on the disk",
        keys=(RADIUS, SECTORS),
        certified="theory.periodic_amsler:max_curvature",
        reference="theory.periodic_amsler_reference:max_curvature",
        reference_digits=500,
    ),
)
