"""``wraparc report``."""

import os
import re
from pathlib import Path

import pytest

from cli.running import wraparc
from render.reading import media_box, metadata
from wraparc.errors import input_error
from wraparc.render import typesetting

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
DRIVE = str(EXAMPLES / "head-drive-fabric.toml")


@pytest.mark.parametrize(
    ("suffix", "start"),
    [(".pdf", b"%PDF-"), (".xlsx", b"PK"), (".md", b"# Head drive"), (".PDF", b"%PDF-")],
)
def test_the_kind_is_told_by_the_ending(tmp_path: Path, suffix: str, start: bytes) -> None:
    target = tmp_path / f"note{suffix}"
    ran = wraparc("report", DRIVE, "-o", str(target), "--case", "design")
    assert (ran.code, ran.err) == (0, f"Wrote {target}\n")
    # the lines of the first screen
    assert "ATTENTION    Creep 7.49 mm exceeds the 6.35 mm limit (head, design).\n" in ran.out
    assert re.search(r"^Probability  OK in \d+ % of 4,096 draws of the usual", ran.out, re.M)
    assert target.read_bytes().startswith(start)
    assert os.listdir(tmp_path) == [target.name]


def test_the_title_block_is_filled_from_options(tmp_path: Path) -> None:
    options = {"title": "Drive 7", "project": "Mine", "number": "CN-7", "revision": "C",
               "author": "B. Jones", "date": "2026-02-03"}  # fmt: skip
    flags = [part for key, value in options.items() for part in (f"--{key}", value)]
    ran = wraparc("report", DRIVE, "-o", "-", "--case", "design", *flags)
    assert ran.code == 0
    assert ran.out.startswith("# Drive 7\n")
    for line in ("Project: Mine", "Document: CN-7", "Revision: C", "Prepared by: B. Jones",
                 "Date: 2026-02-03", "Drive file: head-drive-fabric.toml"):  # fmt: skip
        assert f"- {line}\n" in ran.out


def test_us_units_come_on_us_paper_unless_asked_otherwise(tmp_path: Path) -> None:
    target = tmp_path / "note.pdf"
    wraparc("report", DRIVE, "-o", str(target), "--units", "us", "--case", "design")
    assert media_box(target.read_bytes())[2:] == pytest.approx([612, 792])
    wraparc(
        "report", DRIVE, "-o", str(target), "--units", "us", "--paper", "a4", "--case", "design"
    )
    assert media_box(target.read_bytes())[2:] == pytest.approx([595.28, 841.89], abs=0.01)
    assert "0.295 in" in metadata(target.read_bytes())


def test_values_can_be_put_over_those_of_the_file() -> None:
    ran = wraparc(
        "report", DRIVE, "-o", "-", "--case", "design", "--creep-limit", "10 mm",
        "--set", "pulley.head.lagging=full-ceramic",
    )  # fmt: skip
    assert ran.code == 0
    assert re.search(r"\| Creep \| \S+ mm \| max 10 mm \|", ran.out)
    assert "full-ceramic" in ran.out


def test_a_train_is_reported_as_one() -> None:
    ran = wraparc("report", str(EXAMPLES / "tandem-fabric.toml"), "-o", "-", "--case", "empty")
    assert ran.code == 0
    assert "### Drives: load case empty" in ran.out
    assert "Surface speeds of drives on one belt" in ran.out


def test_a_breakaway_is_reported_and_told_by_the_exit_code(tmp_path: Path) -> None:
    target = tmp_path / "note.pdf"
    ran = wraparc(
        "report", DRIVE, "-o", str(target), "--case", "design",
        "--set", "pulley.head.exit_tension=2 kN",
    )  # fmt: skip
    assert ran.code == 1
    assert target.read_bytes().startswith(b"%PDF-")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            ("-o", "note.doc"),
            "must end in .pdf or .xlsx or .md",
        ),
        (("-o", "no/such/note.pdf"), "its folder does not exist"),
        (("-o", DRIVE[:-5] + ".pdf", "--case", "nigth"), "the drive has no such load case"),
        (("-o", "note.pdf", "--title", "x" * 200), "--title"),
        (("-o", "note.pdf", "--creep-limit", "10"), "--creep-limit"),
        ((), "--output: missing"),
    ],
)
def test_bad_input_is_told_and_nothing_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...], sentence: str
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = wraparc("report", DRIVE, *arguments)
    assert ran.code == 2
    assert sentence in ran.err
    assert "Traceback" not in ran.err
    assert os.listdir(tmp_path) == []


def test_the_drive_file_is_not_written_over(tmp_path: Path) -> None:
    own = tmp_path / "drive.md"
    own.write_text(Path(DRIVE).read_text("utf-8"), "utf-8")
    ran = wraparc("report", str(own), "-o", str(own))
    assert ran.code == 2
    assert "must not be a file that is read" in ran.err
    assert own.read_text("utf-8").startswith("#")


def test_a_note_that_cannot_be_set_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: object) -> bytes:
        raise input_error(message="no page can be set")

    monkeypatch.setattr(typesetting, "_typeset", fails)
    target = tmp_path / "note.pdf"
    target.write_bytes(b"old")
    ran = wraparc("report", DRIVE, "-o", str(target), "--case", "design")
    assert ran.code == 2
    assert "no page can be set" in ran.err
    assert target.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["note.pdf"]
