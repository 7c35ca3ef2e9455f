"""Workbook and Markdown: the numbers are those of the JSON document; nothing typed is a formula."""

import io
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from python_calamine import CalamineWorkbook

from answer.drives import drive, marched, solved
from render.cases import train
from wraparc import MissingExtraError, solve
from wraparc.answer.document import result_document
from wraparc.glossary import GLOSSARY
from wraparc.render import NoteHead, markdown, pdf, workbook
from wraparc.units import System, in_units, percent, unit_factor

pytestmark = pytest.mark.usefixtures("solved_once")

BOTH = [solved(), marched()]
SHEETS = ("Summary", "Inputs", "Results", "Tables", "Profile", "All profiles", "Sources")


def sheets(data: bytes) -> dict[str, list[list[Any]]]:
    book = CalamineWorkbook.from_filelike(io.BytesIO(data))
    return {name: book.get_sheet_by_name(name).to_python() for name in book.sheet_names}


def in_si(head: str, value: float) -> tuple[str, float]:
    """Title and SI value of a cell under a head like ``Creep at exit [mm]``."""
    title, _, unit = head.partition(" [")
    if not unit:
        return title, value
    entry = next(q for q in GLOSSARY.values() if q.title == title)
    return title, value * unit_factor(unit.removesuffix("]"), entry.dimension)


@pytest.mark.parametrize("system", ["si", "us"])
def test_the_results_are_those_of_the_document(system: System) -> None:
    heads, *rows = sheets(workbook(BOTH, system=system))["Results"]
    document = result_document(BOTH)
    assert len(rows) == len(document["arcs"]) == 2
    compared = 0
    for row, arc in zip(rows, document["arcs"], strict=True):
        assert row[:2] == [arc["load_case"], arc["pulley"]]
        cells = dict(
            in_si(h, v)
            for h, v in zip(heads[4:], row[4:], strict=True)
            if v != "" and not isinstance(v, str)
        )
        for name, entry in GLOSSARY.items():
            value = arc.get(name)
            if isinstance(value, float) and abs(value) < float("inf") and entry.title in cells:
                assert cells[entry.title] == pytest.approx(value, rel=1e-12, abs=1e-15), name
                compared += 1
    assert compared > 40


def test_the_profile_is_that_of_the_document() -> None:
    heads, *rows = sheets(workbook(BOTH))["Profile"]
    profile = result_document(BOTH)["arcs"][0]["profile"]
    for name in ("position", "tension", "friction_used", "creep", "shear_stress"):
        column = next(i for i, h in enumerate(heads) if h.startswith(GLOSSARY[name].title))
        values = [in_si(heads[column], row[column])[1] for row in rows[: len(profile[name])]]
        assert values == pytest.approx(profile[name], rel=1e-12, abs=1e-15)
    everything = sheets(workbook(BOTH))["All profiles"]
    assert len(everything) == 1 + sum(len(arc.profile) for r in BOTH for arc in r)


def test_inputs_are_numbers_with_their_origin() -> None:
    heads, *rows = sheets(workbook(BOTH))["Inputs"]
    inputs = {(row[0], row[1]): dict(zip(heads, row, strict=True)) for row in rows}
    diameter = inputs["Pulley head", "Diameter over lagging"]
    assert (diameter["Value"], diameter["Unit"], diameter["Kind"]) == (800.0, "mm", "input")
    modulus = inputs["Lagging diamond-rubber", GLOSSARY["shear_modulus"].title]
    assert modulus["Kind"] == "published"
    assert "DeVries" in modulus["Source"]
    assert inputs["Lagging diamond-rubber", "Friction law"]["Kind"] == "illustrative"
    assert inputs["Load case full", GLOSSARY["entry_tension"].title]["Value"] == pytest.approx(150)
    assert all(row[5] for row in rows)


def test_the_sheets_are_these_with_frozen_heads_and_native_charts() -> None:
    import zipfile

    data = workbook(BOTH, NoteHead(date="2026-11-21"))
    assert tuple(sheets(data)) == SHEETS
    with zipfile.ZipFile(io.BytesIO(data)) as parts:
        names = parts.namelist()
        assert sum(name.startswith("xl/charts/chart") for name in names) == 4
        for number in range(1, len(SHEETS) + 1):
            assert b'state="frozen"' in parts.read(f"xl/worksheets/sheet{number}.xml")
        chart = parts.read("xl/charts/chart3.xml").decode()
        assert "Creep limit" in chart
        assert "Profile!" in chart
    assert workbook(BOTH, NoteHead(date="2026-11-21")) == data


def test_checks_stand_in_the_summary_as_numbers() -> None:
    rows = sheets(workbook(BOTH))["Summary"]
    heads = next(row for row in rows if row[0] == "Check")
    titles = [row[0] for row in rows]
    creep = dict(zip(heads, rows[titles.index("Creep")], strict=True))
    told = {head: creep[head] for head in heads[1:7]}
    assert told == {
        "Bound": "max", "Limit": pytest.approx(6.35), "Value": pytest.approx(7.4927, rel=1e-4),
        "Unit": "mm", "Used [%]": pytest.approx(118.00, rel=1e-4), "Status": "ATTENTION",
    }  # fmt: skip
    assert "Data line" not in titles  # it compares nothing


def test_nothing_typed_becomes_a_formula_or_a_link() -> None:
    evil = '=HYPERLINK("http://x","y")'
    hostile = replace(drive(), title=evil, belt=replace(drive().belt, name=evil))
    head = NoteHead(project="=1+1", author="+cmd", number="http://example.org")
    data = workbook([solve(hostile, raise_on_failure=False)], head)
    cells = [cell for rows in sheets(data).values() for row in rows for cell in row]
    assert {evil, "=1+1", "+cmd", "http://example.org"} <= {c for c in cells if isinstance(c, str)}
    import zipfile

    with zipfile.ZipFile(io.BytesIO(data)) as parts:
        for name in parts.namelist():
            if name.startswith("xl/worksheets/sheet"):
                assert b"<f>" not in parts.read(name)
                assert b"<hyperlink" not in parts.read(name)


def test_a_train_brings_its_loads_shares_and_motors() -> None:
    whole, results = train("triple-steel-cord")
    there = sheets(workbook(results, train=whole))
    inputs = {(row[0], row[1]): row[3] for row in there["Inputs"][1:]}
    assert inputs["Motor head 1", "Rated power"] == pytest.approx(630.0)
    assert inputs["Case design", "Tension at the last exit"] == pytest.approx(90.0)
    assert not [group for group, _ in inputs if group.startswith("Load case")]
    heads = there["Results"][0]
    shares = [row[heads.index(GLOSSARY["share"].title)] for row in there["Results"][1:10]]
    expected = [m.share for case in whole for m in case.members]
    assert shares == pytest.approx(expected, rel=1e-12)
    told = {(row[0], row[1], row[3]): row[4:6] for row in there["Tables"][1:]}
    for member in whole.cases[0].members:
        value, unit = told["Drives: load case design", "Speed trim", member.name]
        assert (value, unit) == (pytest.approx(100.0 * member.speed_trim, rel=1e-12), "%")
    text = markdown(results, train=whole)
    for case in whole:
        table = text.partition(f"### Drives: load case {case.case.name}\n")[2]
        parts = "".join(f" {in_units(percent(m.share))} |" for m in case.members)
        assert f"| Share of the load | f |{parts}" in table.replace("\\", "")
    assert "induction motor with fluid coupling" in text


def test_markdown_says_what_the_note_says() -> None:
    text = markdown(BOTH, NoteHead(author="A. Smith", date="2026-11-21", file="d.toml"))
    assert text.startswith("# Test drive\n")
    assert "| Creep | 7.49 mm | max 6.35 mm | 118 % | ATTENTION | head, full " in text
    assert "| Name | A. Smith | | |" in text
    assert r"\frac{d \ln T}{d\theta}" in text
    for line in text.splitlines():  # every row of a table as wide as its head
        if line.startswith("| ") and not line.startswith("| |"):
            assert line.endswith(" |")


def test_markdown_takes_nothing_typed_for_markup() -> None:
    evil = "[x](javascript:1) <b> | a *b* `c` $d$"
    hostile = replace(drive(), title=evil, description=evil)
    text = markdown([solve(hostile, raise_on_failure=False)], NoteHead(project=evil))
    assert "<b>" not in text
    assert "[x](" not in text
    assert r"\[x\](javascript:1) \<b\> \| a \*b\* \`c\` \$d\$" in text


@pytest.mark.parametrize(("library", "make"), [("typst", pdf), ("xlsxwriter", workbook)])
def test_a_missing_library_is_named_with_its_extra(
    monkeypatch: pytest.MonkeyPatch, library: str, make: Callable[..., object]
) -> None:
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(MissingExtraError) as caught:
        make([marched()])
    assert str(caught.value) == f"needs {library}: pip install 'wraparc[report]'"


@pytest.mark.parametrize("system", ["si", "us"])
def test_tables_of_the_note_are_numbers_in_the_workbook(system: System) -> None:
    """Expected: the result, in the unit beside each number; 60 kN as given."""
    heads, *rows = sheets(workbook(BOTH, system=system))["Tables"]
    assert heads[4:6] == ["Value", "Unit"]
    told = {(row[0], row[1], row[3]): row[4:6] for row in rows}
    arc = BOTH[0].arcs[0]
    creep, unit = told["Creep by source", "Creep at exit", "distributed"]
    assert creep * unit_factor(unit, "length") == pytest.approx(arc.exit_creep, rel=1e-12)
    slack, unit = told["Tensions", "full", "T2"]
    assert slack * unit_factor(unit, "force") == pytest.approx(60e3, rel=1e-12)
    assert sum(isinstance(value, float) for value, _ in told.values()) > 60
    one = re.compile(r"-?[\d.]+ (mm|kN|kPa|in|lbf|psi|deg)")
    assert [value for value, _ in told.values() if one.fullmatch(str(value))] == []
