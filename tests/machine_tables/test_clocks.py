"""Clock times: expected is what Python's calendar makes of the same day and time."""

import datetime as dt

import numpy as np
import pytest

from wraparc import InputError
from wraparc.machine_tables.clocks import looks_like_clock, read_clocks


def seconds(*moment: int) -> float:
    return dt.datetime(*moment, tzinfo=dt.UTC).timestamp()  # type: ignore[misc, arg-type]


TEXTS = {
    "2026-03-01 06:00:00": seconds(2026, 3, 1, 6),
    "2026-03-01T06:00:00.250": seconds(2026, 3, 1, 6) + 0.25,
    "2026-03-01T06:00:00Z": seconds(2026, 3, 1, 6),
    "2026-03-01T06:00:00+02:00": seconds(2026, 3, 1, 4),
    "2026-03-01 06:00:00-0530": seconds(2026, 3, 1, 11, 30),
    "28.11.2026 06:00:01": seconds(2026, 11, 28, 6, 0, 1),
    "8.1.2026 6:05": seconds(2026, 1, 8, 6, 5),
    "28/11/2026 06:00": seconds(2026, 11, 28, 6),
    "11/28/2026 6:00:00 AM": seconds(2026, 11, 28, 6),
    "11/28/2026 12:30:00 AM": seconds(2026, 11, 28, 0, 30),
    "11/28/2026 12:30:00 PM": seconds(2026, 11, 28, 12, 30),
    "01-Mar-26 06:00:00": seconds(2026, 3, 1, 6),
    "1 Dez 2026 23:59:59": seconds(2026, 12, 1, 23, 59, 59),
    "2024-02-29 00:00:00": seconds(2024, 2, 29),
    "1999-12-31": seconds(1999, 12, 31),
}


@pytest.mark.parametrize("text", TEXTS)
def test_one_time(text: str) -> None:
    assert looks_like_clock(text)
    assert read_clocks([text], "log.csv").tolist() == [pytest.approx(TEXTS[text], abs=1e-6)]


@pytest.mark.parametrize("text", ["", "1487,290", "Bad", "6:00", "2026", "12/2026", "1.5.1"])
def test_what_is_no_time(text: str) -> None:
    assert not looks_like_clock(text)
    assert np.isnan(read_clocks([text, "2026-03-01"], "log.csv")[0])


def test_forms_may_change_from_row_to_row() -> None:
    # expected: a row each hour, whatever its number of digits
    texts = [f"{1 + k // 24}.3.2026 {k % 24}:00" for k in range(24 * 20)]
    times = read_clocks(texts, "log.csv")
    assert times[0] == seconds(2026, 3, 1)
    assert set(np.diff(times).tolist()) == {3600.0}


def test_the_order_of_day_and_month_is_proven_or_asked_for() -> None:
    rising = [f"{day:02d}/03/2026 06:00" for day in range(1, 11)]  # ten days, not ten months
    assert np.ptp(read_clocks(rising, "log.csv")) == 9 * 86400.0
    american = [f"03/{day:02d}/2026 06:00" for day in range(1, 14)]
    assert read_clocks(american, "log.csv")[0] == seconds(2026, 3, 1, 6)
    unclear = ["03/04/2026 06:00", "03/04/2026 07:00"]
    with pytest.raises(InputError, match="day and month are unclear"):
        read_clocks(unclear, "log.csv")
    assert read_clocks(unclear, "log.csv", "day first")[0] == seconds(2026, 4, 3, 6)
    assert read_clocks(unclear, "log.csv", "month first")[0] == seconds(2026, 3, 4, 6)
