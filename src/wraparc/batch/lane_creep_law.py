"""Friction at a creep and a tension: the slip that belongs to a creep, u = x + (h/G) mu(x, p) p.

Whatever the law is, creep grows smoothly along an arc, and its direction may turn.
"""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    Table,
    anywhere,
    full_ex,
    full_ln,
    index,
    lanes,
    lower,
    select,
    upper,
)
from wraparc.batch.lane_look import look_up, read_head
from wraparc.batch.lane_slots import (
    A_0,
    A_1,
    A_2,
    A_3,
    AT_T,
    AT_U,
    CELL_AT,
    FRICTION,
    FRICTION_AT,
    FRICTION_P,
    FRICTION_T,
    FRICTION_U,
    GONE,
    HELD,
    HIGH,
    INSIDE,
    LOW,
    MISSED,
    P1,
    PAST,
    PAST_HIGH,
    PAST_LOW,
    PRESSURE,
    REST,
    RISES_TO,
    ROW,
    SHEAR,
    SLIP,
    SLIP_AT,
    SLIP_P,
    SMALLEST,
    SOFT,
)
from wraparc.batch.lane_tables import FIRST_CUBIC, GROWTH_CUBIC, TABLE_CELL, TABLE_HEAD

# the fetched cell: slip and pressure where it begins and ends, two cubics
X_LOW, X_HIGH, P_LOW, P_HIGH = range(CELL_AT, CELL_AT + 4)
FIRST, GROWTH = CELL_AT + FIRST_CUBIC, CELL_AT + GROWTH_CUBIC
MORE_STEPS = 20  # to a slip, where three from that of the last stage do not do
NEAR, LEAST = 1e-10, 1e-12  # miss of a slip over its creep and this [m]
NO_WIDTH = 1e6  # a cell wider than this is the last one, of constant friction [m]

#: halvings of a table's cells, or None for integral-log laws: their code alone is compiled then
Cells = int | None


def read_law(w: Lanes, laws: Table, cells: Cells) -> None:
    """Make ready to look up laws in their rows."""
    if cells is None:
        read_head(w, laws)
        return
    n = lanes()
    for i in range(n):
        row = index(w[ROW, i])
        w[LOW, i], w[HIGH, i] = laws[row + 2], laws[row + 3]
        zero = 0.0 * w[P1, i]
        w[X_LOW, i], w[X_HIGH, i] = zero, zero - 1.0  # no cell has been fetched
        for k in range(CELL_AT + 2, CELL_AT + TABLE_CELL):
            w[k, i] = zero
        w[SLIP, i], w[RISES_TO, i] = zero, laws[row + 4]


def friction_of_creep(w: Lanes, laws: Table, cells: Cells) -> None:
    """FRICTION, FRICTION_U and FRICTION_T at AT_U and AT_T, and the magnitude of SLIP."""
    n = lanes()
    for i in range(n):
        p = w[P1, i] * w[AT_T, i]
        w[PRESSURE, i], w[SOFT, i] = p, w[SHEAR, i] * p
    if cells is None:
        look_up(w, laws)
        slip_of_form(w)
    else:
        fetch_cell(w, laws, cells)
        slip_of_cell(w)


def fetch_cell(w: Lanes, laws: Table, halvings: int) -> None:
    """The cell of the table that creep and pressure lie in, if it is not the one that is there."""
    n = lanes()
    missing = 0
    for i in range(n):
        p = w[PRESSURE, i]
        inside = lower(upper(p, w[LOW, i]), w[HIGH, i])
        held = w[HIGH, i] / upper(p, w[HIGH, i])
        size = upper(w[AT_U, i], -w[AT_U, i])
        w[INSIDE, i], w[HELD, i] = inside, held
        d, t, carry = inside - w[P_LOW, i], w[X_HIGH, i] - w[X_LOW, i], held * w[SOFT, i]
        first = w[X_LOW, i] + carry * (w[FIRST, i] + d * w[GROWTH, i])
        a1 = w[FIRST + 1, i] + d * w[GROWTH + 1, i]
        a2 = w[FIRST + 2, i] + d * w[GROWTH + 2, i]
        a3 = w[FIRST + 3, i] + d * w[GROWTH + 3, i]
        last = w[X_HIGH, i] + carry * (
            w[FIRST, i] + d * w[GROWTH, i] + t * (a1 + t * (a2 + t * a3))
        )
        gone = (size < first) | (size > last) | (d < 0.0) | (inside > w[P_HIGH, i])
        w[GONE, i] = select(gone, 1.0, 0.0)
        missing = missing + select(gone, 1, 0)
    if not anywhere(missing > 0):
        return
    for i in range(n):
        if anywhere(w[GONE, i] > 0.5):
            size = upper(w[AT_U, i], -w[AT_U, i])
            cell = cell_of(laws, w[ROW, i], w[INSIDE, i], size, w[HELD, i] * w[SOFT, i], halvings)
            for k in range(TABLE_CELL):
                w[CELL_AT + k, i] = laws[cell + k]


def cell_of(
    laws: Table, row: Number, inside: Number, creep: Number, carry: Number, halvings: int
) -> Number:
    """Where the cell of a pressure and a creep stands, whose u = x + carry mu."""
    head = index(row)
    many = index(laws[head])
    first = head + TABLE_HEAD
    low, high = 0 * many, index(laws[head + 1])
    for _ in range(halvings):
        middle = index(0.5 * (low + high) - 0.25)
        beyond = inside >= laws[first + TABLE_CELL * many * middle + 2]
        low, high = select(beyond, middle, low), select(beyond, high, middle)
    first = first + TABLE_CELL * many * low
    d = inside - laws[first + 2]
    low, high = 0 * many, many
    for _ in range(halvings):
        middle = index(0.5 * (low + high) - 0.25)
        o = first + TABLE_CELL * middle
        begins = laws[o] + carry * (laws[o + FIRST_CUBIC] + d * laws[o + GROWTH_CUBIC])
        beyond = creep >= begins
        low, high = select(beyond, middle, low), select(beyond, high, middle)
    return first + TABLE_CELL * low


def slip_of_cell(w: Lanes) -> None:
    """Slip in the fetched cell of a table, by Newton's method from the last one.

    A few steps do for most; the lanes that need more are taken on within a bracket.
    """
    n = lanes()
    missing = 0
    for i in range(n):
        held, c = w[HELD, i], w[SOFT, i]
        d = w[INSIDE, i] - w[P_LOW, i]
        a0 = held * (w[FIRST, i] + d * w[GROWTH, i])
        a1 = held * (w[FIRST + 1, i] + d * w[GROWTH + 1, i])
        a2 = held * (w[FIRST + 2, i] + d * w[GROWTH + 2, i])
        a3 = held * (w[FIRST + 3, i] + d * w[GROWTH + 3, i])
        size = upper(w[AT_U, i], -w[AT_U, i])
        most = w[X_HIGH, i] - w[X_LOW, i]
        rest = size - w[X_LOW, i] - c * a0
        t = w[SLIP, i] - w[X_LOW, i]
        chord = rest * most / (most + c * most * (a1 + most * (a2 + most * a3)))
        chord = select(most > NO_WIDTH, upper(rest, 0.0), chord)
        t = select((t > 0.0) & (t < most), t, lower(upper(chord, 0.0), most))
        # written out: a loop in here keeps lanes from going side by side
        t = nearer(t, c, a1, a2, a3, rest, most)
        t = nearer(t, c, a1, a2, a3, rest, most)
        t = nearer(t, c, a1, a2, a3, rest, most)
        w[A_0, i], w[A_1, i], w[A_2, i], w[A_3, i] = a0, a1, a2, a3
        w[PAST, i], w[PAST_LOW, i], w[PAST_HIGH, i] = t, 0.0 * t, most
        w[REST, i] = rest
        miss = (t + c * t * (a1 + t * (a2 + t * a3))) - rest
        far = upper(miss, -miss) > NEAR * (size + LEAST)
        missing = missing + select(far, 1, 0)
    if anywhere(missing > 0):
        for _ in range(MORE_STEPS):
            closer(w)
    for i in range(n):
        held, c, p, t = w[HELD, i], w[SOFT, i], w[PRESSURE, i], w[PAST, i]
        a0, a1, a2, a3 = w[A_0, i], w[A_1, i], w[A_2, i], w[A_3, i]
        size = upper(w[AT_U, i], -w[AT_U, i])
        miss = (t + c * t * (a1 + t * (a2 + t * a3))) - w[REST, i]
        w[MISSED, i] = upper(w[MISSED, i], upper(miss, -miss) / (size + LEAST))
        w[SLIP, i] = w[X_LOW, i] + t
        mu = a0 + t * (a1 + t * (a2 + t * a3))
        mu_x = a1 + t * (2.0 * a2 + 3.0 * t * a3)
        b1, b2, b3 = w[GROWTH + 1, i], w[GROWTH + 2, i], w[GROWTH + 3, i]
        grown = held * (w[GROWTH, i] + t * (b1 + t * (b2 + t * b3)))
        # below the range friction is held, above it the traction
        mu_p = select(p < w[LOW, i], 0.0, select(p > w[HIGH, i], -mu / p, grown))
        tell(w, i, mu, mu_x, mu_p)


def nearer(
    t: Number, c: Number, a1: Number, a2: Number, a3: Number, rest: Number, most: Number
) -> Number:
    """One step of Newton's method to t + c (a1 t + a2 t^2 + a3 t^3) = rest, between 0 and most."""
    miss = t + c * t * (a1 + t * (a2 + t * a3)) - rest
    slope = 1.0 + c * (a1 + t * (2.0 * a2 + 3.0 * t * a3))
    return lower(upper(t - miss / slope, 0.0), most)


def closer(w: Lanes) -> None:
    """One more step to the slips that are not near yet, halving where Newton's method strays."""
    n = lanes()
    for i in range(n):
        c, t, low, high = w[SOFT, i], w[PAST, i], w[PAST_LOW, i], w[PAST_HIGH, i]
        a1, a2, a3 = w[A_1, i], w[A_2, i], w[A_3, i]
        size = upper(w[AT_U, i], -w[AT_U, i])
        miss = (t + c * t * (a1 + t * (a2 + t * a3))) - w[REST, i]
        slope = 1.0 + c * (a1 + t * (2.0 * a2 + 3.0 * t * a3))
        far = upper(miss, -miss) > NEAR * (size + LEAST)
        low, high = select(miss > 0.0, low, t), select(miss > 0.0, t, high)
        new = t - miss / slope
        new = select((new > low) & (new < high), new, 0.5 * (low + high))
        w[PAST, i], w[PAST_LOW, i], w[PAST_HIGH, i] = select(far, new, t), low, high


def slip_of_form(w: Lanes) -> None:
    """Slip of an integral-log law, flat past its peak, from what has been looked up."""
    n = lanes()
    for i in range(n):
        slip, friction, p = w[SLIP_AT, i], w[FRICTION_AT, i], w[PRESSURE, i]
        bend = w[SOFT, i] * friction / slip
        ratio = upper(w[AT_U, i], -w[AT_U, i]) / slip
        # r (1 + bend (1 - ln r)) = ratio, by one step of Halley's method in y = ln r
        goal = full_ln(upper(ratio, SMALLEST))
        y = goal - full_ln(1.0 + bend * (1.0 - lower(goal, 0.0)))
        stiff = 1.0 + bend * (1.0 - y)
        part, miss = bend / stiff, y + full_ln(stiff) - goal
        slope = 1.0 - part
        y = lower(y - miss * slope / (slope * slope + 0.5 * miss * part * part), 0.0)
        miss = full_ex(y) * (1.0 + bend * (1.0 - y)) / upper(ratio, SMALLEST) - 1.0
        past = ratio >= 1.0 + bend
        miss = select(past, 0.0, select(ratio > SMALLEST, upper(miss, -miss), 0.0))
        w[MISSED, i] = upper(w[MISSED, i], miss)
        r = select(past, ratio - bend, full_ex(y))
        y = select(past, 0.0, y)
        form = lower(r, 1.0) * (1.0 - y)
        within = select(p < w[LOW, i], 0.0, select(p > w[HIGH, i], 0.0, 1.0))
        above = select(p > w[HIGH, i], 1.0, 0.0)
        by_p = within * w[FRICTION_P, i] * form - above * friction * form
        by_p = by_p + within * friction * y * lower(r, 1.0) * w[SLIP_P, i] / slip
        w[SLIP, i], w[RISES_TO, i] = slip * r, slip
        tell(w, i, friction * form, -friction * y / slip, by_p / p)


def tell(w: Lanes, i: int, mu: Number, mu_x: Number, mu_p: Number) -> None:
    """Write friction and its derivatives, of those by slip and by pressure."""
    c = w[SHEAR, i]
    sign = select(w[AT_U, i] < 0.0, -1.0, 1.0)
    stiff = 1.0 + w[SOFT, i] * mu_x
    w[FRICTION, i] = sign * mu
    w[FRICTION_U, i] = mu_x / stiff
    w[FRICTION_T, i] = sign * w[P1, i] * (mu_p - mu_x * c * mu) / stiff
