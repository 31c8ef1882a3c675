"""Sweeps that resume: nothing is done twice, nothing torn is believed."""

from concurrent.futures import ThreadPoolExecutor

import pytest

from checks.searches.resumable import discard, swept


@pytest.fixture
def sweep(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = []

    def task(key):
        if key == "bad":
            raise RuntimeError(key)
        done.append(key)
        return {"square": int(key) ** 2}

    def run(keys, stamp="one"):
        done.clear()
        with ThreadPoolExecutor(1) as executor:
            found = dict(
                swept(task, keys, name="s", stamp=stamp, executor=executor, progress=lambda t: None)
            )
        return found, list(done)

    return run


def test_results_come_in_the_order_of_the_keys(sweep):
    found, _ = sweep(["3", "1", "2"])
    assert list(found.items()) == [("3", {"square": 9}), ("1", {"square": 1}), ("2", {"square": 4})]


def test_what_is_done_is_not_done_again(sweep):
    with pytest.raises(RuntimeError):
        sweep(["1", "2", "bad", "4"])
    found, done = sweep(["1", "2", "3", "4"])
    assert "1" not in done
    assert found["1"] == {"square": 1}


def test_a_torn_line_is_done_again(sweep, tmp_path):
    sweep(["1", "2"])
    file = tmp_path / ".kminusone" / "s.partial.jsonl"
    file.write_text(file.read_text()[:-9])
    found, done = sweep(["1", "2"])
    assert done == ["2"]
    assert found["2"] == {"square": 4}
    assert sweep(["1", "2"])[1] == []


def test_another_stamp_begins_anew(sweep):
    sweep(["1", "2"])
    assert sweep(["1", "2"], stamp="two")[1] == ["1", "2"]


def test_a_finished_sweep_leaves_nothing(sweep, tmp_path):
    sweep(["1"])
    discard("s")
    assert sweep(["1"])[1] == ["1"]
