"""The verdict is the worst check, the same in every door.

100 random drives: the verdict of the judgement is the worst of an independent walk over its list.
The doors are slow: JSON, the answers of the calculator that the page shows, the note, and the Excel
file are opened here on ten of 300 drives, by benchmarks/verdicts.py on all of them.
"""

import io
from functools import cache
from pathlib import Path

import pytest

from checks.test_least_tension import random_drives
from cli.running import wraparc
from render.test_note_files import sheets
from worded import worded
from wraparc import DriveResult, solve
from wraparc.answer.document import result_document
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.sheet import shown
from wraparc.arc import Distributed
from wraparc.checks import Level, judge
from wraparc.checks.check import INFO_CHECKS
from wraparc.files.write import drive_document, drive_text
from wraparc.render import markdown, workbook
from wraparc.units import in_units
from wraparc.web.answers.drives import solve_all
from wraparc.web.asked import SolveRequest

pytestmark = pytest.mark.usefixtures("solved_once")

ORDER = ["NOT CHECKED", "OK", "ATTENTION", "FAILS", "INTERNAL ERROR"]
OPENED = range(0, 300, 30)


@cache
def solved(number: int) -> DriveResult:
    return solve(random_drives(300)[number], raise_on_failure=False)


def test_the_verdict_is_the_worst_check_of_100_drives() -> None:
    seen = set()
    for of in random_drives(300)[:100]:
        fast = Distributed(capacities=False, points=20)
        verdict = judge(solve(of, method=fast, raise_on_failure=False))
        worst = max((c.level.value for c in verdict.checks), key=ORDER.index)
        assert verdict.level.value == max(worst, "OK", key=ORDER.index)
        assert verdict.governing in verdict.checks
        seen.add(verdict.level)
    assert {Level.OK, Level.ATTENTION, Level.FAILS} <= seen


@pytest.mark.parametrize("number", OPENED)
def test_every_door_tells_the_same(number: int, tmp_path: Path) -> None:
    result = solved(number)
    verdict = judge(result)
    listed = {c.title: c.level.value for c in verdict.listed}
    judged = {c.title: c.level.value for c in verdict.listed if c.compares}
    rated = {c.title: c.level.value for c in verdict.listed if c.name not in INFO_CHECKS}

    data = result_document([result])["verdict"]
    assert (data["level"], data["label"]) == (verdict.level.value, verdict.label)
    assert {c["title"]: c["level"] for c in data["checks"]} == listed

    table = shown(drive_sheet([result]), "si").tables[0]
    assert {row.title: str(row.level) for row in table.rows} == judged

    request = SolveRequest(document=drive_document(result.drive))
    answer = solve_all(request)
    assert (answer.verdict.level, answer.verdict.label) == (verdict.level, verdict.label)
    assert worded(answer.verdict.text) == in_units(verdict.text)
    assert {row.title: str(row.level) for row in answer.checks.rows} == judged

    note = markdown([result])
    assert f"**{verdict.label}** " in note
    assert all(f"| {title} |" in note for title in judged)

    rows = sheets(workbook([result]))["Summary"]
    in_excel = {str(row[0]): row[6] for row in rows if len(row) > 6 and row[6] in ORDER}
    assert in_excel == rated

    path = tmp_path / "drive.toml"
    path.write_text(drive_text(result.drive), "utf-8")
    ran = wraparc("solve", path)
    assert ran.out.splitlines()[2].startswith(verdict.label)
    assert ran.code == {Level.FAILS: 1, Level.FAULT: 3}.get(verdict.level, 0)
    assert io.StringIO(ran.out).readline().strip() == "Test drive"
