"""The least slack-side tension that carries a pull within a limit of creep.

By Newton's method where it meets the pull, else by a search of one unknown, the entry tension: the
pull at the limit rises with it up to a largest one, where the belt shrinks as far as it may.
"""

from __future__ import annotations

from math import exp, inf, log, nan

from wraparc.arc.kernel.capacity import MEET_STEPS, Guess, carry, carry_from, meet
from wraparc.arc.kernel.effort import CREEP, Aim
from wraparc.arc.kernel.layers import NO_LAYERS
from wraparc.arc.kernel.quantities import Geometry
from wraparc.friction.compact import CompactLaw

HIGHEST = 1e3  # times the tight side, where no largest pressure is given
PULL_TOLERANCE = 2e-9  # relative: what the steps of layers leave
GOLDEN = 0.6180339887498949
NEAR_TOP = 0.08  # of ln(tension): so near its top the pull is a parabola


def highest_tight(pressure_max: float, area: float, tight: float) -> float:
    """Largest tight-side tension that is looked at [N]: that of the largest tested pressure.

    `area` is B R; without a tested range a thousand times the present one.
    """
    return pressure_max * area if pressure_max == pressure_max else HIGHEST * tight


def least_slack(
    law: CompactLaw,
    geometry: Geometry,
    pull: float,
    limit: float,
    tight: float,
    entry: float,
    z: float,
    tight_max: float,
    steps: int,
) -> tuple[float, float]:
    """Least slack-side tension that carries a pull within a creep limit.

    Parameters
    ----------
    pull
        |T1 - T2| to be carried [N].
    limit
        Exit creep towards the slack side [m].
    tight, entry, z
        A tight-side tension, and the entry tension and effort at its creep limit, to begin with
        [N, N, -].
    tight_max
        Largest tight-side tension to consider [N]: the top of the tested pressures.

    Returns
    -------
    least, most
        The smallest root [N] and nan; without a root nan and the largest pull there is [N].
    """
    if z != z:  # a long arc
        return _least_bracketed(law, geometry, pull, limit, tight_max, steps)
    met, _, entry_met, shot, growth = meet(
        law, geometry, Aim(CREEP, limit), True, pull, entry, z, 1.5 * tight_max, steps
    )
    if met and growth > 0.0:
        found = max(entry_met, entry_met * exp(shot.log_tension))
        if found <= tight_max:
            return found - pull, nan
    return _least_bracketed(law, geometry, pull, limit, tight_max, steps)


def _least_bracketed(
    law: CompactLaw, geometry: Geometry, pull: float, limit: float, tight_max: float, steps: int
) -> tuple[float, float]:
    """`least_slack` where Newton's method fails: the pull rises with tension to a largest one.

    In t, the logarithm of the entry tension, which a search of one unknown meets the limit at.
    """
    aim = Aim(CREEP, limit)
    _, z, entry, shot = carry(law, geometry, tight_max, aim, nan, MEET_STEPS)
    guess = Guess(z, NO_LAYERS)
    high, p_high = log(entry), entry * abs(1.0 - exp(shot.log_tension))
    if p_high < pull:
        high, p_high, guess = _most(law, geometry, limit, pull, high, p_high, guess)
    if p_high < pull:
        if high < log(entry):
            return nan, _pull(law, geometry, exp(high), limit, guess, steps)[0]
        shot = carry(law, geometry, tight_max, aim, guess.z, steps)[3]
        return nan, tight_max * (1.0 - exp(-abs(shot.log_tension)))
    low, p_low, high, p_high, guess = _down(law, geometry, pull, limit, high, p_high, guess)
    if p_low != p_low:
        return nan, nan
    f_low, f_high = log(max(p_low, 1e-9 * pull) / pull), log(p_high / pull)
    side, slope, t_last, f_last = 0, 1.0, high, f_high
    for _ in range(40):
        t = (low * f_high - high * f_low) / (f_high - f_low)
        p, guess = _pull(law, geometry, exp(t), limit, guess, MEET_STEPS)
        f = log(max(p, 1e-9 * pull) / pull)
        if t != t_last:
            slope = (f - f_last) / (t - t_last)
        if abs(f) < 1e-3:
            break
        # false position keeps one end: halve its weight when it does (Illinois)
        if f > 0.0:
            f_low *= 0.5 if side > 0 else 1.0
            high, f_high, side = t, f, 1
        else:
            f_high *= 0.5 if side < 0 else 1.0
            low, f_low, side = t, f, -1
        t_last, f_last = t, f
    t = _pull_closed(law, geometry, pull, limit, (t, slope), guess, steps)
    return (exp(t) - pull if geometry.side > 0.0 else exp(t)), nan


def _down(
    law: CompactLaw,
    geometry: Geometry,
    pull: float,
    limit: float,
    high: float,
    p_high: float,
    guess: Guess,
) -> tuple[float, float, float, float, Guess]:
    """Bracket of ln(entry tension) around a pull, from where more is carried downwards.

    Both ends with the pulls there, the lower one first, and what to go on from.
    """
    floor = log(pull) if geometry.side > 0.0 else -inf  # no belt pulls more than its tight side
    low, p_low = high, p_high
    step, slope = inf, 1.0
    while p_low >= pull:
        # where little tension is left, the pull goes with it; before that it falls more slowly
        step = min(1.2 * log(p_low / pull) / slope + 0.02, 2.0 * step)
        high, p_high, low = low, p_low, low - step
        if low <= floor:
            return floor, 0.5 * pull, high, p_high, guess
        p_low, guess = _pull(law, geometry, exp(low), limit, guess, MEET_STEPS)
        if p_low >= pull:
            slope = max(min(log(p_high / p_low) / step, 1.0), 1e-3)
    return low, p_low, high, p_high, guess


def _pull_closed(
    law: CompactLaw,
    geometry: Geometry,
    pull: float,
    limit: float,
    near: tuple[float, float],
    guess: Guess,
    steps: int,
) -> float:
    """ln(entry tension) at which a pull is carried, by secants on the fine mesh; nan if not met.

    `near` is one close to it, and the slope of ln(pull) there, as the coarse mesh has them.
    """
    t, slope = near
    t_last = f_last = 0.0
    for i in range(12):
        p, guess = _pull(law, geometry, exp(t), limit, guess, steps)
        f = log(max(p, 1e-9 * pull) / pull)
        if abs(f) < PULL_TOLERANCE:
            return t
        if i > 0 and t != t_last:
            slope = (f - f_last) / (t - t_last)
        if slope <= 0.0 or abs(f) > slope:
            break  # it goes astray
        t_last, f_last, t = t, f, t - f / slope
    return nan


def _pull(
    law: CompactLaw, geometry: Geometry, entry: float, limit: float, guess: Guess, steps: int
) -> tuple[float, Guess]:
    """Pull carried at a creep limit with a held entry tension [N], and what to go on from."""
    _, guess, shot = carry_from(law, geometry, entry, Aim(CREEP, limit), guess, steps)
    return entry * abs(1.0 - exp(shot.log_tension)), guess


def _most(
    law: CompactLaw,
    geometry: Geometry,
    limit: float,
    enough: float,
    top: float,
    p_top: float,
    guess: Guess,
) -> tuple[float, float, Guess]:
    """ln(entry tension) up to `top` of the largest pull at a creep limit, the pull [N], a guess.

    Golden section on the coarse mesh and a parabola; a pull of `enough` ends it. `p_top` and
    `guess` belong to the top.
    """
    p_in, guess_in = _pull(law, geometry, exp(top - 0.02), limit, guess, MEET_STEPS)
    if p_in <= p_top:
        return top, p_top, guess
    low, high, p_low, p_high = top - 3.0, top, -inf, p_top
    d = low + GOLDEN * (high - low)
    p_d, guess = _pull(law, geometry, exp(d), limit, guess_in, MEET_STEPS)
    c = high - GOLDEN * (high - low)
    p_c, guess = _pull(law, geometry, exp(c), limit, guess, MEET_STEPS)
    while high - low > NEAR_TOP and max(p_c, p_d) < enough:
        if p_c >= p_d:
            high, p_high, d, p_d = d, p_d, c, p_c
            c = high - GOLDEN * (high - low)
            p_c, guess = _pull(law, geometry, exp(c), limit, guess, MEET_STEPS)
        else:
            low, p_low, c, p_c = c, p_c, d, p_d
            d = low + GOLDEN * (high - low)
            p_d, guess = _pull(law, geometry, exp(d), limit, guess, MEET_STEPS)
    t, p_t = (c, p_c) if p_c >= p_d else (d, p_d)
    if p_t >= enough or p_low == -inf:
        return t, p_t, guess
    # the top of the parabola through the best and its neighbours
    left, right = (low, d) if t == c else (c, high)
    p_left, p_right = (p_low, p_d) if t == c else (p_c, p_high)
    rise, fall = (p_t - p_left) / (t - left), (p_right - p_t) / (right - t)
    v = 0.5 * (left + t) + 0.5 * (right - left) * rise / (rise - fall)
    p_v, guess_v = _pull(law, geometry, exp(v), limit, guess, MEET_STEPS)
    return (v, p_v, guess_v) if p_v > p_t else (t, p_t, guess)
