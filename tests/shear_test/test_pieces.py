"""One run that a machine wrote in pieces is one test of all its rows, or what is not read is said.

Expected: the rows that were written.
"""

from typing import Any

import numpy as np
import pytest

from shear_test.test_traps import read
from wraparc.answer.shear_test_record import record_sheet
from wraparc.checks import Level
from wraparc.shear_test import Choices, read_machine_bytes

COUNT = 270


def pull(noise: float, seed: int = 1) -> tuple[Any, Any]:
    """Travel [mm] with noise of its reading, and force [N]."""
    rng = np.random.default_rng(seed)
    travel = 0.04 * np.arange(COUNT)
    r = np.clip((travel - 0.3) / 8.0, 1e-9, 1.0)
    force = 4000.0 * r * (1.0 - np.log(r)) + rng.normal(0.0, 8.0, COUNT)
    return travel + rng.normal(0.0, noise, COUNT), force


def written(pieces: int, noise: float, time: str, seed: int = 1, factor: float = 1.0) -> str:
    travel, force = pull(noise, seed)
    lines = []
    for k, part in enumerate(np.array_split(np.arange(COUNT), pieces)):
        begin = 0.2 * part[0]
        heads = ["Displacement\tForce", "mm\tN"] if not time else [
            "Time\tDisplacement\tForce", "s\tmm\tN"]  # fmt: skip
        lines += [f"Data Acquisition\tTime: {begin:.3f} Sec", *heads]
        for j in part.tolist():
            at = 0.2 * (j - part[0]) if time == "restarts" else 0.2 * j
            cells = f"{factor * travel[j]:.4f}\t{force[j]:.2f}"
            lines.append(f"{at:.2f}\t{cells}" if time else cells)
        lines.append("" if k + 1 < pieces else "\n")
    return "\n".join(lines)


@pytest.mark.parametrize("time", ["", "restarts", "goes on"])
@pytest.mark.parametrize("noise", [0.0, 0.02, 0.06])
@pytest.mark.parametrize("pieces", [2, 4, 9])
def test_a_noisy_run_in_pieces_is_one_test(pieces: int, noise: float, time: str) -> None:
    """One noisy reading at a seam decided, and 25 to 75 % of a run were lost."""
    for seed in (1, 2, 3):
        record = read(written(pieces, noise, time, seed))
        assert len(record.travel) == COUNT
        assert record.unread == 0
        if time:
            assert record.time is not None
            assert np.all(np.diff(record.time) > 0.0)


def test_a_travel_in_thousandths_of_an_inch_is_joined_as_well() -> None:
    text = written(9, 0.05 * 0.0254, "", factor=1 / 0.0254).replace("mm\tN", "mil\tN")
    assert len(read(text).travel) == COUNT


def test_steps_of_one_pull_are_one_by_the_columns_that_are_named() -> None:
    """A tribometer's Y says nothing by its name."""
    text = written(2, 0.0, "restarts").replace("Displacement", "Y")
    record = read_machine_bytes(text.encode(), "x", Choices(travel="Y", force="Force"))
    assert len(record.travel) == COUNT


def test_another_test_is_not_joined_and_named_as_not_read() -> None:
    other = written(4, 0.0, "restarts", seed=5)
    record = read(written(3, 0.02, "restarts") + other)
    assert len(record.travel) == COUNT
    assert record.unread == 4
    assert any("not read, for they do not go on from it: lines" in note for note in record.notes)
    told = record_sheet(record).verdict
    assert told is not None
    assert told.level is Level.ATTENTION
    assert told.text == "4 further tables of the file not read, 270 rows used."


def test_a_release_between_pieces_ends_the_run() -> None:
    """Travel goes on, the force has gone: what follows is another state."""
    lines = written(2, 0.0, "restarts").split("\n\n")
    rows = [line.split("\t") for line in lines[1].split("\n")]
    fallen = [[*row[:2], "3.00"] if len(row) == 3 and row[0][:1].isdigit() else row for row in rows]
    record = read("\n\n".join([lines[0], "\n".join(map("\t".join, fallen))]))
    assert len(record.travel) == COUNT // 2
    assert record.unread == 1
