"""What the lagging answers to creep: shear stress tau(u, p) with both derivatives.

Slip and shear of the lagging in series, u = x + (h/G) tau with tau = mu(x, p) p (section 2 of the
page on the model). Creep is the state across the width, not slip: neighbouring strips may creep
either way, and creep passes through zero where slip has no slope. Plain numbers, like the march
along the arc, so that one source runs in the interpreter and compiled.
"""

from __future__ import annotations

from math import log
from typing import NamedTuple

from wraparc.friction.compact import (
    LIMIT,
    PLASTIC,
    SMALLEST,
    TABLE,
    CompactLaw,
    friction_at,
    peak,
    segment_of,
    tail,
)

_MOST_ITERATIONS = 60


class Stress(NamedTuple):
    """Shear stress of a strip.

    Attributes
    ----------
    stress
        tau [Pa].
    by_creep, by_pressure
        Its derivatives by creep at fixed pressure [Pa/m] and by pressure at fixed creep [-].
    slip
        x [m].
    """

    stress: float
    by_creep: float
    by_pressure: float
    slip: float


def stress_of(law: CompactLaw, compliance: float, creep: float, pressure: float) -> Stress:
    """Shear stress between belt and lagging.

    Parameters
    ----------
    law
        The friction law.
    compliance
        h/G of the lagging, >= 0 [m/Pa].
    creep
        u, either sign [m].
    pressure
        Wrap pressure [Pa]; a strip without pressure carries nothing.
    """
    if pressure <= 0.0:
        return Stress(0.0, 0.0, 0.0, creep)
    b = abs(creep)
    segment = segment_of(law, pressure)
    if law.kind == LIMIT:
        found = _limit(law, segment, compliance, b, pressure)
    elif law.kind == TABLE:
        found = _table(law, segment, compliance, b, pressure)
    else:
        found = _integral_log(law, segment, compliance, b, pressure)
    if creep < 0.0:
        return Stress(-found.stress, found.by_creep, -found.by_pressure, -found.slip)
    return found


def branch_of(law: CompactLaw, compliance: float, creep: float, pressure: float) -> int:
    """Number of the piece of its law that a strip is on, 0 where it sticks; arguments as above.

    Pieces in creep of a law that sticks and slides, or is a table; 0 for any other.
    """
    if pressure <= 0.0:
        return 0
    b, segment = abs(creep), segment_of(law, pressure)
    if law.kind == LIMIT:
        mu, _, _ = friction_at(law, segment, PLASTIC, 0.0, pressure)
        return int(b > (compliance + law.onset_compliance) * mu * pressure)
    if law.kind != TABLE:
        return 0
    passed = 0
    for k, x in enumerate(law.slips):
        mu, _, _ = friction_at(law, segment, max(k - 1, 0), x, pressure)
        passed += int(b > x + compliance * mu * pressure)
    return passed


def _series(
    mu: float, mu_x: float, mu_p: float, compliance: float, pressure: float, slip: float
) -> Stress:
    """Shear stress of a sliding strip from the friction at its slip and the derivatives."""
    slope = mu_x * pressure
    yielding = 1.0 + compliance * slope
    return Stress(mu * pressure, slope / yielding, (mu + pressure * mu_p) / yielding, slip)


def _limit(law: CompactLaw, segment: int, compliance: float, b: float, pressure: float) -> Stress:
    mu, _, mu_p = friction_at(law, segment, PLASTIC, 0.0, pressure)
    elastic = compliance + law.onset_compliance
    if b <= elastic * mu * pressure and elastic > 0.0:
        stress = b / elastic
        return Stress(stress, 1.0 / elastic, 0.0, law.onset_compliance * stress)
    return _series(mu, 0.0, mu_p, compliance, pressure, b - compliance * mu * pressure)


def _integral_log(
    law: CompactLaw, segment: int, compliance: float, b: float, pressure: float
) -> Stress:
    slip_pk, mu_pk, slip_pk_p, mu_pk_p = peak(law, segment, pressure)
    last = len(law.edges) - 1
    held = 1.0  # above the highest tested pressure the traction is held
    if last >= 0 and segment >= last:
        held = law.edges[last] / pressure
    reach = compliance * pressure * mu_pk * held  # shear of the lagging at the peak
    if b > slip_pk + reach:
        return _past_peak(law, segment, compliance, b, pressure)
    if b == 0.0 and compliance > 0.0:
        return Stress(0.0, 1.0 / compliance, 0.0, 0.0)
    whole = slip_pk + reach
    small = max(b / whole, SMALLEST)
    r = max(b / (slip_pk + reach * (1.0 - log(small))), SMALLEST)
    for _ in range(_MOST_ITERATIONS):
        lr = log(r)
        step = (slip_pk * r + reach * r * (1.0 - lr) - b) / (slip_pk - reach * lr)
        r = min(max(r - step, 0.1 * r), 1.0)
        if r < SMALLEST:
            r = SMALLEST
            break
        if abs(step) <= 1e-13 * r:
            break
    lr = log(r)
    form = r - r * lr
    mu = held * mu_pk * form
    mu_x = -held * mu_pk * lr / slip_pk
    mu_p = mu_pk_p * form + mu_pk * lr * r * slip_pk_p / slip_pk
    if held < 1.0:
        mu_p = -mu / pressure
    return _series(mu, mu_x, mu_p, compliance, pressure, slip_pk * r)


def _past_peak(
    law: CompactLaw, segment: int, compliance: float, b: float, pressure: float
) -> Stress:
    slip_pk, mu_pk, _, _ = peak(law, segment, pressure)
    slope, residual, _, _ = tail(law, segment, pressure)
    last = len(law.edges) - 1
    held = 1.0
    if last >= 0 and segment >= last:
        held = law.edges[last] / pressure
    give = compliance * pressure * held
    beyond = (b - slip_pk - give * mu_pk) / (1.0 + give * slope)
    branch, slip = 1, slip_pk + beyond
    if mu_pk + slope * beyond < min(residual, mu_pk):
        branch, slip = 2, b - give * min(residual, mu_pk)
    mu, mu_x, mu_p = friction_at(law, segment, branch, slip, pressure)
    return _series(mu, mu_x, mu_p, compliance, pressure, slip)


def _table(law: CompactLaw, segment: int, compliance: float, b: float, pressure: float) -> Stress:
    onset, _, _ = friction_at(law, segment, 0, 0.0, pressure)
    if b <= compliance * onset * pressure and compliance > 0.0:
        return Stress(b / compliance, 1.0 / compliance, 0.0, 0.0)
    slips = law.slips
    branch, low = 0, 0.0
    high = b
    while branch < len(slips) - 1:
        x = slips[branch + 1]
        mu, _, _ = friction_at(law, segment, branch, x, pressure)
        if x + compliance * mu * pressure >= b:
            high = min(high, x)
            break
        branch, low = branch + 1, x
    slip = 0.5 * (low + high)
    for _ in range(_MOST_ITERATIONS):
        mu, mu_x, _ = friction_at(law, segment, branch, slip, pressure)
        miss = slip + compliance * mu * pressure - b
        if miss > 0.0:
            high = slip
        else:
            low = slip
        trial = slip - miss / (1.0 + compliance * mu_x * pressure)
        if not low <= trial <= high:
            trial = 0.5 * (low + high)
        done = abs(trial - slip) <= 1e-14 * b
        slip = trial
        if done:
            break
    mu, mu_x, mu_p = friction_at(law, segment, branch, slip, pressure)
    return _series(mu, mu_x, mu_p, compliance, pressure, slip)
