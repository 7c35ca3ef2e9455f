"""Profiles along the wrap, drawn for a note: tension, friction, creep and shear."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import ArcResult
from wraparc.glossary import GLOSSARY
from wraparc.plot.profiles import angles, column, most_friction, outside_spans
from wraparc.present.arc_tables import belongs
from wraparc.present.sheet import named
from wraparc.report.svg import (
    BLUE,
    DASHED,
    DOTTED,
    GREEN,
    GREY,
    GRID,
    INK,
    ORANGE,
    RED,
    Canvas,
    Drawing,
    Point,
    nice_ticks,
)
from wraparc.units import System, display_unit

Array = NDArray[np.float64]
_Change = Callable[[float], float]

_WIDTH, _HEIGHT = 493.0, 310.0
_PANEL = (190.0, 108.0)
_MOST_POINTS = 240


@dataclass(frozen=True)
class _Panel:
    """Axes in a drawing.

    Attributes
    ----------
    canvas
        Where it is.
    left, top, width, height
        Of the axes [pt].
    end
        Largest angle [deg].
    low, high
        Ends of the vertical axis.
    """

    canvas: Canvas
    left: float
    top: float
    width: float
    height: float
    end: float
    low: float
    high: float

    def at(self, x: float, y: float) -> Point:
        """Return the place of an angle [deg] and a value."""
        return (
            self.left + self.width * x / self.end,
            self.top + self.height * (self.high - y) / (self.high - self.low),
        )

    def curve(self, x: Array, y: Array, colour: str, width: float = 1.4, dash: str = "") -> None:
        """Draw values over angles [deg]."""
        self.canvas.line((self.at(*pair) for pair in _thinned(x, y)), colour, width, dash)

    def between(self, x: Array, low: Array, high: Array, colour: str) -> None:
        """Fill what lies between two curves."""
        there, back = _thinned(x, low), _thinned(x, high)
        self.canvas.area([self.at(*p) for p in (*there, *back[::-1])], colour, opacity=0.15)

    def frame(self, title: str, unit: str) -> None:
        """Draw grid, numbers and heading."""
        c, bottom = self.canvas, self.top + self.height
        for y in nice_ticks(self.low, self.high, 5):
            row = self.at(0.0, y)[1]
            c.line([(self.left, row), (self.left + self.width, row)], GRID, 0.5)
            c.text((self.left - 3.0, row + 2.4), f"{y:.10g}", 7.0, anchor="end")
        for x in _angle_ticks(self.end):
            place = self.at(x, self.low)[0]
            c.line([(place, self.top), (place, bottom)], GRID, 0.5)
            c.text((place, bottom + 8.5), f"{x:g}", 7.0, anchor="middle")
        c.line([(self.left, self.top), (self.left, bottom), (self.left + self.width, bottom)],
               INK, 0.6)  # fmt: skip
        c.text((self.left - 22.0, self.top - 5.0), f"{title} [{unit}]", 8.0, bold=True)

    def right_axis(self, title: str, to_right: _Change, to_left: _Change) -> None:
        """Number the right side by another quantity."""
        c, edge = self.canvas, self.left + self.width
        for value in nice_ticks(to_right(self.low), to_right(self.high), 5):
            row = self.at(0.0, to_left(value))[1]
            c.line([(edge, row), (edge + 2.0, row)], INK, 0.5)
            c.text((edge + 4.0, row + 2.4), f"{value:.10g}", 7.0)
        c.text((edge + 24.0, self.top - 5.0), title, 7.5, anchor="end", colour=GREY)


def _thinned(x: Array, y: Array) -> list[Point]:
    step = max(1, len(x) // _MOST_POINTS)
    keep = np.unique(np.r_[0 : len(x) : step, len(x) - 1])
    return list(zip(x[keep].tolist(), y[keep].tolist(), strict=True))


def _angle_ticks(end: float) -> list[float]:
    step = next(s for s in (5, 10, 15, 30, 45, 60, 90, 180) if end / s <= 8.0)
    return [float(t) for t in np.arange(0.0, end + 1e-6, step)]


def profile_drawing(results: Sequence[ArcResult], system: System) -> Drawing:
    """Return the four profiles of one arc, by one method or a second one thin over it."""
    canvas = Canvas(_WIDTH, _HEIGHT)
    spots = [(26.0, 16.0), (276.0, 16.0), (26.0, 178.0), (276.0, 178.0)]
    for spot, draw in zip(spots, (_tension, _friction, _creep, _shear), strict=True):
        draw(canvas, spot, results, system)
    first = results[0]
    caption = f"Along the wrap, {belongs(first)}; angles from the entry nip [deg]."
    if len(results) > 1:
        caption += " Thin and black: the paper's march."
    alt = _told(first, system)
    return Drawing("profiles", canvas.finished(alt), _WIDTH, _HEIGHT, alt, caption)


def _told(result: ArcResult, system: System) -> str:
    p = result.profile

    def ends(name: str) -> str:
        column: Array = getattr(p, name)
        first, last = (named(name, float(column[i]), system) for i in (0, -1))
        return f"from {first} at the entry to {last} at the exit"

    return (
        f"Four profiles along the wrap of {belongs(result)}. Belt tension runs {ends('tension')}, "
        f"creep {ends('creep')}, slip {ends('slip')}, friction used {ends('friction_used')}, "
        f"shear stress {ends('shear_stress')}."
    )


def _panel(
    canvas: Canvas, spot: Point, result: ArcResult, low: float, high: float, title: str, unit: str
) -> _Panel:
    """Return axes with their frame, and mark where the belt rests and where the law is unsure."""
    span = max(high - low, 1e-9)
    end = math.degrees(result.arc.wrap_angle)
    high = high + 0.06 * span
    low = low - 0.06 * span if low < 0.0 else low
    panel = _Panel(canvas, *spot, *_PANEL, end, low, high)
    for start, stop in outside_spans(result):
        panel.canvas.hatched(_strip(panel, start, stop), "#e3a9a9")
    if result.stuck_arc > 0.0:
        strip = _strip(panel, 0.0, math.degrees(result.stuck_arc))
        panel.canvas.area(strip, GREY, opacity=0.12)
    panel.frame(title, unit)
    return panel


def _strip(panel: _Panel, start: float, stop: float) -> list[Point]:
    return [
        panel.at(start, panel.low), panel.at(start, panel.high),
        panel.at(stop, panel.high), panel.at(stop, panel.low),
    ]  # fmt: skip


def _legend(panel: _Panel, entries: Sequence[tuple[str, str, str]]) -> None:
    """Say below the axes what each line is: words, colour, dashes."""
    x, y = panel.left, panel.top + panel.height + 20.0
    for words, colour, dash in entries:
        panel.canvas.line([(x, y - 2.5), (x + 16.0, y - 2.5)], colour, 1.4, dash)
        panel.canvas.text((x + 19.0, y), words, 7.5)
        x += 26.0 + 3.5 * len(words)


def _bounds(*columns: Array) -> tuple[float, float]:
    return (
        min(0.0, *(float(c.min()) for c in columns)),
        max(0.0, *(float(c.max()) for c in columns)),
    )


def _tension(canvas: Canvas, spot: Point, results: Sequence[ArcResult], system: System) -> None:
    first = results[0]
    values = [column(r, "tension", system) for r in results]
    force, pressure = (display_unit(GLOSSARY[n].dimension, system) for n in _PAIR)
    panel = _panel(canvas, spot, first, *_bounds(*values), "Belt tension", force[0])
    panel.curve(angles(first), values[0], BLUE)
    for other, tension in zip(results[1:], values[1:], strict=True):
        panel.curve(angles(other), tension, INK, 0.6)
    scale = first.arc.wrap_pressure(force[1]) / pressure[1]
    panel.right_axis(f"wrap pressure [{pressure[0]}]", lambda t: t * scale, lambda p: p / scale)


_PAIR = ("tension", "wrap_pressure")


def _friction(canvas: Canvas, spot: Point, results: Sequence[ArcResult], system: System) -> None:
    first = results[0]
    available, used = (np.abs(column(first, n, system)) for n in ("friction", "friction_used"))
    most = most_friction(first)
    columns = [available, used] + ([] if most is None else [most])
    panel = _panel(canvas, spot, first, *_bounds(*columns), "Friction", "-")
    at = angles(first)
    legend = [("available", BLUE, ""), ("used", ORANGE, DASHED)]
    panel.between(at, used, available, BLUE)
    if most is not None:
        panel.curve(at, most, GREEN, 1.0, "5 2 1 2")
        legend.append(("largest tested", GREEN, "5 2 1 2"))
    panel.curve(at, available, BLUE)
    panel.curve(at, used, ORANGE, dash=DASHED)
    for other in results[1:]:
        panel.curve(angles(other), np.abs(column(other, "friction_used", system)), INK, 0.6)
    _legend(panel, legend)


def _creep(canvas: Canvas, spot: Point, results: Sequence[ArcResult], system: System) -> None:
    first = results[0]
    creep, slip = (column(first, n, system) for n in ("creep", "slip"))
    unit, size = display_unit("length", system)
    limit = math.copysign(first.arc.creep_limit, first.arc.side) / size
    near = abs(limit) < 2.0 * float(np.max(np.abs(creep)))
    columns = [creep, slip, *(column(r, "creep", system) for r in results[1:])]
    bounds = _bounds(*columns, *([np.array([limit])] if near else []))
    panel = _panel(canvas, spot, first, *bounds, "Creep and slip", unit)
    at, end = angles(first), math.degrees(first.arc.wrap_angle)
    panel.between(at, slip, creep, GREY)
    legend = [("creep", BLUE, ""), ("slip", ORANGE, DASHED)]
    if near:
        panel.canvas.line([panel.at(0.0, limit), panel.at(end, limit)], RED, 1.2, DOTTED)
        legend.append(("creep limit", RED, DOTTED))
    panel.curve(at, creep, BLUE)
    panel.curve(at, slip, ORANGE, dash=DASHED)
    for other in results[1:]:
        panel.curve(angles(other), column(other, "creep", system), INK, 0.6)
    _legend(panel, legend)


def _shear(canvas: Canvas, spot: Point, results: Sequence[ArcResult], system: System) -> None:
    first = results[0]
    values = [column(r, "shear_stress", system) for r in results]
    unit, size = display_unit("pressure", system)
    panel = _panel(canvas, spot, first, *_bounds(*values), "Shear stress", unit)
    panel.curve(angles(first), values[0], BLUE)
    for other, stress in zip(results[1:], values[1:], strict=True):
        panel.curve(angles(other), stress, INK, 0.6)
    peak = first.arc.side * first.peak_shear_stress / size
    place = panel.at(math.degrees(first.peak_shear_position), peak)
    panel.canvas.circle(place, 2.4, "white", INK, 0.9)
    modulus = first.arc.shear_modulus / size
    if math.isfinite(modulus):
        panel.right_axis(
            "shear angle [deg]",
            lambda stress: math.degrees(math.atan(stress / modulus)),
            lambda angle: modulus * math.tan(math.radians(angle)),
        )
    _legend_peak(panel, outside=bool(outside_spans(first)), stuck=first.stuck_arc > 0.0)


def _legend_peak(panel: _Panel, *, outside: bool, stuck: bool) -> None:
    x, y = panel.left, panel.top + panel.height + 20.0
    panel.canvas.circle((x + 8.0, y - 2.5), 2.4, "white", INK, 0.9)
    panel.canvas.text((x + 14.0, y), "peak", 7.5)
    x += 40.0
    for words, wanted in (("outside tested range", outside), ("belt at rest", stuck)):
        if wanted:
            box = [(x, y - 7.0), (x + 14.0, y - 7.0), (x + 14.0, y + 1.0), (x, y + 1.0)]
            if words.startswith("outside"):
                panel.canvas.hatched(box, "#c96a6a", 3.0)
            else:
                panel.canvas.area(box, GREY, opacity=0.2)
            panel.canvas.text((x + 17.0, y), words, 7.5)
            x += 90.0
