"""JSON written in parts: the same data as in one piece, never half written, never held whole."""

import json
import tracemalloc
from itertools import repeat

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from checks.errors import BadInput
from checks.files import canonical_json, json_parts, write_parts
from checks.output import write_long_json

LEAVES = (
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, width=32) | st.text()
)
DATA = st.recursive(
    LEAVES.filter(lambda leaf: leaf not in (float("inf"), -float("inf"))),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)


@settings(derandomize=True, deadline=None)
@given(st.dictionaries(st.text(), DATA, min_size=1, max_size=4))
def test_without_iterators_the_parts_are_the_canonical_text(data):
    assert "".join(json_parts(data)) == canonical_json(data)


@settings(derandomize=True, deadline=None)
@given(st.lists(DATA, max_size=4), DATA)
def test_entries_of_an_iterator_are_a_list_of_one_line_each(entries, last):
    text = "".join(json_parts({"first": 1, "entries": iter(entries), "last": last}))
    assert json.loads(text) == {"first": 1, "entries": entries, "last": last}
    block = text.split('"entries": [')[1].split("\n")[1 : len(entries) + 1]
    assert [json.loads(line.rstrip(",")) for line in block] == entries


def test_a_long_list_is_never_held_whole(tmp_path):
    entries = 200_000
    tracemalloc.start()
    write_long_json(str(tmp_path / "long.json"), {"entries": repeat({"angle": 0.25}, entries)})
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert (tmp_path / "long.json").stat().st_size > 20 * entries
    assert peak < 1e6


@pytest.mark.parametrize("error", [KeyboardInterrupt, ValueError])
def test_an_error_among_the_parts_leaves_the_old_file(tmp_path, error):
    def parts():
        yield "new"
        raise error

    path = tmp_path / "kept.json"
    path.write_text("old", encoding="utf-8")
    with pytest.raises(error):
        write_parts(path, parts())
    assert path.read_text(encoding="utf-8") == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_missing_folder_is_told(tmp_path):
    with pytest.raises(BadInput, match="cannot write"):
        write_long_json(str(tmp_path / "no" / "file.json"), {"entries": iter(())})
