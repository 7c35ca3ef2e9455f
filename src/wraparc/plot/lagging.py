"""The picture of a lagging: friction over slip, traction and coefficients over pressure."""

import textwrap
from itertools import cycle
from typing import TYPE_CHECKING

import numpy as np

from wraparc.arrays import Array
from wraparc.drive import Lagging
from wraparc.friction import FrictionLaw, IntegralLog
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, ORANGE, RED, Picture, ramp, styled
from wraparc.provenance import Kind
from wraparc.units import System, display, display_unit
from wraparc.version import __version__

if TYPE_CHECKING:
    from matplotlib.axes import Axes


#: Dashes of curves that are alike but for one number.
DASHES = ((), (6, 2), (1.5, 1.5), (6, 2, 1.5, 2), (3, 1.5), (8, 2, 2, 2, 2, 2))
_CURVES = 6
#: What is drawn of a law that states no tested range: pressures [Pa] and slip [m].
_UNTESTED = (50e3, 700e3, 15e-3)


def plot_lagging(lagging: Lagging, system: System = "si") -> Picture:
    """Return the picture of a lagging in one condition.

    Friction over slip at several pressures and traction over pressure at several slips; of an
    integral-log law also A and b, slip and friction at the peak over pressure.

    Parameters
    ----------
    lagging
        The lagging.
    system
        Units of the axes.
    """
    law = lagging.law
    rows = 2 if isinstance(law, IntegralLog) else 1
    with styled():
        from matplotlib.figure import Figure

        size = 3.8 * rows + 1.5
        figure = Figure(figsize=(11.0, size))
        grid = figure.add_gridspec(
            rows, 2, left=0.07, right=0.925, top=1.0 - 1.3 / size, bottom=0.95 / size,
            hspace=0.36, wspace=0.42,
        )  # fmt: skip
        _draw_curves(figure.add_subplot(grid[0, 0]), law, system)
        _draw_traction(figure.add_subplot(grid[0, 1]), law, system)
        if isinstance(law, IntegralLog):
            _draw_peak(figure.add_subplot(grid[1, 0]), law, system)
            _draw_coefficients(figure.add_subplot(grid[1, 1]), law, system)
        name = lagging.title or lagging.name
        top = f"{name}, {lagging.condition}"
        figure.text(0.02, 1.0 - 0.33 / size, top, fontsize=13, weight="bold", va="center")
        figure.text(0.02, 0.1 / size, _foot(lagging), fontsize=7.5, color="#444444", va="bottom")
        return Picture(figure)


def _range(law: FrictionLaw) -> tuple[float, float, float]:
    """Lowest and highest pressure [Pa] and largest slip [m] to draw."""
    if law.tested is None:
        return _UNTESTED
    return law.tested.pressure_min, law.tested.pressure_max, law.tested.slip_max


def _pressures(law: FrictionLaw) -> Array:
    low, high, _ = _range(law)
    if isinstance(law, IntegralLog) and len(law.coefficients.pressure) > 3:
        knots = law.coefficients.pressure
        places = np.unique(np.linspace(0, len(knots) - 1, _CURVES).round().astype(int))
        return np.array([knots[place] for place in places])  # the ends among them
    return np.geomspace(low, high, _CURVES)


def _scaled(name: str, system: System) -> tuple[float, str]:
    """SI value of the unit of an axis, and the label of the axis."""
    unit, size = display_unit(GLOSSARY[name].dimension, system)
    return size, f"{GLOSSARY[name].title} [{unit}]" if unit else f"{GLOSSARY[name].title} [-]"


def shades(count: int) -> Array:
    """Return colours from light to dark, apart in print too, shape (count, 4)."""
    shades: Array = np.asarray(ramp()(np.linspace(0.25, 1.0, count)), float)
    return shades


def _draw_curves(ax: "Axes", law: FrictionLaw, system: System) -> None:
    _, _, tested_slip = _range(law)
    size, label = _scaled("slip", system)
    slip = np.linspace(0.0, 1.15 * tested_slip, 300)[1:]
    pressures = _pressures(law)
    for pressure, shade, dash in zip(
        pressures, shades(len(pressures)), cycle(DASHES), strict=False
    ):
        text = display(float(pressure), "pressure", system, digits=3)
        style = {"color": shade, "dashes": dash} if dash else {"color": shade}
        mu = law.friction(slip, float(pressure))
        ax.plot(np.r_[0.0, slip] / size, np.r_[0.0, mu], label=text, **style)
    if law.tested is not None:
        _mark_untested(ax, tested_slip / size, slip[-1] / size, vertical=True)
    ax.set_xlim(0.0, slip[-1] / size)
    ax.set_ylim(bottom=0.0)
    ax.set_xlabel(label)
    ax.set_ylabel("Friction mu [-]")
    _name(ax, "Friction over slip, at wrap pressures")


def _name(ax: "Axes", title: str) -> None:
    """Put title and legend above the axes, out of the way of the curves."""
    ax.set_title(title, pad=36)
    ax.legend(loc="lower left", bbox_to_anchor=(-0.02, 0.985), ncols=3)


def _mark_untested(ax: "Axes", start: float, end: float, *, vertical: bool) -> None:
    ax.axvspan(start, end, facecolor="none", edgecolor=RED, hatch="//", alpha=0.35, linewidth=0.0)
    if vertical:
        place = (0.5 * (start + end), 0.03)
        ax.text(
            *place, "not tested", transform=ax.get_xaxis_transform(), rotation=90, ha="center",
            va="bottom", fontsize=8, color=RED,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
        )  # fmt: skip


def _over_pressure(law: FrictionLaw) -> Array:
    """Pressures from below to above the tested ones."""
    low, high, _ = _range(law)
    ends = (0.6 * low, 1.12 * high) if law.tested is not None else (low, high)
    return np.linspace(*ends, 400)


def _pressure_axis(ax: "Axes", law: FrictionLaw, system: System) -> None:
    size, label = _scaled("wrap_pressure", system)
    ax.set_xlabel(label)
    drawn = _over_pressure(law) / size
    ax.set_xlim(0.0, drawn[-1])
    if law.tested is not None:
        _mark_untested(ax, 0.0, law.tested.pressure_min / size, vertical=False)
        _mark_untested(ax, law.tested.pressure_max / size, float(drawn[-1]), vertical=True)


def _draw_traction(ax: "Axes", law: FrictionLaw, system: System) -> None:
    pressure = _over_pressure(law)
    size, _ = _scaled("wrap_pressure", system)
    _, _, tested_slip = _range(law)
    slips = tested_slip * np.array([0.05, 0.15, 0.3, 0.5, 0.75, 1.0])
    for slip, shade, dash in zip(slips, shades(len(slips)), cycle(DASHES), strict=False):
        style = {"color": shade, "dashes": dash} if dash else {"color": shade}
        traction = law.friction(float(slip), pressure) * pressure
        text = display(float(slip), "length", system, digits=3)
        ax.plot(pressure / size, traction / size, label=text, **style)
    _pressure_axis(ax, law, system)
    ax.set_ylim(bottom=0.0)
    ax.set_ylabel(f"Traction mu p [{display_unit('pressure', system)[0]}]")
    _name(ax, "Traction over pressure, at slips")


def _two_lines(
    ax: "Axes", law: IntegralLog, system: System, left: tuple[Array, str], right: tuple[Array, str]
) -> None:
    """Draw two quantities over pressure, one on each side."""
    size, _ = _scaled("wrap_pressure", system)
    at = _over_pressure(law) / size
    ax.plot(at, left[0], color=BLUE)
    other = ax.twinx()
    other.plot(at, right[0], color=ORANGE, dashes=(5, 2))
    other.spines["right"].set_visible(True)
    other.grid(visible=False)
    for axes, (_, label), colour in ((ax, left, BLUE), (other, right, ORANGE)):
        dash = "solid" if axes is ax else "dashed"
        axes.set_ylabel(f"{label}, {dash}", color=colour)
        axes.tick_params(axis="y", labelcolor=colour)
    knots = np.array(law.coefficients.pressure) / size
    for axes, (values, _), colour in ((ax, left, BLUE), (other, right, ORANGE)):
        axes.plot(knots, np.interp(knots, at, values), "o", color=colour, markersize=3.5)
    _pressure_axis(ax, law, system)


def _draw_peak(ax: "Axes", law: IntegralLog, system: System) -> None:
    slip, friction, _, _ = law.parameters(_over_pressure(law))
    size, label = _scaled("peak_slip", system)
    _two_lines(ax, law, system, (slip / size, label), (friction, "Peak friction [-]"))
    ax.set_title("Peak of the curves over pressure")


def _draw_coefficients(ax: "Axes", law: IntegralLog, system: System) -> None:
    unit, size = display_unit("length", system)
    pairs = np.array([law.coefficients_ab(float(p), size) for p in _over_pressure(law)])
    a, b = pairs.T
    _two_lines(ax, law, system, (a, f"A [1/{unit}]"), (b, f"b [1/{unit}]"))
    ax.set_title(f"A and b of mu = A x ln(x) - b x, x in [{unit}]")


def _foot(lagging: Lagging) -> str:
    origin = lagging.source_of("law")
    text = f"Friction law: {origin}."
    if origin.kind is Kind.ILLUSTRATIVE:
        text += " Illustrative: it describes no real product."
    text += f" Outside the tested range the law is an extrapolation. wraparc {__version__}."
    return "\n".join(textwrap.wrap(text, 175, max_lines=2, placeholder=" ..."))
