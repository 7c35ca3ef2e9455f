"""A study: many variants of one drive, solved by ranges of their index."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import Capacities
from wraparc.arrays import Array, Codes, Flags, Integers
from wraparc.batch import Setting
from wraparc.batch.arcs import Arcs, present
from wraparc.batch.scaled import solve_scaled
from wraparc.checks.of_arc import NO_GRIP
from wraparc.checks.of_rows import LEVELS, NAMES, Held, kept_rows, worst_of_rows
from wraparc.drive import GRAVITY, Drive
from wraparc.drive.conditions import DRY
from wraparc.drive.criteria import is_wet
from wraparc.provenance import Provenance
from wraparc.study.across_rows import solve_rows
from wraparc.study.distributions import Distribution
from wraparc.study.histogram import LIMITED, limit_column
from wraparc.study.plan import DrawnField, Plan, Values
from wraparc.units import Dimension
from wraparc.version import __version__

Progress = Callable[[int, int], object]
#: Columns of numbers, whole numbers or truth values, by name.
Columns = dict[str, NDArray[Any]]

#: Status of a row by its code; those of the batch kernel and one for what cannot be a drive.
STATUS_WORDS = ("solved", "breakaway", "unsolved", "refused", "invalid")
SOLVED, BREAKAWAY, INVALID = 0, 1, 4

#: Columns that say which row it is.
DESIGN, LOAD_CASE, CONDITION, STATUS = "design", "load_case", "condition", "status"
FRICTION_FACTOR = "friction_factor"
WITHIN, VERDICT, GOVERNING = "within_creep_limit", "verdict", "governing"
#: Words of the columns of the verdict, by their codes.
JUDGED: Mapping[str, tuple[str, ...]] = {
    VERDICT: tuple(str(level) for level in LEVELS),
    GOVERNING: NAMES,
}

#: Results that are kept where the study does not name others.
OUTPUTS = (
    "entry_tension",
    "exit_tension",
    "exit_creep",
    "exit_slip",
    "peak_shear_stress",
    "active_arc",
    "outside_tested_share",
    "creep_limit_margin",
    "tested_slip_margin",
    "gross_slip_safety",
    "least_exit_tension",
    "largest_effective_tension",
    "power_loss",
)
#: Results that a pulley has within a train; not a number where the study does not divide its load.
TRAIN_OUTPUTS = ("share", "speed_trim", "motor_load", "motor_torque")
#: Strength of the belt over its larger tension at the pulley, and bounds of the load of its shaft
#: with the weight of the pulley; not a number without a strength, without a mass.
LOADS = ("belt_safety", "most_shaft_load", "least_shaft_load")
#: Results that need the capacities.
CAPACITY_OUTPUTS = frozenset(f.name for f in fields(Capacities))

_MOST_OWN_LAWS = 512  # arcs with a law of their own that are solved at once: each takes 20 kB


@dataclass(frozen=True, eq=False, kw_only=True)
class Rows:
    """Designs in one load case.

    Attributes
    ----------
    arcs
        One arc for each design.
    held
        What the checks hold them against.
    valid
        Which of them are a drive at all; the numbers of the others mean nothing.
    friction_factor, slip_factor
        Factors on the friction and the slips of their laws [-].
    drives, which
        Drives they are of, and that of each design, shape (n,).
    pulley, load_case
        Names.
    lost
        Status of those that are trains without a balance, 0 of the others, shape (n,).
    of_train
        What the pulley has within the whole drive, see `TRAIN_OUTPUTS`; shape (n,) each.
    """

    arcs: Arcs
    held: Held
    valid: Flags
    friction_factor: Array
    slip_factor: Array
    drives: Sequence[Drive]
    which: Integers
    pulley: str
    load_case: str
    lost: Codes
    of_train: Mapping[str, Array]


class Source(Protocol):
    """What turns values of fields into arcs."""

    def rows(self, values: Values, size: int, load_case: str) -> Rows:
        """Return designs in a load case."""

    def unit_of(self, name: str) -> Dimension | None:
        """Return what a column of values measures."""


@dataclass(frozen=True, kw_only=True)
class Condition:
    """A state of the surfaces, every design being solved in each.

    Attributes
    ----------
    name
        ``dry``, ``wet`` ...
    friction_factor
        Friction over that of the law: a number, or how it is distributed [-].
    share
        Part of the time, for probabilities over all conditions; None if it is not known.
    provenance
        Where the factor came from.
    """

    name: str
    friction_factor: float | Distribution = 1.0
    share: float | None = None
    provenance: Provenance = field(default_factory=Provenance)

    @property
    def field(self) -> str:
        """Name of the column that a distributed factor is drawn into."""
        return f"condition.{self.name}.friction_factor"

    def drawn(self) -> tuple[DrawnField, ...]:
        """What has to be drawn for it."""
        if not isinstance(self.friction_factor, Distribution):
            return ()
        made = DrawnField(field=self.field, distribution=self.friction_factor, dimension="number")
        return (made,)

    def factor(self, values: Values, size: int) -> Array:
        """Friction factor of designs, shape (size,) [-]."""
        if isinstance(self.friction_factor, Distribution):
            return values[self.field]
        return np.full(size, self.friction_factor)


@dataclass(frozen=True, kw_only=True, eq=False)
class Study:
    """Everything that fixes the numbers of a study, and nothing else.

    Attributes
    ----------
    title
        What it is called.
    plan
        The designs.
    source
        What turns them into arcs.
    load_cases, conditions
        Every design is solved in each combination of them; no conditions for the law as it is.
    setting
        How accurately.
    outputs
        Results that are kept, by their names in the glossary.
    description
        The input as plain data, for the fingerprint and for readers of the results.
    ground
        What limits an OK: load cases that are left out, unknown wet friction.
    data_line
        On what data the results are based, as the verdict on a drive has it.
    """

    title: str
    plan: Plan
    source: Source
    load_cases: tuple[str, ...]
    conditions: tuple[Condition, ...] = ()
    setting: Setting = Setting.ENGINEERING
    outputs: tuple[str, ...] = OUTPUTS
    description: Mapping[str, Any] = field(default_factory=dict)
    ground: str = ""
    data_line: str = ""

    @property
    def cases(self) -> tuple[tuple[str, Condition | None], ...]:
        """Load cases and conditions of every design, in the order of its rows."""
        conditions: Sequence[Condition | None] = self.conditions or (None,)
        return tuple((load, condition) for load in self.load_cases for condition in conditions)

    @property
    def rows(self) -> int:
        """Rows of the results."""
        return len(self.plan) * len(self.cases)

    @property
    def limited(self) -> tuple[str, ...]:
        """Results whose limits are kept beside them, that of the creep always."""
        return tuple(n for n in LIMITED if n == "exit_creep" or n in self.outputs)

    @property
    def fingerprint(self) -> str:
        """Says whether two studies give the same numbers."""
        known = {
            "program": __version__,
            "setting": self.setting.value,
            "outputs": list(self.outputs),
            **self.description,
        }
        text = json.dumps(known, sort_keys=True, default=str)
        return hashlib.sha256(text.encode("utf-8")).hexdigest()

    def solve(self, start: int, stop: int, *, progress: Progress | None = None) -> Columns:
        """Columns of the designs `start` to `stop`, a row for each design and case.

        The same numbers to the last bit for a design whatever the range it is solved in.
        `progress` is called now and then with arcs done and their number of some part of the work;
        what it raises ends the work.
        """
        return self.solve_values(self.plan.values(start, stop), stop - start, start, progress)

    def solve_values(
        self, values: Values, size: int, start: int = 0, progress: Progress | None = None
    ) -> Columns:
        """Columns of designs by the values of their fields; the first has the number `start`."""
        parts = [
            self._case(values, size, load, condition, progress) for load, condition in self.cases
        ]
        columns = {
            name: np.stack([part[name] for part in parts], axis=1).ravel()
            for part in parts[:1]
            for name in part
        }
        count, loads = len(self.cases), len(self.cases) // len(self.load_cases)
        place = np.arange(size * count) % count
        shown = {
            name: np.repeat(value, count)
            for name, value in values.items()
            if not name.startswith("condition.")
        }
        which = {
            DESIGN: np.repeat(np.arange(start, start + size), count),
            LOAD_CASE: place // loads,
            **({CONDITION: place % loads} if self.conditions else {}),
        }
        return which | shown | columns

    def _case(
        self,
        values: Values,
        size: int,
        load: str,
        condition: Condition | None,
        progress: Progress | None,
    ) -> Columns:
        rows = self.source.rows(values, size, load)
        factor = rows.friction_factor
        if condition is not None:
            factor = factor * condition.factor(values, size)
            if condition.name != DRY or any(is_wet(of.name) for of in self.conditions):
                rows = replace(rows, held=replace(rows.held, wet_factor=np.zeros(size)))
        good = np.flatnonzero(rows.valid)
        solved = self._solved(rows, good, factor, progress)
        columns: Columns = {}
        if self.conditions:
            columns[FRICTION_FACTOR] = factor
        status = np.full(size, INVALID, dtype=np.int8)
        status[good] = solved[STATUS]
        columns[STATUS] = status
        within = np.zeros(size, dtype=bool)
        creep, limit = np.abs(solved["exit_creep"]), rows.arcs.creep_limit[good]
        within[good] = kept_rows(creep, limit, at_most=True)
        columns[WITHIN] = within & (status == SOLVED)
        for name in JUDGED:
            columns[name] = np.zeros(size, dtype=np.int8)
            columns[name][good] = solved[name]
        for name in self.outputs:
            columns[name] = np.full(size, np.nan)
            columns[name][good] = solved[name]
        for name in self.limited:
            limits = [rows.held.limit(rule) for rule in LIMITED[name]]
            columns[limit_column(name)] = np.where(rows.valid, np.fmin.reduce(limits), np.nan)
        _lose(columns, rows, self.outputs)
        return columns

    def _solved(
        self, rows: Rows, good: Integers, factor: Array, progress: Progress | None
    ) -> Mapping[str, NDArray[Any]]:
        """Results that are kept, and the verdicts, of the rows that are drives.

        Many laws are solved a few at a time, for the memory they take.
        """
        arcs = rows.arcs
        wanted = dict.fromkeys((STATUS, "exit_creep", *self.outputs))
        own = len(arcs.laws) > _MOST_OWN_LAWS
        size = _MOST_OWN_LAWS if own else max(1, len(good))
        capacities = not CAPACITY_OUTPUTS.isdisjoint(self.outputs)
        found = []
        for begin in range(0, max(1, len(good)), size):
            some = good[begin : begin + size]
            part, friction = arcs.rows(some), factor[some]
            if own:
                part = part.with_laws(np.asarray(present(part.law)))
            solved = solve_scaled(
                part,
                friction,
                rows.slip_factor[some],
                setting=self.setting,
                capacities=capacities,
                progress=progress,
            )
            factors, held = (friction, rows.slip_factor[some]), rows.held.rows(some)
            solved = solved.growing(held.tight_rise, held.slack_rise)
            judged = worst_of_rows(solved, held, factors, self.setting)
            uneven = solve_rows(
                rows.drives,
                rows.which[some],
                arcs.rows(some),
                friction,
                rows.slip_factor[some],
                (rows.pulley, rows.load_case),
                judged,
            )
            missing = np.full(len(some), np.nan)
            whole = {
                n: rows.of_train[n][some] if n in rows.of_train else missing for n in TRAIN_OUTPUTS
            }
            tension = np.maximum(part.entry_tension, part.exit_tension)
            safety = rows.held.state.strength[some] * part.belt_width / tension
            masses = np.array([d.pulley(rows.pulley).mass or np.nan for d in rows.drives])
            weight, force = masses[rows.which[some]] * GRAVITY, solved["resultant_force"]
            loads = (safety, force + weight, np.abs(force - weight))
            more = {**uneven, **whole, **dict(zip(LOADS, loads, strict=True))}
            kept = {n: more[n] if n in more else solved[n] for n in wanted}
            found.append(kept | dict(zip(JUDGED, judged[:2], strict=True)))
        return {name: np.concatenate([part[name] for part in found]) for name in found[0]}


def _lose(columns: Columns, rows: Rows, outputs: Sequence[str]) -> None:
    """Take back the results of trains whose load finds no balance: they break away."""
    lost = np.flatnonzero(rows.lost)
    columns[STATUS][lost] = rows.lost[lost]
    columns[WITHIN][lost] = False
    columns[VERDICT][lost] = NO_GRIP.rank
    columns[GOVERNING][lost] = NAMES.index("gross_slip")
    for name in outputs:
        columns[name][lost] = np.nan
