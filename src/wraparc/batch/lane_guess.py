"""First guesses of the lane kernel, from exact relations with the profile along the arc guessed."""

from __future__ import annotations

from wraparc.batch.elementwise import (
    Lanes,
    Number,
    Table,
    ex,
    lanes,
    ln,
    lower,
    root,
    select,
    upper,
)
from wraparc.batch.lane_look import (
    look_up,
)
from wraparc.batch.lane_slots import (
    AT,
    COMPLIANCE,
    END,
    FRICTION_AT,
    FRICTION_EXIT,
    FRICTION_WORK,
    GAMMA,
    GOAL,
    KICK,
    KICK_FORMULA,
    KICK_GIVEN,
    LENGTH,
    P1,
    P_EXIT,
    P_WORK,
    PEAK_FRICTION,
    PEAK_SLIP,
    PRESSURE,
    PULL,
    RADIUS,
    RATIO,
    SHEAR,
    SLIP_AT,
    SLIP_EXIT,
    SLIP_WORK,
    SMALLEST,
    TENSION,
    WIDTH,
    WORK_0,
    S,
    X,
    Z,
)

#: shares of Q at which the pressure stands for the arc in the first guess, and of shrinkage in it
WORK_SHARE, EXIT_SHARE, SHRINKAGE_SHARE = 0.4, 0.85, 0.3
MOST_FALL, GUESS_DAMPING = 0.95, 0.7  # of (T1 - T2)/T1 in a guess; of its changes
WORK_EXPONENT = 0.7  # the work of friction grows with this power of pressure, roughly


def load(w: Lanes, laws: Table) -> None:
    """What follows from the entry tension: pressure, kick, law at the entry, shear-lag length."""
    n = lanes()
    for i in range(n):
        tension = w[TENSION, i]
        p = tension / (w[WIDTH, i] * w[RADIUS, i])
        w[P1, i] = w[PRESSURE, i] = p
        w[KICK, i] = w[KICK_GIVEN, i] + w[KICK_FORMULA, i] * p * root(p)
        w[RATIO, i] = tension * w[COMPLIANCE, i]
    look_up(w, laws)
    for i in range(n):
        slip, friction = w[SLIP_AT, i], w[FRICTION_AT, i]
        w[PEAK_SLIP, i], w[PEAK_FRICTION, i] = slip, friction
        soft = w[SHEAR, i] + 0.18 * slip / (friction * w[P1, i])
        lag = root(soft / (w[WIDTH, i] * w[COMPLIANCE, i]))
        w[GAMMA, i] = w[KICK, i] / lag


def guess(w: Lanes, laws: Table) -> None:
    """First guess of z from two exact relations with the profile guessed.

    With the creep ratio g + dT C at any point, (g + dT C/2) dT = B int tau du; and u(L) is the mean
    creep ratio times L. Friction is taken at one pressure for the work and at another at the exit.
    """
    n = lanes()
    law_at_shares(w, laws)
    for i in range(n):
        slip, friction = w[SLIP_WORK, i], w[FRICTION_WORK, i]
        bend = w[SHEAR, i] * w[P1, i] * friction / slip
        kick = w[KICK, i]
        kicked = kick / (1.0 + bend * (1.0 - ln(lower(upper(kick / slip, 1e-9), 1.0))))
        w[WORK_0, i], _, _ = work_of(kicked, slip, friction)
        share = lower(1.8 * w[END, i] * w[RADIUS, i] / (w[LENGTH, i] * friction), 0.9)
        w[AT, i] = share
        w[X, i] = 0.3 * share
    for _ in range(2):
        for i in range(n):
            r, log_r = w[X, i], ln(w[X, i])
            step = (w[AT, i] - r * (1.0 - log_r)) / log_r
            w[X, i] = lower(upper(r - step, 0.3 * r), 0.9)
    for i in range(n):
        w[X, i] = w[X, i] * w[SLIP_WORK, i]
    for _ in range(3):
        better_guess(w)
    for i in range(n):
        shrink = w[RATIO, i] * (1.0 - ex(-w[END, i]))
        w[Z, i] = guess_z(shrink, w[S, i], w[KICK, i], w[LENGTH, i], w[GAMMA, i])


def guess_z(shrink: Number, creep: Number, kick: Number, length: Number, gamma: Number) -> Number:
    """Z from the exit creep and the shrinkage to it.

    The mean creep ratio gives g where the belt is stiff. Where it is soft that is a small
    difference of large numbers, and creep grows like sinh(s/l): with y = L w/u = X coth X at the
    exit, X = L/l, g/w = 1/cosh X is nearly 2 exp(-y).
    """
    ratio = (creep - kick) / length - SHRINKAGE_SHARE * shrink
    exit_ratio = upper(ratio, 0.0) + shrink
    soft = exit_ratio * ex(-lower(length * exit_ratio / creep, 40.0))
    return ln(upper(ratio + gamma, soft + SMALLEST))


def law_at_shares(w: Lanes, laws: Table) -> None:
    """The law at the two pressures that stand for the arc in a guess."""
    n = lanes()
    for i in range(n):
        w[PRESSURE, i] = w[P1, i] * ex(-WORK_SHARE * w[END, i])
    look_up(w, laws)
    for i in range(n):
        w[P_WORK, i] = w[PRESSURE, i]
        w[SLIP_WORK, i], w[FRICTION_WORK, i] = w[SLIP_AT, i], w[FRICTION_AT, i]
        w[PRESSURE, i] = w[P1, i] * ex(-EXIT_SHARE * w[END, i])
    look_up(w, laws)
    for i in range(n):
        w[P_EXIT, i] = w[PRESSURE, i]
        w[SLIP_EXIT, i], w[FRICTION_EXIT, i] = w[SLIP_AT, i], w[FRICTION_AT, i]


def better_guess(w: Lanes) -> None:
    """One Newton step of the exit slip, kept in X; S gets the exit creep before it."""
    n = lanes()
    for i in range(n):
        c, length, x = w[SHEAR, i], w[LENGTH, i], w[X, i]
        p_work, p_exit = w[P_WORK, i], w[P_EXIT, i]
        fall = 1.0 - ex(-w[END, i])
        shrink = w[RATIO, i] * fall
        scale = w[P1, i] * w[RADIUS, i] * fall
        work, mu, _ = work_of(x, w[SLIP_WORK, i], w[FRICTION_WORK, i])
        _, mu_e, mu_x = work_of(x, w[SLIP_EXIT, i], w[FRICTION_EXIT, i])
        tau, tau_x = mu_e * p_exit, mu_x * p_exit
        energy = p_work * (work - w[WORK_0, i]) + 0.5 * c * tau * tau
        ratio = energy / scale - 0.5 * shrink
        creep = x + c * tau
        miss = length * (ratio + SHRINKAGE_SHARE * shrink) + w[KICK, i] - creep
        slope = length * (p_work * mu + c * tau * tau_x) / scale - 1.0 - c * tau_x
        step = select(slope > 0.0, miss / upper(slope, SMALLEST), -x)
        w[S, i] = creep
        w[X, i] = lower(upper(x - step, 0.4 * x), 2.5 * x)


def work_of(x: Number, peak_slip: Number, peak_friction: Number) -> tuple[Number, Number, Number]:
    """Int mu dx [m], mu [-] and its slope [1/m] of the integral-log law, flat past the peak."""
    r = upper(x / peak_slip, SMALLEST)
    log_r = lower(ln(r), 0.0)
    y = lower(r, 1.0)
    work = peak_friction * peak_slip * (y * y * (0.75 - 0.5 * log_r) + r - y)
    return work, peak_friction * y * (1.0 - log_r), -peak_friction * log_r / peak_slip


def guess_carried(w: Lanes, laws: Table, of_slip: float) -> None:
    """First guess of z and END at which the exit creep or slip is GOAL; see `guess`."""
    n = lanes()
    for i in range(n):
        w[END, i] = 0.6 + 0.0 * w[GOAL, i]
    for _ in range(4):
        guess_work(w, laws, of_slip)
        for i in range(n):
            energy = w[AT, i] / (w[P1, i] * w[RADIUS, i])
            mean = upper((w[S, i] - w[KICK, i]) / w[LENGTH, i], SMALLEST)
            bow = 4.0 * (0.5 - SHRINKAGE_SHARE) * w[RATIO, i] * energy
            fall = lower(2.0 * energy / (mean + root(mean * mean + bow)), MOST_FALL)
            shrink = w[RATIO, i] * fall
            w[Z, i] = guess_z(shrink, w[S, i], w[KICK, i], w[LENGTH, i], w[GAMMA, i])
            w[END, i] = w[END, i] + GUESS_DAMPING * (-ln(1.0 - fall) - w[END, i])


def guess_least(w: Lanes, laws: Table) -> None:
    """First guess of z and TENSION at which the exit creep is GOAL and the pull PULL."""
    n = lanes()
    for _ in range(4):
        end_of_pull(w, laws)
        guess_work(w, laws, 0.0)
        for i in range(n):
            pull, shrink = w[PULL, i], w[PULL, i] * w[COMPLIANCE, i]
            mean = upper((w[S, i] - w[KICK, i]) / w[LENGTH, i], SMALLEST)
            due = pull * (mean + (0.5 - SHRINKAGE_SHARE) * shrink)
            slack = upper(w[TENSION, i] - pull, 1e-3 * pull)
            # the work grows with about this power of T2
            power = WORK_EXPONENT * (WORK_SHARE + (1.0 - WORK_SHARE) * slack / w[TENSION, i])
            move = ln(due / (w[WIDTH, i] * w[AT, i])) / power
            w[TENSION, i] = pull + slack * ex(lower(upper(move, -1.0), 1.0))
            w[Z, i] = guess_z(shrink, w[S, i], w[KICK, i], w[LENGTH, i], w[GAMMA, i])


def end_of_pull(w: Lanes, laws: Table) -> None:
    """END of the pull at the entry tension, with all that depends on the latter."""
    n = lanes()
    load(w, laws)
    for i in range(n):
        w[END, i] = -ln(upper(1.0 - w[PULL, i] / w[TENSION, i], 1e-4))


def guess_work(w: Lanes, laws: Table, of_slip: float) -> None:
    """Creep at the exit, in S, and work of friction and shear per area, in AT, for the goal."""
    n = lanes()
    law_at_shares(w, laws)
    for i in range(n):
        slip, goal = w[SLIP_EXIT, i], w[GOAL, i]
        bend = (1.0 - of_slip) * w[SHEAR, i] * w[P_EXIT, i] * w[FRICTION_EXIT, i] / slip
        w[AT, i] = bend
        w[X, i] = goal / (1.0 + bend * (1.0 - lower(ln(upper(goal / slip, SMALLEST)), 0.0)))
    for _ in range(2):
        for i in range(n):
            x, slip, bend = w[X, i], w[SLIP_EXIT, i], w[AT, i]
            log_r = lower(ln(upper(x / slip, SMALLEST)), 0.0)
            miss = x + bend * lower(x, slip) * (1.0 - log_r) - w[GOAL, i]
            w[X, i] = upper(x - miss / (1.0 - bend * log_r), 0.1 * x)
    for i in range(n):
        x, c = w[X, i], w[SHEAR, i]
        work, _, _ = work_of(x, w[SLIP_WORK, i], w[FRICTION_WORK, i])
        _, mu, _ = work_of(x, w[SLIP_EXIT, i], w[FRICTION_EXIT, i])
        kick, _, _ = work_of(0.2 * w[KICK, i], w[SLIP_WORK, i], w[FRICTION_WORK, i])
        tau = mu * w[P_EXIT, i]
        w[AT, i] = upper(w[P_WORK, i] * (work - kick) + 0.5 * c * tau * tau, SMALLEST)
        w[S, i] = upper(x + c * tau, SMALLEST)
