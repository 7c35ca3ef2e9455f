"""The checks of many arcs at once, by the same rules: a verdict and what governs it, row by row."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.quantities import BREAKAWAY, REFUSED, SOLVED, UNSOLVED
from wraparc.arc.sliding import TESTED
from wraparc.arc.wrap_arc import of_belt
from wraparc.arrays import Array, Codes, Flags, Integers
from wraparc.batch import BatchResult, Setting, row
from wraparc.batch.arcs import Arcs
from wraparc.batch.interval import Fitted, farthest_creeps
from wraparc.batch.scaled import solve_scaled
from wraparc.batch.sliding import slides_of, wet_creeps
from wraparc.checks.case_kind import CASE_KIND, named_kind
from wraparc.checks.check import Level, keeps, margin_to
from wraparc.checks.design_standard import wrap_factors
from wraparc.checks.numbers import (
    ALIKE,
    COVERS_APART,
    KIND_STEP,
    LEAST_SHIFT,
    MOST_USED,
    Sizes,
    compared_sizes,
    kind_of,
    trim_shift,
)
from wraparc.checks.of_arc import (
    COVER_CREEP,
    CREEP_INTERVAL,
    DESIGN_STANDARD,
    GROSS_SLIP,
    NO_GRIP,
    start_factor,
)
from wraparc.checks.of_data import CONDITION, FIT
from wraparc.checks.of_drive import BELT_THICKNESS
from wraparc.checks.of_train import OF_MOTORS
from wraparc.checks.of_wet import WET_CREEP, estimate_factor
from wraparc.checks.rule import At, Rule, State
from wraparc.checks.rules import ACROSS_CHECKS, RULES
from wraparc.checks.usual import USUAL_RULE, least_margin, sizes_of
from wraparc.drive import Drive, Pulley
from wraparc.drive.belt_mass import masses_at
from wraparc.drive.changes import WORN
from wraparc.drive.conditions import SCALED
from wraparc.drive.pitch import pitch_offset
from wraparc.drive.pull import given_up, idle_rows, rises_of
from wraparc.drive.usual_sizes import USUAL_SIZES, unusual_rows

#: Words of a verdict by its code; a row that is no drive at all is not checked.
LEVELS = tuple(Level)
OF_ROWS = tuple(rule for rule in RULES.values() if rule.of_rows)
#: Checks by their code: what governs a row. "" where nothing could be checked.
NAMES = ("", *(rule.name for rule in OF_ROWS), *sorted(ACROSS_CHECKS))
#: What `judge` checks of one drive and no row is checked for, in words.
NOT_CHECKED = (
    "the energy balance of each solution",
    "the interval of the creep by a fitted law (draw the law instead)",
    "the torque of motors, where the load of a train is not divided anew in every row",
    "opposing drives, sizes of motors, take-ups over load cases",
)
#: Where checks that solve arcs anew are made.
Wanted = Mapping[Rule, Flags]
#: Those checks.
SOLVE_ANEW = (GROSS_SLIP, WET_CREEP, COVER_CREEP)
#: Relative distance within which two numbers may be the same in the digits that are shown.
_NEAR = 2e-3


@dataclass(frozen=True, eq=False)
class RowCheck:
    """One check of many arcs, columns of shape (n,).

    Attributes
    ----------
    rule
        The check.
    rank
        Rank of its level, 0 where nothing is compared.
    margin
        How far the value is from the limit, over the limit [-]; infinite where nothing is
        compared, nan where it is missed and no number says by how much.
    value, limit
        What is compared [SI]; nan where the check compares no number.
    """

    rule: Rule
    rank: Array
    margin: Array
    value: Array
    limit: Array

    def rows(self, which: Integers) -> RowCheck:
        """Return some of the arcs, also several times."""
        columns = self.rank, self.margin, self.value, self.limit
        return RowCheck(self.rule, *(column[which] for column in columns))

    def is_worse(self, rank: Array | Codes, margin: Array) -> Flags:
        """Return where it is worse than one of that rank and margin; having none is worst."""
        alike = (self.rank == rank) & (self.rank > 0)
        nearer = (self.margin < margin) | (np.isnan(self.margin) & ~np.isnan(margin))
        return np.asarray((self.rank > rank) | (alike & nearer))


@dataclass(frozen=True, eq=False, kw_only=True)
class Held:
    """What arcs are held against beside their laws, columns of shape (n,), nan where nothing is.

    Attributes
    ----------
    allowed, firm
        What each drive is allowed by name of the check, as `Rule.allowed` has it, and whether the
        check is firm.
    state
        What is compared and known before the arcs are solved.
    sizes
        What is given of belt, pulley and lagging.
    odd
        Least margin of sizes beside those that are asked about, infinite for none [-].
    safety
        Safety factor on gross slip [-].
    tight_rise, slack_rise
        How the tensions grow with the pull of the whole drive, see `rises` [N].
    standard
        Slack-side tension that the design standard requires [N]; infinite where a chosen one
        cannot be applied.
    wet_factor
        Friction over dry friction for the estimate when wet, nan if not known, 0 for no estimate
        [-].
    cover_left_out
        h_b/G_b of a belt cover that the slip of the law may include or not [m/Pa].
    scaled
        Whether the law was not tested in its condition, but scaled to it, or before wear.
    misfit
        Whether the law does not describe its tests.
    misnamed
        Whether the load case is named as of another kind.
    open_trim
        Whether the trim against another drum is open without the thickness of the belt.
    """

    allowed: Mapping[str, Array]
    firm: Mapping[str, Flags]
    state: State[Array]
    sizes: Sizes[Array]
    odd: Array
    safety: Array
    tight_rise: Array
    slack_rise: Array
    standard: Array
    wet_factor: Array
    cover_left_out: Array
    scaled: Flags
    misfit: Flags
    misnamed: Flags
    open_trim: Flags

    def rows(self, which: slice | Integers) -> Held:
        """Return some of the rows."""
        taken: dict[str, Any] = {}
        for of in fields(self):
            value = getattr(self, of.name)
            if isinstance(value, Mapping):
                taken[of.name] = {name: column[which] for name, column in value.items()}
            elif isinstance(value, Sizes):
                taken[of.name] = Sizes(*(column[which] for column in value))
            else:
                some = _row(value, which) if isinstance(value, State) else value[which]
                taken[of.name] = some
        return Held(**taken)

    @classmethod
    def joined(cls, every: Sequence[Held]) -> Held:
        """Return what rows are held against that stand below each other."""
        first, made = every[0], dict[str, Any]()
        for of in fields(cls):
            values = [getattr(held, of.name) for held in every]
            value = values[0]
            if isinstance(value, Mapping):
                made[of.name] = {n: np.concatenate([v[n] for v in values]) for n in value}
            elif isinstance(value, Sizes):
                made[of.name] = Sizes(*map(np.concatenate, zip(*values, strict=True)))
            elif isinstance(value, State):
                made[of.name] = _joined_states(values)
            else:
                made[of.name] = np.concatenate(values)
        return first if len(every) == 1 else cls(**made)

    def columns(self) -> Iterator[Array]:
        """Yield every column but those of the motors."""
        motors = {rule.name for rule in OF_MOTORS}
        for of in fields(self):
            value = getattr(self, of.name)
            if isinstance(value, Mapping):
                yield from (value[name] for name in sorted(value.keys() - motors))
            elif isinstance(value, State):
                yield from (
                    getattr(value, f.name)
                    for f in fields(value)
                    if f.name not in ("motor", "found")
                )
            else:
                yield from value if isinstance(value, Sizes) else (value,)

    def with_motors(self, load: Array, name: str, most: float) -> Held:
        """Return the same with the torque of motors, and what they bear over their rating [-]."""
        allowing = self.allowing({name: np.full(len(load), most)})
        return replace(allowing, state=replace(self.state, motor=load))

    def allowing(self, allowed: Mapping[str, Array]) -> Held:
        """Return the same with other numbers allowed, by name of the check."""
        return replace(self, allowed={**self.allowed, **allowed})

    def limit(self, rule: Rule) -> Array:
        """Return the limit of a check that needs no solution, nan where it has none [SI]."""
        if rule is GROSS_SLIP:
            return self.safety
        none = np.full(len(self.safety), math.nan)
        return rule.limited(self.allowed.get(rule.name, none), self.state)


def held_by(
    drives: Sequence[Drive],
    which: Integers,
    pulley: str,
    load_case: str,
    arcs: Arcs,
    tensions: tuple[Array, Array],
    diameters: Array | None = None,
) -> Held:
    """Return what arcs are held against.

    Parameters
    ----------
    drives, which
        Drives, and that of each arc, shape (n,); their tensions do not count.
    pulley, load_case
        Names in all of them.
    arcs
        The arcs of the pulley.
    tensions
        Entry and exit tensions of all pulleys, shape (pulleys, n) each [N].
    diameters
        Diameters of all pulleys, shape (pulleys, n) [m]; those of the drives unless given.
    """
    entry, leaving = tensions
    names = [p.name for p in drives[0].pulleys]
    index = names.index(pulley)
    every = [At(drive=d, case=d.load_case(load_case), pulley=d.pulley(pulley)) for d in drives]

    def column(of: Callable[[At], float | None]) -> Array:
        return np.array([of(at) for at in every], dtype=float)[which]

    lost = np.zeros(len(arcs))
    for take_up in {d.criteria.take_up for d in drives}:
        places = [i for i, d in enumerate(drives) if d.criteria.take_up == take_up]
        rows = np.flatnonzero(np.isin(which, places))
        lost[rows] = given_up((entry - leaving)[:, rows], names, take_up)
    tight_rise, slack_rise = rises_of(entry - leaving, index, lost)
    factors = _factors(drives, which, pulley, arcs.wrap_angle)
    never = np.isinf(factors)
    pull = column(_start) * np.abs(arcs.entry_tension - arcs.exit_tension)
    firm = {r.name: column(_firm(r.firm)) > 0.0 for r in OF_ROWS if r.firm is not None}
    strength = column(lambda at: at.drive.belt.breaking_strength)
    return Held(
        allowed={r.name: column(r.allowed) for r in OF_ROWS if r.allowed is not None},
        firm=firm,
        state=_state(arcs, strength, _slack_end(entry, leaving, index)),
        sizes=_sizes(every, which, arcs, alone=len(names) == 1),
        odd=column(lambda at: least_margin(at.drive)),
        safety=column(lambda at: at.drive.criteria.safety.of(at.case.kind)),
        tight_rise=tight_rise,
        slack_rise=slack_rise,
        standard=np.where(never, math.inf, np.where(never, 0.0, factors) * pull),
        wet_factor=column(estimate_factor),
        cover_left_out=column(_cover_left_out),
        scaled=column(_scaled) > 0.0,
        misfit=column(_misfit) > 0.0,
        misnamed=column(_misnamed) > 0.0,
        open_trim=_open_trims(drives, which, index, tensions, diameters),
    )


def _firm(of: Callable[[Drive], bool]) -> Callable[[At], float]:
    return lambda at: float(of(at.drive))


def _start(at: At) -> float:
    return start_factor(at.drive.criteria, at.case.kind)


def _cover_left_out(at: At) -> float:
    return of_belt(at.drive.belt, at.pulley.side, at.pulley.lagging.law)["cover_left_out"]


def _scaled(at: At) -> float:
    sources = at.pulley.lagging.sources
    return float(SCALED in sources or WORN in sources)


def _misfit(at: At) -> float:
    fit = at.pulley.lagging.fit
    return float(fit is not None and bool(fit.misfit))


def _misnamed(at: At) -> float:
    return float(named_kind(at.case) != "")


def _slack_end(entry: Array, leaving: Array, index: int) -> Array:
    """Tension of the slack end of the drive where the belt leaves it at a pulley, else nan [N]."""
    driving = entry[0] >= leaving[-1]
    found = np.full(entry.shape[1], math.nan)
    for place, end, side in ((len(entry) - 1, leaving[-1], driving), (0, entry[0], ~driving)):
        if place == index:
            found = np.where(side, end, found)
    return found


def _state(arcs: Arcs, strength: Array, slack_end: Array) -> State[Array]:
    none = np.full(len(arcs), math.nan)
    return State(
        tight=np.maximum(arcs.entry_tension, arcs.exit_tension),
        slack=np.minimum(arcs.entry_tension, arcs.exit_tension),
        slack_end=slack_end,
        width=arcs.belt_width,
        diameter=arcs.diameter,
        strength=strength,
        centrifugal=arcs.centrifugal_force,
        creep_limit=arcs.creep_limit,
        motor=none,
        found={},
    )


def _sizes(every: Sequence[At], which: Integers, arcs: Arcs, *, alone: bool) -> Sizes[Array]:
    given = Sizes(*np.array([sizes_of(at.drive, at.case, at.pulley) for at in every]).T[:, which])
    none, idle = np.full(len(arcs), math.nan), idle_rows(arcs.entry_tension, arcs.exit_tension)
    pull = np.where(idle, none, arcs.entry_tension - arcs.exit_tension)
    return given._replace(
        width=arcs.belt_width,
        modulus=arcs.belt_modulus,
        speed=arcs.belt_speed,
        diameter=arcs.diameter,
        idle_wrap=np.where(idle, arcs.wrap_angle, none),
        wrap_angle=np.where(idle, none, arcs.wrap_angle),
        creep_limit=arcs.creep_limit,
        overrun=arcs.overrun,
        thickness=arcs.lagging_thickness,
        shear_modulus=arcs.shear_modulus,
        compression_modulus=arcs.compression_modulus,
        entry=arcs.entry_tension,
        leaving=arcs.exit_tension,
        pull=pull if alone else none,
        mass=masses_at([at.drive.belt for at in every], which, arcs.belt_width),
    )


def _row(state: State[Array], which: Any) -> State[Any]:
    """Return some rows of a state that is not solved, or one as plain numbers."""
    numbers = (f.name for f in fields(state) if f.name != "found")
    return State(**{name: getattr(state, name)[which] for name in numbers}, found={})


def _joined_states(states: Sequence[State[Array]]) -> State[Array]:
    numbers = [f.name for f in fields(states[0]) if f.name != "found"]
    columns = {name: np.concatenate([getattr(s, name) for s in states]) for name in numbers}
    return State(**columns, found={})


def _open_trims(
    drives: Sequence[Drive],
    which: Integers,
    index: int,
    tensions: tuple[Array, Array],
    diameters: Array | None,
) -> Flags:
    """Whether the trim of a pulley against the first of the driven ones is open."""
    entry, leaving = tensions
    driven = ~idle_rows(entry, leaving).T
    first = driven.argmax(axis=1)
    if diameters is None:
        diameters = np.array([[p.diameter for p in d.pulleys] for d in drives])[which].T
    unknown = np.array(
        [[_is_unknown(d, one, d.pulleys[index]) for one in d.pulleys] for d in drives]
    )
    sides = np.array([[one.side != d.pulleys[index].side for one in d.pulleys] for d in drives])
    other = diameters[first, np.arange(len(which))]
    along = trim_shift(other, diameters[index], False)
    across = COVERS_APART / (0.5 * np.minimum(other, diameters[index]))
    shifts = np.where(sides[which, first], across, along) > LEAST_SHIFT
    there = unknown[which, first] & driven[:, index] & (first != index)
    return np.asarray(there & shifts)


def _is_unknown(drive: Drive, *pulleys: Pulley) -> bool:
    """Whether the offset of the tension member is not known at some pulleys."""
    return any(pitch_offset(drive.belt, pulley.side) is None for pulley in pulleys)


def _factors(drives: Sequence[Drive], which: Integers, pulley: str, wrap_angle: Array) -> Array:
    """Wrap factors of the design standard, shape (n,) [-]; drives that agree in it at once.

    Infinite where a chosen standard cannot be applied.
    """
    found = np.full(len(which), math.nan)
    alike: dict[object, list[int]] = {}
    for place, drive in enumerate(drives):
        criteria, lagging = drive.criteria, drive.pulley(pulley).lagging
        key = (criteria.standard, criteria.take_up, lagging.surface, lagging.condition)
        alike.setdefault(key, []).append(place)
    for places in alike.values():
        of, rows = drives[places[0]], np.flatnonzero(np.isin(which, places))
        criteria, lagging = of.criteria, of.pulley(pulley).lagging
        factors = wrap_factors(criteria.standard, criteria.take_up, lagging, wrap_angle[rows])
        if criteria.standard.name not in ("", "none"):  # one that was chosen is held against
            factors = np.where(np.isnan(factors), math.inf, factors)
        found[rows] = factors
    return found


def worst_of_rows(
    solved: BatchResult, held: Held, factors: tuple[Array, Array], setting: Setting
) -> tuple[Codes, Codes, Array]:
    """Return the verdict of every arc, the check that governs it, and its place in the order.

    As `judge` finds them for one pulley in one load case, but for the energy balance of the
    solution, which a batch does not report.

    Parameters
    ----------
    solved
        The arcs, solved.
    held
        What they are held against.
    factors
        Factors on the friction and the slips of each law, shape (n,) each [-].
    setting
        How accurately the pull at which a belt slides is found.

    Returns
    -------
    level, governing, margin
        Places in `LEVELS` and `NAMES`, and what `order_of` gives of the check, shape (n,) each.
    """
    n = len(solved.arcs)
    level, governing = np.zeros(n, dtype=np.int8), np.zeros(n, dtype=np.int8)
    least = np.full(n, math.inf)
    for check in row_checks(solved, held, factors, setting):
        ranks, orders = check.rank, _orders(check)
        worse = (ranks > level) | ((ranks == level) & (ranks > 0) & (orders < least))
        worse |= (ranks > 0) & (governing == 0)
        level = np.where(worse, ranks, level).astype(np.int8)
        least = np.where(worse, orders, least)
        governing = np.where(worse, NAMES.index(check.rule.name), governing).astype(np.int8)
    lost = solved["status"] == REFUSED
    level[lost], governing[lost] = 0, 0
    return level, governing, least


def _orders(check: RowCheck) -> Array:
    """Return the place of a check among those of its level, as `order_of` gives it."""
    missed, name = check.rank > Level.OK.rank, check.rule.name
    fails = check.rank == Level.FAILS.rank
    kind = np.where(fails, kind_of(name, True), kind_of(name, False))
    used = used_of_rows(check.margin, at_most=check.rule.at_most)
    shares = np.where(np.isfinite(used), np.minimum(used, MOST_USED), MOST_USED)
    shares = np.floor(shares / ALIKE + 0.5) * ALIKE
    alone = np.where(np.isfinite(used), -shares, math.inf)
    return np.where(missed, kind * KIND_STEP - shares, alone)


def used_of_rows(margins: Array, *, at_most: bool) -> Array:
    """Return how much of a limit is used, by its margin: see `used_of` [-]."""
    if at_most:
        return np.asarray(1.0 - margins)
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 / np.maximum(1.0 + margins, 0.0))


def row_checks(
    solved: BatchResult,
    held: Held,
    factors: tuple[Array, Array],
    setting: Setting,
    rules: Sequence[Rule] = OF_ROWS,
    wanted: Wanted = MappingProxyType({}),
) -> Iterator[RowCheck]:
    """Yield what each rule finds of every arc; parameters as of `worst_of_rows`.

    `wanted` is where checks that solve arcs anew are made, shape (n,); everywhere unless given.
    """
    arcs, n = solved.arcs, len(solved.arcs)
    none = np.full(n, math.nan)
    idle = idle_rows(arcs.entry_tension, arcs.exit_tension)
    of_course = {"largest_slip": solved.largest_slip, "slip_speed": solved.slip_speed}
    names = {rule.result for rule in rules if rule.result}
    found = {n: of_course[n] if n in of_course else np.abs(solved[n]) for n in names}
    state = replace(held.state, found=found)
    flags = {
        CONDITION: held.scaled,
        FIT: held.misfit,
        BELT_THICKNESS: held.open_trim,
        CASE_KIND: held.misnamed,
    }
    for rule in rules:
        if rule is GROSS_SLIP:
            yield gross_slip_of(solved, held, wanted.get(rule))
        elif rule is DESIGN_STANDARD:
            standard = np.where(idle, none, held.standard)
            yield _compared(rule, held, state.slack, standard)
        elif rule is COVER_CREEP:
            there = solved.solved & (held.cover_left_out > 0.0) & wanted.get(rule, True)
            if there.any():
                creep = _covered_creep(arcs, held, factors, setting, np.flatnonzero(there))
                limit = np.where(there, arcs.creep_limit, none)
                yield _compared(rule, held, creep, limit)
        elif rule is WET_CREEP:
            dry = kept_rows(np.abs(solved["exit_creep"]), arcs.creep_limit, at_most=True)
            asked = solved.solved & dry & ~idle & wanted.get(rule, True)
            wet = np.where(asked, held.wet_factor, none)
            creep = wet_creeps(arcs, wet, factors, setting)
            limit = np.where(wet > 0.0, arcs.creep_limit, none)
            yield _compared(rule, held, creep, limit)
        elif rule is USUAL_RULE:
            yield RowCheck(rule, *_usual_sizes(held), none, none)
        elif rule in flags:
            ranks = np.where(flags[rule], rule.missed.rank, 0)
            yield RowCheck(rule, ranks, np.full(len(arcs), math.inf), none, none)
        elif rule.result or rule.value is not None:
            value, limit = rule.compared(state), held.limit(rule)
            there = ~np.isnan(value) & (solved.solved | (not rule.result))
            limit = np.where(there & ~(idle & rule.pulls), limit, none)
            yield _compared(rule, held, _rounded(rule, value, limit, state), limit)


def _rounded(rule: Rule, value: Array, limit: Array, state: State[Array]) -> Array:
    """Return values, those near their limits as they are rounded."""
    if rule.rounded is None:
        return value
    for i in np.flatnonzero(np.abs(value / limit - 1.0) < _NEAR):  # digits decide
        value[i] = rule.rounded(float(value[i]), float(limit[i]), _row(state, i))
    return value


def _compared(rule: Rule, held: Held, value: Array, limit: Array) -> RowCheck:
    """Return the check of a value against a limit; of a limit of nan there is none."""
    missed, firm = np.full(len(value), rule.missed.rank), held.firm.get(rule.name)
    if firm is not None:
        missed[firm] = Level.FAILS.rank
    fails = rule.fails_beyond
    missed[value > fails if rule.at_most else value < fails] = Level.FAILS.rank
    if rule is not DESIGN_STANDARD or firm is None:
        ranks, margins = _ranks(value, limit, missed, at_most=rule.at_most)
    else:
        never = np.isinf(limit)  # it cannot be applied
        ranks, margins = _ranks(
            value, np.where(never, math.nan, limit), missed, at_most=rule.at_most
        )
        ranks = np.where(never, missed, ranks)
        margins = np.where(never, math.nan, margins)
    return RowCheck(rule, ranks, margins, value, limit)


def _covered_creep(
    arcs: Arcs,
    held: Held,
    factors: tuple[Array, Array],
    setting: Setting,
    which: NDArray[np.intp],
) -> Array:
    """Creep of some arcs with the cover of the belt in series [m]; infinite where it slips."""
    some, found = arcs.rows(which), np.full(len(arcs), math.nan)
    covered = replace(some, cover_compliance=some.cover_compliance + held.cover_left_out[which])
    friction, slip = (factor[which] for factor in factors)
    again = solve_scaled(covered, friction, slip, setting=setting, parts=row.RATIO)
    found[which] = np.where(again.solved, np.abs(again["exit_creep"]), math.inf)
    return found


def interval_of(
    solved: BatchResult,
    held: Held,
    laws: Sequence[Fitted],
    factors: tuple[Array, Array],
    where: Flags | None = None,
) -> RowCheck:
    """Return the creep at the far end of the interval of fitted laws, of some arcs.

    Where the creep itself exceeds the limit it stands for that of the end, which is larger still.
    """
    arcs = solved.arcs
    creep = np.abs(solved["exit_creep"])
    fitted = np.array([of.has_knots for of in laws])[arcs.law] & solved.solved
    value = np.where(fitted, creep, math.nan)
    asked = fitted & kept_rows(creep, arcs.creep_limit, at_most=True)
    which = np.flatnonzero(asked if where is None else asked & where)
    if len(which):
        friction, slip = (factor[which] for factor in factors)
        ends = farthest_creeps(arcs.rows(which), laws, (friction, slip), solved.setting)
        value[which] = ends
    return _compared(CREEP_INTERVAL, held, value, np.where(fitted, arcs.creep_limit, math.nan))


def kept_rows(value: Array, limit: Array, *, at_most: bool) -> Flags:
    """Return which values keep their limits, compared in four digits as `keeps` does."""
    return _kept(value, limit, at_most)[0]


def _kept(value: Array, limit: Array, at_most: bool) -> tuple[Flags, Array]:
    kept = (value <= limit) if at_most else (value >= limit)
    with np.errstate(invalid="ignore", divide="ignore"):
        margins = margin_to(value, limit, at_most=at_most)
    near = np.flatnonzero(~kept & (np.abs(margins) < _NEAR))
    for i in near:  # few: the digits decide
        kept[i] = keeps(float(value[i]), float(limit[i]), at_most=at_most)
    return kept, margins


def _ranks(value: Array, limit: Array, missed: Array, *, at_most: bool) -> tuple[Array, Array]:
    """Rank of the level and margin of a check; 0 where nothing is compared."""
    compared = ~np.isnan(limit)
    kept, margins = _kept(value, limit, at_most)
    ranks = np.where(kept, Level.OK.rank, missed)
    margins = np.where(np.isnan(margins), np.where(kept, math.inf, -math.inf), margins)
    return np.where(compared, ranks, 0), np.where(compared, margins, math.inf)


def gross_slip_of(solved: BatchResult, held: Held, where: Flags | None = None) -> RowCheck:
    """Return the safety against gross slip of some arcs, and of those that are not solved."""
    if where is None or where.all():
        return _gross_slip(solved, held)
    which, n = np.flatnonzero(where | ~solved.solved), len(where)
    found = _gross_slip(solved.rows(which), held.rows(which))
    columns = np.zeros(n, dtype=found.rank.dtype), np.full(n, math.inf), *np.full((2, n), math.nan)
    for column, some in zip(
        columns, (found.rank, found.margin, found.value, found.limit), strict=True
    ):
        column[which] = some
    return RowCheck(GROSS_SLIP, *columns)


def _gross_slip(solved: BatchResult, held: Held) -> RowCheck:
    """Return the safety against gross slip."""
    arcs, status, limit = solved.arcs, solved["status"], held.safety
    gone, fault = status == BREAKAWAY, status == UNSOLVED
    idle = idle_rows(arcs.entry_tension, arcs.exit_tension) & (status == SOLVED)
    factor, cause = slides_of(solved.growing(held.tight_rise, held.slack_rise))
    missed = np.full(len(factor), GROSS_SLIP.missed.rank)
    missed[(factor < GROSS_SLIP.fails_beyond) & (cause != TESTED)] = Level.FAILS.rank
    ranks, margins = _ranks(factor, limit, missed, at_most=False)
    ranks, margins = np.where(idle, Level.OK.rank, ranks), np.where(idle, math.inf, margins)
    ranks = np.where(np.isnan(factor), 0, ranks)
    ranks = np.where(gone, NO_GRIP.rank, ranks)
    ranks = np.where(fault, Level.FAULT.rank, ranks)
    return RowCheck(GROSS_SLIP, ranks, margins, factor, limit)


def _usual_sizes(held: Held) -> tuple[Array, Array]:
    """Return rank and margin of the sizes that conveyor drives have."""
    missed = USUAL_RULE.missed.rank
    ranks, margins = np.where(np.isfinite(held.odd), missed, Level.OK.rank), held.odd
    values: list[Any] = compared_sizes(held.sizes)
    for value, (least, most) in zip(values, USUAL_SIZES, strict=True):
        low, high = unusual_rows(value, (least, most))
        with np.errstate(divide="ignore", invalid="ignore"):
            under = np.where(low, margin_to(value, least, at_most=False), math.inf)
            found = np.where(high, margin_to(value, most, at_most=True), under)
        ranks = np.where(low | high, missed, ranks)
        margins = np.minimum(margins, found)
    return ranks, margins
