"""The kernel's march in tension with its steps cut where the law has a kink, in the lanes.

As :mod:`wraparc.arc.kernel.tension_march` has it, past the peak of friction too: a step that leaves
a branch of the law is cut there, and the last one at the exit nip. Lanes come to their kinks at
different steps, so each is on a step of its own: a turn takes every lane one step further, or one
try nearer to where its step is to be cut.
"""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    Table,
    anywhere,
    full_ln,
    lanes,
    select,
    upper,
)
from wraparc.batch.lane_law import FRICTION_CUBIC, RESIDUAL_CUBIC, SLOPE_CUBIC
from wraparc.batch.lane_look import read_head
from wraparc.batch.lane_sixth import MOST_SIXTH, PLACE, SIXTH_STEP, find_piece, lay_place, set_step
from wraparc.batch.lane_slots import (
    ABOVE,
    AT,
    BELOW,
    BRANCH,
    CELL_AT,
    CUT_END,
    CUTTING,
    END,
    END_AT,
    ETA,
    ETA_END,
    FINISHED,
    FRESH,
    GRADED,
    GRADED_STEP,
    HIGH,
    HIGH_GAP,
    HIGH_PART,
    KICK,
    LEAST_SLIP,
    LENGTH,
    LOW,
    LOW_GAP,
    LOW_PART,
    MESH_END,
    NEXT_BRANCH,
    PART,
    Q_AT,
    RADIUS,
    RATE_1,
    RATE_2,
    RATE_3,
    RATE_4,
    RATE_5,
    RATE_6,
    RATE_S,
    SHEAR,
    SIDE,
    SMALLEST,
    STEP_BY,
    STEP_FROM,
    STEP_TO,
    STOP,
    SUM_S,
    SUM_X,
    TRACTION,
    WEIGHED_BY,
    G,
    S,
    X,
)

TURNS = 600  # steps and tries of a march
LANDED = 1e-12  # relative, of a cut
FARTHEST_X, FARTHEST_S = 1e3, 1e6  # slip and arc of a step that leads nowhere [m]
FIRST_PLACE = SIXTH_STEP * MOST_SIXTH + 1  # where the places of the step at hand stand
TAIL = 4  # numbers of a place past the peak, see `lay_tail`
TAILS = SIXTH_STEP * (MOST_SIXTH + 1)
CUT_NODES = TAILS + 5 * TAIL


def march_cut(w: Lanes, laws: Table, nodes: Lanes) -> None:
    """March from S and X at the entry (without a kick, at the first node) to the exit nip.

    S, X and END_AT there, TRACTION, and FINISHED.
    """
    begin(w, laws)
    for _ in range(TURNS):
        find_piece(w, laws)
        lay_step(w, nodes)
        take_step(w, nodes)
        if decide(w, nodes):
            break


def begin(w: Lanes, laws: Table) -> None:
    """Before the first step."""
    read_head(w, laws)
    n = lanes()
    for i in range(n):
        zero = 0.0 * w[X, i]
        w[Q_AT, i] = w[ETA, i] = w[ETA_END, i] = w[MESH_END, i] = w[GRADED_STEP, i] = zero
        w[BRANCH, i] = w[CUTTING, i] = w[FINISHED, i] = w[PART, i] = zero
        w[FRESH, i] = zero + 1.0
        w[STOP, i] = w[END, i]
        w[LEAST_SLIP, i] = select(w[KICK, i] > 0.0, 0.5 * w[X, i], 0.0)


def lay_step(w: Lanes, nodes: Lanes) -> None:
    """Lay the step of every lane: one of the mesh, what is left of one, or a part that is tried."""
    n = lanes()
    set_step(w, nodes, MOST_SIXTH)
    for i in range(n):
        fresh = w[FRESH, i] > 0.5
        w[MESH_END, i] = end = select(fresh, w[STEP_TO, i], w[MESH_END, i])
        w[ETA_END, i] = select(fresh, w[ETA, i], w[ETA_END, i])
        w[ETA, i] = w[ETA_END, i]
        tries = w[CUTTING, i] > 0.5
        whole = select(tries, w[CUT_END, i], end) - w[Q_AT, i]
        by = select(tries, w[PART, i], 1.0) * whole
        plain = tries | (w[FRESH, i] < 0.5)
        w[GRADED, i] = select(plain, 0.0, w[GRADED, i])
        w[STEP_FROM, i] = select(plain, w[Q_AT, i], w[STEP_FROM, i])
        w[STEP_BY, i] = by = select(plain, by, w[STEP_BY, i])
        # without a kick the first step is closed analytically
        closed = (w[KICK, i] <= 0.0) & (w[Q_AT, i] <= 0.0)
        w[WEIGHED_BY, i] = select(closed, 0.0, by)
    for place in range(5):
        lay_place(w, nodes, MOST_SIXTH, place)
        lay_tail(w, nodes, place)


def lay_tail(w: Lanes, nodes: Lanes, place: int) -> None:
    """Numbers of one place past the peak.

    z = m x_pk/mu_pk and the residual friction over that of the peak; and what their slopes by
    pressure add to the rate of slip, as `tension_table` has them.
    """
    n = lanes()
    o, k = FIRST_PLACE + PLACE * place, TAILS + TAIL * place
    a, b, c = CELL_AT + SLOPE_CUBIC, CELL_AT + RESIDUAL_CUBIC, CELL_AT + FRICTION_CUBIC
    for i in range(n):
        p, slip = nodes[o + 6, i] * nodes[o + 1, i] / w[RADIUS, i], 1.0 / nodes[o, i]
        above, below = w[ABOVE, i] > 0.5, w[BELOW, i] > 0.5
        t = select(above, w[HIGH, i], select(below, w[LOW, i], p)) - w[CELL_AT, i]
        s1, s2, s3 = w[a + 1, i], w[a + 2, i], w[a + 3, i]
        r1, r2, r3 = w[b + 1, i], w[b + 2, i], w[b + 3, i]
        m1, m2, m3 = w[c + 1, i], w[c + 2, i], w[c + 3, i]
        slope = w[a, i] + t * (s1 + t * (s2 + t * s3))
        residual = w[b, i] + t * (r1 + t * (r2 + t * r3))
        peak = w[c, i] + t * (m1 + t * (m2 + t * m3))
        varies = select(above | below, 0.0, 1.0)
        slope_p = varies * (s1 + t * (2.0 * s2 + 3.0 * t * s3))
        residual_p = varies * (r1 + t * (2.0 * r2 + 3.0 * t * r3))
        peak_p = varies * (m1 + t * (2.0 * m2 + 3.0 * t * m3)) / peak
        falls = (slope < 0.0) & (residual < peak)
        held = select(above, w[HIGH, i] / p, 1.0)
        part = w[SIDE, i] * w[SHEAR, i] * p * p * held
        nodes[k, i] = select(falls, slope * slip / peak, 0.0)
        nodes[k + 1, i] = select(falls, residual / peak, 1.0)
        nodes[k + 2, i] = select(falls, part * slip * (slope_p - slope * peak_p), 0.0)
        nodes[k + 3, i] = select(falls, part * (residual_p - residual * peak_p), 0.0)


def rates_at(w: Lanes, nodes: Lanes, place: int, i: int) -> tuple[Number, Number]:
    """Rates of arc and slip by a step at a place, in the branch of a lane, with the slip AT."""
    o, k = FIRST_PLACE + PLACE * place, TAILS + TAIL * place
    z, rho, turn, steep = nodes[k, i], nodes[k + 1, i], nodes[o + 4, i], nodes[o + 5, i]
    r = w[AT, i] * nodes[o, i]
    log_r = full_ln(upper(r, SMALLEST))
    fall = r * log_r
    rises = (w[BRANCH, i] < 0.5) & ((r < 1.0) | (z < 0.0))
    ends = w[BRANCH, i] > 1.5
    form = select(rises, r - fall, select(ends, rho, 1.0 + z * (r - 1.0)))
    line = nodes[k + 2, i] * (r - 1.0) - turn * z
    more = select(rises, turn * fall, select(ends, nodes[k + 3, i], line))
    stiff = 1.0 + steep * select(rises, -log_r, select(ends, 0.0, z))
    resistance, weight = nodes[o + 1, i] / form, nodes[o + 7, i]
    dx = (w[G, i] + nodes[o + 2, i]) * resistance + nodes[o + 3, i] * form + more
    return weight * resistance, weight * dx / stiff


def take_step(w: Lanes, nodes: Lanes) -> None:
    """One step (:mod:`wraparc.arc.kernel.butcher`): AT is the slip it ends with, SUM_S its arc."""
    n = lanes()
    for i in range(n):
        beyond = w[X, i] * nodes[FIRST_PLACE, i] > 1.0 + 1e-9
        begins = (w[BRANCH, i] < 0.5) & (nodes[TAILS + 4 * TAIL, i] < 0.0) & beyond
        w[BRANCH, i] = select(begins, 1.0, w[BRANCH, i])
        w[AT, i] = w[X, i]
    for i in range(n):
        ds, dx = rates_at(w, nodes, 0, i)
        w[RATE_1, i], w[SUM_S, i], w[SUM_X, i] = dx, 11.0 * ds, 11.0 * dx
        w[AT, i] = w[X, i] + dx / 3.0
    for i in range(n):
        _, dx = rates_at(w, nodes, 1, i)
        w[RATE_2, i], w[AT, i] = dx, w[X, i] + dx * (2.0 / 3.0)
    for i in range(n):
        ds, dx = rates_at(w, nodes, 3, i)
        w[RATE_3, i] = dx
        w[SUM_S, i], w[SUM_X, i] = w[SUM_S, i] + 81.0 * ds, w[SUM_X, i] + 81.0 * dx
        w[AT, i] = w[X, i] + (w[RATE_1, i] + 4.0 * w[RATE_2, i] - dx) / 12.0
    for i in range(n):
        ds, dx = rates_at(w, nodes, 1, i)
        w[RATE_4, i] = dx
        w[SUM_S, i], w[SUM_X, i] = w[SUM_S, i] + 81.0 * ds, w[SUM_X, i] + 81.0 * dx
        due = 18.0 * w[RATE_2, i] - w[RATE_1, i] - 3.0 * w[RATE_3, i] - 6.0 * dx
        w[AT, i] = w[X, i] + due / 16.0
    for i in range(n):
        ds, dx = rates_at(w, nodes, 2, i)
        w[RATE_5, i] = dx
        w[SUM_S, i], w[SUM_X, i] = w[SUM_S, i] - 32.0 * ds, w[SUM_X, i] - 32.0 * dx
        due = 9.0 * w[RATE_2, i] - 3.0 * w[RATE_3, i] - 6.0 * w[RATE_4, i] + 4.0 * dx
        w[AT, i] = w[X, i] + due / 8.0
    for i in range(n):
        ds, dx = rates_at(w, nodes, 2, i)
        w[RATE_6, i] = dx
        w[SUM_S, i], w[SUM_X, i] = w[SUM_S, i] - 32.0 * ds, w[SUM_X, i] - 32.0 * dx
        due = 9.0 * w[RATE_1, i] - 36.0 * w[RATE_2, i] + 63.0 * w[RATE_3, i]
        w[AT, i] = w[X, i] + (due + 72.0 * w[RATE_4, i] - 64.0 * dx) / 44.0
    for i in range(n):
        ds, dx = rates_at(w, nodes, 4, i)
        w[RATE_S, i] = ds
        w[SUM_S, i] = (w[SUM_S, i] + 11.0 * ds) / 120.0
        w[AT, i] = w[X, i] + (w[SUM_X, i] + 11.0 * dx) / 120.0


def next_branch(branch: Number, r: Number, z: Number, rho: Number) -> Number:
    """Branch of a state with x/x_pk = r, among the neighbours of the branch it comes from."""
    over = 1.0 + z * (r - 1.0) >= rho
    rise = select(r > 1.0, 1.0, 0.0)
    flat = select(r >= 1.0, branch, 0.0)
    line = select(r < 1.0, 0.0, select(over, 1.0, 2.0))
    rest = select(over & (rho < 1.0), 1.0, 2.0)
    past = select(branch > 1.5, rest, line)
    return select(branch < 0.5, rise, select(z == 0.0, flat, past))


def gap_to(branch: Number, to: Number, r: Number, z: Number, rho: Number) -> Number:
    """How far a state is beyond the boundary to another branch; negative before."""
    below = rho - 1.0 - z * (r - 1.0)
    past = select(to < 0.5, 1.0 - r, select(to > 1.5, below, -below))
    return select(branch < 0.5, r - 1.0, past)


def other(condition: Number) -> Number:
    """Whether a condition does not hold."""
    return select(condition, 0.0, 1.0) > 0.5


def decide(w: Lanes, nodes: Lanes) -> bool:
    """What becomes of the step of every lane: taken, to be cut, nearer to its cut; whether all end.

    A cut at a branch is found by false position (Illinois), one at the exit by Newton's method,
    both to rounding: it does not matter how.
    """
    n = lanes()
    left = 0
    first, last = FIRST_PLACE, FIRST_PLACE + 4 * PLACE
    for i in range(n):
        runs, cutting, branch = w[FINISHED, i] < 0.5, w[CUTTING, i], w[BRANCH, i]
        x, x1, length = w[X, i], w[AT, i], w[LENGTH, i]
        s, s1, q = w[S, i], w[S, i] + w[SUM_S, i], w[Q_AT, i]
        z0, rho0 = nodes[TAILS, i], nodes[TAILS + 1, i]
        z1, rho1 = nodes[TAILS + 4 * TAIL, i], nodes[TAILS + 4 * TAIL + 1, i]
        r1 = x1 * nodes[last, i]
        closed, opens = (w[KICK, i] <= 0.0) & (q <= 0.0), (w[KICK, i] > 0.0) | (q > 0.0)
        sound = (x1 > w[LEAST_SLIP, i]) & (s1 > s) & (x1 < FARTHEST_X) & (s1 < FARTHEST_S)
        # a whole step
        plain = runs & (cutting < 0.5)
        lost = plain & opens & other(sound)
        to = select(plain, next_branch(branch, r1, z1, rho1), w[NEXT_BRANCH, i])
        to = select(closed, branch, to)
        kink = plain & (to != branch)
        gap_0 = gap_to(branch, to, x * nodes[first, i], z0, rho0)
        gap_1 = gap_to(branch, to, r1, z1, rho1)
        here = kink & (gap_0 >= 0.0)  # on the boundary already
        passes = s1 >= length
        # a part of a step
        part, low, high = w[PART, i], w[LOW_PART, i], w[HIGH_PART, i]
        exits = cutting > 1.5
        gap = select(exits, s1 / length - 1.0, gap_1)
        near = (upper(gap, -gap) < LANDED) | (high - low < 1e-15)
        tries = runs & (cutting > 0.5)
        landed = tries & near
        at = select(tries, q + part * (w[CUT_END, i] - q), w[MESH_END, i])
        done = landed & exits
        # a step that is cut at a boundary beyond the exit is cut at the exit next
        whole, at_branch = plain & (to == branch), landed & (cutting < 1.5)
        starts_exit = (whole & passes & sound) | (at_branch & passes)
        stays = other(starts_exit)
        taken = (whole | landed) & stays
        # the tries: their bracket, and the next of them
        beyond = gap > 0.0
        f_low, f_high = w[LOW_GAP, i], w[HIGH_GAP, i]
        low, high = select(beyond, low, part), select(beyond, part, high)
        f_low, f_high = select(beyond, f_low, gap), select(beyond, gap, f_high)
        by_false = low - f_low * (high - low) / (f_high - f_low)
        f_low = select(beyond & (cutting < 1.5), 0.5 * f_low, f_low)
        f_high = select(beyond | exits, f_high, 0.5 * f_high)
        new = select(exits, part - gap * part * length / w[RATE_S, i], by_false)
        new = select((new > low) & (new < high), new, 0.5 * (low + high))
        # a new cut
        cuts = kink & (gap_0 < 0.0)
        begins = cuts | starts_exit
        f_0 = select(starts_exit, s / length - 1.0, gap_0)
        f_1 = select(starts_exit, s1 / length - 1.0, gap_1)
        w[PART, i] = select(begins, f_0 / (f_0 - f_1), new)
        w[LOW_PART, i], w[HIGH_PART, i] = select(begins, 0.0, low), select(begins, 1.0, high)
        w[LOW_GAP, i], w[HIGH_GAP, i] = select(begins, f_0, f_low), select(begins, f_1, f_high)
        w[CUT_END, i] = select(begins, at, w[CUT_END, i])
        w[NEXT_BRANCH, i] = to
        mode = select(starts_exit, 2.0, select(cuts, 1.0, cutting))
        w[CUTTING, i] = select(taken | here, 0.0, mode)
        # a step that is taken, or cut
        w[BRANCH, i] = select((at_branch & stays) | here, to, branch)
        w[Q_AT, i] = select(runs & taken, at, q)
        w[S, i], w[X, i] = select(runs & taken, s1, s), select(runs & taken, x1, x)
        inside = (landed | here) & (w[Q_AT, i] < w[MESH_END, i] * (1.0 - 1e-13))
        fresh = select(begins, 0.0, w[FRESH, i])
        w[FRESH, i] = select(taken | here, select(inside, 0.0, 1.0), fresh)
        w[FINISHED, i] = select(done, 1.0, select(lost, 2.0, w[FINISHED, i]))
        rise = r1 * (1.0 - full_ln(upper(r1, SMALLEST)))
        past = select(z1 < 0.0, upper(1.0 + z1 * (r1 - 1.0), rho1), 1.0)
        form = select(r1 <= 1.0, rise, past)
        w[TRACTION, i] = select(done, form * nodes[last + 6, i], w[TRACTION, i])
        w[END_AT, i] = w[Q_AT, i]
        left = left + select(w[FINISHED, i] < 0.5, 1, 0)
    return not anywhere(left > 0)
