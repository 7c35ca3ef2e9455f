"""Reserves of designs by column: those of each drive alone."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from reserve.test_find import euler
from wraparc import load_lagging, solve, solve_batch
from wraparc.drive import Drive, Lagging, LoadCase, Tensions
from wraparc.errors import InputError
from wraparc.files import drive_from_document
from wraparc.reserve import Flip, find_reserve, find_reserves

TABLE: dict[str, Any] = {
    "entry_tension": np.array([100e3, 120e3, 90e3]),
    "exit_tension": np.array([40e3, 45e3, 30e3]),
    "diameter": 1.0,
    "wrap_angle": np.array([3.2, 3.3, 3.5]),
    "belt_width": 1.2,
    "belt_modulus": 15e6,
    "belt_speed": 3.0,
    "creep_limit": 0.02,
    "lagging": ["full-ceramic", "diamond-rubber", "diamond-rubber"],
}


def laggings() -> list[Lagging]:
    return [load_lagging(name) for name in ("diamond-rubber", "full-ceramic")]


def like() -> Drive:
    return drive_from_document(euler())


def own(row: int) -> Drive:
    """Return the drive of a row, written out."""
    base, of = like(), {name: np.broadcast_to(v, 3)[row] for name, v in TABLE.items()}
    pulley = replace(
        base.pulleys[0], diameter=1.0, wrap_angle=float(of["wrap_angle"]),
        lagging=load_lagging(str(of["lagging"])), creep_limit=0.02,
    )  # fmt: skip
    at = Tensions(entry=float(of["entry_tension"]), exit=float(of["exit_tension"]))
    return replace(
        base, belt=replace(base.belt, width=1.2, modulus=15e6, speed=3.0), pulleys=(pulley,),
        load_cases=(LoadCase(name="design", tensions={"head": at}),),
    )  # fmt: skip


def told(flips: tuple[Flip, ...]) -> list[tuple[str, float, str]]:
    return [(flip.input.name, flip.change, str(flip.level)) for flip in flips]


def test_each_is_that_of_its_drive_alone() -> None:
    found = find_reserves(TABLE, laggings(), like())
    assert len(found) == len(solve_batch(TABLE, laggings())["exit_creep"])
    for row in range(3):
        expected = find_reserve(solve(own(row)))
        assert told(found[row].flips) == told(expected.flips)
        assert found[row].level is expected.level
    assert {flip.input.name for of in found for flip in of.flips} >= {"friction", "slack_tension"}


def test_some_rows_are_asked_and_the_nearest_alone() -> None:
    (nearest,) = find_reserves(TABLE, laggings(), like(), rows=[1], every=False)
    assert told(nearest.flips) == told(find_reserve(solve(own(1)), every=False).flips)


def test_what_is_no_table_of_one_pulley_is_refused() -> None:
    with pytest.raises(InputError, match=r"column pitch_offset: follows from the belt"):
        find_reserves({**TABLE, "pitch_offset": 0.01}, laggings(), like())
    two = like()
    two = replace(two, load_cases=(*two.load_cases, replace(two.load_cases[0], name="other")))
    with pytest.raises(InputError, match=r"like.load_case: must have one load case, got 2"):
        find_reserves(TABLE, laggings(), two)
