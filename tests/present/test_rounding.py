"""What rounding leaves is shown by no door: results moved in their last bits read the same.

Expected: the texts of the same result, every number of it moved by a few units in the last place,
and every zero by what is left of a difference of two equal numbers of that size.
"""

import dataclasses
import json
import math
from collections.abc import Iterator
from dataclasses import astuple, replace
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from wraparc import Distributed, TrainResult, load_drive, load_train, solve, solve_train
from wraparc.checks import Check, Level, judge
from wraparc.present.checks_table import check_data, check_table, margin_text
from wraparc.present.document import json_text
from wraparc.present.drive_sheet import drive_sheet
from wraparc.present.profile_csv import profile_csv
from wraparc.present.sheet import Sheet
from wraparc.present.train_sheet import signed, train_sheet
from wraparc.units import display

EXAMPLES = Path(__file__).parents[2] / "examples"
TRAINS = ("tandem-fabric", "triple-steel-cord")
#: What results hold of the solution, not of the input.
SOLVED = ("Result", "Point", "Energy", "Capacities", "Profile")
IDLE = ["pulley.head.entry_tension=60 kN"]


def moved(value: Any, rng: np.random.Generator) -> Any:
    """Return a result with every number a few units in the last place off; inputs as they are."""
    if isinstance(value, float):
        if value == 0.0:
            return float(rng.choice([-1e-15, -0.0, 1e-15]))
        return value * (1.0 + float(rng.integers(-4, 5)) * 2.0**-52)
    if isinstance(value, np.ndarray) and value.dtype == float:
        return np.array([moved(v, rng) for v in value.tolist()])
    if isinstance(value, tuple):
        kind = type(value)
        items = [moved(v, rng) for v in value]
        return kind(*items) if hasattr(value, "_fields") else kind(items)
    if dataclasses.is_dataclass(value) and type(value).__name__.endswith(SOLVED):
        fields = [f.name for f in dataclasses.fields(value) if f.init]
        return replace(value, **{n: moved(getattr(value, n), rng) for n in fields})  # type: ignore[type-var]
    return value


def differing(one: Sheet, other: Sheet) -> list[tuple[str, str]]:
    """Return the pairs of texts in which two sheets differ."""

    def texts(sheet: Sheet) -> Iterator[str]:
        yield from (sheet.title, sheet.subtitle, *sheet.remarks, *sheet.sources)
        yield from astuple(sheet.verdict) if sheet.verdict else ()
        for table in sheet.tables:
            yield from (table.title, table.note, *table.heads)
            for row in table.rows:
                yield f"{row.title}: {' | '.join(map(str, row.values))} {row.note} {row.level}"

    pairs = zip_longest(texts(one), texts(other))
    return [(a, b) for a, b in pairs if a != b]


@pytest.mark.parametrize("system", ["si", "us"])
@pytest.mark.parametrize("name", TRAINS)
def test_a_train_reads_the_same(name: str, system: Any) -> None:
    train = load_train(EXAMPLES / f"{name}.toml")
    result = solve_train(train, method=Distributed(capacities=False, points=20))
    for seed in range(3):
        other: TrainResult = moved(result, np.random.default_rng(seed))
        assert other != result
        assert differing(train_sheet(result, system), train_sheet(other, system)) == []


@pytest.mark.parametrize(
    ("name", "changes"),
    [("head-drive-fabric", []), ("head-drive-fabric", IDLE), ("downhill-braking", [])],
)
def test_a_drive_reads_the_same(name: str, changes: list[str]) -> None:
    drive = load_drive(EXAMPLES / f"{name}.toml", overrides=changes)
    result = solve(drive, method=Distributed(points=20))
    for seed in range(3):
        other = moved(result, np.random.default_rng(seed))
        assert differing(drive_sheet([result]), drive_sheet([other])) == []


def test_what_is_below_its_accuracy_is_told_so() -> None:
    """Expected: by hand, the limit of a check of the solution is the accuracy of its value."""
    kept = Check(name="balance", title="Balance", level=Level.OK, value=2e-16, limit=1e-4)
    assert kept.texts() == ("below 0.0001", "0.0001")
    assert kept.sentence() == "Balance: below 0.0001, at most 0.0001."
    assert (kept.margin, margin_text(kept)) == (1.0, "-")
    data = check_data(kept)
    assert (data["value"], data["floor"]) == (2e-16, 1e-4)
    missed = replace(kept, level=Level.FAULT, value=3e-4, says="Misses by {value}.")
    assert missed.sentence() == "Misses by 0.0003."
    assert missed.margin == pytest.approx(-2.0)
    creep = replace(kept, name="creep", value=2e-3, limit=6.35e-3, dimension="length")
    assert (creep.texts()[0], creep.floor) == ("2 mm", 0.0)


def test_the_place_of_a_check_of_the_solution_is_not_that_of_the_largest_noise() -> None:
    result = solve(load_drive(EXAMPLES / "triple-steel-cord.toml"), method=Distributed(points=20))
    places = {next(c.place for c in judge(r).listed if c.name == "balance")
              for r in (result, moved(result, np.random.default_rng(1)))}  # fmt: skip
    assert len(places) == 1
    assert all(row.values[0].startswith("below") for row in check_table(judge(result)).rows
               if "balance" in row.title)  # fmt: skip


def test_nothing_is_minus_nothing() -> None:
    assert display(-0.0, "force") == display(-3e-7, "force") == "0 kN"
    assert display(-4e-13, "length", digits=3) == "0 mm"
    assert display(4e-12, "wear_coefficient") == "0.004 mm3/J"
    assert display(1.2e-19, "wear_coefficient") == "1.200e-10 mm3/J"
    assert signed(-0.0) == signed(2e-9) == signed(-2e-9) == "0"
    assert "-0" not in json_text({"a": -0.0, "b": [-0.0], "c": {"d": (-0.0,)}})
    result = solve(load_drive(EXAMPLES / "head-drive-fabric.toml"), method=Distributed(points=20))
    turned = moved(result, np.random.default_rng(0))
    cells = {cell for line in profile_csv(turned).splitlines() for cell in line.split(",")}
    assert "-0" not in cells
    assert math.isfinite(json.loads(json_text({"a": -0.0}))["a"])
