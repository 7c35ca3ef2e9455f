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
from wraparc.checks.of_rows import NAMES, held_by, row_checks
from wraparc.checks.rules import RULES
from wraparc.drive import Drive, LoadCase
from wraparc.errors import InputError

_TENSIONS = ("entry_tension", "exit_tension")


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
        n = len(self.which)
        levels: list[dict[str, int]] = [{} for _ in range(n)]
        used: list[dict[str, float]] = [{} for _ in range(n)]
        passed: list[dict[str, bool]] = [{} for _ in range(n)]
        creeps = np.zeros(n)
        for case in self.drives[0].load_cases:
            creeps = np.maximum(creeps, self._judge(case, levels, used, passed))
        others = {name: rank for name, rank in now.levels.items() if name not in NAMES}
        kept = [name for name in now.passed if name not in NAMES]
        return [
            Outcome(
                possible=bool(self.possible[i]),
                levels=levels[i] | others,
                passed=(*(name for name, passes in passed[i].items() if passes), *kept),
                used=used[i],
                creep=float(creeps[i]),
            )
            for i in range(n)
        ]

    def _judge(
        self,
        case: LoadCase,
        levels: list[dict[str, int]],
        used: list[dict[str, float]],
        passed: list[dict[str, bool]],
    ) -> Array:
        """Judge a load case into the lists of all of them; return the creeps [m]."""
        drives = [drive.in_case(drive.load_case(case.name)) for drive in self.drives]
        try:
            arcs = self._arcs(drives, case.name)
        except InputError:
            self.possible[:] = False
            return np.zeros(len(self.which))
        (pulley,) = drives[0].pulleys
        ends = arcs.entry_tension[None], arcs.exit_tension[None]
        held = held_by(drives, self.which, pulley.name, case.name, arcs, ends)
        solved = solve_arcs(arcs, setting=Setting.PRECISE, capacities=False, threads=1)
        ones = np.ones(len(arcs))
        self.possible &= solved["status"] != REFUSED
        for name, ranks, margins in row_checks(solved, held, (ones, ones), Setting.PRECISE):
            for i in np.flatnonzero(ranks >= Level.OK.rank).tolist():
                misses = int(ranks[i]) > Level.OK.rank
                passed[i][name] = passed[i].get(name, True) and not misses
                if misses:
                    levels[i][name] = max(levels[i].get(name, 0), int(ranks[i]))
                    share = _share(float(margins[i]), RULES[name].at_most)
                    used[i][name] = max(used[i].get(name, 0.0), share)
        return np.where(solved.solved, np.abs(np.nan_to_num(solved["exit_creep"])), 0.0)

    def _arcs(self, drives: list[Drive], case: str) -> Arcs:
        """Return the arcs of a load case; what cannot be is marked, and stands for one that can."""
        own = [WrapArc.of(d, d.pulleys[0], d.load_case(case)) for d in drives]
        table = np.array([[_number(arc, name) for name in COLUMNS] for arc in own])[self.which]
        columns = {name: table[:, k].copy() for k, name in enumerate(COLUMNS)}
        entry, leaving = (columns[name] for name in _TENSIONS)
        slack = np.minimum(entry, leaving)
        entry, leaving = (slack + self.pull * (t - slack) + self.lift for t in (entry, leaving))
        valid: Flags = np.minimum(entry, leaving) > columns["centrifugal_force"] + 1.0
        self.possible &= valid
        columns["entry_tension"] = np.where(valid, entry, columns["entry_tension"])
        columns["exit_tension"] = np.where(valid, leaving, columns["exit_tension"])
        columns["wrap_angle"] = np.where(self.wrap > 0.0, self.wrap, columns["wrap_angle"])
        laws = list(dict.fromkeys(arc.law for arc in own))
        law = np.array([laws.index(arc.law) for arc in own])[self.which]
        return Arcs(laws=LawBank.of(laws), law=law, **columns)


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


def _share(margin: float, at_most: bool) -> float:
    """Return a value over its maximum, or a minimum over its value, by its margin [-]."""
    if at_most:
        return 1.0 - margin
    return 1.0 / (1.0 + margin) if margin > -1.0 else inf
