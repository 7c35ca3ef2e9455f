"""The checks of many arcs at once, by the same rules: a verdict and what governs it, row by row."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.quantities import BREAKAWAY, REFUSED, SOLVED, UNSOLVED
from wraparc.arc.wrap_arc import of_belt
from wraparc.arrays import Array, Codes, Flags, Integers
from wraparc.batch import BatchResult, Setting
from wraparc.batch.arcs import Arcs
from wraparc.batch.scaled import solve_scaled
from wraparc.checks.check import ADVICE, Level, ahead, behind, keeps, margin_to
from wraparc.checks.design_standard import wrap_factors
from wraparc.checks.gross_slip import given_up, rises_of
from wraparc.checks.numbers import (
    IDLE,
    NUMBERLESS,
    USUAL_SIZES,
    Sizes,
    compared_sizes,
    safety_of,
)
from wraparc.checks.of_drive import open_shift
from wraparc.checks.rules import (
    ACROSS_CHECKS,
    LEAST_RATED,
    NO_GRIP,
    RULES,
    asked_safety,
    start_factor,
    tension_factor,
    wrap_pressure,
)
from wraparc.checks.sliding import CREEP, NOT_CARRIED, TESTED
from wraparc.checks.sliding_rows import LoadedRows, pulls_at_sliding
from wraparc.checks.usual import least_margin
from wraparc.drive import Drive
from wraparc.drive.changes import WORN
from wraparc.drive.conditions import SCALED

#: Words of a verdict by its code; a row that is no drive at all is not checked.
LEVELS = tuple(Level)
_NOT_OF_ROWS = (
    "creep_interval", "balance", "train_balance", "motor_heat", "taut",
)  # fmt: skip
#: Checks by their code: what governs a row. "" where nothing could be checked.
NAMES = (
    "",
    *(name for name in RULES if name not in _NOT_OF_ROWS),
    *sorted(ACROSS_CHECKS),
)
#: What `judge` checks of one drive and no row is checked for, in words.
NOT_CHECKED = (
    "the energy balance of each solution",
    "the interval of the creep by a fitted law (draw the law instead)",
    "the torque of motors, where the load of a train is not divided anew in every row",
)
#: Fields of `Held` on motors, known where the load of a train is divided anew.
MOTORS = ("motor", "motor_load", "momentary_load")
#: Relative distance within which two numbers may be the same in the digits that are shown.
_NEAR = 2e-3


@dataclass(frozen=True, eq=False, kw_only=True)
class Held:
    """What arcs are held against beside their laws, columns of shape (n,), nan where nothing is.

    Attributes
    ----------
    safety
        Safety factor on gross slip [-].
    tight_rise, slack_rise
        How the tensions grow with the pull of the whole drive, see `rises` [N].
    standard
        Slack-side tension that the design standard asks for [N]; infinite where a chosen one
        cannot be applied.
    binding
        Whether the standard binds.
    alone
        Whether no other pulley pulls the belt.
    rating, strength, mass
        Of the belt [N/m, kg/m].
    cover_left_out
        h_b/G_b of a belt cover that the slip of the law may include or not [m/Pa].
    belt_tension, momentary_tension
        Largest tension: one of them, by the kind of the load case [N].
    belt_safety, customary
        Least strength over tension [-], and whether no rating to rely on asks for it.
    face_pressure, bond_stress, fatigue_stress
        Largest pressures and stresses [Pa].
    slack, sag
        Tension of the slack end of the whole drive where the belt leaves it here, and the least of
        it [N].
    diameter
        Least diameter [m].
    scaled
        Whether the law was not tested in its condition, but scaled to it, or before wear.
    misfit
        Whether the law does not describe its tests.
    open_trim
        Whether the trim against another drum is open without the thickness of the belt.
    odd
        Least margin of sizes beside those of the arc that are asked about, infinite for none [-].
    motor, motor_load, momentary_load
        Torque of the motors over the rated one, and the largest of it: one of them, by the kind of
        the load case [-].
    """

    safety: Array
    tight_rise: Array
    slack_rise: Array
    standard: Array
    binding: Flags
    alone: Flags
    rating: Array
    strength: Array
    mass: Array
    cover_left_out: Array
    belt_tension: Array
    momentary_tension: Array
    belt_safety: Array
    customary: Flags
    face_pressure: Array
    bond_stress: Array
    fatigue_stress: Array
    slack: Array
    sag: Array
    diameter: Array
    scaled: Flags
    misfit: Flags
    open_trim: Flags
    odd: Array
    motor: Array
    motor_load: Array
    momentary_load: Array

    def rows(self, which: slice | Integers) -> Held:
        """Return some of the rows."""
        return replace(self, **{f.name: getattr(self, f.name)[which] for f in fields(self)})


def held_by(
    drives: Sequence[Drive],
    which: Integers,
    pulley: str,
    load_case: str,
    arcs: Arcs,
    tensions: tuple[Array, Array],
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
    """
    entry, leaving = tensions
    names = [p.name for p in drives[0].pulleys]
    index = names.index(pulley)
    numbers = np.array([_numbers(d, pulley, load_case) for d in drives], dtype=float).T
    (
        safety, start, binding, running, momentary, face, bond, fatigue, sag, least, scaled,
        misfit, rating, strength, mass, cover, odd, asked,
    ) = (column[which] for column in numbers)  # fmt: skip
    lost = np.zeros(len(arcs))
    for take_up in {d.criteria.take_up for d in drives}:
        places = [i for i, d in enumerate(drives) if d.criteria.take_up == take_up]
        rows = np.flatnonzero(np.isin(which, places))
        lost[rows] = given_up((entry - leaving)[:, rows], names, take_up)
    tight_rise, slack_rise = rises_of(entry - leaving, index, lost)
    driving = entry[0] >= leaving[-1]
    slack = np.full(len(arcs), math.nan)
    for place, end, side in ((len(entry) - 1, leaving[-1], driving), (0, entry[0], ~driving)):
        if place == index:
            slack = np.where(side, end, slack)
    factors = _factors(drives, which, pulley, arcs.wrap_angle)
    never = np.isinf(factors)
    pull = start * np.abs(arcs.entry_tension - arcs.exit_tension)
    standard = np.where(never, math.inf, np.where(never, 0.0, factors) * pull)
    return Held(
        safety=safety,
        tight_rise=tight_rise,
        slack_rise=slack_rise,
        standard=standard,
        binding=binding > 0.0,
        alone=np.full(len(arcs), len(names) == 1),
        rating=rating,
        strength=strength,
        mass=mass,
        cover_left_out=cover,
        belt_tension=running * arcs.belt_width,
        momentary_tension=momentary * arcs.belt_width,
        belt_safety=asked,
        customary=np.isnan(rating) | (strength < LEAST_RATED * rating),
        face_pressure=face,
        bond_stress=bond,
        fatigue_stress=fatigue,
        slack=slack,
        sag=sag,
        diameter=least,
        scaled=scaled > 0.0,
        misfit=misfit > 0.0,
        open_trim=_open_trims(drives, which, index, tensions),
        odd=odd,
        **dict.fromkeys(MOTORS, np.full(len(arcs), math.nan)),
    )


def _numbers(drive: Drive, pulley: str, load_case: str) -> tuple[float | None, ...]:
    criteria, belt, kind = drive.criteria, drive.belt, drive.load_case(load_case).kind
    lagging = drive.pulley(pulley).lagging
    allowed = tension_factor(belt, kind) * belt.rating if belt.rating is not None else None
    return (
        criteria.safety.of(kind),
        start_factor(criteria, kind),
        float(criteria.standard.binding),
        allowed if kind == "running" else None,
        allowed if kind != "running" else None,
        belt.largest_wrap_pressure,
        lagging.bond_strength,
        lagging.fatigue_limit,
        criteria.sag.tension if criteria.sag is not None else None,
        belt.least_pulley_diameter,
        float(SCALED in lagging.sources or WORN in lagging.sources),
        float(lagging.fit is not None and bool(lagging.fit.misfit)),
        belt.rating,
        belt.breaking_strength,
        belt.mass,
        of_belt(belt, drive.pulley(pulley).side, lagging.law)["cover_left_out"],
        least_margin(drive),
        asked_safety(belt, kind),
    )


def _open_trims(
    drives: Sequence[Drive], which: Integers, index: int, tensions: tuple[Array, Array]
) -> Flags:
    """Whether a trim that a pulley takes part in is open, that of the driven ones to the first."""
    entry, leaving = tensions
    driven = ~_idle(entry, leaving).T
    first = driven.argmax(axis=1)
    shifts = np.array(
        [
            [[open_shift(d.belt, one, other) > 0.0 for other in d.pulleys] for one in d.pulleys]
            for d in drives
        ]
    )
    with_first = shifts[which, first] & driven
    found = np.where(first == index, with_first.any(axis=1), with_first[:, index])
    return np.asarray(found & driven[:, index])


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
    """Return the verdict of every arc, the check that governs it, and by which margin.

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
        Places in `LEVELS` and `NAMES`, and the margin, shape (n,) each.
    """
    n = len(solved.arcs)
    level, governing = np.zeros(n, dtype=np.int8), np.zeros(n, dtype=np.int8)
    least = np.full(n, math.inf)
    for name, ranks, margins in _checks(solved, held, factors, setting):
        worse = (ranks > level) | ((ranks == level) & (ranks > 0) & (margins < least))
        worse |= (ranks > 0) & (governing == 0)
        level = np.where(worse, ranks, level).astype(np.int8)
        least = np.where(worse, margins, least)
        governing = np.where(worse, NAMES.index(name), governing).astype(np.int8)
    lost = solved["status"] == REFUSED
    level[lost], governing[lost] = 0, 0
    return level, governing, least


def _checks(
    solved: BatchResult, held: Held, factors: tuple[Array, Array], setting: Setting
) -> Iterator[tuple[str, Array, Array]]:
    """Yield name, rank of the level and margin of every check in the order of `RULES`."""
    yield _gross_slip(solved, held, factors, setting)
    for name, value, limit in _compared(solved, held, factors, setting):
        missed = np.full(len(value), RULES[name].missed.rank)
        if name == "design_standard":
            missed[held.binding] = Level.FAILS.rank
        if name == "belt_safety":
            missed[~held.customary] = Level.FAILS.rank
        fails = RULES[name].fails_beyond
        missed[value > fails if RULES[name].at_most else value < fails] = Level.FAILS.rank
        never = np.isinf(limit) & (name == "design_standard")
        ranks, margins = _ranks(
            value, np.where(never, math.nan, limit), missed, at_most=RULES[name].at_most
        )
        # what has no number comes first where it binds a design, and last where it does not
        first = np.where(held.binding, NUMBERLESS, math.inf)
        ranks, margins = np.where(never, missed, ranks), np.where(never, first, margins)
        advice = ranks > Level.OK.rank
        advice &= ~held.binding if name == "design_standard" else name in ADVICE
        margins = np.where(advice & np.isinf(value), math.inf, margins)  # has no number: last
        yield name, ranks, np.where(advice, behind(margins), margins)
        if name == "tested_pressure_min":
            for told, flags in (("condition", held.scaled), ("fit", held.misfit)):
                ranks = np.where(flags, RULES[told].missed.rank, 0)
                yield told, ranks, np.full(len(value), math.inf)
    ranks = np.where(held.open_trim, RULES["belt_thickness"].missed.rank, 0)
    yield "belt_thickness", ranks, np.full(len(ranks), math.inf)
    yield _usual_sizes(solved.arcs, held)


def _compared(
    solved: BatchResult, held: Held, factors: tuple[Array, Array], setting: Setting
) -> Iterator[tuple[str, Array, Array]]:
    """Yield name, value and limit of what is compared; a limit of nan is none."""
    arcs = solved.arcs
    tight = np.maximum(arcs.entry_tension, arcs.exit_tension)
    slack = np.minimum(arcs.entry_tension, arcs.exit_tension)
    low, high, slip_max = arcs.laws.tested[arcs.law].T
    speed, pulls = arcs.laws.tested_speed[arcs.law], ~_idle(arcs.entry_tension, arcs.exit_tension)
    yield "design_standard", slack, np.where(pulls, held.standard, math.nan)
    yield "creep", np.abs(solved["exit_creep"]), _where(solved.solved, arcs.creep_limit)
    there = solved.solved & (held.cover_left_out > 0.0)
    if there.any():
        creep = _covered_creep(arcs, held, factors, setting, np.flatnonzero(there))
        yield "cover_creep", creep, _where(there, arcs.creep_limit)
    yield "belt_tension", tight, held.belt_tension
    yield "momentary_tension", tight, held.momentary_tension
    yield "belt_safety", _safety(held, arcs, tight), held.belt_safety
    pressure = wrap_pressure(tight, arcs.belt_width, arcs.diameter, arcs.centrifugal_force)
    yield "face_pressure", pressure, held.face_pressure
    stress = solved["peak_shear_stress"]
    yield "bond_stress", stress, _where(solved.solved, held.bond_stress)
    yield "fatigue_stress", stress, _where(solved.solved, held.fatigue_stress)
    yield "tested_pressure_max", pressure, high
    yield (
        "tested_pressure_min",
        wrap_pressure(slack, arcs.belt_width, arcs.diameter, arcs.centrifugal_force),
        low,
    )
    yield "tested_slip", solved.largest_slip, _where(solved.solved, slip_max)
    slips = solved.slip_speed
    yield "tested_slip_speed", slips, _where(solved.solved & ~np.isnan(slips), speed)
    yield "sag", held.slack, _where(~np.isnan(held.slack), held.sag)
    yield "pulley_diameter", arcs.diameter, _where(pulls, held.diameter)
    yield "motor_load", held.motor, held.motor_load
    yield "momentary_load", held.motor, held.momentary_load


def _safety(held: Held, arcs: Arcs, tight: Array) -> Array:
    """Strength of the belt over its tension, as `safety_of` has it [-]."""
    strength = held.strength * arcs.belt_width
    safety = strength / tight
    for i in np.flatnonzero(np.abs(safety / held.belt_safety - 1.0) < _NEAR):  # digits decide
        safety[i] = safety_of(*map(float, (strength[i], tight[i], held.belt_safety[i])))
    return np.asarray(safety)


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
    again = solve_scaled(covered, friction, slip, setting=setting, capacities=False)
    found[which] = np.where(again.solved, np.abs(again["exit_creep"]), math.inf)
    return found


def _where(there: Flags, limit: Array) -> Array:
    return np.where(there, limit, math.nan)


def _idle(entry: Array, leaving: Array) -> Flags:
    return np.asarray(np.abs(entry - leaving) <= IDLE * entry)


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


def _gross_slip(
    solved: BatchResult, held: Held, factors: tuple[Array, Array], setting: Setting
) -> tuple[str, Array, Array]:
    """Return name, rank and margin of the safety against gross slip."""
    arcs, status, limit = solved.arcs, solved["status"], held.safety
    gone, idle, fault = (
        status == BREAKAWAY,
        _idle(arcs.entry_tension, arcs.exit_tension) & (status == SOLVED),
        status == UNSOLVED,
    )
    factor, cause = np.full(len(arcs), math.inf), np.full(len(arcs), CREEP, dtype=np.int8)
    which = np.flatnonzero(~(idle | fault) & (status != REFUSED))
    friction, slip = factors
    of = LoadedRows.of(arcs, friction_factor=friction, slip_factor=slip, setting=setting)
    of = replace(of, peaks=of.peaks & ~np.isposinf(solved["gross_slip_creep"]))
    rises = held.tight_rise[which], held.slack_rise[which]
    factor[which], cause[which] = pulls_at_sliding(of.rows(which), rises)
    factor = np.where(gone, np.minimum(factor, NOT_CARRIED), factor)
    missed = np.full(len(factor), RULES["gross_slip"].missed.rank)
    missed[(factor < RULES["gross_slip"].fails_beyond) & (cause != TESTED)] = Level.FAILS.rank
    ranks, margins = _ranks(factor, limit, missed, at_most=False)
    ranks, margins = np.where(idle, Level.OK.rank, ranks), np.where(idle, math.inf, margins)
    ranks = np.where(np.isnan(factor), 0, ranks)
    ranks = np.where(gone, NO_GRIP.rank, ranks)
    ranks = np.where(fault, Level.FAULT.rank, ranks)
    leads = ranks == Level.FAILS.rank
    return "gross_slip", ranks, np.where(leads, ahead(margins), margins)


def _usual_sizes(arcs: Arcs, held: Held) -> tuple[str, Array, Array]:
    """Return name, rank and margin of the sizes that conveyor drives have."""
    missed = RULES["usual_sizes"].missed.rank
    ranks, margins = np.where(np.isfinite(held.odd), missed, Level.OK.rank), held.odd
    idle = _idle(arcs.entry_tension, arcs.exit_tension)
    pull = np.where(idle | ~held.alone, math.nan, arcs.entry_tension - arcs.exit_tension)
    wraps = (np.where(of, arcs.wrap_angle, math.nan) for of in (idle, ~idle))
    given: Any = [
        arcs.belt_width, arcs.belt_modulus, arcs.belt_speed, arcs.diameter, *wraps,
        arcs.creep_limit, arcs.overrun, arcs.lagging_thickness, arcs.shear_modulus,
        arcs.compression_modulus, held.rating, held.strength, held.bond_stress, held.fatigue_stress,
        held.face_pressure, held.diameter, held.sag, arcs.entry_tension, arcs.exit_tension, pull,
        held.mass,
    ]  # fmt: skip
    values: list[Any] = compared_sizes(Sizes(*given))
    for value, (least, most) in zip(values, USUAL_SIZES, strict=True):
        low, high = value < least, (value > most) & np.isfinite(value)
        with np.errstate(divide="ignore", invalid="ignore"):
            under = np.where(low, margin_to(value, least, at_most=False), math.inf)
            found = np.where(high, margin_to(value, most, at_most=True), under)
        ranks = np.where(low | high, missed, ranks)
        margins = np.minimum(margins, found)
    return "usual_sizes", ranks, margins
