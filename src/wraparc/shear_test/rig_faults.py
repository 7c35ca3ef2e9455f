"""What the tests of a condition show together: a rig that gives way, a step, an offset, aliasing.

Single curves of such a laboratory are sound, and a law goes through them; only side by side their
cause is seen.
"""

from collections.abc import Sequence

import numpy as np

from wraparc.arrays import Array, Flags
from wraparc.shear_test.analysis import Findings, TestResult
from wraparc.shear_test.consistency import USUAL, USUAL_WEIGHT
from wraparc.shear_test.misfit import Misfit
from wraparc.shear_test.plan import TestPlan
from wraparc.shear_test.record_faults import excess_kurtosis
from wraparc.shear_test.student import two_sided
from wraparc.units import quantity

# Slope of ln force over ln pressure of a force that does not rise, and of the peak slip over
# pressure where something gives way before the lagging slides; pressures that differ. Ours.
_NO_RISE, _EARLIER, _APART = 0.12, -0.25, 1.25
# Range of one force at three pressures or more, whatever their slips [-]. Ours.
_ONE_FORCE = 0.015
# Step or dent of ln mu over pressure that is asked about, how sure it must be, and what no trend
# through a few pressures follows. Ours.
_STEP, _STEP_LEVEL, _TREND = 0.05, 0.98, 0.015
# Repeats apart in slip: least difference of ln x_pk, how often a sound laboratory is accused, and
# the standard deviation between samples from which slips are not of one kind. Ours.
_SLIPS, _SLIP_ALARM, _LOOSE_SLIP = 0.12, 0.005, 0.12
# A force that stands in all tests, over the largest of the lightest, and over its error. Ours.
_STANDS, _SURE = 0.01, 5.0
# A share of the force that stands in all tests. Ours.
_RUBS = 0.03
# Readings even between two bounds: excess kurtosis, least scatter of friction, readings. Ours.
_EVEN, _SCATTERS, _READINGS = -0.5, 0.012, 200


def rig_sentences(plan: TestPlan, found: Findings) -> list[str]:
    """Say what the tests show together.

    Parameters
    ----------
    plan, found
        The plan, and what the tests of one condition have shown.
    """
    if plan.digitised is not None:
        return _slips_apart(found)
    given = _gives_way(found)
    return [
        *given,
        *([] if given else _step(found)),
        *_slips_apart(found),
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


def _gives_way(found: Findings) -> list[str]:
    """One force from a pressure on: backing, clamp or machine gives way before the rubber slides.

    Friction of any lagging falls with pressure by less than the pressure rises; a law that is one
    force (contact saturated) keeps its slip, where a backing that tears is passed ever earlier.
    """
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
    return _drawn(found, 1, ~found.flagged)


def _drawn(found: Findings, which: int, use: Flags) -> tuple[float, float]:
    squares, freedom = 0.0, 0
    for k in np.unique(found.levels[use]):
        own = found.points.value[(found.levels == k) & use, which]
        squares += float(((own - own.mean()) ** 2).sum())
        freedom += len(own) - 1
    variance = (squares + USUAL_WEIGHT * USUAL**2) / (freedom + USUAL_WEIGHT)
    return variance, freedom + USUAL_WEIGHT - 1.0


def _step(found: Findings) -> list[str]:
    """A step or a dent of friction over pressure, beyond what repeats allow.

    Against a parabola (of four pressures a line) of ln mu over ln p, by Student's t; only where the
    slopes go down and up again there, as those of no smooth law do, for a law that bends is
    no step.
    """
    pressure, values, counts = _means(found)
    count = len(pressure)
    if count < 4:
        return []
    x, y = np.log(pressure), values[:, 1]
    at = (x - x.mean()) / np.ptp(x)
    base = np.vander(at, 3 if count > 4 else 2)
    variance, freedom = _variance(found)
    weights = np.sqrt(1.0 / (variance / counts + _TREND**2))
    slopes = np.diff(y) / np.diff(x)
    shapes = [(k, np.arange(count) > k) for k in range(1, count - 2)]
    shapes += [(k, np.arange(count) == k) for k in range(1, count - 1)]
    sure = two_sided(freedom, 1.0 - (1.0 - _STEP_LEVEL) / len(shapes))
    best: tuple[float, float, int, bool] | None = None
    for k, shape in shapes:
        design = np.column_stack([base, shape]) * weights[:, None]
        size = float(np.linalg.lstsq(design, y * weights, rcond=None)[0][-1])
        error = float(np.sqrt(np.linalg.inv(design.T @ design)[-1, -1]))
        is_dent = int(shape.sum()) == 1 and k < count - 1 and bool(shape[k])
        t = abs(size) / error
        if abs(size) < _STEP or t < sure or not _breaks(slopes, x, k, size, is_dent):
            continue
        if best is None or t > best[0]:
            best = (t, size, k, is_dent)
    if best is None:
        return []
    _, size, k, is_dent = best
    low, high = (quantity(float(pressure[j]), "pressure") for j in (k, k + 1))
    way = f"{100 * abs(np.expm1(size)):.0f} % {'higher' if size > 0.0 else 'lower'}"
    where = f"at {low}" if is_dent else f"from {high} on"
    text = (
        f"friction is {way} {where} than the trend of the other pressures, more than repeats "
        "allow: damp or warm samples, another batch, another load cell or other weights?"
    )
    head = f"friction steps {way} {where}"
    return [Misfit(text, head, "Check samples, cell and weights there, and repeat a pressure.")]


def _breaks(slopes: Array, x: Array, k: int, size: float, is_dent: bool) -> bool:
    """Whether slopes of ln mu leave those on both sides, as no law that bends one way does."""
    steps = np.diff(x)

    def leaves(j: int, sign: float) -> bool:
        """Slope between pressures j and j + 1, beyond both of its neighbours by half the size."""
        beside = [slopes[i] for i in (j - 1, j + 1) if 0 <= i < len(slopes)]
        nearest = max(beside) if sign > 0.0 else min(beside)
        off = sign * (slopes[j] - nearest) * steps[j]
        return len(beside) == 2 and off > 0.4 * abs(size)

    sign = float(np.sign(size))
    if not is_dent:
        return leaves(k, sign)
    inner = [(j, s) for j, s in ((k - 1, sign), (k, -sign)) if 0 < j < len(slopes) - 1]
    return bool(inner) and all(leaves(j, s) for j, s in inner)


def _slips_apart(found: Findings) -> list[str]:
    """Repeats that differ in slip, not in friction."""
    use = ~found.flagged & np.array([t.fit.peak_inside for t in found.tests])
    values = found.points.value
    worst: tuple[float, int, int] | None = None
    repeated = [k for k in np.unique(found.levels) if int(((found.levels == k) & use).sum()) > 1]
    for k in repeated:
        own = np.flatnonzero((found.levels == k) & use)
        variance, freedom = _drawn(found, 0, use & (found.levels != k))
        low, high = own[np.argmin(values[own, 0])], own[np.argmax(values[own, 0])]
        off = float(values[high, 0] - values[low, 0])
        noise = float(found.points.covariance[[low, high], 0, 0].sum())
        sure = two_sided(freedom, 1.0 - _SLIP_ALARM / len(repeated))
        if off > max(_SLIPS, sure * np.sqrt(2.0 * variance + noise)) and (
            worst is None or off > worst[0]
        ):
            worst = (off, int(low), int(high))
    if worst is None and len(repeated) > 2:
        worst = _loose_slips(found, use, repeated)
    if worst is None:
        return []
    off, low, high = worst
    names = [found.tests[j].test.file for j in (low, high)]
    slips = [quantity(float(np.exp(values[j, 0])), "length") for j in (low, high)]
    text = (
        f"{names[0]} and {names[1]} are repeats, and their peaks are {100 * np.expm1(off):.0f} % "
        f"apart in slip ({slips[0]} and {slips[1]}), not in friction: see thickness and clamping "
        "of the samples, and what measured the travel"
    )
    head = f"slips of repeats are {100 * np.expm1(off):.0f} % apart ({names[0]}, {names[1]})"
    return [Misfit(text, head, "Check thickness, clamps and travel of these repeats.")]


def _loose_slips(
    found: Findings, use: Flags, repeated: Sequence[int]
) -> tuple[float, int, int] | None:
    """The widest of repeats of which none agrees with its own."""
    values, noise = found.points.value, found.points.covariance
    squares = [
        float(np.var(values[own, 0], ddof=1) - noise[own, 0, 0].mean())
        for k in repeated
        if len(own := np.flatnonzero((found.levels == k) & use)) > 1
    ]
    if float(np.mean(squares)) < _LOOSE_SLIP**2:
        return None
    own = np.flatnonzero((found.levels == repeated[int(np.argmax(squares))]) & use)
    low, high = own[np.argmin(values[own, 0])], own[np.argmax(values[own, 0])]
    return float(values[high, 0] - values[low, 0]), int(low), int(high)


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
