"""What a recorded march with creep as the state says of each arc."""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    Table,
    full_ex,
    lanes,
    lower,
    select,
    upper,
)
from wraparc.batch.lane_creep import NOTED
from wraparc.batch.lane_creep_law import Cells, friction_of_creep
from wraparc.batch.lane_read import ACTIVE_SHARE, cubic, step_of
from wraparc.batch.lane_slots import (
    ACTIVE,
    AT_NODE,
    AT_T,
    AT_U,
    CHANGE,
    CHANGE_FIRST,
    CREST_1,
    CREST_2,
    CREST_HIGH,
    CREST_LOW,
    END,
    ENTRY_STRESS,
    EXIT_CREEP,
    EXIT_STRESS,
    EXIT_X,
    FRICTION,
    HIGH,
    KICK,
    LARGEST,
    LENGTH,
    LOW,
    MISS,
    OUTSIDE,
    P1,
    PEAK_AT,
    PEAK_NODE,
    PEAK_STRESS,
    PRESSURE,
    SLIP,
    SLIP_MAX,
    SMALLEST,
    STRESS_1,
    STRESS_2,
    U_COARSE,
    U_COARSEST,
    U_Z,
    Z_STEP,
    U,
    Z,
)

GOLDEN = 0.6180339887498949
CLOSER = 14  # steps of golden section: to 1/400 of a step of the mesh
HALVINGS = 14  # of a step of the mesh


def read(w: Lanes, laws: Table, cells: Cells, trace: Lanes, steps: int) -> None:
    """What the last march says, its exit brought to T2 by the derivatives.

    MISS is the last change of the creep at the exit, CHANGE that by the mesh of all steps, both
    over the larger of the creeps there and at the entry.
    """
    n = lanes()
    for i in range(n):
        by = lower(upper(w[Z_STEP, i], -1.0), 1.0)
        change = w[U_Z, i] * by
        w[AT_T, i], w[AT_U, i] = full_ex(-w[END, i]), w[U, i] + change
        size = upper(upper(w[AT_U, i], -w[AT_U, i]), w[KICK, i]) + SMALLEST
        mesh = w[AT_U, i] - w[U_COARSE, i]
        w[MISS, i] = select(by * by < 1.0, upper(change, -change) / size, 1.0)
        w[CHANGE, i] = upper(mesh, -mesh) / size
        mesh = w[AT_U, i] - w[U_COARSEST, i]
        w[CHANGE_FIRST, i] = upper(mesh, -mesh) / size
    friction_of_creep(w, laws, cells)
    for i in range(n):
        sign, stress = select(w[AT_U, i] < 0.0, -1.0, 1.0), w[FRICTION, i] * w[PRESSURE, i]
        w[EXIT_CREEP, i], w[EXIT_X, i], w[EXIT_STRESS, i] = w[AT_U, i], sign * w[SLIP, i], stress
        w[LARGEST, i] = upper(w[LARGEST, i], w[SLIP, i])
        trace[NOTED * steps, i], trace[NOTED * steps + 2, i] = w[AT_T, i], w[AT_U, i]
        w[AT_NODE, i] = 0.0 * w[Z, i]
    stress_at_node(w, laws, cells, trace, steps)
    for i in range(n):
        w[ENTRY_STRESS, i] = w[FRICTION, i] * w[PRESSURE, i]
    find_crest(w, laws, cells, trace, steps)
    find_active(w, trace, steps)
    find_outside(w, trace, steps)


def stress_at_node(w: Lanes, laws: Table, cells: Cells, trace: Lanes, steps: int) -> None:
    """The state at AT_NODE and its friction: tension and creep are smooth whatever the law is."""
    n = lanes()
    for i in range(n):
        j = step_of(w[AT_NODE, i], steps)
        o, f = NOTED * j, w[AT_NODE, i] - j
        w[AT_T, i] = between(trace, o, i, f)
        w[AT_U, i] = between(trace, o + 2, i, f)
    friction_of_creep(w, laws, cells)


def between(trace: Lanes, o: Number, i: int, f: Number) -> Number:
    """A number that is recorded with its change by step, at the fraction f of the step."""
    return cubic(f, trace[o, i], trace[o + NOTED, i], trace[o + 1, i], trace[o + NOTED + 1, i])


def find_crest(w: Lanes, laws: Table, cells: Cells, trace: Lanes, steps: int) -> None:
    """Largest shear stress and where: beside the node where it is largest, by golden section."""
    n = lanes()
    for i in range(n):
        last = upper(w[EXIT_STRESS, i], -w[EXIT_STRESS, i])
        at = select(last >= w[PEAK_STRESS, i], 1.0 * steps, lower(w[PEAK_NODE, i], steps - 1.0))
        w[PEAK_NODE, i], w[PEAK_STRESS, i] = at, upper(last, w[PEAK_STRESS, i])
        low, high = upper(at - 1.0, 0.0), lower(at + 1.0, 1.0 * steps)
        w[CREST_LOW, i], w[CREST_HIGH, i] = low, high
        w[CREST_1, i], w[STRESS_1, i] = high - GOLDEN * (high - low), 0.0 * at
        w[AT_NODE, i] = w[CREST_2, i] = low + GOLDEN * (high - low)
    for k in range(CLOSER):
        stress_at_node(w, laws, cells, trace, steps)
        for i in range(n):
            stress = w[FRICTION, i] * w[PRESSURE, i]
            stress = upper(stress, -stress)
            better = stress > w[PEAK_STRESS, i]
            w[PEAK_NODE, i] = select(better, w[AT_NODE, i], w[PEAK_NODE, i])
            w[PEAK_STRESS, i] = select(better, stress, w[PEAK_STRESS, i])
            second = w[AT_NODE, i] == w[CREST_2, i]
            w[STRESS_1, i] = select(second, w[STRESS_1, i], stress)
            w[STRESS_2, i] = select(second, stress, w[STRESS_2, i])
            if k == 0:
                w[AT_NODE, i] = w[CREST_1, i]
            else:
                left = w[STRESS_1, i] >= w[STRESS_2, i]
                low = select(left, w[CREST_LOW, i], w[CREST_1, i])
                high = select(left, w[CREST_2, i], w[CREST_HIGH, i])
                first, next_one = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
                kept = select(left, w[CREST_1, i], w[CREST_2, i])
                kept_stress = select(left, w[STRESS_1, i], w[STRESS_2, i])
                w[CREST_LOW, i], w[CREST_HIGH, i] = low, high
                w[CREST_1, i] = select(left, first, kept)
                w[CREST_2, i] = select(left, kept, next_one)
                w[STRESS_1, i] = w[STRESS_2, i] = kept_stress
                w[AT_NODE, i] = select(left, w[CREST_1, i], w[CREST_2, i])
    for i in range(n):
        w[PEAK_AT, i] = w[PEAK_NODE, i] * w[LENGTH, i] / steps


def find_active(w: Lanes, trace: Lanes, steps: int) -> None:
    """Length of the exit part in which all but a hundredth of the tension change takes place."""
    n = lanes()
    for i in range(n):
        w[ACTIVE, i] = 0.0 * w[Z, i]
    for j in range(steps):
        at = float(j)
        for i in range(n):
            change = 1.0 - full_ex(-w[END, i])
            taken = (1.0 - trace[NOTED * j, i]) * select(change > 0.0, 1.0, -1.0)
            before = taken <= ACTIVE_SHARE * upper(change, -change)
            w[ACTIVE, i] = select(before, at, w[ACTIVE, i])
    for i in range(n):
        at = step_of(w[ACTIVE, i] + 0.5, steps)
        change = 1.0 - full_ex(-w[END, i])
        sign, low, high = select(change > 0.0, 1.0, -1.0), 0.0 * change, 0.0 * change + 1.0
        for _ in range(HALVINGS):
            f = 0.5 * (low + high)
            taken = (1.0 - between(trace, NOTED * at, i, f)) * sign
            before = taken <= ACTIVE_SHARE * upper(change, -change)
            low, high = select(before, f, low), select(before, high, f)
        length = w[LENGTH, i] * (1.0 - (at + low) / steps)
        w[ACTIVE, i] = select(change == 0.0, 0.0, length)


def find_outside(w: Lanes, trace: Lanes, steps: int) -> None:
    """Share of the arc outside the tested range, slip and pressure straight in a step."""
    n = lanes()
    for i in range(n):
        w[OUTSIDE, i] = 0.0 * w[Z, i]
    for j in range(steps):
        o = NOTED * j
        for i in range(n):
            low, high, limit = 0.0 * w[Z, i], 0.0 * w[Z, i] + 1.0, w[SLIP_MAX, i]
            p0, p1 = w[P1, i] * trace[o, i], w[P1, i] * trace[o + NOTED, i]
            low, high = cut(low, high, w[LOW, i] - p0, w[LOW, i] - p1)
            low, high = cut(low, high, p0 - w[HIGH, i], p1 - w[HIGH, i])
            low, high = cut(low, high, trace[o + 4, i] - limit, trace[o + NOTED + 4, i] - limit)
            w[OUTSIDE, i] = w[OUTSIDE, i] + (1.0 - upper(high - low, 0.0)) / steps


def cut(low: Number, high: Number, f0: Number, f1: Number) -> tuple[Number, Number]:
    """What is left between low and high of a step of where f, straight, is not positive."""
    at = f0 / select(f0 == f1, 1.0, f0 - f1)
    low = select(f0 > 0.0, select(f1 > 0.0, 2.0, upper(low, at)), low)
    return low, select(f0 > 0.0, high, select(f1 > 0.0, lower(high, at), high))
