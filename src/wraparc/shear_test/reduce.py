"""A machine record to a friction curve: mu = F_x / (n F_n) over machine travel.

What is taken off is said: force zero, unloading, release, spikes. The lash is not cut here
but estimated with the curve, because the two depend on each other.
"""

import math
from dataclasses import dataclass

import numpy as np

from wraparc.arrays import Array, Integers
from wraparc.errors import InputError
from wraparc.machine_tables import refused
from wraparc.shear_test.noise import despiked, noise_level
from wraparc.shear_test.record import MachineRecord
from wraparc.shear_test.record_faults import (
    Fault,
    Swing,
    envelope,
    saturated,
    stall,
    swing,
    travel_faults,
    unlike_strokes,
    without_repeats,
)
from wraparc.shear_test.strokes import Stroke, find_strokes
from wraparc.shear_test.travel_units import meant_travel

LEAST_POINTS = 10
#: Which pull of a record is used: the first, the last (after run-in cycles), the readings of all,
#: or the mean of all at each travel.
STROKES = ("first", "last", "all", "mean")
_BINS = 300
_FINE = 10
# Beyond these a column or a unit is wrong.
_SLIPS = (
    (1e-3, "a force in N had been read as kN"),
    (1e3, "a force in kN had been read as N"),
    (1 / 4.4482216152605, "a force in N had been read as lbf"),
    (4.4482216152605, "a force in lbf had been read as N"),
    (0.1, "its pressure or normal force were 10 times as large"),
    (10.0, "its pressure or normal force were a tenth"),
    (0.01, "its sample area or pressure were 100 times as large"),
    (100.0, "its sample area or pressure were a hundredth"),
)
# Friction of a lagging, by which the likelier of these is named first. Ours.
_LIKELY = 0.6
#: Error of the force's zero, as a share of the largest force, where the record does not show it
#: (one standard deviation), and the most that is taken for one. Ours.
UNKNOWN_ZERO, MOST_ZERO = 0.02, 0.1
_LEAST_BEFORE = 3
# A record of fewer readings is looked at reading by reading. Ours.
_SPARSE = 100
_LEAST_TRAVEL, _MOST_TRAVEL, _MOST_FORCE = 1e-6, 10.0, 1e9


@dataclass(frozen=True, kw_only=True)
class Sample:
    """What was clamped, and in what rig.

    Parameters
    ----------
    area
        Of one face [m2].
    faces
        Number of faces that slide.
    shear_compliance
        h/G of lagging and belt cover, to take their shear off the travel [m/Pa]; 0 to leave it
        in.
    compliance
        Of the rig [m/N].
    normal_force
        Constant normal force [N], where the record has no measured one.
    friction
        Least and most friction that a test may reach [-].
    stroke
        Which pull of a record of several: one of `STROKES`.
    stick_slip
        Which part of stick-slip is kept: one of `STICK_SLIP`; empty keeps all readings.
    recorded
        Whether sensors recorded it; a curve read off a figure has no end of a load cell.
    """

    area: float
    faces: int = 2
    shear_compliance: float = 0.0
    compliance: float = 0.0
    normal_force: float | None = None
    friction: tuple[float, float] = (0.0, np.inf)
    stroke: str = "first"
    stick_slip: str = ""
    recorded: bool = True


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionCurve:
    """Friction over machine travel, ready to be fitted.

    Parameters
    ----------
    travel, friction
        The pull: travel from its first reading [m] and friction [-], shape (n,).
    binned_travel, binned_friction, counts
        Means over bins that are narrow where the friction rises, and the readings in each,
        shape (m,).
    place
        Bin of each reading, shape (n,).
    pressure
        Mean pressure while sliding [Pa].
    bending
        K, travel that friction 1 bends away in sample and rig [m].
    noise
        Standard deviation of one reading of friction, from second differences [-].
    zero
        Friction shown before the slip starts, an error of the force's zero, first guess [-];
        None if the record has no such part.
    zero_error
        Its standard error, for white noise [-].
    zero_unknown
        Standard deviation of a zero that the record does not show [-]; 0 where it shows one.
    first_friction
        Friction of the first readings [-].
    top
        Largest friction, but for a few readings [-].
    onset
        Travel where the friction has started to rise, a first guess of the lash [m].
    notes
        What was taken off or found, as sentences.
    faults
        What the record shows of its own recording.
    swing
        Its stick-slip, if there is any.
    other_strokes
        Strokes of the record that were not used.
    read_off
        What slip [m] and friction [-] of a point may be wrong by, of a curve read off a figure.
    """

    travel: Array
    friction: Array
    binned_travel: Array
    binned_friction: Array
    counts: Array
    place: Integers
    pressure: float
    bending: float
    noise: float
    zero: float | None
    zero_error: float
    zero_unknown: float
    first_friction: float
    top: float
    onset: float
    notes: tuple[str, ...]
    faults: tuple[Fault, ...] = ()
    swing: Swing | None = None
    other_strokes: int = 0
    read_off: tuple[float, float] = (0.0, 0.0)


def reduce_record(record: MachineRecord, sample: Sample) -> FrictionCurve:
    """Reduce a record to a friction curve.

    Parameters
    ----------
    record
        The test.
    sample
        Area, faces, and what is to be taken off.

    Raises
    ------
    InputError
        If the travel is constant or has no direction, fewer than 10 readings are left, the
        force is zero throughout, there is no normal force, or friction is beyond what the sample
        may have.
    """
    record, faults = without_repeats(record)
    found = find_strokes(record.travel, record.force)
    if not found:
        raise _refused(
            record,
            "the travel does not advance",
            "Check the travel column (--travel).",
        )
    used = {"first": found[:1], "last": found[-1:]}.get(sample.stroke, found)
    for stroke in used:
        _check(record, stroke.rows)
        faults += travel_faults(record, stroke.rows, stroke.direction)
    faults += unlike_strokes(record, found) if len(used) < len(found) else []
    travel, pull, normal = _pulled(record, sample, used)
    sign = 1.0 if np.median(pull[len(pull) // 5 :]) >= 0 else -1.0
    if sample.recorded:
        _refuse_saturated(record, travel, {"force": sign * pull, "normal force": normal})
    friction = sign * pull / (sample.faces * normal)
    onset, zero = _start(travel, friction)
    keep = despiked(friction)
    travel, friction, normal = (a[keep] for a in (travel, friction, normal))
    top = float(np.quantile(np.abs(friction), 0.98))
    _refuse_odd_friction(record, friction, sample.friction)
    swings = swing(travel, friction, top, said=bool(sample.stick_slip))
    if swings is None:
        faults += stall(travel, friction, top, onset)
    if swings is not None and sample.stick_slip in {"upper", "lower"}:
        ends = envelope(friction, swings.readings, sample.stick_slip)
        travel, friction = travel[ends], friction[ends]
    notes = _notes(record, found, used, sample.stroke, int((~keep).sum()))
    mean_normal = float(normal.mean())
    pressure = mean_normal / sample.area
    if zero and abs(zero[0]) > MOST_ZERO * top:
        zero = None
    bins = _binned(travel, friction, onset)
    return FrictionCurve(
        travel=travel,
        friction=friction,
        binned_travel=bins[0],
        binned_friction=bins[1],
        counts=bins[2],
        place=bins[3],
        pressure=pressure,
        bending=sample.shear_compliance * pressure + sample.compliance * sample.faces * mean_normal,
        noise=noise_level(friction),
        zero=zero[0] if zero else None,
        zero_error=zero[1] if zero else 0.0,
        zero_unknown=_zero_unknown(friction, friction[travel < 0.75 * onset], zero is None, top),
        first_friction=float(np.median(friction[: _first_readings(len(friction))])),
        top=top,
        onset=onset,
        notes=notes,
        faults=tuple(faults),
        swing=swings,
        other_strokes=len(found) - len(used),
    )


def _check(record: MachineRecord, rows: np.ndarray[tuple[int], np.dtype[np.int64]]) -> None:
    if len(rows) < LEAST_POINTS:
        raise _refused(
            record,
            f"only {len(rows)} usable readings, minimum {LEAST_POINTS}",
            "See wraparc read FILE, or record at a higher rate.",
        )
    if not np.any(record.force[rows]):
        raise _refused(
            record,
            "the force is zero throughout",
            "Check the force column (--force).",
        )
    advance, largest = (float(v) for v in (np.ptp(record.travel[rows]), np.abs(record.force).max()))
    if not _LEAST_TRAVEL < advance < _MOST_TRAVEL or largest > _MOST_FORCE:
        raise _refused(
            record,
            f"implausible travel {advance:.3g} m at force {largest:.3g} N"
            f"{meant_travel(advance, record.unit_of('travel'))}",
            "Check columns and units: wraparc read FILE.",
        )
    if len(np.unique(record.travel[rows])) < LEAST_POINTS:
        raise _refused(
            record,
            "the travel has fewer than 10 different values",
            "Check the travel column (--travel).",
        )


def _refuse_odd_friction(
    record: MachineRecord, friction: Array, allowed: tuple[float, float]
) -> None:
    """Refuse friction that no lagging has: a force was read in another unit, or another column."""
    top = float(np.quantile(friction, 0.98))
    if allowed[0] <= top <= allowed[1]:
        return
    fitting = [
        f"{top * factor:.3g} if {what}"
        for factor, what in sorted(_SLIPS, key=lambda of: abs(math.log(top * of[0] / _LIKELY)))
        if allowed[0] <= top * factor <= allowed[1]
    ]
    hint = f" ({fitting[0]})" if fitting else ""
    raise _refused(
        record,
        f"friction {top:.3g} is outside {allowed[0]:g} to {allowed[1]:g}{hint}",
        "Check units and pressure, or widen most_friction in [rig].",
    )


def _refuse_saturated(record: MachineRecord, travel: Array, forces: dict[str, Array]) -> None:
    """Refuse a force that its transducer did not follow to its top."""
    for name, values in forces.items():
        count = saturated(values, travel)
        if count:
            raise _refused(
                record,
                f"{count} of {len(values)} readings of the {name} are clipped at "
                f"{values.max():.5g} N",
                "Repeat the test with a larger range.",
            )


def _normal_force(record: MachineRecord, sample: Sample) -> Array:
    if record.normal_force is not None:
        measured = np.abs(record.normal_force)
        if float(np.median(measured)) <= 0.0 or not np.all(measured > 0.0):
            raise _refused(
                record,
                "the measured normal force is zero in places",
                "Name the right column, or give the normal force in the plan.",
            )
        return measured
    if sample.normal_force is None:
        raise _refused(
            record,
            "has no normal force",
            "Give pressure, normal_force or normal_force_column in the plan.",
        )
    return np.full(len(record.travel), sample.normal_force)


def _start(travel: Array, friction: Array) -> tuple[float, tuple[float, float] | None]:
    """Travel where friction starts to rise; friction before it with its error, if it is flat.

    Before the lash is taken up the record is flat: its level is an error of the force's zero.
    """
    top = float(np.quantile(friction, 0.98))
    base = float(np.median(friction[: _first_readings(len(friction))]))
    if abs(base) > 0.5 * abs(top):
        return 0.0, None
    spread = max(noise_level(friction), 1e-4 * abs(top))
    width = max(3, len(friction) // 500) if len(friction) >= _SPARSE else 1
    smooth = np.convolve(friction, np.ones(width) / width, mode="valid")
    above = smooth > base + max(0.03 * (top - base), 4.0 * spread / np.sqrt(width))
    # The start of a lasting rise, not a wiggle.
    lasts = min(5, max(2, len(friction) // 12))
    lasting = np.convolve(above, np.ones(lasts), mode="valid") > lasts - 0.5
    first = int(np.argmax(lasting)) if lasting.any() else 0
    onset = float(travel[min(first + width // 2, len(travel) - 1)])
    flat = friction[travel < 0.75 * onset]
    if len(flat) < 8 or onset < 0.004 * travel[-1]:
        return onset, None
    rise = np.polyfit(np.arange(len(flat)), flat, 1)[0] * len(flat)
    error = 1.25 * spread / np.sqrt(len(flat))
    if abs(rise) > max(0.01 * top, 6.0 * error):
        return onset, None
    return onset, (float(np.median(flat)), error)


def _first_readings(count: int) -> int:
    """Readings at the start that show what stands before the rise: fewer of a sparse record."""
    return max(1, min(5, count // 40), count // 200)


def _zero_unknown(friction: Array, before: Array, missing: bool, top: float) -> float:
    """Standard deviation of a zero that was not taken from the record [-].

    The readings before the slip starts bound it, even where they are too few to be taken off;
    what stands there and is too much for an error of the zero may be one, or friction.
    """
    if not missing:
        return 0.0
    if len(before) < _LEAST_BEFORE:
        return UNKNOWN_ZERO * top
    standing = abs(float(np.median(before)))
    if standing > MOST_ZERO * top:
        return 0.5 * standing
    error = 1.25 * noise_level(friction) / np.sqrt(len(before))
    return min(float(np.hypot(standing, error)), UNKNOWN_ZERO * top)


def _binned(travel: Array, friction: Array, onset: float) -> tuple[Array, Array, Array, Integers]:
    """Means over bins of equal travel, ten times narrower around the onset.

    Bins make a record that is dense in places (slow start, fast end) count by travel.
    """
    end = float(travel[-1])
    width = end / _BINS
    low, high = onset - 0.02 * end, onset + 0.08 * end
    coarse = np.linspace(0.0, end, _BINS + 1)
    fine = np.arange(max(0.0, low), min(high, end), width / _FINE)
    edges = np.concatenate([coarse[(coarse < low) | (coarse > high)], fine])
    edges = np.unique(np.append(edges, [0.0, end]))
    place = np.searchsorted(edges, travel, side="right") - 1
    _, place = np.unique(np.clip(place, 0, len(edges) - 2), return_inverse=True)
    counts = np.bincount(place).astype(float)
    means = [np.bincount(place, weights=values) / counts for values in (travel, friction)]
    return means[0], means[1], counts, place


def _pulled(
    record: MachineRecord, sample: Sample, strokes: list[Stroke]
) -> tuple[Array, Array, Array]:
    """Travel from the first reading of each pull, force and normal force, travel ascending."""
    all_normal = _normal_force(record, sample)
    parts = []
    for stroke in strokes:
        travel = (record.travel[stroke.rows] - record.travel[stroke.rows[0]]) * stroke.direction
        order = np.argsort(travel, kind="stable")
        rows = stroke.rows[order]
        parts.append((travel[order], record.force[rows], all_normal[rows]))
    if sample.stroke == "mean" and len(parts) > 1:
        end = min(float(travel[-1]) for travel, _, _ in parts)
        grid = parts[0][0][parts[0][0] <= end]
        means = [np.mean([np.interp(grid, p[0], p[k]) for p in parts], axis=0) for k in (1, 2)]
        return grid, means[0], means[1]
    travel, pull, normal = (np.concatenate(columns) for columns in zip(*parts, strict=True))
    order = np.argsort(travel, kind="stable")
    return travel[order], pull[order], normal[order]


def _notes(
    record: MachineRecord, found: list[Stroke], used: list[Stroke], which: str, spikes: int
) -> tuple[str, ...]:
    notes: list[str] = []
    if len(found) > 1:
        of = f"the {which} of {len(found)} strokes" if len(used) == 1 else f"{len(found)} strokes"
        how = {"mean": ", their mean at each travel,", "all": ", all readings,"}.get(which, "")
        notes.append(f"{of}{how} was used" if len(used) == 1 else f"{of}{how} were used")
    stroke = used[0]
    unloading = len(record.travel) - sum(len(s.rows) + s.released for s in used)
    if unloading:
        notes.append(f"{unloading} rows of the way back or of other strokes were left out")
    released = sum(s.released for s in used)
    if released:
        notes.append(f"{released} rows after the force collapsed were left out")
    if spikes:
        notes.append(f"{spikes} readings far off their neighbours were left out")
    if stroke.direction < 0:
        notes.append("the machine counts its travel downwards; the sign was turned")
    return tuple(notes)


def _refused(record: MachineRecord, message: str, remedy: str) -> InputError:
    line = int(record.lines[0]) if len(record.lines) else None
    return refused(record.file, message, remedy, line=line)
