"""What the tests of a condition show together: a rig that gives way, a step, an offset, aliasing.

Single curves of such a laboratory are sound, and a law goes through them; only side by side their
cause is seen.
"""

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array
from wraparc.shear_test.analysis import Findings, TestResult
from wraparc.shear_test.apart import are_apart, drawn, repeats_of
from wraparc.shear_test.consistency import USUAL
from wraparc.shear_test.misfit import JUMP, Misfit
from wraparc.shear_test.one_way import step_over_pressure
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.record_faults import excess_kurtosis
from wraparc.units import quantity

# Slope of ln force over ln pressure of a force that does not rise, and of the peak slip over
# pressure where something gives way before the lagging slides; pressures that differ. Ours.
_NO_RISE, _EARLIER, _APART = 0.12, -0.25, 1.25
# Range of one force at three pressures or more, whatever their slips [-]. Ours.
_ONE_FORCE = 0.015
# Repeats apart in slip: least difference of ln x_pk, how often a sound laboratory is accused, and
# the standard deviation between samples from which slips are not of one kind; slip over that of the
# peak that shows where it is. Ours.
_SLIPS, _SLIP_ALARM, _LOOSE_SLIP, _REACHED = 0.12, 0.01, 0.10, 0.8
_DOUBLE = float(np.log(2.0))  # from which slips are a factor apart, not per cents
# Repeats apart behind the peak: usual standard deviation and least difference of what friction
# changes by over the tested slip [-]; where the tail begins, its least length, both over the slip
# of the peak, and its least number of readings. Ours.
_USUAL_TAIL, _TAILS, _BEHIND, _LONG, _TAIL = 0.015, 0.08, 1.05, 1.15, 12
# A force that stands in all tests, over the largest of the lightest, and over its error. Ours.
_STANDS, _SURE = 0.01, 5.0
# A share of the force that stands in all tests. Ours.
_RUBS = 0.03
# Readings even between two bounds: excess kurtosis, least scatter of friction, readings. Ours.
_EVEN, _SCATTERS, _READINGS = -0.5, 0.012, 200


def rig_sentences(plan: TestPlan, found: Findings, *, gives_way: bool) -> list[str]:
    """Say what the tests show together.

    Parameters
    ----------
    plan, found
        The plan, and what the tests of one condition have shown.
    gives_way
        Whether they are known to have one force, which is no step.
    """
    if plan.digitised is not None:
        return _slips_apart(found)
    return [
        *([] if gives_way else _step(found)),
        *_slips_apart(found),
        *_tails_apart(found),
        *_standing(found.tests),
        *_aliased(found.tests),
    ]


def _means(found: Findings) -> tuple[Array, Array, Array]:
    """Pressures of the levels [Pa], means of (ln x_pk, ln mu_pk) there, and how many tests."""
    good = ~found.flagged
    levels = [k for k in np.unique(found.levels) if (good & (found.levels == k)).any()]
    inside = [good & (found.levels == k) for k in levels]
    pressure = np.array([found.points.pressure[own].mean() for own in inside])
    values = np.array([found.points.value[own].mean(0) for own in inside])
    return pressure, values, np.array([int(own.sum()) for own in inside])


def one_force(plan: TestPlan, found: Findings) -> list[str]:
    """Say that one force is reached from a pressure on, where backing, clamp or machine gives way.

    Friction of any lagging falls with pressure by less than the pressure rises; a law that is one
    force (contact saturated) keeps its slip, where a backing that tears is passed ever earlier.

    Parameters
    ----------
    plan, found
        As in `rig_sentences`.
    """
    if plan.digitised is not None:
        return []
    pressure, values, _ = _means(found)
    ln_p, ln_force = np.log(pressure), np.log(pressure) + values[:, 1]
    for first in range(len(pressure) - 1):
        own = slice(first, None)
        if pressure[-1] < _APART * pressure[first]:
            break
        slope, by_slip = (np.polyfit(ln_p[own], v[own], 1)[0] for v in (ln_force, values[:, 0]))
        several = len(pressure) - first
        # a force that rises and falls again is that of a curved law
        one = several > 2 and float(np.ptp(ln_force[own])) < _ONE_FORCE
        if one or (slope < _NO_RISE and by_slip < _EARLIER):
            force = float(np.exp(ln_force[own].mean())) * _force_per_pressure(found)
            low, high = (quantity(float(pressure[k]), "pressure") for k in (first, -1))
            text = (
                f"from {low} to {high} the peak is one force, {quantity(force, 'force')}, not one "
                "that grows with pressure: the backing, a clamp, an adhesive or the machine gives "
                "way before the lagging slides, and the law there is not its friction"
            )
            head = f"one force from {low} to {high}: backing or clamp gives way"
            return [Misfit(text, head, "Check backing, clamp and bond, or leave these out.")]
    return []


def _force_per_pressure(found: Findings) -> float:
    """Pulling force per friction and pressure [m2]."""
    test = found.tests[0]
    force = float(np.quantile(np.abs(test.record.force), 0.98))
    return force / (test.curve.top * test.curve.pressure)


def _variance(found: Findings) -> tuple[float, float]:
    """Variance of ln mu_pk between samples, drawn towards a usual one; its degrees of freedom."""
    good = ~found.flagged
    own = [found.points.value[(found.levels == k) & good, 1] for k in np.unique(found.levels[good])]
    squares = [float(((v - v.mean()) ** 2).sum()) for v in own]
    return drawn(squares, [len(v) - 1 for v in own], USUAL)


def _step(found: Findings) -> list[str]:
    """A step or a dent of friction over pressure, beyond what repeats allow."""
    pressure, values, counts = _means(found)
    variance, freedom = _variance(found)
    step = step_over_pressure(pressure, values[:, 1], variance / counts, freedom)
    if step is None:
        return []
    at = quantity(float(pressure[step.pressure]), "pressure")
    way = f"{100 * abs(np.expm1(step.size)):.0f} % {'higher' if step.size > 0.0 else 'lower'}"
    where = f"at {at}" if step.is_dent else f"from {at} on"
    text = (
        f"friction is {way} {where} than the trend of the other pressures, more than repeats "
        "allow: damp or warm samples, another batch, another load cell or other weights?"
    )
    head = f"friction steps {way} {where}"
    return [Misfit(text, head, "Check samples, cell and weights there, and repeat a pressure.")]


def _slips_apart(found: Findings) -> list[str]:
    """Repeats that differ in slip, not in friction."""
    use = ~found.flagged & np.array([_shows_slip(t) for t in found.tests])
    points = found.points
    repeats = repeats_of(points.value[:, 0], points.covariance[:, 0, 0], found.levels, use)
    if not are_apart(repeats, USUAL, _SLIPS, _SLIP_ALARM):
        squares = [max(r.squares / r.freedom - 0.5 * r.noise, 0.0) for r in repeats]
        if len(repeats) < 3 or float(np.mean(squares)) < _LOOSE_SLIP**2:
            return []
    off, low, high = repeats[0][:3]
    names = [found.tests[j].test.file for j in (low, high)]
    slips = [quantity(float(np.exp(found.points.value[j, 0])), "length") for j in (low, high)]
    apart = f"{100 * np.expm1(off):.0f} %" if off < _DOUBLE else f"a factor of {np.exp(off):.2g}"
    text = (
        f"{names[0]} and {names[1]} are repeats, and their peaks are {apart} "
        f"apart in slip ({slips[0]} and {slips[1]}), not in friction: see thickness and clamping "
        "of the samples, and what measured the travel"
    )
    head = f"slips of repeats are {apart} apart ({names[0]}, {names[1]})"
    return [Misfit(text, head, "Check thickness, clamps and travel of these repeats.")]


def _shows_slip(test: TestResult) -> bool:
    """Whether a curve shows where its peak is: near the tested slip, and not at its first."""
    fit = test.fit
    reached = fit.peak_inside or fit.slip_max > _REACHED * fit.parameters.peak_slip
    return reached and not any(s.about == JUMP for s in test.judged.misfit)


def _tails_apart(found: Findings) -> list[str]:
    """Repeats of which one goes on to rise or fall behind the peak, and the other does not.

    What friction changes by over the tested slip, of its peak, from the straight line through the
    readings behind the peaks of the pressure. A cell whose zero drifts during the stroke makes it,
    and a sample that warms or wears within it.
    """
    count = len(found.tests)
    change, noise, use = np.zeros(count), np.zeros(count), ~found.flagged
    for level in np.unique(found.levels):
        own = np.flatnonzero(found.levels == level)
        fits = [found.tests[k].fit for k in own]
        begin = _BEHIND * max(f.parameters.peak_slip for f in fits)
        end = min(f.slip_max for f in fits)
        for k, fit in zip(own, fits, strict=True):
            curve, top = found.tests[k].curve, fit.parameters.peak_friction
            slip = curve.travel - fit.parameters.lash - fit.bending * curve.friction
            behind = (slip > begin) & (slip < end)
            use[k] &= end > _LONG * begin and int(behind.sum()) >= _TAIL
            if use[k]:
                x = slip[behind] - slip[behind].mean()
                change[k] = float(x @ curve.friction[behind] / (x @ x)) * end / top
                noise[k] = (curve.noise * end / top) ** 2 / float(x @ x)
    repeats = repeats_of(change, noise, found.levels, use)
    if not are_apart(repeats, _USUAL_TAIL, _TAILS, _SLIP_ALARM):
        return []
    _, low, high = repeats[0][:3]
    names = [found.tests[k].test.file for k in (low, high)]
    by = [f"{100 * change[k]:+.0f} %" for k in (low, high)]
    text = (
        f"{names[0]} and {names[1]} are repeats, and behind their peaks friction changes by "
        f"{by[0]} and {by[1]} over the tested slip, more unlike than that of the others: the zero "
        "of the cell drifts during a stroke, or a sample warms or wears within it"
    )
    head = f"behind the peak {names[0]} changes by {by[0]}, repeat {names[1]} by {by[1]}"
    return [Misfit(text, head, "Read the cell's zero before and after each stroke.")]


def _standing(tests: Sequence[TestResult]) -> list[str]:
    """One force that stands in all tests before they slide.

    The force before the slip starts, where nothing was taken off as an error of the zero, in
    newtons: of a rig or a cell it is the same at all pressures, where friction is not.
    """
    forces, errors, tops = [], [], []
    for test in tests:
        curve = test.curve
        if curve.zero is not None:
            continue
        scale = float(np.quantile(np.abs(test.record.force), 0.98)) / curve.top  # N per friction
        before = curve.friction[curve.travel < min(curve.onset, max(test.fit.parameters.lash, 0.0))]
        if len(before) < 1 or curve.first_friction > 0.3 * curve.top:
            continue
        forces.append(float(before.mean()) * scale)
        errors.append(curve.noise * scale / np.sqrt(len(before)))
        tops.append(curve.top * scale)
    if len(forces) < 3 or max(tops) < 1.5 * min(tops):
        return []
    weights = 1.0 / np.square(errors)
    force, error = float(np.average(forces, weights=weights)), float(weights.sum() ** -0.5)
    apart = float(np.sqrt(np.average((np.array(forces) - force) ** 2 * weights)))
    alike = apart < 3.0 or float(np.std(forces)) < 0.5 * abs(force)
    if not alike:
        return _rubs(np.array(forces) / tops, np.array(errors) / tops, len(tests))
    if abs(force) < max(_STANDS * min(tops), _SURE * error):
        return []
    share = abs(force) / min(tops)
    text = (
        f"before the slip starts {quantity(force, 'force')} stand in {len(forces)} of "
        f"{len(tests)} tests, at every pressure: an error of the cell's zero, a dead load or drag "
        f"of the rig, up to {100 * share:.1f} % of the maximum force; it was not taken off"
    )
    head = f"{quantity(force, 'force')} stand in all forces before the slip starts"
    return [Misfit(text, head, "Zero the load cell, or record 10 readings before the pull.")]


def _rubs(shares: Array, errors: Array, count: int) -> list[str]:
    """A share of the load that stands in all tests, as a guide that rubs makes it."""
    share, spread = float(shares.mean()), float(shares.std())
    error = float(np.sqrt(np.sum(errors**2))) / len(shares)
    if abs(share) < max(_RUBS, _SURE * error) or spread > 0.5 * abs(share):
        return []
    text = (
        f"before the slip starts {100 * share:.1f} % of the maximum force stand in "
        f"{len(shares)} of {count} tests: a guide or a bearing of the rig rubs with "
        "the load; it was not taken off"
    )
    head = f"{100 * share:.1f} % of the force stand before the slip starts"
    return [Misfit(text, head, "Measure what the rig rubs without a sample, and take it off.")]


def _aliased(tests: Sequence[TestResult]) -> list[str]:
    """Readings that scatter evenly between two bounds: swings faster than they are sampled."""
    parts, shares = [], []
    for test in tests:
        curve = test.curve
        if curve.swing is not None or test.test.stick_slip:
            continue
        slides = curve.friction > 0.6 * curve.top
        x, y = curve.travel[slides], curve.friction[slides]
        if len(x) < 30:
            continue
        at = (x - x[0]) / max(float(x[-1] - x[0]), 1e-12)
        design = np.vander(at, 8)
        off = y - design @ np.linalg.lstsq(design, y, rcond=None)[0]
        parts.append(off / max(float(np.std(off)), 1e-12))
        shares.append(float(np.std(off)) / curve.top)
    if not parts:
        return []
    readings = np.concatenate(parts)
    if len(readings) < _READINGS or float(np.mean(shares)) < _SCATTERS:
        return []
    if excess_kurtosis(readings) > _EVEN:
        return []
    size = np.sqrt(12.0) * float(np.mean(shares))  # of an even distribution
    text = (
        f"readings scatter evenly over {100 * size:.0f} % of friction, not as noise does: "
        "stick-slip or vibration that is sampled slower than its period; its middle is the law, if "
        "the readings are not filtered"
    )
    head = f"readings vary by {100 * size:.0f} %, faster than they are sampled"
    return [Misfit(text, head, "Record faster, or write stick_slip in each [[test]].")]
