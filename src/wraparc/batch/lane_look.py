"""Look up the law of every lane at a pressure."""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Table,
    anywhere,
    index,
    lanes,
    lower,
    select,
    upper,
)
from wraparc.batch.lane_law import (
    BUCKETS,
    CELL,
    FIRST_CELL,
    HEAD,
)
from wraparc.batch.lane_slots import (
    BUCKET,
    BUCKETS_PER_PASCAL,
    CELL_AT,
    FRICTION_AT,
    FRICTION_P,
    HIGH,
    INSIDE,
    LOW,
    PRESSURE,
    ROW,
    SLIP_AT,
    SLIP_P,
)


def read_head(w: Lanes, laws: Table) -> None:
    """The range of each lane's law."""
    n = lanes()
    for i in range(n):
        row = index(w[ROW, i])
        w[LOW, i], w[HIGH, i] = laws[row], laws[row + 1]
        w[BUCKETS_PER_PASCAL, i] = laws[row + 2]
        # no cell has been fetched
        w[CELL_AT, i], w[CELL_AT + 1, i] = w[HIGH, i], w[LOW, i]


def look_up(w: Lanes, laws: Table) -> None:
    """The law at PRESSURE: peak slip [m], peak friction [-], and p times their slopes.

    SLIP_AT, FRICTION_AT, FRICTION_P = p dmu_pk/dp, SLIP_P = p dx_pk/dp. Below the law's
    range friction is held, above it the traction; the slopes are those at the end of the range
    then.
    """
    n = lanes()
    for i in range(n):
        inside = lower(upper(w[PRESSURE, i], w[LOW, i]), w[HIGH, i])
        w[INSIDE, i] = inside
        part = (inside - w[LOW, i]) * w[BUCKETS_PER_PASCAL, i]
        w[BUCKET, i] = w[ROW, i] + HEAD + lower(part, BUCKETS - 0.5) - 0.5
    fetch(w, laws)
    for i in range(n):
        inside = w[INSIDE, i]
        t = inside - w[CELL_AT, i]
        x1, x2, x3 = w[CELL_AT + 3, i], w[CELL_AT + 4, i], w[CELL_AT + 5, i]
        m1, m2, m3 = w[CELL_AT + 7, i], w[CELL_AT + 8, i], w[CELL_AT + 9, i]
        slip = w[CELL_AT + 2, i] + t * (x1 + t * (x2 + t * x3))
        friction = w[CELL_AT + 6, i] + t * (m1 + t * (m2 + t * m3))
        held = w[HIGH, i] / upper(w[PRESSURE, i], w[HIGH, i])
        w[SLIP_AT, i], w[FRICTION_AT, i] = slip, friction * held
        w[SLIP_P, i] = inside * (x1 + t * (2.0 * x2 + 3.0 * t * x3))
        w[FRICTION_P, i] = inside * (m1 + t * (2.0 * m2 + 3.0 * t * m3))


def fetch(w: Lanes, laws: Table) -> None:
    """The cell of the law that INSIDE lies in, if it is not the one that is there.

    One lane after the other, where there is one to be fetched: gathering is slow.
    """
    n = lanes()
    missing = 0
    for i in range(n):
        inside = w[INSIDE, i]
        gone = (inside < w[CELL_AT, i]) | (inside > w[CELL_AT + 1, i])
        missing = missing + select(gone, 1, 0)
    if not anywhere(missing > 0):
        return
    for i in range(n):
        inside = w[INSIDE, i]
        if anywhere((inside < w[CELL_AT, i]) | (inside > w[CELL_AT + 1, i])):
            row = index(w[ROW, i])
            o = row + FIRST_CELL + CELL * index(laws[index(w[BUCKET, i])])
            o = o + select(inside > laws[o + 1], CELL, 0)
            for k in range(CELL):
                w[CELL_AT + k, i] = laws[o + k]
