"""The picture of a belt across its width: a map over arc and width, lagging and tension beside."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.across import AcrossResult, AcrossStatus, slack_words
from wraparc.arrays import Array
from wraparc.errors import input_error, nearest, shown
from wraparc.friction.interpolation import evaluate, pchip
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, GREY, ORANGE, RED, Picture, ramp, styled
from wraparc.units import System, display_unit, in_units

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: What a map may show, by the names of `wraparc.across.Fields`.
QUANTITIES = ("shear_stress", "creep", "slip", "wrap_pressure", "tension", "frictional_energy")
_LEVELS = 16


def plot_across(
    result: AcrossResult, system: System = "si", *, quantity: str = "shear_stress"
) -> Picture:
    """Return the map of a quantity over wrap angle and width.

    Beside it stand the radius and the thickness of the lagging over the width, and the tension at
    entry and exit.

    Parameters
    ----------
    result
        The solved arc.
    system
        Units to show.
    quantity
        ``shear_stress``, ``creep``, ``slip``, ``wrap_pressure``, ``tension`` or
        ``frictional_energy``.

    Raises
    ------
    InputError
        If there is no such quantity.
    """
    if quantity not in QUANTITIES:
        raise input_error(
            value=shown(quantity),
            message=f"no such quantity; a map shows {', '.join(QUANTITIES)}",
            remedy=nearest(quantity, QUANTITIES),
        )
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(11.0, 5.6))
        grid = figure.add_gridspec(
            2, 3, width_ratios=(2.4, 1.0, 1.0), height_ratios=(1.0, 0.05), wspace=0.16,
            hspace=0.36, left=0.075, right=0.975, top=0.82, bottom=0.12,
        )  # fmt: skip
        axes = [figure.add_subplot(grid[0, 0])]
        axes += [figure.add_subplot(grid[0, i], sharey=axes[0]) for i in (1, 2)]
        filled = _draw_map(axes[0], result, system, quantity)
        bar = figure.colorbar(filled, cax=figure.add_subplot(grid[1, 0]), orientation="horizontal")
        name = "width_tension" if quantity == "tension" else quantity
        bar.set_label(GLOSSARY[name].heading(system))
        _draw_lagging(axes[1], result, system)
        _draw_tension(axes[2], result, system)
        arc = result.wide.arc
        title = f"Across the width: pulley {arc.pulley}, load case {arc.load_case}"
        figure.text(0.02, 0.945, title, fontsize=13, weight="bold")
        words = in_units(slack_words(result), system)
        if result.status is AcrossStatus.SOLVED:
            words = (
                f"Entry tension at most {result.entry_unevenness:.3g} of its mean, wear "
                f"{result.energy_unevenness:.3g} of its mean; {result.wide.strips} strips"
            )
        figure.text(0.02, 0.9, words or str(result.status), fontsize=10)
        return Picture(figure)


def _across(result: AcrossResult, system: System) -> tuple[Array, str]:
    unit, size = display_unit("length", system)
    return result.position / size, unit


def _draw_map(ax: Axes, result: AcrossResult, system: System, name: str) -> Any:
    key = "width_tension" if name == "tension" else name
    _, size = display_unit(GLOSSARY[key].dimension, system)
    y, length = _across(result, system)
    edge = 0.5 * result.wide.arc.width * y[-1] / result.position[-1]
    values = getattr(result.fields, name) / size
    angle = np.degrees(result.angle)
    even = np.linspace(0.0, angle[-1], 181)
    smooth = np.array([evaluate(angle, pchip(angle, column), even) for column in values.T])
    # the outermost strips reach to the edges
    rows = np.concatenate([[-edge], y, [edge]])
    smooth = np.vstack([smooth[:1], smooth, smooth[-1:]])
    filled: Any = ax.contourf(even, rows, smooth, levels=_LEVELS, cmap=ramp())
    lines = ax.contour(even, rows, smooth, levels=filled.levels[::2], colors="white",
                       linewidths=0.5)  # fmt: skip
    ax.clabel(lines, fontsize=7, fmt="%g")
    ax.grid(visible=False)
    ax.set_title("Over the wrap, entry at the left")
    ax.set_xlabel("Wrap angle from the entry nip [deg]")
    ax.set_ylabel(f"Across the belt [{length}]")
    ax.set_xticks(np.arange(0.0, angle[-1] + 1.0, 30.0 if angle[-1] <= 240.0 else 60.0))
    return filled


def _draw_lagging(ax: Axes, result: AcrossResult, system: System) -> None:
    unit, size = display_unit("length", system)
    y, _ = _across(result, system)
    wide = result.wide
    radius = (wide.radius_deviation - np.max(wide.radius_deviation)) / size
    worn = (wide.arc.thickness - wide.thickness) / size
    ax.plot(radius, y, color=BLUE, label="radius, less its maximum")
    if np.any(worn != 0.0):
        ax.plot(-worn, y, color=ORANGE, linestyle="--", label="worn off the lagging")
    ax.set_title("Pulley")
    ax.set_xlabel(f"Deviation [{unit}]")
    ax.tick_params(labelleft=False)
    if not np.any(radius) and not np.any(worn):
        ax.set_xlim(-1.0, 1.0)
    ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14))


def _draw_tension(ax: Axes, result: AcrossResult, system: System) -> None:
    unit, size = display_unit("force_per_width", system)
    y, _ = _across(result, system)
    ax.plot(result.entry_tension / size, y, color=BLUE, label="entry")
    ax.plot(result.exit_tension / size, y, color=ORANGE, linestyle="--", label="exit")
    if result.wide.static_profile is not None:
        ax.plot(result.static_tension / size, y, color=GREY, linestyle=":", label="standstill")
    ax.axvline(0.0, color=RED, linewidth=0.8)
    ax.set_xlim(left=min(0.0, 1.05 * float(np.min(result.fields.tension)) / size))
    ax.set_title("Tension per width")
    ax.set_xlabel(f"Tension [{unit}]")
    ax.tick_params(labelleft=False)
    ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncol=2, columnspacing=1.0)
