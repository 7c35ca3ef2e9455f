"""What the gate says of its parts, and which tests `make check` runs."""

import time
from pathlib import Path

import pytest

import gate
from changed import SMOKE, above, chosen

# as pytest prints it, the names of what failed and the closing line, and make after it
LOG = """..F.
=========================== short test summary info ============================
FAILED tests/train/test_a.py::test_b[steel cord | motors] - assert 1 == 2
FAILED tests/test_units.py::test_c
ERROR tests/web/test_d.py - ImportError: no such thing
============ 2 failed, 1 passed, 3 skipped, 1 error in 1.00s (0:00:01) =========
make[1]: *** [Makefile:123: tests] Error 1
"""


@pytest.fixture
def log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(gate, "ROOT", tmp_path)
    file = tmp_path / "tests.log"
    file.write_text(LOG)
    return file


def test_a_failed_test_is_told_with_the_command_that_repeats_it(log: Path) -> None:
    told = list(gate.told([gate.Ran("lint", 1.0, 0, log), gate.Ran("tests", 61.4, 1, log)]))
    assert told[:2] == [
        "  lint           1 s  passed  tests.log",
        "  tests         61 s  FAILED  tests.log  1 passed, 3 failed, 3 skipped",
    ]
    assert told[-4:] == [
        "  make tests WORKERS=0 TESTS='tests/train/test_a.py::test_b[steel cord | motors]'",
        "  make tests WORKERS=0 TESTS=tests/test_units.py::test_c",
        "  make tests WORKERS=0 TESTS=tests/web/test_d.py",
        "\n1 passed, 3 failed, 3 skipped",
    ]


def test_a_part_that_fails_beside_the_tests_is_told_with_the_end_of_its_log(
    log: Path, tmp_path: Path
) -> None:
    passed = tmp_path / "passed.log"
    passed.write_text("==== 7 passed in 1.00s ====\n")
    told = list(gate.told([gate.Ran("types", 2.0, 2, log), gate.Ran("tests", 1.0, 0, passed)]))
    assert LOG.splitlines()[-1] in told
    assert told[-2:] == ["  make types", "\n7 passed, 1 failed"]


def test_tests_that_end_without_a_count_have_failed(tmp_path: Path, log: Path) -> None:
    log.write_text("Fatal Python error: Segmentation fault\n")
    told = list(gate.told([gate.Ran("tests", 1.0, 139, log)]))
    assert told[-2:] == ["  make tests", "\n0 passed, 1 failed"]


@pytest.mark.processes
def test_a_part_that_hangs_is_ended_with_all_it_started_and_the_others_go_on(
    log: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    # types never ends, nor does what it started, which takes no interrupt
    (tmp_path / "Makefile").write_text(
        "docs: ; @echo built\ntypes: ; @trap '' INT; sleep 1000000 & sleep 1000000\n"
    )
    monkeypatch.setattr(gate, "LOGS", tmp_path)
    monkeypatch.setattr(gate, "LIMITS", {"types": 1.0, "docs": 600.0})
    monkeypatch.setattr(gate, "GRACE", 1.0)
    types, docs = gate.side_by_side(("types", "docs"))
    assert (types.code, docs.code) == (gate.HANGS, 0)
    assert "HANGS, ended  types.log" in types.line()
    assert "HANGS" in capfd.readouterr().out
    assert (tmp_path / "docs.log").read_text() == "built\n"
    assert "  make types" in list(gate.told([types, docs]))
    # closed once all that held it open have ended
    while not all(process.stdout and process.stdout.closed for process in gate.RUNNING):
        time.sleep(0.01)


def test_a_changed_room_brings_the_tests_of_the_rooms_that_import_it() -> None:
    # expected: the floors of CONTRIBUTING.md; only doors stand on the report
    found = chosen(["src/wraparc/render/note.py", "docs/model.md", "src/wraparc/gone.py"])
    assert found[: len(SMOKE)] == list(SMOKE)
    assert [f for f in found if f not in SMOKE] == [
        "tests/docs", "tests/render", "tests/web", "tests/cli",
    ]  # fmt: skip
    rooms = above({"units"})
    assert {"drive", "arc", "train", "web", "cli"} <= set(rooms)
    assert rooms.index("arc") < rooms.index("train") < rooms.index("cli")
    assert "units" not in rooms


def test_a_changed_test_runs_alone_and_a_helper_brings_its_folder() -> None:
    found = chosen(["tests/arc/test_twin.py", "tests/train/cases.py", "tests/arc/test_gone.py"])
    assert [f for f in found if f not in SMOKE] == ["tests/arc/test_twin.py", "tests/train"]
