"""Which stroke of a record is used: first, last, all or their mean.

Expected values: three pulls of one made-up rise, the force 1.3, 1.1 and 1.0 times as large, as
run-in cycles fall. The reading at a turn is of both ways: 82 of the later pulls.
"""

import numpy as np
import pytest

from wraparc.answer.shear_test_record import record_sheet
from wraparc.errors import InputError
from wraparc.shear_test import Choices, MachineRecord, Sample, read_machine_bytes, reduce_record
from wraparc.shear_test.plan_file import plan_from_text

FACTORS = (1.3, 1.1, 1.0)
RISE = np.linspace(0.0, 1.0, 81) ** 0.5


def cycles(*, back: float = -0.9) -> MachineRecord:
    """Three pulls and the ways back, under `back` times the force of the pull."""
    travel = np.linspace(0.0, 10.0, 81)
    x, f = [], []
    for factor in FACTORS:
        x += [travel, travel[::-1]]
        f += [factor * 4000.0 * RISE, back * factor * 4000.0 * RISE[::-1]]
    rows = zip(np.concatenate(x), np.concatenate(f), strict=True)
    text = "Travel [mm];Load [N]\n" + "".join(f"{a:.4f};{b:.3f}\n" for a, b in rows)
    return read_machine_bytes(text.encode(), "cycles.csv", Choices())


@pytest.mark.parametrize(
    ("stroke", "factor", "readings"),
    [("first", 1.3, 81), ("last", 1.0, 82), ("mean", 3.4 / 3.0, 81), ("all", 3.4 / 3.0, 245)],
)
@pytest.mark.parametrize("back", [-0.9, 0.0])
def test_the_stroke_that_is_asked_for(
    stroke: str, factor: float, readings: int, back: float
) -> None:
    sample = Sample(area=0.04, faces=2, normal_force=4000.0, stroke=stroke)
    curve = reduce_record(cycles(back=back), sample)
    assert len(curve.travel) == readings
    end = curve.friction[curve.travel > 9.99e-3]
    assert np.mean(end) == pytest.approx(0.5 * factor, rel=1e-3)
    assert "3 strokes" in curve.notes[0]


def test_the_sheet_of_a_file_tells_how_many_strokes_there_are() -> None:
    (row,) = [r for r in record_sheet(cycles()).tables[1].rows if r.title == "Strokes"]
    assert row.values == ("3",)
    assert "the first is used where a plan does not say another" in row.note


def test_the_stroke_is_a_choice_of_the_plan() -> None:
    plan = """
format = 1
[lagging]
name = "x"
[rig]
sample_area = "400 cm2"
[columns]
stroke = "last"
stress_area = "800 cm2"
[[test]]
file = "a.csv"
pressure = "34 kPa"
[[test]]
file = "a.csv"
pressure = "34 kPa"
stroke = "mean"
block = 2
"""
    one, two = plan_from_text(plan).tests
    assert (one.stroke, two.stroke) == ("last", "mean")
    assert (one.choices.block, two.choices.block) == (None, 2)
    assert one.choices.stress_area == pytest.approx(0.08)
    with pytest.raises(InputError, match="stroke"):
        plan_from_text(plan.replace('"mean"', '"middle"'))
