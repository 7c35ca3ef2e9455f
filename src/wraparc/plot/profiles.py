"""Profiles along the wrap: tension and pressure, friction, creep and slip, shear."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.arc import ArcResult
from wraparc.arrays import Array
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, GREEN, GREY, ORANGE, RED
from wraparc.units import System, display, display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_OTHER_NAME = "paper's integration"
#: How a second method is drawn over the first.
_OTHER: dict[str, Any] = {"color": "black", "linewidth": 1.0}


def draw_profiles(axes: Sequence["Axes"], results: Sequence[ArcResult], system: System) -> None:
    """Draw the four profiles of one arc into four axes, top to bottom.

    Parameters
    ----------
    axes
        Four axes that share their horizontal axis.
    results
        The arc by one method, or by a second one too, which is drawn thin over the first.
    system
        Units of the axes.
    """
    _draw_tension(axes[0], results, system)
    _draw_friction(axes[1], results, system)
    _draw_creep(axes[2], results, system)
    _draw_shear(axes[3], results, system)
    first = results[0]
    end = math.degrees(first.arc.wrap_angle)
    for i, ax in enumerate(axes):
        _mark_zones(ax, first, named=i == 0)
        ax.set_xlim(0.0, end)
        ax.set_xticks(angle_ticks(end))
        spec = ax.get_subplotspec()
        last = spec is None or spec.is_last_row()
        ax.tick_params(labelbottom=last)
        if last:
            ax.set_xlabel("Wrap angle from the entry nip [deg]")
        _name_lines(ax, first=i == 0, beside_title=spec is None or spec.get_gridspec().ncols == 1)


def _name_lines(ax: "Axes", *, first: bool, beside_title: bool) -> None:
    """Put the legend out of the curves' way: on the line of the title, or below the title.

    The second method is named in the first axes alone.
    """
    handles, labels = ax.get_legend_handles_labels()
    named = [k for k, label in enumerate(labels) if first or label != _OTHER_NAME]
    if not named:
        return
    style: dict[str, Any] = {"columnspacing": 1.2, "handletextpad": 0.5, "borderpad": 0.2}
    style |= {"handles": [handles[k] for k in named], "ncols": 5}
    if beside_title:
        ax.legend(loc="lower right", bbox_to_anchor=(1.01, 0.97), **style)
    else:
        ax.set_title(ax.get_title(loc="left"), pad=17.0)
        style |= {"handlelength": 1.9, "columnspacing": 1.0}
        ax.legend(loc="lower left", bbox_to_anchor=(-0.02, 0.97), **style)


def column(result: ArcResult, name: str, system: System) -> Array:
    """Return a column of the profile in the unit of its axis."""
    values: Array = getattr(result.profile, name)
    return values / display_unit(GLOSSARY[name].dimension, system)[1]


def heading(name: str, system: System) -> str:
    """Return the label of an axis: the title of a quantity and its unit."""
    unit, _ = display_unit(GLOSSARY[name].dimension, system)
    return f"{GLOSSARY[name].title} [{unit}]" if unit else GLOSSARY[name].title


def angles(result: ArcResult) -> Array:
    """Return the positions of the profile [deg]."""
    return np.degrees(result.profile.position)


def angle_ticks(end: float) -> list[float]:
    """Return round angles from 0 to `end` [deg], at most nine steps."""
    step = next(s for s in (5, 10, 15, 30, 45, 60, 90, 180) if end / s <= 9.0)
    return [float(t) for t in np.arange(0.0, end + 1e-6, step)]


def _draw_tension(ax: "Axes", results: Sequence[ArcResult], system: System) -> None:
    for i, result in enumerate(results):
        style = _OTHER | {"label": _OTHER_NAME} if i else {"color": BLUE}
        ax.plot(angles(result), column(result, "tension", system), **style)
    ax.set_ylim(bottom=0.0)
    ax.set_ylabel(heading("tension", system))
    ax.set_title("Belt tension")
    arc = results[0].arc
    force, pressure = (display_unit(GLOSSARY[n].dimension, system)[1] for n in _PAIR)
    lift = arc.centrifugal
    scale = arc.wrap_pressure(force + lift) / pressure

    def to_pressure(tension: Any) -> Any:
        return (tension - lift / force) * scale

    def to_tension(pressure: Any) -> Any:
        return pressure / scale + lift / force

    right = ax.secondary_yaxis("right", functions=(to_pressure, to_tension))
    right.set_ylabel(heading("wrap_pressure", system))


_PAIR = ("tension", "wrap_pressure")


def _draw_friction(ax: "Axes", results: Sequence[ArcResult], system: System) -> None:
    for i, result in enumerate(results):
        at = angles(result)
        available, used = (np.abs(column(result, n, system)) for n in ("friction", "friction_used"))
        if i:
            ax.plot(at, used, label=_OTHER_NAME, **_OTHER)
            continue
        most = most_friction(result)
        if most is not None:
            label = "maximum tested"
            ax.plot(at, most, color=GREEN, linewidth=1.2, linestyle=(0, (6, 2, 1, 2)), label=label)
        ax.plot(at, available, color=BLUE, label="available")
        ax.plot(at, used, color=ORANGE, linestyle=(0, (4, 2)), label="used")
        ax.fill_between(at, used, available, color=BLUE, alpha=0.12, linewidth=0.0)
    ax.set_ylim(bottom=0.0)
    ax.set_ylabel("Friction [-]")
    ax.set_title("Friction")


def most_friction(result: ArcResult) -> Array | None:
    """Return the largest friction within the tested slip at the pressure of each point [-].

    None for a law without a tested range.
    """
    tested = result.arc.law.tested
    if tested is None:
        return None
    slips = np.linspace(0.0, tested.slip_max, 61)[1:, np.newaxis]
    most: Array = result.arc.law.friction(slips, result.profile.wrap_pressure).max(axis=0)
    return most


def _draw_creep(ax: "Axes", results: Sequence[ArcResult], system: System) -> None:
    for i, result in enumerate(results):
        at = angles(result)
        creep, slip = (column(result, n, system) for n in ("creep", "slip"))
        if i:
            ax.plot(at, creep, label=_OTHER_NAME, **_OTHER)
            continue
        ax.plot(at, creep, color=BLUE, label="creep")
        ax.plot(at, slip, color=ORANGE, linestyle=(0, (4, 2)), label="slip")
        ax.fill_between(at, slip, creep, color=GREY, alpha=0.25, linewidth=0.0)
        limit = math.copysign(result.arc.creep_limit, result.arc.side)
        limit /= display_unit("length", system)[1]
        if abs(limit) < 2.0 * np.max(np.abs(creep)):
            ax.axhline(limit, color=RED, linewidth=1.0, linestyle=(0, (1, 1.5)), label="limit")
    ax.axhline(0.0, color="#444444", linewidth=0.6)
    unit, _ = display_unit("length", system)
    ax.set_ylabel(f"Displacement [{unit}]")
    ax.set_title("Creep and slip")


def _draw_shear(ax: "Axes", results: Sequence[ArcResult], system: System) -> None:
    for i, result in enumerate(results):
        style = _OTHER | {"label": _OTHER_NAME} if i else {"color": BLUE}
        ax.plot(angles(result), column(result, "shear_stress", system), **style)
    first = results[0]
    at, sign = math.degrees(first.peak_shear_position), first.arc.side
    peak = sign * first.peak_shear_stress / display_unit("pressure", system)[1]
    text = display(first.peak_shear_stress, "pressure", system, digits=3)
    ax.plot([at], [peak], "o", color=ORANGE, markersize=5, label=f"peak {text}")
    ax.axhline(0.0, color="#444444", linewidth=0.6)
    ax.set_ylabel(heading("shear_stress", system))
    ax.set_title("Lagging shear")
    modulus = first.arc.shear_modulus / display_unit("pressure", system)[1]
    if math.isfinite(modulus):

        def to_angle(stress: Any) -> Any:
            return np.degrees(np.arctan(stress / modulus))

        def to_stress(angle: Any) -> Any:
            return modulus * np.tan(np.radians(angle))

        right = ax.secondary_yaxis("right", functions=(to_angle, to_stress))
        right.set_ylabel("Shear angle [deg]")


def outside_spans(result: ArcResult) -> list[tuple[float, float]]:
    """Return the parts of the wrap outside the tested range [deg]."""
    tested, profile = result.arc.law.tested, result.profile
    if tested is None:
        return []
    outside = (
        (profile.wrap_pressure < tested.pressure_min)
        | (profile.wrap_pressure > tested.pressure_max)
        | (np.abs(profile.slip) > tested.slip_max)
    )
    edges = np.flatnonzero(np.diff(np.r_[False, outside, False].astype(int)))
    at = angles(result)
    return [
        (float(at[start]), float(at[min(stop, len(at) - 1)]))
        for start, stop in edges.reshape(-1, 2).tolist()
    ]


def _mark_zones(ax: "Axes", result: ArcResult, *, named: bool) -> None:
    """Hatch where the belt is at rest and where the law is an extrapolation."""
    if result.sticks:
        label = "belt at rest" if named else None
        end = math.degrees(result.stuck_arc)
        ax.axvspan(0.0, end, facecolor="none", edgecolor="#999999", hatch="....", label=label)
    for i, (start, stop) in enumerate(outside_spans(result)):
        label = "outside the tested range" if named and not i else None
        ax.axvspan(start, stop, facecolor="none", edgecolor=RED, alpha=0.5, hatch="//", label=label)
