"""The quick way through long files against the careful one, cell by cell: an independent reader."""

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from shear_test.virtual import rubber
from wraparc.arrays import Array
from wraparc.errors import InputError
from wraparc.machine_tables import tables
from wraparc.machine_tables import text as room
from wraparc.machine_tables.numerals import NumeralStyle, numbers, style_of
from wraparc.machine_tables.sniff import decode
from wraparc.shear_test import DIALECTS, Choices, VirtualRig, read_machine_bytes, run_virtual_test

TEST = run_virtual_test(VirtualRig(law=rubber(), points=400), 207e3, 1)
TEXTS = {name: d for name, d in DIALECTS.items() if name != "excel"}


def text_of(name: str) -> list[str]:
    return decode(TEXTS[name].write(TEST), name).text.splitlines()


def values(cells: object, style: NumeralStyle) -> Array:
    return numbers(cells, style)  # type: ignore[arg-type]


CHANGES: dict[str, Callable[[list[str]], list[str]]] = {
    "as it is": lambda lines: lines,
    "a blank line in it": lambda lines: [*lines[:250], "", *lines[250:]],
    "two blank lines in it": lambda lines: [*lines[:250], "", "", *lines[250:]],
    "a word after a blank line": lambda lines: [*lines[:250], "", "pause", *lines[250:]],
    "a word in it": lambda lines: [*lines[:250], "pause", *lines[250:]],
    "another table behind it": lambda lines: [*lines, "", "a;b", "", "x", *lines[-3:]],
    "the same rows behind three lines": lambda lines: [
        *lines[:300], "", "one", "two", "three", *lines[-60:],
    ],
    "a word at its end": lambda lines: [*lines, "", "end of test"],
    "a short row before a blank line": lambda lines: [*lines[:250], "1", "", *lines[250:]],
    "short rows at the end": lambda lines: [*lines, "1", "2"],
    "a row twice as wide": lambda lines: [*lines[:250], lines[250] * 2, *lines[250:]],
    "no numbers here and there": lambda lines: [
        line.replace("1", "-- µ", 1) if k > 60 and k % 9 == 0 else line
        for k, line in enumerate(lines)
    ],
    "blanks around the cells": lambda lines: [
        line.replace(";", " ; ") if k > 60 and k % 3 else line for k, line in enumerate(lines)
    ],
    "an empty cell here and there": lambda lines: [
        re.sub(r"(?<=[;\t,])[^;\t,\"]+$", "", line) if k > 60 and k % 7 == 0 else line
        for k, line in enumerate(lines)
    ],
}  # fmt: skip


@pytest.mark.parametrize("change", list(CHANGES))
@pytest.mark.parametrize("name", list(TEXTS))
def test_the_quick_way_gives_what_the_careful_one_gives(
    name: str, change: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = "\n".join(CHANGES[change](text_of(name))) + "\n"
    monkeypatch.setattr(room, "_PIECE", 60)
    quick = room.tables_in_text(text)
    monkeypatch.setattr(room, "_quick", lambda *_: None)
    careful = room.tables_in_text(text)
    assert [t.place for t in quick] == [t.place for t in careful]
    assert [t.header for t in quick] == [t.header for t in careful]
    for one, other in zip(quick, careful, strict=True):
        assert one.lines.tolist() == other.lines.tolist()
        assert one.skipped == other.skipped
        columns: Any = [c for c in other.columns if any(str(cell).strip() for cell in c)]
        style = one.style or style_of(
            [c for c in columns if isinstance(c[0], str) and c[0][-1:].isdigit()], ""
        )
        for a, b in zip(one.columns, other.columns, strict=True):
            np.testing.assert_array_equal(values(a, style), values(b, style))


@pytest.mark.parametrize("cell", ["note", "", "7", "n.a.; see below", "über"])
def test_a_sparse_column_of_notes_goes_the_quick_way(
    cell: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = [f"{k * 0.1:.1f};{k * 0.25:.2f};" for k in range(1000)]
    for k in range(200, 1000, 97):
        rows[k] += cell.replace(";", "")
    text = "Weg [mm];Kraft [N];Note\n" + "\n".join(rows) + "\n"
    original, read = tables.careful_tables, []

    def counting(lines: list[str], *more: Any, **named: Any) -> Any:
        read.append(len(lines))
        return original(lines, *more, **named)

    monkeypatch.setattr(room, "careful_tables", counting)
    (table,) = room.tables_in_text(text)
    assert sum(read) < 200
    np.testing.assert_array_equal(table.columns[1], np.arange(1000) * 0.25)
    noted = np.flatnonzero(~np.isnan(values(table.columns[2], NumeralStyle())))
    assert len(noted) == (9 if cell == "7" else 0)


def test_a_sign_that_changes_in_the_file_is_asked_about_however_long_it_is() -> None:
    rows = [f"{k * 0.1:.2f};{k * 0.25:.2f}" for k in range(4000)]
    rows[3000] = rows[3000].replace(".", ",")
    (table,) = room.tables_in_text("Weg [mm];Kraft [N]\n" + "\n".join(rows) + "\n")
    with pytest.raises(InputError, match=r"decimal sign unclear: both 0\.00 and 300,00 occur"):
        table.found_style("x")


@pytest.mark.parametrize("name", list(TEXTS))
def test_every_dialect_goes_the_quick_way(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise AssertionError("the careful way was taken")

    found = read_machine_bytes(TEXTS[name].write(TEST), "x", Choices(units=dict(TEXTS[name].units)))
    assert len(found.travel) == 400
    original = tables.careful_tables
    monkeypatch.setattr(
        room,
        "careful_tables",
        lambda lines, sign, offset=0, file="", header=(): (
            refuse() if len(lines) > 160 else original(lines, sign, offset)
        ),
    )
    again = read_machine_bytes(TEXTS[name].write(TEST), "x", Choices(units=dict(TEXTS[name].units)))
    np.testing.assert_array_equal(again.force, found.force)
