"""The greedy algorithm as printed: its variants, and the shipped algorithm by another route."""

import json
import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from checks.cli import run as command
from checks.grow.printed_cover import areas_and_densities
from checks.printed.greedy_algorithm import PrintedParameters, printed_run
from checks.printed.greedy_reading import MEANT, VARIANTS, Reading
from checks.verify.printed_cuts import shipped_cuts
from checks.verify.printed_runs import Case, parameters_of
from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_parameters import GreedyParameters


def shipped(case: Case):
    radius, sectors, cutoff, step = case
    return grown(
        GreedyParameters(
            radius=Fraction(radius),
            sectors=sectors,
            cutoff=ExactAngle(half_turns=Fraction(cutoff)),
            step=Fraction(step),
        )
    )


@settings(max_examples=12, deadline=None, derandomize=True)
@given(
    radius=st.integers(min_value=10, max_value=35),
    sectors=st.sampled_from([4, 6, 8]),
    cutoff=st.sampled_from(["3/5", "2/3", "3/4", "4/5"]),
)
def test_as_meant_it_makes_the_cuts_of_the_shipped_algorithm(radius, sectors, cutoff):
    case = (str(Fraction(radius, 10)), sectors, cutoff, "1/10")
    run = printed_run(parameters_of(case), MEANT, max_cuts=500)
    found = {s.path: s.cut for s in run.sectors if s.cut is not None}
    wanted = {f"{n}{path}": cut for n in range(sectors) for path, cut in shipped_cuts(case).items()}
    if shipped(case).unresolved_cuts:
        return
    assert run.end == "step 25"
    assert found == wanted


def test_every_variant_takes_one_line_to_the_letter():
    fields = list(Reading.__dataclass_fields__)
    for name, reading in VARIANTS.items():
        letters = sum(getattr(reading, field) for field in fields)
        assert letters == {"letter": len(fields), "meant": 0}.get(name, 1)


@pytest.mark.parametrize(
    "values", [{"sectors": 5}, {"sectors": 2}, {"cutoff": 1.5}, {"cutoff": 4.0}]
)
def test_parameters_outside_step_1_are_refused(values):
    good = {"radius": 2.0, "sectors": 4, "cutoff": 2.0, "step": 0.1}
    assert PrintedParameters(**good).nodes == 40
    with pytest.raises(ValueError, match="expected"):
        PrintedParameters(**{**good, **values})


def test_areas_of_whole_quads_and_at_the_rim_add_up_to_those_of_the_shipped_algorithm():
    """As meant the disk of radius R - Delta is covered: the part of it in the quads is its area."""
    case = ("3", 4, "3/4", "1/10")
    run = printed_run(parameters_of(case), MEANT, max_cuts=500)
    inner = 2.9
    area = sum(
        float(areas_and_densities(sector.corners(), inner, 0.1)[0].sum()) for sector in run.sectors
    )
    assert area == pytest.approx(4 * math.pi * math.sinh(inner / 2) ** 2, rel=1e-9)


def test_energy_is_that_of_the_shipped_algorithm_on_whole_quads():
    case = ("3", 4, "3/4", "1/10")
    run = printed_run(parameters_of(case), MEANT, max_cuts=500)
    energy = sum(
        float(np.prod(areas_and_densities(sector.corners(), 3.0, 0.1), axis=0).sum())
        for sector in run.sectors
    )
    # The quads at the rim that are lost are below 2 % of the disk.
    assert energy < shipped(case).willmore < 1.05 * energy


def test_command_writes_the_fields_of_the_shipped_run(tmp_path: Path, capfd):
    out = tmp_path / "out.json"
    words = ["grow", "--radius", "2", "--step", "1/10", "--json", str(out)]
    assert command(words) == 0
    fields = set(json.loads(out.read_text()))
    assert command([*words, "--as-printed", "meant"]) == 0
    found = json.loads(out.read_text())
    assert set(found) == fields | {"variant", "end", "uncovered", "twice"}
    assert 0.001 < found["uncovered"] < 0.05
    assert found["twice"] == 0
    assert command([*words, "--as-printed"]) == 0
    found = json.loads(out.read_text())
    assert found["variant"] == "letter"
    assert found["uncovered"] > 0.9
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--as-printed", "bogus"], "expected one of letter, fill"),
        (["--as-printed", "--out", "net.ply"], "makes no surface"),
        (["--as-printed", "--step", "1/1000"], "expected at most 1000"),
    ],
)
def test_command_refuses(words, message, capfd, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert command(["grow", "--radius", "2", *words]) == 2
    err = capfd.readouterr().err
    assert message in err
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_variant_that_does_not_end_is_undecided(capfd):
    words = ["--radius", "3", "--step", "1/10", "--max-cuts", "20", "--as-printed", "discard"]
    assert command(["grow", *words]) == 4
    assert "did not end by step 25 but by: max cuts" in capfd.readouterr().err
