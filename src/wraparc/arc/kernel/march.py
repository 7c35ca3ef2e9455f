"""March around one wrap arc from the entry nip to the exit nip, for a given entry creep ratio.

Every function takes and returns plain numbers, so that one source runs in the interpreter and
translated for the page. A law arrives as (kind, edges, coefficients, slips), see
:mod:`wraparc.friction.compact`; the drive as the tuple `par` made by
:func:`wraparc.arc.kernel.quantities.parameters_at`.

A step (:mod:`wraparc.arc.kernel.step`) uses one piece of the law throughout; where it ends in
another piece, it is cut at the boundary (:mod:`wraparc.arc.kernel.cut`).
"""

from __future__ import annotations

from math import expm1, inf, nan

from wraparc.arc.kernel.creep_step import cell_lag, cell_step, creep_step, slip_at_entry
from wraparc.arc.kernel.cut import (
    LOWER_EDGE,
    NEXT_BRANCH,
    NO_SLIP,
    PREVIOUS_BRANCH,
    UPPER_EDGE,
    beyond,
    cut_tolerance,
    first_crossing,
    within,
)
from wraparc.arc.kernel.quantities import Parameters, Sliding
from wraparc.arc.kernel.step import LARGEST_LOG, MESH_POWER, pressure_at, rates, step
from wraparc.friction.compact import (
    KNOTS,
    LIMIT,
    PIECES,
    TABLE,
    CompactLaw,
    branch_of,
    friction_at,
    segment_of,
)

FEWEST_CUT_STEPS = 16  # a coarser march takes the piece of the law where each step starts
LANDINGS = 40  # attempts to land on a boundary
MOST_CUTS = 200  # of a mesh step
WILD_LOG_STEP, WILD_SLIP = 1.0, 1e4  # of ln T in a step, and [m]: no step is like this
FARTHEST_SLIP = 1e3  # [m]
LARGEST_LOG_STEP = 0.12  # of tension, in one step: keeps a piece of law near where it holds
FEW_STEPS = 0.05  # of a cell of a table, in one step: looked at
PART_OF_LAG = 0.3  # of the shear-lag length of a cell, in one step: misses some 1e-8
NEAREST = 1e-7  # of the arc, to a point of no slip: nearer the slope of friction does not count


def _stride(
    steep: bool,
    law: CompactLaw,
    par: Parameters,
    g: float,
    segment: int,
    branch: int,
    sign: float,
    q: float,
    x: float,
    span: float,
    xi: float,
    h: float,
    k: tuple[float, float, float],
) -> tuple[float, float, float]:
    """`step`, or `creep_step` in a steep cell of a table."""
    if steep:
        return creep_step(law, par, g, sign, q, x, span, xi, h)
    return step(law, par, g, segment, branch, sign, q, x, span, xi, h, k)


def _near_no_slip(away: float, s: float, nearest: float) -> float:
    """Longest step near a point of no slip amid the mesh, where the slope of the law is infinite.

    `away` is slip over its rate: how far there is no slip, < 0 where it lies ahead [m].
    """
    if away < 0.0:
        return max(-0.7 * away, nearest)
    return max(2.0 * away, nearest) if away < 0.1 * s else inf


def advance(  # noqa: C901 - one loop over steps and cuts
    law: CompactLaw,
    par: Parameters,
    g: float,
    state: Sliding,
    span: float,
    xi: float,
    xi_end: float,
    cut: bool,
) -> Sliding:
    """Carry a sliding state from xi to xi_end on a mesh of span xi^4.

    Steps are cut where the law changes its piece (if `cut`).
    """
    q, x, work, segment, branch, sign = state
    switches = 0
    while xi < xi_end:
        if not (-LARGEST_LOG < q < LARGEST_LOG and abs(x) < FARTHEST_SLIP):
            break  # tension or slip have grown beyond all bounds: no solution is near
        h = xi_end - xi
        k = rates(law, par, g, segment, branch, sign, q, x)
        jacobian = MESH_POWER * span * xi * xi * xi
        dq = abs(k[0]) * jacobian
        if dq * h > LARGEST_LOG_STEP:
            h = LARGEST_LOG_STEP / dq
        most = nan
        if law.kind in (KNOTS, PIECES) and x * k[1] != 0.0:
            s = span * xi**MESH_POWER
            reach = _near_no_slip(x / k[1], s, NEAREST * par.length)
            if span * (xi + h) ** MESH_POWER - s > reach:
                h = ((s + reach) / span) ** (1.0 / MESH_POWER) - xi
        if law.kind == TABLE:
            most = cell_step(law, par, g, segment, branch, sign, q, x)
            # a cubic is not to be trusted far outside its cell
            cell = law.slips[branch + 1] - law.slips[branch] if branch < len(law.slips) - 1 else inf
            if abs(k[1]) * span * ((xi + h) ** MESH_POWER - xi**MESH_POWER) > cell:
                reach = xi**MESH_POWER + cell / (abs(k[1]) * span)
                h = reach ** (1.0 / MESH_POWER) - xi
            reach = span * ((xi + h) ** MESH_POWER - xi**MESH_POWER)
            if abs(k[1]) * reach > FEW_STEPS * cell:
                # nor where friction, stepping up, makes creep grow manifold within a step
                lag = cell_lag(law, par, segment, branch, q, abs(x), abs(k[0]) * par.radius)
                if reach > PART_OF_LAG * lag:
                    h = (xi**MESH_POWER + PART_OF_LAG * lag / span) ** (1.0 / MESH_POWER) - xi
            if span * ((xi + h) ** MESH_POWER - xi**MESH_POWER) > most:
                h = (xi**MESH_POWER + most / span) ** (1.0 / MESH_POWER) - xi
        steep = most == most
        q1, x1, w1 = _stride(steep, law, par, g, segment, branch, sign, q, x, span, xi, h, k)
        tries = 0
        while not (abs(q1 - q) < WILD_LOG_STEP and abs(x1) < WILD_SLIP) and tries < 40:
            # a piece of a table continued far outside its cell knows no bounds
            tries += 1
            h *= 0.25
            q1, x1, w1 = _stride(steep, law, par, g, segment, branch, sign, q, x, span, xi, h, k)
        if tries == 40:
            break
        if not cut:
            p = pressure_at(par, q1)
            sign = sign if sign * x1 >= 0.0 else -sign
            segment = segment_of(law, p)
            branch = branch_of(law, segment, sign * x1, p)
        elif switches < MOST_CUTS and not within(law, par, segment, branch, q1, sign * x1):
            switches += 1
            t = xi + h
            r = rates(law, par, g, segment, branch, sign, q1, x1)
            j1 = MESH_POWER * span * t * t * t
            f, side = first_crossing(
                law,
                par,
                segment,
                branch,
                sign,
                h,
                (q, x, k[0] * jacobian, k[1] * jacobian),
                (q1, x1, r[0] * j1, r[1] * j1),
            )
            if f > 0.0:
                tolerance = cut_tolerance(law, segment, side)
                if side == NO_SLIP:
                    tolerance = min(tolerance, 1e-3 * abs(x))
                f_last, gap_last = 0.0, beyond(law, par, segment, branch, side, q, sign * x)
                low, high = 0.0, 1.0
                for tries in range(LANDINGS):
                    # land on the boundary: the cubic misses it a little, secant steps do not;
                    # where the law bends within the step, halving brings them back
                    q1, x1, w1 = _stride(
                        steep, law, par, g, segment, branch, sign, q, x, span, xi, h * f, k
                    )
                    gap = beyond(law, par, segment, branch, side, q1, sign * x1)
                    if abs(gap) < tolerance or gap == gap_last or tries == LANDINGS - 1:
                        break
                    low, high = (low, f) if gap > 0.0 else (f, high)
                    f_next = f - gap * (f - f_last) / (gap - gap_last)
                    f_last, gap_last = f, gap
                    if not low < f_next < high or tries > 3:
                        f_next = 0.5 * (low + high)
                    f = f_next
                q, x = q1, x1
                h *= f
                work += w1
                xi = min(xi + h, xi_end)
            if side == LOWER_EDGE:
                segment -= 1
            elif side == UPPER_EDGE:
                segment += 1
            elif side == NO_SLIP:
                sign = -sign
            elif side == PREVIOUS_BRANCH:
                branch -= 1
            elif side == NEXT_BRANCH:
                branch += 1
            continue
        q, x, work = q1, x1, work + w1
        xi = xi_end if h == xi_end - xi else xi + h
    return Sliding(q, x, work, segment, branch, sign)


def stress_and_creep(law: CompactLaw, par: Parameters, state: Sliding) -> tuple[float, float]:
    """Shear stress [Pa] and creep u = x + (h/G) tau [m] of a sliding state."""
    q, x, _, segment, branch, sign = state
    if x == 0.0 and law.kind in (KNOTS, PIECES):
        return 0.0, 0.0
    p = pressure_at(par, q)
    mu, _, _ = friction_at(law, segment, branch, sign * x, p)
    tau = sign * mu * p
    return tau, x + par.shear * tau


def _leave(law: CompactLaw, par: Parameters, rate: float, q: float, s: float) -> Sliding:
    """Sliding a short way s past a point of no slip, where creep grows at `rate` (no kick)."""
    sign = 1.0 if rate > 0.0 else -1.0
    x = slip_at_entry(law, par, abs(rate) * s, q)
    p = pressure_at(par, q)
    segment = segment_of(law, p)
    branch = branch_of(law, segment, x, p)
    mu, _, _ = friction_at(law, segment, branch, x, p)
    # friction grows nearly in proportion to s here: its mean is half of its last value
    dq = 0.5 * mu * s / par.radius
    return Sliding(q - sign * dq, sign * x, 0.5 * mu * p * x, segment, branch, sign)


def to_zero_slip(
    law: CompactLaw, par: Parameters, g: float, steps: int
) -> tuple[int, float, float, float]:
    """March while the creep of the kick is used up, with creep as the independent variable.

    u = x_c (1 - zeta)^4, x_c of either sign: the mesh is graded towards the point of no slip, which
    it reaches by construction. Returns a status and s, q, work there; status 1 arrived, 0 the creep
    rate changes sign before, 2 the end of the arc comes before.
    """
    kick, length = abs(par.kick), par.length
    sign = 1.0 if par.kick > 0.0 else -1.0
    q, s, work = 0.0, 0.0, 0.0
    x = slip_at_entry(law, par, kick, 0.0)  # its magnitude, as all but the rates
    h = 1.0 / steps
    for i in range(steps - 1):
        p = pressure_at(par, q)
        segment = segment_of(law, p)
        branch = branch_of(law, segment, x, p)
        # classical fourth-order step in zeta; the last mesh cell is closed analytically below
        zeta = i * h
        dq1 = dx1 = ds1 = dw1 = 0.0
        sum_q = sum_x = sum_s = sum_w = 0.0
        for stage in range(4):
            a = 0.0 if stage == 0 else (h if stage == 3 else 0.5 * h)
            weight = h / 6.0 if stage in (0, 3) else h / 3.0
            qs, xs = q + a * dq1, max(x + a * dx1, 0.0)
            rate = sign * (g + par.entry_tension * -expm1(qs) * par.compliance)
            if rate >= 0.0:
                return 0, 0.0, 0.0, 0.0
            r = rates(law, par, g, segment, branch, sign, qs, sign * xs)
            e = 1.0 - zeta - a
            ds1 = -4.0 * kick * e * e * e / rate
            dq1, dx1, dw1 = r[0] * ds1, sign * r[1] * ds1, r[2] * ds1
            sum_q += weight * dq1
            sum_x += weight * dx1
            sum_s += weight * ds1
            sum_w += weight * dw1
        if s + sum_s >= length:
            return 2, 0.0, 0.0, 0.0
        q, x, s, work = q + sum_q, x + sum_x, s + sum_s, work + sum_w
        if x <= 0.0:
            return 0, 0.0, 0.0, 0.0
    rate = sign * (g + par.entry_tension * -expm1(q) * par.compliance)
    if rate >= 0.0:
        return 0, 0.0, 0.0, 0.0
    ds = kick * h**4 / -rate
    if s + ds >= length:
        return 2, 0.0, 0.0, 0.0
    dq = rates(law, par, g, segment, branch, sign, q, sign * x)[0]
    return 1, s + ds, q + 0.5 * ds * dq, work


def carry_to_exit(
    law: CompactLaw,
    par: Parameters,
    g: float,
    state: Sliding,
    span: float,
    first: int,
    steps: int,
) -> Sliding:
    """Carry a state from mesh node `first` over the `span` [m] that is left to the exit."""
    h = 1.0 / steps
    cut = steps >= FEWEST_CUT_STEPS or law.kind in (LIMIT, TABLE)
    for i in range(first, steps):
        state = advance(law, par, g, state, span, i * h, (i + 1) * h, cut)
    return state


def sweep(law: CompactLaw, par: Parameters, g: float, steps: int) -> Sliding:
    """March the whole arc with a law that starts without a jump.

    Parameters
    ----------
    law, par
        See the module.
    g
        Entry creep ratio [-].
    steps
        Mesh steps over the arc.

    Returns
    -------
    Sliding
        At the exit nip.
    """
    kick, length = par.kick, par.length
    if kick != 0.0:
        sign = 1.0 if kick > 0.0 else -1.0
        x = slip_at_entry(law, par, abs(kick), 0.0)
        p = par.entry_pressure
        segment = segment_of(law, p)
        state = Sliding(0.0, sign * x, 0.0, segment, branch_of(law, segment, x, p), sign)
        if sign * g < 0.0 and law.kind in (KNOTS, PIECES):
            status, s, q, work = to_zero_slip(law, par, g, steps)
            if status == 1:
                rate = g + par.entry_tension * -expm1(q) * par.compliance
                cell = (length - s) / steps**MESH_POWER
                gone = _leave(law, par, rate, q, cell)
                state = gone._replace(work=gone.work + work)
                return carry_to_exit(law, par, g, state, length - s, 1, steps)
        return carry_to_exit(law, par, g, state, length, 0, steps)
    if g == 0.0:
        return Sliding(0.0, 0.0, 0.0, segment_of(law, par.entry_pressure), 0, 1.0)
    if law.kind in (LIMIT, TABLE):
        sign = 1.0 if g > 0.0 else -1.0
        state = Sliding(0.0, 0.0, 0.0, segment_of(law, par.entry_pressure), 0, sign)
        return carry_to_exit(law, par, g, state, length, 0, steps)
    state = _leave(law, par, g, 0.0, length / steps**MESH_POWER)
    return carry_to_exit(law, par, g, state, length, 1, steps)
