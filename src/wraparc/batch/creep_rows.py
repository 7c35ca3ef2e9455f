"""Operating points that the march in tension is not made for, by creep: rows in, rows out.

Idling and braking pulleys and measured tables, see :mod:`wraparc.batch.lane_creep_solve`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel.quantities import SOLVED
from wraparc.arc.kernel.search import NO_PULL
from wraparc.batch import lane_slots as slot
from wraparc.batch import row
from wraparc.batch.arcs import Arcs, Array, Integers
from wraparc.batch.elementwise import LANES, Lanes
from wraparc.batch.lane_creep import MESHES, NOTED
from wraparc.batch.lane_creep_solve import (
    EXIT_OVER_MEAN,
    GIVEN_MORE,
    TOLD,
    form_rows,
    solve_block,
    table_rows,
)
from wraparc.batch.lane_kernel import GIVEN
from wraparc.batch.lane_law import LaneLaws
from wraparc.batch.lane_tables import LaneTables, guess_under
from wraparc.batch.native import available, compiled, pays
from wraparc.batch.precise import FEW

Flags = NDArray[np.bool_]

TRACES = NOTED * (MESHES[-1] + 1)
ACCEPTED_MISS = 1e-4  # last correction of creep: what is left after it is about its square
#: of creep by the finer mesh, of twice and of three times the steps: near the kinks of a law either
#: may be small by chance, and half as much is accepted of a table before a finer mesh is tried
ACCEPTED_CHANGE, ACCEPTED_CHANGES, OF_KINKS = 3e-5, 1e-4, 0.5
ACCEPTED_SLIP = 1e-7  # miss of a slip over the creep that it belongs to
#: slip speed over that of the tests, beyond which the largest on the nodes tells which is faster
SURELY_BY = 1.5
_PLACE = {name: k for k, name in enumerate(TOLD)}
_MAIN = (
    (row.EXIT_CREEP, slot.EXIT_CREEP),
    (row.EXIT_SLIP, slot.EXIT_X),
    (row.LARGEST_SLIP, slot.LARGEST),
    (row.STEEPEST_SLIP, slot.FASTEST),
    (row.EXIT_STRESS, slot.EXIT_STRESS),
    (row.ENTRY_STRESS, slot.ENTRY_STRESS),
    (row.CREEP_RATIO, slot.G),
    (row.PEAK_STRESS, slot.PEAK_STRESS),
    (row.PEAK_AT, slot.PEAK_AT),
    (row.ACTIVE, slot.ACTIVE),
)


def solve_left(
    arcs: Arcs,
    laws: LaneLaws,
    tables: LaneTables,
    rows_of: Callable[[Integers, float], Array],
    wanted: Flags,
    found: Array,
) -> Flags:
    """Solve operating points into rows of results; returns which are solved.

    Parameters
    ----------
    arcs, laws, tables
        The arcs and their laws.
    rows_of
        Rows of `lane_kernel.GIVEN` of some of the arcs.
    wanted
        Which are wanted.
    found
        Rows of results; those that are solved are written.
    """
    done, places = np.zeros(len(arcs), dtype=bool), list(row.PLACES[row.TENSIONS])
    for of in (laws, tables):
        which = np.flatnonzero(wanted & (of.row[arcs.law] >= 0))
        if not len(which):
            continue
        rows = rows_of(which, 1.0)
        rows[:, GIVEN.index(slot.ROW)] = of.row[arcs.law[which]]
        results, good = solve_by_creep(arcs.rows(which), rows, of)
        done[which] = good
        found[np.ix_(which[good], places)] = results[np.ix_(good, places)]
    return done


def solve_by_creep(arcs: Arcs, rows: Array, laws: LaneLaws | LaneTables) -> tuple[Array, Flags]:
    """Rows of results of operating points, and which of them are near enough.

    Parameters
    ----------
    arcs
        The arcs, with a kick along the way of the belt against the pulley or none.
    rows
        Their rows of `lane_kernel.GIVEN`.
    laws
        The laws that the rows refer to.
    """
    given = dict(zip(row.INPUTS, arcs.inputs().T, strict=True))
    end = np.log(given["entry_tension"] / given["exit_tension"])
    more, halvings = np.zeros((len(rows), len(GIVEN_MORE))), 0
    if isinstance(laws, LaneTables):
        more, halvings = _guesses(arcs, given, end), laws.halvings
    few = not (available() and pays(len(rows), FEW))
    falls = given["steepest_fall"] < 0.0
    out = _run(rows, more, laws.numbers, halvings, True, few)
    good = _near(out, falls, OF_KINKS if halvings else 1.0)
    again = np.flatnonzero(~good & (out[:, _PLACE[slot.MISSED]] < ACCEPTED_SLIP))
    rows[:, GIVEN.index(slot.Z)] = out[:, _PLACE[slot.Z]]
    out[again] = _run(rows[again], more[again], laws.numbers, halvings, False, few)
    good[again] = _near(out[again], falls[again], 1.0)
    fastest = arcs.belt_speed * out[:, _PLACE[slot.FASTEST]] / arcs.laws.tested_speed[arcs.law]
    good &= ~((fastest > 1.0 / SURELY_BY) & (fastest < SURELY_BY))
    # nothing drives the belt, and an arc without an end is of no use to anybody
    good &= (np.abs(end) > NO_PULL) | (out[:, _PLACE[slot.ENTRY_STRESS]] > 0.0)
    return _results(given, end, out), good


def _results(given: dict[str, Array], end: Array, out: Array) -> Array:
    """Rows of results, of rows of `TOLD`."""
    found = np.full((len(out), row.FOUND_NUMBERS), np.nan)
    for place, name in _MAIN:
        found[:, place] = out[:, _PLACE[name]]
    found[:, row.OUTCOME], found[:, row.STUCK_LENGTH] = SOLVED, 0.0
    found[:, row.LOG_RATIO] = -end
    tested = np.isfinite(given["slip_max"])
    found[tested, row.OUTSIDE] = out[tested, _PLACE[slot.OUTSIDE]]
    # by the exact loss of energy: friction's part is what the shear does not take
    pull = given["entry_tension"] - given["exit_tension"]
    loss = pull * (found[:, row.CREEP_RATIO] + 0.5 * pull * given["compliance"])
    stress = found[:, row.EXIT_STRESS] ** 2 - found[:, row.ENTRY_STRESS] ** 2
    found[:, row.WORK] = loss / given["width"] - 0.5 * given["shear"] * stress
    return found


def _guesses(arcs: Arcs, given: dict[str, Array], end: Array) -> Array:
    """Rows of `GIVEN_MORE` of arcs under measured tables."""
    pressure = given["entry_tension"] / (given["width"] * given["radius"])
    half = pressure * np.exp(-0.5 * end)
    mean = np.abs(end) / given["wrap_angle"]
    slip, stiff = np.empty(len(arcs)), np.empty(len(arcs))
    for law in np.unique(arcs.law):
        of = arcs.law == law
        slip[of], stiff[of] = guess_under(arcs.laws.compact(int(law)), mean[of], half[of])
    creep = slip + given["shear"] * EXIT_OVER_MEAN * mean * half
    kick = given["kick"] + given["kick_coefficient"] * pressure**1.5
    return np.stack([np.where(end < 0.0, -creep, creep) - kick, stiff], axis=1)


def _near(out: Array, falls: Flags, part: float) -> Flags:
    """Whether what is left of the search, the changes by finer meshes and of slips are small.

    Past where friction begins to fall another creep may meet the same tensions.
    """
    good = out[:, _PLACE[slot.MISS]] < ACCEPTED_MISS
    good &= out[:, _PLACE[slot.CHANGE]] < part * ACCEPTED_CHANGE
    good &= out[:, _PLACE[slot.CHANGE_FIRST]] < part * ACCEPTED_CHANGES
    good &= ~falls | (out[:, _PLACE[slot.STEEPEST]] <= 1.0)
    return good & (out[:, _PLACE[slot.MISSED]] < ACCEPTED_SLIP)


def _run(rows: Array, more: Array, laws: Array, halvings: int, first: bool, few: bool) -> Array:
    """Rows of `TOLD` numbers; the `first` time from a guess and on the coarser mesh."""
    steps = MESHES[0] if first else MESHES[1]
    out = np.empty((len(rows), len(TOLD)))
    if not len(rows):
        return out
    if not few:
        scratch = (np.zeros(k * LANES) for k in (slot.SLOTS, TRACES))
        entry = compiled(table_rows if halvings else form_rows, contract=True)
        entry(rows, more, laws, halvings, first, steps, *scratch, out)
        return out
    w, trace = Lanes(slot.SLOTS), Lanes(TRACES)
    for k, name in enumerate(GIVEN):
        w[name, 0] = rows[:, k]
    for k, name in enumerate(GIVEN_MORE):
        w[name, 0] = more[:, k]
    with np.errstate(all="ignore"):
        solve_block(w, laws, halvings or None, trace, first, steps)
    for k, name in enumerate(TOLD):
        out[:, k] = w[name, 0]
    return out
