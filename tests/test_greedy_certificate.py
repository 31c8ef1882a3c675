"""Certificates of the greedy algorithm: made in balls, refused where any decisive field is off."""

import copy
import json
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from checks.certificates.__main__ import main
from checks.certificates.greedy import verdict
from checks.certificates.greedy_format import MalformedError, certificate
from checks.cli import run as command
from checks.grow.certificate import certificate_of
from checks.searches.greedy_certificates import parameters
from discrete.certified_greedy import certified_tree
from discrete.errors import InsufficientPrecisionError, ShapeError
from discrete.greedy import grown

RUNS = (("2", "1/10", 4, "3/4"), ("3", "1/8", 8, "4/5"), ("5/2", "1/12", 12, "1/2"))


@cache
def made(run: tuple[str, str, int, str]) -> dict[str, Any]:
    return json.loads(json.dumps(certificate_of(certified_tree(parameters(*run)))))


def leaves(data: Any, at: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Places of numbers, texts and nulls in the data."""
    if isinstance(data, dict | list):
        items = data.items() if isinstance(data, dict) else enumerate(data)
        for key, value in items:
            yield from leaves(value, (*at, key))
    else:
        yield at


def decisive(data: dict[str, Any]) -> list[tuple[Any, ...]]:
    """Places that say something about the run: the parameters say which run it is."""
    return [at for at in leaves(data) if at[0] not in ("format", "parameters", "bits")]


def moved(text: str, factor: int, sign: int) -> str:
    """Ball with its midpoint moved by 3 and more of its radii."""
    m, e, r, f = (int(part) for part in text.split())
    shift = sign * (3 + factor) * r * Fraction(2) ** f + sign * Fraction(2) ** (e - 2)
    scale = max(0, e - f + 4, 4)
    middle = (m * Fraction(2) ** e + shift) * Fraction(2) ** (scale - e)
    assert middle.denominator == 1
    return f"{middle.numerator} {e - scale} {r} {f}"


@pytest.mark.parametrize("run", RUNS, ids=str)
def test_a_run_in_balls_has_a_sound_certificate_and_the_cuts_of_the_run_in_floats(run):
    tree, floats = certified_tree(parameters(*run)), grown(parameters(*run))
    cuts = {s.path: None if s.cut is None else (s.cut.i, s.cut.k) for s in tree.sectors}
    assert cuts == {
        path: (int(row["i_cut"]), int(row["k_cut"])) if row["cut"] else None
        for row, path in zip(floats.sectors, floats.paths, strict=True)
    }
    assert tree.branch_point_count == floats.branch_point_count
    assert tree.quad_count == (floats.sectors["quads"] * floats.sectors["copies"]).sum()
    largest = max(float(s.largest.angle) for s in tree.sectors if s.largest)
    smallest = min(float(s.smallest.angle) for s in tree.sectors if s.smallest)
    assert largest == pytest.approx(floats.max_angle, abs=1e-12)
    assert smallest == pytest.approx(floats.min_angle, abs=1e-12)
    said = verdict(certificate(made(run)))
    assert (said.wrong, said.open) == ("", "")
    assert said.quads == sum(s.quads for s in tree.sectors)


@settings(max_examples=120, deadline=None, derandomize=True)
@given(data=st.data(), run=st.sampled_from(RUNS))
def test_any_decisive_field_altered_beyond_its_radius_is_refused(data, run):
    found = copy.deepcopy(made(run))
    *way, last = data.draw(st.sampled_from(decisive(found)))
    room = found
    for key in way:
        room = room[key]
    value = room[last]
    if value is None:
        # The cut of a sector that is whole, or the extremes of one without a vertex in the disk.
        room[last] = next(
            (s[last] for s in found["sectors"] if s[last] is not None), ["0 0 0 0", [0, 0]]
        )
    elif isinstance(value, int):
        room[last] = value + data.draw(st.sampled_from([-2, -1, 1, 2, 1000]))
    elif last == "path":
        room[last] = data.draw(
            st.sampled_from(["uu", "vA", "AAAA", value + "u"]).filter(lambda path: path != value)
        )
    else:
        shift = data.draw(st.integers(0, 10**9))
        room[last] = moved(value, shift, data.draw(st.sampled_from([-1, 1])))
    try:
        said = verdict(certificate(found))
    except MalformedError:
        return
    assert said.wrong


@pytest.mark.parametrize("run", RUNS, ids=str)
def test_missing_doubled_and_foreign_sectors_and_wide_balls_are_refused(run):
    for alter in ("drop", "double", "whole", "wide"):
        found = copy.deepcopy(made(run))
        tree = found["sectors"]
        if alter == "drop":
            tree.pop()
        elif alter == "double":
            tree.append(tree[-1])
        elif alter == "whole":
            tree[0]["cut"] = None
        else:
            tree[0]["opening"] = "3 -1 1 0"
        assert verdict(certificate(found)).wrong


@pytest.mark.parametrize(
    ("name", "value"),
    [("radius", "9/4"), ("step", "1/11"), ("sectors", 6), ("cutoff", ["0", "5/7"])],
)
def test_a_certificate_of_another_run_is_refused(name, value):
    found = copy.deepcopy(made(RUNS[0]))
    found["parameters"][name] = value
    assert verdict(certificate(found)).wrong


@pytest.mark.parametrize(
    "spoil",
    [
        lambda d: d.pop("totals"),
        lambda d: d.update(format="other"),
        lambda d: d["parameters"].update(radius="two"),
        lambda d: d["parameters"].update(sectors=5),
        lambda d: d["sectors"][0].update(opening="1 2 3"),
        lambda d: d["sectors"][0].update(path="x"),
        lambda d: d["sectors"][0].update(quads=1.5),
        lambda d: d.update(sectors={}),
    ],
)
def test_malformed_data_are_refused_in_one_line(spoil):
    found = copy.deepcopy(made(RUNS[0]))
    spoil(found)
    with pytest.raises(MalformedError) as error:
        certificate(found)
    assert "\n" not in str(error.value)


def test_a_tie_is_decided_or_the_run_is_refused():
    """The vertex at distance R on an axis is in the closed disk whatever the bits."""
    run = parameters("2", "1/10", 4, "3/4")
    few = certified_tree(run, bits=64)
    assert [s.quads for s in few.sectors] == [s.quads for s in certified_tree(run).sectors]
    with pytest.raises(InsufficientPrecisionError, match="bits"):
        certified_tree(run, bits=16, limit=20)
    with pytest.raises(ShapeError, match="cuts"):
        certified_tree(parameters("4", "1/10", 4, "3/4"), max_cuts=3)


def test_command_writes_a_certificate_that_can_be_checked(tmp_path: Path, capfd):
    out = tmp_path / "out.json"
    words = ["grow", "--radius", "2", "--step", "1/10", "--certified", "--json", str(out)]
    assert command(words) == 0
    assert "every comparison decided" in capfd.readouterr().out
    assert main([str(out)]) == 0
    assert capfd.readouterr().out.startswith("sound: ")
    data = json.loads(out.read_text())
    data["certificate"]["totals"]["quads"] += 1
    out.write_text(json.dumps(data))
    assert main([str(out)]) == 1
    assert "refuted: totals: quads are" in capfd.readouterr().out
    out.write_text("{")
    assert main([str(out)]) == 2
    assert capfd.readouterr().err.count("\n") == 1
    assert main([]) == 2


def test_command_says_where_no_certificate_can_be_made(tmp_path: Path, capfd):
    out = tmp_path / "out.json"
    words = ["grow", "--radius", "4", "--step", "1/10", "--certified", "--max-cuts", "8"]
    assert command([*words, "--json", str(out)]) == 4
    assert "no certificate" in capfd.readouterr().err
    assert not out.exists()
