"""The pulley with its wrapped arc, coloured by what happens there."""

import math
from typing import TYPE_CHECKING

import numpy as np

from wraparc.arc import ArcResult
from wraparc.arrays import Array
from wraparc.errors import input_error, shown
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import RED, ramp
from wraparc.plot.profiles import angles, column, heading, outside_spans
from wraparc.units import System, display, display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes


# Radii of the drawing: shell, lagging (drawn thicker than it is), belt; and a step per turn.
_SHELL, _LAGGING, _BELT, _TURN = 0.80, 1.0, 1.05, 0.16
_STRAND = 1.55
_INK = "#222222"


def draw_pulley(
    ax: "Axes", result: ArcResult, system: System, quantity: str = "shear_stress"
) -> None:
    """Draw the pulley of an arc into axes.

    The belt comes in at the top and the pulley turns clockwise; the lagging is coloured by the
    magnitude of a quantity of the profile, dark where it is large. In gross slip there is no
    profile, and it stays without colour.

    Parameters
    ----------
    ax
        Where to draw; a colour bar is put beside it.
    result
        What to draw.
    system
        Units of the colour bar and the labels.
    quantity
        Name of a column of the profile.

    Raises
    ------
    InputError
        If the profile has no such column.
    """
    columns = [name for name, _ in result.profile.columns()]
    if quantity not in columns:
        message = f"the profile has no such column, only {', '.join(columns)}"
        raise input_error(key="quantity", value=shown(quantity), message=message)
    ax.set_aspect("equal")
    ax.axis("off")
    _draw_body(ax)
    if result.status.solved:
        _draw_lagging(ax, result, system, quantity)
    _draw_belt(ax, result)
    for entry in (True, False):
        _draw_tension(ax, result, system, entry=entry)
    if result.status.solved:
        _draw_zones(ax, result)
    _draw_rotation(ax, result)
    ax.margins(0.02)
    ax.autoscale_view()


def _places(result: ArcResult, theta: Array, radius: float) -> Array:
    """Points of the drawing at angles from the entry nip [deg], shape (n, 2)."""
    half = 0.5 * math.degrees(result.arc.wrap_angle)
    at = np.radians(half - theta)
    out = radius + _TURN * _turns(result, theta)
    return np.column_stack([out * np.cos(at), out * np.sin(at)])


def _turns(result: ArcResult, theta: Array) -> Array:
    """How many turns lie under the belt; a wrap beyond one turn is drawn as a spiral."""
    if result.arc.wrap_angle <= 2.0 * math.pi:
        return np.zeros_like(theta)
    return theta / 360.0


def _draw_body(ax: "Axes") -> None:
    from matplotlib.patches import Circle

    ax.add_patch(Circle((0, 0), _LAGGING, facecolor="#eeeeee", edgecolor="#999999", linewidth=0.8))
    ax.add_patch(Circle((0, 0), _SHELL, facecolor="#fafafa", edgecolor="#777777", linewidth=1.0))
    ax.add_patch(Circle((0, 0), 0.10, facecolor="white", edgecolor="#777777", linewidth=1.0))


def _draw_lagging(ax: "Axes", result: ArcResult, system: System, quantity: str) -> None:
    from matplotlib.collections import PolyCollection

    end = math.degrees(result.arc.wrap_angle)
    edges = np.linspace(0.0, end, 181)
    inner, outer = _places(result, edges, _SHELL), _places(result, edges, _LAGGING)
    cells = np.stack([inner[:-1], outer[:-1], outer[1:], inner[1:]], axis=1)
    values = np.abs(column(result, quantity, system))
    middle = np.interp(0.5 * (edges[1:] + edges[:-1]), angles(result), values)
    drawn = PolyCollection(list(cells), array=middle, cmap=ramp(), edgecolors="face")
    most = float(values.max())
    limit = result.arc.creep_limit if quantity == "creep" else 0.0
    scale = limit / display_unit(GLOSSARY[quantity].dimension, system)[1]
    drawn.set_clim(0.0, scale if 0.0 < scale < most else max(most, 1e-12))
    drawn.set_linewidth(0.7)
    ax.add_collection(drawn)
    figure = ax.get_figure()
    if figure is not None:
        bar = figure.colorbar(
            drawn,
            ax=ax,
            orientation="horizontal",
            fraction=0.05,
            pad=0.02,
            aspect=32,
            extend="max" if 0.0 < scale < most else "neither",
        )
        sign = "" if np.all(getattr(result.profile, quantity) >= 0.0) else ", magnitude"
        bar.set_label(f"{heading(quantity, system)}{sign}; the dot marks the peak shear stress")
        bar.outline.set_linewidth(0.5)


def _outside(result: ArcResult) -> float:
    """Radius of the outside of the belt, to scale where its thickness is known."""
    thickness = result.arc.belt_thickness
    return _BELT if thickness is None else _LAGGING + thickness / result.arc.radius


def _draw_belt(ax: "Axes", result: ArcResult) -> None:
    from matplotlib.patches import Polygon

    end = math.degrees(result.arc.wrap_angle)
    sides = []
    for radius in (_LAGGING, _outside(result)):
        arc = _places(result, np.linspace(0.0, end, 361), radius)
        far = (_strand(result, radius, entry=entry)[1] for entry in (True, False))
        first, last = far
        sides.append(np.vstack([first, arc, last]))
    ax.add_patch(Polygon(np.vstack([sides[0], sides[1][::-1]]), facecolor=_INK, linewidth=0.0))
    if result.arc.offset > 0.0 and result.arc.belt_thickness is not None:  # the tension member
        middle = _places(result, np.linspace(0.0, end, 361), _LAGGING + result.arc.offset
                         / result.arc.radius)  # fmt: skip
        ax.plot(middle[:, 0], middle[:, 1], color="white", linewidth=0.7, linestyle="--")
    for theta, text in ((0.0, "entry nip"), (end, "exit nip")):
        x, y = _places(result, np.array([theta, theta]), 1.0)[0]
        line = np.array([0.72, _LAGGING])
        ax.plot(line * x, line * y, color=_INK, linewidth=0.8)
        ax.text(0.62 * x, 0.62 * y, text, ha="center", va="center", fontsize=8)


def _strand(result: ArcResult, radius: float, *, entry: bool) -> Array:
    """Straight belt from a nip outwards, shape (2, 2)."""
    theta = 0.0 if entry else math.degrees(result.arc.wrap_angle)
    nip = _places(result, np.array([theta]), radius)[0]
    out = _outwards(result, entry=entry)
    return np.vstack([nip, nip + _STRAND * out])


def _outwards(result: ArcResult, *, entry: bool) -> Array:
    """Unit vector along a strand away from the pulley."""
    half = 0.5 * result.arc.wrap_angle
    at = half if entry else -half
    travel = np.array([math.sin(at), -math.cos(at)])
    return -travel if entry else travel


def _draw_tension(ax: "Axes", result: ArcResult, system: System, *, entry: bool) -> None:
    """Draw the pull on a strand, its arrow as long as the tension is large."""
    tension = result.entry_tension if entry else result.exit_tension
    largest = max(result.entry_tension, result.exit_tension)
    nip, far = _strand(result, _BELT, entry=entry)
    out = _outwards(result, entry=entry)
    aside = np.array([out[1], -out[0]]) * (1.0 if entry else -1.0)
    if np.dot(aside, nip) < 0.0:
        aside = -aside
    start = nip + 0.12 * out + 0.10 * aside
    tip = start + (0.25 + 0.95 * tension / largest) * out
    _arrow(ax, start, tip, 1.6)
    symbol = GLOSSARY["entry_tension" if entry else "exit_tension"].symbol
    text = f"{symbol} = {display(tension, 'force', system, digits=3)}"
    turn = (math.degrees(math.atan2(out[1], out[0])) + 90.0) % 180.0 - 90.0
    x, y = start + 0.55 * out
    # in points from the arrow, so that the words stay clear of it in a small picture
    ax.annotate(
        text, (float(x), float(y)), (10.0 * float(aside[0]), 10.0 * float(aside[1])),
        textcoords="offset points", ha="center", va="center", rotation=turn,
        rotation_mode="anchor", fontsize=10, weight="bold",
    )  # fmt: skip
    # a mark on the inner side of the strand tells which way the belt runs
    way = -out if entry else out
    middle = 0.5 * (nip + far) - 0.12 * aside
    _arrow(ax, middle - 0.09 * way, middle + 0.09 * way, 1.0)
    ax.update_datalim([start + 0.24 * aside, tip])


def _arrow(ax: "Axes", start: Array, tip: Array, width: float) -> None:
    head = "-|>,head_width=0.28,head_length=0.55"
    ax.annotate(
        "",
        xy=(float(tip[0]), float(tip[1])),
        xytext=(float(start[0]), float(start[1])),
        arrowprops={"arrowstyle": head, "color": _INK, "lw": width, "shrinkA": 0, "shrinkB": 0},
    )


def _draw_zones(ax: "Axes", result: ArcResult) -> None:
    from matplotlib.patches import Polygon

    zones = [(start, stop, "//", RED) for start, stop in outside_spans(result)]
    if result.sticks:
        zones.append((0.0, math.degrees(result.stuck_arc), "....", "#777777"))
    for start, stop, hatch, colour in zones:
        theta = np.linspace(start, stop, 90)
        ring = np.vstack([_places(result, theta, _SHELL), _places(result, theta, _LAGGING)[::-1]])
        ax.add_patch(Polygon(ring, facecolor="none", edgecolor=colour, hatch=hatch, linewidth=0.4))
    at = np.array([math.degrees(result.peak_shear_position)])
    x, y = _places(result, at, 0.5 * (_SHELL + _LAGGING))[0]
    ax.plot(x, y, "o", color="white", markeredgecolor=_INK, markersize=5.5)


def _draw_rotation(ax: "Axes", result: ArcResult) -> None:
    from matplotlib.patches import Arc

    radius = 0.34
    ax.add_patch(Arc((0, 0), 2 * radius, 2 * radius, theta1=-60, theta2=150, color=_INK, lw=1.2))
    end = math.radians(-60.0)
    tip = radius * np.array([math.cos(end), math.sin(end)])
    way = np.array([math.sin(end), -math.cos(end)])
    _arrow(ax, tip - 0.01 * way, tip + 0.09 * way, 1.2)
    ax.text(0.06, -0.22, result.arc.duty, ha="right", va="center", fontsize=8.5)
