"""The tensions of many trains from what turns their drums: all arcs of all rows side by side.

The unknowns are the tensions between the pulleys. Each arc is solved for its tensions by the batch
kernel, which gives its entry creep ratio; the speed that each drum then asks of the belt,

    L = -ln(1 - g) + ln(1 + T1/EA) - ln(1 - delta/R) - ln(omega(M) R),

must be the same for all drums, and a torque that follows another must do so. Between two drums L of
the second less that of the first rises with the tension between them, past breakaway to infinity:
the root is kept in a bracket and none can be missed. Between more, Newton's method with slopes by
differences; what it does not find is left to the solver of one train.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import nan

import numpy as np
from numpy.typing import NDArray

from wraparc.arc.quantities import BREAKAWAY, SOLVED, jumps
from wraparc.batch import Setting, row
from wraparc.batch.scaled import solve_scaled
from wraparc.train.rows import Followers, TrainRows

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Integers = NDArray[np.int64]

#: Miss of a speed equation that counts as none, by setting [-].
MISSES = {Setting.ENGINEERING: 1e-8, Setting.PRECISE: 1e-11}
_SCALE = 3e-4  # miss from which on misses are counted by their logarithm: creep is exponential
_LEAST, _MOST = 1e-5, 30.0  # tensions between the drums, over the largest at the ends
_CLOSE = 1e-12  # width of a bracket that holds one number, over the largest tension
_FIRST_STEP = 0.03  # of the total pull
_DIFFERENCE = 1e-4  # of a tension, for slopes
_CLOSINGS, _NEWTON_STEPS, _HALVINGS = 80, 25, 10


@dataclass(frozen=True)
class Start:
    """Where to look for the balance first.

    Attributes
    ----------
    shares
        Of the drums [-].
    sensitivity
        Change of the share of the second drum by the logarithm of its speed, nan if unknown [-].
    """

    shares: tuple[float, ...]
    sensitivity: float = nan


@dataclass(frozen=True, eq=False)
class Balanced:
    """Tensions of trains.

    Attributes
    ----------
    between
        Tensions behind all pulleys but the last, shape (n, drums - 1) [N].
    found
        Which trains have a balance (an arc may break away at given pulls), shape (n,).
    fallen
        Which drums break away where there is none, shape (n, drums).
    unsure
        Trains left to the solver of one train, shape (n,).
    """

    between: Array
    found: Flags
    fallen: Flags
    unsure: Flags


def balance(equations: Equations, start: Start) -> Balanced:
    """Return the tensions of trains."""
    rows = equations.rows
    n, count = len(rows), equations.count
    pulls = rows.pulls
    if pulls is None:
        pulls = np.array(start.shares) * rows.total[:, None]
    before = np.cumsum(pulls, axis=1)[:, :-1] - np.cumsum(rows.drums["run"], axis=1)[:, :-1]
    between = rows.whole["entry_tension"][:, None] - before
    none, nobody = np.zeros(n, dtype=bool), np.zeros((n, count), dtype=bool)
    if rows.pulls is not None or count == 1:
        return Balanced(between, ~none, nobody, none)
    if equations.rests:
        return Balanced(between, none, nobody, ~none)
    if equations.setting is Setting.PRECISE:  # the last steps are enough
        near = balance(Equations(rows, Setting.ENGINEERING), start)
        between = np.where(near.found[:, None], near.between, between)
    if count == 2 and not equations.followers:
        return _between_two(equations, between[:, 0], start.sensitivity)
    return _newton(equations, between)


class Equations:
    """What must balance, for some or all of the rows at once."""

    def __init__(self, rows: TrainRows, setting: Setting) -> None:
        self.rows, self.setting = rows, setting
        self.arcs = rows.arcs()
        self.count = len(rows.names)
        self.followers = [i for i, m in enumerate(rows.motors) if isinstance(m, Followers)]
        self.turned = [i for i in range(self.count) if i not in self.followers]
        lift = rows.lift  # tensions are those above m v^2
        self.entry, self.exit = (rows.whole[f"{end}_tension"] - lift for end in ("entry", "exit"))
        self.largest = np.maximum(self.entry, self.exit)
        drums = rows.drums
        area = rows.whole["belt_width"][:, None] * drums["diameter"]
        self.radius = 0.5 * drums["diameter"] + rows.offsets  # R + e
        self.squeeze = 2.0 * drums["lagging_thickness"] / (drums["compression_modulus"] * area)

    @property
    def rests(self) -> bool:
        """Whether a belt rests on a drum whatever the load: no speed tells its tensions."""
        stiff = self.arcs.shear_compliance.reshape(-1, self.count) == 0.0
        laws = self.rows.bank
        return any(
            jumps(laws.compact(i)) and laws.onset_compliance[i] == 0.0 and stiff[:, i].any()
            for i in range(self.count)
        )

    def tensions(self, which: Integers, between: Array) -> tuple[Array, Array]:
        """Entry and exit tensions, shape (k, drums) each [N]."""
        first, last = self.entry[which, None], self.exit[which, None]
        entries = np.concatenate([first, between + self.rows.runs[which]], axis=1)
        return entries, np.concatenate([between, last], axis=1)

    def torques(self, which: Integers, entries: Array, exits: Array) -> Array:
        """Torques on the drums, shape (k, drums) [N m]."""
        arm = self.radius[which] - self.squeeze[which] * entries
        return np.asarray((entries - exits) * arm)

    def levels(self, which: Integers, between: Array) -> Array:
        """L of the drums that do not follow, inf of those that break away, shape (k, turned)."""
        entries, exits = self.tensions(which, between)
        drums = np.array(self.turned)
        ratios = self._ratios(which, drums, entries[:, drums], exits[:, drums])
        return self.asked(which, entries, exits, ratios)

    def asked(self, which: Integers, entries: Array, exits: Array, ratios: Array) -> Array:
        """L of the drums that do not follow, from their entry creep ratios, shape (k, turned)."""
        drums = np.array(self.turned)
        at, a = np.ix_(which, drums), entries[:, drums]
        finite = np.isfinite(ratios)
        level = np.log1p(a / self.rows.light_stiffness[which, None])
        level -= np.log1p(-self.squeeze[at] * a / self.radius[at])
        level -= np.log1p(-np.where(finite, np.minimum(ratios, 0.99), 0.0))
        speeds = self.drum_speeds(which, self.torques(which, entries, exits))[:, drums]
        return np.where(finite, level - np.log(speeds * self.radius[at]), ratios)

    def drum_speeds(self, which: Integers, torques: Array) -> Array:
        """Speeds of the drums, 1 of those that follow, shape (k, drums) [rad/s]."""
        if self.rows.speeds is not None:
            return self.rows.speeds[which]
        speeds = np.ones_like(torques)
        for i in self.turned:
            motor = self.rows.motors[i]
            assert not isinstance(motor, Followers)  # noqa: S101 - those turn as they must
            speeds[:, i] = motor.rows(which).drum_speed(torques[:, i])
        return speeds

    def _ratios(self, which: Integers, drums: Integers, a: Array, b: Array) -> Array:
        """Entry creep ratios, inf towards the slack side where an arc breaks away, else nan."""
        places = (which[:, None] * self.count + drums).ravel()
        arcs = self.arcs.rows(places)
        arcs = replace(arcs, entry_tension=a.ravel(), exit_tension=b.ravel())
        factors = (self.rows.drums[k].ravel()[places] for k in ("friction_factor", "slip_factor"))
        found = solve_scaled(arcs, *factors, setting=self.setting, capacities=False).found
        gone = found[:, row.OUTCOME] == BREAKAWAY
        away = np.where(arcs.entry_tension >= arcs.exit_tension, np.inf, -np.inf)
        solved = np.where(found[:, row.OUTCOME] == SOLVED, found[:, row.CREEP_RATIO], np.nan)
        return np.where(gone, away, solved).reshape(a.shape)

    def misses(self, which: Integers, between: Array) -> Array:
        """Misses of all equations, shape (k, drums - 1) [-]."""
        levels = self.levels(which, between)
        with np.errstate(invalid="ignore"):
            speeds = np.diff(levels, axis=1)
        entries, exits = self.tensions(which, between)
        return np.concatenate([speeds, self.unfollowed(which, entries, exits)], axis=1)

    def unfollowed(self, which: Integers, entries: Array, exits: Array) -> Array:
        """Misses of the torques that follow others, shape (k, followers) [-]."""
        torques = self.torques(which, entries, exits)
        scale = self.largest[which] * self.radius[which, 0]
        misses = np.empty((len(which), len(self.followers)))
        for k, i in enumerate(self.followers):
            motor = self.rows.motors[i]
            assert isinstance(motor, Followers)  # noqa: S101 - see `followers`
            misses[:, k] = torques[:, i] - motor.ratio[which] * torques[:, motor.master]
        return np.asarray(misses / scale[:, None])


def _between_two(equations: Equations, start: Array, sensitivity: float) -> Balanced:
    """Close in on the tension between two drums, in every row."""
    n, tolerance = len(start), MISSES[equations.setting]
    largest = equations.largest
    low = np.maximum(_LEAST * largest, _LEAST * largest - equations.rows.runs[:, 0])
    high = _MOST * largest
    x = np.clip(start, low, high)
    before, f_before = np.full(n, np.nan), np.full(n, np.nan)
    broken = np.zeros((2, n, 2), dtype=bool)  # at the lower and at the upper end
    done, lost, nowhere = (np.zeros(n, dtype=bool) for _ in range(3))
    size = np.full(n, np.inf)
    total = np.maximum(np.abs(equations.rows.total), 1e-3 * largest)
    # without the slope at the start a step that leads across the root more often than not
    step = total * sensitivity if sensitivity > 0.0 else np.full(n, nan)
    for i in range(_CLOSINGS):
        live = np.flatnonzero(~(done | lost | nowhere))
        if not len(live):
            break
        at = x[live]
        levels = equations.levels(live, at[:, None])
        gone = np.isinf(levels)
        with np.errstate(invalid="ignore"):
            f = levels[:, 1] - levels[:, 0]
        opposed = gone.all(axis=1) & (levels[:, 0] == levels[:, 1])
        lost[live] = np.isnan(f) & ~opposed
        # both break away, each wanting less: no tension between them helps
        nowhere[live] = opposed
        broken[0][live] |= gone & (opposed | (f < 0.0))[:, None]
        broken[1][live] |= gone & (f > 0.0)[:, None]
        done[live] = np.abs(f) <= tolerance
        below = f < 0.0
        low[live], high[live] = np.where(below, at, low[live]), np.where(below, high[live], at)
        closed = (high[live] - low[live] <= _CLOSE * largest[live]) & ~done[live]
        # a jump between two ways of solving an arc is no edge of friction
        done[live] |= closed & (np.abs(f) <= 1e3 * tolerance)
        nowhere[live] |= closed & ~done[live]
        f = np.arcsinh(f / _SCALE)
        new = _next(at, f, before[live], f_before[live])
        if i == 0:
            blind = np.sign(f) * _FIRST_STEP * total
            new = at - np.where(np.isnan(step), blind, step * _SCALE * f)
        inside = (low[live] < new) & (new < high[live])
        slow = np.zeros(len(live), dtype=bool)
        if i % 3 == 2:
            slow = ~(np.abs(f) < 0.5 * size[live])
            size[live] = np.abs(f)
        new = np.where(inside & ~slow, new, 0.5 * (low[live] + high[live]))
        before[live], f_before[live] = at, f
        x[live] = np.where(done[live], at, new)
    unsure = ~(done | nowhere)
    return Balanced(x[:, None], done, broken.any(axis=0) & nowhere[:, None], unsure)


def _next(x: Array, f: Array, before: Array, f_before: Array) -> Array:
    """Where a straight line through two points is zero, nan or infinite where there is none."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(x - f * (x - before) / (f - f_before))


def _newton(equations: Equations, start: Array) -> Balanced:
    """Newton's method in every row, its slopes kept and corrected (Broyden) while they serve."""
    n, k = start.shape
    tolerance = MISSES[equations.setting]
    low = _LEAST * equations.largest[:, None]
    x = np.maximum(start, np.maximum(low, low - equations.rows.runs))
    everywhere = np.arange(n)
    f = equations.misses(everywhere, x)
    slopes = np.full((n, k, k), np.nan)
    fresh, lost = np.zeros(n, dtype=bool), np.asarray(~np.isfinite(f).all(axis=1))
    size = _size(f)
    for _ in range(_NEWTON_STEPS):
        live = np.flatnonzero(~lost & (size > tolerance))
        if not len(live):
            break
        old = live[np.isnan(slopes[live]).any(axis=(1, 2))]
        if len(old):
            slopes[old], fresh[old] = _slopes(equations, old, x[old], f[old]), True
        step, solvable = _step(slopes[live], f[live])
        lost[live[~solvable]] = True
        left = np.flatnonzero(solvable)
        factor = 1.0
        for _ in range(_HALVINGS):
            rows = live[left]
            if not len(rows):
                break
            new = x[rows] + factor * step[left]
            held = (new > low[rows]) & (new + equations.rows.runs[rows] > low[rows])
            new = np.where(held, new, x[rows])
            f_new = equations.misses(rows, new)
            size_new = _size(f_new)
            better = size_new < size[rows]
            good, moved = rows[better], new[better] - x[rows[better]]
            slopes[good] = _learned(slopes[good], moved, f_new[better] - f[good])
            slow = size_new[better] > 0.5 * size[good]
            slopes[good[slow & ~fresh[good]]] = np.nan
            fresh[good] = False
            x[good], f[good], size[good] = new[better], f_new[better], size_new[better]
            left, factor = left[~better], 0.5 * factor
        stuck = live[left]
        lost[stuck[fresh[stuck]]] = True
        slopes[stuck] = np.nan
    found = size <= tolerance
    found |= lost & (size <= 1e3 * tolerance)  # as near as the arcs are solved
    return Balanced(x, found, np.zeros((n, k + 1), dtype=bool), ~found)


def _size(misses: Array) -> Array:
    """Largest miss of each row; infinite where an arc breaks away."""
    size = np.abs(misses).max(axis=1)
    return np.where(np.isfinite(size), size, np.inf)


def _slopes(equations: Equations, which: Integers, x: Array, f: Array) -> Array:
    """Slopes of the misses by the tensions, by differences, shape (k, drums - 1, drums - 1)."""
    made = np.empty((len(which), x.shape[1], x.shape[1]))
    for j in range(x.shape[1]):
        moved = x.copy()
        moved[:, j] *= 1.0 + _DIFFERENCE
        with np.errstate(invalid="ignore"):
            made[:, :, j] = (equations.misses(which, moved) - f) / (moved - x)[:, j, None]
    return made


def _step(slopes: Array, f: Array) -> tuple[Array, Flags]:
    """Steps of the linear equations, and where they have one."""
    good = np.asarray(np.isfinite(slopes).all(axis=(1, 2)) & np.isfinite(f).all(axis=1))
    good &= np.abs(np.linalg.det(np.where(good[:, None, None], slopes, 0.0))) > 0.0
    step = np.zeros_like(f)
    if good.any():
        step[good] = np.linalg.solve(slopes[good], -f[good][..., None])[..., 0]
    return step, good


def _learned(slopes: Array, moved: Array, change: Array) -> Array:
    """Slopes that are true between the last two points, little changed otherwise."""
    square = (moved * moved).sum(axis=1)
    miss = change - (slopes @ moved[..., None])[..., 0]
    part = miss / np.where(square > 0.0, square, np.inf)[:, None]
    return np.asarray(slopes + part[:, :, None] * moved[:, None, :])
