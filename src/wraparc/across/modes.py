"""Small deviations, mode by mode: the fast screening, and what wear makes of them.

About the even belt every mode cos(n pi (y/B + 1/2)) stands alone: with the slopes of the interface
along the even arc, tension, creep and label line of a mode obey

    t_n' = -(tau_u u_n + tau_p t_n/R + tau_h h_n) - S k_n^2 lag_n
    u_n' = a_n/R - t_n/M' - d(1/M')/dh T h_n ,

which is solved for a unit of each cause at once.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from wraparc.across.compiled import quickest
from wraparc.across.interface import stress_of
from wraparc.across.march import step
from wraparc.across.mesh import Mesh, mesh_of
from wraparc.across.newton import System, newton, started
from wraparc.across.wide_arc import Array, WideArc
from wraparc.arc import ArcResult, Distributed
from wraparc.errors import ConvergenceError

#: what makes a belt uneven: radius alone, lagging (radius and thickness), free profile of the
#: entry tension, misfit of the path at entry and exit
CAUSES = ("radius", "lagging", "entry_profile", "entry_misfit", "exit_misfit")
# columns that a piece of the arc is carried with: its tension and creep at its start, the offset of
# the label line, a drift of the creep rate, and the thickness
_TENSION, _CREEP, _OFFSET, _DRIFT, _THICKNESS = range(5)


@dataclass(frozen=True, eq=False)
class ModeResponse:
    """What a unit of each cause does to each mode, arrays of shape (modes, causes).

    Attributes
    ----------
    entry_tension, exit_tension
        t1_n and t2_n by amplitude of the cause [N/m per m, or per N/m].
    exit_creep
        u_n at the exit [m per m, or per N/m].
    energy
        e_n [J/m2 per m, or per N/m].
    mean_energy
        Frictional energy of the even belt [J/m2].
    """

    entry_tension: Array
    exit_tension: Array
    exit_creep: Array
    energy: Array
    mean_energy: float

    @property
    def levelling_depth(self) -> Array:
        """D_n = mean(e)/(d e_n/d h_n): mean wear over which a mode falls by 2.72 [m].

        Negative where wear makes it grow; free of the wear coefficient. Shape (modes,).
        """
        return np.asarray(self.mean_energy / self.energy[:, CAUSES.index("lagging")])

    def stationary_lagging(self, cause: str) -> Array:
        """Amplitude h_n that wear ends at under a unit of a lasting cause, shape (modes,) [m].

        The shape that wears evenly, h_n = -(d e_n/d cause)/(d e_n/d h_n); it is reached only where
        the levelling depth is positive.
        """
        lagging = self.energy[:, CAUSES.index("lagging")]
        return np.asarray(-self.energy[:, CAUSES.index(cause)] / lagging)


@dataclass(frozen=True)
class _Slopes:
    """The even arc at one place: state, stress, and what they depend on."""

    tension: float
    creep_rate: float
    stress: float
    by_creep: float
    by_tension: float
    by_thickness: float


def mode_response(
    wide: WideArc, modes: int = 16, steps: int = 48, *, even: ArcResult | None = None
) -> ModeResponse:
    """Return what small deviations do, by mode.

    Parameters
    ----------
    wide
        The arc; its deviations are left out, its spans and its belt count.
    modes
        How many modes, fewer than strips.
    steps
        Mesh steps over the arc.
    even
        The even belt, if it is solved already.

    Raises
    ------
    ConvergenceError
        If the even belt is not carried.
    """
    even = even or Distributed(capacities=False).solve(wide.arc)
    if not even.status.solved:
        raise ConvergenceError(str(even.status))
    return _Modes(wide, even, min(modes, wide.strips - 1), steps).response()


@dataclass(frozen=True)
class _Modes:
    wide: WideArc
    even: ArcResult
    count: int
    steps: int

    def response(self) -> ModeResponse:
        wide, arc = self.wide, self.wide.arc
        k2 = wide.shear_stiffness * wide.wave_numbers[: self.count] ** 2
        states, drum, mesh = self._even_states()
        pieces, energy, end_state = [], 0.0, states[0]
        for start, last, state in zip(mesh.cuts, mesh.cuts[1:], states, strict=False):
            piece, end_state, work = self._carried(state, drum, k2, mesh.nodes[start : last + 1])
            pieces.append(piece)
            energy += work
        first, end = self._slopes(states[0], drum), self._slopes(end_state, drum)
        shear = arc.shear_compliance
        energy -= 0.5 * shear * (end.stress**2 - first.stress**2)
        return self._closed(np.array(pieces), states[0][0], first, end, energy)

    def _even_states(self) -> tuple[list[Array], float, Mesh]:
        """The even belt at the cuts of the mesh: one strip, solved like many."""
        one = _even_strip(self.wide)
        mesh = mesh_of(self.wide, self.even, self.steps)
        system = System(one, mesh, quickest())
        found = newton(system, started(one, self.even, mesh))
        if not found.solved:
            raise ConvergenceError("the even belt was not solved across its cuts")
        at = found.unknowns
        kick, _ = one.overrun(at.tension)
        return [np.array([at.tension[0], kick[0]]), *at.states], at.drum, found.system.mesh

    def _slopes(self, state: Array, drum: float) -> _Slopes:
        arc = self.wide.arc
        t, u = float(state[0]), float(state[1])
        found = stress_of(arc.law.compact(), arc.shear_compliance, u, t / arc.radius)
        compliance = 1.0 / self.wide.belt_modulus
        rate = drum - t * compliance
        give = self._give
        rate -= (t if arc.recovery else arc.entry_tension / arc.width) * give
        return _Slopes(
            t,
            rate,
            found.stress,
            found.by_creep,
            found.by_pressure / arc.radius,
            -found.stress * found.by_creep / arc.shear_modulus,
        )

    @cached_property
    def _give(self) -> float:
        """h/(R^2 E_c) of the even lagging [m/N]."""
        arc = self.wide.arc
        return arc.compression_compliance / arc.radius**2

    @cached_property
    def _give_by_thickness(self) -> float:
        """Its derivative by the thickness, E_c following the shape of the blocks [1/N]."""
        arc, lagging = self.wide.arc, self.wide.lagging
        if arc.thickness == 0.0 or math.isinf(arc.compression_modulus):
            return 0.0
        h = arc.thickness * np.array([1.0 - 1e-4, 1.0 + 1e-4])
        modulus = np.full(2, arc.compression_modulus)
        if lagging is not None:
            modulus = lagging.compression_modulus_at(h)
        low, high = h / (arc.radius**2 * modulus)
        return float((high - low) / (h[1] - h[0]))

    def _carried(
        self, state: Array, drum: float, k2: Array, nodes: Array
    ) -> tuple[Array, Array, float]:
        """Carry the columns over a piece: (3, modes, 5) at its end, the state, the energy."""
        n = len(k2)
        columns = np.zeros((3, n, 5))  # tension, creep, energy
        columns[0, :, _TENSION] = columns[1, :, _CREEP] = 1.0
        y = np.concatenate([state, [0.0], columns.ravel()])

        def slopes(at: Array) -> Array:
            return self._rates(at, drum, k2)

        for i in range(len(nodes) - 1):
            y = step(slopes, y, float(nodes[i + 1] - nodes[i]))
        return y[3:].reshape(3, n, 5), y[:2], float(y[2])

    def _rates(self, at: Array, drum: float, k2: Array) -> Array:
        even, wide = self._slopes(at[:2], drum), self.wide
        tension, creep, _ = at[3:].reshape(3, len(k2), 5)
        out = np.empty(len(at))
        out[0], out[1] = -even.stress, even.creep_rate
        out[2] = even.stress * even.creep_rate
        stress = even.by_creep * creep + even.by_tension * tension
        stress[:, _THICKNESS] += even.by_thickness
        lag = creep.copy()
        lag[:, _OFFSET] += 1.0
        recovery = self._give if wide.arc.recovery else 0.0
        creep_rate = -(1.0 / wide.belt_modulus + recovery) * tension
        creep_rate[:, _DRIFT] += 1.0
        if wide.arc.recovery:
            creep_rate[:, _THICKNESS] -= even.tension * self._give_by_thickness
        rows = out[3:].reshape(3, len(k2), 5)
        rows[0] = -stress - k2[:, None] * lag
        rows[1] = creep_rate
        rows[2] = stress * even.creep_rate + even.stress * creep_rate
        return out

    def _closed(
        self, pieces: Array, entry: float, first: _Slopes, end: _Slopes, mean: float
    ) -> ModeResponse:
        """Solve the ends of the arc for every mode and cause."""
        count, last = self.count, len(pieces) - 1
        tables = np.zeros((4, count, len(CAUSES)))
        for n in range(count):
            for j, cause in enumerate(CAUSES):
                starts, given = self._mode(pieces[:, :, n], n, cause, entry)
                full = [np.concatenate([s, given]) for s in starts]
                t2, u2, _ = pieces[last, :, n] @ full[last]
                work = sum(float(pieces[k, 2, n] @ full[k]) for k in range(last + 1))
                h = given[2]
                tau1 = first.by_creep * starts[0][1] + first.by_tension * starts[0][0]
                tau2 = end.by_creep * u2 + end.by_tension * t2
                tau1, tau2 = tau1 + first.by_thickness * h, tau2 + end.by_thickness * h
                arc = self.wide.arc
                work -= arc.shear_compliance * (end.stress * tau2 - first.stress * tau1)
                work -= 0.5 * h / arc.shear_modulus * (end.stress**2 - first.stress**2)
                tables[:, n, j] = starts[0][0], t2, u2, work
        return ModeResponse(tables[0], tables[1], tables[2], tables[3], mean)

    def _mode(self, pieces: Array, n: int, cause: str, entry: float) -> tuple[list[Array], Array]:
        """States at the starts of the pieces, and offset, drift and thickness, of one mode."""
        wide, arc, m = self.wide, self.wide.arc, self.wide.belt_modulus
        before, after = float(wide.length_before[n]), float(wide.length_after[n])
        on = {key: float(key == cause) for key in CAUSES}
        h = on["lagging"]
        # per unit of t1: creep at the nip, offset of the label line, drift
        kick = _kick_slope(arc.overrun, arc.entry_overrun, entry)
        kick_h = 0.0
        if arc.overrun is None and self._give > 0.0:
            kick_h = 1.5 * arc.entry_overrun * self._give_by_thickness / self._give * h
        lag_t, lag_0 = -before / m, on["entry_misfit"] + before / m * on["entry_profile"]
        drift_t, drift_0 = 0.0, (on["radius"] + h) / arc.radius
        if not arc.recovery:
            drift_t, drift_0 = -self._give, drift_0 - entry * self._give_by_thickness * h
        by = np.zeros((5, 2))  # columns of the piece by (1, t1)
        by[_TENSION, 1] = 1.0
        by[_CREEP] = kick_h, kick
        by[_OFFSET] = lag_0 - kick_h, lag_t - kick
        by[_DRIFT] = drift_0, drift_t
        by[_THICKNESS, 0] = h
        size = 1 + 2 * (len(pieces) - 1)
        a, b = np.zeros((size, size)), np.zeros(size)
        for k, piece in enumerate(pieces):
            # end of the piece: constant, by t1, by its own start
            forced = piece[:2] @ (by if k == 0 else np.vstack([np.zeros((2, 2)), by[2:]]))
            own = slice(2 * k - 1, 2 * k + 1)
            rows = np.zeros((2, size))
            rows[:, 0] = forced[:, 1]
            if k > 0:
                rows[:, own] = piece[:2, :2]
            if k < len(pieces) - 1:
                at = slice(2 * k + 1, 2 * k + 3)
                rows[:, at] -= np.eye(2)
                a[at], b[at] = rows, -forced[:, 0]
                continue
            # E1 + E2 + u(L) - u(0) + (Lam1 (f - t1) - Lam2 t2)/M = 0
            a[0] = rows[1] - after / m * rows[0]
            a[0, 0] -= kick + before / m
            b[0] = -(forced[1, 0] - after / m * forced[0, 0] - kick_h)
            b[0] -= on["entry_misfit"] + on["exit_misfit"] + before / m * on["entry_profile"]
        found = np.linalg.solve(a, b)
        given = by @ np.array([1.0, found[0]])
        starts = [given[:2], *(found[2 * k - 1 : 2 * k + 1] for k in range(1, len(pieces)))]
        return starts, given[2:]


def _kick_slope(given: float | None, overrun: float, tension: float) -> float:
    """Derivative of the overrun by the entry tension [m2/N]."""
    return 0.0 if given is not None else 1.5 * overrun / tension


def _even_strip(wide: WideArc) -> WideArc:
    """One even strip of an arc."""
    arc, none, no_modes = wide.arc, np.zeros(1), np.zeros(0)
    return replace(
        wide,
        radius_deviation=none,
        thickness=np.full(1, arc.thickness),
        compression_modulus=np.full(1, arc.compression_modulus),
        entry_profile=none,
        entry_misfit=none,
        exit_misfit=none,
        length_before=no_modes,
        length_after=no_modes,
        static_profile=None,
        transition=None,
    )
