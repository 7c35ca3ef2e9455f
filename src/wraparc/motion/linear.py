"""A station linearised about its steady state: its equations for small vibrations, and its roots.

Put into the equations of the train, the arcs' responses make a small complex matrix. Its
determinant vanishes at the roots; how many lie to the right of a line is how often the determinant
winds around 0 along a rectangle; with a force on the right side it gives amplitudes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from wraparc.arrays import Complex
from wraparc.motion.arc_response import ArcResponse, SteadyProfile
from wraparc.motion.control import Duty, ExactSpeed, Follower, SpeedLoop
from wraparc.motion.drum_state import duty_of
from wraparc.motion.station import Drum, Station
from wraparc.motion.station_state import steady_of
from wraparc.train import CaseResult

NDArrayInt = np.ndarray[tuple[int, ...], np.dtype[np.int64]]

#: Highest frequency looked at [Hz], real parts searched [1/s], points on the left side.
HIGHEST = 15.0
#: Growth that the search does not tell from none [1/s]: a root at 0, as the length of belt that a
#: fixed take-up keeps, doubles in no less than 70 s.
CALM = 0.01
_LEFT, _RIGHT, _POINTS = -3.0, 25.0, 400
#: Laplace variable that stands for 0 [1/s].
SLOWLY = 1e-4j


@dataclass(frozen=True, eq=False)
class Linear:
    """A station linearised about its steady state.

    Attributes
    ----------
    station, steady
        The station, and its steady state.
    profiles, duties
        Of every drum.
    """

    station: Station
    steady: CaseResult
    profiles: tuple[SteadyProfile, ...]
    duties: tuple[Duty, ...]

    @classmethod
    @lru_cache(maxsize=4)  # the verdict of a run asks too
    def of(cls, station: Station) -> Linear:
        """Linearise a station."""
        steady = steady_of(station)
        profiles = tuple(SteadyProfile.of(m.arc, m.surface_speed) for m in steady.members)
        duties = tuple(duty_of(station, steady, i) for i in range(len(station.drums)))
        return cls(station, steady, profiles, duties)

    def controlled(self, *drums: Drum) -> Linear:
        """Return the same steady state with other drums (controls, inertias)."""
        station = replace(self.station, drums=drums)
        duties = tuple(
            replace(d, inertia=o.inertia) for d, o in zip(self.duties, drums, strict=True)
        )
        return replace(self, station=station, duties=duties)

    def responses(self, lam: Complex) -> list[ArcResponse]:
        """Responses of the arcs."""
        return [p.response(lam) for p in self.profiles]

    def matrix(
        self, lam: Complex, responses: Sequence[ArcResponse] | None = None
    ) -> tuple[Complex, Complex, dict[str, Complex]]:
        """The equations at every lam.

        Returns
        -------
        matrix
            Of the unknowns T_0..T_n, q_i, omega_i, v_c, shape (k, N, N).
        forces
            Right sides for unit run-out of every drum [1/m], then unit torque on every drum, then
            unit relative change of every set speed, shape (k, N, 3 n).
        reports
            Rows that give moments and exit creeps, with their direct parts of the forces.
        """
        table, reports = self.table(lam, responses)
        size = table.shape[1]
        scale = np.max(np.abs(table[:, :, :size]), axis=(0, 2), keepdims=True)
        table = table / np.where(scale > 0.0, scale, 1.0)
        full = {key: value[..., :size] for key, value in reports.items()}
        full |= {f"{key} forces": value[..., size:] for key, value in reports.items()}
        return table[:, :, :size], -table[:, :, size:], full

    def table(
        self, lam: Complex, responses: Sequence[ArcResponse] | None = None
    ) -> tuple[Complex, dict[str, Complex]]:
        """The equations as they are, forces behind the unknowns; and the rows of reports.

        The equation of drum i is in row i - n of the n drums; its inertia is nowhere else.
        """
        lam = np.asarray(lam, dtype=complex)
        return _Assembly(self, lam, responses or self.responses(lam)).done()

    def determinant(self, lam: Complex, responses: Sequence[ArcResponse] | None = None) -> Complex:
        """Of the matrix, scaled; 0 at the roots."""
        m, _, _ = self.matrix(lam, responses)
        return np.asarray(np.linalg.det(m))

    def roots_beyond(self, real: float) -> int:
        """How many roots have a real part above a value [1/s], up to `HIGHEST`."""
        path, responses = _on_contour(self.profiles, real)
        return int(windings(self.determinant(path, responses)))

    @cached_property
    def rightmost(self) -> complex:
        """The root with the largest real part, or nan if it lies left of what is searched [1/s]."""
        low, high = self._left(), _RIGHT
        if self.roots_beyond(low) == 0:
            return complex(math.nan, math.nan)
        while high - low > 0.02:
            middle = 0.5 * (low + high)
            if self.roots_beyond(middle) > 0:
                low = middle
            else:
                high = middle
        line: Complex = np.asarray(
            0.5 * (low + high) + 1j * np.linspace(1e-6, 2.0 * math.pi * HIGHEST, 1200)
        )
        size = np.abs(self.determinant(line))
        # beside a root the determinant is small against what it is around it
        depth = np.log(size + 1e-300)
        calm = np.convolve(np.pad(depth, 40, mode="edge"), np.ones(81) / 81.0, mode="valid")
        order = np.argsort(depth - calm)
        for start in line[order[:5]]:
            root = self._polished(complex(start))
            if abs(root.real - 0.5 * (low + high)) < 0.2:
                return complex(root.real, abs(root.imag))
        return complex(line[order[0]])

    def _left(self) -> float:
        """Real part to search from: right of the poles of the controls' lags [1/s]."""
        lags = [getattr(d.control, "lag", 0.0) for d in self.station.drums]
        lags += [d.trim.filter_time for d in self.station.drums if d.trim is not None]
        return max([_LEFT, *(-0.9 / lag for lag in lags if lag > 0.0)])

    def _polished(self, z: complex) -> complex:
        """Secant steps on the determinant."""
        a, b = z, z + 1e-3
        fa, fb = (complex(self.determinant(np.array([v]))[0]) for v in (a, b))
        for _ in range(40):
            if fb == fa:
                break
            c = b - fb * (b - a) / (fb - fa)
            a, fa, b = b, fb, c
            fb = complex(self.determinant(np.array([b]))[0])
            if abs(b - a) < 1e-9 * (1.0 + abs(b)):
                break
        return b

    def forced(self, lam: Complex, kind: str, pulley: int) -> dict[str, Complex]:
        """Answers to a unit vibration.

        Parameters
        ----------
        lam
            Laplace variable, shape (k,) [1/s].
        kind
            ``run-out`` [per m], ``torque`` [per N m] or ``speed`` [per relative set speed].
        pulley
            The drum that it comes from.

        Returns
        -------
        Complex amplitudes: ``tension`` (k, n + 1) [N], ``moment`` (k, n) [N m], ``share`` (k, n),
        ``creep`` (k, n) [m].
        """
        n = len(self.duties)
        m, f, reports = self.matrix(lam)
        column = {"run-out": 0, "torque": n, "speed": 2 * n}[kind] + pulley
        x = np.linalg.solve(m, f[:, :, column, None])[..., 0]
        found = {
            what: np.einsum("kij,kj->ki", reports[what], x) + reports[f"{what} forces"][..., column]
            for what in ("moment", "creep")
        }
        arcs = [member.arc for member in self.steady.members]
        total = sum(a.effective_tension for a in arcs)
        shares = np.array([a.effective_tension / total for a in arcs])
        pull = x[:, :n] - x[:, 1 : n + 1]
        share = (pull - shares * pull.sum(axis=1, keepdims=True)) / total
        return {"tension": x[:, : n + 1], "share": share, **found}

    def share_by_speed(self, pulley: int) -> float:
        """Static d share/d ln omega of a drum, all speeds and outer tensions held [-]."""
        rigid = [replace(d, control=ExactSpeed(), trim=None) for d in self.station.drums]
        station = replace(self.station, drums=tuple(rigid), conveyor_mass=None, take_up="gravity")
        held = replace(self, station=station)
        found = held.forced(np.array([SLOWLY]), "speed", pulley)
        return float(found["share"][0, pulley].real)


class _Assembly:
    """Rows of the matrix, each a vector over the unknowns and the forces, for all lam at once."""

    def __init__(self, linear: Linear, lam: Complex, responses: Sequence[ArcResponse]) -> None:
        self.linear, self.lam, self.responses = linear, lam, responses
        self.n = n = len(linear.duties)
        self.size = 3 * n + 2
        self.k = len(lam)
        self.stretch = 1.0 / linear.station.train.belt.axial_stiffness

    def row(self, *parts: tuple[int, object]) -> Complex:
        """A quantity as its parts of the unknowns (and forces, behind them)."""
        out = np.zeros((self.k, self.size + 3 * self.n), complex)
        for place, value in parts:
            out[:, place] += value
        return out

    def done(self) -> tuple[Complex, dict[str, Complex]]:
        n, lam, station = self.n, self.lam, self.linear.station
        rows: list[Complex] = []
        slips = [self._slip(i) for i in range(n)]
        leaving, moments, creeps = [], [], []
        for i, (p, r) in enumerate(zip(self.linear.profiles, self.responses, strict=True)):
            t_in = self.row((i, 1.0))
            wave = np.exp(-lam * p.transit)
            arc = self.linear.steady.members[i].arc.arc
            arm = arc.radius + arc.offset
            rows.append(
                self.row((i + 1, 1.0))
                - r.out_by_in[:, None] * t_in
                - r.out_by_slip[:, None] * slips[i]
            )
            wrapped = r.wrapped_by_in[:, None] * t_in + r.wrapped_by_slip[:, None] * slips[i]
            lifted = self.row((self.size + i, p.speed / arm * (1.0 - wave)))
            leaving.append(self.row((n + 1 + i, 1.0)) + lam[:, None] * wrapped - lifted)
            moments.append(self._moment(i, wave))
            creeps.append(r.creep_by_in[:, None] * t_in + r.creep_by_slip[:, None] * slips[i])
        for i in range(n - 1):
            c = station.drums[i + 1].run * self.stretch
            rows.append(self.row((i + 1, lam * c), (n + 2 + i, -1.0)) + leaving[i])
        rows += self._ends(leaving[-1])
        rows += self._drums(moments)
        reports = {"moment": np.stack(moments, axis=1), "creep": np.stack(creeps, axis=1)}
        return np.stack(rows, axis=1), reports

    def _slip(self, i: int) -> Complex:
        """V c_hat of a drum."""
        n, d = self.n, self.linear.duties[i]
        p, member = self.linear.profiles[i], self.linear.steady.members[i]
        arc = member.arc.arc
        entry = member.arc.entry_tension
        squeeze = 2.0 * arc.compression_compliance / (arc.width * arc.diameter)
        c = member.arc.entry_creep_ratio + p.give * entry
        factor = 1.0 + p.give * entry - c
        flow = p.speed * (1.0 - member.arc.entry_creep_ratio) / (1.0 + entry * self.stretch)
        return self.row(
            (2 * n + 1 + i, factor * arc.pitch_radius),
            (i, p.speed * p.give - factor * d.speed * squeeze - flow * self.stretch),
            (n + 1 + i, -(1.0 + entry * self.stretch)),
            (self.size + i, factor * d.speed),
        )

    def _moment(self, i: int, wave: Complex) -> Complex:
        member = self.linear.steady.members[i]
        arc, entry, exit_ = member.arc.arc, member.arc.entry_tension, member.arc.exit_tension
        squeeze = 2.0 * arc.compression_compliance / (arc.width * arc.diameter)
        pull, kappa = entry - exit_, arc.recovery_compliance
        arm = arc.pitch_radius
        slope = arm * (1.0 + kappa * pull)
        by_in = slope - squeeze * pull * (1.0 + 0.5 * kappa * pull)
        lift = arc.centrifugal
        turned = entry - lift - (exit_ - lift) * wave
        return self.row((i, by_in), (i + 1, -slope), (self.size + i, turned))

    def _ends(self, leaving: Complex) -> list[Complex]:
        n, lam, station = self.n, self.lam, self.linear.station
        v = 3 * n + 1
        if station.conveyor_mass is None:
            return [self.row((0, 1.0)), self.row((n, 1.0)), self.row((v, 1.0))]
        carry, back = station.carry_run * self.stretch, station.return_run * self.stretch
        first = self.row((0, lam * carry), (n + 1, -1.0), (v, 1.0))
        last = self.row((n, 1.0))
        if station.take_up == "fixed":
            last = self.row((n, lam * back), (v, -1.0)) + leaving
        mass = self.row((v, lam * station.conveyor_mass), (0, -1.0), (n, 1.0))
        return [first, last, mass]

    def _drums(self, moments: list[Complex]) -> list[Complex]:
        n, lam, station = self.n, self.lam, self.linear.station
        total = sum(d.torque for d in self.linear.duties)
        whole = sum(moments)
        rows: list[Complex] = [moments[0]] * n
        torques: dict[int, Complex] = {}
        order = sorted(range(n), key=lambda i: isinstance(station.drums[i].control, Follower))
        for i in order:
            drum, duty = station.drums[i], self.linear.duties[i]
            omega = self.row((2 * n + 1 + i, 1.0))
            given = self.row((self.size + 2 * n + i, duty.speed))  # a change of the set speed
            if drum.trim is not None:
                k = drum.trim
                loop = k.gain * np.exp(-lam * k.dead_time) / (lam * (1.0 + lam * k.filter_time))
                share = (moments[i] - duty.torque / total * whole) / total
                given = given - duty.speed * loop[:, None] * share
            yields = np.broadcast_to(np.asarray(drum.control.yielding(duty, lam)), lam.shape)
            if np.any(np.isinf(yields)):
                rows[i] = omega - given
                torques[i] = moments[i]
                continue
            torque = -yields[:, None] * (omega - given)
            if isinstance(drum.control, Follower):
                lead = station.index(drum.control.master)
                ratio = drum.control.ratio
                if ratio is None:
                    ratio = duty.torque / self.linear.duties[lead].torque
                behind = np.asarray(drum.control.behind(lam))
                torque = torque + ratio * behind[:, None] * torques[lead]
            torques[i] = torque
            push = self.row((self.size + n + i, 1.0))
            rows[i] = (lam * drum.inertia)[:, None] * omega - torque - push + moments[i]
        # an integral makes a pole at 0, which would be counted as a root less
        integral = [d.trim is not None or isinstance(d.control, SpeedLoop) for d in station.drums]
        for i, drum in enumerate(station.drums):
            follows = isinstance(drum.control, Follower)
            lead = station.index(drum.control.master) if isinstance(drum.control, Follower) else i
            if integral[i] or (follows and integral[lead]):
                rows[i] = lam[:, None] * rows[i]
        return rows


@lru_cache(maxsize=48)
def _on_contour(
    profiles: tuple[SteadyProfile, ...], real: float
) -> tuple[Complex, list[ArcResponse]]:
    """A contour and the arcs' responses on it, which do not depend on how the drums are driven."""
    path = contour(real)
    return path, [p.response(path) for p in profiles]


def contour(real: float, points: int = _POINTS) -> Complex:
    """Upper half of a rectangle around what lies right of a line: up, right, down."""
    top = 2.0 * math.pi * HIGHEST
    up = real + 1j * top * np.linspace(1e-9, 1.0, points)
    along = np.linspace(real, _RIGHT + 5.0, 30) + 1j * top
    down = _RIGHT + 5.0 + 1j * top * np.linspace(1.0, 1e-9, 60)
    return np.concatenate([up, along[1:], down[1:]])


def windings(values: Complex) -> NDArrayInt:
    """How many zeros a contour (the last axis) encloses together with its mirror image."""
    turns = np.angle(values[..., 1:] / values[..., :-1])
    return np.asarray(np.rint(-np.sum(turns, axis=-1) / math.pi), dtype=np.int64)
