"""What the name of a test file tells."""

import pytest

from wraparc.shear_test.file_names import read_name


@pytest.mark.parametrize(
    ("name", "pressure", "condition", "number"),
    [
        ("wet-0034kPa-1.csv", 34, "wet", "1"),
        ("dry-0690kPa-2.MTR", 690, "dry", "2"),
        ("Lot 7 nass 20 psi run 3.txt", 20, "wet", "3"),
        ("138kPa.xlsx", 138, None, None),
        ("dry and wet 34kPa.csv", 34, None, None),
        ("sample.csv", None, None, None),
        ("laundry-12.csv", None, None, "12"),
        ("wet 2026-03-05.csv", None, "wet", None),
    ],
)
def test_names_tell_pressure_condition_and_number(
    name: str, pressure: float | None, condition: str | None, number: str | None
) -> None:
    # expected: what someone reads off the name
    found = read_name(name)
    assert (found.pressure and float(found.pressure.split()[0])) == pressure
    assert (found.condition, found.number) == (condition, number)
