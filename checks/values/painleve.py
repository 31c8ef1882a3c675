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

VALUES = (
    Value(
        name="painleve.angle",
        meaning="angle phi(z) between the asymptotic lines of an Amsler sector",
        keys=(PHI0, Z),
        certified="theory.painleve:angle",
        reference="theory.painleve_reference:angle",
        reference_digits=DIGITS,
    ),
    Value(
        name="painleve.slope",
        meaning="its derivative phi'(z)",
        keys=(PHI0, Z),
        certified="theory.painleve:slope",
        reference="theory.painleve_reference:slope",
        reference_digits=DIGITS,
    ),
    Value(
        name="painleve.crossing",
        meaning="first z with phi(z) = level",
        keys=(PHI0, LEVEL),
        certified="theory.painleve:crossing",
        reference="theory.painleve_reference:crossing",
        reference_digits=DIGITS,
    ),
    Value(
        name="painleve.diagonal",
        meaning="signed integral of cos(phi/2) from 0 to z, the length along the mirror line",
        keys=(PHI0, Z),
        certified="theory.painleve:diagonal",
        reference="theory.painleve_reference:diagonal",
        reference_digits=DIGITS,
    ),
)
