"""Faults of laboratories that their data show, kind by kind: how many are told OK?

    python benchmarks/shear_test_faults.py --laboratories 20 --readings 250 2000

The laboratories are drawn here, from closed forms, not by the virtual rig of the package: friction
mu = M r (1 - ln r) with r = x/X and a line behind the peak, M and X powers of pressure, travel =
lash + x + K p mu by a table, and its own noise, scatter of samples, lash of every test, order and
resolution. A kind puts one fault into a sound laboratory. **False OK** is the share of faulty ones
that are told OK; **false ATTENTION** that of sound ones that are not; and at the tested pressures
the 95 % intervals of peak friction and slip are held against the truth.
"""

import argparse
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from wraparc.answer.shear_test_tables import verdict
from wraparc.checks import Level
from wraparc.errors import InputError
from wraparc.shear_test import MachineRecord, PlannedTest, PlanResult, Rig, TestPlan, fit_plan
from wraparc.shear_test.apart import drawn
from wraparc.shear_test.budget import Uncertainty
from wraparc.shear_test.consistency import USUAL
from wraparc.shear_test.digitised import with_curves
from wraparc.shear_test.one_way import step_over_pressure
from wraparc.shear_test.plan import Digitised
from wraparc.units import in_units

PRESSURES = (35e3, 60e3, 90e3, 140e3, 200e3, 290e3, 420e3, 650e3)
AREA, FACES = 0.04, 2
DESIGNS = (3, 4, 5, 6, 8)
Array = Any


@dataclass
class Drawn:
    """One test: what is true of it, and what is recorded."""

    pressure: float
    order: int
    lash: float
    top: float
    peak: float
    travel: Array
    friction: Array
    force: Array = field(default_factory=lambda: np.zeros(0))
    normal: Array | None = None
    file: str = ""
    planned: dict[str, Any] = field(default_factory=dict)

    def shift(self) -> Array:
        """Pulling force without noise [N]."""
        return FACES * self.pressure * AREA * self.friction


@dataclass
class Laboratory:
    """Tests of one rubber, and how it is planned and measured."""

    rng: Any
    tests: list[Drawn]
    law: tuple[float, float, float, float]
    noise: float
    measured: bool
    gains: Array = field(default_factory=lambda: np.ones(4))

    def peaks(self, pressure: Array) -> tuple[Array, Array]:
        """True peak slip [m] and friction."""
        top, power, slip, growth = self.law
        return slip * (pressure / 1e5) ** growth, top * (pressure / 1e5) ** -power


def law_friction(x: Array, top: float, peak: float, slope: float) -> Array:
    """M r (1 - ln r), and a falling line behind the peak."""
    r = np.clip(x / peak, 1e-12, 1.0)
    rising = top * r * (1.0 - np.log(r))
    return np.where(x > peak, np.maximum(top * (1.0 - slope * (x / peak - 1.0)), 0.6 * top), rising)


Shape = Callable[[Array, float, float, float], Array]


def draw(seed: int, readings: int, shape: Shape = law_friction) -> Laboratory:
    """Draw a sound laboratory."""
    rng = np.random.default_rng([seed, readings])
    count = DESIGNS[seed % len(DESIGNS)]
    inner = sorted(rng.choice(np.arange(1, 7), count - 2, replace=False).tolist())
    levels = [PRESSURES[k] for k in (0, *inner, 7)]
    power = rng.uniform(0.15, 0.35)
    law = (rng.uniform(0.6, 1.1), power, rng.uniform(5e-3, 9e-3), rng.uniform(0.0, 0.15))
    measured, slope = bool(rng.random() < 0.5), rng.uniform(0.0, 0.15)
    order = rng.permutation(2 * count) + 1
    lab = Laboratory(rng, [], law, rng.uniform(0.003, 0.01), measured)
    # Errors of the rig, common to its tests: pull, load, travel, area, as a plan without a budget.
    lab.gains = 1.0 + 0.01 * rng.uniform(-1.0, 1.0, 4)
    stroke, compliance = rng.uniform(14e-3, 17e-3), rng.uniform(0.0, 0.05e-6)
    for k, pressure in enumerate(np.repeat(levels, 2)):
        slip, friction = lab.peaks(pressure)
        top, peak = friction * np.exp(0.02 * rng.normal()), slip * np.exp(0.03 * rng.normal())
        lash = float(rng.uniform(0.1e-3, 0.9e-3))
        travel = np.linspace(0.0, stroke, readings)
        fine = np.linspace(0.0, 1.0, 20001) ** 3 * stroke
        bend = compliance * FACES * pressure * AREA
        mu = shape(fine, float(top), float(peak), slope)
        x = np.interp(travel - lash, fine + bend * mu, fine, left=0.0)
        friction = np.where(travel > lash, shape(x, float(top), float(peak), slope), 0.0)
        test = Drawn(
            float(pressure), int(order[k]), lash, float(top), float(peak), travel, friction
        )
        test.file = f"t{k:02d}"
        test.force = test.shift()
        lab.tests.append(test)
    return lab


def record(lab: Laboratory) -> None:
    """Add the noise of the readings."""
    for test in lab.tests:
        count, largest = len(test.travel), float(np.abs(test.force).max())
        test.force = test.force + lab.noise * largest * lab.rng.normal(size=count)
        if lab.measured and test.normal is None:
            wander = 1.0 + 0.003 * lab.rng.normal(size=count)
            test.normal = test.pressure * AREA * wander


def fit(lab: Laboratory) -> PlanResult:
    """Fit what the laboratory recorded."""
    records: dict[str, MachineRecord] = {}
    tests = []
    for k, test in enumerate(lab.tests, start=1):
        count = len(test.travel)
        records[test.file] = MachineRecord(
            file=test.file, place="", encoding="", delimiter="", decimal=".", columns=(),
            travel=np.round(lab.gains[2] * test.travel, 7),
            force=np.round(lab.gains[0] * test.force, 2),
            normal_force=None if test.normal is None else lab.gains[1] * test.normal,
            time=test.travel / (10e-3 / 60.0),
            lines=np.arange(1, count + 1), rows=count, dropped=(), notes=(), header=(),
            digest=test.file,
        )  # fmt: skip
        said: dict[str, Any] = {"pressure": test.pressure, "order": test.order} | test.planned
        tests.append(PlannedTest(file=test.file, place=f"test[{k}]", **said))
    plan = TestPlan(
        name="drawn", surface="rubber", rig=Rig(area=lab.gains[3] * AREA, faces=FACES),
        tests=tuple(tests), uncertainty=Uncertainty(),
    )  # fmt: skip
    return fit_plan(plan, read=lambda test: records[test.file])


def _levels(lab: Laboratory) -> list[float]:
    return sorted({test.pressure for test in lab.tests})


def _limited(lab: Laboratory) -> None:
    """From a middle pressure on the force is one: something gives way instead of sliding."""
    levels = _levels(lab)
    weak = levels[max(1, len(levels) - 3)]
    limit = float(np.median([t.force.max() for t in lab.tests if t.pressure == weak]))
    for test in lab.tests:
        test.force = limit * np.tanh((test.force / limit) ** 4) ** 0.25


def _limited_sharp(lab: Laboratory) -> None:
    """The same, each test by its own strength within half a per cent, and without a bend."""
    levels = _levels(lab)
    weak = levels[max(1, len(levels) - 3)]
    limit = 0.95 * float(np.median([t.force.max() for t in lab.tests if t.pressure == weak]))
    for test in lab.tests:
        own = limit * np.exp(0.005 * lab.rng.normal())
        soft = 0.02 * own
        test.force = own - soft * np.log1p(np.exp((own - test.force) / soft))
        test.force = test.force - test.force[0]


def _step(lab: Laboratory, factor: float) -> None:
    levels = _levels(lab)
    first = levels[len(levels) // 2]
    for test in lab.tests:
        if test.pressure >= first:
            test.force = test.force * factor


def _step_down(lab: Laboratory) -> None:
    """From a middle pressure on friction is 18 % less: damp, another sample, another cell."""
    _step(lab, 0.82)


def _step_up(lab: Laboratory) -> None:
    _step(lab, 1.18)


def _damp(lab: Laboratory) -> None:
    """The tests of one inner pressure were damp: 12 % less friction, both repeats."""
    levels = _levels(lab)
    damp = levels[len(levels) // 2] if len(levels) > 3 else levels[1]
    for test in lab.tests:
        if test.pressure == damp:
            test.force = 0.88 * test.force


def _two_cells(lab: Laboratory) -> None:
    """Above a middle pressure another cell was used, 7 % off."""
    _step(lab, 1.07)


def _slip_of_repeat(lab: Laboratory, factor: float) -> None:
    rng = lab.rng
    for k in range(0, len(lab.tests), 2):
        if k and rng.random() < 0.5:
            continue
        test = lab.tests[k]
        way = np.maximum(test.travel - test.lash, 0.0)
        test.force = np.interp(way / factor, way, test.force)
        test.force[test.travel < test.lash] = 0.0


def _slips_apart(lab: Laboratory) -> None:
    """Repeats of one pressure differ by 30 % in slip, not in friction."""
    _slip_of_repeat(lab, 1.3)


def _slips_apart_down(lab: Laboratory) -> None:
    _slip_of_repeat(lab, 0.75)


def _copies(lab: Laboratory, change: Callable[[Drawn, Drawn], None]) -> None:
    """Every second test is a copy of the one before, changed; made behind the noise."""
    record(lab)
    lab.noise = 0.0
    for first, second in zip(lab.tests[::2], lab.tests[1::2], strict=True):
        second.travel, second.force = first.travel.copy(), first.force.copy()
        second.normal = None if first.normal is None else first.normal.copy()
        change(first, second)


def _copy_scaled(lab: Laboratory) -> None:
    def change(_: Drawn, second: Drawn) -> None:
        second.force = second.force * lab.rng.uniform(0.97, 1.03)

    _copies(lab, change)


def _copy_slips(lab: Laboratory) -> None:
    """Copies with their travel scaled."""

    def change(_: Drawn, second: Drawn) -> None:
        second.travel = second.travel * lab.rng.uniform(0.97, 1.03)

    _copies(lab, change)


def _copy_resampled(lab: Laboratory) -> None:
    """Copies on another grid, scaled."""

    def change(first: Drawn, second: Drawn) -> None:
        second.travel = np.linspace(0.0, first.travel[-1], int(0.83 * len(first.travel)))
        second.force = np.interp(second.travel, first.travel, first.force)
        second.force = second.force * lab.rng.uniform(0.98, 1.02)
        if second.normal is not None:
            second.normal = np.interp(second.travel, first.travel, second.normal)

    _copies(lab, change)


def _copy_noisy(lab: Laboratory) -> None:
    """Copies with a little noise of their own, a third of that of the first."""

    def change(first: Drawn, second: Drawn) -> None:
        spread = 0.002 * float(first.force.max())
        second.force = second.force * 1.01 + spread * lab.rng.normal(size=len(first.force))

    _copies(lab, change)


def _copy_shifted(lab: Laboratory) -> None:
    """Copies that start some readings later."""

    def change(first: Drawn, second: Drawn) -> None:
        late = 3
        second.travel = first.travel[late:] - first.travel[late]
        second.force = first.force[late:] * 1.01
        if second.normal is not None:
            second.normal = second.normal[late:]

    _copies(lab, change)


def _interpolated(lab: Laboratory) -> None:
    """A pressure in the middle was not tested, but drawn between its neighbours."""
    record(lab)
    lab.noise = 0.0
    levels = _levels(lab)
    middle = levels[len(levels) // 2] if len(levels) > 3 else levels[1]
    below = [t for t in lab.tests if t.pressure == levels[levels.index(middle) - 1]]
    above = [t for t in lab.tests if t.pressure == levels[levels.index(middle) + 1]]
    for own, low, high in zip(
        [t for t in lab.tests if t.pressure == middle], below, above, strict=True
    ):
        part = (middle - low.pressure) / (high.pressure - low.pressure)
        own.travel, own.lash = low.travel.copy(), low.lash
        own.force = (1.0 - part) * low.force + part * high.force


def _standing(lab: Laboratory) -> None:
    """One force stands in all tests: 6 % of the largest of the lightest."""
    light = float(np.median([t.force.max() for t in lab.tests[:2]]))
    for test in lab.tests:
        test.force = test.force + 0.06 * light


def _standing_below(lab: Laboratory) -> None:
    light = float(np.median([t.force.max() for t in lab.tests[:2]]))
    for test in lab.tests:
        test.force = test.force - 0.08 * light


def _teeth(lab: Laboratory, size: float, period: float) -> None:
    """Stick-slip of a given size, its period in readings."""
    for test in lab.tests:
        count = len(test.travel)
        ends = np.cumsum(period * lab.rng.uniform(0.8, 1.2, int(3 * count / period) + 10))
        at = np.arange(count)
        k = np.searchsorted(ends, at)
        left = (ends[k] - at) / np.diff(ends, prepend=0.0)[k]
        test.force = test.force * (1.0 + size * (0.5 - left))


def _teeth_fast(lab: Laboratory) -> None:
    """Stick-slip of 12 %, sampled slower than it swings."""
    _teeth(lab, 0.12, 0.37)


def _teeth_coarse(lab: Laboratory) -> None:
    _teeth(lab, 0.15, 2.3)


def _teeth_slow(lab: Laboratory) -> None:
    _teeth(lab, 0.12, len(lab.tests[0].travel) / 20)


def _filter(lab: Laboratory, length: float) -> None:
    """A first-order low pass behind the noise, its length as travel."""
    record(lab)
    lab.noise = 0.0
    for test in lab.tests:
        keep = float(np.exp(-(test.travel[1] - test.travel[0]) / length))
        out = np.zeros_like(test.force)
        state = float(test.force[0])
        for k, value in enumerate(test.force):
            state = keep * state + (1.0 - keep) * value
            out[k] = state
        test.force = out


def _slow_filter(lab: Laboratory) -> None:
    """A filter whose time constant is 0.8 mm of travel."""
    _filter(lab, 0.8e-3)


def _moving_mean(lab: Laboratory) -> None:
    """A centred running mean over 1.6 mm."""
    record(lab)
    lab.noise = 0.0
    for test in lab.tests:
        width = max(3, int(1.6e-3 / (test.travel[1] - test.travel[0])) | 1)
        padded = np.pad(test.force, width // 2, mode="edge")
        test.force = np.convolve(padded, np.ones(width) / width, mode="valid")


def _unsaid(lab: Laboratory) -> None:
    for test in lab.tests:
        test.planned = {"order": None}


def _warms_unsaid(lab: Laboratory) -> None:
    """The sample warms over the campaign, 3 % less a test; the order is not stated."""
    for k, test in enumerate(lab.tests):
        test.force = test.force * 0.97**k
    _unsaid(lab)


def _wears(lab: Laboratory) -> None:
    for test in lab.tests:
        test.force = test.force * 0.96 ** (test.order - 1)


def _starts(lab: Laboratory) -> None:
    """The curves start like an S: the first millimetre of slip takes up."""
    for test in lab.tests:
        way = np.maximum(test.travel - test.lash, 0.0)
        test.force = test.force * (1.0 - np.exp(-((way / 1.3e-3) ** 2)))


def _seats(lab: Laboratory) -> None:
    """A clamp seats itself: the first 1.5 mm of travel are twice as soft."""
    for test in lab.tests:
        way = np.maximum(test.travel - test.lash, 0.0)
        real = way - 1.2e-3 * (1.0 - np.exp(-way / 1.2e-3))
        test.force = np.interp(real, way, test.force)


def _lash_varies(lab: Laboratory) -> None:
    """A clamp slips before some of the tests: 2 mm more of lash."""
    for test in lab.tests[::3]:
        test.force = np.interp(test.travel - 2e-3, test.travel, test.force, left=0.0)


def _one(lab: Laboratory) -> Drawn:
    return lab.tests[int(lab.rng.integers(len(lab.tests)))]


def _half(lab: Laboratory) -> None:
    test = _one(lab)
    test.force = 0.5 * test.force


def _micrometres(lab: Laboratory) -> None:
    test = _one(lab)
    test.travel = 1e-3 * test.travel


def _inches(lab: Laboratory) -> None:
    test = _one(lab)
    test.travel = test.travel / 25.4


def _pounds(lab: Laboratory) -> None:
    test = _one(lab)
    test.force = test.force / 4.448222


def _all_pounds(lab: Laboratory) -> None:
    for test in lab.tests:
        test.force = 4.448222 * test.force


def _typed(lab: Laboratory) -> None:
    test = _one(lab)
    test.planned = {"pressure": 10.0 * test.pressure}
    lab.measured = False


def _swapped(lab: Laboratory) -> None:
    """The pressures of two tests were swapped in the plan."""
    first, last = lab.tests[0], lab.tests[-1]
    first.planned, last.planned = {"pressure": last.pressure}, {"pressure": first.pressure}
    lab.measured = False


def _clipped(lab: Laboratory) -> None:
    record(lab)
    lab.noise = 0.0
    test = lab.tests[-1]
    test.force = np.minimum(test.force, 0.85 * float(np.quantile(test.force, 0.98)))


def _clipped_all(lab: Laboratory) -> None:
    """The load cell ends below the friction of the highest pressures."""
    record(lab)
    lab.noise = 0.0
    end = 0.8 * max(float(np.quantile(t.force, 0.98)) for t in lab.tests)
    for test in lab.tests:
        test.force = np.minimum(test.force, end)


def _travel_ends(lab: Laboratory) -> None:
    test = _one(lab)
    test.travel = np.minimum(test.travel, 0.6 * float(test.travel[-1]))


def _cut(test: Drawn, rows: Array) -> None:
    test.travel, test.force, test.friction = (
        test.travel[rows],
        test.force[rows],
        test.friction[rows],
    )
    test.normal = None if test.normal is None else test.normal[rows]


def _rows_lost(lab: Laboratory) -> None:
    test = _one(lab)
    count = len(test.travel)
    _cut(test, np.r_[0 : count // 4, count // 4 + count // 10 : count])


def _late(lab: Laboratory) -> None:
    """One record starts under full load."""
    test = _one(lab)
    start = int(np.argmax(test.force > 0.7 * test.force.max()))
    _cut(test, np.arange(start, len(test.travel)))
    test.travel = test.travel - test.travel[0]


def _all_late(lab: Laboratory) -> None:
    for test in lab.tests:
        start = int(np.argmax(test.force > 0.7 * test.force.max()))
        _cut(test, np.arange(start, len(test.travel)))
        test.travel = test.travel - test.travel[0]


def _drift(lab: Laboratory) -> None:
    """The zero of one test drifts by 15 % of its largest force over the stroke."""
    test = _one(lab)
    test.force = test.force + 0.15 * test.force.max() * test.travel / test.travel[-1]


def _waves(lab: Laboratory) -> None:
    for test in lab.tests:
        test.force = test.force * (1.0 + 0.06 * np.sin(15.0 * test.travel / test.travel[-1]))


def _speed(lab: Laboratory) -> None:
    """The plan says 60 mm/min, the file 10."""
    for test in lab.tests:
        test.planned = {"speed": 60e-3 / 60.0}


def _face(lab: Laboratory) -> None:
    for test in lab.tests:
        test.force = 2.4 * test.force


def _load_measured(lab: Laboratory) -> None:
    """The measured normal force of one test is that of another pressure."""
    lab.measured = True
    record(lab)
    lab.noise = 0.0
    test = lab.tests[0]
    assert test.normal is not None
    test.normal = 1.3 * test.normal


def _stalls(lab: Laboratory) -> None:
    """Slack is taken up again in the middle of one rise: 1.5 mm without more force."""
    test = _one(lab)
    at = test.lash + 1.2e-3
    real = np.where(test.travel < at, test.travel, np.maximum(test.travel - 1.5e-3, at))
    test.force = np.interp(real, test.travel, test.force)


def _spread(lab: Laboratory) -> None:
    """Samples scatter by 14 %."""
    for test in lab.tests:
        test.force = test.force * np.exp(0.14 * lab.rng.normal())


def _rig_rubs(lab: Laboratory) -> None:
    """Before the slip starts the rig rubs with 8 % of the largest force, in every test."""
    for test in lab.tests:
        test.force = test.force + 0.08 * test.force.max() * np.clip(test.travel / 0.05e-3, 0.0, 1.0)


def _constant(lab: Laboratory) -> None:
    """Friction is at its peak at once: the sample is glued, or no rubber slides."""
    for test in lab.tests:
        test.force = np.where(test.travel > test.lash, float(test.force.max()), 0.0)


def _seconds(lab: Laboratory) -> None:
    """Every second test was pulled 40 times as fast, with 12 % more friction; not stated."""
    for test in lab.tests[1::2]:
        test.force = 1.12 * test.force
        test.planned = {"speed": 400e-3 / 60.0}


KINDS: dict[str, Callable[[Laboratory], None]] = {
    "one force from a pressure on (soft)": _limited,
    "one force from a pressure on (sharp)": _limited_sharp,
    "18 % less friction from a pressure on": _step_down,
    "18 % more friction from a pressure on": _step_up,
    "one pressure damp, 12 % less": _damp,
    "another cell, 7 % off, from a pressure on": _two_cells,
    "repeats apart by 30 % in slip": _slips_apart,
    "repeats apart by 25 % in slip, shorter": _slips_apart_down,
    "repeats are copies, scaled": _copy_scaled,
    "repeats are copies, travel scaled": _copy_slips,
    "repeats are copies, on another grid": _copy_resampled,
    "repeats are copies with some noise": _copy_noisy,
    "repeats are copies that start later": _copy_shifted,
    "a pressure drawn between its neighbours": _interpolated,
    "one force stands in all tests": _standing,
    "one force is missing in all tests": _standing_below,
    "stick-slip sampled slower than it swings": _teeth_fast,
    "stick-slip of 2.3 readings": _teeth_coarse,
    "stick-slip of 12 %": _teeth_slow,
    "a slow filter, 0.8 mm": _slow_filter,
    "a running mean, 1.6 mm": _moving_mean,
    "warms, order not stated": _warms_unsaid,
    "wears 4 % a test": _wears,
    "curves start like an S": _starts,
    "a clamp seats itself": _seats,
    "lash differs by 2 mm": _lash_varies,
    "half the friction in one test": _half,
    "travel in micrometres in one test": _micrometres,
    "travel in inches in one test": _inches,
    "force in pounds in one test": _pounds,
    "force in pounds in all tests": _all_pounds,
    "pressure typed ten times": _typed,
    "pressures of two tests swapped": _swapped,
    "load cell at its end in one test": _clipped,
    "load cell at its end from a force on": _clipped_all,
    "travel sensor at its end": _travel_ends,
    "a tenth of the rows lost": _rows_lost,
    "one record starts under load": _late,
    "all records start under load": _all_late,
    "zero drifts by 15 % in one test": _drift,
    "waves of 6 %": _waves,
    "speed is not that of the plan": _speed,
    "2.4 times the friction": _face,
    "measured load is not the set one": _load_measured,
    "slack in the middle of a rise": _stalls,
    "samples scatter by 14 %": _spread,
    "the rig rubs with 8 %": _rig_rubs,
    "friction at its peak at once": _constant,
    "two speeds, 12 % apart": _seconds,
}


def faulty(kind: str, seed: int, readings: int) -> PlanResult:
    """Fit a laboratory with a fault."""
    lab = draw(seed, readings)
    KINDS[kind](lab)
    if lab.noise:
        record(lab)
    return fit(lab)


def passes(result: PlanResult) -> bool:
    """Whether a result is told OK; what speed does may be told and taken off instead."""
    told = any(c.found.separated.by_slip_speed is not None for c in result.conditions)
    return verdict(result).level is Level.OK and not told


def sound(seed: int, readings: int) -> tuple[PlanResult, list[bool]]:
    """Fit a sound laboratory: the result, and which of its intervals hold the truth."""
    lab = draw(seed, readings)
    record(lab)
    result = fit(lab)
    condition = result.conditions[0]
    at = condition.found.level_pressures()
    slip, friction, error = condition.peaks_at(at)
    true_slip, true_friction = lab.peaks(np.array(_levels(lab)))
    held = [*(np.abs(np.log(friction / true_friction)) < error[:, 1]),
            *(np.abs(np.log(slip / true_slip)) < error[:, 0])]  # fmt: skip
    return result, [bool(h) for h in held]


def figure(seed: int) -> tuple[PlanResult, list[bool]]:
    """Fit a sound figure of 3 to 5 curves of 10 to 45 clicked points; which intervals hold.

    Its axes are off by up to 1 % of full scale at either end, each click by 0.2 %.
    """
    rng = np.random.default_rng([seed, 77])
    count, points = int(rng.integers(3, 6)), int(rng.integers(10, 46))
    levels = np.array(sorted(rng.choice(PRESSURES, count, replace=False)))
    power, growth = rng.uniform(0.15, 0.35), rng.uniform(0.0, 0.15)
    top = rng.uniform(0.6, 1.1) * (levels / 1e5) ** -power
    slip = rng.uniform(3e-3, 8e-3) * (levels / 1e5) ** growth
    end, slope = rng.uniform(12e-3, 16e-3), rng.uniform(0.0, 0.15)
    ends = rng.uniform(-0.01, 0.01, 4)

    def read_off(value: Array, full: float, zero: float, far: float) -> Array:
        off = full * (zero * (1.0 - value / full) + far * value / full)
        return value + off + 0.002 * full * rng.normal(size=len(value))

    clicks = []
    for k in range(count):
        at = np.linspace(0.0, 1.0, points + 1)[1:] ** rng.uniform(1.0, 1.6)
        x = end * np.clip(at + 0.1 / points * rng.normal(size=points), 0.2 / points, 1.0)
        y = law_friction(np.sort(x), float(top[k]), float(slip[k]), slope)
        own = zip(read_off(np.sort(x), end, ends[0], ends[1]) * 1e3,
                  read_off(y, float(top.max()), ends[2], ends[3]), strict=True)  # fmt: skip
        clicks += [f"{levels[k] / 1e3:g} kPa,{a:.4f},{b:.4f}" for a, b in own if a > 0.0]
    data = "\n".join(["curve,x,y", *clicks, ""]).encode()
    plan = TestPlan(
        name="figure", surface="rubber", rig=Rig(area=AREA),
        tests=(PlannedTest(file="a.csv", place="test[1]"),),
        digitised=Digitised(source="a paper", slip_unit=1e-3), uncertainty=Uncertainty(),
    )  # fmt: skip
    plan, records = with_curves(plan, lambda _: data)
    result = fit_plan(plan, read=lambda test: records[test.file])
    found, friction, error = result.conditions[0].peaks_at(levels)
    held = [*(np.abs(np.log(friction / top)) < error[:, 1]),
            *(np.abs(np.log(found / slip)) < error[:, 0])]  # fmt: skip
    return result, [bool(h) for h in held]


def figures(count: int) -> Iterable[str]:
    """Rows on figures."""
    refused, held = [], []
    for seed in range(1, count + 1):
        try:
            result, own = figure(seed)
        except InputError as error:
            refused.append(f"{seed}: {error}")
            continue
        held += own
        if verdict(result).level is not Level.OK:
            refused.append(f"{seed}: {in_units(verdict(result).text)}")
    yield f"figures: {len(refused)} of {count} refused; " + "; ".join(refused)
    yield f"intervals: {sum(held)} of {len(held)} hold ({100 * np.mean(held):.1f} %)\n"


def sounds(count: int, readings: int) -> Iterable[str]:
    """Rows on sound laboratories."""
    accused: list[str] = []
    held: list[bool] = []
    for seed in range(1, count + 1):
        result, own = sound(seed, readings)
        held += own
        if verdict(result).level is not Level.OK:
            accused.append(f"{seed}: {in_units(verdict(result).text)}")
    yield f"sound: {len(accused)} of {count} accused; " + "; ".join(accused)
    yield f"intervals: {sum(held)} of {len(held)} hold ({100 * np.mean(held):.1f} %)\n"


COURSES: dict[str, Callable[[Any, Array], Array]] = {
    "a power": lambda rng, p: -rng.uniform(0.15, 0.35) * np.log(p / 1e5),
    "contact saturates": lambda rng, p: (
        -rng.uniform(0.3, 0.8) * np.log1p(p / rng.uniform(5e4, 5e5))
    ),
    "a constant part": lambda rng, p: np.log(
        rng.uniform(0.2, 0.6) + rng.uniform(0.2, 1.0) * (p / 1e5) ** -rng.uniform(0.5, 1.0)
    ),
    "two pieces": lambda _, p: np.log(np.interp(p, [34e3, 172e3, 690e3], [1.3, 0.86, 0.385])),
}
STEPS: dict[str, Callable[[int], Array]] = {
    "-": np.zeros,
    "18 % less from a pressure on": lambda n: np.log(0.82) * (np.arange(n) >= n // 2),
    "18 % more from a pressure on": lambda n: np.log(1.18) * (np.arange(n) >= n // 2),
    "one pressure 12 % less": lambda n: np.log(0.88) * (np.arange(n) == n // 2),
    "7 % more from a pressure on": lambda n: np.log(1.07) * (np.arange(n) >= n // 2),
}


def stepped(course: str, step: str, count: int, scatter: float, rng: Any) -> bool:
    """Draw peaks of two samples a pressure, no curves, and return whether a step is told."""
    inner = sorted(rng.choice(np.arange(1, 7), count - 2, replace=False).tolist())
    levels = np.array([PRESSURES[k] for k in (0, *inner, 7)])
    mean = COURSES[course](rng, levels) + STEPS[step](count)
    peaks = mean[:, None] + scatter * rng.normal(size=(count, 2))
    squares = [float(((own - own.mean()) ** 2).sum()) for own in peaks]
    variance, freedom = drawn(squares, [1] * count, USUAL)
    found = step_over_pressure(levels, peaks.mean(axis=1), np.full(count, variance / 2), freedom)
    return found is not None


def steps(count: int) -> Iterable[str]:
    """Rows on steps over pressure: how many are told, of sound courses and of stepped ones."""
    yield f"\n### Steps over pressure, {count} drawn laboratories a cell\n"
    yield "| course | step | scatter | 4 | 5 | 6 | 8 pressures |\n|---|---|---|---|---|---|---|"
    cases = [(course, "-", scatter) for course in COURSES for scatter in (0.02, 0.04)]
    cases += [("a power", step, 0.02) for step in STEPS if step != "-"]
    rng = np.random.default_rng(1)
    for course, step, scatter in cases:
        cells = [
            f"{100 * np.mean([stepped(course, step, n, scatter, rng) for _ in range(count)]):.1f} %"
            for n in (4, 5, 6, 8)
        ]
        yield f"| {course} | {step} | {100 * scatter:.0f} % | {' | '.join(cells)} |"


def faults(kind: str, count: int, readings: int) -> str:
    """Row on a kind of fault: how many are told OK, and what the others are called most."""
    missed = 0
    names: dict[str, int] = {}
    for seed in range(1, count + 1):
        try:
            result = faulty(kind, seed, readings)
        except InputError as error:  # no test of it is usable
            text = " ".join(in_units(error.problems[0].message).split()[:9])
        else:
            if passes(result):
                missed += 1
                continue
            text = " ".join(in_units(verdict(result).text).split()[:9])
        names[text] = names.get(text, 0) + 1
    most = max(names, key=lambda n: names[n], default="-")
    return f"| {kind} | {missed} of {count} | {most} |"


def rows(arguments: argparse.Namespace) -> Iterable[str]:
    """Rows of the tables."""
    if arguments.figures:
        yield from figures(arguments.figures)
    if arguments.steps:
        yield from steps(arguments.steps)
    for readings in arguments.readings:
        yield f"\n### {readings} readings, {arguments.laboratories} laboratories a kind\n"
        if arguments.sound:
            yield from sounds(arguments.sound, readings)
        if not arguments.laboratories:
            continue
        yield "| fault | false OK | named as |\n|---|---|---|"
        for kind in KINDS:
            if not arguments.kind or any(part in kind for part in arguments.kind):
                yield faults(kind, arguments.laboratories, readings)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0] if __doc__ else None)
    parser.add_argument("--laboratories", type=int, default=20, help="of each kind")
    parser.add_argument("--readings", type=int, nargs="*", default=(250,))
    parser.add_argument("--sound", type=int, default=0, help="sound laboratories")
    parser.add_argument("--figures", type=int, default=0, help="figures of clicked points")
    parser.add_argument("--steps", type=int, default=0, help="peaks with steps over pressure")
    parser.add_argument("--kind", nargs="*", default=(), help="parts of names of kinds")
    parser.add_argument("--table", default=None, help="append the tables to this file")
    arguments = parser.parse_args()
    begin = time.process_time()
    for row in rows(arguments):
        print(row, flush=True)
        if arguments.table:
            with open(arguments.table, "a", encoding="utf-8") as stream:
                stream.write(f"{row}\n")
    print(f"\n({time.process_time() - begin:.0f} s)")


if __name__ == "__main__":
    main()
