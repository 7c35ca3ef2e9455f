"""Variants of a drive as rows, judged together: all its pulleys in all its load cases."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.quantities import REFUSED
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import BatchResult, Setting, row
from wraparc.batch.arcs import COLUMNS, Arcs, compression_moduli
from wraparc.batch.interval import Fitted
from wraparc.batch.laws import LawBank
from wraparc.batch.scaled import solve_scaled
from wraparc.checks.of_arc import CREEP_INTERVAL
from wraparc.checks.of_rows import (
    NAMES,
    OF_ROWS,
    SOLVE_ANEW,
    Held,
    RowCheck,
    Wanted,
    gross_slip_of,
    held_by,
    interval_of,
    row_checks,
)
from wraparc.checks.of_train import OF_MOTORS
from wraparc.checks.rule import Rule
from wraparc.checks.rules import ACROSS_CHECKS
from wraparc.drive import Drive, Tensions
from wraparc.drive.pitch import centrifugal_of, strain_ratio

#: Checks that rows make of a drive.
KNOWN = frozenset(NAMES) - ACROSS_CHECKS - {rule.name for rule in OF_MOTORS}
#: Checks of rows that compare nothing that is solved.
DESCRIBED = tuple(rule for rule in OF_ROWS if not rule.result and rule not in SOLVE_ANEW)
#: Factors on the law of a lagging, beside those on columns of arcs.
FRICTION, SLIP = "friction", "slip"
#: Least tension above m v^2 that still is one [N].
_LEAST_TENSION = 1.0


class JudgedRows(NamedTuple):
    """What the judgement of variants comes to.

    Attributes
    ----------
    places
        Pulley and load case, by name.
    checks
        What each rule finds of every arc: those of a place stand together, a row a variant.
    solved
        The arcs, in the same order.
    possible
        Whether there is such a drive, shape (n,).
    """

    places: tuple[tuple[str, str], ...]
    checks: tuple[RowCheck, ...]
    solved: BatchResult
    possible: Flags

    def by_place(self, column: NDArray[Any]) -> NDArray[Any]:
        """Return a column of arcs with a row for each place, shape (places, n)."""
        return np.asarray(column).reshape(len(self.places), -1)


class VariantArcs(NamedTuple):
    """The arcs of variants, a row a variant and those of a place together.

    Attributes
    ----------
    places
        Pulley and load case, by name.
    arcs, held
        The arcs, and what they are held against.
    friction, slip
        Factors on their laws [-].
    possible
        Whether the tensions of a variant are some, shape (n,).
    laws
        Their laws, with the statistics of their fits.
    """

    places: tuple[tuple[str, str], ...]
    arcs: Arcs
    held: Held
    friction: Array
    slip: Array
    possible: Flags
    laws: tuple[Fitted, ...] = ()

    def variants(self, which: Integers) -> VariantArcs:
        """Return some of the variants."""
        starts = np.arange(len(self.places)) * len(self.possible)
        return self._rows((starts[:, None] + which).ravel(), self.possible[which])

    def at_places(self, which: Integers) -> VariantArcs:
        """Return the arcs of some places."""
        n = len(self.possible)
        found = self._rows((which[:, None] * n + np.arange(n)).ravel(), self.possible)
        return found._replace(places=tuple(self.places[place] for place in which.tolist()))

    def check_described(self) -> JudgedRows:
        """Return the checks that need no solution."""
        solved = BatchResult(self.arcs, np.zeros((len(self.arcs), row.FOUND_NUMBERS)))
        factors = self.friction, self.slip
        checks = row_checks(solved, self.held, factors, solved.setting, DESCRIBED)
        return self._possible(tuple(checks), solved)

    def _rows(self, rows: Integers, possible: Flags) -> VariantArcs:
        held, factors = self.held.rows(rows), (self.friction[rows], self.slip[rows])
        return VariantArcs(self.places, self.arcs.rows(rows), held, *factors, possible, self.laws)

    def judge(
        self,
        setting: Setting = Setting.ENGINEERING,
        rules: Sequence[Rule] = OF_ROWS,
        wanted: Wanted = MappingProxyType({}),
    ) -> JudgedRows:
        """Return the checks of some rules; arcs that variants have in common are solved once.

        `wanted` is where checks that solve arcs anew are made, shape (places, n).
        """
        first, same = self._distinct()
        if len(first) == len(same):
            every = {rule: flags.ravel() for rule, flags in wanted.items()}
            return self._solved(setting, rules, every)
        some = {
            rule: np.bincount(same, flags.ravel(), len(first)) > 0.0
            for rule, flags in wanted.items()
        }
        judged = self._rows(first, self.possible)._solved(setting, rules, some)
        checks = tuple(check.rows(same) for check in judged.checks)
        found = judged.solved.found[same]
        factors = {"friction_factor": self.friction, "slip_factor": self.slip}
        solved = BatchResult(self.arcs, found, setting=setting, **factors)
        return self._possible(checks, solved)

    def check_gross_slip(self, solved: BatchResult, which: Integers) -> RowCheck:
        """Return the safety against gross slip of some variants that are solved."""
        rows = (np.arange(len(self.places))[:, None] * len(self.possible) + which).ravel()
        first, same = self._rows(rows, self.possible[which])._distinct()
        some = rows[first]
        return gross_slip_of(solved.rows(some), self.held.rows(some)).rows(same)

    def _solved(self, setting: Setting, rules: Sequence[Rule], wanted: Wanted) -> JudgedRows:
        factors = self.friction, self.slip
        solved = solve_scaled(self.arcs, *factors, setting=setting, capacities=False)
        checks = [*row_checks(solved, self.held, factors, setting, rules, wanted)]
        if CREEP_INTERVAL in rules and any(of.has_knots for of in self.laws):
            where = wanted.get(CREEP_INTERVAL)
            checks.append(interval_of(solved, self.held, self.laws, factors, where))
        return self._possible(tuple(checks), solved)

    def _possible(self, checks: tuple[RowCheck, ...], solved: BatchResult) -> JudgedRows:
        possible = self.possible
        if len(solved.arcs) == len(self.places) * len(possible):
            refused = (solved["status"] == REFUSED).reshape(len(self.places), -1)
            possible = possible & ~refused.any(axis=0)
        return JudgedRows(self.places, checks, solved, possible)

    def _distinct(self) -> tuple[Integers, Integers]:
        """Return the first of each of the arcs that differ, and the place of every arc in them."""
        if len({pulley for pulley, _ in self.places}) == 1:
            every = np.arange(len(self.arcs))
            return every, every
        columns = [*self.arcs.columns().values(), self.arcs.law, self.friction, self.slip]
        columns += self.held.columns()
        table = np.ascontiguousarray(np.stack([np.asarray(c, float) for c in columns], axis=1))
        known: dict[bytes, int] = {}
        same = [known.setdefault(of.tobytes(), len(known)) for of in table]
        first = np.unique(np.array(same), return_index=True)[1]
        return first, np.array(same)


@dataclass(frozen=True, eq=False, kw_only=True)
class VariantRows:
    """Variants of a drive: the drive of each, and what differs from it within the row.

    Every pulley keeps its share of the load.

    Attributes
    ----------
    drives, which
        Drives of the same pulleys and load cases, and that of each variant, shape (n,).
    lift
        By how much all tensions are higher, shape (n,) [N].
    pull
        Factor on the effective tension, the lowest tension being fixed, shape (n,) [-].
    tensions
        Entry and exit tensions of the pulleys by load case, shape (2, pulleys, n) [N]; nan where
        they are those of the drive.
    factors
        Factors by name of a column of arcs, `FRICTION` or `SLIP`, of shape (pulleys, n) or (n,)
        [-]. E_c follows the thickness of a lagging.
    odd
        Least margin of implausible sizes beside those of arcs, shape (n,) [-]; that of the drives
        unless given.
    """

    drives: Sequence[Drive]
    which: Integers
    lift: Array
    pull: Array
    tensions: Mapping[str, Array] = field(default_factory=dict)
    factors: Mapping[str, Array] = field(default_factory=dict)
    odd: Array | None = None

    def judge(self, setting: Setting = Setting.ENGINEERING) -> JudgedRows:
        """Return the checks of every variant, see `VariantArcs.judge`."""
        return self.arcs().judge(setting)

    def arcs(self) -> VariantArcs:
        """Return the arcs of every variant.

        Raises
        ------
        InputError
            If one of the drives cannot be solved as it is.
        """
        places, arcs, held, possible, laws = self._arcs()
        pulleys = [p.name for p in self.drives[0].pulleys]
        of = [pulleys.index(name) for name, _ in places]
        friction, slip = (
            np.concatenate([self._factor(name, index) for index in of]) for name in (FRICTION, SLIP)
        )
        return VariantArcs(places, arcs, held, friction, slip, possible, laws)

    def _factor(self, name: str, index: int) -> Array:
        """Return the factor of each variant on a column of a pulley [-]."""
        n = len(self.which)
        factor = self.factors.get(name)
        if factor is None:
            return np.ones(n)
        return np.asarray(factor if factor.ndim == 1 else factor[index])

    def _arcs(
        self,
    ) -> tuple[tuple[tuple[str, str], ...], Arcs, Held, Flags, tuple[Fitted, ...]]:
        """Return the places, all arcs, what they are held against, which can be, and the laws."""
        first = self.drives[0]
        own: list[list[WrapArc]] = []
        of: list[tuple[list[Drive], str, int]] = []
        for case in first.load_cases:
            drives = [drive.in_case(drive.load_case(case.name)) for drive in self.drives]
            for index in range(len(first.pulleys)):
                of.append((drives, case.name, index))
                own.append(
                    [WrapArc.of(d, d.pulleys[index], d.load_case(case.name)) for d in drives]
                )
        laws = list(dict.fromkeys(Fitted(arc.law, arc.fit) for arcs in own for arc in arcs))
        bank, possible = LawBank.of([of.law for of in laws]), np.ones(len(self.which), dtype=bool)
        every, held = list[Arcs](), list[Held]()
        for (drives, name, index), arcs_of in zip(of, own, strict=True):
            ends, there = self._ends(drives, name)
            possible &= there
            arcs = self._rows(drives, arcs_of, ends, index, (laws, bank))
            every.append(arcs)
            held.append(self._held(drives, name, index, arcs, ends))
        places = tuple((first.pulleys[index].name, name) for _, name, index in of)
        return places, _below(every), Held.joined(held), possible, tuple(laws)

    def _held(
        self, drives: list[Drive], case: str, index: int, arcs: Arcs, ends: tuple[Array, Array]
    ) -> Held:
        """Return what the arcs of a pulley are held against."""
        diameters = np.array([[p.diameter for p in d.pulleys] for d in drives])[self.which].T
        factors = [self._factor("diameter", i) for i in range(len(diameters))]
        pulley = drives[0].pulleys[index].name
        held = held_by(drives, self.which, pulley, case, arcs, ends, diameters * factors)
        return held if self.odd is None else replace(held, odd=self.odd)

    def _ends(self, drives: list[Drive], name: str) -> tuple[tuple[Array, Array], Flags]:
        """Return entry and exit tensions of every pulley, shape (pulleys, n) each [N].

        What is no tension is marked, and stands as it is.
        """
        pairs = np.array(
            [
                [(at.entry, at.exit) for at in (case.tensions[p.name] for p in drive.pulleys)]
                for drive in drives
                for case in (drive.load_case(name),)
            ]
        )[self.which]
        slack = pairs.min(axis=(1, 2), keepdims=True)
        after = slack + self.pull[:, None, None] * (pairs - slack) + self.lift[:, None, None]
        if name in self.tensions:
            given = np.moveaxis(self.tensions[name], -1, 0).swapaxes(1, 2)
            after = np.where(np.isnan(given), after, given)
        flying = np.array([centrifugal_of(drive.belt) for drive in drives])[self.which]
        valid = after.min(axis=(1, 2)) > flying + _LEAST_TENSION
        valid &= after.max(axis=(1, 2)) <= Tensions.LIMITS["entry"].most
        entry, leaving = np.moveaxis(np.where(valid[:, None, None], after, pairs), -1, 0)
        return (entry.T, leaving.T), valid

    def _rows(
        self,
        drives: list[Drive],
        own: list[WrapArc],
        ends: tuple[Array, Array],
        index: int,
        laws: tuple[list[Fitted], LawBank],
    ) -> Arcs:
        """Return the arcs of a pulley in a load case."""
        known, bank = laws
        table = np.array([[_number(arc, name) for name in COLUMNS] for arc in own])[self.which]
        columns = {name: table[:, k].copy() for k, name in enumerate(COLUMNS)}
        for name, tensions in zip(("entry_tension", "exit_tension"), ends, strict=True):
            columns[name] = tensions[index]
        for name in self.factors:
            if name in columns:
                columns[name] = columns[name] * self._factor(name, index)
        if "lagging_thickness" in self.factors:
            self._follow_thickness(drives, columns, index)
        if index > 0:
            self._follow_strain(drives, columns, ends[0])
        law = np.array([known.index(Fitted(arc.law, arc.fit)) for arc in own])[self.which]
        return Arcs(laws=bank, law=law, **columns)

    def _follow_thickness(self, drives: list[Drive], columns: dict[str, Array], index: int) -> None:
        """Set E_c of laggings of other thickness, by the shape of their blocks."""
        thickness, factor = columns["lagging_thickness"], self._factor("lagging_thickness", index)
        laggings = [drive.pulleys[index].lagging for drive in drives]
        shaped = compression_moduli(laggings, self.which, thickness)
        shaped = shaped * self._factor("compression_modulus", index)
        columns["compression_modulus"] = np.where(
            factor == 1.0, columns["compression_modulus"], shaped
        )

    def _follow_strain(self, drives: list[Drive], columns: dict[str, Array], entry: Array) -> None:
        """Set the speed of the belt, which is given where it meets the first pulley."""
        given = [np.nan if d.belt.speed is None else d.belt.speed for d in drives]
        stiffness = columns["belt_modulus"] * columns["belt_width"]
        strain = strain_ratio(columns["entry_tension"], entry[0], stiffness)
        columns["belt_speed"] = np.array(given)[self.which] * strain


def _below(every: list[Arcs]) -> Arcs:
    """Return arcs of the same laws that stand below each other."""
    columns = {n: np.concatenate([getattr(arcs, n) for arcs in every]) for n in COLUMNS}
    law = np.concatenate([arcs.law for arcs in every])
    return Arcs(laws=every[0].laws, law=law, **columns)


#: Columns of arcs that `WrapArc` calls otherwise.
_NAMES = {
    "belt_width": "width", "lagging_thickness": "thickness", "centrifugal_force": "centrifugal",
}  # fmt: skip


def _number(arc: WrapArc, name: str) -> float:
    """Return what a column has of an arc; nan where it is not known."""
    if name == "belt_modulus":
        return arc.axial_stiffness / arc.width
    value = getattr(arc, _NAMES.get(name, name))
    if value is None:
        return 0.0 if name == "pitch_offset" else float("nan")
    return float(value)
