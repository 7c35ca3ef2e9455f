"""Drawings of a note: the pictures drawn everywhere, each told in words that hold its numbers."""

import json
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import typst

from answer.drives import drive, marched, solved, sticking
from wraparc import load_drive, solve
from wraparc.render import NoteHead, pdf
from wraparc.render.drawings import (
    Drawing,
    budget_drawing,
    profile_drawing,
    pulley_drawing,
    reserve_drawing,
)
from wraparc.render.note import make_note
from wraparc.units import System

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
SVG = "{http://www.w3.org/2000/svg}"


def texts(drawing: Drawing) -> list[str]:
    root = ET.fromstring(drawing.draw().to_bytes("svg"))  # noqa: S314 - our own
    return ["".join(element.itertext()) for element in root.iter(f"{SVG}text")]


@pytest.mark.parametrize("system", ["si", "us"])
def test_words_of_pictures_can_be_read_and_searched(system: System) -> None:
    arcs = [solved().arcs[0], marched().arcs[0]]
    pulley, budget, profiles = (
        drawing.shown(system) for drawing in (
            pulley_drawing(arcs[0]), budget_drawing(arcs), profile_drawing(arcs)
        )
    )  # fmt: skip
    assert {"driving", "entry nip", "exit nip"} <= set(texts(pulley))
    assert ("T1 = 150 kN" if system == "si" else "T1 = 33700 lbf") in texts(pulley)
    assert {"Creep by source", "distributed", "paper's integration"} <= set(texts(budget))
    assert {"Belt tension", "Friction", "Creep and slip", "Lagging shear"} <= set(texts(profiles))
    assert all(len(d.alt) > 60 and d.caption.endswith(".") for d in (pulley, budget, profiles))


def test_a_report_draws_the_reserve_of_its_verdict() -> None:
    """Expected: the line of the first screen, and a bar for every input of the table."""
    result = solve(load_drive(EXAMPLES / "head-drive-fabric.toml"))
    own = reserve_drawing(result)
    assert own is not None
    told = own.shown("si")
    for named in ("OK at Te -48 %", "FAILS at Te +20 %", "friction -49 %"):
        assert named in told.alt
    assert {"Te", "friction", "T2", "wrap"} <= set(texts(told))
    note = make_note([result], NoteHead())
    (checks,) = (s for s in note.sections if s.title == "Checks against limits")
    assert [drawing.caption for drawing in checks.drawings] == [own.caption]


def test_what_is_told_holds_the_numbers_of_the_result() -> None:
    """Expected: the result itself, 150 and 60 kN, 7.49 mm of creep, as the sheets print them."""
    arc = solved().arcs[0]
    assert "wrapped over 180 deg, tension 150 kN to 60 kN" in pulley_drawing(arc).shown("si").alt
    assert f"to {arc.exit_creep * 1e3:.2f} mm at the exit" in profile_drawing([arc]).shown("si").alt
    assert f"{arc.creep_global * 1e3:.2f} mm (" in budget_drawing([arc]).shown("si").alt


@pytest.mark.parametrize(
    ("entry", "leaving", "duty"), [(60e3, 150e3, "braking"), (100e3, 100e3, "idling")]
)
def test_braking_and_idling_are_drawn(entry: float, leaving: float, duty: str) -> None:
    arc = solve(drive(entry, leaving), raise_on_failure=False).arcs[0]
    assert duty in texts(pulley_drawing(arc).shown("si"))
    assert f"Pulley head, {duty}:" in pulley_drawing(arc).shown("si").alt
    for drawing in (budget_drawing([arc]).shown("si"), profile_drawing([arc]).shown("si")):
        assert "nan" not in drawing.alt
        assert not {"nan", "inf"} & set(texts(drawing))


def test_rest_and_range_left_show() -> None:
    words = texts(profile_drawing(sticking().arcs).shown("si"))
    assert {"outside the tested range", "belt at rest"} <= set(words)
    assert "outside the tested range" not in texts(profile_drawing(solved().arcs).shown("si"))


def test_each_pulley_has_its_own_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    """Names alike in their first letters: the first takes in 150 kN, the second 90 kN."""
    base = drive()
    names = ("drive pulley 1", "drive pulley 2")
    tensions = base.load_cases[0].tensions["head"]
    case = replace(
        base.load_cases[0],
        tensions={
            names[0]: tensions,
            names[1]: replace(tensions, entry=90e3, exit=60e3),
        },
    )
    pulleys = tuple(replace(base.pulleys[0], name=name) for name in names)
    result = solve(replace(base, pulleys=pulleys, load_cases=(case,)), raise_on_failure=False)
    given: dict[str, bytes] = {}

    def compiled(parts: dict[str, bytes], **_: object) -> bytes:
        given.update(parts)
        return b""

    monkeypatch.setattr(typst, "compile", compiled)
    pdf([result])
    sections = json.loads(given["data.json"])["sections"]
    shown: list[dict[str, Any]] = [d for s in sections for d in s["drawings"]]
    shown = [d for d in shown if d["alt"].startswith("Pulley")]
    for name, tension, drawing in zip(names, ("150 kN", "90 kN"), shown, strict=True):
        assert drawing["alt"].startswith(f"Pulley {name}, driving")
        assert f"T1 = {tension}".encode() in given[drawing["file"]]


def test_hostile_names_stay_text() -> None:
    named = '</text><script>"&'
    pulley = replace(solved().arcs[0].arc, pulley=named)
    drawing = pulley_drawing(replace(solved().arcs[0], arc=pulley)).shown("si")
    assert f"Pulley {named}, driving" in drawing.alt
    assert texts(drawing)


def test_a_note_draws_nothing_until_it_is_set_in_type() -> None:
    note = make_note([solved()], NoteHead())
    assert len(note.drawings) == 4  # the reserve first
