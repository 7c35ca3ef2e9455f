"""Answers hold no system of units: every number with a unit is a cell until it is shown.

What is left of the texts of tables and verdicts when cells are taken out holds no number of metric
units; names and sources, which come from files, are not looked at.
"""

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from wraparc import Distributed, load_drive, load_train, solve, solve_train
from wraparc.answer.drive_sheet import drive_sheet, input_sheet
from wraparc.answer.sheet import Sheet
from wraparc.answer.train_sheet import matching_sheet, train_sheet
from wraparc.train import match_drives

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
CELL = re.compile("\x02[^\x03]*\x03|\x04[^\x06]*\x06")
METRIC = re.compile(r"\d ?(?:u?m|mm|k?N|kN/m|k?Pa|MPa|kW|W|m/s|mm/s|kg|kN m|mm3/J|W/m2|J/m2)\b")


def a_train() -> Sheet:
    train = load_train(EXAMPLES / "tandem-fabric.toml")
    return train_sheet(solve_train(train, method=Distributed(points=20)))


def matched() -> Sheet:
    train = load_train(EXAMPLES / "tandem-fabric.toml")
    result = solve_train(train, method=Distributed(capacities=False, points=20))
    return matching_sheet(result, match_drives(result, points=3))


def a_drive(name: str) -> Callable[[], Sheet]:
    drive = load_drive(EXAMPLES / f"{name}.toml")
    return lambda: drive_sheet([solve(drive, method=Distributed(points=20))])


SHEETS: dict[str, Callable[[], Sheet]] = {
    "fabric": a_drive("head-drive-fabric"),
    "steel cord": a_drive("steel-cord-drive"),
    "braking": a_drive("downhill-braking"),
    "inputs": lambda: input_sheet(load_drive(EXAMPLES / "head-drive-fabric.toml")),
    "train": a_train,
    "matched": matched,
}


def told(sheet: Sheet) -> Iterator[str]:
    """Yield the texts of tables and verdict."""
    if sheet.verdict is not None:
        yield from (sheet.verdict.text, *sheet.verdict.sentences)
        yield from (text for _, text in sheet.verdict.lines)  # action, also, wet, reserve, data
        yield from (way.text for way in (sheet.verdict.action.ways if sheet.verdict.action else ()))
    for table in sheet.tables:
        yield from table.heads
        for row in table.rows:
            yield from row.values


@pytest.mark.parametrize("name", SHEETS)
def test_no_number_of_an_answer_has_its_unit_yet(name: str) -> None:
    texts = [*told(SHEETS[name]())]
    assert sum(bool(CELL.search(text)) for text in texts) > 8
    left = [CELL.sub("", text) for text in texts]
    assert [text for text in left if METRIC.search(text)] == []
