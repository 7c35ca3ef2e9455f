"""Where the creep comes from, as bars."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from wraparc.arc import ArcResult
from wraparc.glossary import GLOSSARY
from wraparc.plot.picture import BLUE, GREEN, ORANGE, RED
from wraparc.units import System, display, display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Part, label, colour, hatch: told apart in print as well.
_PARTS = (
    ("creep_shrinkage", "belt shrinkage", BLUE, ""),
    ("creep_compression", "lagging compression", GREEN, "xxxx"),
    ("creep_global", "global", ORANGE, "////"),
)
_NAMES = {"distributed": "distributed", "paper": "paper's integration"}


def draw_budget(ax: "Axes", results: Sequence[ArcResult], system: System, columns: int = 2) -> None:
    """Draw the creep at the exit by source, a bar for each method, beside the limit.

    The legend, in `columns`, stands below the axes.
    """
    from matplotlib.transforms import ScaledTranslation

    unit, size = display_unit("length", system)
    for place, result in enumerate(results):
        above = below = 0.0
        for name, label, colour, hatch in _PARTS:
            part = getattr(result, name) / size
            start = above if part >= 0.0 else below
            # with white edges the hatch shows white on the colour
            ax.barh(
                place, part, left=start, height=0.62, color=colour, edgecolor="white",
                linewidth=0.8, hatch=hatch, label=None if place else _label(result, name, label),
            )  # fmt: skip
            above, below = (above + part, below) if part >= 0.0 else (above, below + part)
    first = results[0]
    limit = first.arc.side * first.arc.creep_limit / size
    if abs(limit) < 2.5 * max(abs(r.exit_creep) / size for r in results):
        text = f"limit {display(first.arc.creep_limit, 'length', system, digits=3)}"
        ax.axvline(limit, color=RED, linewidth=1.2, linestyle=(0, (1, 1.5)), label=text)
    ax.axvline(0.0, color="#444444", linewidth=0.6)
    ax.set_yticks(range(len(results)))
    ax.set_yticklabels([_NAMES[r.method] for r in results] if len(results) > 1 else [""])
    ax.set_ylim(len(results) - 0.5, -0.5)
    ax.grid(axis="y", visible=False)
    ax.tick_params(axis="y", length=0)
    ax.set_xlabel(f"{GLOSSARY['exit_creep'].title} [{unit}]")
    ax.set_title("Creep by source")
    # a fixed distance below the label of the axis, however high the axes are
    under = ax.transAxes + ScaledTranslation(0.0, -0.42, ax.figure.dpi_scale_trans)
    ax.legend(loc="upper left", bbox_to_anchor=(-0.02, 0.0), bbox_transform=under, ncols=columns)


def _label(result: ArcResult, name: str, label: str) -> str:
    part = getattr(result, name)
    parts = [abs(getattr(result, one)) for one, *_ in _PARTS]
    # parts that cancel, as on an idle pulley, are no shares of their sum
    adds_up = 0.0 < sum(parts) <= 1.05 * abs(result.exit_creep)
    share = f", {100.0 * part / result.exit_creep:.0f} %" if adds_up else ""
    return f"{label} ({GLOSSARY[name].symbol}{share})"
