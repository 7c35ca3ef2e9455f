"""Operating points under constant friction, from closed forms, for many arcs at once.

The belt sticks from the entry nip to s_j, where the shear of the lagging asks for all that friction
can carry, and slips from there on at T = T_j exp(-mu (s - s_j)/R). In the stuck zone, with the
shear-lag length l = sqrt(c/(B C)), c = h/G and C = 1/EA', u = x_c cosh(s/l) + g l sinh(s/l). Both
meet at u_j = c mu T_j/(B R), which leaves one equation in s_j:

    T1 - T_j = (mu l T_j/R + B l x_c/c) tanh(s_j/(2 l)),   T_j = T2 exp(mu (L - s_j)/R).

For driving pulleys with a lagging that shears, on which the belt never turns back to the point of
no creep; whatever else there is, is left to the scalar kernel. NumPy alone: an arc's numbers depend
on itself alone.
"""

from __future__ import annotations

import numpy as np

from wraparc.arc.quantities import BREAKAWAY, SOLVED
from wraparc.arrays import Array, Flags
from wraparc.batch import row
from wraparc.batch.arcs import Arcs
from wraparc.batch.laws import LawBank
from wraparc.friction.compact import LIMIT

ROUNDS = 60  # of Newton's method in a bracket: 5 to 8 are usual
NEAR = 1e-12  # of T1
LONGEST = 300.0  # stuck zone over the shear-lag length: the hyperbolic functions end there
ACTIVE_SHARE = 0.01  # of the tension change that lies before the active arc


def constant_friction(bank: LawBank) -> Array:
    """Friction of each law of a bank that is constant from no slip on, else nan, shape (m,)."""
    found = np.full(len(bank), np.nan)
    for i in np.flatnonzero(bank.kind == LIMIT):
        law = bank.compact(int(i))
        if law.coefficients[2] == 0.0 and law.coefficients[3] == 0.0 and not len(law.edges):
            found[i] = law.coefficients[0]
    return found


#: What is written: an operating point.
_POINT = sorted({*row.PLACES[row.TENSIONS], *row.PLACES[row.RATIO]})


def solve_constant(arcs: Arcs, which: Flags, found: Array) -> Flags:
    """Solve driving arcs under constant friction into rows of results; returns which are solved.

    Parameters
    ----------
    arcs, which
        The arcs, and which of them are wanted.
    found
        Rows of results, see `wraparc.batch.row`; those that are solved are written.
    """
    done = np.zeros(len(arcs), dtype=bool)
    mu_of_law = constant_friction(arcs.laws)
    rows = np.flatnonzero(which & np.isfinite(mu_of_law[arcs.law]))
    if not len(rows):
        return done
    some = arcs.rows(rows)
    given = dict(zip(row.INPUTS, some.inputs().T, strict=True))
    with np.errstate(all="ignore"):
        out = _rows(given, mu_of_law[some.law])
    good = np.isfinite(out[:, row.OUTCOME])
    # with a tested range, what lies outside it is counted by the scalar kernel
    good &= np.isnan(given["slip_max"]) & np.isnan(some.laws.tested_speed[some.law])
    done[rows] = good
    found[np.ix_(rows[good], _POINT)] = out[np.ix_(good, _POINT)]  # capacities stay as they are
    return done


def _rows(given: dict[str, Array], mu: Array) -> Array:
    """Rows of results; the outcome is nan where the closed forms do not hold."""
    t1, t2, radius, width = (given[k] for k in ("entry_tension", "exit_tension", "radius", "width"))
    c, compliance, length = given["shear"], given["compliance"], radius * given["wrap_angle"]
    area, slope = width * radius, mu / radius
    overrun = given["overrun_constant"] + given["overrun_coefficient"] * (t1 / area) ** 1.5
    lag = np.sqrt(c / (width * compliance))
    out = np.full((len(mu), row.FOUND_NUMBERS), np.nan)
    log_ratio = np.log(t1 / t2)
    fit = (given["side"] > 0.0) & (c > 0.0) & (overrun >= 0.0) & (length < LONGEST * lag)
    fit &= overrun <= c * mu * t1 / area * (1.0 - 1e-9)  # else it is refused
    # a breakaway by more than rounding
    out[fit & (log_ratio > mu * given["wrap_angle"] + 1e-9), row.OUTCOME] = BREAKAWAY
    fit &= log_ratio < mu * given["wrap_angle"] - 1e-9
    end, met = _zone(t1, t2, length, lag, slope, width * lag * overrun / c)
    rest = length - end
    junction = t2 * np.exp(slope * rest)
    creep, sinh, cosh = c * mu * junction / area, np.sinh(end / lag), np.cosh(end / lag)
    g = (creep - overrun * cosh) / (lag * sinh)
    # creep stays rearward where the belt sticks, and slip grows where it slips
    fit &= met & (overrun + g * lag > 0.0)
    fit &= g + compliance * (t1 - junction) + c * mu * slope * junction / area > 0.0
    exit_creep = creep + g * rest + compliance * (t1 * rest - (junction - t2) / slope)
    exit_stress, pull = mu * t2 / area, t1 - t2
    columns = {
        row.OUTCOME: np.full(len(mu), float(SOLVED)),
        row.LOG_RATIO: -log_ratio,
        row.EXIT_CREEP: exit_creep,
        row.EXIT_SLIP: exit_creep - c * exit_stress,
        row.EXIT_STRESS: exit_stress,
        row.ENTRY_STRESS: overrun / c,
        # by the exact loss of energy: friction's part is what the shear does not take
        row.WORK: pull * (g + 0.5 * pull * compliance) / width
        - 0.5 * c * (exit_stress**2 - (overrun / c) ** 2),
        row.CREEP_RATIO: g,
        row.STUCK_LENGTH: end,
        row.PEAK_STRESS: mu * junction / area,  # stress grows to the junction, then falls
        row.PEAK_AT: end,
        row.ACTIVE: length - _begins(t1, t2, junction, end, slope, lag, c, width, overrun, g),
        row.LARGEST_SLIP: exit_creep - c * exit_stress,
        # slip grows by g + (T1 - T) C + c mu p mu/R, which goes one way with T
        row.STEEPEST_SLIP: g
        + np.maximum(
            compliance * (t1 - junction) + c * mu * slope * junction / area,
            compliance * pull + c * mu * slope * t2 / area,
        ),
    }
    for place, column in columns.items():
        out[fit, place] = column[fit]
    return out


def _zone(
    t1: Array, t2: Array, length: Array, lag: Array, slope: Array, overrun: Array
) -> tuple[Array, Flags]:
    """Length of the stuck zone [m], and where it is found: Newton's method in a bracket."""
    low, high = np.zeros_like(t1), length.copy()
    at, miss = 0.5 * length, np.full_like(t1, np.inf)
    met = np.zeros(len(t1), dtype=bool)
    for _ in range(ROUNDS):
        junction = t2 * np.exp(slope * (length - at))
        half = np.tanh(0.5 * at / lag)
        takes = slope * lag * junction + overrun
        miss = t1 - junction - takes * half
        met = np.abs(miss) <= NEAR * t1
        if met.all():
            break
        low, high = np.where(miss < 0.0, at, low), np.where(miss < 0.0, high, at)
        rise = slope * junction * (1.0 + slope * lag * half) - takes * (0.5 / lag) * (1 - half**2)
        new = at - miss / rise
        new = np.where((new > low) & (new < high), new, 0.5 * (low + high))
        at = np.where(met, at, new)
    return at, met


def _begins(
    t1: Array,
    t2: Array,
    junction: Array,
    end: Array,
    slope: Array,
    lag: Array,
    c: Array,
    width: Array,
    overrun: Array,
    g: Array,
) -> Array:
    """Where the active arc begins [m], in the stuck zone or past it."""
    taken = ACTIVE_SHARE * (t1 - t2)
    way, due = g * lag, taken * c / (width * lag)
    grown = (way + due + np.sqrt((way + due) ** 2 - way**2 + overrun**2)) / (overrun + way)
    return np.where(
        taken < t1 - junction, lag * np.log(grown), end + np.log(junction / (t1 - taken)) / slope
    )
