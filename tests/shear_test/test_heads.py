"""Heads of machine files: found, or asked about, never silently wrong.

Expected values: the columns that were written.
"""

import io
from dataclasses import replace
from itertools import permutations, product

import numpy as np
import pytest

from machine_tables.asked import problems
from wraparc.errors import InputError
from wraparc.machine_tables import find_tables
from wraparc.shear_test import Choices, read_machine_bytes, read_machine_tests
from wraparc.shear_test.one_test import one_run

ROWS = 40
TIME = np.arange(ROWS) * 0.5
TRAVEL = np.arange(ROWS) * 0.25
FORCE = 900.0 * (1.0 - np.exp(-TRAVEL / 2.0)) + 0.125
DEMAND = 30.0 * TIME + 0.5
#: Time, travel, force and the set-point of the force.
WORDS = {
    "en": ("Time", "Travel", "Force", "Force set point"),
    "en 2": ("Time", "Crosshead", "Load", "Load command"),
    "de": ("Zeit", "Weg", "Kraft", "Kraft Sollwert"),
    "de 2": ("Zeit", "Traversenweg", "Prüfkraft", "Sollkraft"),
    "fr": ("Temps", "Course", "Force", "Consigne de force"),
    "es": ("Tiempo", "Desplazamiento", "Fuerza", "Fuerza consigna"),
    "pt": ("Tempo", "Deslocamento", "Força", "Força desejada"),
    "it": ("Tempo", "Spostamento", "Forza", "Forza impostata"),
    "pl": ("Czas", "Droga", "Siła", "Siła zadana"),
    "cs": ("Čas", "Dráha", "Síla", "Žádaná síla"),
    "nl": ("Tijd", "Verplaatsing", "Kracht", "Gewenste kracht"),
    "sv": ("Tid", "Förskjutning", "Kraft", "Börvärde kraft"),
    "tr": ("Zaman", "Uzama", "Kuvvet", "Hedef kuvvet"),
    "ru": ("Время", "Ход", "Усилие", "Заданное усилие"),
    "ja": ("時間", "ストローク", "試験力", "目標試験力"),
    "zh": ("时间", "位移", "载荷", "设定载荷"),
}
UNITS = ("s", "mm", "N", "N")
VALUES = (TIME, TRAVEL, FORCE, DEMAND)
ORDERS = ((0, 3, 2, 1), (3, 1, 2, 0), (2, 3, 1, 0))
DIALECTS = ("units below", "in brackets", "title above")
TRAPS = ("none", "numeric sensors", "comment", "head lost")


def head(language: str, order: tuple[int, ...], dialect: str, trap: str) -> bytes:
    """A file whose columns stand in an order, in a dialect, with something that hides its head."""
    names, units = [WORDS[language][k] for k in order], [UNITS[k] for k in order]
    values = [VALUES[k] for k in order]
    if trap == "numeric sensors":
        names, units = [*names, "1944", "2157"], [*units, "mm", "mm"]
        values = [*values, 0.01 * TRAVEL, 0.02 * TRAVEL]
    lines = ["***Header***\t\t\t"] if dialect == "title above" else []
    if dialect == "in brackets":
        row = [f"{n} [{u}]" for n, u in zip(names, units, strict=True)]
        unit_row = []
    else:
        row, unit_row = names, ["\t".join(units)]
    if trap == "comment":
        row = [*row, "Comment"]
    if trap == "head lost":  # one name more than columns that is no comment
        row = ["", *row, "x"]
    lines += ["\t".join(row), *unit_row]
    lines += ["\t".join(f"{v:.4f}" for v in cells) for cells in zip(*values, strict=True)]
    return "\n".join(lines).encode()


@pytest.mark.parametrize("language", WORDS)
def test_no_head_of_many_is_read_silently_wrong(language: str) -> None:
    """36 heads a language, 576 in all; where the head is there, it is read."""
    for order, dialect, trap in product(ORDERS, DIALECTS, TRAPS):
        told = f"{language}, {order}, {dialect}, {trap}"
        try:
            record = read_machine_bytes(head(language, order, dialect, trap), "x")
        except InputError:
            assert trap == "head lost", told
            continue
        np.testing.assert_allclose(record.force, FORCE, atol=1e-4, err_msg=told)
        np.testing.assert_allclose(record.travel, 1e-3 * TRAVEL, atol=1e-7, err_msg=told)


@pytest.mark.parametrize("order", list(permutations(range(3))))
def test_unnamed_columns_beside_others_of_their_kind_are_asked_for(order: tuple[int, ...]) -> None:
    units = ["\t".join(("s", "mm", "N", "N", "mm")[k] for k in (*order, 3, 4))]
    values = [(TIME, TRAVEL, FORCE, DEMAND, TRAVEL)[k] for k in (*order, 3, 4)]
    rows = ["\t".join(f"{v:.4f}" for v in cells) for cells in zip(*values, strict=True)]
    text = problems("\n".join([*units, *rows]).encode())
    assert "force column unclear" in text
    assert "travel column unclear" in text


def test_height_of_a_tribometer_is_no_travel() -> None:
    rows = "\n".join(
        f"{t},{n},{f},{z}" for t, n, f, z in zip(TIME, FORCE, FORCE, TRAVEL, strict=True)
    )
    text = problems(f"Time [s],Fz [N],Fx [N],Z [mm]\n{rows}".encode())
    assert "travel column unclear" in text


def buffers(*starts: float) -> bytes:
    pieces = []
    for start in starts:
        rows = [f"{start + 0.05 * k:.3f}\t{100 * np.sqrt(start + 0.05 * k):.3f}" for k in range(40)]
        pieces += [f"Data Acquisition\tTime:\t{start}", "Displacement\tForce", "mm\tN", *rows, ""]
    return "\n".join(pieces).encode()


def test_a_run_written_in_buffers_is_one() -> None:
    record = read_machine_bytes(buffers(0.0, 2.0, 4.0), "x")
    np.testing.assert_allclose(record.travel, 1e-3 * 0.05 * np.arange(120), atol=1e-9)
    assert "the run was written in 3 pieces" in " ".join(record.notes)
    assert record.unread == 0


def test_tables_that_do_not_run_on_are_told_as_unread() -> None:
    record = read_machine_bytes(buffers(0.0, 2.0, 0.0), "x")
    assert len(record.travel) == 80
    assert record.unread == 1


def test_tests_side_by_side_end_each_for_itself() -> None:
    lines = ["A,,,B,,", "Time,Force,Stroke,Time,Force,Stroke", "s,N,mm,s,N,mm"]
    for k in range(60):
        short = f"{k / 10},{10 + k},{k / 20}" if k < 14 else ",,"
        lines.append(f"{short},{k / 5},{20 + k},{k / 10}")
    one, two = read_machine_tests_of("\n".join(lines).encode())
    assert (len(one.travel), len(two.travel)) == (14, 60)
    assert one.time is not None
    assert two.time is not None
    assert one.time[-1] == pytest.approx(1.3)
    assert two.time[-1] == pytest.approx(11.8)
    assert not one.dropped


def read_machine_tests_of(data: bytes) -> list:  # type: ignore[type-arg]
    return [read_machine_bytes(data, "x", Choices(block=k)) for k in (1, 2)]


def test_a_stress_has_its_unit_from_the_user() -> None:
    data = b"Travel (mm),Shear stress\n" + b"".join(b"%d,%d\n" % (k, 10 * k) for k in range(20))
    choices = Choices(units={"Shear stress": "kPa"}, stress_area=0.04)
    record = read_machine_bytes(data, "x", choices)
    np.testing.assert_allclose(record.force, 10e3 * 0.04 * np.arange(20))


@pytest.mark.parametrize(
    ("head_row", "factor"),
    [("Time_S,Disp_MM,Force_KN", 1e3), ("Time_S,Disp_MM,Force_N", 1.0)],
)
def test_units_behind_an_underscore(head_row: str, factor: float) -> None:
    rows = "\n".join(f"{k * 0.1:.1f},{k * 0.5:.1f},{k * 2.0:.1f}" for k in range(20))
    record = read_machine_bytes(f"{head_row}\n{rows}".encode(), "x")
    np.testing.assert_allclose(record.force, factor * 2.0 * np.arange(20))
    np.testing.assert_allclose(record.travel, 0.5e-3 * np.arange(20))


def test_a_stress_behind_an_underscore_is_asked_for_its_area() -> None:
    rows = "\n".join(f"{k * 0.5:.1f},{k * 0.2:.1f}" for k in range(20))
    text = problems(f"Disp_MM,shear_stress_mpa\n{rows}".encode())
    assert 'Add --force, or --stress-area for "shear_stress".' in text
    data = f"Disp_MM,shear_stress_mpa\n{rows}".encode()
    record = read_machine_bytes(data, "x", Choices(stress_area=1e-4))
    np.testing.assert_allclose(record.force, 100.0 * 0.2 * np.arange(20))


def test_a_column_is_found_under_the_name_that_the_file_writes() -> None:
    rows = "\n".join(f"{k},{2 * k},{3 * k}" for k in range(20))
    data = f"Time (s),Way (mm),Push (N)\n{rows}".encode()
    record = read_machine_bytes(data, "x", Choices(travel="Way (mm)", force="Push (N)"))
    np.testing.assert_allclose(record.force, 3.0 * np.arange(20))


def test_cells_with_units_are_told_by_their_cause() -> None:
    rows = "\n".join(f"{k},5 mm;{k} N" for k in range(20))
    assert "its cells are text with units" in problems(f"Weg;Kraft\n{rows}".encode())
    xlsxwriter = pytest.importorskip("xlsxwriter")
    stream = io.BytesIO()
    book = xlsxwriter.Workbook(stream, {"in_memory": True})
    sheet = book.add_worksheet()
    sheet.write_row(0, 0, ["Weg", "Kraft"])
    for k in range(20):
        sheet.write_row(k + 1, 0, [f"{k},1 mm", f"{k} N"])
    book.close()
    assert "such as '0,1 mm'" in problems(stream.getvalue()).replace('"', "'")


def test_all_tests_side_by_side_are_read(tmp_path) -> None:  # type: ignore[no-untyped-def]
    lines = ["Force [N],Stroke [mm],Force [N],Stroke [mm]"]
    lines += [f"{k},{k},{2 * k},{k}" if k < 30 else f",,{2 * k},{k}" for k in range(80)]
    path = tmp_path / "two.csv"
    path.write_text("\n".join(lines))
    assert [len(record.travel) for record in read_machine_tests(path)] == [30, 80]


def test_a_best_table_without_a_head_stands_alone_beside_others_that_have_one() -> None:
    """Such a table is like each that has a head and not like itself, which a mutated file found."""
    data = head("en", (0, 1, 2), "units below", "none")
    (table,) = find_tables(data, "run.csv").tables
    best = replace(table, header=())
    assert one_run([table, best, replace(table)], best) == [best]
