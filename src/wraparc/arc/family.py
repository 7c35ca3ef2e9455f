"""One arc at several tension ratios: how creep grows along the wrap as more is asked of it.

The picture is Figure 1 of B. DeVries, *A model of lagging friction as a function of creep history
and wrap pressure*: belt displacement over wrap angle for increasing tension ratios.
"""

from collections.abc import Sequence
from dataclasses import replace

from wraparc.arc.result import ArcResult
from wraparc.arc.solver import Distributed
from wraparc.arc.wrap_arc import WrapArc
from wraparc.errors import InputError, Problem

#: Largest tension ratio that is solved: beyond it a slack side is a slip of the pen.
LARGEST_RATIO = 1000.0


def tension_ratio_family(arc: WrapArc, ratios: Sequence[float]) -> tuple[ArcResult, ...]:
    """Solve an arc at several tension ratios, its tight side held.

    Parameters
    ----------
    arc
        The arc. A driving or idling pulley keeps T1 and gets T2 = T1/ratio; a braking one keeps T2
        and gets T1 = T2/ratio.
    ratios
        Tight-side over slack-side tension, > 1 [-]; what is solved comes in the order given.

    Returns
    -------
    results
        One for each ratio; one that the friction cannot carry has a status that says so.

    Raises
    ------
    InputError
        Without a ratio, for ratios that are not above 1 or above `LARGEST_RATIO`, and for a law
        that is unfit for the arc.
    """
    problems = [
        Problem(
            key="ratios",
            value=f"{ratio:g}",
            message=f"must be more than 1 and at most {LARGEST_RATIO:g}",
            remedy="Give T1 over T2, also when braking.",
        )
        for ratio in ratios
        if not 1.0 < ratio <= LARGEST_RATIO
    ]
    if not ratios:
        problems = [Problem(key="ratios", message="needs at least one tension ratio")]
    if problems:
        raise InputError(problems)
    if arc.side < 0.0:
        arcs = (replace(arc, entry_tension=arc.exit_tension / ratio) for ratio in ratios)
    else:
        arcs = (replace(arc, exit_tension=arc.entry_tension / ratio) for ratio in ratios)
    return tuple(map(Distributed().solve, arcs))
