"""Picture of a study over an event: peaks over what is varied, and what each comes to."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from wraparc.checks import Level
from wraparc.errors import InputError
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import GREY, LINES, Picture, styled
from wraparc.study.event_study import EventRow, EventStudy
from wraparc.units import Dimension, System, display_unit
from wraparc.units.numbers import split_number

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Marker by the worst check; what is refused has no point.
_MARKERS = {Level.OK: "o", Level.ATTENTION: "^", Level.FAILS: "X"}


def plot_event_study(study: EventStudy, rows: Sequence[EventRow], system: System = "si") -> Picture:
    """Return largest creep and tension over the axis of numbers with the most values.

    Each combination of everything else is a line of its own; the marker tells the worst check.
    """
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(9.6, 4.2), layout="constrained")
        left, right = figure.subplots(1, 2)
        axis = _axis(study)
        panels: tuple[tuple[Axes, str, str, Dimension], ...] = (
            (left, "peak_creep", f"Maximum {GLOSSARY['exit_creep'].title.lower()}", "length"),
            (right, "peak_tension", "Maximum tension", "force"),
        )
        for ax, name, title, dimension in panels:
            _lines(ax, study, rows, axis, name, system, dimension)
            ax.set_ylabel(f"{title} [{display_unit(dimension, system)[0]}]")
        _explain(right, rows)
        if len(study.fields) > 1 or axis < 0:
            left.legend(loc="best")
        return Picture(figure)


def _axis(study: EventStudy) -> int:
    """Place of the axis of numbers with the most values; -1 if none has numbers."""
    numbers = [i for i, texts in enumerate(study.values) if _numbers(texts)[0]]
    return max(numbers, key=lambda i: len(study.values[i]), default=-1)


def _numbers(texts: Sequence[str]) -> tuple[list[float], str]:
    """Return texts as numbers with the unit they share; nothing if they are something else."""
    try:
        pairs = [split_number(text) for text in texts]
        units = {unit for _, unit in pairs}
        return (
            ([float(number) for number, _ in pairs], units.pop()) if len(units) == 1 else ([], "")
        )
    except (InputError, ValueError):
        return [], ""


def _lines(
    ax: Axes, study: EventStudy, rows: Sequence[EventRow], axis: int, name: str,
    system: System, dimension: Dimension,
) -> None:  # fmt: skip
    size = display_unit(dimension, system)[1]
    texts = study.values[axis] if axis >= 0 else ()
    places, unit = dict(zip(texts, _numbers(texts)[0], strict=True)), _numbers(texts)[1]
    curves: dict[str, list[tuple[float, float, str]]] = {}
    for row in rows:
        others = [
            f"{field.rpartition('.')[2]} {value}"
            for i, (field, value) in enumerate(zip(study.fields, row.values, strict=True))
            if i != axis
        ]
        x = places[row.values[axis]] if axis >= 0 else float(len(curves))
        points = curves.setdefault(", ".join(others), [])
        points.append((x, getattr(row, name) / size, row.level))
    for k, (label, points) in enumerate(curves.items()):
        color, dashes = LINES[k % len(LINES)]
        points.sort()
        ax.plot(*zip(*(p[:2] for p in points), strict=True), dashes, color=color, label=label)
        for x, y, level in points:
            if math.isfinite(y):
                ax.plot(x, y, _MARKERS.get(Level(level), "X"), color=color, markersize=6)
    ax.set_xlabel(f"{study.fields[axis]} [{unit}]" if axis >= 0 and unit else study.event)


def _explain(ax: Axes, rows: Sequence[EventRow]) -> None:
    """Say what the markers mean, and how many designs have none."""
    for level, word in sorted({(row.level, row.label) for row in rows if not row.refused}):
        ax.plot([], [], _MARKERS.get(Level(level), "X"), color=GREY, label=word)
    refused = sum(row.refused for row in rows)
    if refused:
        ax.plot([], [], " ", label=f"{refused} refused: not drawn")
    ax.legend(loc="best")
