"""Variants of a drive of one pulley judged together, as rows: many at once, all load cases."""

from __future__ import annotations

from math import inf, radians

import numpy as np

from wraparc.actions.document import Source
from wraparc.actions.variant import IMPOSSIBLE, Outcome, Variant
from wraparc.arc.quantities import REFUSED
from wraparc.arc.wrap_arc import WrapArc
from wraparc.arrays import Array, Flags
from wraparc.batch import Setting, solve_arcs
from wraparc.batch.arcs import COLUMNS, Arcs
from wraparc.batch.laws import LawBank
from wraparc.checks.check import Level
from wraparc.checks.of_rows import NAMES, Held, held_by, row_checks
from wraparc.checks.rules import RULES
from wraparc.drive import Drive
from wraparc.errors import InputError

_TENSIONS = ("entry_tension", "exit_tension")
#: What is told is confirmed by the solver of one arc.
_SETTING = Setting.ENGINEERING


class RowEvaluator:
    """Judges variants of a drive of one even pulley.

    What rows do not check is taken as it is in the drive as it is.
    """

    def __init__(self, source: Source, drive: Drive, now: Outcome, tension: float) -> None:
        self._source, self._now, self._tension = source, now, tension
        self._drives: dict[Variant, Drive | None] = {Variant(): drive}

    def __call__(self, variants: list[Variant]) -> list[Outcome]:
        """Return the outcome of each variant."""
        drives = [self._drive(variant) for variant in variants]
        which = [i for i, drive in enumerate(drives) if drive is not None]
        found = [IMPOSSIBLE] * len(variants)
        if which:
            some = _Rows([d for d in drives if d], [variants[i] for i in which], self._tension)
            for i, outcome in zip(which, some.outcomes(self._now), strict=True):
                found[i] = outcome
        return found

    def _drive(self, variant: Variant) -> Drive | None:
        """Return the drive that a variant is without its tensions and wrap; None if there is none.

        Those are columns.
        """
        base = variant._replace(tension=0.0, wrap=0.0, pull=0.0)
        if base not in self._drives:
            try:
                read = self._source.read(self._source.changes(base))
                self._drives[base] = read if isinstance(read, Drive) else None
            except InputError:
                self._drives[base] = None
        return self._drives[base]


class _Rows:
    """Variants as rows: a drive for each, and the columns that differ within drives."""

    def __init__(self, drives: list[Drive], variants: list[Variant], tension: float) -> None:
        places: dict[int, int] = {}
        self.drives = list({id(drive): drive for drive in drives}.values())
        for place, drive in enumerate(self.drives):
            places[id(drive)] = place
        self.which = np.array([places[id(drive)] for drive in drives])
        self.lift = np.array([v.tension - tension if v.tension else 0.0 for v in variants])
        self.pull = np.array([v.pull or 1.0 for v in variants])
        self.wrap = np.array([radians(v.wrap) for v in variants])
        self.possible = np.ones(len(variants), dtype=bool)

    def outcomes(self, now: Outcome) -> list[Outcome]:
        """Return the outcomes; `now` is that of the drive as it is."""
        n, names = len(self.which), [case.name for case in self.drives[0].load_cases]
        try:
            found = [self._wrap_arcs(name) for name in names]
        except InputError:
            return [IMPOSSIBLE] * n
        laws = list(dict.fromkeys(arc.law for own in found for arc in own))
        bank = LawBank.of(laws)
        law = [np.array([laws.index(arc.law) for arc in own])[self.which] for own in found]
        every = [
            Arcs(laws=bank, law=laws_of_case, **self._columns(own))
            for own, laws_of_case in zip(found, law, strict=True)
        ]
        held = Held.joined([self._held(n, arcs) for n, arcs in zip(names, every, strict=True)])
        arcs = _below(every)
        solved = solve_arcs(arcs, setting=_SETTING, capacities=False, threads=1)
        ones = np.ones(len(arcs))
        levels: list[dict[str, int]] = [{} for _ in range(n)]
        used: list[dict[str, float]] = [{} for _ in range(n)]
        passed: list[list[str]] = [[] for _ in range(n)]
        for name, ranks, margins in row_checks(solved, held, (ones, ones), _SETTING):
            by_case = np.asarray(ranks).reshape(len(names), n)
            shares = _shares(margins, RULES[name].at_most)
            most = np.where(ranks > Level.OK.rank, shares, 0.0).reshape(len(names), n).max(axis=0)
            worst = by_case.max(axis=0)
            for i, rank in enumerate(worst.tolist()):
                if rank > Level.OK.rank:
                    levels[i][name], used[i][name] = rank, float(most[i])
                elif rank == Level.OK.rank:
                    passed[i].append(name)
        creeps = np.where(solved.solved, np.abs(solved["exit_creep"]), 0.0)
        creeps = creeps.reshape(len(names), n).max(axis=0)
        refused = (solved["status"] == REFUSED).reshape(len(names), n).any(axis=0)
        others = {name: rank for name, rank in now.levels.items() if name not in NAMES}
        passes = [name for name in now.passed if name not in NAMES]
        return [
            Outcome(
                possible=bool(self.possible[i] and not refused[i]),
                levels=levels[i] | others,
                passed=(*passed[i], *passes),
                used=used[i],
                creep=float(creeps[i]),
            )
            for i in range(n)
        ]

    def _in_case(self, name: str) -> list[Drive]:
        return [drive.in_case(drive.load_case(name)) for drive in self.drives]

    def _wrap_arcs(self, name: str) -> list[WrapArc]:
        """Return the arc of each drive in a load case."""
        return [WrapArc.of(d, d.pulleys[0], d.load_case(name)) for d in self._in_case(name)]

    def _held(self, name: str, arcs: Arcs) -> Held:
        """Return what the arcs of a load case are held against."""
        drives, ends = self._in_case(name), (arcs.entry_tension[None], arcs.exit_tension[None])
        return held_by(drives, self.which, drives[0].pulleys[0].name, name, arcs, ends)

    def _columns(self, own: list[WrapArc]) -> dict[str, Array]:
        """Return the columns of the variants; what cannot be is marked, and stands as it is."""
        table = np.array([[_number(arc, name) for name in COLUMNS] for arc in own])[self.which]
        columns = {name: table[:, k].copy() for k, name in enumerate(COLUMNS)}
        before = [columns[name] for name in _TENSIONS]
        slack = np.minimum(*before)
        after = [slack + self.pull * (t - slack) + self.lift for t in before]
        valid: Flags = np.minimum(*after) > columns["centrifugal_force"] + 1.0
        self.possible &= valid
        for name, tension, other in zip(_TENSIONS, after, before, strict=True):
            columns[name] = np.where(valid, tension, other)
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
