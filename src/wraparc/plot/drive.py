"""The picture of a solved arc: the pulley at the left, the profiles at the right."""

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

from wraparc.arc import ArcResult, DriveResult, Status
from wraparc.checks import judge
from wraparc.glossary import GLOSSARY
from wraparc.plot.budget import draw_budget
from wraparc.plot.picture import Picture, styled
from wraparc.plot.profiles import draw_profiles
from wraparc.plot.pulley import draw_pulley
from wraparc.units import System, display, in_units
from wraparc.version import __version__

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_NOTHING = (
    "The whole wrap slips: no creep, slip or shear stress\nalong it transmits these tensions, and "
    "none is drawn."
)


def plot_drive(
    results: Sequence[DriveResult], system: System = "si", *, quantity: str = "shear_stress"
) -> Picture:
    """Return the picture of the governing arc of a drive.

    Parameters
    ----------
    results
        The drive solved by one method or by two; the second is drawn thin over the first.
    system
        Units to show.
    quantity
        What the pulley is coloured by, a column of the profile.
    """
    first = results[0]
    position = first.arcs.index(first.governing)
    arcs = [result.arcs[position] for result in results]
    title = first.drive.title or "Drive"
    remarks = [in_units(remark, system) for remark in judge(first).remarks]
    return plot_arc(arcs, system, quantity=quantity, title=title, remarks=remarks)


def plot_arc(
    results: Sequence[ArcResult],
    system: System = "si",
    *,
    quantity: str = "shear_stress",
    title: str = "",
    remarks: Sequence[str] = (),
) -> Picture:
    """Return the picture of one arc: pulley and profiles.

    Parameters
    ----------
    results
        The arc by one method or by two; what is not solved has no profile to draw.
    system
        Units to show.
    quantity
        What the pulley is coloured by, a column of the profile.
    title
        Heading, before what the arc is called.
    remarks
        Sentences a reader must not miss, put at the foot.
    """
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(12.0, 8.0))
        # the drawing has an aspect of its own, so it does not take part in the grid
        drawing = figure.add_axes((0.02, 0.385, 0.43, 0.53))
        draw_pulley(drawing, results[0], system, quantity)
        if results[0].status.solved:
            _draw_along(figure, [r for r in results if r.status.solved], system)
        else:
            figure.text(0.535, 0.6, _NOTHING, fontsize=10, va="center")
        figure.text(0.02, 0.965, _title(results[0], title), fontsize=13, weight="bold")
        figure.text(0.02, 0.932, caption(results[0], system), fontsize=10)
        figure.text(0.02, 0.018, _foot(remarks), fontsize=7.5, color="#444444", va="bottom")
        return Picture(figure)


def _draw_along(figure: "Figure", results: Sequence[ArcResult], system: System) -> None:
    """Draw the creep by source at the left, below the pulley, and the profiles at the right."""
    indent = 0.02 if len(results) == 1 else 0.095
    height = 0.045 * len(results)
    budget = figure.add_axes((indent, 0.29 - height, 0.45 - indent, height))
    draw_budget(budget, results, system)
    rows = figure.add_gridspec(4, 1, hspace=0.34, left=0.535, right=0.935, top=0.885, bottom=0.125)
    axes = [figure.add_subplot(rows[i]) for i in range(4)]
    draw_profiles(axes, results, system)
    figure.align_ylabels(axes)


def plot_pulley(result: ArcResult, system: System = "si") -> Picture:
    """Return the pulley of an arc alone, small enough to stand beside another in print."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(4.1, 3.6))
        draw_pulley(figure.add_axes((0.04, 0.17, 0.92, 0.82)), result, system)
        return Picture(figure)


def plot_budget(results: Sequence[ArcResult], system: System = "si") -> Picture:
    """Return the creep at the exit by source alone, a bar for each method."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(3.7, 3.6))
        left, height = (0.04, 0.2) if len(results) == 1 else (0.27, 0.32)
        draw_budget(figure.add_axes((left, 0.9 - height, 0.95 - left, height)), results, system, 1)
        return Picture(figure)


def plot_profiles(results: Sequence[ArcResult], system: System = "si") -> Picture:
    """Return the four profiles of an arc alone, two by two."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(8.2, 5.4))
        grid = {"left": 0.07, "right": 0.93, "top": 0.91, "bottom": 0.085, "wspace": 0.42}
        axes = figure.subplots(2, 2, gridspec_kw={**grid, "hspace": 0.42}).ravel().tolist()
        draw_profiles(axes, results, system)
        return Picture(figure)


def _title(result: ArcResult, title: str) -> str:
    arc = result.arc
    place = f"pulley {arc.pulley}, load case {arc.load_case}" if arc.pulley else ""
    return " - ".join(part for part in (title, place) if part) or "Wrap arc"


def caption(result: ArcResult, system: System) -> str:
    """Return the answer in one line."""
    if result.status is Status.BREAKAWAY:
        ratio = display(result.tension_ratio, "number", digits=3)
        return f"Gross slip: friction cannot transmit this load, T1/T2 = {ratio}."
    creep = display(abs(result.exit_creep), "length", system, digits=3)
    limit = display(result.arc.creep_limit, "length", system, digits=3)
    within = "within" if result.within_creep_limit else "more than"
    angle = display(result.peak_shear_angle, "angle", digits=3)
    title = GLOSSARY["exit_creep"].title
    return f"{title} {creep}, {within} the limit of {limit}; peak shear angle {angle}."


def _foot(remarks: Sequence[str]) -> str:
    text = " ".join((*remarks, f"wraparc {__version__}."))
    return "\n".join(textwrap.wrap(text, 190, max_lines=3, placeholder=" ..."))
