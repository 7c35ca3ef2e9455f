"""Logs as control systems write them: expected are the readings that were put in."""

import numpy as np
import pytest

from wraparc import InputError
from wraparc.machine_tables.log_rows import LogFile, read_log

HOURS = np.arange(48)
SPEED, TORQUE = 1487.25 + HOURS, 40.5 + HOURS % 7


def log(text: str, encoding: str = "utf-8") -> LogFile:
    found = read_log(text.encode(encoding), "log.csv")
    assert found is not None
    return found


def stamp(hour: int) -> str:
    return f"{1 + hour // 24:02d}.03.2026 {hour % 24:02d}:00:00"


def in_german(value: float) -> str:
    return f"{value:.3f}".replace(".", ",")


WIDE = "Zeitstempel;M1_Drehzahl;M1_Drehmoment\n;1/min;%\n" + "".join(
    f"{stamp(h)};{in_german(a)};{in_german(b)}\n"
    for h, a, b in zip(HOURS.tolist(), SPEED.tolist(), TORQUE.tolist(), strict=True)
)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-8-sig", "utf-16-le", "cp1252"])
def test_a_column_a_tag(encoding: str) -> None:
    found = log(WIDE, encoding)
    assert [(tag.name, tag.unit) for tag in found.tags] == [
        ("M1_Drehzahl", "1/min"), ("M1_Drehmoment", "%"),
    ]  # fmt: skip
    assert np.array_equal(found.tags[0].values, SPEED)
    assert np.array_equal(found.tags[1].values, TORQUE)
    assert set(np.diff(found.tags[0].times).tolist()) == {3600.0}
    assert (found.is_long, found.is_zoned, found.rows, found.skipped) == (False, False, 48, 0)


def test_a_row_a_reading_with_unit_and_quality() -> None:
    rows = ["Tag,Timestamp,Value,Unit,Quality"]
    for h in HOURS.tolist():
        clock = f"2026-03-{1 + h // 24:02d}T{h % 24:02d}:00:00+01:00"
        rows.append(f"CV07.M1.Speed,{clock},{SPEED[h]},rpm,Good")
        rows.append(f"CV07.M1.Torque,{clock},{TORQUE[h]},%,{'Bad' if h == 5 else 'Good'}")
    found = log("\n".join(rows))
    assert found.is_long
    assert found.is_zoned
    speed, torque = found.tags
    assert (speed.name, speed.unit) == ("CV07.M1.Speed", "rpm")
    assert (torque.name, torque.unit) == ("CV07.M1.Torque", "%")
    assert np.array_equal(speed.values, SPEED)
    assert np.flatnonzero(np.isnan(torque.values)).tolist() == [5]
    # midnight one hour east of Greenwich is 23 h of the day before
    assert speed.times[0] % 86400.0 == 23 * 3600.0


def test_every_tag_with_its_own_clock() -> None:
    # as a spreadsheet of stored values has it: the tag that changes less has fewer rows
    rows = ["Time,Speed [rpm],Time,Torque [%]"]
    for h in HOURS.tolist():
        clock = f"2026-03-{1 + h // 24:02d} {h % 24:02d}:00:00"
        later = f"2026-03-{1 + h // 12:02d} {2 * (h % 12):02d}:30:00"
        rows.append(
            f"{clock},{SPEED[h]},{later},{TORQUE[h]}" if h < 24 else f"{clock},{SPEED[h]},,"
        )
    speed, torque = log("\n".join(rows)).tags
    assert (len(speed.times), len(torque.times)) == (48, 24)
    assert torque.times[0] - speed.times[0] == 1800.0


def test_what_is_no_number_is_a_missing_reading() -> None:
    rows = ["Time,Speed [rpm],Torque [%]"]
    for h in HOURS.tolist():
        bad = {3: "Bad", 4: "", 5: "I/O Timeout", 6: "-"}.get(h, f"{TORQUE[h]}")
        rows.append(f"2026-03-{1 + h // 24:02d} {h % 24:02d}:00,{SPEED[h]},{bad}")
    rows.insert(20, "exported by somebody")
    found = log("\n".join(rows))
    assert np.flatnonzero(np.isnan(found.tags[1].values)).tolist() == [3, 4, 5, 6]
    assert np.isfinite(found.tags[0].values).all()
    assert (found.rows, found.skipped) == (48, 1)


def test_a_table_without_clock_times_is_no_log() -> None:
    text = "Travel mm;Force N\n" + "".join(f"{k},5;{k}\n" for k in range(50))
    assert read_log(text.encode(), "test.csv") is None


def test_numbers_that_may_be_read_in_two_ways_are_asked_for() -> None:
    rows = ["Time;Speed [rpm]", *(f"2026-03-01 {h:02d}:00;1,{480 + h}" for h in range(24))]
    with pytest.raises(InputError, match="decimal sign unclear"):
        log("\n".join(rows))
