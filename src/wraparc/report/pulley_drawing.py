"""The pulley with its wrapped arc coloured by shear stress, and the budget of its creep."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from wraparc.arc import ArcResult
from wraparc.glossary import GLOSSARY
from wraparc.plot.profiles import angles, column, outside_spans
from wraparc.present.arc_tables import METHOD_TITLES, belongs
from wraparc.present.sheet import named, percent
from wraparc.report.svg import (
    BLUE,
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
from wraparc.units import System, display, display_unit

# Radii of the drawing: shell, lagging (thicker than it is), belt, and a step outwards per turn.
_SHELL, _LAGGING, _BELT, _TURN = 0.80, 1.0, 1.05, 0.16
_STRAND, _CELLS = 1.45, 120
# From light to dark, ColorBrewer's YlOrRd (Brewer and Harrower).
_SHADES = ("ffffcc", "ffeda0", "fed976", "feb24c", "fd8d3c", "fc4e2a", "e31a1c", "bd0026")

_PULLEY_SIZE = (258.0, 196.0)
_BUDGET_SIZE = (225.0, 196.0)


def pulley_drawing(result: ArcResult, system: System) -> Drawing:
    """Return the pulley of an arc: the belt comes in at the top, the pulley turns clockwise."""
    canvas = Canvas(*_PULLEY_SIZE)
    pulley = _Pulley(canvas, result)
    pulley.body()
    pulley.lagging(system)
    pulley.belt()
    for entry in (True, False):
        pulley.pull(system, entry=entry)
    pulley.scale(system)
    peak = named("peak_shear_stress", result.peak_shear_stress, system)
    where = named("peak_shear_position", result.peak_shear_position, system)
    duty = pulley.duty
    tensions = " to ".join(
        named("tension", t, system) for t in (result.entry_tension, result.exit_tension)
    )
    alt = (
        f"Pulley {result.arc.pulley}, {duty}: belt wrapped over "
        f"{named('wrap_angle', result.arc.wrap_angle, system)}, tension {tensions}. The lagging is "
        f"coloured by shear stress, which peaks at {peak}, {where} from the entry nip."
    )
    caption = f"{belongs(result)[0].upper()}{belongs(result)[1:]}: shear stress of the lagging."
    name = "pulley-" + "".join(f"{ord(c):x}" for c in result.arc.pulley[:12])
    return Drawing(name, canvas.finished(alt), *_PULLEY_SIZE, alt, caption)


class _Pulley:
    """Draws one pulley."""

    def __init__(self, canvas: Canvas, result: ArcResult) -> None:
        self.canvas, self.result = canvas, result
        self.half = 0.5 * result.arc.wrap_angle
        self.unit, self.centre = 58.0, (100.0, 88.0)
        pull = result.arc.effective_tension
        self.duty = "driving" if pull > 0.0 else "braking" if pull < 0.0 else "idling"

    def place(self, theta: float, radius: float) -> Point:
        """Return the place at an angle from the entry nip [rad]; beyond one turn, a spiral."""
        turns = theta / (2.0 * math.pi) if self.half > math.pi else 0.0
        out = self.unit * (radius + _TURN * turns)
        at = self.half - theta
        return self.centre[0] + out * math.cos(at), self.centre[1] - out * math.sin(at)

    def ring(self, start: float, stop: float, cells: int = 60) -> list[Point]:
        """Return the outline of the lagging between two angles [rad]."""
        at = np.linspace(start, stop, cells + 1).tolist()
        inner, outer = ([self.place(t, r) for t in at] for r in (_SHELL, _LAGGING))
        return [*inner, *outer[::-1]]

    def body(self) -> None:
        """Draw shell and unloaded lagging, and how it turns."""
        c, centre = self.canvas, self.centre
        c.circle(centre, self.unit * _LAGGING, "#eeeeee", "#999999", 0.6)
        c.circle(centre, self.unit * _SHELL, "#fafafa", "#777777", 0.8)
        c.circle(centre, 5.0, "white", "#777777", 0.8)
        radius = 0.36 * self.unit
        turn = np.radians(np.linspace(150.0, -50.0, 40)).tolist()
        arc = [(centre[0] + radius * math.cos(t), centre[1] - radius * math.sin(t)) for t in turn]
        c.line(arc[:-3], INK, 0.9)
        c.arrow(arc[-4], arc[-1], 0.9)
        c.text((centre[0], centre[1] + 15.0), self.duty, 8.0, anchor="middle")

    def lagging(self, system: System) -> None:
        """Colour the wrapped lagging, hatch it outside its tested range, mark the peak."""
        stress = np.abs(column(self.result, "shear_stress", system))
        most = max(float(stress.max()), 1e-12)
        edges = np.linspace(0.0, self.result.arc.wrap_angle, _CELLS + 1)
        middle = np.degrees(0.5 * (edges[1:] + edges[:-1]))
        shares = (np.interp(middle, angles(self.result), stress) / most).tolist()
        for start, stop, share in zip(edges[:-1], edges[1:], shares, strict=True):
            colour = _shade(share)
            self.canvas.area(self.ring(float(start), float(stop), 2), colour, edge=colour)
        for start, stop in outside_spans(self.result):
            self.canvas.hatched(self.ring(math.radians(start), math.radians(stop)), RED, 3.0)
        spot = self.place(self.result.peak_shear_position, 0.5 * (_SHELL + _LAGGING))
        self.canvas.circle(spot, 2.4, "white", INK, 0.9)

    def belt(self) -> None:
        """Draw the belt and name the nips."""
        end = self.result.arc.wrap_angle
        sides = []
        for radius in (_LAGGING, _BELT):
            arc = [self.place(t, radius) for t in np.linspace(0.0, end, 181).tolist()]
            far = [self.far(radius, entry=entry) for entry in (True, False)]
            sides.append([far[0], *arc, far[1]])
        self.canvas.area([*sides[0], *sides[1][::-1]], INK)
        for theta, words in ((0.0, "entry nip"), (end, "exit nip")):
            self.canvas.line([self.place(theta, 0.72), self.place(theta, _LAGGING)], INK, 0.7)
            x, y = self.place(theta, 0.60)
            self.canvas.text((x, y + 2.5), words, 7.5, anchor="middle")

    def outwards(self, *, entry: bool) -> Point:
        """Return the direction of a strand away from the pulley, y downwards."""
        at = self.half if entry else -self.half
        travel = (math.sin(at), math.cos(at))
        sign = -1.0 if entry else 1.0
        return sign * travel[0], sign * travel[1]

    def far(self, radius: float, *, entry: bool) -> Point:
        """Return the far end of a strand."""
        x, y = self.place(0.0 if entry else self.result.arc.wrap_angle, radius)
        ux, uy = self.outwards(entry=entry)
        return x + _STRAND * self.unit * ux, y + _STRAND * self.unit * uy

    def pull(self, system: System, *, entry: bool) -> None:
        """Draw the tension of a strand, as long as it is large, and its value."""
        r = self.result
        tension = r.entry_tension if entry else r.exit_tension
        part = tension / max(r.entry_tension, r.exit_tension)
        ux, uy = self.outwards(entry=entry)
        theta = 0.0 if entry else r.arc.wrap_angle
        x, y = self.place(theta, _BELT + 0.12)
        start = (x + 6.0 * ux, y + 6.0 * uy)
        length = 14.0 + 60.0 * part
        self.canvas.arrow(start, (start[0] + length * ux, start[1] + length * uy), 1.3)
        symbol = GLOSSARY["entry_tension" if entry else "exit_tension"].symbol
        words = f"{symbol} = {display(tension, 'force', system, digits=3)}"
        lx, ly = self.place(theta, _BELT + (0.24 if entry else 0.31))
        turn = (math.degrees(math.atan2(uy, ux)) + 90.0) % 180.0 - 90.0
        self.canvas.text(
            (lx + 44.0 * ux, ly + 44.0 * uy), words, 9.0, anchor="middle", turn=turn, bold=True
        )

    def scale(self, system: System) -> None:
        """Draw what the colours mean."""
        unit, size = display_unit("pressure", system)
        most = float(np.max(np.abs(self.result.profile.shear_stress))) / size
        left, top, width = 30.0, 172.0, 198.0
        step = width / 48
        for k in range(48):
            x = left + k * step
            colour = _shade((k + 0.5) / 48)
            box = [(x, top), (x + step, top), (x + step, top + 6.0), (x, top + 6.0)]
            self.canvas.area(box, colour, edge=colour)
        for value in nice_ticks(0.0, max(most, 1e-12), 5):
            place = left + width * value / max(most, 1e-12)
            self.canvas.line([(place, top + 6.0), (place, top + 8.0)], INK, 0.5)
            self.canvas.text((place, top + 15.0), f"{value:.10g}", 7.0, anchor="middle")
        words = f"shear stress [{unit}]; the dot marks its peak"
        self.canvas.text((left + 0.5 * width, top + 23.0), words, 7.5, anchor="middle")


def _shade(share: float) -> str:
    """Return the colour of a share of the largest value, 0 to 1."""
    at = min(max(share, 0.0), 1.0) * (len(_SHADES) - 1)
    low = min(int(at), len(_SHADES) - 2)
    part = at - low
    pair = zip(bytes.fromhex(_SHADES[low]), bytes.fromhex(_SHADES[low + 1]), strict=True)
    return "#" + "".join(f"{round(a + part * (b - a)):02x}" for a, b in pair)


_PARTS = (
    ("creep_shrinkage", "belt shrinkage", BLUE),
    ("creep_compression", "lagging compression", GREEN),
    ("creep_global", "global", ORANGE),
)


def budget_drawing(results: Sequence[ArcResult], system: System) -> Drawing:
    """Return the creep at the exit by source, a bar for each method, beside the limit."""
    canvas = Canvas(*_BUDGET_SIZE)
    first = results[0]
    unit, size = display_unit("length", system)
    limit = first.arc.side * first.arc.creep_limit / size
    ends = [_ends(r, size) for r in results]
    reach = max(abs(e) for pair in ends for e in pair)
    near = abs(limit) < 2.5 * reach
    low = min(0.0, *(e[0] for e in ends), *([limit] if near else []))
    high = max(0.0, *(e[1] for e in ends), *([limit] if near else []))
    span = max(high - low, 1e-9)
    left, width, top, step = 8.0, 206.0, 34.0, 44.0
    bottom = top + step * len(results)

    def x(value: float) -> float:
        return left + width * (value - low) / (1.04 * span)

    canvas.text((left, 12.0), f"Creep at the exit by source [{unit}]", 8.0, bold=True)
    for tick in nice_ticks(low, low + 1.04 * span, 6):
        canvas.line([(x(tick), top - 12.0), (x(tick), bottom)], GRID, 0.5)
        canvas.text((x(tick), bottom + 9.0), f"{tick:.10g}", 7.0, anchor="middle")
    for number, result in enumerate(results):
        y = top + step * number
        canvas.text((left, y - 3.0), METHOD_TITLES.get(result.method, result.method), 7.5)
        _bar(canvas, result, x, y, size)
    canvas.line([(x(0.0), top - 12.0), (x(0.0), bottom)], INK, 0.6)
    if near:
        canvas.line([(x(limit), top - 12.0), (x(limit), bottom)], RED, 1.2, DOTTED)
    _budget_legend(canvas, first, bottom + 24.0, system, near=near)
    alt = "Creep at the exit by source. " + " ".join(_budget_words(r, system) for r in results)
    caption = f"Creep at the exit by source, {belongs(first)}."
    return Drawing("budget", canvas.finished(alt), *_BUDGET_SIZE, alt, caption)


def _ends(result: ArcResult, size: float) -> tuple[float, float]:
    parts = [getattr(result, name) / size for name, _, _ in _PARTS]
    return sum(p for p in parts if p < 0.0), sum(p for p in parts if p > 0.0)


def _bar(
    canvas: Canvas, result: ArcResult, x: Callable[[float], float], y: float, size: float
) -> None:
    above = below = 0.0
    for name, _, colour in _PARTS:
        part = getattr(result, name) / size
        start = above if part >= 0.0 else below
        ends = sorted((x(start), x(start + part)))
        box = [(ends[0], y), (ends[1], y), (ends[1], y + 24.0), (ends[0], y + 24.0)]
        canvas.area(box, colour, edge="white")
        if name != "creep_shrinkage" and ends[1] - ends[0] > 1.0:
            canvas.hatched(box, "#ffffff", 3.0 if name == "creep_compression" else 6.0)
        above, below = (above + part, below) if part >= 0.0 else (above, below + part)


def _budget_legend(
    canvas: Canvas, result: ArcResult, y: float, system: System, *, near: bool
) -> None:
    for name, words, colour in _PARTS:
        box = [(8.0, y - 6.0), (22.0, y - 6.0), (22.0, y + 1.0), (8.0, y + 1.0)]
        canvas.area(box, colour)
        if name != "creep_shrinkage":
            canvas.hatched(box, "#ffffff", 3.0 if name == "creep_compression" else 6.0)
        canvas.text((26.0, y), f"{words}, {_part(result, name, system)}", 7.5)
        y += 10.5
    if near:
        canvas.line([(8.0, y - 2.5), (22.0, y - 2.5)], RED, 1.2, DOTTED)
        limit = named("creep_limit", result.arc.creep_limit, system)
        canvas.text((26.0, y), f"creep limit, {limit}", 7.5)
    else:
        limit = named("creep_limit", result.arc.creep_limit, system)
        canvas.text((8.0, y), f"The creep limit, {limit}, lies off the picture.", 7.5, colour=GREY)


def _part(result: ArcResult, name: str, system: System) -> str:
    value = named(name, getattr(result, name), system)
    if result.exit_creep == 0.0:
        return value
    return f"{value} ({percent(getattr(result, name) / result.exit_creep, 2)})"


def _budget_words(result: ArcResult, system: System) -> str:
    parts = ", ".join(f"{words} {_part(result, name, system)}" for name, words, _ in _PARTS)
    method = METHOD_TITLES.get(result.method, result.method)
    return f"{method[0].upper()}{method[1:]}: {parts}."
