"""Values around the modified Bessel function I_0, which bounds the recursion of section 5.1."""

from checks.values.value import Key, Value

DIGITS = 2000

X = Key(name="x", meaning="argument", low="0", high="10000")
Y = Key(name="y", meaning="value of I_0", low="1", high=None)

VALUES = (
    Value(
        name="bessel.i0",
        meaning="modified Bessel function I_0(x)",
        keys=(X,),
        certified="theory.bessel:i0",
        reference="theory.bessel_reference:i0",
        reference_digits=DIGITS,
    ),
    Value(
        name="bessel.i1",
        meaning="modified Bessel function I_1(x), the derivative of I_0",
        keys=(X,),
        certified="theory.bessel:i1",
        reference="theory.bessel_reference:i1",
        reference_digits=DIGITS,
    ),
    Value(
        name="bessel.inverse_i0",
        meaning="x >= 0 with I_0(x) = y",
        keys=(Y,),
        certified="theory.bessel:inverse_i0",
        reference="theory.bessel_reference:inverse_i0",
        reference_digits=DIGITS,
    ),
    Value(
        name="bessel.fixed_point",
        meaning="x with I_0(x) = 3",
        keys=(),
        certified="theory.bessel:fixed_point",
        reference="theory.bessel_reference:fixed_point",
        reference_digits=DIGITS,
    ),
    Value(
        name="bessel.supporting_argument",
        meaning="w where the supporting quadratic touches I_0(2 w^2)/3",
        keys=(),
        certified="theory.bessel:supporting_argument",
        reference="theory.bessel_reference:supporting_argument",
        reference_digits=DIGITS,
    ),
    Value(
        name="bessel.supporting_constant",
        meaning="its constant, the least I_0(2 w^2)/(3 w^2) over w > 0",
        keys=(),
        certified="theory.bessel:supporting_constant",
        reference="theory.bessel_reference:supporting_constant",
        reference_digits=DIGITS,
    ),
    Value(
        name="bessel.supporting_scale",
        meaning="alpha*, the largest w/sqrt(I_0(2 w^2)/3): the quadratic is (w/alpha*)^2",
        keys=(),
        certified="theory.bessel:supporting_scale",
        reference="theory.bessel_reference:supporting_scale",
        reference_digits=DIGITS,
    ),
)
