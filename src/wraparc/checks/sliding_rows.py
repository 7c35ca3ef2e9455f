"""The pull at which belts slide, for many arcs at once: the same numbers as `checks.sliding`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.capacity import CREEP_LIMIT as BY_CREEP
from wraparc.arc.capacity import GROSS_SLIP as BY_LAW
from wraparc.arc.capacity import TESTED_SLIP as BY_SLIP
from wraparc.batch import Setting, row
from wraparc.batch.arcs import Arcs
from wraparc.batch.gross_slip import ratio_at_gross_slip
from wraparc.batch.rows import solve_rows
from wraparc.batch.scaled import Unscaled
from wraparc.batch.solve import CHUNK
from wraparc.batch.traction import Laws
from wraparc.checks.sliding import (
    ALIKE,
    CREEP,
    DIFFERENCE,
    EARLY,
    FARTHEST,
    MOST,
    ROUNDS,
    SLIDES,
    TESTED,
)

Array = NDArray[np.float64]
Codes = NDArray[np.int8]
Integers = NDArray[np.int64]

#: Last step over the place, over the accuracy of the arcs.
_NEAR = 10.0  # the last step of a secant leaves its square


@dataclass(frozen=True, eq=False, kw_only=True)
class LoadedRows:
    """Arcs that are asked when their belts slide, see `checks.sliding.Loaded`.

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
    peaks: NDArray[np.bool_]
    setting: Setting = Setting.ENGINEERING

    @classmethod
    def of(cls, arcs: Arcs, **more: Any) -> LoadedRows:
        """Return arcs of which nothing more is known; tensions are those above m v^2."""
        arcs = arcs.light()
        one = np.ones(len(arcs))
        falls = arcs.laws.steepest_fall[arcs.law] < 0.0
        return cls(
            **{"friction_factor": one, "slip_factor": one, "peaks": falls, **more}, arcs=arcs
        )

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
        kinds = arcs.laws.kind[arcs.law]
        for kind in np.unique(kinds).tolist():
            at = np.flatnonzero(kinds == kind)
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
        columns: dict[str, Any] = dict(arcs.columns()) | {
            "entry_tension": np.where(driving, tight, 0.5 * tight),
            "exit_tension": np.where(driving, 0.5 * tight, tight),
            "creep_limit": np.full(n, SLIDES),
        }
        f, s = self.friction_factor, self.slip_factor
        given = Unscaled(laws=arcs.laws, law=arcs.law, friction_factor=f, slip_factor=s, **columns)
        found = np.full((n, row.FOUND_NUMBERS), np.nan)
        parts = np.where(self.peaks, BY_CREEP + BY_SLIP + BY_LAW, BY_CREEP + BY_SLIP)
        parts[~self.peaks & (self._creep_at_end(tight) < EARLY * SLIDES)] = BY_SLIP
        for part in np.unique(parts).tolist():
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

    def rows(self, which: Integers) -> _Lines:
        return _Lines(
            self.tight[which], self.slack[which], self.tight_rise[which], self.slack_rise[which]
        )


def pulls_at_sliding(of: LoadedRows, rises: tuple[Array, Array]) -> tuple[Array, Codes]:
    """Pull at which each belt slides over its pull [-], and what comes first there, (n,) each.

    As `checks.sliding.pull_at_sliding`; inf where it never slides, nan where that is not found.
    """
    arcs = of.arcs
    tight = np.maximum(arcs.entry_tension, arcs.exit_tension)
    slack = np.minimum(arcs.entry_tension, arcs.exit_tension)
    place, cause = np.full(len(tight), np.inf), np.full(len(tight), CREEP, dtype=np.int8)
    pulls = np.flatnonzero(tight != slack)
    lines = _Lines(tight[pulls], slack[pulls], rises[0][pulls], rises[1][pulls])
    start, low = np.ones(len(pulls)), np.zeros(len(pulls))
    place[pulls], cause[pulls] = _places(of.rows(pulls), lines, 1.0, low, start)
    return place, cause


def tight_at_sliding(of: LoadedRows, pull: Array) -> Array:
    """Least tension above m v^2 of each tight side that slides no belt of a pull [N], (n,).

    As `checks.sliding.tight_at_sliding`.
    """
    tight = np.maximum(of.arcs.entry_tension, of.arcs.exit_tension)
    lines = _Lines(pull, np.zeros(len(pull)), pull, pull)
    start = np.maximum(tight / pull, 1.0 + 1e-6)
    return pull * _places(of, lines, -1.0, np.ones(len(pull)), start)[0]


def _places(
    of: LoadedRows, lines: _Lines, way: float, low: Array, start: Array
) -> tuple[Array, Codes]:
    """`checks.sliding.slide_place` of every row, all rows a step at a time."""
    n = len(start)
    near = _NEAR * of.setting.accuracy
    falls = lines.slack_rise < 0.0
    even = falls | (way < 0.0)
    a, b, k = low.copy(), np.full(n, np.inf), start.copy()
    with np.errstate(divide="ignore", invalid="ignore"):
        b = np.where(falls, 1.0 - lines.slack / lines.slack_rise, b)
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
    of: LoadedRows, at: _Lines, k: Array, q: Array, even: NDArray[np.bool_]
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
        np.where(even, slack - tight * kept, np.log(q / asked)),
        np.where(even, at.slack_rise - at.tight_rise * kept, fall - grows),
    )
