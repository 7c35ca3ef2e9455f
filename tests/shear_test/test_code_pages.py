"""Heads of machine files in other writings: told by their words, or asked; nothing steers a screen.

Expected: the columns that were written.
"""

from typing import Any

import numpy as np
import pytest

from machine_tables.asked import problems
from wraparc.errors import InputError
from wraparc.machine_tables.code_pages import printable
from wraparc.machine_tables.sniff import decode
from wraparc.shear_test import Choices, read_machine_bytes
from wraparc.shear_test.clock import clock_seconds
from wraparc.shear_test.roles import Role, suitability

TRAVEL = 0.25 * np.arange(40)
FORCE = 1900.0 * (1.0 - np.exp(-TRAVEL / 2.0)) + 0.125

HEADS = {
    "gbk": "时间(s),力(N),位移(mm)",
    "big5": "時間(s),力(N),位移(mm)",
    "cp949": "시간(s),하중(N),변위(mm)",
    "cp932": "時間(s),荷重(N),変位(mm)",
    "koi8-r": "время (с),сила (Н),перемещение (мм)",
    "cp1251": "время (с),сила (Н),перемещение (мм)",
    "cp1254": "süre (s),yük (N),yer değiştirme (mm)",
    "cp1250": "čas (s),zatížení (N),dráha (mm)",
    "cp1252": "Prüfzeit (s),Standardkraft (N),Weg über Länge (mm)",
}


def table(head: str, first: Any = None) -> str:
    times = first or [f"{0.5 * k:.2f}" for k in range(len(TRAVEL))]
    rows = zip(times, FORCE, TRAVEL, strict=True)
    return "\n".join([head, *(f"{t},{f:.4f},{x:.4f}" for t, f, x in rows), ""])


@pytest.mark.parametrize("page", HEADS)
def test_a_code_page_is_told_by_the_words_of_the_head(page: str) -> None:
    record = read_machine_bytes(table(HEADS[page]).encode(page), "x")
    assert record.encoding == page
    assert [column.name for column in record.columns] == [
        cell.partition("(")[0].strip() for cell in HEADS[page].split(",")
    ]
    np.testing.assert_allclose(record.force, FORCE, atol=1e-4)
    np.testing.assert_allclose(record.travel, 1e-3 * TRAVEL, atol=1e-7)
    assert record.time is not None


def test_a_page_that_no_word_tells_is_asked() -> None:
    """Thai in its own page reads as letters of no language in the Western ones."""
    data = table("เวลา(s),แรง(N),ระยะทาง(mm)").encode("cp874")
    assert "encoding unclear. Give --encoding, such as gbk, big5" in problems(data)


@pytest.mark.parametrize("text", ["ì più velocità °C µm ±", "Größe, Länge, Weg", "señal, ángulo"])
def test_western_letters_are_not_asked_about(text: str) -> None:
    assert decode(f"{text}\n1,2\n".encode("cp1252"), "x").encoding == "cp1252"


@pytest.mark.parametrize(
    "brackets", ["\uff08{}\uff09", "\u3010{}\u3011", "\uff3b{}\uff3d", "\uff0f{}"]
)
def test_brackets_of_full_width_are_brackets(brackets: str) -> None:
    """ "No unit, give =N" was said to one in kN, and followed: a factor of 1,000."""
    s, kn, mm = (brackets.format(unit) for unit in ("s", "kN", "mm"))
    record = read_machine_bytes(table(f"Zeit{s},Kraft{kn},Weg{mm}").encode(), "x")
    np.testing.assert_allclose(record.force, 1e3 * FORCE, rtol=1e-4)


def test_units_in_a_line_that_names_itself_are_those_of_the_channels() -> None:
    head = (
        "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\n\t\nChannels\t2\t\n"
        "Samples\t40\t40\t\nY_Unit_Label\tkN\tmm\t\nX0\t0\t0\t\nDelta_X\t0.5\t0.5\t\n"
        "***End_of_Header***\t\t\t\nX_Value\tForce\tTravel\tComment\n"
    )
    body = table("").replace(",", "\t").strip()
    record = read_machine_bytes(f"{head}{body}\n".encode(), "x")
    np.testing.assert_allclose(record.force, 1e3 * FORCE, rtol=1e-4)
    np.testing.assert_allclose(record.travel, 1e-3 * TRAVEL, atol=1e-7)


def test_no_control_character_or_mark_of_direction_reaches_a_screen() -> None:
    hostile = "Load\x1b[31m\x1b]0;title\x07\u202e\u2066\x9b (N)"
    record = read_machine_bytes(table(f"Time (s),{hostile},Travel (mm)").encode(), "x")
    assert [column.name for column in record.columns] == ["Time", "Load", "Travel"]
    with pytest.raises(InputError) as caught:
        read_machine_bytes(table(f"Time,{hostile[:-4]},Travel").encode(), "x")
    assert str(caught.value).replace("\n", "").isprintable()
    assert printable("a\tb\nc") == "a\tb\nc"


@pytest.mark.parametrize(
    ("cells", "seconds"),
    [
        (["12:21:58.029", "12:21:58.529", "12:22:00"], [0.0, 0.5, 1.971]),
        (["23:59:59,5", "00:00:00,5"], [0.0, 1.0]),
        (["2026-03-05 11:59 PM", "2026-03-06 12:01 AM"], [0.0, 120.0]),
        (["05.03.2026 7:00:00", "05.03.2026 7:00:01"], [0.0, 1.0]),
    ],
)
def test_clocks(cells: list[str], seconds: list[float]) -> None:
    found = clock_seconds(cells)
    assert found is not None
    assert found == pytest.approx(seconds)
    assert clock_seconds([*cells, "noon"]) is None


def test_a_clock_is_the_time_of_a_test() -> None:
    clock = [f"23:59:{50 + k // 2:02d}.{5 * (k % 2)}" for k in range(20)]
    clock += [f"00:00:{k // 2:02d}.{5 * (k % 2)}" for k in range(20)]
    record = read_machine_bytes(table("Uhrzeit,Kraft (N),Weg (mm)", clock).encode(), "x")
    assert record.time is not None
    np.testing.assert_allclose(record.time, 0.5 * np.arange(40), atol=1e-9)


@pytest.mark.parametrize(
    "name",
    ["Time", "Prüfzeit", "Temps", "Tiempo", "Tempo", "Czas", "Čas", "Tijd", "Tid", "Süre", "Время",
     "時間", "时间", "시간", "Idő", "Aika", "Χρόνος"],
)  # fmt: skip
def test_time_in_many_languages(name: str) -> None:
    assert suitability(name, Role.TIME) > 0.0


@pytest.mark.parametrize("name", ["PosZ", "Axis_Z", "stageZ", "Ch1 Z", "Probe.Z", "ProbeZ"])
def test_z_behind_a_prefix_is_across(name: str) -> None:
    assert suitability(name, Role.TRAVEL) == 0.0


@pytest.mark.parametrize(("unit", "said"), [("kgf", "N"), ("KGF", "N"), ("кН", "N"), ("mil", "mm")])
def test_a_unit_that_the_file_contradicts_is_refused_in_every_spelling(
    unit: str, said: str
) -> None:
    column = "Travel" if said == "mm" else "Load"
    head = (
        f"Time (s),Load ({unit if said == 'N' else 'N'}),Travel ({unit if said == 'mm' else 'mm'})"
    )
    told = problems(table(head).encode(), Choices(units={column: said}))
    assert "contradicts" in told
