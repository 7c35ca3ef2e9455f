"""The reader never returns a wrong number: it returns the numbers written, or asks.

Expected values: the numbers the tables were made from (independent of the reader).
"""

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from wraparc.errors import InputError
from wraparc.shear_test import Choices, read_machine_bytes

COLUMNS = (("Time", "s"), ("Extension", "mm"), ("Load", "N"))


def grouped(text: str, sign: str) -> str:
    """Put `sign` between groups of three digits."""
    return text.replace(",", sign)


def cell(value: float, digits: int, decimal: str, thousands: str) -> str:
    whole, _, part = f"{value:,.{digits}f}".partition(".")
    return grouped(whole, thousands) + (decimal + part if part else "")


@st.composite
def tables(draw: st.DrawFn) -> tuple[bytes, list[list[float]], Choices]:
    """Draw a file, the numbers in it, and what a user would say about it."""
    delimiter = draw(st.sampled_from([",", ";", "\t", "|", "  "]))
    decimal = draw(st.sampled_from([".", ","]))
    thousands = draw(st.sampled_from(["", "", "," if decimal == "." else ".", "'", " "]))
    quoted = draw(st.booleans())
    digits = draw(st.tuples(*[st.integers(0, 5)] * 3))
    count = draw(st.integers(12, 40))
    step = draw(st.floats(0.01, 3.0))
    largest = draw(st.sampled_from([0.9, 40.0, 980.0, 52_000.0, 3.4e6]))
    rng = np.random.default_rng(draw(st.integers(0, 10_000)))
    start = draw(st.sampled_from([0.0, -0.3, 1.0, 700.0]))
    rows = [
        [0.1 * k, start + step * k, float(largest * rng.uniform(-0.05, 1.0))] for k in range(count)
    ]
    rows = [[round(v, d) for v, d in zip(row, digits, strict=True)] for row in rows]
    place = draw(st.sampled_from(["row", "brackets", "none"]))
    preamble = st.sampled_from(["", "Specimen 1", "Width;12.5;mm", "v1,1,mm/min"])
    lines = draw(st.lists(preamble, max_size=4))
    names = [f"{name} ({unit})" if place == "brackets" else name for name, unit in COLUMNS]
    lines.append(delimiter.join(names))
    if place == "row":
        lines.append(delimiter.join(f"({unit})" for _, unit in COLUMNS))
    for row in rows:
        cells = [cell(v, d, decimal, thousands) for v, d in zip(row, digits, strict=True)]
        lines.append(delimiter.join(f'"{c}"' for c in cells) if quoted else delimiter.join(cells))
    end = draw(st.sampled_from(["\n", "\r\n", "\r"]))
    text = end.join(lines) + draw(st.sampled_from(["", end, end + end]))
    encoding = draw(st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252"]))
    units = dict(COLUMNS) if place == "none" else {}
    told = draw(st.booleans())
    return text.encode(encoding), rows, Choices(units=units, decimal=decimal if told else None)


@settings(max_examples=200, suppress_health_check=[HealthCheck.too_slow])
@given(tables())
def test_the_numbers_written_or_a_question(drawn: tuple[bytes, list[list[float]], Choices]) -> None:
    data, rows, choices = drawn
    try:
        record = read_machine_bytes(data, "drawn.csv", choices)
    except InputError as refused:
        told = refused.problems
        assert all(problem.remedy for problem in told)
        return
    written = np.array(rows)
    kept = np.searchsorted(np.arange(len(rows)) + record.lines[0], record.lines)
    np.testing.assert_allclose(record.travel, written[kept, 1] * 1e-3, rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(record.force, written[kept, 2], rtol=1e-12, atol=1e-12)
