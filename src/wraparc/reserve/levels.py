"""The level of the whole verdict on a drive with one input changed, for many changes at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import inf, nan
from typing import NamedTuple

import numpy as np

from wraparc.arc import Distributed
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import Setting
from wraparc.checks.check import Check, Level, Place, margin_to
from wraparc.checks.judge import judge
from wraparc.checks.of_arc import CREEP_INTERVAL, EXIT_CREEP, GROSS_SLIP
from wraparc.checks.of_drive import meeting, take_up
from wraparc.checks.of_rows import OF_ROWS, SOLVE_ANEW, Wanted
from wraparc.checks.of_wet import WET_CREEP
from wraparc.checks.rule import Rule
from wraparc.checks.usual import least_margin
from wraparc.checks.variant_rows import DESCRIBED, KNOWN, JudgedRows, VariantArcs, VariantRows
from wraparc.drive import Drive, LoadCase
from wraparc.errors import InputError
from wraparc.reserve.inputs import CARCASS, OF_DRIVES, PULL, SLACK, Input, change_drive, lift_of
from wraparc.train import Pulls, TrainResult
from wraparc.train.whole import Whole, by_pulley, solved

#: Ranks of what has no level: not known by rows, and no drive.
UNKNOWN, IMPOSSIBLE = -1, -2
#: Checks of tensions alone that rows do not make.
TENSION_CHECKS = frozenset({"take_up", "meeting"})
#: Least and largest factor that an input is changed by [-].
FACTORS = (0.5, 2.0)
#: Margin of a check from which on it stays the same between rows that are close together [-].
FAR = 0.1
#: The checks of a verdict, those of rows and of the interval of fitted laws; of them those that
#: solve arcs anew.
JUDGED, ANEW = (*OF_ROWS, CREEP_INTERVAL), (*SOLVE_ANEW, CREEP_INTERVAL)
RULES = {rule.name: place for place, rule in enumerate(JUDGED)}
_OF_SOLVED = [place for place, rule in enumerate(JUDGED) if rule not in DESCRIBED]


class Levels(NamedTuple):
    """Levels of n rows, and what they are made of.

    Attributes
    ----------
    rank
        Of the level of the whole verdict, `UNKNOWN` or `IMPOSSIBLE`, shape (n,).
    ranks, margins
        Of every check (`JUDGED`) at every place, and how far its value is from the limit, over it:
        positive where it passes; infinite where nothing is compared; shape (checks, places, n).
    others
        Rank of the level of what rows do not check, shape (n,).
    """

    rank: Integers
    ranks: Integers
    margins: Array
    others: Integers

    def rows(self, which: Integers) -> Levels:
        """Return some of the rows."""
        rank, ranks, margins, others = self
        return Levels(rank[which], ranks[..., which], margins[..., which], others[which])

    def put(self, which: Integers, others: Levels) -> None:
        """Take other rows in the place of some."""
        for name in self._fields:
            getattr(self, name)[..., which] = getattr(others, name)

    @classmethod
    def joined(cls, every: Sequence[Levels]) -> Levels:
        """Return the rows of several below each other."""
        return cls(
            np.concatenate([of.rank for of in every]),
            np.concatenate([of.ranks for of in every], axis=-1),
            np.concatenate([of.margins for of in every], axis=-1),
            np.concatenate([of.others for of in every]),
        )

    @classmethod
    def of(cls, ranks: Integers, margins: Array, others: Integers, possible: Flags) -> Levels:
        """Return the levels of rows by the ranks of their checks."""
        worst = ranks.max(axis=(0, 1))
        total = np.maximum(np.maximum(worst, others), Level.OK.rank)
        total = np.where(worst >= Level.FAULT.rank, UNKNOWN, total)
        return cls(np.where(possible, total, IMPOSSIBLE), ranks, margins, others)


class LevelRows:
    """Finds levels of a drive with one input changed in each row.

    Parameters
    ----------
    drive
        As it is, each pulley at the tensions that the load divides into.
    inputs
        What is changed, between `FACTORS`.
    constant
        Rank of what does not change: the checks that are made of no row.
    meets
        Whether neighbouring pulleys give tensions of their own.
    """

    def __init__(
        self, drive: Drive, inputs: tuple[Input, ...], constant: int, *, meets: bool
    ) -> None:
        self.drive, self.inputs, self._constant, self._meets = drive, inputs, constant, meets
        self._drives: dict[tuple[Input, float], Drive | None] = {}
        self._now = self._described(drive)
        self._varies = [self._varies_with(of) for of in inputs]
        #: Pulley and load case of every place, by name.
        self.places = tuple((p.name, c.name) for c in drive.load_cases for p in drive.pulleys)
        #: Margin of every check at every place beyond which a drive fails, nan where none is known.
        self.fails_at = np.full((len(JUDGED), len(self.places)), nan)

    def __call__(
        self,
        which: Integers,
        factors: Array,
        setting: Setting,
        ends: tuple[Levels, Levels] | None = None,
    ) -> Levels:
        """Return the levels with factors on inputs, by their places, shape (n,) each.

        Where `ends` has a lower and a higher factor of each row, a check that solves arcs anew is
        not made again where it is the same at both, and by far, and no arc of a place is solved
        where all checks of it are; nothing is where no check of what is solved changes.
        """
        if ends is None:
            return self._solve(which, factors, setting, {})[0]
        if self.are_described(*ends).all():
            return self._describe(which, factors, ends[0])
        near, same = ends[0], _constant_checks(*ends, self.fails_at)
        every = [flags.all(axis=1) for flags in same.values()]
        closed = np.logical_and.reduce(every)
        open_ = np.flatnonzero(~closed)
        wanted = {rule: ~same[rule][open_] for rule in ANEW}
        solved, _, judged = self._solve(which, factors, setting, wanted, open_)
        found = self._describe(which, factors, near)
        for rule, flags in same.items():
            place, anew = RULES[rule.name], ~flags
            anew[closed] = False
            found.ranks[place][anew] = solved.ranks[place][anew]
            found.margins[place][anew] = solved.margins[place][anew]
        return Levels.of(*found[1:], (found.rank > IMPOSSIBLE) & judged.possible)

    @staticmethod
    def are_described(near: Levels, far: Levels) -> Flags:
        """Return where no check of what is solved changes between two ends, shape (n,)."""
        return np.asarray((near.ranks == far.ranks)[_OF_SOLVED].all(axis=(0, 1)))

    def _describe(self, which: Integers, factors: Array, near: Levels) -> Levels:
        """Return levels by what is described alone, all else as it is near by."""
        margins, others = self._described_rows(which, factors)
        judged = self._variants(which, factors, margins).arcs().check_described()
        ranks, rule_margins = near.ranks.copy(), near.margins.copy()
        for check in judged.checks:
            place = RULES[check.rule.name]
            ranks[place] = judged.by_place(check.rank)
            rule_margins[place] = judged.by_place(check.margin)
        possible = judged.possible & (others > IMPOSSIBLE)
        others = np.maximum(others, self._constant)
        return Levels.of(ranks, rule_margins, others, possible)

    def slide_later(
        self, which: Integers, factors: Array, setting: Setting, sliding: Flags
    ) -> tuple[Levels, Callable[[Integers], tuple[Integers, Array]]]:
        """Return the same, the safety against gross slip of some rows alone, and what finds others.

        That takes rows, and returns ranks and margins of shape (places, n).
        """
        wanted = {GROSS_SLIP: np.tile(sliding, (len(self.places), 1))}
        found, arcs, judged = self._solve(which, factors, setting, wanted)

        def slide(rows: Integers) -> tuple[Integers, Array]:
            check = arcs.check_gross_slip(judged.solved, rows)
            shape = len(self.places), len(rows)
            return check.rank.astype(np.int64).reshape(shape), check.margin.reshape(shape)

        return found, slide

    def _solve(
        self,
        which: Integers,
        factors: Array,
        setting: Setting,
        wanted: Wanted,
        places: Integers | None = None,
    ) -> tuple[Levels, VariantArcs, JudgedRows]:
        """Return levels by arcs of some places, all unless given, with the arcs and their checks.

        Of the others nothing is compared.
        """
        margins, others = self._described_rows(which, factors)
        arcs = self._variants(which, factors, margins).arcs()
        if places is None:
            places = np.arange(len(self.places))
        else:
            arcs = arcs.at_places(places)
        judged = arcs.judge(setting, JUDGED, wanted)
        shape = (len(JUDGED), len(self.places), len(which))
        ranks, margins = np.zeros(shape, dtype=np.int64), np.full(shape, inf)
        for check in judged.checks:
            place = RULES[check.rule.name]
            ranks[place][places] = judged.by_place(check.rank)
            margins[place][places] = judged.by_place(check.margin)
            limit: Array = judged.by_place(check.limit)[:, 0]
            beyond = np.full(len(limit), check.rule.fails_beyond)
            with np.errstate(invalid="ignore", divide="ignore"):
                ends = margin_to(beyond, limit, at_most=check.rule.at_most)
                self.fails_at[place][places] = ends
        _miss_wet(ranks, margins)
        possible = judged.possible & (others > IMPOSSIBLE)
        others = np.maximum(others, self._constant)
        return Levels.of(ranks, margins, others, possible), arcs, judged

    def known(self, found: Levels, which: Integers, factors: Array) -> Levels:
        """Return levels, those that rows do not solve by the solver of one arc."""
        rank = found.rank.copy()
        for row in np.flatnonzero(rank == UNKNOWN).tolist():
            alone = self.level_of(self.inputs[int(which[row])], float(factors[row]))
            rank[row] = UNKNOWN if alone >= Level.FAULT.rank else alone
        return found._replace(rank=rank)

    def is_firm(self, rule: Rule) -> bool:
        """Return whether a drive fails that misses a check."""
        return rule.firm is not None and rule.firm(self.drive)

    def level_of(self, changed: Input, factor: float) -> int:
        """Return the rank of the level with one change, by the solver of one arc."""
        try:
            of = change_drive(self.drive, changed, factor)
            result = solved(of, Distributed(capacities=False))
        except InputError:
            return IMPOSSIBLE
        # between pulleys of a divided load tensions differ by more than rows know
        checks = (c for c in judge(result).checks if self._meets or c.name != "meeting")
        return max([c.level.rank for c in checks] + [self._constant, Level.OK.rank])

    def _variants(self, which: Integers, factors: Array, odd: Array) -> VariantRows:
        """Return the rows of changes."""
        n, names = len(which), [p.name for p in self.drive.pulleys]
        lift, pull, columns = np.zeros(n), np.ones(n), dict[str, Array]()
        drives, of_row = [self.drive], np.zeros(n, dtype=np.int64)
        ends: dict[str, Array] = {}
        for place, of in enumerate(self.inputs):
            rows = np.flatnonzero(which == place)
            if not len(rows):
                continue
            if of.name == SLACK:
                lift[rows] = (factors[rows] - 1.0) * lift_of(self.drive, 2.0)
            elif of.name == PULL:
                pull[rows] = factors[rows]
            elif of.name in OF_DRIVES:
                for row in rows.tolist():
                    changed = self._changed_drive(of, float(factors[row])) or self.drive
                    if of.name == CARCASS:
                        of_row[row] = len(drives)
                        drives.append(changed)
                        continue
                    for case in changed.load_cases:
                        at = [case.tensions[name] for name in names]
                        shape = 2, len(names), n
                        tensions = ends.setdefault(case.name, np.full(shape, nan))
                        tensions[..., row] = [t.entry for t in at], [t.exit for t in at]
            else:
                column = columns.setdefault(of.name, np.ones((len(names), n)))
                for index in [names.index(name) for name in of.pulleys or names]:
                    column[index, rows] = factors[rows]
        return VariantRows(
            drives=drives, which=of_row, lift=lift, pull=pull, tensions=ends,
            factors=columns, odd=odd,
        )  # fmt: skip

    def _described_rows(self, which: Integers, factors: Array) -> tuple[Array, Integers]:
        """Return least margins of implausible sizes, and ranks of what tensions alone miss.

        `IMPOSSIBLE` where there is no such drive.
        """
        margin, rank = self._now
        margins, ranks = np.full(len(which), margin), np.full(len(which), rank)
        for row in np.flatnonzero(np.array(self._varies)[which]).tolist():
            found = self._changed(self.inputs[which[row]], float(factors[row]))
            margins[row], ranks[row] = (margin, IMPOSSIBLE) if found is None else found
        return margins, ranks

    def _varies_with(self, of: Input) -> bool:
        """Return whether what is described changes with an input.

        Where it is as now at both ends, and nothing is missed now, it is so between them.
        """
        ends = [self._changed(of, factor) for factor in FACTORS]
        return any(end is None or end != self._now for end in ends) or self._now[1] > Level.OK.rank

    def _changed(self, of: Input, factor: float) -> tuple[float, int] | None:
        drive = self._changed_drive(of, factor)
        return None if drive is None else self._described(drive)

    def _changed_drive(self, of: Input, factor: float) -> Drive | None:
        """Return the drive with a factor on an input; None where there is none."""
        key = of, factor
        if key not in self._drives:
            try:
                self._drives[key] = change_drive(self.drive, of, factor)
            except InputError:
                self._drives[key] = None
        return self._drives[key]

    def _described(self, drive: Drive) -> tuple[float, int]:
        """Return the least margin of implausible sizes, and the rank of what tensions miss."""
        ranks = [check.level.rank for check in take_up(drive)]
        if self._meets:
            ranks += [
                check.level.rank for case in drive.load_cases for check in _meetings(case, drive)
            ]
        return least_margin(drive), max(ranks, default=Level.OK.rank)


def _miss_wet(ranks: Integers, margins: Array) -> None:
    """Let the wet creep exceed its limit where the dry creep does and it is not compared.

    The level is the same, and does not seem to be decided by another check there.
    """
    wet, dry = RULES[WET_CREEP.name], RULES[EXIT_CREEP.name]
    known = (ranks[wet] > 0).any(axis=1, keepdims=True)
    hidden = known & (ranks[wet] == 0) & (ranks[dry] > Level.OK.rank)
    ranks[wet][hidden], margins[wet][hidden] = WET_CREEP.missed.rank, -inf


def _constant_checks(near: Levels, far: Levels, fails_at: Array) -> dict[Rule, Flags]:
    """Return where checks of what is solved are the same at both ends of rows, and by far.

    Shape (places, n): far from the limit, and from where a drive fails.
    """
    found = {}
    for place in _OF_SOLVED:
        same = near.ranks[place] == far.ranks[place]
        ends = near.margins[place], far.margins[place]
        for limit in (0.0, np.nan_to_num(fails_at[place])[:, None]):
            above, below = ((of > limit + FAR for of in ends), (of < limit - FAR for of in ends))
            same &= np.logical_and(*above) | np.logical_and(*below)
        found[JUDGED[place]] = same & (np.isinf(ends[0]) == np.isinf(ends[1]))
    return found


def _meetings(case: LoadCase, drive: Drive) -> Iterator[Check]:
    """Yield what is asked about neighbouring pulleys whose tensions differ."""
    for one, other in pairwise(drive.pulleys):
        leaves, enters = case.tensions[one.name].exit, case.tensions[other.name].entry
        yield from meeting(one.name, leaves, other.name, enters, Place(other.name, case.name))


def level_rows(result: Whole, inputs: tuple[Input, ...]) -> LevelRows:
    """Return the levels of a solved drive or train, its inputs changed."""
    constant, meets = constant_rank(result)
    return LevelRows(by_pulley(result).drive, inputs, constant, meets=meets)


def constant_rank(result: Whole) -> tuple[int, bool]:
    """Return the rank of what no row checks, and whether pulleys give tensions of their own."""
    meets = isinstance(result, TrainResult) and all(
        isinstance(case.division, Pulls) for case in result.train.cases
    )
    made = {*KNOWN, CREEP_INTERVAL.name} | (TENSION_CHECKS if meets else {"take_up"})
    missed = [c.level.rank for c in judge(result).checks if c.missed and c.name not in made]
    return max(missed, default=Level.OK.rank), meets
