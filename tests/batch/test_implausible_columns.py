"""Columns of sizes that no drive has: a unit that is not the SI unit."""

import warnings

import numpy as np
import pytest
from numpy.typing import ArrayLike

from wraparc.batch import solve_batch
from wraparc.files import load_lagging

TABLE: dict[str, ArrayLike] = {
    "entry_tension": 160e3, "exit_tension": np.array([60e3, 70e3, 80e3]), "diameter": 0.8,
    "wrap_angle": np.pi, "belt_width": 1.2, "belt_modulus": 10e6,
}  # fmt: skip
PLAIN = load_lagging("diamond-rubber")


def test_a_table_in_si_units_warns_of_nothing() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solve_batch(TABLE, PLAIN)


@pytest.mark.parametrize(
    ("column", "value", "words"),
    [
        ("wrap_angle", 180.0, "wrap_angle: .* in 3 of 3 rows"),
        ("entry_tension", 160.0, "entry_tension: 0.16 kN in 3 of 3 rows"),
        ("exit_tension", np.array([60e3, 70.0, 80e3]), "exit_tension: 0.07 kN in 1 of 3 rows"),
        ("diameter", 800.0, "diameter: .* usual are 150 mm to 3"),
        ("belt_width", 1200.0, "belt_width"),
    ],
)
def test_sizes_that_no_drive_has_warn_once_a_column(
    column: str, value: ArrayLike, words: str
) -> None:
    with pytest.warns(UserWarning, match=words) as warned:
        solve_batch({**TABLE, column: value}, PLAIN)
    assert len([w for w in warned if str(w.message).startswith(f"{column}:")]) == 1


def test_a_rigid_lagging_is_none_of_them() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solve_batch({**TABLE, "shear_modulus": np.inf}, PLAIN)
