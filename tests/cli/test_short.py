"""The short answer: one screen, which loses nothing that matters; --full and --table give the rest.

Expected: counted and looked for in the whole answer, of which the short one is a part.
"""

import re
from pathlib import Path

import pytest

from cli.running import DRIVE, Ran, drive_file, wraparc
from wraparc import load_drive, solve
from wraparc.answer.motion_sheet import work
from wraparc.answer.sheet import Also, Row, Sheet, Table, Verdict
from wraparc.answer.short import short_sheet
from wraparc.checks import Level, judge, least_tension
from wraparc.checks.action import Action
from wraparc.cli.solve import TABLES
from wraparc.units import in_units, per_stress

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path("examples")
START = """
[[load_case]]
name = "start"
kind = "starting"
pulley.head.entry_tension = "186 kN"
"""
#: Drives of one pulley: name, and what is missed or near in them.
ONE = (
    "downhill-braking", "head-drive-fabric", "steel-cord-drive", "test-pulley-calibrated",
    "uphill-conveyor", "studies/head-drive", "wet-season/wet-season-drive",
)  # fmt: skip


def lines(ran: Ran) -> list[str]:
    assert ran.code in (0, 1), ran.err
    return ran.out.splitlines()


@pytest.fixture(autouse=True)
def eighty_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")


@pytest.mark.parametrize("units", ["si", "us"])
def test_a_drive_of_three_load_cases_is_one_screen(tmp_path: Path, units: str) -> None:
    ran = wraparc("solve", drive_file(tmp_path, DRIVE + START), "--units", units)
    assert 15 < len(lines(ran)) <= 40
    assert max(map(len, lines(ran))) <= 80


@pytest.mark.parametrize("name", ONE)
def test_an_example_is_one_screen_with_all_that_is_missed(name: str) -> None:
    file = EXAMPLES / f"{name}.toml"
    ran = wraparc("solve", file)
    assert len(lines(ran)) <= 40
    judged = judge(solve(load_drive(file), raise_on_failure=False))
    for check in judged.missed[:3]:  # the verdict and two lines more; the others are counted
        assert in_units(check.text) in ran.words, check.name
    if len(judged.missed) > 3:
        assert f"Also {len(judged.missed) - 3} more (--table checks)." in ran.words
    for check in judged.missed:
        row = re.escape(" ".join(check.title.split()[:2]))  # the rest may be on another line
        assert re.search(rf"(?m)^ {row}.* {check.level} ", ran.out), check.name
    assert f"Data {judged.data.text}" in ran.words
    left = [c for c in judged.not_checked if c.name != "wet_creep"]
    assert left
    assert all(f"{c.noun} ({c.missing or c.why})" in ran.words for c in left)


def test_a_narrow_terminal_wraps_and_breaks_no_table(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    ran = wraparc("solve", EXAMPLES / "head-drive-fabric.toml")
    assert max(map(len, lines(ran))) <= 60
    assert re.search(r"Creep +11\.4 mm +max 6\.35 mm +180 % +ATTENTION", ran.out)


def test_full_is_all_of_it_and_the_short_answer_says_so() -> None:
    file = EXAMPLES / "head-drive-fabric.toml"
    short, full = wraparc("solve", file), wraparc("solve", file, "--full")
    assert lines(short)[-1] == "More  --full, --table NAME"
    assert "More  --full" not in full.out
    assert len(lines(full)) > 5 * len(lines(short))
    assert "Sources" in full.out.splitlines()
    tables = [line for line in lines(full) if line in ("Checks", "Capacity", "Energy and wear")]
    assert len(tables) == 3


def test_one_table_is_what_the_whole_answer_shows_of_it() -> None:
    file = EXAMPLES / "head-drive-fabric.toml"
    full, one = wraparc("solve", file, "--full").out, wraparc("solve", file, "--table", "capacity")
    assert one.out.startswith("Capacity\n")
    assert one.out.rstrip() in full


def test_an_unknown_table_is_refused_before_anything_is_solved() -> None:
    ran = wraparc("solve", "nowhere.toml", "--table", "capasity")
    assert (ran.code, ran.out) == (2, "")
    assert 'got "capasity". Did you mean "capacity"?' in ran.err
    assert all(name in wraparc("solve", "--help").words for name in TABLES)


def test_a_table_that_this_answer_lacks_is_told_with_those_it_has() -> None:
    ran = wraparc("solve", EXAMPLES / "head-drive-fabric.toml", "--table", "conveyor")
    assert ran.code == 2
    assert (
        '--table: no such table in this answer, got "conveyor". Write one of "checks", "least",'
        in ran.err
    )


@pytest.mark.parametrize(
    "arguments",
    [
        ("trim", "tandem-fabric.toml", "--points", "3"),
        ("field", "head-drive-fabric.toml"),
        ("what-if", "head-drive-fabric.toml", "--worn", "6 mm", "--lagging", "full-ceramic"),
        ("choose", "wet-season/choose.toml"),
        ("stability", "tandem-fabric.toml"),
        ("calibrate", "test-pulley/published-pair.toml"),
        ("check", "triple-steel-cord.toml"),
        ("lagging", "full-ceramic"),
    ],
    ids=lambda arguments: arguments[0],
)
def test_every_command_answers_in_one_screen(
    arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(EXAMPLES)
    ran, full = wraparc(*arguments), wraparc(*arguments, "--full")
    assert len(lines(ran)) <= 48
    assert ran.code == full.code
    names = re.search(r"--table NAME +Print one table alone: (.*?)\.", _help(arguments[0]))
    assert names
    alone = wraparc(*arguments, "--table", names[1].split(", ")[0])
    assert alone.code == full.code
    assert alone.out.rstrip() in full.out


def _help(command: str) -> str:
    return wraparc(command, "--help").words


def test_the_least_tension_of_a_load_case_holds_as_it_is_shown() -> None:
    """Rounded upwards in the table as in the sentence; expected: what the check itself found."""
    file = EXAMPLES / "wet-season" / "wet-season-drive.toml"
    found = least_tension(solve(load_drive(file)))
    assert found is not None
    ran = wraparc("solve", file, "--full")
    (shown,) = re.findall(r"start: head .* (\S+) +ATTENTION creep", ran.out)
    assert found.tension <= 1e3 * float(shown) < 1.002 * found.tension
    assert f"Minimum T2 {shown} kN (Creep, head, start); now 50 kN." in ran.words


def test_every_missed_check_is_told_or_counted_however_many() -> None:
    also = tuple(Also(Level.ATTENTION, f"Missed {n}.") for n in range(20))
    told = Verdict(Level.FAILS, "Bad.", also=also)
    verdict = short_sheet(Sheet("T", verdict=told)).verdict
    assert verdict is not None
    assert verdict.lines == (
        ("Also", "ATTENTION: Missed 0."), ("Also", "ATTENTION: Missed 1."),
        ("Also", "18 more (--table checks)."),
    )  # fmt: skip


@pytest.mark.parametrize("changes", range(10))
@pytest.mark.parametrize("others", range(4))
def test_a_first_screen_has_eight_lines_and_counts_what_they_leave_out(
    changes: int, others: int
) -> None:
    told = Verdict(
        Level.ATTENTION,
        "Much.",
        action=Action("Take less."),
        also=tuple(Also(Level.ATTENTION, f"Missed {n}.") for n in range(others)),
        data="All measured.",
        changes=tuple(f"change {n}: no effect." for n in range(changes)),
    )
    lines = told.lines
    assert 1 + len(lines) <= 8
    for label, of in (("Change", changes), ("Also", others)):
        texts = [text for name, text in lines if name == label]
        assert bool(texts) is bool(of)
        left = int(texts.pop().split()[0]) if texts and " more (" in texts[-1] else 0
        assert len(texts) + left == of
        assert label == "Change" or len(texts) <= 2


def test_a_study_shows_the_load_case_that_comes_off_worst(tmp_path: Path) -> None:
    """Only in a start does the momentary rating of the lighter belt fail."""
    out = tmp_path / "out.parquet"
    ran = wraparc("study", EXAMPLES / "studies" / "load-cases.toml", "-o", out)
    assert len(lines(ran)) <= 40
    assert "start: by belt" in ran.out
    assert "design: by belt" not in ran.out
    assert ran.words.count("FAILS: the momentary") == 4


# ---- what is chosen ----


def _sheet(**changed: object) -> Sheet:
    bad = tuple(
        Row(f"row {n}", ("1",), level=Level.ATTENTION if n == 8 else None) for n in range(9)
    )
    tables = (
        Table("Known", bad, name="trim"),
        Table("Unknown", bad, name="constant"),
        Table("Nameless", (Row("all", ("1",)),)),
    )
    told = Verdict(Level.ATTENTION, "Too much.", ("one", "two"), action=Action("Take less."))
    values = {"title": "T", "verdict": told, "tables": tables, "sources": ("a", "b"), **changed}
    return Sheet(**values)  # type: ignore[arg-type]


def test_rows_that_ask_for_attention_stay_and_it_is_said_how_to_have_the_others() -> None:
    short = short_sheet(_sheet(), "--table", "--full")
    known, nameless = short.tables
    assert [row.title for row in known.rows] == [f"row {n}" for n in (0, 1, 2, 3, 4, 5, 6, 8)]
    assert nameless.rows[0].title == "all"
    assert "Unknown: ATTENTION in 1 row (--table constant)." in short.foot
    assert short.foot[-1] == "More  --full"


def test_sentence_and_action_are_shown_as_they_are() -> None:
    whole, verdict = _sheet().verdict, short_sheet(_sheet()).verdict
    assert whole is not None
    assert verdict is not None
    assert (verdict.text, verdict.action) == (whole.text, whole.action)
    assert verdict.lines == (("Action", "Take less."),)


def test_sentences_are_left_to_the_whole_answer_and_it_is_said_that_there_are_others() -> None:
    told = Verdict(Level.OK, "Fine.", tuple(f"s{n}" for n in range(12)))
    short = short_sheet(_sheet(verdict=told, remarks=("r0", "r1"), kept=("r1",)), rest="--full")
    assert short.verdict is not None
    assert short.verdict.sentences == ()
    assert "r1" in short.foot
    assert "r0" not in short.foot
    assert short.foot[-1] == "More  --full"
    nothing_left = short_sheet(Sheet("T", verdict=Verdict(Level.OK, "Fine.")), rest="--full")
    assert nothing_left.foot == ()


def test_numbers_of_sources_go_with_the_sources_and_other_brackets_stay() -> None:
    rows = (Row("row", ("1",), note="published [2], of [pulley] [7]"),)
    short = short_sheet(_sheet(tables=(Table("Known", rows, name="trim"),)))
    assert short.tables[0].rows[0].note == "published, of [pulley] [7]"


@pytest.mark.parametrize(
    "command",
    [
        ("run", EXAMPLES / "tandem-fabric.toml"),
        ("what-if", EXAMPLES / "head-drive-fabric.toml", "--worn", "0.2 in", "--wet", "DIN 22101"),
    ],
    ids=lambda command: command[0],
)
def test_an_answer_in_us_units_holds_no_metric_number(command: tuple[str | Path, ...]) -> None:
    found = wraparc(*map(str, command), "--units", "us", "--full").words
    found = re.sub(r"\[\d+\] [^.]*\.|from 50 kN", "", found)
    assert not re.search(r"\d (mm|um|kN|kPa|MPa|kW|kJ|mm/MPa)\b", found)


def test_friction_work_and_compliance_in_us_units() -> None:
    """1 ft lbf = 1.3558179483 J; 1 in/ksi = 0.0254 m over 6.894757293 MPa."""
    assert in_units(work(1355.8179483), "us") == "1000 ft lbf"
    assert in_units(work(1355.8179483)) == "1.36 kJ"
    assert in_units(per_stress(0.0254 / 6.894757293e6), "us") == "1 in/ksi"
