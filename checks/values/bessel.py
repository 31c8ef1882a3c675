"""Values around the modified Bessel function I_0, which bounds the recursion of section 5.1."""

from checks.values.value import Key, Value

DIGITS = 2000

X = Key(name="x", meaning="argument", low="0", high="10000")
Y = Key(name="y", meaning="value of I_0", low="1", high=None)


def _value(name: str, meaning: str, *keys: Key) -> Value:
    return Value(
        name=f"bessel.{name}",
        meaning=meaning,
        keys=keys,
        certified=f"theory.bessel:{name}",
        reference=f"theory.bessel_reference:{name}",
        reference_digits=DIGITS,
    )


VALUES = (
    _value("i0", "modified Bessel function I_0(x)", X),
    _value("i1", "modified Bessel function I_1(x), the derivative of I_0", X),
    _value("inverse_i0", "x >= 0 with I_0(x) = y", Y),
    _value("fixed_point", "x with I_0(x) = 3"),
    _value("supporting_argument", "w where the supporting quadratic touches I_0(2 w^2)/3"),
    _value("supporting_constant", "its constant, the least I_0(2 w^2)/(3 w^2) over w > 0"),
    _value("supporting_scale", "alpha*, the inverse root of that constant"),
)
