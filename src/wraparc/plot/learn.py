"""Pictures of a learned drive: speed differences by torque, friction and wear in time."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from wraparc.learn.learn import Learned
from wraparc.learn.windows import DAY
from wraparc.plot.picture import BLUE, GREEN, GREY, ORANGE, RED, Picture, styled
from wraparc.units import System, display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Windows that are drawn at most.
_MOST = 4000


def plot_learned(learned: Learned, units: System = "si") -> Picture:
    """Return, for each pulley, the difference over the zero by torque, and friction in time."""
    with styled():
        from matplotlib.figure import Figure

        count = len(learned.pulleys)
        figure = Figure(figsize=(7.0, 5.6 * count), layout="constrained")
        axes = figure.subplots(2 * count, 1, squeeze=False)[:, 0]
        for k in range(count):
            _draw_levels(axes[2 * k], learned, k)
            _draw_course(axes[2 * k + 1], learned, k, units)
        return Picture(figure)


class LearnedPicture(NamedTuple):
    """One of the two pictures of a pulley: its name, what it shows, and how it is drawn."""

    name: str
    caption: str
    draw: Callable[[], Picture]


def learned_pictures(learned: Learned, units: System = "si") -> Iterator[LearnedPicture]:
    """Yield the pictures of every pulley, each to be drawn by itself."""
    for k, pulley in enumerate(learned.pulleys):
        name = pulley.name
        for kind, caption in (
            (
                "levels",
                f"Speed difference over its zero by torque, {name}: windows, alarm and trip",
            ),
            ("course", f"Friction and radius of {name} over the log, with its wet episodes"),
        ):
            draw = partial(_picture, learned, kind, k, units)
            yield LearnedPicture(f"{kind}, {name}", caption, draw)


def _picture(learned: Learned, name: str, k: int, units: System) -> Picture:
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.0, 3.4), layout="constrained")
        if name == "levels":
            _draw_levels(figure.subplots(), learned, k)
        else:
            _draw_course(figure.subplots(), learned, k, units)
        return Picture(figure)


def _draw_levels(ax: "Axes", learned: Learned, k: int) -> None:
    """Draw windows, those of low friction, first and last curve, alarm and trip."""
    pulley, windows, fit = learned.pulleys[k], learned.windows, learned.fit
    zero = fit.course("zero", windows.time / DAY)[k]
    over = 100.0 * (windows.difference[k] - zero)
    step = max(1, len(over) // _MOST)
    dry = ~learned.episodes.low
    for chosen, colour, label in ((dry, GREY, "windows"), (~dry, BLUE, "low friction")):
        own = np.flatnonzero(chosen)[:: step if chosen is dry else 1]
        ax.plot(100.0 * windows.torque[k][own], over[own], ".", color=colour, markersize=2,
                alpha=0.5, label=label)  # fmt: skip
    line = pulley.line
    end = float(fit.course("zero", np.array([learned.stop - 1e-9]))[k, 0])
    mean = windows.torque.mean(axis=1)
    torque = np.array([line.torque * m / mean[k] for m in mean])
    start = fit.curve(torque, np.full(len(line.torque), learned.since + 1e-9), 0.0)[k]
    ax.plot(100.0 * line.torque, 100.0 * start, "-", color=GREEN, label="first days")
    for values, colour, dashes, label in (
        (line.normal, ORANGE, "--", "last days"),
        (line.alarm, RED, "-.", "alarm"),
        (line.trip, RED, ":", "trip"),
    ):
        ax.plot(100.0 * line.torque, 100.0 * (values - end), dashes, color=colour, label=label)
    top = 130.0 * max(line.alarm.max() - end, 1e-4)
    ax.set_ylim(-0.1 * top, top)
    ax.set_xlabel("Torque [% of rated]")
    ax.set_ylabel("Speed difference over zero [%]")
    ax.set_title(f"Speed difference by torque, {pulley.name}")
    ax.legend(loc="upper left", ncols=2)


def _draw_course(ax: "Axes", learned: Learned, k: int, units: System) -> None:
    """Draw friction since the first days, what the radius lost, episodes and cuts."""
    pulley = learned.pulleys[k]
    if pulley.friction_course is not None:
        value, low, high = pulley.friction_course
        ax.plot(learned.days, value, "-", color=BLUE, label="friction, factor on its law")
        ax.fill_between(learned.days, low, high, color=BLUE, alpha=0.15, linewidth=0.0)
    for n, e in enumerate(learned.episodes.found):
        ax.axvspan(e.start / DAY, e.stop / DAY, color=BLUE, alpha=0.25, linewidth=0.0,
                   label="" if n else "low friction")  # fmt: skip
    for n, cut in enumerate(learned.cuts):
        ax.axvline(cut, color=GREY, linestyle=":", label="" if n else "relagged, or wheel")
    ax.set_xlabel("Day of the log")
    ax.set_ylabel("Friction factor")
    ax.set_title(f"Friction and wear, {pulley.name}")
    unit, size = display_unit("length", units)
    radius = learned.plan.drive.pulley(pulley.name).radius
    worn = (pulley.zero_course[0] - pulley.zero_course[0][0]) * radius / size
    other = ax.twinx()
    other.plot(learned.days, worn, "--", color=ORANGE, label="radius lost, or wheel")
    other.set_ylabel(f"Radius lost [{unit}]")
    other.grid(visible=False)
    lines = [*ax.get_legend_handles_labels()[0], *other.get_legend_handles_labels()[0]]
    ax.legend(lines, [str(line.get_label()) for line in lines], loc="lower left")
