"""Pictures of a study: probabilities, percentiles, convergence, tornado and Sobol indices."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.checks.rules import RULES
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, GREY, LINES, ORANGE, RED, Picture, styled
from wraparc.study.fields import label_of, names_of
from wraparc.study.monte_carlo import Group, Summary
from wraparc.study.sensitivity import Global, Indices, Local, Swing
from wraparc.study.share import CONFIDENCE
from wraparc.units import Dimension, System, display, display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MOST_LINES = 8


def study_pictures(
    summary: Summary,
    local: Local | None,
    indices: Global | None,
    units: Mapping[str, Dimension | None],
    system: System = "si",
    *,
    spread: bool = True,
) -> dict[str, Picture]:
    """Return what a study says, or the sensitivity of its results, by name."""
    if local is None or indices is None:
        return {"results": plot_study(summary, units, system, spread=spread)}
    return {
        f"{name}-{number}" if len(indices) > 1 else name: plot_sensitivity(
            name, local[case][name], found, units, system
        )
        for number, (case, of_case) in enumerate(indices.items(), start=1)
        for name, found in of_case.items()
    }


def plot_study(
    summary: Summary,
    units: Mapping[str, Dimension | None],
    system: System = "si",
    *,
    spread: bool = True,
) -> Picture:
    """Return what a study says.

    Of draws how their creep is spread (`spread`), probabilities over the levels, and how they
    settle; of a grid values over the levels.
    """
    shown = [spread, bool(_axis_of(summary)), True] if summary.drawn else [True, True]
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(4.8 * sum(shown), 4.2), layout="constrained")
        axes = list(figure.subplots(1, sum(shown), squeeze=False)[0])
        if summary.drawn:
            for draw, wanted in zip((_spread, _chances, _settling), shown, strict=True):
                if wanted:
                    draw(axes.pop(0), summary, units, system)
        else:
            left, right = axes
            _over_levels(left, summary, "exit_creep", units, system)
            _over_levels(right, summary, "least_exit_tension", units, system)
        return Picture(figure)


def _axis_of(summary: Summary) -> str:
    """Axis of levels to draw over: the one of numbers with the most values."""
    levels: Mapping[str, Sequence[Any]] = summary.data["levels"]
    numbers = [n for n, v in levels.items() if not isinstance(v[0], str | bool)]
    return max(numbers, key=lambda name: len(levels[name]), default="")


def _curves(summary: Summary, axis: str) -> dict[str, list[Group]]:
    """Groups along an axis, a curve for each combination of everything else."""
    curves: dict[str, list[Group]] = {}
    for group in summary.groups:
        others = [str(v) for name, v in group.levels.items() if name != axis]
        name = ", ".join(part for part in (*others, group.load_case, group.condition) if part)
        curves.setdefault(name, []).append(group)
    return dict(list(curves.items())[:_MOST_LINES])


def _spread(
    ax: Axes, summary: Summary, units: Mapping[str, Dimension | None], system: System
) -> None:
    """How the creep of the group is spread that keeps its limit least often."""
    drawn = [g for g in summary.groups if "exit_creep" in g.histograms]
    if not drawn:
        return
    group = max(drawn, key=lambda g: g.over_limit.value)
    found, name = group.histograms["exit_creep"], "exit_creep"
    _, scale = display_unit(GLOSSARY[name].dimension, system)
    edges = np.array(found.edges) / scale
    limit = found.limit.least / scale
    for low, high, count in zip(edges, edges[1:], found.counts, strict=False):
        beyond = abs(low + high) / 2.0 > limit
        face, edge, hatch = ("#f3d5d8", RED, "////") if beyond else ("#9cc9e3", BLUE, None)
        ax.bar(
            low, count, high - low, align="edge", facecolor=face, edgecolor=edge, hatch=hatch,
            linewidth=0.6,
        )  # fmt: skip
    if not math.isnan(limit):
        told = f"{RULES['creep'].what} {display(found.limit.least, 'length', system)}"
        ax.axvline(limit, color=RED, linestyle=(0, (5, 2)), label=told)
        if len(edges) and edges[0] < 0.0:
            ax.axvline(-limit, color=RED, linestyle=(0, (5, 2)))
    ax.set_title(f"{found.total:,} draws: {_place(group, units, system)}")
    ax.set_xlabel(GLOSSARY[name].heading(system))
    ax.set_ylabel("Draws")
    lost = found.away + found.unanswered
    if lost:
        ax.plot([], [], " ", label=f"{lost:,} without a creep")
    if ax.get_legend_handles_labels()[1]:
        ax.legend(loc="best")


def _chances(
    ax: Axes, summary: Summary, units: Mapping[str, Dimension | None], system: System
) -> None:
    axis = _axis_of(summary)
    unit, size = display_unit(units.get(axis) or "number", system)
    for (name, groups), (color, dashes) in zip(
        _curves(summary, axis).items(), _cycle(), strict=False
    ):
        x = [float(g.levels[axis]) / size for g in groups]
        p = np.array([100.0 * g.over_limit.value for g in groups])
        ends = 100.0 * np.array([g.over_limit.interval for g in groups])
        spread = np.abs(ends.T - p)
        ax.errorbar(
            x, p, yerr=spread, color=color, linestyle=dashes, marker="o", markersize=4,
            capsize=2, label=name,
        )  # fmt: skip
    ax.set_xlabel(f"{names_of(summary.data)(axis).capitalize()} [{unit}]")
    ax.set_ylabel("Creep over its limit [% of draws]")
    ax.set_title(f"Probability, {CONFIDENCE:.0%} interval")
    ax.set_ylim(bottom=0.0)
    if summary.groups:
        ax.legend(loc="best")


def _settling(
    ax: Axes, summary: Summary, units: Mapping[str, Dimension | None], system: System
) -> None:
    """The estimate over the draws, for the groups that are least certain."""
    groups = sorted(
        summary.groups, key=lambda g: g.over_limit.interval[0] - g.over_limit.interval[1]
    )
    for group, (color, dashes) in zip(groups[:3], _cycle(), strict=False):
        n = [step.draws for step in group.steps]
        p = [100.0 * step.over_limit.value for step in group.steps]
        ends = 100.0 * np.array([step.over_limit.interval for step in group.steps]).reshape(-1, 2)
        name = _place(group, units, system)
        ax.plot(n, p, color=color, linestyle=dashes, marker="o", markersize=4, label=name)
        ax.fill_between(n, ends[:, 0], ends[:, 1], color=color, alpha=0.15, linewidth=0.0)
    ax.set_xscale("log", base=2)
    ax.set_xlabel("Draws")
    ax.set_ylabel("Creep over its limit [% of draws]")
    ax.set_title("Convergence where it is most uncertain")
    if groups:
        ax.legend(loc="best")


def _place(group: Group, units: Mapping[str, Dimension | None], system: System) -> str:
    """Levels, load case and condition of a group."""
    parts = [_shown(name, v, units, system) for name, v in group.levels.items()]
    return ", ".join(part for part in (*parts, group.load_case, group.condition) if part)


def _shown(field: str, value: Any, units: Mapping[str, Dimension | None], system: System) -> str:
    dimension = units.get(field)
    return str(value) if dimension is None else display(value, dimension, system)


def _over_levels(
    ax: Axes,
    summary: Summary,
    result: str,
    units: Mapping[str, Dimension | None],
    system: System,
) -> None:
    axis = _axis_of(summary)
    unit, size = display_unit(units.get(axis) or "number", system)
    of, scale = display_unit(GLOSSARY[result].dimension, system)
    for (name, groups), (color, dashes) in zip(
        _curves(summary, axis).items(), _cycle(), strict=False
    ):
        x = [float(g.levels[axis]) / size if axis else 0.0 for g in groups]
        y = [g.percentiles.get(result, (math.nan,) * 4)[1] / scale for g in groups]
        ax.plot(x, y, color=color, linestyle=dashes, marker="o", markersize=4, label=name)
    ax.set_xlabel(f"{names_of(summary.data)(axis).capitalize()} [{unit}]" if axis else "")
    ax.set_ylabel(f"{GLOSSARY[result].title} [{of}]")
    if summary.groups:
        ax.legend(loc="best")


def _cycle() -> list[tuple[str, str]]:
    return [LINES[k % len(LINES)] for k in range(_MOST_LINES)]


def plot_sensitivity(
    result: str,
    swings: Sequence[Swing],
    indices: Indices | None,
    units: Mapping[str, Dimension | None],
    system: System = "si",
) -> Picture:
    """Return the tornado of a result, and its Sobol indices beside it."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(9.6, 1.6 + 0.42 * max(len(swings), 3)), layout="constrained")
        left, right = figure.subplots(1, 2)
        _tornado(left, result, swings, system)
        _bars(right, indices)
        return Picture(figure)


def _tornado(ax: Axes, result: str, swings: Sequence[Swing], system: System) -> None:
    unit, scale = display_unit(GLOSSARY[result].dimension, system)
    names = [label_of(s.field) for s in swings][::-1]
    for place, swing in enumerate(swings[::-1]):
        for end, color in ((swing.at_low, BLUE), (swing.at_high, ORANGE)):
            width = (end - swing.base) / scale
            ax.barh(place, width, left=swing.base / scale, color=color, height=0.6)
    ax.set_yticks(range(len(names)), names)
    if swings:
        ax.axvline(swings[0].base / scale, color=GREY, linewidth=1.0)
    ax.plot([], [], color=BLUE, linewidth=6, label="input at its 5 %")
    ax.plot([], [], color=ORANGE, linewidth=6, label="input at its 95 %")
    ax.legend(loc="lower right")
    ax.set_xlabel(f"{GLOSSARY[result].title}{f' [{unit}]' if unit else ''}")
    ax.set_title("Each input alone")


def _bars(ax: Axes, indices: Indices | None) -> None:
    inputs = indices.inputs[::-1] if indices else ()
    for place, one in enumerate(inputs):
        for value, ends, color, shift in (
            (one.first, one.first_interval, BLUE, 0.2),
            (one.total, one.total_interval, ORANGE, -0.2),
        ):
            ax.barh(place + shift, value, color=color, height=0.36)
            ax.plot(ends, [place + shift] * 2, color=GREY, linewidth=1.2)
    ax.set_yticks(range(len(inputs)), [label_of(one.name) for one in inputs])
    ax.plot([], [], color=BLUE, linewidth=6, label="alone")
    ax.plot([], [], color=ORANGE, linewidth=6, label="with others")
    ax.legend(loc="best")
    ax.set_xlabel("Part of the variance [-]")
    ax.set_title("All together (Sobol indices)")
