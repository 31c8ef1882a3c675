"""Certificates of the greedy algorithm: made in balls, refused where any decisive field is off."""

import copy
import dataclasses
import json
import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st

from checks.certificates.__main__ import main
from checks.certificates.greedy import verdict
from checks.certificates.greedy_format import MalformedError, certificate
from checks.cli import run as command
from checks.grow.certificate import certificate_of
from checks.grow.certified import ROUNDING, difference
from checks.searches.greedy_certificates import parameters
from discrete.certified_area import ClippingDisk
from discrete.certified_greedy import WIDE, certified_tree
from discrete.certified_tree import CertifiedTree
from discrete.clipped_quads import clipped_area
from discrete.complex_errors import SurgeryError
from discrete.enclosure import Enclosure, fraction_of
from discrete.errors import InsufficientPrecisionError, ShapeError
from discrete.greedy import grown

RUNS = (("2", "1/10", 4, "3/4"), ("3", "1/8", 8, "4/5"), ("5/2", "1/12", 12, "1/2"))

#: Coarse runs, with cuts on a side, at the centre itself, and angles that leap beyond pi, in the
#: disk beyond 2 pi minus the cutoff and elsewhere beyond 2 pi.
COARSE = (
    ("3", "1/6", 4, "99/100"),
    ("4", "1/2", 6, "999/1000"),
    ("6", "1/2", 6, "3/4"),
    ("8", "1/2", 8, "1/2"),
    ("123/50", "1/8", 4, "99/100"),
    ("6", "1/3", 4, "9/10"),
)


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


@pytest.mark.parametrize("run", RUNS + COARSE, ids=str)
def test_a_run_in_balls_has_a_sound_certificate_and_the_sectors_of_the_run_in_floats(run):
    tree, floats = certified_tree(parameters(*run)), grown(parameters(*run))
    assert difference(tree, floats) == ""
    assert tree.branch_point_count == floats.branch_point_count
    assert tree.generations == floats.generations
    assert tree.sector_count == floats.sector_count
    assert floats.area == pytest.approx(floats.parameters.area, rel=ROUNDING)
    said = verdict(certificate(made(run)))
    assert (said.wrong, said.open) == ("", "")
    assert said.quads == sum(s.quads for s in tree.sectors)


@given(
    angle=st.fractions(Fraction(1, 10), Fraction(29, 10), max_denominator=50),
    turn=st.fractions(-3, 3, max_denominator=50),
    distance=st.fractions(Fraction(4, 5), Fraction(6, 5), max_denominator=50),
)
@settings(max_examples=60, deadline=None, derandomize=True)
def test_clipped_areas_in_balls_hold_those_in_floats(angle, turn, distance):
    """Rhombi with edges 1/4 and a vertex at a distance near the radius 1 of the disk."""
    step, (phi, at, away) = 0.25, (float(x) for x in (angle, turn, distance))
    s, c, cosh, sinh = math.sin(phi), math.cos(phi), math.cosh(step), math.sinh(step)
    first, second = (
        math.cosh(away) * cosh + math.sinh(away) * sinh * math.cos(at + x) for x in (0, phi)
    )
    q = math.tanh(step / 2) ** 2
    more = 2 * q * (c - q) / ((1 - q * c) ** 2 + (q * s) ** 2) * (first + second)
    heights = math.cosh(away), first, first + second - math.cosh(away) + more, second
    floats = clipped_area(cosh, sinh, math.cosh(1), s, c, heights)
    disk = ClippingDisk(rim=arb(math.cosh(1)), cosh_length=arb(cosh), sinh_length=arb(sinh))
    balls = disk.clipped_area(arb(s), arb(c), tuple(arb(h) for h in heights))
    assert balls.rad() < ROUNDING
    assert abs(balls - floats) < ROUNDING


def test_the_coarse_runs_have_what_they_are_for():
    trees = [certified_tree(parameters(*run)) for run in COARSE]
    cuts = [s.cut for tree in trees for s in tree.sectors if s.cut]
    assert any(cut.rho.ends() == (0, 0) for cut in cuts)
    assert any((cut.i == 0) != (cut.k == 0) for cut in cuts)
    assert any(float(cut.row.angle) > math.pi for cut in cuts)


def spoilt(tree: CertifiedTree, number: int, **changes: Any) -> CertifiedTree:
    sectors = list(tree.sectors)
    sectors[number] = dataclasses.replace(sectors[number], **changes)
    return dataclasses.replace(tree, sectors=tuple(sectors))


def test_a_tree_that_is_not_that_in_floats_is_told_from_it():
    run = parameters(*RUNS[0])
    tree, floats = certified_tree(run), grown(run)
    first, cut = tree.sectors[0], tree.sectors[0].cut
    assert cut is not None
    elsewhere = Enclosure.of(arb(float(cut.rho)) + 1e-8)
    moved_cut = dataclasses.replace(cut, rho=elsewhere)
    assert "other sectors" in difference(dataclasses.replace(tree, sectors=(first,)), floats)
    assert "quads" in difference(spoilt(tree, 0, quads=first.quads + 1), floats)
    assert "cut" in difference(spoilt(tree, 0, cut=dataclasses.replace(cut, k=cut.k - 1)), floats)
    assert "cut_rho" in difference(spoilt(tree, 0, cut=moved_cut), floats)
    assert "copies" in difference(spoilt(tree, 1, copies=1), floats)


def altered(value: Any, last: Any, data: dict[str, Any]) -> Any:
    """Another value for a leaf: a number beyond its radius, a count one on, another path."""
    if value is None:
        return next((s[last] for s in data["sectors"] if s[last] is not None), ["0 0 0 0", [0, 0]])
    if isinstance(value, int):
        return value + 1
    return value + "u" if last == "path" else moved(value, 0, 1)


def put(data: dict[str, Any], at: tuple[Any, ...], change: Callable[[Any], Any]) -> None:
    *way, last = at
    room: Any = data
    for key in way:
        room = room[key]
    room[last] = change(room[last])


def is_refused(data: dict[str, Any]) -> bool:
    try:
        return bool(verdict(certificate(data)).wrong)
    except MalformedError:
        return True


@pytest.mark.parametrize("run", [RUNS[0], COARSE[1]], ids=str)
def test_every_single_decisive_field_is_decisive(run):
    places = decisive(made(run))
    assert len(places) > 40
    for at in places:
        found = copy.deepcopy(made(run))
        put(found, at, lambda value, at=at, found=found: altered(value, at[-1], found))
        assert is_refused(found), at


@settings(max_examples=400, deadline=None, derandomize=True)
@given(data=st.data(), run=st.sampled_from(RUNS + COARSE[:2]))
def test_any_decisive_field_altered_beyond_its_radius_is_refused(data, run):
    found = copy.deepcopy(made(run))
    at = data.draw(st.sampled_from(decisive(found)))

    def change(value: Any) -> Any:
        if isinstance(value, int):
            return value + data.draw(st.sampled_from([-2, -1, 1, 2, 1000]))
        if at[-1] == "path":
            paths = ["uu", "vA", "AAAA", value + "u"]
            return data.draw(st.sampled_from([path for path in paths if path != value]))
        if value is None:
            # The cut of a sector that is whole, or extremes where no vertex is in the disk.
            return altered(value, at[-1], found)
        return moved(value, data.draw(st.integers(0, 10**9)), data.draw(st.sampled_from([-1, 1])))

    put(found, at, change)
    assert is_refused(found)


@pytest.mark.parametrize("run", RUNS, ids=str)
def test_missing_doubled_and_foreign_sectors_and_wide_balls_are_refused(run):
    for alter in ("none", "drop", "double", "whole", "wide"):
        found = copy.deepcopy(made(run))
        tree = found["sectors"]
        if alter == "none":
            tree.clear()
        elif alter == "drop":
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
    assert all(fraction_of(e.radius) <= WIDE for s in few.sectors for e in s.enclosures())
    assert [s.quads for s in few.sectors] == [s.quads for s in certified_tree(run).sectors]
    with pytest.raises(InsufficientPrecisionError, match="bits"):
        certified_tree(run, bits=16, limit=20)
    with pytest.raises(ShapeError, match="cuts"):
        certified_tree(parameters("4", "1/10", 4, "3/4"), max_cuts=3)


def test_rows_and_columns_that_disagree_are_refused_in_balls_as_in_floats():
    """A row of the disk begins beyond the end of the one below: its columns see another order."""
    run = parameters("5/4", "1/4", 4, "99/100")
    for made_by in (certified_tree, grown):
        with pytest.raises(SurgeryError):
            made_by(run)


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
