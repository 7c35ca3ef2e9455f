"""The picture of a conveyor: its profile, and the belt tension along both strands."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from wraparc.conveyor import Conveyor, State
from wraparc.drive import Drive
from wraparc.errors import input_error
from wraparc.plot.picture import GREY, LINES, Picture, styled
from wraparc.train import Train, TrainResult, states_of
from wraparc.units import System, display_unit
from wraparc.version import __version__

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Load cases that are drawn, the first ones.
MOST_CASES = 8
_FAMILY = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#000000", "#e69f00", "#882255")


def plot_conveyor(
    of: Drive | Train, units: System = "si", result: TrainResult | None = None
) -> Picture:
    """Return the picture of a conveyor: profile above, tension along the belt in its load cases.

    The carrying strand is drawn with full lines, the return strand dashed; both over the distance
    from the tail, so that a drive at the head or the tail is the gap between them.

    Parameters
    ----------
    of
        A drive or a train of which the tensions follow from a conveyor.
    units
        Units to show.
    result
        The train as it was solved, whose drives share as they were found to.

    Raises
    ------
    InputError
        If the tensions are stated, and no conveyor.
    """
    states, conveyor = states_of(of, result), of.conveyor
    if not states or conveyor is None:
        message = "the file has no [conveyor] that gives its tensions"
        raise input_error(key="conveyor", message=message, remedy="Write one.")
    once = {state.name: state for state in states}
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(9.0, 6.4), layout="constrained")
        profile, tension = figure.subplots(2, 1, sharex=True, height_ratios=(1, 3))
        _draw_profile(profile, conveyor, units)
        _draw_tensions(tension, conveyor, list(once.values())[:MOST_CASES], units)
        figure.suptitle(of.title or "Conveyor", x=0.02, ha="left", fontsize=13, weight="bold")
        figure.text(0.99, 0.003, f"wraparc {__version__}", ha="right", fontsize=7, color=GREY)
        return Picture(figure)


def _metres(units: System) -> tuple[str, float]:
    """Return the unit of distances along a conveyor, and its SI value."""
    return ("ft", 0.3048) if units == "us" else ("m", 1.0)


def _draw_profile(ax: "Axes", conveyor: Conveyor, units: System) -> None:
    """Draw the height of the belt over the distance from the tail, and where the drives are."""
    unit, size = _metres(units)
    places, heights = [0.0], [0.0]
    for flight in conveyor.course_flights:
        places.append(places[-1] + flight.length / size)
        heights.append(heights[-1] + flight.rise / size)
        middle = 0.5 * (places[-1] + places[-2])
        ax.annotate(
            flight.name, (middle, 0.5 * (heights[-1] + heights[-2])), (0, 6),
            textcoords="offset points", ha="center", fontsize=8, color=GREY,
        )  # fmt: skip
    ax.plot(places, heights, color="#222222")
    ax.plot(places, heights, "o", color="#222222", markersize=3)
    ax.set_ylabel(f"Height [{unit}]")
    ax.set_title("Profile")
    ax.margins(y=0.35)


def _draw_tensions(ax: "Axes", conveyor: Conveyor, states: Sequence[State], units: System) -> None:
    unit, size = _metres(units)
    force, newton = display_unit("force", units)
    for i, state in enumerate(states):
        colour = _FAMILY[i % len(_FAMILY)]
        for strand, dashes in (("carry", "-"), ("return", "--")):
            places, tensions = strand_course(conveyor, state, strand)
            label = state.name if strand == "carry" else "_nolegend_"
            ax.plot(
                [place / size for place in places], [t / newton for t in tensions],
                linestyle=dashes, color=colour, label=label, linewidth=1.5,
            )  # fmt: skip
    marked: list[tuple[str, float]] = []
    for point in states[0].points:
        if point.kind not in ("drive", "take-up"):
            continue
        place = from_tail(conveyor, point.strand, point.position) / size
        stacked = sum(1 for _, at in marked if abs(at - place) < 0.05 * conveyor.length / size)
        marked.append((point.name, place))
        ax.axvline(place, color=GREY, linewidth=0.8, linestyle=LINES[3][1])
        ax.text(
            place, 0.99 - 0.05 * stacked, f" {point.name} ", fontsize=7.5, color=GREY, va="top",
            ha="right" if place > 0.5 * conveyor.length / size else "left",
            transform=ax.get_xaxis_transform(),
        )  # fmt: skip
    ax.set_xlabel(f"Distance from the tail [{unit}]")
    ax.set_ylabel(f"Belt tension [{force}]")
    ax.set_ylim(bottom=0.0)
    ax.set_title("Carrying strand (full lines) and return strand (dashed)")
    ax.legend(ncols=4, loc="upper center", bbox_to_anchor=(0.5, -0.13))


def from_tail(conveyor: Conveyor, strand: str, position: float) -> float:
    """Return how far a point of a strand is from the tail [m]."""
    return position if strand == "carry" else conveyor.length - position


def strand_course(conveyor: Conveyor, state: State, strand: str) -> tuple[list[float], list[float]]:
    """Return distances from the tail [m] and tensions [N] along a strand, in belt order."""
    places: list[float] = []
    tensions: list[float] = []
    for point in state.points:
        if point.strand == strand:
            places += [from_tail(conveyor, strand, point.position)] * 2
            tensions += [point.before, point.after]
    ends = [s.end for s in state.stretches if s.strand == strand and s.mass > 0.0]
    if all(p.position < conveyor.length for p in state.points if p.strand == strand):
        places.append(from_tail(conveyor, strand, conveyor.length))
        tensions.append(ends[-1])
    return places, tensions
