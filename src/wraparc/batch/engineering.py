"""The engineering setting: most arcs by the lane kernel, the others by the scalar one."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.kernel import answer
from wraparc.arc.kernel.least_slack import HIGHEST
from wraparc.arc.kernel.quantities import BREAKAWAY, REFUSED, SOLVED
from wraparc.batch import lane_slots as slot
from wraparc.batch import row
from wraparc.batch.arcs import Arcs, Array, Integers
from wraparc.batch.constant import solve_constant
from wraparc.batch.creep_rows import solve_left
from wraparc.batch.elementwise import LANES, Lanes
from wraparc.batch.lane_kernel import (
    CREEP,
    FOUND,
    GIVEN,
    GIVEN_FIRST,
    GIVEN_NEAR,
    GROSS,
    GUESSED,
    LEAST,
    NODES,
    SLIP,
    TENSIONS,
    TRACES,
    solve_falling_rows,
    solve_goal_rows,
    solve_goals,
    solve_rows,
    solve_tensions,
)
from wraparc.batch.lane_law import LaneLaws
from wraparc.batch.lane_tables import LaneTables
from wraparc.batch.laws import LawBank
from wraparc.batch.least import Least, search_least
from wraparc.batch.native import available, compiled
from wraparc.batch.plateau import Plateaus
from wraparc.batch.precise import solve_precisely

Flags = NDArray[np.bool_]
Solved = tuple[Array, Flags]  # rows of `FOUND`, and which are near enough

#: largest last correction: what is left after it is about its square, and a sixteenth for the mesh
ACCEPTED_MISS = 1e-3
ACCEPTED_CHANGE = 3e-4  # of the exit slip by twice the steps, before a law with kinks is left
SMALLEST_LOG_RATIO = 1e-5
SURELY = 1.01  # times the slip speed of the tests: above it by more than the accuracy of a batch
MESH = slot.MESHES[1]  # where the coarse one is not enough, and for laws that fall: no kink is cut
NO_LIMIT = 1e300

_INPUT = {name: k for k, name in enumerate(row.INPUTS)}
_FOUND = {place: k for k, place in enumerate(FOUND)}
BEGUN_PLACES = [_FOUND[name] for name in (slot.G, slot.G_Z, slot.SLOPE_Z, slot.END, slot.TENSION)]
_MAIN = (
    (row.EXIT_CREEP, slot.EXIT_CREEP),
    (row.EXIT_SLIP, slot.EXIT_X),
    (row.LARGEST_SLIP, slot.EXIT_X),  # of a driving arc it grows all along
    (row.EXIT_STRESS, slot.EXIT_STRESS),
    (row.ENTRY_STRESS, slot.ENTRY_STRESS),
    (row.CREEP_RATIO, slot.G),
    (row.PEAK_STRESS, slot.PEAK_STRESS),
    (row.PEAK_AT, slot.PEAK_AT),
    (row.ACTIVE, slot.ACTIVE),
)


def solve_in_lanes(arcs: Arcs, parts: int = row.EVERYTHING) -> tuple[Array, Flags]:
    """Rows of results (see `row`) that are wanted, and which arcs the scalar kernel had to do."""
    batch = LaneBatch(arcs)
    batch.find(parts)
    batch.cap_by_gross(batch.found)
    batch.hand_over(parts)
    return batch.found, batch.left > 0


@lru_cache(maxsize=8)
def tables_of(laws: LawBank) -> tuple[LaneLaws, Plateaus, LaneTables]:
    """Tables of a bank, shared by the chunks of a batch."""
    table = LaneLaws.of(laws)
    return table, Plateaus(table), LaneTables.of(laws)


class LaneBatch:
    """A batch while it is being solved."""

    def __init__(self, arcs: Arcs) -> None:
        self.arcs, self.given = arcs, arcs.inputs()
        self.laws, self.plateaus, self.tables = tables_of(arcs.laws)
        self.found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
        self.left = np.zeros(len(arcs), dtype=np.int64)  # parts for the scalar kernel
        self.starts = np.full((len(arcs), row.STARTS), np.nan)
        self.begun: dict[int, Array] = {}  # rows of `sixth_begin.BEGUN`, by what has been met
        self.log_ratio = np.log(self.of("entry_tension") / self.of("exit_tension"))
        pull = self.of("entry_tension") - self.of("exit_tension")
        self.pull = np.maximum(pull, 0.0)
        pressure = self.of("entry_tension") / (self.of("width") * self.of("radius"))
        self.asks_pull = self.pull > 1e-6 * self.of("entry_tension")
        top = self.of("pressure_max") * self.of("width") * self.of("radius")
        self.top = np.where(np.isnan(top), HIGHEST * self.of("entry_tension"), top)
        softens = self.of("steepest_fall") < 0.0
        refused = self.of("shear") * pressure * self.of("steepest_fall") <= -1.0
        self.found[:, row.OUTCOME] = np.where(refused, REFUSED, SOLVED)
        self.pressure, self.softens, self.live = pressure, softens, ~refused
        self.fit = self.live & (self.laws.row[arcs.law] >= 0) & (self.of("side") > 0.0)
        self.fit &= self.of("kick") >= 0.0  # lanes know no slip that passes zero
        self.left[self.live & ~self.fit] = row.EVERYTHING

    def find(self, parts: int, *, to_begin: bool = False) -> None:
        """All that is wanted and that lanes can do; or `to_begin` with, where searches may."""
        self.to_begin = to_begin
        self.find_gross(parts)
        if parts & row.TENSIONS:
            self.find_tensions()
        if parts & (answer.CREEP_LIMIT | answer.LEAST):
            self.find_carried(CREEP, row.CREEP_CAPACITY, answer.CREEP_LIMIT)
        if parts & answer.TESTED_SLIP:
            self.find_carried(SLIP, row.SLIP_CAPACITY, answer.TESTED_SLIP)
        if parts & answer.LEAST:
            self.find_least()

    def of(self, name: str) -> Array:
        """One number of every arc."""
        return self.given[:, _INPUT[name]]

    def rows(self, which: Integers, goal: Array | float, tension: Array | None = None) -> Array:
        """Rows for the lane kernel."""
        arcs, given = self.arcs, self.given[which]
        columns = {
            slot.ROW: self.laws.row[arcs.law[which]],
            slot.RADIUS: given[:, _INPUT["radius"]],
            slot.LENGTH: given[:, _INPUT["radius"]] * given[:, _INPUT["wrap_angle"]],
            slot.SHEAR: given[:, _INPUT["shear"]],
            slot.WIDTH: given[:, _INPUT["width"]],
            slot.COMPLIANCE: given[:, _INPUT["compliance"]],
            slot.KICK_GIVEN: given[:, _INPUT["kick"]],
            slot.KICK_FORMULA: given[:, _INPUT["kick_coefficient"]],
            slot.TENSION: given[:, _INPUT["entry_tension"]] if tension is None else tension,
            slot.END: self.log_ratio[which],
            slot.GOAL: goal,
            slot.PULL: self.pull[which],
            slot.SLIP_MAX: np.nan_to_num(given[:, _INPUT["slip_max"]], nan=NO_LIMIT),
            slot.Z: np.nan,
        }
        made = np.empty((len(which), len(GIVEN)))
        for k, name in enumerate(GIVEN):
            made[:, k] = columns[name]
        return made

    def solve(self, which: Integers, rows: Array, what: int, fine: bool = False) -> Solved:
        """Solve rows of the arcs `which`, and say which of them are near enough.

        Laws that fall past their peak are solved by lanes of their own, but for the tensions: there
        few come to the peak, and those are not good.
        """
        if not self.softens.any():
            return self._solve_flat(rows, what, fine)
        falls = self.softens[which] & (what != TENSIONS)
        out, good = np.empty((len(rows), len(FOUND))), np.empty(len(rows), dtype=bool)
        flat = np.flatnonzero(~falls)
        out[flat], good[flat] = self._solve_flat(rows[flat], what, fine)
        falling = np.flatnonzero(falls)
        out[falling] = self._run(rows[falling], what, GUESSED, MESH, True)
        good[falling] = _near(out[falling], what)
        again = falling[~good[falling] & (what != GROSS)]
        out[again] = self._again(rows[again], out[again], what, GIVEN_NEAR, True)
        good[again] = _near(out[again], what)
        good &= ~self.softens[which] | falls | (out[:, _FOUND[slot.STEEPEST]] <= 1.0)
        return out, good

    def _solve_flat(self, rows: Array, what: int, fine: bool) -> Solved:
        """Solve rows of laws flat past their peak, some a second time on a finer mesh.

        Those are the ones that were not near enough, and those whose law has kinks that the
        pressure passes: within its range, or at an end of it; all of them, if `fine`.
        """
        out = self._run(rows, what, GUESSED, slot.MESHES[0], False)
        good = _near(out, what)
        near = np.flatnonzero((self._kinked(rows, out) | fine) & good)
        out[near] = self._again(rows[near], out[near], what, GIVEN_NEAR, False)
        far = np.flatnonzero(~good & np.isfinite(out[:, _FOUND[slot.Z]]))
        out[far] = self._again(rows[far], out[far], what, GIVEN_FIRST, False)
        again = np.concatenate([near, far])
        good[again] = _near(out[again], what)
        return out, good

    def _again(self, rows: Array, out: Array, what: int, begin: int, falls: bool) -> Array:
        """Solve rows once more, from what has been found, on the finer mesh."""
        for name in (slot.Z, slot.END, slot.TENSION):
            rows[:, GIVEN.index(name)] = out[:, _FOUND[name]]
        return self._run(rows, what, begin, MESH, falls)

    def _run(self, rows: Array, what: int, begin: int, steps: int, falls: bool) -> Array:
        return run_lanes(rows, self.laws.numbers, what, begin, steps, falls)

    def _kinked(self, rows: Array, out: Array) -> Flags:
        """Whether the law has kinks, or the pressure passes its first or last edge."""
        place = rows[:, GIVEN.index(slot.ROW)].astype(np.int64)
        area = rows[:, GIVEN.index(slot.WIDTH)] * rows[:, GIVEN.index(slot.RADIUS)]
        first = out[:, _FOUND[slot.TENSION]] / area
        last = first * np.exp(-out[:, _FOUND[slot.END]])
        of_row = np.zeros(len(self.laws.numbers), dtype=bool)
        of_row[self.laws.row[self.laws.kinked]] = True
        passes = of_row[place]
        for edge in (self.laws.numbers[place], self.laws.numbers[place + 1]):
            passes |= (first > edge) & (last < edge)
        return passes

    def find_gross(self, parts: int) -> None:
        """Gross slip, and the breakaways that follow from it where laws are flat."""
        which = np.flatnonzero(self.fit & ~self.softens)
        gross = self.plateaus.capacity(
            self.arcs.law[which], self.pressure[which], self.of("wrap_angle")[which]
        )
        self.found[which, row.GROSS_CAPACITY] = gross
        self.found[which, row.GROSS_CREEP] = np.inf
        self.found[which[self.log_ratio[which] >= gross], row.OUTCOME] = BREAKAWAY
        if parts & answer.CAPACITIES and not self.to_begin:
            self._find_falling_gross()

    def _find_falling_gross(self) -> None:
        """Gross slip of laws that fall past their peak."""
        which = np.flatnonzero(self.fit & self.softens)
        rows = self.rows(which, 1.0)
        rows[:, GIVEN.index(slot.END)] = self.plateaus.capacity(
            self.arcs.law[which], self.pressure[which], self.of("wrap_angle")[which]
        )
        out, good = self.solve(which, rows, GROSS)
        good &= out[:, _FOUND[slot.DETERMINANT]] > 0.5  # not at the low end of what is looked at
        self.found[which[good], row.GROSS_CAPACITY] = out[good, _FOUND[slot.END]]
        self.found[which[good], row.GROSS_CREEP] = out[good, _FOUND[slot.EXIT_CREEP]]
        self.left[which[~good]] |= answer.CAPACITIES

    def find_tensions(self) -> None:
        """Operating points."""
        runs = self.fit & (self.found[:, row.OUTCOME] == SOLVED)
        which = np.flatnonzero(runs & (self.log_ratio > SMALLEST_LOG_RATIO))
        self.left[runs & (self.log_ratio <= SMALLEST_LOG_RATIO)] |= row.TENSIONS
        out, good = self.solve(which, self.rows(which, 1.0), TENSIONS)
        self.left[which[~good]] |= row.TENSIONS
        kept: Integers | slice = slice(None)  # the usual one, and the fastest
        if len(which) < len(self.left) or not good.all():
            kept, out = which[good], out[good]
        self.starts[kept, 0] = out[:, _FOUND[slot.G]]
        self.starts[kept, 4] = out[:, _FOUND[slot.SLOPE_Z]] / out[:, _FOUND[slot.G_Z]]
        self._begun(TENSIONS, kept, out)
        for place, name in _MAIN:
            self.found[kept, place] = out[:, _FOUND[name]]
        self.found[kept, row.LOG_RATIO] = -self.log_ratio[kept]
        self.found[kept, row.STUCK_LENGTH] = 0.0
        untested = np.isnan(self.of("slip_max")[kept])
        self.found[kept, row.OUTSIDE] = np.where(untested, np.nan, out[:, _FOUND[slot.OUTSIDE]])
        self._slip_speed(kept)
        # by the exact loss of energy: friction's part is what the shear does not take
        pull, shear = self.pull[kept], self.of("shear")[kept]
        loss = pull * (out[:, _FOUND[slot.G]] + 0.5 * pull * self.of("compliance")[kept])
        stress = out[:, _FOUND[slot.EXIT_STRESS]] ** 2 - out[:, _FOUND[slot.ENTRY_STRESS]] ** 2
        self.found[kept, row.WORK] = loss / self.of("width")[kept] - 0.5 * shear * stress

    def _begun(self, what: int, which: Integers | slice, out: Array) -> None:
        """Keep where the kernel's march in the lanes may begin."""
        begun = self.begun.setdefault(what, np.full((len(self.left), len(BEGUN_PLACES)), np.nan))
        begun[which] = out[:, BEGUN_PLACES]

    def _slip_speed(self, kept: Integers | slice) -> None:
        """Bound the slip speed from below, by the mean over the arc.

        Lanes do not look for the largest; where the bound does not tell whether it is above that
        of the tests, the scalar kernel does.
        """
        length = self.of("radius")[kept] * self.of("wrap_angle")[kept]
        mean = self.found[kept, row.EXIT_SLIP] / length
        self.found[kept, row.STEEPEST_SLIP] = mean
        tested = self.arcs.laws.tested_speed[self.arcs.law[kept]]
        unsure = self.arcs.belt_speed[kept] * mean <= SURELY * tested  # False where either is nan
        self.left[kept] |= np.where(unsure, row.TENSIONS, 0)

    def find_carried(self, what: int, place: int, part: int) -> None:
        """Capacity at the creep limit, or at the largest tested slip."""
        goal = self.of("creep_limit" if what == CREEP else "slip_max")
        which = np.flatnonzero(self.fit & np.isfinite(goal))
        out, good = self.solve(which, self.rows(which, goal[which]), what)
        self.found[which[good], place] = out[good, _FOUND[slot.END]]
        self.starts[which[good], 1 if what == CREEP else 2] = out[good, _FOUND[slot.G]]
        self._begun(what, which[good], out[good])
        self.left[which[~good]] |= part

    def find_least(self) -> None:
        """Least slack-side tension, or the largest pull where there is none."""
        limit, top = self.of("creep_limit"), self.top
        wanted = self.fit & self.asks_pull
        which = np.flatnonzero(wanted & ~np.isnan(self.found[:, row.CREEP_CAPACITY]))
        self.left[wanted & np.isnan(self.found[:, row.CREEP_CAPACITY])] |= answer.LEAST
        # the ratio that is carried at the given T1 is a good one to begin with
        carried = -np.expm1(-self.found[which, row.CREEP_CAPACITY])
        first = np.minimum(self.pull[which] / carried, top[which])
        first = np.maximum(first, 1.02 * self.pull[which])
        out, good = self.solve(which, self.rows(which, limit[which], first), LEAST)
        found = out[:, _FOUND[slot.TENSION]]
        good &= (out[:, _FOUND[slot.DETERMINANT]] > 0.0) & (found <= top[which])
        self.found[which[good], row.LEAST_SLACK] = found[good] - self.pull[which[good]]
        self._begun(LEAST, which[good], out[good])
        self.starts[which[good], 3] = out[good, _FOUND[slot.G]]
        self.starts[which[good], 5] = found[good]
        if not self.to_begin:
            self._find_most(which[~good])

    def _find_most(self, which: Integers) -> None:
        """Largest pull at the creep limit, or the least tension where that is no easy search."""
        found = self.search_most(which)
        self.found[which, row.LEAST_SLACK] = found.least - self.pull[which]
        self.found[which, row.MOST_PULL] = found.most
        self.left[which[~found.good]] |= answer.LEAST

    def search_most(self, which: Integers) -> Least:
        """Search along the tension for what `_find_most` finds."""
        limit = self.of("creep_limit")[which]

        def pull_within(log_tension: Array, rows: Integers, fine: bool) -> tuple[Array, Flags]:
            tension, some = np.exp(log_tension), which[rows]
            out, good = self.solve(some, self.rows(some, limit[rows], tension), CREEP, fine)
            return -tension * np.expm1(-out[:, _FOUND[slot.END]]), good

        return search_least(pull_within, self.pull[which], self.top[which])

    def cap_by_gross(self, found: Array) -> None:
        """Where creep or slip reach the limit past the largest ratio, that ratio is what counts."""
        creep = found[:, row.GROSS_CREEP]
        for limit, place, part in (
            ("creep_limit", row.CREEP_CAPACITY, answer.CREEP_LIMIT),
            ("slip_max", row.SLIP_CAPACITY, answer.TESTED_SLIP),
        ):
            capped = creep <= self.of(limit)  # False where either is nan
            found[capped, place] = found[capped, row.GROSS_CAPACITY]
            self.left[capped] &= ~part

    def hand_over(self, parts: int) -> None:
        """Let the scalar kernel do what is left; it caps ratios only where it knows gross slip."""
        unsure = self.softens & (self.left & (answer.CREEP_LIMIT | answer.TESTED_SLIP) > 0)
        self.left[unsure] |= answer.GROSS_SLIP
        self.left &= parts | (answer.GROSS_SLIP if parts & answer.CAPACITIES else 0)
        for solve in (solve_constant, self._by_creep):
            solved = solve(self.arcs, self.left & row.TENSIONS > 0, self.found)
            self.left[solved] &= ~row.TENSIONS
        which = np.flatnonzero(self.left)
        if not len(which):
            return
        left = self.left[which]
        done = solve_precisely(self.arcs.rows(which), left)
        for part, places in row.PLACES.items():
            these = (left & part) > 0
            for place in places:
                self.found[which[these], place] = done[these, place]

    def _by_creep(self, arcs: Arcs, wanted: Flags, found: Array) -> Flags:
        wanted = wanted & (self.of("kick") >= 0.0)
        return solve_left(arcs, self.laws, self.tables, self.rows, wanted, found)


def _near(out: Array, what: int) -> Flags:
    """Whether what is left of the search, and the change by a finer mesh, are small enough."""
    near = np.abs(out[:, _FOUND[slot.MISS]]) < ACCEPTED_MISS
    if what == TENSIONS:
        near &= out[:, _FOUND[slot.CHANGE]] < ACCEPTED_CHANGE
    return np.asarray(near)


def run_lanes(rows: Array, laws: Array, what: int, begin: int, steps: int, falls: bool) -> Array:
    """Rows of `FOUND` numbers from rows of `GIVEN` numbers; in the interpreter without numba."""
    out = np.empty((len(rows), len(FOUND)))
    if not len(rows):
        return out
    if available():
        scratch = (np.zeros(k * LANES) for k in (slot.SLOTS, NODES, TRACES))
        entry = solve_rows if what == TENSIONS else solve_goal_rows
        entry = solve_falling_rows if falls else entry
        compiled(entry, contract=True)(rows, laws, what, begin, steps, *scratch, out)
        return out
    w, nodes, trace = Lanes(slot.SLOTS), Lanes(NODES), Lanes(TRACES)
    for k, name in enumerate(GIVEN):
        w[name, 0] = rows[:, k]
    with np.errstate(all="ignore"):
        if what == TENSIONS:
            solve_tensions(w, laws, nodes, trace, what, begin, steps)
        else:
            solve_goals(w, laws, nodes, what, begin, steps, 1.0 if falls else None)
    for k, name in enumerate(FOUND):
        out[:, k] = w[name, 0]
    return out
