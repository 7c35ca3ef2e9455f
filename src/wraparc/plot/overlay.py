"""Pictures of measured drives: records over the prediction of both methods."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from wraparc.arc import ArcResult
from wraparc.calibrate.calibration import Trace
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, GREY, ORANGE, Picture, styled
from wraparc.units import System, display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LINES = {"distributed": (BLUE, "-"), "paper": (ORANGE, "--")}


def plot_overlay(
    traces: Sequence[Trace], predicted: Mapping[str, Sequence[ArcResult]], units: System = "si"
) -> Picture:
    """Return one panel for each measured course, with the prediction of both methods."""
    with styled():
        from matplotlib.figure import Figure

        rows = max(1, len(traces))
        figure = Figure(figsize=(7.0, 2.8 * rows), layout="constrained")
        axes = figure.subplots(rows, 1, squeeze=False)[:, 0]
        for ax, trace in zip(axes, traces, strict=False):
            _draw(ax, trace, predicted[trace.load_case], units)
        return Picture(figure)


def _draw(ax: "Axes", trace: Trace, results: Sequence[ArcResult], units: System) -> None:
    unit, size = display_unit(GLOSSARY[trace.quantity].dimension, units)
    degrees = np.degrees(trace.position)
    ax.plot(degrees, trace.value / size, ".", color=GREY, markersize=4, label="measured")
    for r in results:
        if not r.status.solved:
            continue
        colour, line = _LINES[r.method]
        course = getattr(r.profile, trace.quantity) / size
        ax.plot(np.degrees(r.profile.position), course, line, color=colour, label=r.method)
    ax.set_xlabel("Position on the arc [deg]")
    ax.set_ylabel(f"{GLOSSARY[trace.quantity].title} [{unit}]")
    ax.set_title(f"Load case {trace.load_case}")
    ax.legend(loc="best")
