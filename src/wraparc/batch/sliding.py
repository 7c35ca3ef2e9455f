"""The pull at which belts slide, for many arcs at once: the same numbers as `arc.sliding`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, cast

import numpy as np

from wraparc.arc.capacity import CREEP_LIMIT as BY_CREEP
from wraparc.arc.capacity import GROSS_SLIP as BY_LAW
from wraparc.arc.capacity import TESTED_SLIP as BY_SLIP
from wraparc.arc.quantities import BREAKAWAY, SOLVED
from wraparc.arc.sliding import (
    ALIKE,
    CREEP,
    DIFFERENCE,
    EARLY,
    FARTHEST,
    LEAST_CARRIED,
    MOST,
    NOT_CARRIED,
    ROUNDS,
    SLIDES,
    TESTED,
)
from wraparc.arrays import Array, Codes, Flags, Integers
from wraparc.batch import row
from wraparc.batch.arcs import Arcs, present
from wraparc.batch.gross_slip import ratio_at_gross_slip
from wraparc.batch.result import COLUMNS, BatchResult
from wraparc.batch.rows import AtLimit, OnLine, carried_on, may_peak, solve_rows
from wraparc.batch.scaled import Unscaled, solve_scaled
from wraparc.batch.setting import Setting
from wraparc.batch.solve import CHUNK
from wraparc.batch.traction import Laws
from wraparc.drive.pull import idle_rows

#: Fall of friction over the stiffness of the lagging that refuses no arc [-].
_UNREFUSED = 1e-3
#: Last step over the place, over the accuracy of the arcs.
_NEAR = 10.0  # the last step of a secant leaves its square


@dataclass(frozen=True, eq=False, kw_only=True)
class _Sought(Unscaled):
    """Arcs at tensions that a search tries, far beyond those of the drive.

    As of one arc, the fall of friction at such a pressure refuses none of them.
    """

    peaks: Flags

    def rows(self, which: slice | Integers) -> Arcs:
        """Return some of the arcs."""
        return replace(cast(_Sought, super().rows(which)), peaks=self.peaks[which])

    def inputs(self) -> Array:
        """Numbers of every arc that a kernel reads."""
        given = super().inputs()
        tight = np.maximum(self.entry_tension, self.exit_tension)
        shear = self.shear_compliance * tight / (0.5 * self.belt_width * self.diameter)
        at = row.INPUTS.index("steepest_fall")
        gentle = -_UNREFUSED / np.maximum(shear, _UNREFUSED)  # of any fall the sign is asked alone
        given[:, at] = np.where(self.peaks, np.maximum(given[:, at], gentle), 0.0)
        return given


@dataclass(frozen=True, eq=False, kw_only=True)
class LoadedRows:
    """Arcs that are asked when their belts slide, see `arc.sliding.Loaded`.

    Attributes
    ----------
    arcs
        The arcs, with the unscaled laws.
    friction_factor, slip_factor
        Factors on the friction and the slips of their laws, shape (n,) [-].
    peaks
        Whether friction may have its largest ratio at some creep, shape (n,).
    setting
        How accurately.
    """

    arcs: Arcs
    friction_factor: Array
    slip_factor: Array
    peaks: Flags
    setting: Setting = Setting.ENGINEERING

    @classmethod
    def of(cls, arcs: Arcs, **more: Any) -> LoadedRows:
        """Return arcs of which nothing more is known; tensions are those above m v^2."""
        arcs = arcs.light()
        one, every = np.ones(len(arcs)), np.ones(len(arcs), dtype=bool)
        given = {"friction_factor": one, "slip_factor": one, "peaks": every, **more}
        of = cls(**given, arcs=arcs)
        return replace(of, peaks=may_peak(of._unscaled()))

    def rows(self, which: Integers) -> LoadedRows:
        """Return some of the rows."""
        return replace(
            self,
            arcs=self.arcs.rows(which),
            friction_factor=self.friction_factor[which],
            slip_factor=self.slip_factor[which],
            peaks=self.peaks[which],
        )

    def _of_laws(self, tight: Array, of: Callable[[Laws, Array, Integers], Array]) -> Array:
        """Something of the laws at the wrap pressures of tight sides, kind by kind, (n,)."""
        arcs, found = self.arcs, np.empty(len(tight))
        pressure = 2.0 * tight / (arcs.belt_width * arcs.diameter)
        for at in arcs.by_kind():
            found[at] = of(arcs.laws.traction(arcs.law[at]), pressure[at], at)
        return found

    def plateau(self, tight: Array) -> Array:
        """ln(tight/slack) with the largest friction everywhere, shape (n,) [-]."""
        # the plateau of f mu over an angle is that of mu over f times the angle
        wrap = self.arcs.traction_wrap * self.friction_factor
        with np.errstate(all="ignore"):  # rows without a tension become nan
            return self._of_laws(tight, lambda laws, p, at: ratio_at_gross_slip(laws, p, wrap[at]))

    def carried(self, tight: Array) -> tuple[Array, Codes]:
        """Largest ln(tight/slack) with tight sides held [N], and what comes first, (n,) each."""
        arcs, n = self.arcs, len(tight)
        driving = arcs.entry_tension >= arcs.exit_tension
        given = self._unscaled(
            entry_tension=np.where(driving, tight, 0.5 * tight),
            exit_tension=np.where(driving, 0.5 * tight, tight),
        )
        found = np.full((n, row.FOUND_NUMBERS), np.nan)
        parts = np.where(self.peaks, BY_CREEP + BY_SLIP + BY_LAW, BY_CREEP + BY_SLIP)
        parts[~self.peaks & (self._creep_at_end(tight) < EARLY * SLIDES)] = BY_SLIP
        for part in present(parts):
            which = np.flatnonzero(parts == part)
            for begin in range(0, n, CHUNK):
                some = which[begin : begin + CHUNK]
                if len(some):
                    found[some] = solve_rows(given.rows(some), part, self.setting.accuracy)[0]
        q, slip = found[:, row.CREEP_CAPACITY], found[:, row.SLIP_CAPACITY]
        near = 1.0 - max(ALIKE, self.setting.accuracy)
        first = np.isnan(q) | (slip < q * near)
        q = np.where(first, slip, q)
        most = (q >= self.plateau(tight) * near) | (
            self.peaks & (q >= found[:, row.GROSS_CAPACITY] * near)
        )
        return q, np.where(most, MOST, np.where(first, TESTED, CREEP)).astype(np.int8)

    def _unscaled(self, **tensions: Array) -> _Sought:
        """Return the arcs with the creep of sliding for their limit."""
        columns: dict[str, Any] = dict(self.arcs.columns()) | tensions
        columns["creep_limit"] = np.full(len(self.arcs), SLIDES)
        f, s = self.friction_factor, self.slip_factor
        laws, law = self.arcs.laws, self.arcs.law
        columns |= {"friction_factor": f, "slip_factor": s, "peaks": self.peaks}
        return _Sought(laws=laws, law=law, **columns)

    def at_limits(self, on: OnLine) -> list[tuple[int, Integers, AtLimit]]:
        """Return what ends the grip of laws that do not fall, the rows of it, and the arcs there.

        See `arc.sliding`; every row has at least one of them.
        """
        given = self._unscaled()
        tight = np.maximum(self.arcs.entry_tension, self.arcs.exit_tension)
        tests_end_first = self._creep_at_end(tight) < EARLY * SLIDES
        tested = np.isfinite(self.arcs.laws.tested[self.arcs.law].T[2])
        slips, creeps = (np.flatnonzero(of & ~self.peaks) for of in (tested, ~tests_end_first))
        which = np.concatenate([slips, creeps])
        by_slip = np.arange(len(which)) < len(slips)
        parts = []
        for part in np.split(np.arange(len(which)), range(CHUNK, len(which), CHUNK)):
            some = which[part]
            parts.append(
                carried_on(given.rows(some), on.rows(some), by_slip[part], self.setting.accuracy)
            )
        met = AtLimit(*(np.concatenate(column) for column in zip(*parts, strict=True)))
        return [
            (cause, rows, AtLimit(*(column[by_slip == is_slip] for column in met)))
            for cause, rows, is_slip in ((TESTED, slips, True), (CREEP, creeps, False))
        ]

    def _creep_at_end(self, tight: Array) -> Array:
        """Creep where the tests end: their slip and what the lagging shears, shape (n,) [m]."""
        stress = self._of_laws(tight, lambda laws, p, at: laws.plateau(p) * p)
        slip = self.arcs.laws.tested[self.arcs.law].T[2]
        return np.asarray(slip + self.arcs.shear_compliance * self.friction_factor * stress)


@dataclass(eq=False)
class _Lines:
    """Lines of tensions, columns of shape (n,), see `wraparc.arc.gross_slip.Line`."""

    tight: Array
    slack: Array
    tight_rise: Array
    slack_rise: Array

    def at(self, k: Array) -> tuple[Array, Array]:
        return (
            self.tight + (k - 1.0) * self.tight_rise,
            self.slack + (k - 1.0) * self.slack_rise,
        )

    def on(self) -> OnLine:
        """Return what the tensions keep on them."""
        size = np.maximum(np.abs(self.tight_rise), np.abs(self.slack_rise))
        a, b = self.slack_rise / size, -self.tight_rise / size
        least = a * (self.tight - self.tight_rise) + b * (self.slack - self.slack_rise)
        return OnLine(a, b, least)

    def place(self, met: AtLimit) -> Array:
        """Return where tensions lie on them; nan where their ratio does not grow along them."""
        by_tight = (met.tight - self.tight) / self.tight_rise
        by_slack = (met.slack - self.slack) / self.slack_rise
        more = np.abs(self.tight_rise) >= np.abs(self.slack_rise)
        grows = self.tight_rise * met.slack > self.slack_rise * met.tight
        return np.where(grows, 1.0 + np.where(more, by_tight, by_slack), np.nan)

    def rows(self, which: Integers) -> _Lines:
        return _Lines(
            self.tight[which], self.slack[which], self.tight_rise[which], self.slack_rise[which]
        )


def slides_of(solved: BatchResult) -> tuple[Array, Codes]:
    """Return the safety against gross slip of solved arcs and what comes first, (n,) each.

    As `wraparc.arc.ArcResult.gross_slip_safety`: inf of a pulley that pulls nothing, less than 1 in
    gross slip, nan where the arc is not solved or the place is not found.
    """
    if "slides" not in solved.known:
        solved.known["slides"] = _slides_of(solved)
    factor, cause = solved.known["slides"]
    return factor, cause


#: Asked of the arcs anew, which a column of results cannot do.
COLUMNS["gross_slip_safety"] = lambda solved: slides_of(solved)[0]


def _slides_of(solved: BatchResult) -> tuple[Array, Codes]:
    """Work out `slides_of`."""
    arcs, status, n = solved.arcs, solved["status"], len(solved.arcs)
    one, entry, leaving = np.ones(n), arcs.entry_tension, arcs.exit_tension
    idle = idle_rows(entry, leaving) & (status == SOLVED)
    factor, cause = np.full(n, np.nan), np.full(n, CREEP, dtype=np.int8)
    factor[idle] = np.inf
    friction, slip = (
        one if of is None else of for of in (solved.friction_factor, solved.slip_factor)
    )
    of = LoadedRows.of(arcs, friction_factor=friction, slip_factor=slip, setting=solved.setting)
    of = replace(of, peaks=of.peaks & ~np.isposinf(solved["gross_slip_creep"]))
    tight = np.abs(entry - leaving) if solved.tight_rise is None else solved.tight_rise
    slack = np.zeros(n) if solved.slack_rise is None else solved.slack_rise
    answered = ((status == SOLVED) | (status == BREAKAWAY)) & ~np.isnan(tight + slack)
    which = np.flatnonzero(answered & ~idle)
    factor[which], cause[which] = pulls_at_sliding(of.rows(which), (tight[which], slack[which]))
    gone = answered & (status == BREAKAWAY)
    factor[gone] = np.minimum(factor[gone], NOT_CARRIED)
    return factor, cause


def pulls_at_sliding(of: LoadedRows, rises: tuple[Array, Array]) -> tuple[Array, Codes]:
    """Pull at which each belt slides over its pull [-], and what comes first there, (n,) each.

    As `arc.sliding.pull_at_sliding`; inf where it never slides, nan where that is not found.
    """
    arcs = of.arcs
    tight = np.maximum(arcs.entry_tension, arcs.exit_tension)
    slack = np.minimum(arcs.entry_tension, arcs.exit_tension)
    place, cause = np.full(len(tight), np.inf), np.full(len(tight), CREEP, dtype=np.int8)
    pulls = np.flatnonzero(tight != slack)
    lines = _Lines(tight[pulls], slack[pulls], rises[0][pulls], rises[1][pulls])
    pulled = of.rows(pulls)
    with np.errstate(all="ignore"):
        place[pulls], cause[pulls] = _first_places(pulled, lines)
    rest = np.flatnonzero(np.isnan(place[pulls]))
    start, low = np.ones(len(rest)), np.zeros(len(rest))
    found = _places(pulled.rows(rest), lines.rows(rest), 1.0, low, start)
    place[pulls[rest]], cause[pulls[rest]] = found
    return place, cause


def _first_places(of: LoadedRows, lines: _Lines) -> tuple[Array, Codes]:
    """`arc.sliding.pull_at_sliding` by one solution a limit; nan where one is not met so."""
    n = len(lines.tight)
    near = 1.0 - max(ALIKE, of.setting.accuracy)
    place, cause = np.full(n, np.inf), np.full(n, CREEP, dtype=np.int8)
    missed = of.peaks.copy()
    for limit, which, met in of.at_limits(lines.on()):
        there = lines.rows(which).place(met)
        most = np.log(met.tight / met.slack) >= of.rows(which).plateau(met.tight) * near
        first = there < place[which] * near
        cause[which[first]] = np.where(most, MOST, limit)[first]
        place[which[first]] = there[first]
        missed[which[~(there > 0.0)]] = True
    return np.where(missed, np.nan, place), cause


def tight_at_sliding(of: LoadedRows, pull: Array) -> Array:
    """Least tension above m v^2 of each tight side that slides no belt of a pull [N], (n,).

    As `arc.sliding.tight_at_sliding`.
    """
    one, needed, missed = np.ones(len(pull)), np.zeros(len(pull)), of.peaks.copy()
    for _, which, met in of.at_limits(OnLine(one, -one, pull)):
        found = (met.grows > 0.0) & (met.tight <= FARTHEST * pull[which])
        needed[which[found]] = np.maximum(needed[which], met.tight)[found]
        missed[which[~found]] = True
    rest = np.flatnonzero(missed)
    of, pull = of.rows(rest), pull[rest]
    tight = np.maximum(of.arcs.entry_tension, of.arcs.exit_tension)
    lines = _Lines(pull, np.zeros(len(pull)), pull, pull)
    start = np.maximum(tight / pull, 1.0 + 1e-6)
    needed[rest] = pull * _places(of, lines, -1.0, np.ones(len(pull)), start)[0]
    return needed


def _places(
    of: LoadedRows, lines: _Lines, way: float, low: Array, start: Array
) -> tuple[Array, Codes]:
    """`arc.sliding.slide_place` of every row, all rows a step at a time."""
    n = len(start)
    near = _NEAR * of.setting.accuracy
    falls = lines.slack_rise < 0.0
    even = falls | (way < 0.0)
    a, b, k = low.copy(), np.full(n, np.inf), start.copy()
    with np.errstate(divide="ignore", invalid="ignore"):
        no_slack = 1.0 - lines.slack / lines.slack_rise
        b = np.where(falls, no_slack, b)
        a = np.where(lines.slack_rise > 0.0, np.maximum(a, no_slack), a)
    k = np.where(k >= b, 0.5 * (a + b), k)
    last, spare_last = np.full(n, np.nan), np.full(n, np.nan)
    place, cause = np.full(n, np.nan), np.full(n, CREEP, dtype=np.int8)
    live = np.arange(n)
    for _ in range(ROUNDS):
        if not len(live):
            break
        at = lines.rows(live)
        here, x = of.rows(live), k[live]
        tight = at.at(x)[0]
        q, cause[live] = here.carried(tight)
        with np.errstate(all="ignore"):
            where, spare, slope = _spare(here, at, x, q, even[live])
            secant = (spare - spare_last[live]) / (where - last[live])
            slope = np.where(np.isfinite(secant), secant, slope)
            slides = (spare < 0.0) == (way > 0.0)
            b[live] = np.where(slides, x, b[live])
            a[live] = np.where(slides, a[live], x)
            last[live], spare_last[live] = where, spare
            new = np.where(way * slope < 0.0, where - spare / slope, np.inf)
            new = np.where(even[live], new, np.exp(np.minimum(new, 30.0)))
            met = np.abs(new - x) <= near * x
            low_end, high_end = a[live], b[live]
            held = np.minimum(new, FARTHEST)
            middle = np.where(
                high_end < np.inf,
                0.5 * (low_end + high_end),
                np.minimum(4.0 * x + 1.0, FARTHEST),
            )
            held = np.where((low_end < held) & (held < high_end), held, middle)
        never = ~slides & (x >= FARTHEST)
        stuck = np.abs(held - x) <= 1e-14 * x
        done = met | never | stuck | np.isnan(q)
        ends = np.where(never, np.inf, np.where(met, new, held))
        place[live[done]] = np.where(np.isnan(q), np.nan, ends)[done]
        k[live] = held
        live = live[~done]
    place[live] = k[live]
    return place, cause


def _spare(
    of: LoadedRows, at: _Lines, k: Array, q: Array, even: Flags
) -> tuple[Array, Array, Array]:
    """What friction has to spare at places of lines, over what, and about its slope."""
    tight, slack = at.at(k)
    kept = np.exp(-q)
    asked = np.log(tight / slack)
    here = of.plateau(tight)
    there = of.plateau(tight * (1.0 + DIFFERENCE))
    fall = (there - here) / (here * DIFFERENCE) * k * at.tight_rise / tight
    grows = k * (at.tight_rise / tight - at.slack_rise / slack) / asked
    return (
        np.where(even, k, np.log(k)),
        np.where(even, slack - tight * kept, np.log(np.maximum(q, LEAST_CARRIED) / asked)),
        np.where(even, at.slack_rise - at.tight_rise * kept, fall - grows),
    )


def wet_creeps(
    arcs: Arcs, wet: Array, factors: tuple[Array, Array], setting: Setting = Setting.ENGINEERING
) -> Array:
    """Return creeps at the exit with factors on the friction, shape (n,) [m].

    Parameters
    ----------
    arcs
        The arcs.
    wet
        Wet friction over dry friction, shape (n,); nan if not known [-].
    factors
        Factors on the dry friction and on the slips of the laws, shape (n,) each [-].
    setting
        How accurately.

    Returns
    -------
    Infinite in gross slip, nan without a factor.
    """
    found, known = np.full(len(arcs), np.nan), np.flatnonzero(wet > 0.0)
    if len(known) == 0:
        return found
    friction, slip = (factor[known] for factor in factors)
    again = solve_scaled(
        arcs.rows(known), friction * wet[known], slip, setting=setting, parts=row.RATIO
    )
    found[known] = np.where(again.solved, np.abs(again["exit_creep"]), np.inf)
    return found
