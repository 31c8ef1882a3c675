"""`kminusone value`: what it prints, how it rounds, what it refuses."""

import json
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import pytest
from mpmath import mp

from checks.cli import run
from checks.values.registry import values
from checks.values.value import function_of
from theory import bessel_reference, painleve_reference
from theory.enclosure import Enclosure
from theory.errors import InsufficientPrecisionError

EXAMPLES = {
    "sectors": "8",
    "phi0": "pi/7",
    "z": "2.5",
    "level": "3*pi/4",
    "x": "sqrt(2)",
    "y": "17/4",
    "radius": "3/2",
    "kappa": "3",
    "xi": "1/3",
}


def words(name: str) -> list[str]:
    return [f"{key.name}={EXAMPLES[key.name]}" for key in values()[name].keys if not key.optional]


@pytest.fixture
def asked(capsys: pytest.CaptureFixture[str]):
    """Run the command and return its code, stdout's lines and stderr."""

    def ask(*arguments: str):
        code = run(["value", *arguments])
        out, err = capsys.readouterr()
        return code, out.splitlines(), err

    return ask


@pytest.mark.parametrize("name", values())
def test_both_routes_of_every_value_agree_to_the_last_digit(asked, name: str):
    code, reference, _ = asked(name, *words(name), "--digits", "25")
    assert code == 0
    assert reference[1].startswith("not certified")
    code, certified, _ = asked(name, *words(name), "--digits", "25", "--certified")
    assert code == 0
    assert certified[1].startswith("certified: within ")
    assert certified[0] == reference[0]
    if not values()[name].integer:
        assert len(Decimal(certified[0]).as_tuple().digits) == 25


@pytest.mark.parametrize("name", values())
def test_the_routes_share_no_module(name: str):
    value = values()[name]
    assert value.certified.partition(":")[0] != value.reference.partition(":")[0]
    for route in (value.certified, value.reference):
        assert function_of(route).__doc__


@pytest.mark.parametrize("certified", [True, False])
def test_json_says_what_the_two_lines_say(asked, tmp_path: Path, certified: bool):
    out = tmp_path / "out.json"
    flags = ["--certified"] if certified else []
    code, lines, _ = asked(
        "bessel.inverse_i0", "y=10", "--digits", "12", *flags, "--json", str(out)
    )
    assert code == 0
    told = json.loads(out.read_text())
    assert told["name"] == "bessel.inverse_i0"
    assert told["keys"] == {"y": "10"}
    assert told["value"] == lines[0]
    assert told["digits"] == 12
    assert told["certified"] is certified
    assert told["routes"]
    if certified:
        with mp.workdps(40):
            error = abs(bessel_reference.inverse_i0(10) - mp.mpf(told["value"]))
            assert error <= mp.mpf(told["radius"]) < 1e-11
            # The radius bounds the distance to the decimal printed, which is mostly its rounding.
            assert error >= mp.mpf(told["radius"]) * 0.98
    else:
        assert told["radius"] is None


def test_json_on_stdout_is_all_of_stdout(asked):
    code, lines, _ = asked("bessel.fixed_point", "--json", "-")
    assert code == 0
    assert json.loads("\n".join(lines))["value"].startswith("2.378354695")


def test_the_list_names_every_value_with_its_keys(asked):
    code, lines, _ = asked("--list")
    assert code == 0
    for name, value in values().items():
        (place,) = (i for i, line in enumerate(lines) if line.startswith(f"{name}:"))
        for offset, key in enumerate(value.keys, start=1):
            assert key.domain in lines[place + offset]
    code, lines, _ = asked("--list", "--json", "-")
    told = json.loads("\n".join(lines))
    assert [entry["name"] for entry in told["values"]] == list(values())


@pytest.mark.parametrize("flags", [[], ["--certified"]])
@pytest.mark.parametrize("digits", [1, 2, 7, 40])
def test_the_decimal_is_rounded_to_nearest(asked, flags: list[str], digits: int):
    _, (decimal, _), _ = asked("painleve.angle", "phi0=1", "z=3", "--digits", str(digits), *flags)
    exact = painleve_reference.angle(1, 3, digits=60)
    with mp.workdps(70):
        unit = mp.mpf(10) ** (1 - digits)
        assert abs(mp.mpf(decimal) - exact) <= unit / 2
    assert len(Decimal(decimal).as_tuple().digits) == digits


@pytest.mark.parametrize(
    ("found", "said"),
    [
        (mp.mpf("0.125"), "0.12"),
        (mp.mpf("0.375"), "0.38"),
        (mp.mpf("-2.5"), "-2.5"),
        (mp.mpf(2) ** -40, "9.1e-13"),
        (mp.mpf(2) ** 40, "1.1e+12"),
        (mp.mpf(0), "0"),
        (Enclosure(midpoint=(999, 0), radius=(1, -3)), "1.0e+3"),
    ],
)
def test_the_form_of_a_decimal(asked, monkeypatch: pytest.MonkeyPatch, found, said: str):
    monkeypatch.setattr("theory.bessel_reference.fixed_point", lambda *, digits: found)
    code, lines, _ = asked("bessel.fixed_point", "--digits", "2")
    assert (code, lines[0]) == (0, said)


def test_an_undecided_value_is_never_printed(asked, monkeypatch: pytest.MonkeyPatch):
    def capped(*, digits: int):
        raise InsufficientPrecisionError(f"{digits} digits not reached: the limit is 64 bits")

    monkeypatch.setattr("theory.bessel.fixed_point", capped)
    code, lines, err = asked("bessel.fixed_point", "--certified")
    assert (code, lines) == (4, [])
    assert err == (
        "kminusone: undecided: bessel.fixed_point: 30 digits not reached: the limit is 64 bits\n"
    )


@pytest.mark.parametrize("flags", [[], ["--certified"]])
@pytest.mark.parametrize("number", ["pi/2", "1/3", "1", "sqrt(2)"])
def test_a_level_equal_to_phi0_is_crossed_at_0(asked, number: str, flags: list[str]):
    """No ball decides such a tie; the expressions do."""
    again = "0.5*pi" if number == "pi/2" else number
    code, lines, _ = asked("painleve.crossing", f"phi0={number}", f"level={again}", *flags)
    assert (code, lines[0]) == (0, "0")


def test_more_digits_than_the_reference_gives_are_certified(asked):
    code, lines, _ = asked("painleve.angle", "phi0=1", "z=1/2", "--digits", "501")
    assert code == 0
    assert lines[1].startswith("certified")
    assert len(lines[0]) == 502


def test_the_largest_number_of_digits(asked):
    code, lines, _ = asked("bobbin.max_curvature", "radius=1", "--digits", "10000", "--certified")
    assert code == 0
    with mp.workdps(10010):
        # Fractions, as int(text) refuses more than 4300 digits.
        top, bottom = Decimal(lines[0]).as_integer_ratio()
        assert abs(mp.mpf(top) / bottom - mp.cosh(1)) <= mp.mpf(10) ** -9999 / 2


def test_the_best_number_of_sectors_is_taken_where_it_is_left_out(asked):
    best = asked("amsler.periodic_max_curvature", "radius=2", "--digits", "20")
    given = [
        asked("amsler.periodic_max_curvature", "radius=2", f"sectors={n}", "--digits", "20")
        for n in (6, 8, 10)
    ]
    assert best[1][0] == min((lines[0] for code, lines, _ in given if code == 0), key=Fraction)


BAD = [
    (["painleve.angle", "phi0=pi", "z=1"], "phi0 = pi: expected 0 < phi0 < pi"),
    (["painleve.angle", "phi0=0", "z=1"], "phi0 = 0: expected 0 < phi0 < pi"),
    (["painleve.angle", "phi0=-1", "z=1"], "expected 0 < phi0 < pi"),
    (["painleve.angle", "phi0=1", "z=-1"], "z = -1: expected 0 <= z <= 200"),
    (["painleve.angle", "phi0=1", "z=201"], "expected 0 <= z <= 200"),
    (["painleve.angle", "phi0=1"], "missing z"),
    (["painleve.angle", "phi0=1", "z=1", "z=1"], "z is given twice"),
    (["painleve.angle", "phi0=1", "y=1"], "unknown key 'y'"),
    (["painleve.angle", "phi0=1", "1"], "expected KEY=EXPRESSION"),
    (["painleve.angle", "phi0", "=", "1"], "expected KEY=EXPRESSION"),
    (["painleve.angle", "phi0=9**9**9", "z=1"], "expected exponents from -64 to 64"),
    (["painleve.angle", "phi0=__import__('os')", "z=1"], "expected numbers, pi, sqrt"),
    (["painleve.angle", "phi0=", "z=1"], "expected numbers, pi, sqrt"),
    (["painleve.angle", "phi0=" + "1+" * 100 + "1", "z=1"], "at most 200 characters"),
    (["painleve.angle", "phi0=1\x00", "z=1"], "expected numbers, pi, sqrt"),
    (["painleve.angle", "phi0=\u0661", "z=1"], "expected numbers, pi, sqrt"),
    (["painleve.crossing", "phi0=2", "level=1"], "level = 1: expected phi0 <= level < 2*pi"),
    (["painleve.crossing", "phi0=1", "level=5"], "above the first maximum"),
    (["painleve.crossing", "phi0=1", "level=5", "--certified"], "first maximum"),
    (["painleve.crossing", "phi0=1", "level=2*pi"], "expected phi0 <= level < 2*pi"),
    (["bessel.inverse_i0", "y=0.999"], "expected 1 <= y"),
    (["bessel.fixed_point", "y=1"], "takes no key"),
    (["bobbin.max_curvature", "radius=0"], "expected 0 < radius"),
    (["amsler.periodic_max_curvature", "radius=1", "sectors=5"], "an even integer"),
    (["amsler.periodic_max_curvature", "radius=1", "sectors=4.5"], "an even integer"),
    (["amsler.periodic_max_curvature", "radius=1", "sectors=2*pi"], "an even integer"),
    (["amsler.periodic_max_curvature", "radius=1", "sectors=2"], "4 <= sectors"),
    (["amsler.periodic_max_curvature", "radius=5", "sectors=6"], "singular edge"),
    (["painleve.angel", "phi0=1", "z=1"], "did you mean painleve.angle"),
    (["\u202eevil", "z=1"], "`kminusone value --list` lists them"),
    ([], "missing NAME"),
    (["bessel.fixed_point", "--digits", "0"], "--digits"),
    (["bessel.fixed_point", "--digits", "10000000"], "--digits"),
    (["bessel.fixed_point", "--digits", "1.5"], "--digits"),
    (["bessel.fixed_point", "--json", "missing/out.json"], "does not exist, create it"),
]


@pytest.mark.parametrize(
    ("arguments", "said"), BAD, ids=lambda v: ascii(" ".join(v))[:60] if isinstance(v, list) else ""
)
def test_bad_input_gets_one_clear_line(asked, arguments: list[str], said: str):
    code, lines, err = asked(*arguments)
    assert (code, lines) == (2, [])
    assert said in err
    assert err.count("\n") == 1
    assert "Traceback" not in err
    assert len(err) < 400


def test_help_and_the_list_import_nothing_heavy(tmp_path: Path):
    code = (
        "import sys; from checks.cli import run;"
        "run(['value', '--help']); run(['value', '--list']);"
        "heavy = {'sympy', 'numpy', 'mpmath', 'flint', 'scipy', 'theory'} & set(sys.modules);"
        "sys.exit(' '.join(sorted(heavy)) or 0)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_a_certified_value_imports_neither_sympy_nor_scipy(tmp_path: Path):
    code = (
        "import sys; from checks.cli import run;"
        "run(['value', 'painleve.crossing', 'phi0=pi/100', 'level=pi', '--certified']);"
        "sys.exit(' '.join({'sympy', 'numpy', 'scipy'} & set(sys.modules)) or 0)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stderr
