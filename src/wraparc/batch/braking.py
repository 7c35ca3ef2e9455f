"""One braking arc of a batch: the slip of the kick used up, then a march in tension.

The kick turns the belt rearward at the entry nip, braking turns it forward. The scalar kernel takes
a braking arc to the point of no slip with creep as the variable, and from there on in position;
here it goes on in tension, as driving arcs do, to the same numbers within 2e-6. Functions of plain
numbers and buffers only. :mod:`wraparc.batch.sixth_braking` does the same in the lanes; few rows
are solved by what stands here, in the interpreter.
"""

from __future__ import annotations

from math import exp, log, nan
from typing import NamedTuple

from wraparc.arc.kernel.answer import LOSS_MISS, loss_miss
from wraparc.arc.kernel.creep_step import slip_at_entry
from wraparc.arc.kernel.effort import TENSION, Aim, first_guess, mesh_steps, ratio_of
from wraparc.arc.kernel.march import record, to_zero_slip
from wraparc.arc.kernel.quantities import (
    RECORD,
    SOLVED,
    Buffer,
    Load,
    Parameters,
    Shot,
    State,
    parameters_at,
    zeros,
)
from wraparc.arc.kernel.search import tension_shot
from wraparc.arc.kernel.tension_march import march
from wraparc.arc.kernel.tension_table import open_table, table_size
from wraparc.batch.row import FOUND_NUMBERS, OUTCOME, geometry_of, load_of, read_profile
from wraparc.friction.compact import RISE, CompactLaw, branch_of, segment_of

LEAST_CREEP = 1e-4  # of the arc, that is guessed [m]
TURN_STEPS = 16  # of the scalar kernel to the point of no slip
ROUNDS = 14  # of a search, from a guess: 5 to 8 are usual
MET = 1e-10  # of ln(s/L), where it ends
GUESSED_SLOPE = -0.7  # of ln s by ln g


class Turn(NamedTuple):
    """Where the slip of a kick is used up."""

    status: int  # 1 if it is
    par: Parameters  # of the arc that is left
    s: float  # [m]
    log_tension: float  # ln(T/T1)
    work: float  # of friction until there [J/m2]
    gamma: float  # creep ratio there, towards the slack side


def turn_of(law: CompactLaw, par: Parameters, gamma: float, out: Buffer) -> tuple[Turn, int]:
    """Point of no slip of an arc with a kick against its slip, and the records up to it."""
    if par.kick * par.side >= 0.0:
        return Turn(1, par, 0.0, 0.0, 0.0, gamma), 0
    count = 0
    if len(out) > 0:
        sign = -par.side
        x = slip_at_entry(law, par, abs(par.kick), 0.0)
        segment = segment_of(law, par.entry_pressure)
        branch = branch_of(law, segment, x, par.entry_pressure)
        record(law, par, out, 0, 0.0, State(0.0, sign * x, 0.0, segment, branch, sign))
        count = 1
    status, s, q, work, count = to_zero_slip(law, par, par.side * gamma, TURN_STEPS, out, count)
    left = left_of(par, s, q)
    there = gamma + par.side * (par.entry_tension - left.entry_tension) * par.compliance
    return Turn(status, left, s, q, work, there), count


def left_of(par: Parameters, s: float, q: float) -> Parameters:
    """The arc from a point of no slip on, at s and ln(T/T1) = q."""
    fall = exp(q)
    return Parameters(
        par.entry_tension * fall, par.entry_pressure * fall, par.radius, par.length - s,
        par.compliance, par.shear, 0.0, par.width, par.side, par.onset,
    )  # fmt: skip


def guess_of(law: CompactLaw, par: Parameters, goal: float) -> float:
    """First guess of the entry creep ratio towards the slack side, that of the scalar kernel."""
    z = first_guess(law, par, Aim(TENSION, goal))
    # less does not use up the kick on the arc
    return max(par.side * ratio_of(par, z), (LEAST_CREEP - 3.0 * par.side * par.kick) / par.length)


def exit_of(par: Parameters, there: Turn, after: Shot, gamma: float) -> Shot:
    """Exit quantities of a whole arc, of those of the arc that is left."""
    return Shot(
        after.log_tension + there.log_tension, after.slip, after.creep, after.stress,
        after.work + there.work, par.side * gamma, 0.0,
    )  # fmt: skip


def read_both(
    law: CompactLaw,
    par: Parameters,
    load: Load,
    there: Turn,
    shot: Shot,
    out: Buffer,
    before: int,
    more: int,
    found: Buffer,
) -> None:
    """Put the records of the arc that is left behind those up to it, and read them."""
    for k in range(before, before + more):
        out[RECORD * k] += there.s
        out[RECORD * k + 1] += there.log_tension
        out[RECORD * k + 5] += there.work
    for k in range(FOUND_NUMBERS):
        found[k] = nan
    found[OUTCOME] = SOLVED
    read_profile(law, par, load, shot, out, before + more, found)


def brake(law: CompactLaw, given: Buffer, steps: int, points: int, found: Buffer) -> bool:
    """Solve a braking arc into a row of results, if it is fit to be solved so."""
    load = load_of(given)
    par = parameters_at(load.entry_tension, geometry_of(given))
    goal = log(load.exit_tension / load.entry_tension)
    fine = mesh_steps(law, par, steps)
    table, out = zeros(table_size(goal + 1.0, fine)), zeros(RECORD * (points + 2 * fine + 600))
    first = guess_of(law, par, goal)
    z = z_last = miss_last = 0.0
    slope = GUESSED_SLOPE
    for _ in range(ROUNDS):
        gamma = first * exp(z)
        there, before = turn_of(law, par, gamma, out)
        end = par.side * log(there.par.entry_tension / load.exit_tension)
        miss, status = 1.0, SOLVED
        if there.status == 1:
            open_table(law, there.par, end, fine, table)
            status, _, s, a, work, _ = march(law, there.par, there.gamma, False, table, 0, zeros(0))
            if status != SOLVED:
                return False
            miss = log(s / there.par.length)
            if abs(miss) <= MET:
                break
            secant = (miss - miss_last) / (z - z_last) if z != z_last else 0.0
            if secant < 0.0 and miss_last != 0.0:
                slope = secant
            miss_last, z_last = miss, z
        z -= min(max(miss / slope, -1.0), 1.0)
    if not abs(miss) <= MET:
        return False
    after = tension_shot(law, there.par, there.gamma, end, a, work)
    shot = exit_of(par, there, after, gamma)
    if not loss_miss(law, par, shot) < 10.0 * LOSS_MISS:
        return False
    rest = out[RECORD * before : len(out)]
    _, _, _, _, _, more = march(law, there.par, there.gamma, False, table, points, rest)
    for k in range(RECORD * more):
        out[RECORD * before + k] = rest[k]
    p = load.exit_tension / (par.width * par.radius)
    if branch_of(law, segment_of(law, p), abs(shot.slip), p) != RISE:
        return False
    read_both(law, par, load, there, shot, out, before, more, found)
    return True
