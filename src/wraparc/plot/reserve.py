"""How far inputs may be off until the verdict changes, as bars."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from wraparc.checks import Level
from wraparc.plot.picture import BLUE, GREEN, GREY, ORANGE, RED, Picture, styled
from wraparc.reserve import Flip
from wraparc.reserve.levels import FACTORS
from wraparc.units import System

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Colour and hatch of the level that a change ends in: told apart in print as well.
_LOOKS = {Level.OK: (GREEN, ""), Level.ATTENTION: (ORANGE, "////"), Level.FAILS: (RED, "xxxx")}
#: Height of an input [in], the share of it that the band has, and of what surrounds them [in].
_BAR, _BAND, _FRAME = 0.22, 0.8, 0.75


class Bars(NamedTuple):
    """The changes of an input to either side.

    Attributes
    ----------
    name
        What the input is called.
    flips
        The changes.
    """

    name: str
    flips: tuple[Flip, ...]


def plot_reserve(bars: Sequence[Bars], units: System = "si") -> Picture:
    """Return bars from the present of inputs to where the level of the verdict changes.

    Their uncertainty is a band behind them. It is in per cent of the input in either system.

    Raises
    ------
    MissingExtraError
        Without matplotlib.
    """
    with styled():
        from matplotlib.figure import Figure

        height = _FRAME + _BAR * max(len(bars), 1)
        figure = Figure(figsize=(5.5, height), layout="constrained")
        _draw(figure.subplots(), bars)
        return Picture(figure)


def _draw(ax: "Axes", bars: Sequence[Bars]) -> None:
    told: set[Level] = set()
    for place, of in enumerate(bars):
        uncertainty = of.flips[0].uncertainty
        low, high = (100.0 * uncertainty.towards(way) for way in (-1.0, 1.0))
        ax.barh(
            place, low + high, left=-low, height=_BAND, color=BLUE, alpha=0.2,
            label=None if place else "uncertainty of the input",
        )  # fmt: skip
        for flip in of.flips:
            colour, hatch = _LOOKS[flip.level]
            label = None if flip.level in told else f"{flip.level} at its end"
            told.add(flip.level)
            ax.barh(
                place, 100.0 * flip.change, height=0.4, color=colour, edgecolor="white",
                linewidth=0.8, hatch=hatch, label=label,
            )  # fmt: skip
    ax.axvline(0.0, color=GREY, linewidth=0.8)
    ax.set_xlim(*(100.0 * (factor - 1.0) for factor in FACTORS))
    ax.set_ylim(len(bars) - 0.5, -0.5)
    ax.set_yticks(range(len(bars)))
    ax.set_yticklabels([of.name for of in bars])
    ax.tick_params(axis="y", length=0)
    ax.grid(axis="y", visible=False)
    ax.set_xlabel("Change of one input alone [%]")
    ax.set_title("Change at which the verdict is another")
    if bars:
        ax.legend(loc="best")
