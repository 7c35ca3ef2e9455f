"""Drawings: well-formed, told in words, and what they show is where it should be."""

import math
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest

from present.drives import drive, marched, solved, sticking
from wraparc import solve
from wraparc.report.equations import _LAWS, equations
from wraparc.report.profile_drawing import profile_drawing
from wraparc.report.pulley_drawing import _shade, budget_drawing, pulley_drawing
from wraparc.report.svg import Canvas, Drawing, nice_ticks
from wraparc.units import System

SVG = "{http://www.w3.org/2000/svg}"


def texts(drawing: Drawing) -> list[str]:
    return [str(element.text) for element in ET.fromstring(drawing.svg).iter(f"{SVG}text")]  # noqa: S314


@pytest.mark.parametrize("system", ["si", "us"])
def test_drawings_are_sound_and_told(system: System) -> None:
    arcs = [solved().arcs[0], marched().arcs[0]]
    drawings = [pulley_drawing(arcs[0], system), budget_drawing(arcs, system),
                profile_drawing(arcs, system)]  # fmt: skip
    for drawing in drawings:
        root = ET.fromstring(drawing.svg)  # noqa: S314 - our own
        assert root.get("aria-label") == drawing.alt
        assert len(drawing.alt) > 60
        assert "nan" not in drawing.svg
    assert "T1 = 150 kN" in texts(drawings[0]) or system == "us"
    assert any(t.startswith("Creep and slip [") for t in texts(drawings[2]))


def test_the_curve_of_creep_is_that_of_the_result() -> None:
    """Back from points of the drawing to millimetres, by the two ends of the curve."""
    arc = solved().arcs[0]
    root = ET.fromstring(profile_drawing([arc], "si").svg)  # noqa: S314
    blue = [e for e in root.iter(f"{SVG}polyline") if e.get("stroke") == "#0072b2"]
    curves = [e for e in blue if len(str(e.get("points")).split()) > 50]
    points = np.array(
        [list(map(float, p.split(","))) for p in str(curves[2].get("points")).split()]
    )
    x, y = points.T
    at = np.degrees(arc.profile.position)
    theta = (x - x[0]) / (x[-1] - x[0]) * at[-1]
    creep = np.interp(theta, at, arc.profile.creep)
    height = arc.profile.creep[0] + (y - y[0]) / (y[-1] - y[0]) * np.ptp(arc.profile.creep)
    assert height == pytest.approx(creep, abs=0.005 * arc.exit_creep)


def test_the_bars_add_up_to_the_creep() -> None:
    arc = solved().arcs[0]
    root = ET.fromstring(budget_drawing([arc], "si").svg)  # noqa: S314
    colours = ("#0072b2", "#009e73", "#d55e00")
    widths = []
    for colour in colours:
        bar = next(e for e in root.iter(f"{SVG}polygon") if e.get("fill") == colour)
        xs = [float(p.split(",")[0]) for p in str(bar.get("points")).split()]
        widths.append(max(xs) - min(xs))
    parts = [arc.creep_shrinkage, arc.creep_compression, arc.creep_global]
    shares = np.array(parts) / arc.exit_creep
    assert np.array(widths) / sum(widths) == pytest.approx(shares, abs=2e-3)


def test_rest_and_range_left_show() -> None:
    words = texts(profile_drawing(sticking().arcs, "si"))
    assert "outside tested range" in words
    assert "belt at rest" in words
    assert "outside tested range" not in texts(profile_drawing(solved().arcs, "si"))


@pytest.mark.parametrize(
    ("entry", "leaving", "duty"), [(60e3, 150e3, "braking"), (100e3, 100e3, "idling")]
)
def test_braking_and_idling_are_drawn(entry: float, leaving: float, duty: str) -> None:
    arc = solve(drive(entry, leaving), raise_on_failure=False).arcs[0]
    drawings = (
        pulley_drawing(arc, "si"),
        budget_drawing([arc], "si"),
        profile_drawing([arc], "si"),
    )
    assert duty in texts(drawings[0])
    assert all("nan" not in d.svg and "inf" not in d.svg for d in drawings)


def test_a_wrap_beyond_one_turn_is_a_spiral() -> None:
    arc = solve(drive(wrap_angle=math.radians(420.0)), raise_on_failure=False).arcs[0]
    assert "nan" not in pulley_drawing(arc, "si").svg


def test_hostile_names_stay_text() -> None:
    canvas = Canvas(10, 10)
    canvas.text((1, 1), "</text><script>")
    svg = canvas.finished('"><x')
    assert "<script" not in svg
    assert ET.fromstring(svg).get("aria-label") == '"><x'  # noqa: S314


@pytest.mark.parametrize(
    ("low", "high", "ticks"),
    [
        (0.0, 10.0, [0, 2, 4, 6, 8, 10]),
        (-0.3, 0.0, [-0.3, -0.2, -0.1, 0.0]),
        (0.0, 0.7, [0.0, 0.2, 0.4, 0.6]),
    ],
)
def test_ticks_are_round(low: float, high: float, ticks: list[float]) -> None:
    assert nice_ticks(low, high, 5)[: len(ticks)] == pytest.approx(ticks, abs=1e-12)


def test_hatching_stays_inside() -> None:
    canvas = Canvas(20, 20)
    canvas.hatched([(5, 5), (15, 5), (15, 15), (5, 15)], "#000000", 3.0)
    root = ET.fromstring(canvas.finished("x"))  # noqa: S314
    points = [p for e in root for p in str(e.get("points")).split()]
    assert len(points) >= 10
    assert all(5 <= float(c) <= 15 for p in points for c in p.split(","))


def test_shades_run_from_light_to_dark() -> None:
    lightness = [sum(bytes.fromhex(_shade(s)[1:])) for s in np.linspace(0, 1, 20)]
    assert lightness == sorted(lightness, reverse=True)
    assert (_shade(0.0), _shade(1.0)) == ("#ffffcc", "#bd0026")


def test_every_law_has_its_equation() -> None:
    from wraparc.friction import FrictionLaw

    known = {
        cls.__name__
        for cls in FrictionLaw.__subclasses__()
        if cls.__module__.startswith("wraparc.")
    }
    assert set(_LAWS) == known


def test_equations_follow_what_was_used() -> None:
    arcs = solved().arcs
    titles = [e.title for e in equations(arcs, paper=False, train=False, design=False)]
    assert any(t.startswith("Entry overrun") for t in titles)
    given = [replace(arcs[0], arc=replace(arcs[0].arc, overrun=0.0, recovery=False))]
    fewer = [e.title for e in equations(given, paper=False, train=False, design=False)]
    assert not any(t.startswith("Entry overrun") for t in fewer)
    assert any("recovery" in t for t in titles)
    assert not any("recovery" in t for t in fewer)
    for e in equations(arcs, paper=True, train=True, design=True):
        assert e.words
        assert e.latex.count("{") == e.latex.count("}")
