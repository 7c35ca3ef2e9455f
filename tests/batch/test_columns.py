"""Columns in every form that users have them in, and what is told of rows that cannot be.

Expected values: the same numbers as a plain array of double precision, bit for bit; sentences are
stated in full.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd
import pytest
from numpy.typing import NDArray

from batch.batches import designs
from wraparc.batch import Setting, solve_batch
from wraparc.batch.arcs import arcs_of_table
from wraparc.errors import InputError
from wraparc.files import load_lagging

RUBBER = load_lagging("diamond-rubber")
WIDTHS = np.array([1.25, 1.0, 1.5, 1.75, 2.0])  # the same in single precision


def read_only(value: NDArray[Any]) -> NDArray[Any]:
    value = value.copy()
    value.setflags(write=False)
    return value


class PolarsColumn:
    """What is used of a Polars column: it becomes an array, missing values nan."""

    def __init__(self, values: list[Any]) -> None:
        self.values = values

    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[Any]:
        return np.array([math.nan if v is None else v for v in self.values], dtype)


class PolarsFrame:
    """What is used of a Polars frame: the names of its columns, and each by its name.

    To iterate over one gives columns, not names.
    """

    def __init__(self, table: dict[str, Any]) -> None:
        self.columns = list(table)
        self._table = {name: PolarsColumn(np.asarray(v).tolist()) for name, v in table.items()}

    def __getitem__(self, name: str) -> PolarsColumn:
        return self._table[name]

    def __iter__(self) -> Iterator[PolarsColumn]:
        return iter(self._table.values())


FORMS: dict[str, Any] = {
    "list": WIDTHS.tolist(),
    "single precision": WIDTHS.astype(np.float32),
    "half precision": WIDTHS.astype(np.float16),
    "other byte order": WIDTHS.astype(">f8"),
    "every second": np.repeat(WIDTHS, 2)[::2],
    "backwards": WIDTHS[::-1].copy()[::-1],
    "of a table in Fortran order": np.asfortranarray(np.outer(np.ones(3), WIDTHS))[1],
    "column of a table": np.outer(WIDTHS, np.ones(3))[:, 1],
    "read only": read_only(WIDTHS),
    "objects": WIDTHS.astype(object),
    "exact numbers": [Decimal("1.25"), Fraction(1), 1.5, np.float32(1.75), 2],
    "masked nowhere": np.ma.masked_array(WIDTHS, mask=False),
    "pandas": pd.Series(WIDTHS, index=[7, 7, 3, 1, 0]),
    "pandas with missing values": pd.Series(WIDTHS, dtype="Float64"),
    "polars": PolarsColumn(WIDTHS.tolist()),
}


@pytest.mark.parametrize("form", FORMS)
def test_a_column_in_any_form_is_the_same_column(form: str) -> None:
    table: dict[str, Any] = {**designs(5, 19), "belt_width": FORMS[form]}
    arcs = arcs_of_table(table, RUBBER)
    assert arcs.belt_width.tobytes() == WIDTHS.tobytes()
    assert arcs.belt_width.flags.c_contiguous
    assert arcs.belt_width.flags.writeable


def test_whole_numbers_and_truth_values_are_numbers_where_they_may_be() -> None:
    table: dict[str, Any] = {**designs(3, 19), "belt_width": np.array([1, 2, 3], dtype=np.uint8),
                             "recovery": [True, False, True]}  # fmt: skip
    arcs = arcs_of_table(table, RUBBER)
    assert arcs.belt_width.tolist() == [1.0, 2.0, 3.0]
    assert arcs.recovery.tolist() == [1.0, 0.0, 1.0]


@pytest.mark.parametrize("frame", [pd.DataFrame, PolarsFrame])
def test_a_frame_is_a_table(frame: Any) -> None:
    table = designs(40, 3)
    of_frame = solve_batch(frame(table), RUBBER, capacities=False)
    plain = solve_batch(table, RUBBER, capacities=False)
    assert of_frame.found.tobytes() == plain.found.tobytes()


def test_what_is_read_is_never_changed() -> None:
    table = designs(6, 3)
    before = {name: v.tobytes() for name, v in table.items()}
    arcs = arcs_of_table(table, RUBBER)
    arcs.entry_tension[:] = 1.0
    assert {name: v.tobytes() for name, v in table.items()} == before


BAD: dict[str, tuple[Any, str]] = {
    "nan": ([1.0, math.nan, 1.0], "row 1: must be more than 0 and finite, got nan."),
    "infinite": ([1.0, 1.0, math.inf], "row 2: must be more than 0 and finite, got inf."),
    "zero": ([0, 1, 1], "row 0: must be more than 0 and finite, got 0 mm."),
    "negative": (
        [1.0, -1.5, -2.0],
        "row 1: must be more than 0 and finite, got -1500 mm. Correct rows 1, 2.",
    ),
    "text": (["1.0", 1.0, "1 m"],
             'row 0: must be a number [m], got "1.0". Correct rows 0, 2.'),
    "array of texts": (np.array(["1.0", "2", "3"]),
                       'row 0: must be a number [m], got "1.0". Correct rows 0, 1, 2.'),
    "truth value": ([1.0, True, 1.0], "row 1: must be a number [m], got true."),
    "none": ([1.0, None, 1.0], "row 1: must be a number [m], got no value."),
    "missing in pandas": (pd.Series([1.0, None, 1.0], dtype="Float64"),
                          "row 1: must be more than 0 and finite, got nan."),
    "masked": (np.ma.masked_array([1.0, 2.0, 3.0], mask=[False, False, True]),
               "row 2: must be a number [m], got no value."),
    "complex": (np.array([1.0, 1.0, 1j]),
                'row 0: must be a number [m], got "(1+0j)". Correct rows 0, 1, 2.'),
    "dates": (np.array(["2020-01-01"] * 3, "M8[D]"),
              'row 0: must be a number [m], got "2020-01-01". Correct rows 0, 1, 2.'),
    "beyond numbers": ([1.0, 1.0, 10**400], f"row 2: must be a number [m], got 1{'0' * 55}..."),
    "a list within": ([1.0, [2.0], 3.0], "row 1: must be a number [m], got [2.0]."),
    "missing in polars": (PolarsColumn([1.0, None, 1.0]),
                          "row 1: must be more than 0 and finite, got nan."),
}  # fmt: skip


@pytest.mark.parametrize("fault", BAD)
def test_rows_that_cannot_be_are_told(fault: str) -> None:
    column, sentence = BAD[fault]
    with pytest.raises(InputError) as error:
        solve_batch({**designs(3, 19), "belt_width": column}, RUBBER)
    assert str(error.value) == f'column "belt_width", {sentence}'


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        (math.nan, "must be more than 0 and finite, got nan."),
        ("1.2 m", 'must be a number [m], got "1.2 m".'),
        ({"a": 1}, 'must be a number [m], got {"a": 1}.'),
        (np.ones((3, 1)), ("must be one number or have 3 rows, got "
                          "2 dimensions.")),
        (np.ones(2), ("must be one number or have 3 rows, got 2 "
                     "rows.")),
    ],
)  # fmt: skip
def test_one_value_for_all_rows_is_told_without_a_row(value: Any, sentence: str) -> None:
    with pytest.raises(InputError) as error:
        solve_batch({**designs(3, 19), "belt_width": value}, RUBBER)
    assert str(error.value) == f'column "belt_width": {sentence}'


def test_missing_values_are_known_where_a_number_may_be_unknown() -> None:
    table: dict[str, Any] = {
        **designs(3, 19),
        "belt_speed": [3.0, None, 4.0],
        "overrun": np.ma.masked_array([1e-5, 0.0, 0.0], mask=[False, True, False]),
    }
    arcs = arcs_of_table(table, RUBBER)
    assert np.isnan(arcs.belt_speed).tolist() == [False, True, False]
    assert np.isnan(arcs.overrun).tolist() == [False, True, False]


def test_many_bad_rows_are_told_in_one_sentence() -> None:
    table = designs(40, 19)
    table["belt_width"][::2] = -1.0
    table["wrap_angle"][3] = 0.0
    with pytest.raises(InputError) as error:
        solve_batch(table, RUBBER)
    wrap, width = error.value.problems
    assert str(wrap) == ('column "wrap_angle", row 3: must be more than 0 and finite, got 0 deg.')
    assert str(width).endswith("Correct rows 0, 2, 4, 6, 8 and 15 more.")


def test_a_belt_that_presses_on_no_pulley_is_told_with_the_rest() -> None:
    """M v^2 of 70 kN where T2 is 60 kN; before anything is solved."""
    table: dict[str, Any] = {**designs(3, 19), "entry_tension": 150e3, "exit_tension": 60e3}
    flung: dict[str, Any] = {"centrifugal_force": [100.0, 70e3, 60e3], "belt_width": 0.0}
    with pytest.raises(InputError) as error:
        solve_batch({**table, **flung}, RUBBER)
    told = [str(problem) for problem in error.value.problems]
    assert told == [
        'column "belt_width": must be more than 0 and finite, got 0 mm.',
        (
            'column "centrifugal_force", row 1: must be less than both tensions, got 70 kN. '
            "Correct rows 1, 2."
        ),
    ]


def test_a_setting_is_taken_by_its_name() -> None:
    table = {
        "entry_tension": 1e5, "exit_tension": 5e4, "diameter": 1.0, "wrap_angle": 3.2,
        "belt_width": 1.2, "belt_modulus": 1.3e7,
    }  # fmt: skip
    of = load_lagging("diamond-rubber")
    named = solve_batch(table, of, setting="precise")
    assert named["exit_creep"] == solve_batch(table, of, setting=Setting.PRECISE)["exit_creep"]
    with pytest.raises(InputError, match=r"setting: no such setting, got .*precice.*precise"):
        solve_batch(table, of, setting="precice")
