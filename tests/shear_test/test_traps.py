"""What machine files hold beside the readings of a test: read right, or asked about.

Expected values: the columns that were written.
"""

import io
from typing import Any

import numpy as np
import pytest

from machine_tables.asked import problems
from wraparc.errors import InputError
from wraparc.shear_test import Choices, MachineRecord, read_machine_bytes

ROWS = 40
TIME = np.arange(ROWS) * 0.5
TRAVEL = np.arange(ROWS) * 0.25
FORCE = 1900.0 * (1.0 - np.exp(-TRAVEL / 2.0)) + 0.125
NORMAL = 1400.0 + 5.0 * np.sin(TIME)
OTHER = 700.0 + 20.0 * TIME


def table(head: str, *columns: Any, sep: str = ";") -> str:
    rows = [sep.join(f"{v:.4f}" for v in cells) for cells in zip(*columns, strict=True)]
    return "\n".join([head, *rows, ""])


def read(text: str) -> MachineRecord:
    return read_machine_bytes(text.encode(), "x")


def is_right(record: MachineRecord) -> None:
    np.testing.assert_allclose(record.force, FORCE, atol=1e-4)
    np.testing.assert_allclose(record.travel, 1e-3 * TRAVEL, atol=1e-7)


@pytest.mark.parametrize(
    ("pull", "normal"),
    [("Friction force", "Vertical load"), ("Force", "Clamping load"), ("Ff", "Fz"),
     ("Shear load", "Normal"), ("Horizontal load", "Dead weight load"),
     ("Reibkraft", "Auflast"), ("Kraft", "Vertikalkraft"), ("Scherkraft", "Andruckkraft"),
     ("Effort tangentiel", "Effort normal"), ("Force", "Force de serrage"),
     ("Fuerza", "Carga vertical"), ("Fuerza de corte", "Fuerza de apriete"),
     ("Força de atrito", "Carga normal"), ("Forza", "Carico verticale"), ("Forza", "Peso"),
     ("Siła tarcia", "Siła docisku"), ("Siła", "Nacisk"),
     ("Усилие сдвига", "Вертикальная нагрузка"), ("Сила", "Сила прижима"),
     ("摩擦力", "垂直载荷"), ("剪切力", "正压力"), ("試験力", "押付力"), ("水平荷重", "鉛直荷重")],
)  # fmt: skip
def test_what_presses_is_no_pull(pull: str, normal: str) -> None:
    record = read(table(f"{normal} [N];{pull} [N];Travel [mm]", NORMAL, FORCE, TRAVEL))
    is_right(record)
    assert record.normal_force is not None
    np.testing.assert_allclose(record.normal_force, NORMAL, atol=1e-4)


@pytest.mark.parametrize(
    "names",
    [("Kraft links", "Kraft rechts"), ("Force 1", "Force 2"), ("Axial force", "Lateral force"),
     ("Load", "Channel 4"), ("Force raw", "Force tared"), ("Friction force A", "Friction force B")],
)  # fmt: skip
def test_columns_that_may_both_be_the_force_are_asked_for(names: tuple[str, str]) -> None:
    text = problems(
        table(f"{names[0]} [N];{names[1]} [N];Travel [mm]", OTHER, FORCE, TRAVEL).encode()
    )
    assert "force column unclear" in text
    assert 'Add --force with one of "' in text
    # the same readings twice are no question
    is_right(read(table(f"{names[0]} [N];{names[1]} [N];Travel [mm]", FORCE, FORCE, TRAVEL)))


def test_a_load_beside_a_coefficient_of_friction_is_asked_about() -> None:
    """It may be the normal force."""
    text = problems(table("Load [N];COF;Stroke [mm]", NORMAL, FORCE / NORMAL, TRAVEL).encode())
    assert 'Add --force with one of "Load" [N], "COF".' in text
    is_right(read(table("Fz [N];Load [N];COF;Stroke [mm]", NORMAL, FORCE, FORCE, TRAVEL)))


@pytest.mark.parametrize(
    "name",
    ["Vertical displacement", "Displacement Z", "Vertikalweg", "Setzung", "Déplacement vertical",
     "Desplazamiento vertical", "Przemieszczenie pionowe", "Вертикальное перемещение", "竖向位移"],
)  # fmt: skip
def test_a_travel_across_is_no_travel(name: str) -> None:
    is_right(read(table(f"{name} [mm];Displacement [mm];Force [N]", OTHER, TRAVEL, FORCE)))


def test_tension_that_is_also_told_as_compression_is_no_normal_force() -> None:
    record = read(table("Compressive load [N];Extension [mm];Load [N]", -FORCE, TRAVEL, FORCE))
    is_right(record)
    assert record.normal_force is None


FOOTERS = {
    "words": "Mean;7.5;1500.2\nMax;9.7;1880.1\n",
    "a title": "\nStatistics\n7.5;9.2;1500.2\n9.7;9.7;1880.1\n",
    "nothing": "4.7;7.5;1500.2\n",
}


@pytest.mark.parametrize("footer", FOOTERS)
@pytest.mark.parametrize("times", [1, 20])
def test_results_under_a_table_are_no_readings(footer: str, times: int) -> None:
    """Of short tables and of long ones, which are read in pieces."""
    count = ROWS * times
    time, travel = np.arange(count) * 0.5, np.arange(count) * 0.01
    text = table("Time [s];Travel [mm];Force [N]", time, travel, travel**0.5)
    record = read(text + FOOTERS[footer])
    np.testing.assert_allclose(record.travel, 1e-3 * travel, atol=1e-7)


def test_a_row_of_factors_is_asked_about() -> None:
    text = table("Kanal;Zeit [s];Weg [mm];Kraft [N]", TIME, TIME, TRAVEL, FORCE)
    head, _, rows = text.partition("\n")
    assert "has factors above the readings: Faktor 1 1 10" in problems(
        f"{head}\nFaktor;1;1;10\nOffset;0;0;0\n{rows}".encode()
    )
    is_right(read(f"{head}\nFaktor;1;1;1\nOffset;0;0;0\n{rows}"))


@pytest.mark.parametrize("gap", ["NaN", "#N/A", "-", "1.#QNAN", "OVER", ""])
def test_a_number_that_is_missing_splits_no_table_of_two_columns(gap: str) -> None:
    rows = table("Travel [mm];Force [N]", TRAVEL, FORCE).split("\n")
    rows[8] = f"{TRAVEL[7]};{gap}"
    assert len(read("\n".join(rows)).force) == ROWS - 1


def test_a_head_repeated_in_the_middle_of_a_long_table_is_left_out() -> None:
    rng = np.random.default_rng(1)
    travel = np.arange(400) * 0.05
    rows = table("Kraft [N];Weg [mm]", travel + rng.normal(0.0, 1.0, 400), travel).split("\n")
    for k in range(380, 3, -10):
        rows.insert(k, rows[0])
    np.testing.assert_allclose(read("\n".join(rows)).travel, 1e-3 * travel, atol=1e-7)


@pytest.mark.parametrize(
    ("head", "column"),
    [
        ("Travel [mm];Force [N]\n[mm];[kN]", '"Force" [N or kN]'),
        ("Travel [mm];Force/1000 [N]", '"Force/1000" [/1000 N]'),
        ("Travel [mm];Force (x10^3 N)", "[x10^3 N]"),
    ],
)
def test_units_that_contradict_and_factors_in_names_are_asked_about(head: str, column: str) -> None:
    data = table(head, TRAVEL, FORCE).encode()
    text = problems(data)
    assert "force column unclear" in text
    assert column in text
    record = read_machine_bytes(data, "x", Choices(units={"2": "kN"}))
    np.testing.assert_allclose(record.force, 1e3 * FORCE, atol=0.1)


@pytest.mark.parametrize("blank", ["\u00a0", "\u202f"])
def test_blanks_that_do_not_break_group_digits(blank: str) -> None:
    """1 234,5 was lost, and with it all large readings."""
    rows = [f"{k},5\t{1 + k}{blank}234,5" for k in range(40)]
    record = read("\n".join(["Weg [mm]\tKraft [N]", *rows]))
    np.testing.assert_allclose(record.force, 1234.5 + 1000.0 * np.arange(40))
    with pytest.raises(InputError):
        read("\n".join(["Weg [mm]\tKraft [N]", *(f"{k},5\t1a234" for k in range(40))]))


def test_hidden_sheets_are_read_only_by_name() -> None:
    xlsxwriter = pytest.importorskip("xlsxwriter")
    stream = io.BytesIO()
    book = xlsxwriter.Workbook(stream, {"in_memory": True})
    for name, count in (("seen", 20), ("hidden", 60)):
        sheet = book.add_worksheet(name)
        sheet.write_row(0, 0, ["Travel [mm]", "Force [N]"])
        for k in range(count):
            sheet.write_row(k + 1, 0, [0.5 * k, 3.0 * k])
    sheet.hide()
    book.close()
    assert len(read_machine_bytes(stream.getvalue(), "x").force) == 20
    assert len(read_machine_bytes(stream.getvalue(), "x", Choices(sheet="hidden")).force) == 60


def test_a_measurement_file_with_settings_above_its_names() -> None:
    """Names are one more than the columns, and two rows of numbers stand above them."""
    head = "X_Dimension\tTime\tTime\nX0\t0.0\t0.0\nDelta_X\t0.5\t0.5\n***End_of_Header***\t\t\n"
    names = "X_Value\tTravel (mm)\tForce (N)\tComment"
    is_right(read(head + table(names, TIME, TRAVEL, FORCE, sep="\t")))


def test_a_head_that_does_not_know_the_force_still_tells_of_a_second_test() -> None:
    one = table("Weg [mm];FR [N]", TRAVEL, FORCE)
    assert read(f"{one}\n\nProbe 2\n{one}").unread == 1
    # behind an empty line and without a head
    timed = table("Zeit [s];Weg [mm];Kraft [N]", TIME, TRAVEL, FORCE)
    record = read(f"{timed}\n{timed.partition(chr(10))[2]}")
    is_right(record)
    assert record.unread == 1
