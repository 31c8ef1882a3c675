"""`kminusone grow`: what it prints and writes, what it refuses, what it leaves behind."""

import json
import math
import os
import pty
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import jsonschema
import numpy as np
import pytest

from checks.cli import run
from checks.errors import Interrupted
from checks.expression import parse
from checks.grow.files import Files
from discrete.complex_errors import SurgeryError
from theory.greedy_limit import limit_tree

ROOT = Path(__file__).resolve().parent.parent
#: Children run the code beside these tests, wherever the installed package points.
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT)}

NUMBER, COUNT, TEXT = {"type": "number"}, {"type": "integer", "minimum": 0}, {"type": "string"}
OPTIONAL = {"type": ["number", "null"]}
BRANCH = {
    "generation": COUNT,
    "path": {"type": "string", "pattern": "^([0-9]+[uAv]*)?$"},
    "parent": {"type": ["string", "null"]},
    "rho": NUMBER,
    "theta": {"type": "number", "minimum": 0, "exclusiveMaximum": 2 * math.pi},
    "angle": NUMBER,
    "cut_angle": OPTIONAL,
    "distance_to_rim": {"type": "number", "minimum": 0},
}
RESULT = {
    **dict.fromkeys(("radius", "phi0", "cutoff", "step"), NUMBER),
    **dict.fromkeys(("sectors", "branch_points", "generations"), COUNT),
    **dict.fromkeys(("min_angle", "max_angle", "max_curvature"), OPTIONAL),
    **dict.fromkeys(("willmore", "area", "area_expected"), NUMBER),
    "terminated": {"type": "boolean"},
    "seconds": {"type": "number", "minimum": 0},
    "branch": {"type": "array", "items": {}},
    "exact": {"type": "object"},
}


def closed(properties: dict) -> dict:
    """Schema of an object with exactly these properties."""
    return {
        "type": "object",
        "properties": properties,
        "required": list(properties),
        "additionalProperties": False,
    }


SCHEMA = closed(
    {
        **RESULT,
        "branch": {"type": "array", "items": closed(BRANCH)},
        "exact": closed(dict.fromkeys(("radius", "step", "phi0", "cutoff"), TEXT)),
    }
)


@pytest.fixture
def grow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Run the command in an empty folder and return its code, stdout and stderr."""
    monkeypatch.chdir(tmp_path)

    def ask(*arguments: str) -> tuple[int, str, str]:
        code = run(["grow", *arguments])
        return code, *capsys.readouterr()

    return ask


@pytest.fixture
def grown_json(grow):
    """Run the command with --json - and return the data."""

    def ask(*arguments: str) -> dict:
        code, out, err = grow(*arguments, "--json", "-")
        assert (code, err) == (0, "")
        return json.loads(out)

    return ask


RUNS = [
    (["--radius", "3"], 3.0, 4, 0.75),
    (["--radius", "7/2", "--step", "1/80"], 3.5, 4, 0.75),
    (["--radius", "3", "--phi0", "pi/4", "--cutoff", "4*pi/5"], 3.0, 8, 0.8),
    (["--radius", "2.5", "--sectors", "6", "--cutoff", "0.6*pi"], 2.5, 6, 0.6),
]


@pytest.mark.parametrize(("arguments", "radius", "sectors", "cutoff"), RUNS)
def test_the_json_is_of_the_schema_and_consistent(
    grown_json, arguments: list[str], radius: float, sectors: int, cutoff: float
):
    found = grown_json(*arguments)
    jsonschema.validate(found, SCHEMA)
    assert list(found) == list(RESULT)
    assert all(list(entry) == list(BRANCH) for entry in found["branch"])
    assert found["terminated"] is True
    assert found["phi0"] == pytest.approx(2 * math.pi / sectors, rel=1e-15)
    assert found["area_expected"] == pytest.approx(2 * math.pi * (math.cosh(radius) - 1))
    # Rounding of some 10^5 quads.
    assert found["area"] == pytest.approx(found["area_expected"], rel=1e-11)
    assert found["branch_points"] == len(found["branch"])
    assert found["generations"] == max(entry["generation"] for entry in found["branch"])
    cuts = [entry for entry in found["branch"] if entry["generation"] > 0]
    assert found["sectors"] == sectors + 3 * len(cuts)
    low, high = found["min_angle"], found["max_angle"]
    assert 0 < low < high <= cutoff * math.pi
    assert low <= min(entry["angle"] for entry in found["branch"])
    curvature = max(math.tan(high / 2), 1 / math.tan(low / 2))
    assert found["max_curvature"] == pytest.approx(curvature, rel=1e-12)
    # kappa1^2 + kappa2^2 = t^2 + 1/t^2 with t = tan(phi/2) lies between 2 and that of the largest.
    assert 2 * found["area"] < found["willmore"]
    assert found["willmore"] < (curvature**2 + curvature**-2) * found["area"]


@pytest.mark.parametrize(("arguments", "radius", "sectors", "cutoff"), RUNS)
def test_the_branch_points_are_those_of_the_limit_in_every_initial_sector(
    grown_json, arguments: list[str], radius: float, sectors: int, cutoff: float
):
    """theory.greedy_limit shares no code with the nets: cuts are snapped to steps, not more."""
    found = grown_json(*arguments)
    limit = limit_tree(radius, 2 * math.pi / sectors, cutoff * math.pi)
    swap = str.maketrans("uv", "vu")
    wanted = {}
    for cut in limit.cuts:
        for letters in (cut.path, cut.path.translate(swap)):
            wanted.update({f"{number}{letters}": cut for number in range(sectors)})
    cuts = {entry["path"]: entry for entry in found["branch"] if entry["generation"] > 0}
    assert cuts.keys() == wanted.keys()
    assert len(found["branch"]) == len(wanted) + (sectors > 4)
    for path, entry in cuts.items():
        letters = path.lstrip("0123456789")
        assert entry["generation"] == len(letters) + 1
        assert entry["parent"] == (path[:-1] if letters else "")
        # The snapping of a cut moves the next ones: some steps for each generation.
        assert abs(entry["rho"] - wanted[path].rho) < 4 * found["step"] * entry["generation"]
        assert entry["rho"] + entry["distance_to_rim"] == pytest.approx(radius)
        assert 3 * entry["angle"] == pytest.approx(entry["cut_angle"])
        assert entry["cut_angle"] <= cutoff * math.pi


@pytest.mark.parametrize(("arguments", "radius", "sectors", "cutoff"), RUNS)
def test_the_branch_points_have_the_symmetries_of_the_initial_star(
    grown_json, arguments: list[str], radius: float, sectors: int, cutoff: float
):
    branch = [entry for entry in grown_json(*arguments)["branch"] if entry["generation"] > 0]
    per_generation = Counter(entry["generation"] for entry in branch)
    assert all(count % sectors == 0 for count in per_generation.values())
    assert {int(e["path"].rstrip("uAv")) for e in branch} == set(range(sectors))
    phi0 = 2 * math.pi / sectors
    where = [(e["rho"] * math.cos(e["theta"]), e["rho"] * math.sin(e["theta"])) for e in branch]
    for entry in branch:
        number = int(entry["path"].rstrip("uAv"))
        assert number * phi0 < entry["theta"] < (number + 1) * phi0
        for theta in (entry["theta"] + phi0, -entry["theta"]):
            image = (entry["rho"] * math.cos(theta), entry["rho"] * math.sin(theta))
            assert min(math.dist(image, other) for other in where) < 1e-12


def test_the_centre_is_a_branch_point_of_more_than_four_sectors(grown_json):
    assert all(e["path"] for e in grown_json("--radius", "2")["branch"])
    for sectors in (6, 8):
        centre = grown_json("--radius", "2", "--sectors", str(sectors))["branch"][0]
        assert (centre["generation"], centre["path"], centre["parent"]) == (0, "", None)
        assert (centre["rho"], centre["cut_angle"]) == (0, None)
        assert centre["angle"] == pytest.approx(2 * math.pi / sectors)


@pytest.mark.parametrize(
    ("words", "same"),
    [
        (["--phi0", "pi/3"], ["--sectors", "6"]),
        (["--phi0", "0.5*pi"], ["--phi0", "2*pi/4", "--sectors", "4"]),
        (["--step", "0.05"], ["--step", "1/20"]),
        (["--cutoff", "3*pi/4"], []),
        (["--cutoff", "1 + pi/2"], ["--cutoff", "pi/2 + 10/10"]),
    ],
)
def test_one_number_in_two_words_is_one_run(grown_json, words: list[str], same: list[str]):
    first, second = (grown_json("--radius", "2", *given) for given in (words, same))
    first.pop("seconds"), second.pop("seconds")
    assert first == second


def test_the_exact_parameters_can_be_given_again(grown_json):
    words = ["--radius", "1.7", "--step", "0.03", "--sectors", "10", "--cutoff", "0.3 + 2*pi/3"]
    first = grown_json(*words)
    exact = first["exact"]
    assert parse(exact["radius"]).exact == Fraction(17, 10)
    assert parse(exact["cutoff"]).tree == parse("0.3 + 2*pi/3").tree
    again = grown_json(*(w for name, text in exact.items() for w in (f"--{name}", text)))
    first.pop("seconds"), again.pop("seconds")
    assert first == again


def test_the_table_says_what_the_json_says(grow, tmp_path: Path):
    code, out, err = grow("--radius", "3", "--json", "out.json")
    assert (code, err) == (0, "")
    found = json.loads((tmp_path / "out.json").read_text())
    rows = dict(line.split("  ", 1) for line in out.splitlines())
    rows = {name: text.strip() for name, text in rows.items()}
    assert rows["sectors"] == str(found["sectors"])
    assert rows["branch points"].startswith(f"{found['branch_points']}, ")
    assert float(rows["max curvature"]) == pytest.approx(found["max_curvature"], rel=1e-9)
    assert float(rows["area"].split(",")[0]) == pytest.approx(found["area"], rel=1e-9)
    assert rows["terminated"] == "yes"
    assert list(tmp_path.iterdir()) == [tmp_path / "out.json"]


def test_the_number_of_threads_does_not_matter(grown_json):
    words = ["--radius", "6", "--cutoff", "2"]
    results = [grown_json(*words, "--jobs", jobs) for jobs in ("1", "2", "5")]
    for result in results:
        result.pop("seconds")
    assert len(results[0]["branch"]) > 400
    assert results[0] == results[1] == results[2]


def test_the_limit_of_cuts_leaves_a_partial_tree(grow, tmp_path: Path):
    words = ["--radius", "6", "--cutoff", "2"]
    code, out, err = grow(*words, "--max-cuts", "50", "--json", "out.json")
    assert code == 4
    assert err.startswith("kminusone: undecided: stopped after ")
    assert "raise --max-cuts" in err
    assert err.count("\n") == 1
    assert "terminated     no" in out
    found = json.loads((tmp_path / "out.json").read_text())
    jsonschema.validate(found, SCHEMA)
    assert found["terminated"] is False
    # The cut that passes the limit is made with its images, at most two in each initial sector.
    assert 50 < found["branch_points"] <= 58
    assert found["area"] < found["area_expected"]


def test_a_tree_without_a_single_quad_has_no_angles(grow):
    code, out, _ = grow("--radius", "300", "--max-cuts", "1", "--json", "-")
    found = json.loads(out)
    jsonschema.validate(found, SCHEMA)
    assert (code, found["area"]) == (4, 0)
    assert found["min_angle"] is found["max_angle"] is found["max_curvature"] is None
    code, out, _ = grow("--radius", "300", "--max-cuts", "1")
    assert "angles         none" in out


def test_a_step_too_coarse_for_its_cuts_is_warned_of(grow):
    code, _, err = grow("--radius", "6", "--step", "1/2")
    assert code == 0
    assert "cuts fall on a side of their sector: the step 1/2 is too coarse" in err
    assert err.count("\n") == 1


def test_quads_that_do_not_tile_the_disk_are_warned_of(grow, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("discrete.greedy_tree.GreedyTree.area", 56.0)
    code, _, err = grow("--radius", "3")
    assert code == 0
    assert "the quads cover an area of 56 and the disk has 56.97" in err


def test_a_cut_that_rounding_cannot_place_is_undecided(
    grow, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
):
    def refused(*_: object, **__: object) -> None:
        raise SurgeryError("rounding cannot place a cut: change the step a little")

    monkeypatch.setattr("checks.grow.computing._warm_up", lambda: None)
    monkeypatch.setattr("discrete.greedy.grown", refused)
    code, out, err = grow("--radius", "3", "--json", "out.json")
    assert (code, out) == (4, "")
    assert err == "kminusone: undecided: rounding cannot place a cut: change the step a little\n"
    assert list(tmp_path.iterdir()) == []


def test_memory_that_runs_out_is_said_in_one_line(grow, monkeypatch: pytest.MonkeyPatch):
    def refused(*_: object, **__: object) -> None:
        raise MemoryError

    monkeypatch.setattr("checks.grow.computing._warm_up", lambda: None)
    monkeypatch.setattr("discrete.greedy.grown", refused)
    code, out, err = grow("--radius", "3")
    assert (code, out) == (2, "")
    assert "take a larger --step, a smaller --radius or fewer --jobs" in err


@pytest.mark.parametrize(("seconds", "said"), [(0.5, True), (0.0, False)])
def test_compiling_is_told_only_where_it_takes_long(
    grow, monkeypatch: pytest.MonkeyPatch, seconds: float, said: bool
):
    monkeypatch.setattr("checks.grow.computing.NOTICEABLE", 0.05 if said else 60.0)
    monkeypatch.setattr("checks.grow.computing._warm_up", lambda: time.sleep(seconds))
    code, _, err = grow("--radius", "2")
    assert code == 0
    assert ("kminusone: compiling the kernel" in err) is said


BAD = [
    ([], "--radius"),
    (["--radius", "0"], "the radius is 0: expected more than 0"),
    (["--radius", "-1"], "the radius is -1: expected more than 0"),
    (["--radius", "301"], "at most 300"),
    (["--radius", "1e-9", "--step", "1e-9"], "expected at least 1/1000"),
    (["--radius", "sqrt(2)"], "--radius sqrt(2): expected a rational number, give one as 3"),
    (["--radius", "pi"], "--radius pi: expected a rational number"),
    (["--radius", "banana"], "--radius: cannot use 'banana': expected numbers, pi, sqrt"),
    (["--radius", ""], "--radius: cannot use ''"),
    (["--radius", "3)("], "--radius: cannot use '3)('"),
    (["--radius", "9**9**9"], "expected exponents from -64 to 64"),
    (["--radius", "1/0"], "expected a divisor that is not 0"),
    (["--radius", "__import__('os')"], "--radius: cannot use"),
    (["--radius", "nan"], "--radius: cannot use 'nan'"),
    (["--radius", "3", "--step", "0"], "the step is 0: expected more than 0"),
    (["--radius", "3", "--step", "-0.1"], "the step is -0.1"),
    (["--radius", "1/4", "--step", "1/3"], "at most the radius 0.25"),
    (["--radius", "0.01"], "the step is 0.02: expected more than 0, at most the radius 0.01"),
    (["--radius", "3", "--step", "1"], "at most 1/2: give another --radius or --step"),
    (["--radius", "3", "--step", "1e-9"], "expected at least 2e-05 at this radius"),
    (["--radius", "3", "--step", "pi/100"], "--step pi/100: expected a rational number"),
    (["--radius", "3", "--sectors", "5"], "--sectors 5: expected an even integer from 4"),
    (["--radius", "3", "--sectors", "2"], "--sectors 2: expected an even integer from 4"),
    (["--radius", "3", "--sectors", "-4"], "--sectors -4: expected an even integer"),
    (["--radius", "3", "--sectors", "4.5"], "--sectors 4.5: expected an even integer"),
    (["--radius", "3", "--sectors", "2*pi"], "--sectors 2*pi: expected an even integer"),
    (["--radius", "3", "--sectors", "1e30"], "from 4 to 10000"),
    (["--radius", "3", "--phi0", "pi"], "--phi0 pi: expected 2*pi/n with an even integer n"),
    (["--radius", "3", "--phi0", "2*pi/5"], "--phi0 2*pi/5: expected 2*pi/n with an even"),
    (["--radius", "3", "--phi0", "2*pi/3.5"], "expected 2*pi/n with an even"),
    (["--radius", "3", "--phi0", "1.5707963"], "expected 2*pi/n with an even"),
    (["--radius", "3", "--phi0", "pi/2 + 1e-30"], "expected 2*pi/n with an even"),
    (["--radius", "3", "--phi0", "-pi/2"], "expected 2*pi/n with an even"),
    (["--radius", "3", "--phi0", "0"], "expected 2*pi/n with an even"),
    (["--radius", "3", "--phi0", "sqrt(2)"], "--phi0 sqrt(2): expected a + b*pi"),
    (["--radius", "3", "--phi0", "pi/2", "--sectors", "6"], "makes 4 initial sectors"),
    (["--radius", "3", "--cutoff", "pi/2"], "expected an angle between phi0 = pi/2"),
    (["--radius", "3", "--cutoff", "1"], "give another --cutoff, or more --sectors"),
    (["--radius", "3", "--cutoff", "pi"], "and pi: give another --cutoff"),
    (["--radius", "3", "--cutoff", "pi + 1e-40"], "and pi: give another --cutoff"),
    (["--radius", "3", "--cutoff", "sqrt(5)"], "--cutoff sqrt(5): expected a + b*pi"),
    (["--radius", "3", "--cutoff", "3 pi/4"], "--cutoff: cannot use '3 pi/4'"),
    (["--radius", "3", "--max-cuts", "0"], "--max-cuts"),
    (["--radius", "3", "--max-cuts", "1e6"], "--max-cuts"),
    (["--radius", "3", "--jobs", "0"], "--jobs"),
    (["--radius", "3", "--json", "missing/out.json"], "does not exist, create it"),
    (["--radius", "3", "--json", "."], "it is a folder"),
    (["--radius", "3", "--json", ""], "a file without a name"),
    (["--radius", "3", "--json", "/proc/out.json"], "cannot write /proc/out.json"),
    (["3"], "Missing option '--radius'"),
]


@pytest.mark.parametrize(
    ("arguments", "said"), BAD, ids=lambda v: " ".join(v) if isinstance(v, list) else ""
)
def test_bad_input_gets_one_clear_line(grow, tmp_path: Path, arguments: list[str], said: str):
    code, out, err = grow(*arguments, *(() if "--json" in arguments else ("--json", "out.json")))
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("\n") == 1
    assert "Traceback" not in err
    assert len(err) < 400
    assert list(tmp_path.iterdir()) == []


def command(
    *arguments: str, cwd: Path, stderr: int = subprocess.PIPE, **environment: str
) -> subprocess.Popen:
    return subprocess.Popen(
        [sys.executable, "-m", "checks", "grow", *arguments],
        cwd=cwd,
        env={**ENVIRONMENT, **environment},
        stdout=subprocess.PIPE,
        stderr=stderr,
        text=True,
    )


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_an_interrupted_run_says_so_and_writes_nothing(
    grow, tmp_path: Path, jobs: str, number: signal.Signals
):
    grow("--radius", "2")  # the kernels are compiled
    process = command("--radius", "13", "--jobs", jobs, "--json", "out.json", cwd=tmp_path)
    time.sleep(4)
    assert process.poll() is None
    process.send_signal(number)
    sent = time.monotonic()
    _, err = process.communicate(timeout=60)
    # The workers are asked to stop: the rest of the run would take a minute.
    assert time.monotonic() - sent < 8
    assert process.returncode == 130
    assert err == "kminusone: interrupted; nothing was written\n"
    assert list(tmp_path.iterdir()) == []


def test_an_interrupt_while_the_second_file_is_written_names_the_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("checks.grow.files._require_few", lambda *_: None)
    monkeypatch.setattr("checks.grow.files._write_net", interrupted)
    out = tmp_path / "out.json"

    tree = SimpleNamespace(sectors={"quads": np.ones(1), "copies": 1}, parameters=None)
    with pytest.raises(Interrupted, match=r"interrupted; written whole: .*out\.json"):
        Files(json=str(out), net="out.ply", picture=None).write(tree, {"a": 1})
    assert json.loads(out.read_text()) == {"a": 1}
    with pytest.raises(KeyboardInterrupt):
        Files(json=None, net="out.ply", picture=None).write(tree, {"a": 1})


@pytest.mark.parametrize("flags", [[], ["--json", "-"]])
def test_a_closed_pipe_ends_quietly(tmp_path: Path, flags: list[str]):
    process = command("--radius", "8", *flags, cwd=tmp_path)
    process.stdout.close()
    err = process.stderr.read()
    assert "Traceback" not in err
    assert "Broken" not in err
    assert process.wait(timeout=60) == 0
    process.stderr.close()


def on_terminal(*arguments: str, cwd: Path, **environment: str) -> str:
    """What the command draws on a stderr that is a terminal."""
    ours, theirs = pty.openpty()
    process = command(*arguments, cwd=cwd, stderr=theirs, TERM="xterm", **environment)
    os.close(theirs)
    drawn = b""
    try:
        while part := os.read(ours, 1 << 16):
            drawn += part
    except OSError:  # Linux tells the end so
        pass
    os.close(ours)
    process.communicate(timeout=60)
    assert process.returncode == 0
    return drawn.decode()


def test_a_long_run_draws_a_bar_on_a_terminal_alone(grow, tmp_path: Path):
    words = ["--radius", "10.5", "--jobs", "1"]
    drawn = on_terminal(*words, cwd=tmp_path)
    assert "area covered" in drawn
    assert "%" in drawn
    colour = re.compile(r"\x1b\[(?:[39]\d|38;)")
    assert colour.search(drawn)
    plain = on_terminal(*words, cwd=tmp_path, NO_COLOR="1")
    assert "area covered" in plain
    assert not colour.search(plain)
    assert on_terminal("--radius", "3", cwd=tmp_path) == ""
    assert "area covered" not in grow(*words)[2]


def imported(cwd: Path, *commands: list[str]) -> tuple[list[int], set[str]]:
    """Exit codes of the commands in a fresh process, and the heavy packages that they import."""
    code = (
        "import json, sys; from checks.cli import run;"
        f"codes = [run(['grow', *words]) for words in {commands!r}];"
        "heavy = {'sympy', 'numpy', 'numba', 'flint', 'scipy', 'rich', 'discrete', 'theory'};"
        "print(json.dumps([codes, sorted(heavy & set(sys.modules))]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=cwd, capture_output=True, text=True, check=True,
        env=ENVIRONMENT,
    )  # fmt: skip
    codes, heavy = json.loads(done.stdout.splitlines()[-1])
    return codes, set(heavy)


def test_help_and_refusals_import_nothing_heavy(tmp_path: Path):
    words = ["--help"], ["--radius", "banana"], ["--radius", "3", "--sectors", "5"]
    assert imported(tmp_path, *words) == ([0, 2, 2], set())


def test_no_run_imports_sympy(tmp_path: Path):
    codes, heavy = imported(tmp_path, ["--radius", "3", "--cutoff", "2.2", "--json", "out.json"])
    assert codes == [0]
    # Recent releases of numba import scipy themselves.
    assert heavy - {"scipy"} == {"numpy", "numba", "flint", "discrete"}
