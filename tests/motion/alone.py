"""One moving arc alone: a table of wraps with a single one, as the tests of arcs drive it."""

from wraparc import WrapArc
from wraparc.motion import held
from wraparc.motion.arc import MovingArc
from wraparc.motion.wraps import Wraps


def alone(arc: WrapArc, points: int) -> MovingArc:
    """A moving arc in a table of its own."""
    moving = MovingArc(arc, points)
    Wraps([moving])
    return moving


def wraps_of(arc: MovingArc) -> Wraps:
    """Its table."""
    assert isinstance(arc.wraps, Wraps)
    return arc.wraps


def driven(arc: MovingArc, ahead: float, dm: float, exit_tension: float, h: float = 1.0) -> None:
    """One step with given travel and given surface less belt."""
    travel, m, exits = arc.travel + ahead, arc.m + dm, [exit_tension]
    wraps = wraps_of(arc)
    wraps.begin([travel], h)
    for _ in range(30):
        wraps.sweep([travel], [m], exits)
        if wraps.change([m], exits)[0] < 1e-12:
            break
    wraps.finish([m], exits)


def roll(arc: MovingArc, ahead: float, entry: float, exit_tension: float) -> None:
    """Travel on with given tensions."""
    held.roll(wraps_of(arc), [ahead], [entry], [exit_tension])


def settle(arc: MovingArc, entry: float, exit_tension: float, lengths: float) -> None:
    """Bring an arc into its steady state."""
    held.settle(wraps_of(arc), [entry], [exit_tension], lengths)
