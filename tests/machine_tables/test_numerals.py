"""The decimal sign of a table, by what its cells prove; expected: read by hand."""

import pytest

from wraparc.errors import InputError
from wraparc.machine_tables.numerals import style_of


@pytest.mark.parametrize(
    ("cells", "decimal", "proof"),
    [
        (["1", "20"], ".", ""),
        (["0.5", "1"], ".", "0.5"),
        (["0,5", "1"], ",", "0,5"),
        (["1.234,5", "2"], ",", "1.234,5"),
        # groups of thousands alone tell what the sign is not
        (["1.234.567", "12"], ",", "1.234.567"),
        (["1,234,567", "12"], ".", "1,234,567"),
    ],
)
def test_the_decimal_sign_is_proven(cells: list[str], decimal: str, proof: str) -> None:
    style = style_of([cells], "a.csv")
    assert (style.decimal, style.proof) == (decimal, proof)


def test_what_proves_nothing_is_asked_for() -> None:
    with pytest.raises(InputError):
        style_of([["1,234", "5"]], "a.csv")
