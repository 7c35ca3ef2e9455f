"""Where the law does not describe a curve, in words.

The sentences go into the report and into the lagging file. What the law cannot describe is
said, never absorbed: a lash that a rig cannot have is refused, not fitted.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from wraparc.shear_test.curve_fit import CurveFit, fit_curve
from wraparc.shear_test.curve_held import FREE, Held
from wraparc.shear_test.curve_model import friction_and_jacobian
from wraparc.shear_test.record_faults import Swing
from wraparc.shear_test.reduce import MOST_ZERO, FrictionCurve
from wraparc.units import quantity

_LATE = 0.5
_STRETCHES = 30
# What a law may leave of a curve, as a share of the largest friction: in any noise, and where it
# stands clear of the noise of one reading.
_REMAINDER, _SMALL_REMAINDER, _CLEAR_REMAINDER = 0.02, 0.01, 4.0
_NOISY = 0.05
_ZERO_LIMIT = 0.05
_UNKNOWN_PEAK = 0.25
_SWINGS = 3.0
# Readings of the rise between these shares of the peak that show it. Ours.
_RISING, _LOW, _HIGH = 2, 0.1, 0.92
_SUDDEN = 0.02
_SHOWN = 0.7
#: What a sentence is about that says nothing against the curve itself.
OTHER_PRESSURE = "other pressure"
#: What a sentence is about that says how much of a curve the law leaves.
REMAINDER = "remainder"
#: What a sentence is about that says friction is at its peak at once.
JUMP = "jump"
_RUBBING = "Measure what the rig rubs without a sample, and take it off."
_START = "Start the record before the stroke, and check where its travel starts."


class Sentence(NamedTuple):
    """A sentence, and what it is about, so that the same of many tests is said once.

    Attributes
    ----------
    about, text
        Both of these.
    headline, action
        What the first screen says of it, and what is to be done; empty where nothing special is.
    """

    about: str
    text: str
    headline: str = ""
    action: str = ""


class Misfit(str):
    """A sentence on what a law does not describe, with what the first screen says of it."""

    __slots__ = ("action", "headline")
    headline: str
    action: str

    def __new__(cls, text: str, headline: str = "", action: str = "") -> "Misfit":
        """Make one of a text, its few words for the first screen, and what is to be done."""
        own = super().__new__(cls, text)
        own.headline, own.action = headline, action
        return own


@dataclass(frozen=True, kw_only=True)
class JudgedFit:
    """A curve's fit, its lash within what the rig can have, and what is to be said of it.

    Parameters
    ----------
    fit
        The fit.
    misfit
        Sentences on what the law does not describe.
    remarks
        Sentences on what the curve does not tell.
    """

    fit: CurveFit
    misfit: tuple[Sentence, ...]
    remarks: tuple[str, ...]


def judged_fit(
    curve: FrictionCurve, largest_lash: float, bending: float | None = None, held: Held = FREE
) -> JudgedFit:
    """Fit a curve, hold its lash to what is possible, and say where the law fails.

    Parameters
    ----------
    curve
        From `reduce_record`.
    largest_lash
        Of the rig [m].
    bending, held
        As in `fit_curve`.
    """
    free = fit_curve(curve, bending=bending, held=held)
    top = curve.top
    if _zero_carried_off(free, curve, top):
        free = fit_curve(curve, bending=bending, hold_zero=True, held=held)
    fit, misfit = _lash_held(curve, free, largest_lash, bending, top)
    misfit += [Sentence(*fault) for fault in curve.faults]
    if curve.first_friction > _LATE * top:
        share = 100 * curve.first_friction / top
        text = (
            f"the first reading already has {share:.0f} % of the maximum friction: the rise from "
            "zero was not recorded, and the slip before it is not known"
        )
        head = f"the first reading has {share:.0f} % of the maximum friction"
        misfit.append(Sentence("late start", text, head, "Start the record before the stroke."))
    misfit += _jump(fit, curve) + _remainder(fit, curve, top)
    misfit += _not_a_zero(curve, top)
    zero = abs(fit.parameters.zero)
    if zero > _ZERO_LIMIT * top:
        text = (
            f"before the slip starts the force is {100 * zero / top:.1f} % of its maximum: "
            "more than an error of its zero; the rig itself may rub"
        )
        head = f"force before the slip is {100 * zero / top:.1f} % of its maximum"
        misfit.append(Sentence("rubbing", text, head, _RUBBING))
    return JudgedFit(fit=fit, misfit=tuple(misfit), remarks=_remarks(fit, curve, top))


def _not_a_zero(curve: FrictionCurve, top: float) -> list[Sentence]:
    """Force before the slip starts that is too much to be taken off as an error of its zero."""
    if curve.zero_unknown < 0.5 * MOST_ZERO * top:
        return []
    text = (
        f"before the slip starts the force is {200 * curve.zero_unknown / top:.0f} % of its "
        f"maximum: more than the {100 * MOST_ZERO:.0f} % that are taken for an error of "
        "its zero, so nothing was taken off; the rig may rub or the sample may have been under "
        "load, and the intervals include both"
    )
    head = f"force before the slip is {200 * curve.zero_unknown / top:.0f} % of its maximum"
    return [Sentence("rubbing", text, head, _RUBBING)]


def _zero_carried_off(fit: CurveFit, curve: FrictionCurve, top: float) -> bool:
    """Whether the fit bought a better curve with a zero that the record does not show."""
    if curve.zero is None or "zero" not in fit.free:
        return False
    off = abs(fit.parameters.zero - curve.zero)
    return off > 5.0 * curve.zero_error + 0.01 * top


def _lash_held(
    curve: FrictionCurve, free: CurveFit, largest: float, bending: float | None, top: float
) -> tuple[CurveFit, list[Sentence]]:
    """Refit with the lash at its limit where the free one is impossible."""
    if free.held.lash is not None:
        return free, []
    lash, error = free.parameters.lash, free.error("lash")
    most = quantity(largest, "length", 2)
    if lash > largest + 2.0 * error:
        sentence = (
            f"the curve requires a lash of {quantity(lash, 'length')}, more than the {most} the "
            "rig can have: the lash was fixed there, and the law does not describe the start"
        )
        held = fit_curve(curve, bending=bending, lash=largest, held=free.held)
        head = f"lash of {quantity(lash, 'length')} exceeds the {most} of the rig"
        return held, [Sentence("large lash", sentence, head, "Check clamps, or give largest_lash.")]
    negative = lash < -2.0 * error and lash < -1e-3 * curve.travel[-1]
    if negative and not _loaded(curve, free, top):
        sentence = (
            f"the curve requires a lash of {quantity(lash, 'length')}, the wrong sign: friction "
            "rises faster from its start than the law does; the lash was fixed at 0"
        )
        held = fit_curve(curve, bending=bending, lash=0.0, held=free.held)
        head = "friction rises faster at its start than the law"
        return held, [Sentence("lash of wrong sign", sentence, head, _START)]
    if negative and lash < -largest - 2.0 * error:
        sentence = (
            f"the curve requires {quantity(-lash, 'length')} of slip before the record starts, "
            f"more than the {most} of lash the rig can have: the lash was fixed at 0, and the law "
            "does not describe the start"
        )
        held = fit_curve(curve, bending=bending, lash=0.0, held=free.held)
        head = f"the record starts {quantity(-lash, 'length')} behind the start of slip"
        return held, [Sentence("slip before the record", sentence, head, _START)]
    return free, []


def _loaded(curve: FrictionCurve, fit: CurveFit, top: float) -> bool:
    """Whether the first readings show the friction that slip before the record would mean."""
    if curve.first_friction <= max(3.0 * curve.noise / np.sqrt(5.0), 0.01 * top):
        return False
    asked = friction_and_jacobian(np.zeros(1), fit.bending, fit.parameters)[0][0]
    return bool(curve.friction[:2].mean() > _SHOWN * asked - 2.0 * curve.noise)


def _jump(fit: CurveFit, curve: FrictionCurve) -> list[Sentence]:
    """Friction that is at its peak at once: the rise of the law rests on next to nothing."""
    peak = fit.parameters.peak_slip
    begin = fit.parameters.lash
    end = begin + peak + fit.bending * fit.parameters.peak_friction
    rising = int(((curve.travel > begin) & (curve.travel < end)).sum())
    share = (curve.friction - fit.parameters.zero) / fit.parameters.peak_friction
    shown = (curve.travel < end) & (share > _LOW) & (share < _HIGH)
    if int(shown.sum()) >= _RISING and peak > _SUDDEN * fit.slip_max:
        return []
    text = (
        f"friction is at its peak within {quantity(peak, 'length', 2)} of slip ({rising} "
        "readings): the law's rise rests on next to nothing, and a constant friction describes "
        "the curve as well"
    )
    head = f"friction is at its peak within {quantity(peak, 'length', 2)} of slip"
    return [Sentence(JUMP, text, head, "Check that the sample slides, and what measures travel.")]


def noise_levels(fit: CurveFit, curve: FrictionCurve) -> float:
    """What the law leaves of a curve, in noise levels of one reading."""
    return fit.remainder / curve.noise if curve.noise > 0.0 else 0.0


def _beyond_reading(fit: CurveFit, curve: FrictionCurve) -> float:
    """What the law leaves of a curve beyond what its points may be wrong by [-]."""
    slip, friction = curve.read_off
    if not slip and not friction:
        return fit.remainder
    steep = np.abs(np.gradient(fit.fitted, np.maximum.accumulate(curve.binned_travel) + 1e-12))
    off = np.abs(fit.friction - fit.fitted) - np.hypot(friction, slip * steep)
    return min(fit.remainder, float(np.sqrt(np.mean(np.maximum(off, 0.0) ** 2))))


def _remainder(fit: CurveFit, curve: FrictionCurve, top: float) -> list[Sentence]:
    left = _beyond_reading(fit, curve)
    share, levels = left / top, left / curve.noise if curve.noise > 0.0 else 0.0
    if share < _SMALL_REMAINDER or (share < _REMAINDER and levels < _CLEAR_REMAINDER):
        return []
    stretch = np.minimum((fit.slip / fit.slip_max * _STRETCHES).astype(int), _STRETCHES - 1)
    off = fit.friction - fit.fitted
    means = {
        k: float(np.average(off[stretch == k], weights=fit.weights[stretch == k]))
        for k in np.unique(stretch[stretch >= 0]).tolist()
    }
    worst = max(means, key=lambda k: abs(means[k]))
    place = quantity((worst + 0.5) / _STRETCHES * fit.slip_max, "length", 2)
    text = (
        f"the law leaves a systematic remainder of {100 * share:.1f} % of the maximum friction "
        f"({_in_levels(levels)}), maximum "
        f"({means[worst]:+.3f}) near {place} of slip"
    )
    return [Sentence(REMAINDER, text)]


def _in_levels(levels: float) -> str:
    return f"{levels:.2g} noise levels" if levels < 100.0 else "far above the noise"


def _remarks(fit: CurveFit, curve: FrictionCurve, top: float) -> tuple[str, ...]:
    remarks: list[str] = []
    if 0.0 < curve.zero_unknown < 0.5 * MOST_ZERO * top:
        remarks.append(
            "the record has no flat part before the slip starts, or a short one, so the zero of "
            f"the force cannot be verified: it is taken to be good to "
            f"{100 * curve.zero_unknown / top:.1f} % of the maximum force (one standard "
            "deviation), and the intervals include that"
        )
    q, error = fit.parameters, fit.error("ln_peak_slip")
    if not fit.peak_inside and error > _UNKNOWN_PEAK:
        remarks.append(
            f"the peak is outside the tested {quantity(fit.slip_max, 'length')} and this curve "
            f"does not determine it (peak slip uncertain by a factor of {np.exp(1.96 * error):.1f})"
        )
    if q.lash < 0.0 and "lash" in fit.free:
        remarks.append(
            f"the record starts under load: {quantity(-q.lash, 'length')} of slip were past by then"
        )
    if curve.noise > _NOISY * top:
        remarks.append(f"the readings scatter by {100 * curve.noise / top:.0f} % of the friction")
    swings = fit.noise > _SWINGS * curve.noise and fit.noise > 0.5 * _NOISY * top
    if swings and curve.swing is None and fit.remainder < _REMAINDER * top:
        remarks.append(
            f"the friction oscillates about the curve by {100 * fit.noise / top:.0f} %, slower "
            "than "
            "the noise of the readings, as a rig that swings by itself makes it"
        )
    if "post_peak_slope" in fit.free and "residual_friction" not in fit.free:
        remarks.append(
            "friction still falls at the end of the test: its residual level was not reached"
        )
    return tuple(remarks)


def stick_slip(swing: Swing) -> Sentence:
    """Say how much of the friction is stick-slip."""
    text = (
        f"stick-slip: friction varies by {100 * swing.size:.0f} % from its maximum to its "
        f"minimum, every {quantity(swing.period, 'length', 2)}; the law is that of its middle. "
        'Say which is meant: stick_slip = "mean", "upper" or "lower"'
    )
    head = f"stick-slip varies friction by {100 * swing.size:.0f} %"
    return Sentence("stick-slip", text, head, 'Write stick_slip = "mean", "upper" or "lower".')


def with_misfit(judged: JudgedFit, sentence: Sentence) -> JudgedFit:
    """Add a sentence."""
    return replace(judged, misfit=(*judged.misfit, sentence))
