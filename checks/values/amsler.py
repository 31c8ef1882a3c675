"""Values of the periodic Amsler surfaces: 2m equal Amsler sectors about the centre of a disk."""

from dataclasses import replace

from checks.values.value import Key, Value

RADIUS = Key(
    name="radius", meaning="radius of the geodesic disk", low="0", high="50", low_open=True
)
SECTORS = Key(
    name="sectors",
    meaning="number of sectors, the best where it is left out",
    low="4",
    high=None,
    even=True,
    optional=True,
)


def _value(
    name: str, meaning: str, keys: tuple[Key, ...], function: str, *, integer: bool = False
) -> Value:
    return Value(
        name=f"amsler.{name}",
        meaning=meaning,
        keys=keys,
        certified=f"theory.periodic_amsler:{function}",
        reference=f"theory.periodic_amsler_reference:{function}",
        reference_digits=500,
        integer=integer,
    )


VALUES = (
    _value(
        "periodic_max_curvature",
        "largest curvature on the disk",
        (RADIUS, SECTORS),
        "max_curvature",
    ),
    _value(
        "best_sectors",
        "number of sectors for which it is least",
        (RADIUS,),
        "best_sectors",
        integer=True,
    ),
    _value(
        "rim_angle",
        "largest angle on the disk, where the mirror lines leave it",
        (RADIUS, replace(SECTORS, optional=False, meaning="number of sectors")),
        "rim_angle",
    ),
)
