"""What speed and temperature of the tests do to friction, told apart where the tests allow it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.drive import FrictionFactor
from wraparc.provenance import Kind, Provenance
from wraparc.shear_test.analysis import Separated, TestResult
from wraparc.shear_test.reduce import FrictionCurve
from wraparc.shear_test.speeds import per_minute, speed_groups
from wraparc.shear_test.student import t95
from wraparc.units import in_units, quantity

#: Fits a test again, its friction times a factor.
Refit = Callable[[TestResult, float], TestResult]

# Temperatures within this are one [K]; an effect below this over the tested range is none; columns
# that agree more than this, and fewer degrees of freedom, tell nothing. Ours.
_ONE_TEMPERATURE, _LEAST, _TOGETHER, _FREEDOM = 3.0, 0.02, 0.9, 2


@dataclass(frozen=True, eq=False)
class _Circumstance:
    """Speed or temperature of the tests.

    Attributes
    ----------
    name
        Of it.
    at, told
        Its values, ascending [SI], and in words.
    value
        What ln mu is linear in at each, 0 at the reference.
    group
        Value of each test, its place in `at`, shape (n,).
    """

    name: str
    at: tuple[float, ...]
    told: tuple[str, ...]
    value: Array
    group: Integers


def separate(
    tests: Sequence[TestResult], levels: Integers, refit: Refit
) -> tuple[list[TestResult], Separated]:
    """Bring tests to one speed and one temperature.

    Within each pressure ln mu_pk = c_v ln(v/v_0) + c_T (T - T_0), by least squares; an effect that
    is larger than its 95 % interval, and than 2 %, is taken off the curves.

    Parameters
    ----------
    tests
        Of one condition.
    levels
        Number of the pressure of each, shape (n,).
    refit
        Fits a test again.

    Returns
    -------
    tests
        At the reference: the slowest speed, the commonest temperature.
    separated
        The effects, and what could not be told.
    """
    some = [c for c in (_speed(tests), _temperature(tests)) if c is not None]
    inside = [_within(c.value[c.group], levels) for c in some]
    known = [c for c, x in zip(some, inside, strict=True) if np.abs(x).max() > 1e-9]
    remarks = [
        f"no pressure was tested at more than one {c.name}: what {c.name} does is not known"
        for c in some
        if c not in known and c.name != "speed"  # that is a misfit, see `speed_sentences`
    ]
    freedom = len(tests) - len(np.unique(levels)) - len(known)
    design = np.array([_within(c.value[c.group], levels) for c in known]).T
    if known and freedom < _FREEDOM:
        names = " and ".join(c.name for c in known)
        remarks.append(f"too few tests for the effect of {names}")
        known = []
    if len(known) > 1 and _agreement(design) > _TOGETHER:
        remarks.append("speed and temperature changed together: what either does is not known")
        known = []
    if not known:
        return list(tests), Separated(remarks=tuple(remarks))
    friction = np.array([t.fit.parameters.ln_peak_friction for t in tests])
    slopes, halves = _slopes(design, _within(friction, levels), freedom)
    factors: dict[str, FrictionFactor] = {}
    for c, slope, half in zip(known, slopes.tolist(), halves.tolist(), strict=True):
        span = float(np.ptp(c.value))
        change = f"{100 * np.expm1(slope * span):+.1f} ± {100 * half * span:.1f} %"
        over = f"from {c.told[0]} to {c.told[-1]} friction changes by {change}"
        if abs(slope) <= half or abs(slope * span) < _LEAST:
            remarks.append(f"{over}: no effect of {c.name} that the tests resolve")
            continue
        remarks.append(f"{over}: taken off the curves, and saved with the law as a factor")
        factor = tuple(np.exp(slope * c.value).tolist())
        source = Provenance(Kind.MEASURED, note=in_units(f"shear tests: {over}"))
        factors[c.name] = FrictionFactor(at=c.at, factor=factor, source=source)
    return _moved(tests, known, factors, refit), Separated(
        by_slip_speed=factors.get("speed"),
        by_temperature=factors.get("temperature"),
        remarks=tuple(remarks),
    )


def _moved(
    tests: Sequence[TestResult],
    known: Sequence[_Circumstance],
    factors: dict[str, FrictionFactor],
    refit: Refit,
) -> list[TestResult]:
    found = []
    for k, test in enumerate(tests):
        factor = 1.0
        for c in known:
            if c.name in factors:
                factor *= factors[c.name].factor[c.group[k]]
        found.append(refit(test, 1.0 / factor) if factor != 1.0 else test)
    return found


def _speed(tests: Sequence[TestResult]) -> _Circumstance | None:
    """Speeds of the tests, on a logarithmic scale from the slowest; None where they are one."""
    group, speeds = speed_groups(tests)
    if len(speeds) < 2:
        return None
    told = tuple(per_minute(speed) for speed in speeds)
    return _Circumstance("speed", tuple(speeds), told, np.log(np.array(speeds) / speeds[0]), group)


def _temperature(tests: Sequence[TestResult]) -> _Circumstance | None:
    """Temperatures of the tests from the commonest; None where they are one, or not all known."""
    said = [test.test.temperature for test in tests]
    if any(t is None for t in said):
        return None
    values = np.array(said, dtype=float)
    group, at = np.zeros(len(values), dtype=np.int64), list[float]()
    for k in np.argsort(values, kind="stable").tolist():
        if not at or values[k] > at[-1] + _ONE_TEMPERATURE:
            at.append(float(values[k]))
        group[k] = len(at) - 1
    if len(at) < 2:
        return None
    common = at[int(np.bincount(group).argmax())]
    told = tuple(quantity(t, "temperature") for t in at)
    return _Circumstance("temperature", tuple(at), told, np.array(at) - common, group)


def _within(values: Array, levels: Integers) -> Array:
    """Values less the mean of their pressure."""
    means = np.bincount(levels, values) / np.maximum(np.bincount(levels), 1)
    return np.asarray(values - means[levels])


def _agreement(design: Array) -> float:
    a, b = design.T
    return float(abs(a @ b) / np.sqrt((a @ a) * (b @ b)))


def _slopes(design: Array, values: Array, freedom: int) -> tuple[Array, Array]:
    """Slopes by least squares, and half their 95 % intervals."""
    inverse = np.linalg.inv(design.T @ design)
    slopes = inverse @ design.T @ values
    off = values - design @ slopes
    errors = np.sqrt(np.diag(inverse) * float(off @ off) / freedom)
    return slopes, t95(freedom) * errors


def at_reference(curve: FrictionCurve, factor: float) -> FrictionCurve:
    """Return a curve with its friction times a factor; sample and rig have yielded as they have."""
    return replace(
        curve,
        friction=factor * curve.friction,
        binned_friction=factor * curve.binned_friction,
        bending=curve.bending / factor,
        noise=factor * curve.noise,
        zero=None if curve.zero is None else factor * curve.zero,
        zero_error=factor * curve.zero_error,
        first_friction=factor * curve.first_friction,
    )
