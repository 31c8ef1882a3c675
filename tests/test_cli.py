"""The command line: what it prints, what it refuses, what it leaves behind."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from xml.etree import ElementTree

import jsonschema
import pytest
from planted import claim

from checks.cli import run
from checks.registry import Registry

ROOT = Path(__file__).resolve().parent.parent
SCHEMA = json.loads((ROOT / "checks" / "ledger.schema.json").read_text())


@pytest.fixture
def planted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Run the command line in an empty folder on planted claims, with pins of their own."""
    monkeypatch.chdir(tmp_path)

    def plant(*claims):
        whole = Registry(claims=claims)
        for module in ("check", "claims", "explain", "pin"):
            monkeypatch.setattr(f"checks.commands.{module}.registry", lambda: whole)
        pins = tmp_path / "pins.json"
        monkeypatch.setattr("checks.commands.pin.PINS", pins)
        from checks.pins import read_pins

        for module in ("check", "claims", "pin"):
            monkeypatch.setattr(f"checks.commands.{module}.read_pins", lambda: read_pins(pins))
        return tmp_path

    return plant


def ledger(folder: Path) -> dict:
    return json.loads((folder / ".kminusone" / "last.json").read_text())


def test_a_run_is_kept_pinned_and_then_agrees(planted, capsys):
    folder = planted(claim("one", "sound"), claim("two", "drawn", rests_on=("one",)))
    assert run(["check"]) == 1
    assert "not pinned" in capsys.readouterr().out
    assert run(["pin"]) == 0
    assert "not pinned -> pass (exact)" in capsys.readouterr().out
    assert run(["check", "--json", "out.json", "--junit", "out.xml"]) == 0
    assert "2 claims: 2 holds; 2 of 2 checks ran, 2 mutants, 0 broken: as pinned" in (
        capsys.readouterr().out
    )
    written = json.loads((folder / "out.json").read_text())
    jsonschema.validate(written, SCHEMA)
    assert written == ledger(folder)
    assert [entry["expected"] for entry in written["claims"]] == ["holds", "holds"]
    suite = ElementTree.parse(folder / "out.xml").getroot()[0]
    assert suite.attrib["tests"] == "2"
    assert suite.attrib["failures"] == "0"


def test_a_vacuous_check_is_reported_broken_and_cannot_be_pinned(planted, capsys):
    folder = planted(claim("one", "vacuous"))
    assert run(["check"]) == 1
    assert "one / vacuous: broken, it does not reject its mutant factor" in capsys.readouterr().out
    assert ledger(folder)["counts"]["broken"] == 1
    assert run(["pin"]) == 2
    assert "is broken, mend it: one / vacuous" in capsys.readouterr().err


def test_a_killed_child_loses_its_check_alone(planted, capsys):
    folder = planted(claim("one", "killed"), claim("two", "sound"))
    assert run(["check"]) == 1
    kept = ledger(folder)
    assert [entry["verdict"] for entry in kept["claims"]] == ["undecided", "holds"]
    assert "killed by signal 9" in kept["claims"][0]["checks"][0]["error"]
    assert "one/killed" in kept["times"]["tracebacks"]
    jsonschema.validate(kept, SCHEMA)


def test_an_exception_keeps_its_traceback(planted):
    folder = planted(claim("one", "raising"))
    assert run(["check"]) == 1
    assert "ArithmeticError: planted" in ledger(folder)["times"]["tracebacks"]["one/raising"]


def test_what_rests_on_an_undecided_claim_is_weakened(planted):
    folder = planted(claim("one"), claim("two", "sound", rests_on=("one",)))
    run(["check"])
    assert ledger(folder)["claims"][1]["weakened_by"] == ["one"]
    assert ledger(folder)["claims"][1]["verdict"] == "holds"


def test_nothing_to_run_has_its_own_exit_code(planted, capsys):
    folder = planted(claim("one"))
    assert run(["check"]) == 3
    assert "nothing ran" in capsys.readouterr().err
    assert not (folder / ".kminusone").exists()


def test_json_to_stdout_is_all_of_stdout(planted, capsys):
    planted(claim("one", "sound"))
    run(["check", "--json", "-"])
    assert json.loads(capsys.readouterr().out)["schema"] == "kminusone/ledger/1"


def test_claims_and_explain(planted, capsys):
    planted(claim("one", "sound"), claim("two", "drawn", rests_on=("one",)))
    run(["check"])
    run(["pin"])
    capsys.readouterr()
    assert run(["claims", "--json", "-", "--verdict", "holds"]) == 0
    assert [e["id"] for e in json.loads(capsys.readouterr().out)["claims"]] == ["one", "two"]
    assert run(["explain", "one"]) == 0
    told = capsys.readouterr().out
    for part in (
        "verdict: holds",
        "what rests on it",
        "two",
        "mutant factor (factor = 3): rejected",
    ):
        assert part in told


def test_a_pinned_check_that_vanishes_is_noticed(planted, capsys):
    folder = planted(claim("one", "sound"), claim("two", "drawn"))
    run(["check"])
    run(["pin"])
    planted(claim("one", "sound"))
    capsys.readouterr()
    assert run(["check"]) == 1
    assert "two / drawn: pinned pass (exact), no longer in the catalogue" in capsys.readouterr().out
    assert (folder / "pins.json").is_file()


def test_nothing_worse_than_undecided_has_its_own_exit_code(planted):
    planted(claim("one", "undecided"))
    assert run(["check"]) == 4
    assert run(["pin"]) == 0
    assert run(["check"]) == 0


def test_a_broken_check_decides_nothing(planted):
    folder = planted(claim("one", "vacuous"))
    run(["check"])
    assert ledger(folder)["claims"][0]["verdict"] == "undecided"


def test_what_a_check_prints_stays_out_of_the_result(planted, capfd):
    planted(claim("one", "printing"))
    run(["check", "--json", "-"])
    assert json.loads(capfd.readouterr().out)["counts"]["checks"] == 1


def test_a_pipe_is_written_to_and_not_replaced(planted):
    folder = planted(claim("one", "sound"))
    pipe = folder / "pipe"
    os.mkfifo(pipe)
    reader = subprocess.Popen(["cat", str(pipe)], stdout=subprocess.PIPE, text=True)
    run(["claims", "--json", "pipe"])
    assert json.loads(reader.communicate(timeout=30)[0])["claims"][0]["id"] == "one"
    assert pipe.is_fifo()


def test_a_link_is_followed_and_not_replaced(planted):
    folder = planted(claim("one", "sound"))
    (folder / "target.json").write_text("old")
    (folder / "link.json").symlink_to("target.json")
    run(["claims", "--json", "link.json"])
    assert (folder / "link.json").is_symlink()
    assert json.loads((folder / "target.json").read_text())["claims"]


@pytest.mark.parametrize("text", ["5", "null", "{", '{"claims": 5}', '"claims"'])
def test_a_corrupt_last_run_is_ignored_with_a_warning(planted, capsys, text: str):
    folder = planted(claim("one", "sound"))
    (folder / ".kminusone").mkdir()
    (folder / ".kminusone" / "last.json").write_text(text)
    assert run(["explain", "one"]) == 0
    assert "is not a ledger: it is ignored" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["", "[]", '{"one": 5}', '{"one": {"sound": []}}'])
def test_corrupt_pins_are_refused_in_one_line(planted, capsys, text: str):
    folder = planted(claim("one", "sound"))
    (folder / "pins.json").write_text(text)
    assert run(["claims"]) == 2
    err = capsys.readouterr().err
    assert "holds no pins" in err
    assert err.count("\n") == 1


BAD = [
    (["check", "oen"], "did you mean one"),
    (["check", "z*"], "no claim matches 'z*'"),
    (["check", "--digits", "0"], "--digits"),
    (["check", "--digits", "many"], "--digits"),
    (["check", "--jobs", "-1"], "--jobs"),
    (["check", "--seed", "-1"], "--seed"),
    (["check", "--tier", "slow"], "--tier"),
    (["check", "--section", "9"], "unknown section '9'"),
    (["check", "--json", "missing/out.json"], "does not exist, create it"),
    (["check", "--json", "."], "it is a folder"),
    (["check", "--json", "-", "--junit", "-"], "only one of --json and --junit"),
    (["claims", "--verdict", "true"], "unknown verdict 'true'"),
    (["claims", "--kind", "dream"], "unknown kind 'dream'"),
    (["explain", "nothing-like-it"], "unknown claim"),
    (["explain"], "CLAIM"),
    (["pin"], "no last run"),
    (["dance"], "dance"),
]


@pytest.mark.parametrize(
    ("arguments", "said"), BAD, ids=lambda v: " ".join(v) if isinstance(v, list) else ""
)
def test_bad_input_gets_one_clear_line(planted, capsys, arguments, said):
    folder = planted(claim("one", "sound"))
    assert run(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert said in err
    assert err.count("\n") == 1
    assert "Traceback" not in err
    assert list(folder.iterdir()) == []


def test_an_unwritable_place_is_refused_before_the_run(planted, capsys):
    folder = planted(claim("one", "sound"))
    place = "/proc" if Path("/proc").is_dir() else "/System"
    assert run(["check", "--json", f"{place}/out.json"]) == 2
    assert f"cannot write {place}/out.json" in capsys.readouterr().err
    assert list(folder.iterdir()) == []


def command(*arguments: str, cwd: Path, **options) -> subprocess.Popen:
    return subprocess.Popen(
        [sys.executable, "-m", "checks", *arguments], cwd=cwd, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True, **options,
    )  # fmt: skip


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupted_run_says_so_and_writes_nothing(tmp_path: Path, number: signal.Signals):
    process = command("check", "--jobs", "1", "--json", "out.json", cwd=tmp_path)
    time.sleep(2.5)
    process.send_signal(number)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert err.startswith("kminusone: interrupted")
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_closed_pipe_ends_quietly(tmp_path: Path):
    process = command("claims", cwd=tmp_path)
    process.stdout.close()
    assert process.stderr.read().count("Traceback") == 0
    assert process.wait(timeout=60) == 0
    process.stderr.close()


def test_the_ledger_is_the_same_byte_for_byte_whatever_the_jobs_and_the_hash_seed(tmp_path: Path):
    texts = []
    # sympy computes with flint's integers where it finds them: the second run does without.
    for jobs, hashseed, ground in (("1", "1", "flint"), ("3", "2", "python")):
        out = tmp_path / f"{jobs}.json"
        environment = {
            **os.environ,
            "PYTHONHASHSEED": hashseed,
            "SYMPY_GROUND_TYPES": ground,
        }
        process = command(
            "check",
            "--section",
            "3.1",
            "--jobs",
            jobs,
            "--json",
            str(out),
            cwd=tmp_path,
            env=environment,
        )
        process.communicate(timeout=400)
        data = json.loads(out.read_text())
        assert data.pop("times")["jobs"] == int(jobs)
        texts.append(json.dumps(data, indent=2))
    assert texts[0] == texts[1]


def test_listing_the_claims_is_instant_enough_to_need_no_heavy_import(tmp_path: Path):
    code = (
        "import sys; from checks.cli import run; run(['claims', '--json', 'out.json']);"
        "sys.exit(' '.join({'sympy', 'numpy', 'rich', 'multiprocessing'} & set(sys.modules)) or 0)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_version_names_the_commit():
    done = subprocess.run(
        [sys.executable, "-m", "checks", "--version"], capture_output=True, text=True, check=True
    )
    assert done.stdout.startswith("kminusone 0.1.0")
