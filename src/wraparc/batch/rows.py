"""Many arcs by collocation over columns: operating points and capacities, row by row.

Rows are tried on a coarse mesh, then on finer ones spread as their misfit asks, until it is below
what is allowed; what no mesh serves is left to the scalar solver. An arc has the same numbers to
rounding whatever it is solved with.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from wraparc.arc import capacity
from wraparc.arc.capacity import FAR, HALVINGS, HIGHEST
from wraparc.arc.collocation import CREEP, MOST_AMPLIFIED, TENSION
from wraparc.arc.gross_slip import PRESSURES
from wraparc.arc.quantities import BREAKAWAY, LEAST_COMPLIANCE, REFUSED, SOLVED
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import row
from wraparc.batch.arcs import Arcs
from wraparc.batch.constant import solve_constant
from wraparc.batch.gross_slip import breaks_away, ratio_at_gross_slip
from wraparc.batch.least import crown, narrowed, search_least
from wraparc.batch.precise import solve_precisely
from wraparc.batch.read_courses import read_courses
from wraparc.batch.two_point import (
    Block,
    Ends,
    Solved,
    first_courses,
    mean_creep,
    on_mesh,
    solved,
    spread,
)

#: Meshes tried one after the other, to an accuracy of 1e-5 and to finer ones: elements, of which
#: the first is graded to the entry.
MESHES, FINER = (4, 8, 12, 20, 32, 48, 96, 192), (6, 12, 28, 48, 96, 192)
#: What misfit is let stand, of the accuracy: errors are a 50th of it in the median, half at most
#: under friction that rises, two thirds past its peak.
MISFIT = 1.0
#: How many times the relative error of tension that of creep may be before a finer mesh is asked.
AMPLIFIED = 4.0
#: What the creep at the exit may have moved from the mesh before, of the accuracy: friction that
#: hardly grows with slip makes much creep of a small misfit.
MOVED = 10.0
#: Tensions of a smaller ratio, ln(tight/slack), are left to the scalar solver [-], but where an
#: overrun makes creep of its own that friction does not hold [m].
SMALLEST_LOG_RATIO, LEAST_OVERRUN = 1e-5, 1e-9
#: Creeps of which the largest ratio of a law that falls past its peak is looked for, times the one
#: at which a share of the peak is reached; then nearer to the best.
ON_THE_RISE = 0.6
CREEPS = (0.4, 0.7, 1.0, 1.5, 2.2, 3.3, 5.0, 7.0, 10.0, 16.0, 30.0, 60.0)
NEARER = 9  # a kink of the law beside the top needs so many

#: Of the largest ratio, ln(tight/slack), by how much more is gross slip for sure: a hundred times
#: what that may be off.
SURELY = 1e-4
FIRST_NEAR = 0.05  # of Newton's method on the first mesh: what it leaves is the mesh's
LARGEST_FALL = 6.0  # of ln T, of a first guess
#: numbers of an array that is made and freed at first: from then on glibc keeps what it frees, up
#: to twice as much, for later arrays; giving it back page by page takes a third of the time
KEPT = 2_000_000

_INPUT = {name: k for k, name in enumerate(row.INPUTS)}


class Guess(NamedTuple):
    """First guess of an arc: tensions at its ends [N], creep at the exit [m]."""

    entry: Array
    leaving: Array
    creep: Array


class Tensions(NamedTuple):
    """Tensions of the tight and the slack side, shape (n,) each [N]."""

    tight: Array
    slack: Array


class OnLine(NamedTuple):
    """Lines that tensions lie on, at_tight T_tight + at_slack T_slack = tension, shape (n,)."""

    at_tight: Array
    at_slack: Array
    tension: Array

    def meets(self, ratio: Array) -> Tensions:
        """Where the tensions have a ratio, tight over slack [-]."""
        slack = self.tension / (self.at_tight * ratio + self.at_slack)
        return Tensions(ratio * slack, slack)

    def slack_at(self, tight: Array) -> Array:
        """Tension of the slack side [N]."""
        return (self.tension - self.at_tight * tight) / self.at_slack

    def rows(self, which: slice | Integers) -> OnLine:
        """Those of some of the rows."""
        return OnLine(*(column[which] for column in self))


class AtLimit(NamedTuple):
    """Arcs at a limit of creep or slip, shape (n,); nan where that is not met.

    Attributes
    ----------
    tight, slack
        Tensions of both sides [N].
    grows
        See `Solved`.
    """

    tight: Array
    slack: Array
    grows: Array


#: Called with rows that met what was asked, and their blocks and courses.
Read = Callable[[Integers, Block, Solved], None]


def solve_rows(arcs: Arcs, parts: int, accuracy: float) -> tuple[Array, Flags]:
    """Rows of results (see `row`) that are wanted, and which arcs the scalar solver had to do.

    Parameters
    ----------
    arcs
        The arcs.
    parts
        What is wanted, see `row`.
    accuracy
        Largest relative error of creep, slip and shear that is let stand [-].
    """
    np.empty(KEPT)
    found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
    left = np.zeros(len(arcs), dtype=np.int64)
    for which in arcs.by_kind():
        batch = RowBatch.of(arcs.rows(which), accuracy)
        with np.errstate(all="ignore"):
            batch.find(parts)
        found[which], left[which] = batch.found, batch.left
    _leave(arcs, parts, found, left)
    return found, left > 0


def carried_on(arcs: Arcs, on: OnLine, by_slip: Flags, accuracy: float) -> AtLimit:
    """Meet the creep limit or the largest tested slip of arcs with tensions on lines.

    Parameters
    ----------
    arcs
        The arcs; their tensions are where to begin.
    on
        What the tensions are to keep.
    by_slip
        Where it is the largest tested slip, shape (n,).
    accuracy
        As for `solve_rows`.
    """
    found = AtLimit(*(np.full(len(arcs), np.nan) for _ in AtLimit._fields))
    for which in arcs.by_kind():
        with np.errstate(all="ignore"):
            batch = RowBatch.of(arcs.rows(which), accuracy)
            some = np.flatnonzero((batch.found[:, row.OUTCOME] == SOLVED) & ~batch.rigid)
            slips = by_slip[which[some]]
            met = batch.at_limit(some, on.rows(which[some]), batch.limits(some, slips), slips)
        for told, column in zip(found, met, strict=True):
            told[which[some]] = column
    return found


def may_peak(arcs: Arcs) -> Flags:
    """Where friction falls past its peak, and may carry most at some creep."""
    found = np.zeros(len(arcs), dtype=bool)
    for which in arcs.by_kind():
        with np.errstate(all="ignore"):
            batch = RowBatch.of(arcs.rows(which), 1.0)
            falls = np.flatnonzero(batch.of_input("steepest_fall") < 0.0)
            if len(falls):
                outweighs, left = batch.outweighs(falls)
                found[which[falls]] = outweighs | ~np.isfinite(left)
    return found


def _guess_on(block: Block, on: OnLine, tight: Array, goal: Array) -> tuple[Tensions, Array]:
    """Tensions of a line at which about a limit is met, and the stress that is used [Pa]."""
    used, fall = _about(block, tight, goal)
    first = on.meets(np.exp(fall)).tight
    used, fall = _about(block, first, goal)
    guess = on.meets(np.exp(fall))
    beyond = np.flatnonzero(~(guess.slack > 0.0))
    if len(beyond):  # both sides grow: where friction that falls with pressure meets their ratio
        some, of, goal = block.rows(beyond), on.rows(beyond), goal[beyond]
        low, high = tight[beyond], FAR * tight[beyond]
        for _ in range(HALVINGS):
            middle = np.sqrt(low * high)
            more = np.log(middle / of.slack_at(middle)) < _about(some, middle, goal)[1]
            low, high = np.where(more, middle, low), np.where(more, high, middle)
        guess.tight[beyond], guess.slack[beyond] = middle, of.slack_at(middle)
        used[beyond] = _about(some, middle, goal)[0]
    return guess, used


def _about(block: Block, tight: Array, goal: Array) -> tuple[Array, Array]:
    """Stress that is used at a creep with a tight side [N], about, and the fall of ln T by it."""
    used = block.laws.stress(block.shear, tight / block.area, 0.6 * goal).stress
    fall = used / tight * block.area * block.length / block.radius
    return used, 0.9 * np.minimum(fall, LARGEST_FALL)


def _leave(arcs: Arcs, parts: int, found: Array, left: Integers) -> None:
    """Let the scalar solver do what is left."""
    left &= parts
    point = row.TENSIONS | row.RATIO
    done = solve_constant(arcs, left & point > 0, found)
    left[done] &= ~point
    which = np.flatnonzero(left)
    if not len(which):
        return
    rest = solve_precisely(arcs.rows(which), left[which])
    for part, places in row.PLACES.items():
        these = (left[which] & part) > 0
        found[np.ix_(which[these], places)] = rest[np.ix_(these, places)]


@dataclass(eq=False)
class RowBatch:
    """Arcs under laws of one kind while they are being solved.

    Attributes
    ----------
    arcs, given, block
        What is solved.
    found, left
        Rows of results, and parts that are left to the scalar solver.
    accuracy
        See `solve_rows`.
    """

    arcs: Arcs
    given: Array
    block: Block
    found: Array
    left: Integers
    accuracy: float

    @classmethod
    def of(cls, arcs: Arcs, accuracy: float) -> RowBatch:
        """Begin a batch: rows that a law is unfit for are refused."""
        given = arcs.inputs()
        of = {name: given[:, k] for name, k in _INPUT.items()}
        block = Block(
            laws=arcs.laws.traction(arcs.law),
            side=of["side"],
            radius=of["radius"],
            length=of["radius"] * of["wrap_angle"],
            width=of["width"],
            compliance=np.maximum(of["compliance"], LEAST_COMPLIANCE),
            shear=of["shear"],
            overrun_constant=of["overrun_constant"],
            overrun_coefficient=of["overrun_coefficient"],
        )
        found = np.full((len(arcs), row.FOUND_NUMBERS), np.nan)
        left = np.zeros(len(arcs), dtype=np.int64)
        batch = cls(arcs, given, block, found, left, accuracy)
        found[:, row.OUTCOME] = np.where(batch._refused(), REFUSED, SOLVED)
        return batch

    def of_input(self, name: str) -> Array:
        """One number of every arc."""
        return self.given[:, _INPUT[name]]

    @property
    def near(self) -> float:
        """Change at which Newton's method ends: what it leaves is of the square of that [-]."""
        return float(0.1 * np.sqrt(self.accuracy))

    @property
    def tight(self) -> Array:
        """Tension of the tight side [N]."""
        return np.maximum(self.of_input("entry_tension"), self.of_input("exit_tension"))

    @property
    def rigid(self) -> Flags:
        """Rows whose law jumps and is set-valued without shear: a solver of its own has them."""
        return np.asarray(
            (self.block.laws.jump(self.tight / self.block.area) > 0.0) & (self.block.shear == 0.0)
        )

    @property
    def log_ratio(self) -> Array:
        """ln(tight/slack) of the tensions given [-]."""
        return np.abs(np.log(self.of_input("entry_tension") / self.of_input("exit_tension")))

    def _refused(self) -> Flags:
        """Rows with no unique creep, see `row.refused`."""
        top = self.tight / self.block.area
        steep = self.of_input("shear") * top * self.of_input("steepest_fall") <= -1.0
        p = self.of_input("entry_tension") / self.block.area
        overrun = np.abs(self.block.overrun(self.of_input("entry_tension"))[0])
        jump = self.block.laws.jump(p) * p
        held = (self.of_input("shear") + self.arcs.laws.onset_compliance[self.arcs.law]) * jump
        return np.asarray(steep | ((jump > 0.0) & (overrun > 0.0) & (overrun > held)))

    def find(self, parts: int) -> None:
        """Find what is wanted of every row that is not refused."""
        live = np.flatnonzero(self.found[:, row.OUTCOME] == SOLVED)
        self._find_gross(live, parts)
        rigid = self.rigid
        self.left[live[rigid[live]]] = parts
        live = live[~rigid[live]]
        if parts & row.TENSIONS:
            self._find_tensions(live, row.TENSIONS, self._read)
        elif parts & row.RATIO:
            self._find_tensions(live, row.RATIO, self._read_ratio)
        self._find_softened(live)
        if parts & (capacity.CREEP_LIMIT + capacity.LEAST):
            self._find_carried(live, row.CREEP_CAPACITY, capacity.CREEP_LIMIT)
        if parts & capacity.TESTED_SLIP:
            tested = live[np.isfinite(self.of_input("slip_max")[live])]
            self._find_carried(tested, row.SLIP_CAPACITY, capacity.TESTED_SLIP)
        if parts & capacity.LEAST:
            self._find_least(live)
        self._cap_by_gross(parts)

    def meet(self, which: Integers, ends: Ends, guess: Guess, read: Read) -> Integers:
        """Meet end conditions, and return the rows in which that fails.

        Parameters
        ----------
        which
            The rows.
        ends
            What is asked of them.
        guess
            Tensions at the entry and the exit, and creep at the exit, that are near.
        read
            Called with rows that are met.
        """
        failed = np.zeros(len(which), dtype=bool)
        if not len(which):
            return which
        every = np.arange(len(which))
        for first in (0, 2):
            if first:  # once more, from a belt at rest
                every, tight = np.flatnonzero(failed), np.maximum(guess.entry, guess.leaving)
                guess = Guess(tight, tight, np.zeros(len(which)))
            lost = self._refined(which, every, ends, guess, read, first)
            failed[:] = False
            failed[lost] = True
            if not len(lost):
                break
        return which[failed]

    def _refined(
        self,
        which: Integers,
        some: Integers,
        ends: Ends,
        guess: Guess,
        read: Read,
        first: int,
    ) -> Integers:
        """Try the meshes from the `first` on; returns the places in `which` that none serves."""
        block, ends = self.block.rows(which[some]), ends.rows(some)
        entry, leaving, end = (column[some] for column in guess)
        meshes = MESHES if self.accuracy >= 1e-5 else FINER
        at = first_courses(block, entry, leaving, end, meshes[first])
        lost: list[Integers] = []
        last = np.empty(0)
        for k in range(first, len(meshes)):
            done = solved(block, ends, at, FIRST_NEAR if k == 0 else self.near)
            sound = done.met & ((done.grows > 0.0) | (ends.kind != TENSION))
            good = (
                sound & self._near(block, ends, done, last) if k > first else np.zeros_like(sound)
            )
            ready, on = np.flatnonzero(good), np.flatnonzero(sound & ~good)
            if len(ready):
                read(which[some[ready]], block.rows(ready), done.rows(ready))
            lost.append(some[~sound])
            some, block, ends = some[on], block.rows(on), ends.rows(on)
            if not len(some) or k + 1 == len(meshes):
                break
            done = done.rows(on)
            last = done.courses.creep[-1]
            shares = spread(done.courses.shares, done.misfit, meshes[k + 1])
            at = on_mesh(done.courses, done.curves, shares)
        return np.concatenate([*lost, some])

    def _near(self, block: Block, ends: Ends, done: Solved, last: Array) -> Flags:
        """Whether courses are near enough: by their misfit, and by what the last mesh moved.

        Where a ratio is asked, it is the tension of the slack side that has to be.
        """
        at, wanted = done.courses, self.accuracy
        misfit = done.misfit.max(axis=0)
        if ends.kind == TENSION:
            size = np.abs(at.creep).max(axis=0)
            moved = np.abs(at.creep[-1] - last) <= MOVED * wanted * size
            pull = np.abs(at.tension[0] - at.tension[-1])
            by_tension = np.maximum(np.abs(done.by_entry), np.abs(done.by_exit))
            moves = by_tension * block.length * pull / size
            amplified = np.clip(moves / AMPLIFIED, 1.0, MOST_AMPLIFIED)
            return np.asarray((misfit * amplified <= MISFIT * wanted) & moved)
        fall = np.abs(np.log(at.tension[0] / at.tension[-1]))
        return np.asarray(misfit <= MISFIT * wanted * fall)

    def _find_tensions(self, live: Integers, part: int, read: Read) -> None:
        """Operating points; what is not found is that part of what is wanted."""
        entry, leaving = self.of_input("entry_tension"), self.of_input("exit_tension")
        creeps = np.abs(self.block.overrun(entry)[0]) > LEAST_OVERRUN
        creeps &= self.block.laws.jump(entry / self.block.area) == 0.0
        asks = (self.log_ratio > SMALLEST_LOG_RATIO) | creeps
        asks &= self.found[:, row.OUTCOME] == SOLVED
        idle = live[(self.found[live, row.OUTCOME] == SOLVED) & ~asks[live]]
        self.left[idle] |= part
        which = live[asks[live]]
        one, none = np.ones(len(which)), np.zeros(len(which))
        ends = Ends(one, none, entry[which], TENSION, leaving[which], none * np.nan)
        block = self.block.rows(which)
        creep = 2.0 * block.side * mean_creep(block, entry[which], leaving[which])
        guess = Guess(entry[which], leaving[which], creep)
        self.left[self.meet(which, ends, guess, read)] |= part

    def _find_softened(self, live: Integers) -> None:
        """Find which of the arcs that no mesh serves slip grossly past the peak of their friction.

        The scalar solver tries many creeps before it says so.
        """
        point = row.TENSIONS | row.RATIO
        open_ = (self.left[live] & point > 0) & (self.of_input("steepest_fall")[live] < 0.0)
        which = live[open_ & (self.found[live, row.OUTCOME] == SOLVED)]
        if not len(which):
            return
        beyond = self.log_ratio[which] > (1.0 + SURELY) * self._largest(which)[0]
        self.found[which[beyond], row.OUTCOME] = BREAKAWAY
        self.left[which[beyond]] &= ~point

    def _read(self, which: Integers, block: Block, met: Solved) -> None:
        """Write operating points into rows of results."""
        low, high, slip = (
            self.of_input(name)[which] for name in ("pressure_min", "pressure_max", "slip_max")
        )
        timed = np.isfinite(self.arcs.laws.tested_speed[self.arcs.law[which]])
        columns = read_courses(block, met, (low, high, slip), timed)
        for place, column in columns.items():
            self.found[which, place] = column
        # a belt that creeps by more than its length is one that the scalar solver does not hold
        self.left[which[columns[row.CREEP_RATIO] >= 1.0]] |= row.TENSIONS

    def _read_ratio(self, which: Integers, block: Block, met: Solved) -> None:
        """Write creeps, entry creep ratios and their slopes into rows of results."""
        at = met.courses
        self.found[which, row.EXIT_CREEP] = at.creep[-1]
        ratio = at.ratio - block.compliance * at.tension[0]
        self.found[which, row.CREEP_RATIO] = ratio
        self.found[which, row.RATIO_BY_ENTRY] = met.by_entry - block.compliance
        self.found[which, row.RATIO_BY_EXIT] = met.by_exit
        self.left[which[ratio >= 1.0]] |= row.RATIO

    def at_limit(
        self,
        which: Integers,
        on: OnLine,
        goal: Array,
        by_slip: Flags,
        guess: Tensions | None = None,
    ) -> AtLimit:
        """Meet a creep [m], or where said a slip [m], at the exit with tensions on lines.

        From a guess of the tensions; without one, where about what is used then meets the line.
        """
        block = self.block.rows(which)
        about, used = _guess_on(block, on, self.tight[which], goal)
        guess = about if guess is None else guess
        drives, tight, slack = block.side > 0.0, guess.tight, guess.slack
        end = block.side * np.where(by_slip, goal + block.shear * used, goal)
        begin = Guess(np.where(drives, tight, slack), np.where(drives, slack, tight), end)
        asked_slip = np.where(by_slip, block.side * goal, np.nan)
        at_entry = np.where(drives, on.at_tight, on.at_slack)
        at_exit = np.where(drives, on.at_slack, on.at_tight)
        ends = Ends(at_entry, at_exit, on.tension, CREEP, end, asked_slip)
        tight, slack, grows = (np.full(len(self.left), np.nan) for _ in range(3))

        def read(rows: Integers, block: Block, met: Solved) -> None:
            entry, leaving = met.courses.tension[0], met.courses.tension[-1]
            # by what the arc is asked: where an overrun takes all, the sides change places
            driving = block.side > 0.0
            tight[rows] = np.where(driving, entry, leaving)
            slack[rows] = np.where(driving, leaving, entry)
            grows[rows] = met.grows

        begun = np.flatnonzero((guess.slack > 0.0) & np.isfinite(guess.tight))
        some = Guess(*(column[begun] for column in begin))
        self.meet(which[begun], ends.rows(begun), some, read)
        return AtLimit(tight[which], slack[which], grows[which])

    def limits(self, which: Integers, by_slip: Flags) -> Array:
        """Return the creep limits of rows, or where said their largest tested slips [m]."""
        slip, creep = self.of_input("slip_max")[which], self.of_input("creep_limit")[which]
        return np.where(by_slip, slip, creep)

    def _carried(
        self, which: Integers, tight: Array, limit: Array, *, by_slip: bool = False
    ) -> Array:
        """ln(tight/slack) at a creep, or a slip [m]; nan where that fails."""
        one = np.ones(len(which))
        on = OnLine(one, 0.0 * one, tight)
        met = self.at_limit(which, on, limit, np.full(len(which), by_slip))
        return np.log(met.tight / met.slack)

    def _find_carried(self, which: Integers, place: int, part: int) -> None:
        """Capacity at the creep limit, or at the largest tested slip."""
        by_slip = part == capacity.TESTED_SLIP
        limit = self.limits(which, np.full(len(which), by_slip))
        found = self._carried(which, self.tight[which], limit, by_slip=by_slip)
        self.found[which, place] = found
        self.left[which[np.isnan(found)]] |= part

    def _find_least(self, live: Integers) -> None:
        """Least slack-side tension, or the largest pull where there is none."""
        pull = np.abs(self.of_input("entry_tension") - self.of_input("exit_tension"))
        top = self.of_input("pressure_max") * self.block.area
        top = np.where(np.isnan(top), HIGHEST * self.tight, top)
        known = np.isfinite(self.found[:, row.CREEP_CAPACITY])
        self.left[live[~known[live]]] |= capacity.LEAST
        which = live[(pull > 1e-6 * self.tight)[live] & known[live]]
        carried = -np.expm1(-self.found[which, row.CREEP_CAPACITY])
        tight = np.minimum(pull[which] / carried, top[which])
        tight = np.maximum(tight, 1.02 * pull[which])
        limit, one = self.of_input("creep_limit"), np.ones(len(which))
        guess = Tensions(tight, tight - pull[which])
        on = OnLine(one, -one, pull[which])
        met = self.at_limit(which, on, limit[which], np.zeros(len(which), dtype=bool), guess)
        done = (met.grows > 0.0) & (met.tight <= top[which])
        self.found[which[done], row.LEAST_SLACK] = (met.tight - pull[which])[done]
        rest = which[~done]
        if not len(rest):
            return

        def pull_within(log_tension: Array, some: Integers) -> tuple[Array, Flags]:
            tension, rows = np.exp(log_tension), rest[some]
            found = self._carried(rows, tension, limit[rows])
            return -tension * np.expm1(-found), np.isfinite(found)

        searched = search_least(pull_within, pull[rest], top[rest])
        self.found[rest, row.LEAST_SLACK] = searched.least - pull[rest]
        self.found[rest, row.MOST_PULL] = searched.most
        self.left[rest[~searched.good]] |= capacity.LEAST

    def _find_gross(self, live: Integers, parts: int) -> None:
        """Gross slip, and the breakaways that follow from it."""
        block = self.block.rows(live)
        top, wrap = self.tight[live] / block.area, block.length / block.radius
        falls = self.of_input("steepest_fall")[live] < 0.0
        ratio = self.log_ratio[live]
        if not parts & capacity.CAPACITIES:
            beyond = breaks_away(block.laws, top, wrap, ratio)
            self.found[live[beyond], row.OUTCOME] = BREAKAWAY
            return
        most = ratio_at_gross_slip(block.laws, top, wrap)
        self.found[live[ratio >= most], row.OUTCOME] = BREAKAWAY
        creep = np.full(len(live), np.inf)
        softening = np.flatnonzero(falls)
        if len(softening):
            most[softening], creep[softening] = self._largest(live[softening])
        self.found[live, row.GROSS_CAPACITY], self.found[live, row.GROSS_CREEP] = most, creep
        # what it may cap is not known without it
        capped = capacity.GROSS_SLIP | capacity.CREEP_LIMIT | capacity.TESTED_SLIP
        self.left[live[~np.isfinite(most)]] |= capped & parts

    def _largest(self, which: Integers) -> tuple[Array, Array]:
        """Largest ratio of laws that fall past their peak, and the creep there: inf without one.

        With more and more creep friction falls to its residual all along the arc. More than that is
        carried at some creep only if the friction that is left over from the peak outweighs what
        the rise lacks, int (mu - mu_residual) dx > 0 from the overrun on: more creep comes late,
        where the belt is slack.
        """
        outweighs, most = self.outweighs(which)
        creep = np.full(len(which), np.inf)
        rows = np.flatnonzero(outweighs)
        if len(rows):
            found, where = self._peak(which[rows], most[rows])
            higher = ~(found <= most[rows])  # also where it is not found
            most[rows[higher]], creep[rows[higher]] = found[higher], where[higher]
        return most, creep

    def outweighs(self, which: Integers) -> tuple[Flags, Array]:
        """Where some creep may carry more than what is left of friction, and what that carries."""
        block, tight = self.block.rows(which), self.tight[which]
        top, wrap = tight / block.area, block.length / block.radius
        most = ratio_at_gross_slip(block.laws, top, wrap, residual=True)
        found = np.zeros(len(which), dtype=bool)
        for share in np.linspace(0.0, 1.0, PRESSURES):
            tension = tight * np.exp(-share * most)
            p, start = tension / block.area, np.abs(block.overrun(tension)[0])
            found |= block.laws.excess(p) + start * block.laws.residual(p) > 0.0
        return found, most

    def _peak(self, which: Integers, residual: Array) -> tuple[Array, Array]:
        """Largest ratio among creeps around that of the peak and of the shrinkage, and its creep.

        -inf at the least of the creeps looked at; nan at the largest, or where one of them fails.
        """
        block, tight = self.block.rows(which), self.tight[which]
        first = mean_creep(block, tight, tight * np.exp(-10.0), ON_THE_RISE)
        slack = tight * np.exp(-residual)
        entry = np.where(block.side > 0.0, tight, slack)
        shrinks = block.compliance * block.length * (entry - (tight - slack) / residual)
        first = np.maximum(first, block.side * (shrinks + block.overrun(entry)[0]))
        creeps = np.array(CREEPS)[:, None] * first
        ratios = np.stack([self._carried(which, tight, creep) for creep in creeps])
        best = np.nan_to_num(ratios, nan=-np.inf).argmax(axis=0)
        three = np.clip(best, 1, len(CREEPS) - 2) + np.array([[-1], [0], [1]])
        x = np.take_along_axis(np.log(creeps), three, 0)
        y = np.take_along_axis(ratios, three, 0)
        for _ in range(NEARER):
            at = crown(x, y)
            x, y = narrowed(x, y, at, self._carried(which, tight, np.exp(at)))
        known = np.isfinite(ratios).all(axis=0) & (best < len(CREEPS) - 1)
        found = np.where(best > 0, y[1], -np.inf)
        return np.where(known, found, np.nan), np.exp(x[1])

    def _cap_by_gross(self, parts: int) -> None:
        """Where creep or slip reach the limit past the largest ratio, that ratio is what counts."""
        known = np.isfinite(self.found[:, row.GROSS_CAPACITY])
        creep = np.where(known, self.found[:, row.GROSS_CREEP], np.nan)
        for limit, place, part in (
            ("creep_limit", row.CREEP_CAPACITY, capacity.CREEP_LIMIT),
            ("slip_max", row.SLIP_CAPACITY, capacity.TESTED_SLIP),
        ):
            capped = creep <= self.of_input(limit)  # False where either is nan
            if parts & part:
                self.found[capped, place] = self.found[capped, row.GROSS_CAPACITY]
                self.left[capped] &= ~part
