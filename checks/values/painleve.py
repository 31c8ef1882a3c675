"""Values of the solution of phi'' + phi'/z = sin phi, phi(0) = phi0, phi'(0) = 0 (PIII)."""

from checks.values.value import Key, Value

DIGITS = 500

PHI0 = Key(name="phi0", meaning="angle at z = 0", low="0", high="pi", low_open=True, high_open=True)
Z = Key(name="z", meaning="place, 2 sqrt(u v)", low="0", high="200")
LEVEL = Key(
    name="level",
    meaning="angle to be reached, at most the first maximum",
    low="phi0",
    high="2*pi",
    high_open=True,
)


def _value(name: str, meaning: str, *keys: Key) -> Value:
    return Value(
        name=f"painleve.{name}",
        meaning=meaning,
        keys=keys,
        certified=f"theory.painleve:{name}",
        reference=f"theory.painleve_reference:{name}",
        reference_digits=DIGITS,
    )


VALUES = (
    _value("angle", "angle phi(z) between the asymptotic lines of an Amsler sector", PHI0, Z),
    _value("slope", "its derivative phi'(z)", PHI0, Z),
    _value("crossing", "first z with phi(z) = level", PHI0, LEVEL),
    _value("diagonal", "integral of cos(phi/2) from 0 to z, length along the mirror line", PHI0, Z),
)
