"""The key figures of a drive: one list, which every answer and interface shows in its own form.

What is added to the list stands in the full answer and the report, on the short screen, in the
tiles and pins of the page, in comparisons and in the table of drives that share a belt, unless it
is said that it stands elsewhere there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, NamedTuple

if TYPE_CHECKING:
    from wraparc.arc import ArcResult

#: Where key figures are shown: rows of the first screen; the table of all arcs; rows of drives on
#: one belt; tiles and pinned designs of the page; columns of a comparison; rows of a change.
Place = Literal["short", "arcs", "drives", "tiles", "pins", "compare", "changes"]


class KeyFigure(NamedTuple):
    """A quantity that a drive is judged by.

    Attributes
    ----------
    name
        In the glossary, and of a result (`ArcResult.scalar`).
    better
        Which of two is better: ``low``, ``high``, or empty.
    elsewhere
        Where it is no row or column of its own: it stands beside another there, or is left out.
    """

    name: str
    better: str = "low"
    elsewhere: tuple[str, ...] = ()


KEY_FIGURES: tuple[KeyFigure, ...] = (
    KeyFigure("entry_tension", "", ("short", "arcs", "tiles", "compare")),
    KeyFigure("exit_tension", "", ("short", "arcs", "tiles", "compare")),
    KeyFigure("effective_tension", "", ("short", "arcs", "tiles", "compare")),
    KeyFigure("tension_ratio", "", ("short", "arcs", "drives", "compare", "changes")),
    KeyFigure("exit_creep", "low", ("short", "arcs")),
    KeyFigure("exit_slip", "", ("short", "drives", "compare")),
    KeyFigure("peak_shear_stress", "low", ("tiles",)),
    KeyFigure("peak_shear_angle", "low", ("short", "drives")),
    KeyFigure("mean_friction", "", ("short", "drives", "compare", "changes")),
    KeyFigure("creep_limit_margin", "high", ("short", "changes")),
    KeyFigure("equivalent_friction", "", ("short", "drives", "compare")),
    KeyFigure("power_loss"),
)
#: Those that the tables of one arc have in rows of their own.
OWN_ROWS = (
    "entry_tension", "exit_tension", "effective_tension", "tension_ratio", "exit_creep",
    "exit_slip", "peak_shear_stress", "peak_shear_angle", "mean_friction", "active_arc",
    "k_factor", "stuck_arc", "outside_tested_share", "creep_limit_capacity", "creep_limit_margin",
    "equivalent_friction", "tested_slip_capacity", "gross_slip_capacity", "transmitted_power",
    "sliding_power", "shear_loss", "power_loss", "efficiency", "frictional_energy", "wear_rate",
)  # fmt: skip


def key_figures(place: Place) -> list[KeyFigure]:
    """Return the key figures that stand in a place of their own there, in their order."""
    return [figure for figure in KEY_FIGURES if _stands_in(place, figure)]


def _stands_in(place: Place, figure: KeyFigure) -> bool:
    elsewhere = figure.elsewhere
    return place not in elsewhere


def further_figures() -> list[KeyFigure]:
    """Return the key figures that the tables of one arc have no row for."""
    return [figure for figure in KEY_FIGURES if figure.name not in OWN_ROWS]


def figure_of(arc: ArcResult, name: str) -> float:
    """Return a key figure of an arc [SI], nan where there is none."""
    return arc.scalar(name)
