"""A test plan to its results: read, reduce, fit each curve, then the law of each condition."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from wraparc.arrays import Integers
from wraparc.errors import InputError, Problem
from wraparc.machine_tables import read_bytes, refused
from wraparc.shear_test.analysis import ConditionResult, PlanResult, TestResult
from wraparc.shear_test.condition_fit import fit_condition
from wraparc.shear_test.contradictions import contradictions, with_stated
from wraparc.shear_test.curve_fit import fit_curve
from wraparc.shear_test.digitised import as_drawn, with_curves
from wraparc.shear_test.misfit import OTHER_PRESSURE, Sentence, judged_fit, stick_slip, with_misfit
from wraparc.shear_test.noise import noise_level
from wraparc.shear_test.plan import PlannedTest, TestPlan
from wraparc.shear_test.reader import read_machine_file
from wraparc.shear_test.record import MachineRecord
from wraparc.shear_test.reduce import FrictionCurve, Sample, reduce_record
from wraparc.shear_test.separation import at_reference, separate
from wraparc.shear_test.travel_units import odd_travel
from wraparc.units import quantity

Reader = Callable[[PlannedTest], MachineRecord]
#: Called with tests done, tests in all, and what was done.
Progress = Callable[[int, int, str], None]
# Set pressures that differ by less are one pressure.
_SAME_PRESSURE = 0.03
# Part of the travel that a held lash may take up.
_LASH_OF_TEST = 0.8
_MEASURED_OFF = 0.05
# Measured pressures that are one, whatever was set.
_ONE_PRESSURE = 0.01
# Travels and forces nearer than these, of the travel and of the noise, are one test. Ours.
_SAME_TRAVEL, _SAME_NOISE = 1e-3, 0.3
# What computing with readings of any kind can end with.
_FAILURES = (np.linalg.LinAlgError, ArithmeticError, ValueError, IndexError)


def fit_plan(
    plan: TestPlan, *, read: Reader | None = None, progress: Progress | None = None
) -> PlanResult:
    """Fit all tests of a plan.

    A test that cannot be used, or with which no law can be laid through the others, is left out
    and named in ``left_out``; the others go on.

    Parameters
    ----------
    plan
        The plan.
    read
        How to read the file of a test; from the disk, relative to the plan's folder, if
        not given.
    progress
        Told after each test.

    Raises
    ------
    InputError
        If no test can be used, with the reasons of all.
    """
    if plan.digitised is not None and read is None:
        plan, curves = with_curves(plan, lambda test: _bytes(plan, test))
        read = lambda test: curves[test.file]  # noqa: E731 - as short as it says
    reader = read or (lambda test: read_machine_file(Path(plan.folder) / test.file, test.choices))
    results: list[TestResult] = []
    problems: list[Problem] = []
    seen: list[tuple[PlannedTest, MachineRecord]] = []
    for number, test in enumerate(plan.used_tests, start=1):
        try:
            record = reader(test)
            _refuse_duplicate(record, test, seen)
            results.append(_one_test(plan, with_stated(test, record), record))
        except InputError as error:
            problems += [_placed(problem, test) for problem in error.problems]
        except _FAILURES as error:
            problems.append(_placed(_not_fitted(error), test))
        if progress is not None:
            progress(number, len(plan.used_tests), test.file)
    results = _without_odd_travels(results, problems)
    if not results:
        raise InputError(problems or [Problem(message="uses no test", file=plan.file)])
    names = dict.fromkeys(result.test.condition for result in results)
    conditions = [_condition(plan, name, results, problems) for name in names]
    if not any(conditions):
        raise InputError(problems)
    return PlanResult(
        plan=plan,
        conditions=tuple(filter(None, conditions)),
        left_out=tuple(problems),
        date=datetime.now(UTC).date().isoformat(),
    )


def _bytes(plan: TestPlan, test: PlannedTest) -> bytes:
    return read_bytes(Path(plan.folder) / test.file)


def _refuse_duplicate(
    record: MachineRecord, test: PlannedTest, seen: list[tuple[PlannedTest, MachineRecord]]
) -> None:
    """Refuse the readings of a test before, also under another name: they are no repeat."""
    for first, other in seen:
        if first.place != test.place and _are_same_readings(record, other):
            raise refused(
                record.file,
                f"contains the same data as {first.place}",
                "Name the right file, or remove this test.",
            )
    seen.append((test, record))


def _are_same_readings(record: MachineRecord, other: MachineRecord) -> bool:
    """Whether two records are the same to the digit, or nearer than the noise of their forces."""
    if (record.digest, record.place, record.block) == (other.digest, other.place, other.block):
        return True
    if len(record.force) != len(other.force):
        return False
    apart = float(np.std(record.force - other.force))
    span = float(np.ptp(record.travel))
    if not np.all(np.abs(record.travel - other.travel) < _SAME_TRAVEL * span):
        return False
    return apart < _SAME_NOISE * noise_level(record.force) or not np.any(record.force - other.force)


def _without_odd_travels(
    results: Sequence[TestResult], problems: list[Problem]
) -> list[TestResult]:
    """Leave out tests whose travel is another unit's beside the others, and say so."""
    travels = [float(result.curve.travel[-1]) for result in results]
    kept = []
    for k, (result, travel) in enumerate(zip(results, travels, strict=True)):
        others = travels[:k] + travels[k + 1 :]
        fault = odd_travel(travel, others, result.record.unit_of("travel"))
        if fault is None:
            kept.append(result)
        else:
            problems.append(_placed(refused(result.record.file, *fault).problems[0], result.test))
    return kept


def _plain(error: Exception) -> str:
    """What a failure of the computation means."""
    if isinstance(error, np.linalg.LinAlgError):
        return "its readings determine no peak"
    return str(error)


def _not_fitted(error: Exception) -> Problem:
    """What to say of readings that no curve can be laid through."""
    return Problem(
        message=f"no curve fits it ({_plain(error)})",
        remedy="Check columns and units: wraparc read FILE.",
    )


def _placed(problem: Problem, test: PlannedTest) -> Problem:
    key = f"{test.place}.{problem.key}" if problem.key else test.place
    return replace(problem, key=key, file=problem.file or test.file)


def _one_test(plan: TestPlan, test: PlannedTest, record: MachineRecord) -> TestResult:
    known = plan.shear_compliance
    sample = Sample(
        area=plan.rig.area,
        faces=plan.rig.faces,
        shear_compliance=known + plan.cover_compliance,
        compliance=plan.rig.compliance,
        normal_force=plan.set_force(test),
        friction=(plan.rig.least_friction, plan.rig.most_friction),
        stroke=test.stroke,
        stick_slip=test.stick_slip,
        recorded=plan.digitised is None,
    )
    with np.errstate(all="ignore"):  # what is not finite in the end is left out below
        curve = reduce_record(record, sample)
        if plan.digitised is not None:
            errors = None if plan.uncertainty is None else plan.uncertainty.read_off
            curve = as_drawn(curve, float(record.travel.min()), errors)
        result = _fitted(plan, test, record, curve, known)
    if not _is_finite(result):
        raise ArithmeticError("its result is not finite")
    return result


def _is_finite(result: TestResult) -> bool:
    p = result.fit.parameters
    numbers = (p.peak_slip, p.peak_friction, p.lash, p.zero, result.curve.pressure)
    return bool(np.all(np.isfinite(numbers)) and np.all(np.isfinite(result.fit.covariance)))


def _fitted(
    plan: TestPlan, test: PlannedTest, record: MachineRecord, curve: FrictionCurve, known: float
) -> TestResult:
    left_in = curve.bending - known * curve.pressure
    bending, other = curve.bending, left_in
    if not plan.removes_shear:
        bending, other = other, bending
    _refuse_long_lash(plan, test, float(curve.travel[-1]))
    judged = judged_fit(curve, plan.rig.largest_lash, bending, plan.held)
    if curve.swing is not None and not test.stick_slip:
        judged = with_misfit(judged, stick_slip(curve.swing))
    if record.unread:
        judged = with_misfit(judged, _unread(record.unread))
    for sentence in (
        *_set_and_measured(plan, test, curve.pressure),
        *contradictions(plan, test, record),
    ):
        judged = with_misfit(judged, sentence)
    second = fit_curve(curve, bending=other, start=judged.fit) if known > 0.0 else None
    return TestResult(test=test, record=record, curve=curve, judged=judged, other=second)


def _unread(count: int) -> Sentence:
    have = "1 further table of its file has" if count == 1 else f"{count} further tables have"
    text = (
        f"{have} the same columns and do not run on from it: not read. Name the table that is "
        "meant (table = 1), and give each a test of its own"
    )
    head = f"{count} further table{'s' if count > 1 else ''} of the file not read"
    return Sentence(
        "other tables", text, head, "Give each table a [[test]] of its own: table = 1, table = 2."
    )


def _refuse_long_lash(plan: TestPlan, test: PlannedTest, travel: float) -> None:
    """Refuse a lash that the plan holds and that takes up nearly all of a test."""
    lash = plan.held.lash
    if lash is None or lash < _LASH_OF_TEST * travel:
        return
    raise refused(
        test.file,
        f"lash {lash * 1e3:.3g} mm leaves no slip of {travel * 1e3:.3g} mm travel",
        "Correct lash in fixed of [fit], or leave it out.",
    )


def _again(plan: TestPlan, test: TestResult, factor: float) -> TestResult:
    """A test with its friction times a factor, fitted again."""
    curve = at_reference(test.curve, factor)
    return _fitted(plan, test.test, test.record, curve, plan.shear_compliance / factor)


def _set_and_measured(plan: TestPlan, test: PlannedTest, measured: float) -> list[Sentence]:
    force = plan.set_force(test)
    if force is None or abs(measured * plan.rig.area / force - 1.0) <= _MEASURED_OFF:
        return []
    text = (
        f"the measured normal force means {quantity(measured, 'pressure')}, not the "
        f"{quantity(force / plan.rig.area, 'pressure')} that were set; the measured one was used"
    )
    head = (
        f"measured normal force means {quantity(measured, 'pressure')}, the plan says "
        f"{quantity(force / plan.rig.area, 'pressure')}"
    )
    return [Sentence(OTHER_PRESSURE, text, head, "Correct the load in the plan, or its column.")]


def _condition(
    plan: TestPlan, name: str, results: Sequence[TestResult], problems: list[Problem]
) -> ConditionResult | None:
    """Fit the law of a condition, without the tests with which there is none."""
    own = sorted(
        (result for result in results if result.test.condition == name),
        key=lambda result: result.curve.pressure,
    )
    out: list[tuple[TestResult, str]] = []
    fitted = _law(plan, name, own)
    while isinstance(fitted, str) and own:
        out.append((own.pop(_farthest(own)), fitted))
        fitted = _law(plan, name, own) if own else fitted
    for test, said in out[:-1]:  # the last was one too many; those before it may be sound
        again = _law(plan, name, sorted([*own, test], key=lambda result: result.curve.pressure))
        if not isinstance(again, str):
            own, fitted = list(again.tests), again
            out.remove((test, said))
    problems += [_placed(_no_law(said), test.test) for test, said in out]
    return None if isinstance(fitted, str) else fitted


def _law(plan: TestPlan, name: str, own: Sequence[TestResult]) -> ConditionResult | str:
    """The law of the tests, or why there is none."""
    levels = pressure_levels(plan, own)
    order = np.argsort(levels, kind="stable")
    try:
        with np.errstate(all="ignore"):  # what is not finite in the end is no law
            tests, separated = separate(
                [own[k] for k in order], levels[order], lambda t, factor: _again(plan, t, factor)
            )
            result = fit_condition(plan, name, tests, levels[order], separated)
            peaks = np.concatenate(result.peaks_at(result.found.level_pressures())[:2])
    except _FAILURES as error:
        return error.problems[0].message if isinstance(error, InputError) else _plain(error)
    return result if np.all(np.isfinite(peaks)) else "its peaks are not finite"


def _farthest(own: Sequence[TestResult]) -> int:
    """Which test is farthest from the middle of all in its peak."""
    peaks = [(t.fit.parameters.peak_slip, t.fit.parameters.peak_friction) for t in own]
    logs = np.log(np.maximum(peaks, 1e-12))
    off = np.abs(logs - np.median(logs, axis=0))
    return int(np.argmax((off / np.maximum(np.median(off, axis=0), 0.02)).max(axis=1)))


def _no_law(said: str) -> Problem:
    """What to say of a test with which there is no law."""
    return Problem(
        message=f"no law fits its condition with this test ({said})",
        remedy="See wraparc read FILE.",
    )


def pressure_levels(plan: TestPlan, results: Sequence[TestResult]) -> Integers:
    """Number the pressures 0, 1, ...: tests named repeats, else set pressures within 3 %.

    Where they were measured, and are within 1 %, they are one whatever was set.
    """
    keys: list[float | str] = []
    places: dict[float | str, float] = {}
    for result in results:
        force = plan.set_force(result.test)
        pressure = result.curve.pressure if force is None else force / plan.rig.area
        key: float | str = result.test.repeat or next(
            (k for k in places if isinstance(k, float) and abs(pressure / k - 1) < _SAME_PRESSURE),
            pressure,
        )
        places.setdefault(key, result.curve.pressure)
        keys.append(key)
    of = {k: [r.curve.pressure for r, own in zip(results, keys, strict=True) if own == k]
          for k in places}  # fmt: skip
    measured = sorted(((float(np.mean(p)), key) for key, p in of.items()), key=lambda item: item[0])
    ranked, rank, before = {}, -1, 0.0
    for pressure, key in measured:
        rank += pressure > before * (1.0 + _ONE_PRESSURE)
        ranked[key], before = rank, pressure
    return np.array([ranked[key] for key in keys], dtype=np.int64)
