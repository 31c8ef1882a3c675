"""Scales of the pattern of branch points on the surface and in the Poincare disk."""

import pytest

from checks.evidence import Setting
from checks.verify import branch_point_scales as scales

KEY = ("8", "4", "3/4")


@pytest.fixture(autouse=True)
def one_run(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(scales, "RUNS", (KEY,))


def test_the_disk_shrinks_distances_by_its_conformal_factor_at_most():
    """The disk's length element is at most half that of the surface."""
    surface, disk = (scales.sister_distances(KEY, metric) for metric in ("surface", "disk"))
    assert surface.keys() == disk.keys()
    assert all(disk[g] < surface[g] / 2 for g in disk)


def test_distances_fall_in_the_disk_and_not_on_the_surface():
    assert scales.smaller_scales(Setting(), metric="disk").outcome == "pass"
    assert scales.smaller_scales(Setting()).outcome == "fail"
    assert scales.smaller_scales(Setting(), metric="disk", most="1/2").outcome == "fail"


@pytest.mark.parametrize(
    ("given", "outcome"), [({}, "pass"), ({"daughters": 2}, "fail"), ({"until": 5}, "fail")]
)
def test_generations_triple_while_they_are_off_the_rim(given: dict[str, int], outcome: str):
    assert scales.recursion(Setting(), **given).outcome == outcome
