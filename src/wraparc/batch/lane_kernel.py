"""The lane kernel: blocks of arcs read from rows of numbers, solved, written to rows of numbers.

Compiled, a block is `LANES` arcs and all its lanes do the same; the last block is filled up with
copies of its last arc. A lane never depends on its neighbours: whatever the blocks are, an arc has
the same result to the last bit.
"""

from __future__ import annotations

from typing import Any

from wraparc.batch.elementwise import (
    Lanes,
    Table,
    lanes,
    memory,
)
from wraparc.batch.lane_gross import meet_gross
from wraparc.batch.lane_guess import (
    guess,
    guess_carried,
    guess_least,
    load,
)
from wraparc.batch.lane_look import (
    read_head,
)
from wraparc.batch.lane_march import Falls
from wraparc.batch.lane_read import (
    read,
)
from wraparc.batch.lane_slots import (
    ACTIVE,
    CHANGE,
    COMPLIANCE,
    DETERMINANT,
    END,
    ENTRY_STRESS,
    EXIT_CREEP,
    EXIT_STRESS,
    EXIT_X,
    G_Z,
    GOAL,
    KICK_FORMULA,
    KICK_GIVEN,
    LENGTH,
    MISS,
    MOST_STEPS,
    NODE,
    OUTSIDE,
    PEAK_AT,
    PEAK_STRESS,
    PULL,
    RADIUS,
    ROW,
    S_BY_Q,
    S_BY_Z,
    SHEAR,
    SLIP_MAX,
    SLOPE_Z,
    STEEPEST,
    TENSION,
    TRACE,
    V_BY_Q,
    V_BY_Z,
    WIDTH,
    G,
    X,
    Z,
)
from wraparc.batch.lane_solve import (
    meet_creep,
    meet_tensions,
    set_ratio,
)

#: slots that a row fills, in this order
GIVEN = (
    ROW,
    RADIUS,
    LENGTH,
    SHEAR,
    WIDTH,
    COMPLIANCE,
    KICK_GIVEN,
    KICK_FORMULA,
    TENSION,
    END,
    GOAL,
    PULL,
    SLIP_MAX,
    Z,
)
#: slots that a row of results has, in this order
FOUND = (
    MISS,
    Z,
    END,
    TENSION,
    STEEPEST,
    DETERMINANT,
    G,
    EXIT_X,
    EXIT_CREEP,
    EXIT_STRESS,
    ENTRY_STRESS,
    PEAK_STRESS,
    PEAK_AT,
    ACTIVE,
    OUTSIDE,
    CHANGE,
    SLOPE_Z,
    G_Z,
)
NODES = NODE * (2 * MOST_STEPS + 1)
TRACES = TRACE * (MOST_STEPS + 1)

TENSIONS, CREEP, SLIP, LEAST, GROSS = range(5)  # what is to be met
#: how a search begins: with a guess; with what is given; with what is given, good but for the mesh
GUESSED, GIVEN_FIRST, GIVEN_NEAR = range(3)


def solve_tensions(
    w: Lanes, laws: Table, nodes: Lanes, trace: Lanes, what: int, begin: int, steps: int
) -> None:
    """Solve a block for its tensions, beginning with a guess of z or with the one given."""
    read_head(w, laws)
    load(w, laws)
    if begin == GUESSED:
        guess(w, laws)
    meet_tensions(w, laws, nodes, trace, steps)
    read(w, nodes, trace, steps)
    set_ratio(w)


def solve_goals(
    w: Lanes,
    laws: Table,
    nodes: Lanes,
    what: int,
    begin: int,
    steps: int,
    falls: Falls,
) -> None:
    """Solve a block for the creep or slip at the exit, or for the creep at a given pull.

    If not with a guess, it begins with the z and the END or TENSION given. Of laws that fall past
    their peak also for gross slip; END is to be what the plateau would carry.
    """
    n = lanes()
    of_slip = 1.0 if what == SLIP else 0.0
    read_head(w, laws)
    load(w, laws)
    if falls is not None and what == GROSS:
        meet_gross(w, laws, nodes, steps)
        return
    if begin == GUESSED and what == LEAST:
        guess_least(w, laws)
    elif begin == GUESSED:
        guess_carried(w, laws, of_slip)
    first, last = 0, 3
    if falls is not None and begin == GUESSED:
        first = -1  # the guesses know no fall
    elif falls is not None:
        first, last = 2, 4  # kinks are felt by a change of mesh
    elif begin == GIVEN_NEAR and what != LEAST:
        first = 2
    meet_creep(w, laws, nodes, steps, of_slip, what == LEAST, first, last, falls)
    last = NODE * 2 * steps
    for i in range(n):
        w[STEEPEST, i] = w[X, i] * nodes[last, i]
        w[SLOPE_Z, i] = w[V_BY_Z, i] - w[V_BY_Q, i] * w[S_BY_Z, i] / w[S_BY_Q, i]
    set_ratio(w)


def solve_rows(
    rows: Any,
    laws_: Any,
    what: int,
    begin: int,
    steps: int,
    w_: Any,
    nodes_: Any,
    trace_: Any,
    out: Any,
) -> None:
    """Solve rows of `GIVEN` numbers for their tensions into rows of `FOUND`; compiled only."""
    w, nodes, trace = memory(w_, "w"), memory(nodes_, "nodes"), memory(trace_, "trace")
    laws = memory(laws_, "tables")
    n, count = lanes(), len(rows)
    for first in range(0, count, n):
        take(rows, first, count, w)
        solve_tensions(w, laws, nodes, trace, what, begin, steps)
        give(w, first, count, out)


def solve_goal_rows(
    rows: Any,
    laws_: Any,
    what: int,
    begin: int,
    steps: int,
    w_: Any,
    nodes_: Any,
    trace_: Any,
    out: Any,
) -> None:
    """The same for a goal. An entry of its own: what is not asked for need not be compiled."""
    w, nodes, laws = memory(w_, "w"), memory(nodes_, "nodes"), memory(laws_, "tables")
    n, count = lanes(), len(rows)
    for first in range(0, count, n):
        take(rows, first, count, w)
        solve_goals(w, laws, nodes, what, begin, steps, None)
        give(w, first, count, out)


def solve_falling_rows(
    rows: Any,
    laws_: Any,
    what: int,
    begin: int,
    steps: int,
    w_: Any,
    nodes_: Any,
    trace_: Any,
    out: Any,
) -> None:
    """The same for laws that fall past their peak."""
    w, nodes, laws = memory(w_, "w"), memory(nodes_, "nodes"), memory(laws_, "tables")
    n, count = lanes(), len(rows)
    for first in range(0, count, n):
        take(rows, first, count, w)
        solve_goals(w, laws, nodes, what, begin, steps, 1.0)
        give(w, first, count, out)


def take(rows: Any, first: int, count: int, w: Lanes) -> None:
    """Fill a block from rows; past the last one with copies of it."""
    n = lanes()
    for i in range(n):
        source = min(first + i, count - 1)
        for k in range(len(GIVEN)):
            w[GIVEN[k], i] = rows[source, k]


def give(w: Lanes, first: int, count: int, out: Any) -> None:
    """Write what a block has found."""
    n = lanes()
    for i in range(min(n, count - first)):
        for k in range(len(FOUND)):
            out[first + i, k] = w[FOUND[k], i]
