"""Variants of a drive judged together, as rows: many at once, all pulleys and load cases."""

from __future__ import annotations

from dataclasses import replace
from math import inf, radians

import numpy as np

from wraparc.actions.document import Source
from wraparc.actions.variant import IMPOSSIBLE, Outcome, Variant
from wraparc.arc.quantities import REFUSED
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Array
from wraparc.batch import Setting, solve_arcs
from wraparc.batch.arcs import COLUMNS, Arcs
from wraparc.batch.laws import LawBank
from wraparc.checks.check import Level
from wraparc.checks.of_rows import NAMES, Held, held_by, row_checks
from wraparc.checks.of_train import OF_MOTORS
from wraparc.checks.rules import ACROSS_CHECKS
from wraparc.drive import Drive
from wraparc.drive.pitch import centrifugal_of
from wraparc.errors import InputError

#: Checks that rows make.
_KNOWN = frozenset(NAMES) - ACROSS_CHECKS - {rule.name for rule in OF_MOTORS}
#: What is told is confirmed by the solver of one arc.
_SETTING = Setting.ENGINEERING


class RowEvaluator:
    """Judges variants of a drive whose pulleys are even.

    Every pulley keeps its share of the load. What rows do not check is taken as it is in the drive
    as it is.
    """

    def __init__(self, source: Source, drive: Drive, now: Outcome) -> None:
        self._source, self._drive, self._now = source, drive, now
        self._drives: dict[Variant, Drive | None] = {Variant(): drive}

    def __call__(self, variants: list[Variant]) -> list[Outcome]:
        """Return the outcome of each variant."""
        drives = [self._drive_of(variant) for variant in variants]
        which = [i for i, drive in enumerate(drives) if drive is not None]
        found = [IMPOSSIBLE] * len(variants)
        if which:
            of = [drive for drive in drives if drive is not None]
            some = _Rows(of, [variants[i] for i in which], self._source.take_up)
            for i, outcome in zip(which, some.outcomes(self._now), strict=True):
                found[i] = outcome
        return found

    def _drive_of(self, variant: Variant) -> Drive | None:
        """Return the drive that a variant is without its tensions and wrap; None if there is none.

        Those are columns.
        """
        base = variant._replace(tension=0.0, wrap=0.0, pull=0.0)
        if base not in self._drives:
            try:
                self._drives[base] = self._read(base)
            except InputError:
                self._drives[base] = None
        return self._drives[base]

    def _read(self, variant: Variant) -> Drive:
        """Return the drive of a variant; of a train at the tensions that its load divides into."""
        read = self._source.read(self._source.changes(variant))
        if isinstance(read, Drive):
            return read
        belt, pulleys, criteria = read.belt, read.pulleys, read.criteria
        return replace(self._drive, belt=belt, pulleys=pulleys, criteria=criteria)


class _Rows:
    """Variants as rows: a drive for each, and the columns that differ within drives.

    The rows of each pulley in each load case stand below each other.
    """

    def __init__(self, drives: list[Drive], variants: list[Variant], tension: float) -> None:
        self.drives = list({id(drive): drive for drive in drives}.values())
        places = {id(drive): place for place, drive in enumerate(self.drives)}
        self.which = np.array([places[id(drive)] for drive in drives])
        self.lift = np.array([v.tension - tension if v.tension else 0.0 for v in variants])
        self.pull = np.array([v.pull or 1.0 for v in variants])
        self.wrap = np.array([radians(v.wrap) for v in variants])
        self.possible = np.ones(len(variants), dtype=bool)

    def outcomes(self, now: Outcome) -> list[Outcome]:
        """Return the outcomes; `now` is that of the drive as it is."""
        try:
            arcs, held = self._arcs()
        except InputError:
            return [IMPOSSIBLE] * len(self.which)
        solved = solve_arcs(arcs, setting=_SETTING, capacities=False, threads=1)
        factors, shape = (np.ones(len(arcs)),) * 2, (-1, len(self.which))
        levels: list[dict[str, int]] = [{} for _ in self.which]
        used: list[dict[str, float]] = [{} for _ in self.which]
        passed: list[list[str]] = [[] for _ in self.which]
        for check in row_checks(solved, held, factors, _SETTING):
            name, ranks = check.rule.name, check.rank
            missed = _shares(check.margin, check.rule.at_most)
            shares = np.where(ranks > Level.OK.rank, missed, 0.0)
            most = shares.reshape(shape).max(axis=0)
            for i, rank in enumerate(np.asarray(ranks).reshape(shape).max(axis=0).tolist()):
                if rank > Level.OK.rank:
                    levels[i][name], used[i][name] = rank, float(most[i])
                elif rank == Level.OK.rank:
                    passed[i].append(name)
        creeps = np.where(solved.solved, np.abs(solved["exit_creep"]), 0.0).reshape(shape)
        refused = (solved["status"] == REFUSED).reshape(shape).any(axis=0)
        others = {name: rank for name, rank in now.levels.items() if name not in _KNOWN}
        passes = [name for name in now.passed if name not in _KNOWN]
        return [
            Outcome(
                possible=bool(self.possible[i] and not refused[i]),
                levels=levels[i] | others,
                passed=(*passed[i], *passes),
                used=used[i],
                creep=float(creeps[:, i].max()),
            )
            for i in range(len(self.which))
        ]

    def _arcs(self) -> tuple[Arcs, Held]:
        """Return all arcs, and what they are held against."""
        first = self.drives[0]
        cases = [
            [drive.in_case(drive.load_case(case.name)) for drive in self.drives]
            for case in first.load_cases
        ]
        places = [
            (drives, case.name, index)
            for drives, case in zip(cases, first.load_cases, strict=True)
            for index in range(len(first.pulleys))
        ]
        found = [
            [WrapArc.of(d, d.pulleys[index], d.load_case(name)) for d in drives]
            for drives, name, index in places
        ]
        laws = list(dict.fromkeys(arc.law for own in found for arc in own))
        every, held, bank = list[Arcs](), list[Held](), LawBank.of(laws)
        for (drives, name, index), own in zip(places, found, strict=True):
            law = np.array([laws.index(arc.law) for arc in own])[self.which]
            ends = self._ends(drives, name)
            arcs = Arcs(laws=bank, law=law, **self._columns(own, ends, index))
            pulley = first.pulleys[index].name
            every.append(arcs)
            held.append(held_by(drives, self.which, pulley, name, arcs, ends))
        return _below(every), Held.joined(held)

    def _ends(self, drives: list[Drive], name: str) -> tuple[Array, Array]:
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
        flying = np.array([centrifugal_of(drive.belt) for drive in drives])[self.which]
        valid = after.min(axis=(1, 2)) > flying + 1.0
        self.possible &= valid
        entry, leaving = np.moveaxis(np.where(valid[:, None, None], after, pairs), -1, 0)
        return entry.T, leaving.T

    def _columns(
        self, own: list[WrapArc], ends: tuple[Array, Array], index: int
    ) -> dict[str, Array]:
        """Return the columns of a pulley."""
        table = np.array([[_number(arc, name) for name in COLUMNS] for arc in own])[self.which]
        columns = {name: table[:, k].copy() for k, name in enumerate(COLUMNS)}
        for name, tensions in zip(("entry_tension", "exit_tension"), ends, strict=True):
            columns[name] = tensions[index]
        columns["wrap_angle"] = np.where(self.wrap > 0.0, self.wrap, columns["wrap_angle"])
        return columns


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


def _shares(margins: Array, at_most: bool) -> Array:
    """Return values over their maxima, or minima over values, by their margins [-]."""
    if at_most:
        return 1.0 - margins
    with np.errstate(divide="ignore"):
        return np.where(margins > -1.0, 1.0 / np.maximum(1.0 + margins, 0.0), inf)
