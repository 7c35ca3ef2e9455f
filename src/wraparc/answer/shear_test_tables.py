"""Tables of a fitted test plan, for console, page and paper alike."""

import math
from collections.abc import Sequence

import numpy as np

from wraparc.alike import largest
from wraparc.answer.shear_test_budget import budget_table
from wraparc.answer.shear_test_files import (
    files_table,
    left_out_table,
    remarks_table,
    unused_table,
    without_empty,
)
from wraparc.answer.shear_test_head import circumstances_table
from wraparc.answer.shear_test_numbers import slope
from wraparc.answer.shear_test_standard import laws_table, standard_tables
from wraparc.answer.sheet import NONE, Also, Row, Sheet, Table, Verdict, named
from wraparc.checks import Level
from wraparc.checks.action import Action
from wraparc.errors import format_names
from wraparc.friction import ab_from_peak
from wraparc.shear_test.analysis import ConditionResult, PlanResult, TestResult
from wraparc.shear_test.campaign import NOT_STATED
from wraparc.shear_test.curve_fit import Z95
from wraparc.shear_test.derivative import derivative_check
from wraparc.shear_test.lash import LEAST_LASH, lash_range
from wraparc.shear_test.misfit import OTHER_PRESSURE, REMAINDER, Misfit, noise_levels
from wraparc.shear_test.pressure_form import equations
from wraparc.shear_test.sentences import form_sentences
from wraparc.units import (
    GIVEN_DIGITS,
    Cell,
    bare,
    count,
    fixed,
    percent,
    plus_minus,
    quantity,
    unit_of,
)


def plan_sheet(result: PlanResult, *, laws: bool = False) -> Sheet:
    """Return everything to show of a fitted plan.

    Parameters
    ----------
    result
        From `fit_plan`.
    laws
        Whether to fit other laws to the same curves and show them side by side.
    """
    tables = plan_tables(result)
    for condition in result.conditions:
        several = len(result.conditions) > 1
        name = f" ({condition.condition})" if several else ""
        tables += condition_tables(condition, name)
        tables += [laws_table(condition, name)] if laws else []
    remarks = _remarks(result)
    plan = result.plan
    forms = {s for c in result.conditions for s in form_sentences(plan, c.found)}
    return Sheet(
        title=f"Shear tests of {result.plan.title or result.plan.name}",
        subtitle=_subtitle(result),
        verdict=verdict(result),
        tables=tuple(tables),
        remarks=tuple(_started(sentence) for sentence in remarks),
        sources=(str(result.plan.provenance),),
        kept=tuple(_started(s) for s in remarks if s not in forms and _bare(s) not in forms),
    )


def plan_tables(result: PlanResult) -> list[Table]:
    """Tables of the whole plan: what was not used, and under what circumstances was tested."""
    tables = [left_out_table(result)] if result.left_out else []
    if result.plan.unused_tests:
        tables.append(unused_table(result))
    return [*tables, circumstances_table(result)]


def _remarks(result: PlanResult) -> list[str]:
    """Remarks of all conditions; what is not said of all, with its condition."""
    several = len(result.conditions) > 1
    found = []
    for sentence in dict.fromkeys(s for c in result.conditions for s in c.remarks):
        said = [c.condition for c in result.conditions if sentence in c.remarks]
        everywhere = len(said) == len(result.conditions)
        found.append(f"{', '.join(said)}: {sentence}" if several and not everywhere else sentence)
    return found


def _bare(remark: str) -> str:
    """A remark without its condition."""
    return remark.partition(": ")[2]


def _subtitle(result: PlanResult) -> str:
    used = sum(len(condition.tests) for condition in result.conditions)
    names = ", ".join(condition.condition for condition in result.conditions)
    unused = len(result.plan.unused_tests)
    besides = f", {unused} not used, as the plan says" if unused else ""
    return f"{used} of {len(result.plan.tests)} tests used{besides}; condition {names}"


def _started(sentence: str) -> str:
    """A sentence with its capital, unless it begins with a name, and its full stop."""
    first = sentence.split(" ", 1)[0]
    begin = sentence[:1].upper() if first.isalpha() else sentence[:1]
    return begin + sentence[1:] + ("" if sentence.endswith(".") else ".")


def verdict(result: PlanResult) -> Verdict:
    """Say in a sentence how far the law describes the tests."""
    misfit = result.misfit
    shown = tuple(_started(sentence) for sentence in misfit)
    if misfit and result.misfit_accepted:
        shown += (_started(f"Misfit accepted: {result.misfit_accepted}"),)
    total = len(result.plan.used_tests)
    if result.left_out:
        count = len({problem.file for problem in result.left_out})
        text = f"{count} of {total} tests could not be used"
        text += f"; the law deviates from others ({counted(misfit)})." if misfit else "."
        action = Action("Check the tests left out (table left-out).")
        return Verdict(Level.ATTENTION, text, shown, action=action, name="fit")
    if misfit:
        heads = [s for s in misfit if isinstance(s, Misfit) and s.headline]
        first = heads[0] if heads else Misfit("")
        action = Action(first.action or "Repeat or leave out these tests, and fit again.")
        lines = [*(s.headline for s in heads), *_remainder(result)]
        lines = lines or [f"the law does not describe its tests ({counted(misfit)})"]
        text = f"Fit rejected: {lines[0]}."
        rest = dict.fromkeys(_started(line) for line in lines[1:])
        lash = _lash(result)
        also = tuple(Also(Level.ATTENTION, text) for text in rest)
        also += (Also(Level.OK, f"{lash}."),) if lash else ()
        return Verdict(
            Level.ATTENTION, text, shown, action=action, also=also, checks_at="--full", name="fit"
        )
    text = f"Fit accepted: {total} of {total} tests, maximum deviation {_deviation(result)[0]}."
    unsure = any(NOT_STATED in condition.remarks for condition in result.conditions)
    lash = _lash(result)
    order = (Also(Level.OK, "Test order missing: wear during the tests is not detectable."),)
    if unsure and lash:
        order = (Also(Level.OK, f"{lash}; test order missing: wear is not detectable."),)
    elif lash:
        order = (Also(Level.OK, f"{lash}."),)
    return Verdict(
        Level.OK,
        text,
        (_remainders(result),),
        action=_peak_action(result),
        also=(*_left_rows(result), *(order if unsure or lash else ())),
        checks_at="--full",
        name="fit",
    )


def _left_rows(result: PlanResult) -> tuple[Also, ...]:
    """Say which tests, strokes, rows or columns of the files the law is not of."""
    tests = [test for condition in result.conditions for test in condition.tests]
    planned = {(t.file, t.choices.block or 1) for t in result.plan.tests}
    found: dict[str, str] = {}
    for test in tests:
        record, file = test.record, test.test.file
        blocks = record.blocks - sum(of == file for of, _ in planned)
        rows = record.rows - len(record.travel)
        if blocks > 0:
            found.setdefault(file, f"{blocks} of {record.blocks} tests of {file}")
        elif test.curve.other_strokes:
            found.setdefault(file, f"{test.curve.other_strokes} further strokes of {file}")
        elif rows > 0:
            found.setdefault(file, f"{rows} of {record.rows} rows of {file}")
        elif record.passed_over:
            names = format_names(record.passed_over[:1])
            found.setdefault(file, f"column {names} of {file}")
    if not found:
        return ()
    first = next(iter(found.values()))
    more = f", and of {len(found) - 1} more files" if len(found) > 1 else ""
    return (Also(Level.OK, f"Not used: {first}{more} (table files)."),)


def _lash(result: PlanResult) -> str:
    """Say how much travel was taken as lash; nothing of a figure, which has none."""
    if result.plan.digitised is not None:
        return ""
    low, high = lash_range([test for condition in result.conditions for test in condition.tests])
    return f"Lash taken off: {Cell(high, 'length', 2, 'to', low)}" if high >= LEAST_LASH else ""


def _remainder(result: PlanResult) -> list[str]:
    """Say how many tests the law leaves a remainder of, and of which most."""
    tests = [test for condition in result.conditions for test in condition.tests]
    bad = [t for t in tests if any(s.about == REMAINDER for s in t.judged.misfit)]
    if not bad:
        return []
    worst = largest(bad, lambda test: test.fit.remainder / _top(test))
    share = 100 * worst.fit.remainder / _top(worst)
    who = f"{len(bad)} tests deviate" if len(bad) > 1 else "1 test deviates"
    return [f"{who}, worst {worst.test.file} by {share:.1f} % of friction"]


def _peak_action(result: PlanResult) -> Action | None:
    """Return how far to test where the peak of the friction was not reached."""
    tests = [test for condition in result.conditions for test in condition.tests]
    slips = [test.fit.slip_max for test in tests if not test.fit.peak_inside]
    if not slips:
        return None
    return Action(f"Test to more than {named('slip', max(slips))} slip to find the peak friction.")


def maximum_deviation(tests: Sequence[TestResult]) -> str:
    """Return the largest remainder of a single curve, as a share of its friction."""
    share = max(test.fit.remainder / _top(test) for test in tests)
    return f"{100 * share:.1f} % of friction"


def _deviation(result: PlanResult) -> tuple[str, str]:
    """Return the largest remainder of a single curve, of its friction and in noise levels."""
    tests = [test for condition in result.conditions for test in condition.tests]
    levels = max(noise_levels(test.fit, test.curve) for test in tests)
    return maximum_deviation(tests), f"{levels:.1f} noise levels"


def _remainders(result: PlanResult) -> str:
    """Largest remainder of a single curve, by size and by noise, and the scatter of samples."""
    tests = [test for condition in result.conditions for test in condition.tests]
    deviation, levels = _deviation(result)
    scatters = [s for c in result.conditions if (s := c.found.scatter) is not None]
    told = scatters and not result.plan.digitised
    between = f"; {max(scatters, key=lambda s: s.value).words}" if told else ""
    swings = [test.curve.swing for test in tests if test.curve.swing is not None]
    widest = max(swings, default=None)
    stick_slip = (
        f" Stick-slip varies friction by up to {100 * widest.size:.0f} %, every "
        f"{quantity(widest.period, 'length', 2)}."
        if widest
        else ""
    )
    return (
        f"No single curve deviates from its law by more than {deviation} ({levels}){between}."
        f"{stick_slip}"
    )


def counted(remarks: Sequence[str]) -> str:
    """How many remarks, in words."""
    return "1 remark" if len(remarks) == 1 else f"{len(remarks)} remarks"


def condition_tables(condition: ConditionResult, name: str) -> list[Table]:
    """Tables of one condition."""
    tables = [
        curves_table(condition, name),
        coefficients_table(condition, name),
        law_table(condition, name),
        *standard_tables(condition, name),
    ]
    budget = budget_table(condition, name)
    if budget is not None:
        tables.append(budget)
    if condition.fit is not None and condition.found.choice is not None:
        lines = equations(condition.fit.form, condition.fit.theta, condition.fit.ends)
        rows = tuple(Row(x, ()) for x in lines)
        tables.append(Table(f"Equations over pressure{name}", rows, (), name="equations"))
        tables.append(forms_table(condition, name))
    if condition.found.left_out:
        tables.append(prediction_table(condition, name))
    if any(test.other is not None for test in condition.tests):
        tables.append(shear_table(condition, name))
    single = remarks_table(condition, name)
    return [*tables, files_table(condition, name), *([single] if single else [])]


def curves_table(condition: ConditionResult, name: str) -> Table:
    """One line a test: the peak of its own curve, lash, quality."""
    unit = unit_of("length")
    heads = (
        _pressure_head(),
        f"peak slip [{unit}]",
        "peak friction",
        f"lash [{unit}]",
        "R\u00b2",
        "noise",
    )
    rows = tuple(
        Row(
            title=test.test.label,
            values=_curve_values(test),
            note="outlier"
            if condition.found.flagged[k]
            else ("misfit" if test.judged.misfit else ""),
        )
        for k, test in enumerate(condition.tests)
    )
    note = (
        "Each curve by itself; \u00b1 is half the 95 % interval. A peak slip in brackets is "
        "outside the tested slip; if the curve hardly determines it, its ends are from the profile "
        "of the likelihood (? if it has no upper end). A curve that its law does not describe has "
        "no interval. Noise: standard deviation of one reading of friction."
    )
    return Table(f"Tests{name}", rows, heads, note, "tests")


def _curve_values(test: TestResult) -> tuple[str, ...]:
    fit, q, spread = test.fit, test.fit.parameters, _spread(test)
    lash = f"{bare(q.lash, 'length')} (fixed)"
    if "lash" in fit.free:
        lash = plus_minus(q.lash, spread * fit.error("lash"), "length")
    peak = plus_minus(q.peak_friction, spread * fit.error("ln_peak_friction") * q.peak_friction)
    if fit.held.peak_friction is not None:
        peak = f"{bare(q.peak_friction, 'number')} (fixed)"
    return (
        _pressure(test.curve.pressure),
        _peak_slip(test),
        peak,
        lash,
        fixed(fit.r_squared, 4),
        fixed(test.curve.noise, 4),
    )


def _peak_slip(test: TestResult) -> str:
    """Peak slip with its interval; in brackets where it is extrapolated."""
    fit, x = test.fit, test.fit.parameters.peak_slip
    if fit.held.peak_slip is not None:
        return f"{bare(x, 'length')} (fixed)"
    if _spread(test) and test.is_skewed:
        low, high = test.peak_slip_interval
        end = "?" if math.isinf(high) else bare(high, "length")
        return f"({bare(x, 'length')}, {bare(low, 'length')} to {end})"
    text = plus_minus(x, _spread(test) * fit.error("ln_peak_slip") * x, "length")
    return text if fit.peak_inside else f"({text})"


def _spread(test: TestResult) -> float:
    """Half a 95 % interval in standard errors; 0 where the law does not describe the curve.

    Its interval would be that of a law that does not hold.
    """
    return 0.0 if any(s.about != OTHER_PRESSURE for s in test.judged.misfit) else Z95


def coefficients_table(condition: ConditionResult, name: str) -> Table:
    """One line a test: the paper's A and b, and what follows the peak."""
    rows = []
    for test in condition.tests:
        fit, q = test.fit, test.fit.parameters
        (a, b), (by_a, by_b) = fit.coefficients(), fit.coefficient_errors()
        spread = _spread(test)
        of = (
            q.post_peak_slope,
            spread * fit.error("post_peak_slope"),
            q.peak_friction / q.peak_slip,
        )
        level = plus_minus(q.residual_friction, spread * fit.error("residual_friction"))
        check = derivative_check(fit)
        rows.append(
            Row(
                title=test.test.label,
                values=(
                    plus_minus(a, spread * by_a),
                    plus_minus(b, spread * by_b),
                    slope(*of) if "post_peak_slope" in fit.free else NONE,
                    level if "residual_friction" in fit.free else NONE,
                    bare(check.a, "number") if check else NONE,
                    bare(check.b, "number") if check else NONE,
                ),
            )
        )
    heads = (
        "A [1/mm]",
        "b [1/mm]",
        f"slope [1/{unit_of('length')}]",
        "residual",
        "A of derivative",
        "b of derivative",
    )
    note = (
        "mu = A x ln x - b x, x in mm. The last two columns are from the five-point derivative "
        "of the curve, fitted by A ln x + (A - b)."
    )
    title = f"Coefficients of the tests{name}"
    return without_empty(Table(title, tuple(rows), heads, note, "coefficients"))


def law_table(condition: ConditionResult, name: str) -> Table:
    """The law at the tested pressures, with 95 % intervals and the paper's A and b."""
    unit = unit_of("length")
    pressures = condition.found.level_pressures()
    slip, friction, error = condition.peaks_at(pressures)
    slopes, ratio = condition.found.tails.at(pressures)
    rows = []
    for k, pressure in enumerate(pressures):
        a, b = ab_from_peak(float(friction[k]), float(slip[k]) / 1e-3)
        falls = slopes[k] < 0.0
        rows.append(
            Row(
                title=_pressure(pressure),
                values=(
                    plus_minus(slip[k], error[k, 0] * slip[k], "length"),
                    plus_minus(friction[k], error[k, 1] * friction[k]),
                    bare(a, "number", GIVEN_DIGITS),
                    bare(b, "number", GIVEN_DIGITS),
                    slope(slopes[k], 0.0, friction[k] / slip[k]) if falls else NONE,
                    fixed(ratio[k] * friction[k], 3) if falls else NONE,
                ),
            )
        )
    heads = (
        f"peak slip [{unit}]",
        "peak friction",
        "A [1/mm]",
        "b [1/mm]",
        f"slope [1/{unit}]",
        "residual",
    )
    note = (
        f"First column: {_pressure_head()}. \u00b1 is half the 95 % interval of the law, "
        "every part of the budget included. A and b are for slip in mm."
    )
    return without_empty(Table(f"Law of all tests{name}", tuple(rows), heads, note, "law"))


def forms_table(condition: ConditionResult, name: str) -> Table:
    """Forms of the pressure dependence that were tried."""
    choice, fit = condition.found.choice, condition.fit
    assert choice is not None and fit is not None  # noqa: S101, PT018 - asked only where there is one
    rows = tuple(
        Row(
            title=str(item.form),
            values=(
                count(item.parameters),
                fixed(item.criterion - choice.candidates[0].criterion, 1),
                percent(item.left_out_error, 2),
            ),
            note="chosen" if item.form == fit.form else "",
        )
        for item in choice.candidates[:6]
    )
    note = (
        "Difference of Akaike's criterion (AICc) to the best, and error of friction at pressures "
        "left out, inside the tested range, for the forms near the best."
    )
    heads = ("parameters", "AICc", "left-out error")
    return Table(f"Forms of the pressure dependence{name}", rows, heads, note, "forms")


def prediction_table(condition: ConditionResult, name: str) -> Table:
    """Each pressure predicted by the law of the others."""
    rows = tuple(
        Row(
            title=_pressure(item.pressure),
            values=(fixed(item.error, 4), fixed(item.noise_levels, 2), fixed(item.scatter, 4)),
            note="" if item.inside else "outside the others: as at their end",
        )
        for item in condition.found.left_out
    )
    note = (
        f"First column: {_pressure_head()}. Root mean square of predicted less measured "
        "friction over the curve, alone and in noise levels of one reading; scatter between "
        "samples for comparison."
    )
    heads = ("error", "noise levels", "sample scatter")
    return Table(f"Pressures left out in turn{name}", rows, heads, note, "prediction")


def shear_table(condition: ConditionResult, name: str) -> Table:
    """Each curve with the sample's own shear taken off, and left in."""
    unit = unit_of("length")
    rows = []
    for test in condition.tests:
        if test.other is None:
            continue
        both = sorted((test.fit, test.other), key=lambda fit: -fit.bending)
        rows.append(
            Row(
                title=test.test.label,
                values=(
                    fixed(test.curve.bending * _top(test), 3, dimension="length"),
                    *(bare(fit.parameters.peak_slip, "length", GIVEN_DIGITS) for fit in both),
                    *(fixed(fit.parameters.peak_friction, 3) for fit in both),
                ),
            )
        )
    heads = (
        f"shear [{unit}]",
        f"peak slip, off [{unit}]",
        f"left in [{unit}]",
        "peak friction, off",
        "left in",
    )
    note = "Shear of sample and rig at maximum force; peaks with it taken off and left in."
    return Table(f"The sample's own shear{name}", tuple(rows), heads, note, "shear")


def _pressure(pressure: float) -> str:
    return bare(pressure, "pressure")


def _top(test: TestResult) -> float:
    return float(np.max(test.fit.fitted))


def _pressure_head() -> str:
    return f"pressure [{unit_of('pressure')}]"
