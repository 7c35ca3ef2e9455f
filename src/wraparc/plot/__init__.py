"""Pictures of results and laggings; matplotlib is imported when one is drawn."""

from functools import singledispatch
from typing import Any

from wraparc.across import AcrossResult
from wraparc.arc import ArcResult, DriveResult
from wraparc.drive import Lagging
from wraparc.plot.across import plot_across
from wraparc.plot.conveyor import plot_conveyor
from wraparc.plot.drive import plot_arc, plot_drive
from wraparc.plot.lagging import plot_lagging
from wraparc.plot.picture import SUFFIXES, Picture, require_matplotlib
from wraparc.plot.train import plot_matching, plot_train
from wraparc.train import Matching, ShareMap, TrainResult
from wraparc.units import System

__all__ = [
    "SUFFIXES",
    "Picture",
    "plot",
    "plot_across",
    "plot_arc",
    "plot_conveyor",
    "plot_drive",
    "plot_lagging",
    "plot_matching",
    "plot_train",
    "require_matplotlib",
]


@singledispatch
def plot(thing: Any, *, units: System = "si") -> Picture:
    """Return the picture of a result or of a lagging.

    Parameters
    ----------
    thing
        A `DriveResult` (its governing arc is drawn), an `ArcResult`, an `AcrossResult` (a map of
        ``quantity``), a `Lagging`, a
        `TrainResult` (its governing load case, or ``case="name"``) or a `Matching` of its drives.
    units
        ``"si"`` or ``"us"``.

    Raises
    ------
    MissingExtraError
        Without matplotlib.
    TypeError
        If there is no picture of such a thing.
    """
    raise TypeError(f"no picture of {type(thing).__name__}; solve it first if it is a drive")


@plot.register
def _(thing: DriveResult, *, units: System = "si", quantity: str = "shear_stress") -> Picture:
    return plot_drive([thing], units, quantity=quantity)


@plot.register
def _(thing: ArcResult, *, units: System = "si", quantity: str = "shear_stress") -> Picture:
    return plot_arc([thing], units, quantity=quantity)


@plot.register
def _(thing: AcrossResult, *, units: System = "si", quantity: str = "shear_stress") -> Picture:
    return plot_across(thing, units, quantity=quantity)


@plot.register
def _(thing: Lagging, *, units: System = "si") -> Picture:
    return plot_lagging(thing, units)


@plot.register
def _(thing: TrainResult, *, units: System = "si", case: str = "") -> Picture:
    return plot_train(thing, case, units)


@plot.register
def _(thing: Matching, *, units: System = "si", over_load: ShareMap | None = None) -> Picture:
    return plot_matching(thing, over_load)
