"""Pictures of a selection: cost against creep and against slack-side tension."""

from typing import TYPE_CHECKING

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.choose.selection import Selection
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, GREY, ORANGE, Picture, styled
from wraparc.units import System, display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def plot_selection(selection: Selection, units: System = "si") -> Picture:
    """Return cost against creep and against slack-side tension, with the Pareto fronts."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(9.0, 4.0), layout="constrained")
        axes = figure.subplots(1, 2)
        _draw(axes[0], selection, "exit_creep", selection.creep, selection.creep_front, units)
        _draw(axes[1], selection, "tension", selection.slack_tension, selection.slack_front, units)
        axes[1].set_xlabel(f"Slack-side tension T2 [{display_unit('force', units)[0]}]")
        axes[0].legend(loc="best")
        return Picture(figure)


def _draw(
    ax: "Axes",
    selection: Selection,
    name: str,
    values: Array,
    front: Integers,
    units: System,
) -> None:
    unit, size = display_unit(GLOSSARY[name].dimension, units)
    cost, good = selection.costs.total, selection.feasible
    bad = ~good & ~np.isnan(cost)
    ax.plot(values[bad] / size, cost[bad], "x", color=GREY, markersize=4, label="rejected")
    ax.plot(values[good] / size, cost[good], "o", color=BLUE, markersize=5, label="feasible")
    ax.plot(values[front] / size, cost[front], "-", color=ORANGE, label="Pareto front")
    ax.set_xlabel(f"{GLOSSARY[name].title} [{unit}]")
    years, currency = selection.search.costing.years, selection.search.costing.currency
    ax.set_ylabel(f"Cost over {years:g} years [{currency}]")
