"""Small deviations, mode by mode: the fast screening, and what wear makes of them.

About the even belt every mode cos(n pi (y/B + 1/2)) stands alone: with the slopes of the interface
along the even arc, tension, creep and label line of a mode obey

    t_n' = -(tau_u u_n + tau_p t_n/R + tau_h h_n) - S k_n^2 lag_n
    u_n' = a_n/R - t_n/M' - d(1/M')/dh T h_n ,

by collocation (`wraparc.across.collocation`), solved for a unit of each cause at once.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from wraparc.across.collocation import Found, Point, System, along, between, newton, started
from wraparc.across.elements import Elements, graded
from wraparc.across.stresses import FINENESS, Law, pieces, stresses
from wraparc.across.wide_arc import WideArc
from wraparc.arc import ArcResult, Distributed
from wraparc.arrays import Array
from wraparc.errors import ConvergenceError

#: what makes a belt uneven: radius alone, lagging (radius and thickness), free profile of the
#: entry tension, misfit of the path at entry and exit
CAUSES = ("radius", "lagging", "entry_profile", "entry_misfit", "exit_misfit")
#: elements over the arc; how often kinks of the friction law are sought, at so many places, and in
#: so many halvings then
_ELEMENTS, _TIMES, _LOOKS, _HALVINGS = 24, 2, 400, 30


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


class _Cause(NamedTuple):
    """What a unit of each cause does to one mode where its tension stays, arrays by cause.

    Attributes
    ----------
    thickness
        h [m].
    overrun
        Creep at the entry nip [m].
    rate
        Creep per length along the arc, shape (k, causes) [-].
    lag, path, free
        Lag of the label line at the entry [m], the path [m], the free profile [N/m].
    """

    thickness: Array
    overrun: Array
    rate: Array
    lag: Array
    path: Array
    free: Array


def mode_response(wide: WideArc, modes: int = 16, *, even: ArcResult | None = None) -> ModeResponse:
    """Return what small deviations do, by mode.

    Parameters
    ----------
    wide
        The arc; its deviations are left out, its spans and its belt count.
    modes
        How many modes, fewer than strips.
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
    count = min(modes, wide.strips - 1)
    nodes = graded(wide.arc.length, _ELEMENTS)
    fineness = FINENESS if Law.of(wide.arc.law.compact()).bends else 1
    system = System(_even(wide, 1), Elements(nodes, fineness))
    found = newton(system, started(system, even))
    for _ in range(_TIMES):  # with an element's end where the law goes from piece to piece
        elements = Elements(np.union1d(nodes, _kinks(found)))
        found = newton(replace(system, elements=elements), between(found, elements.stages))
    if not found.solved:
        raise ConvergenceError("the even belt was not solved")
    return _response(replace(found.system, wide=_even(wide, count + 1)), found.point)


def _kinks(found: Found) -> Array:
    """Places where the even belt goes from one piece of its friction law to the next [m]."""
    system, wide = found.system, found.system.wide

    def piece(places: Array) -> NDArray[np.intp]:
        creep, tension = (v[:, :1] for v in along(found, places))
        return pieces(system.law, wide.shear[:1], creep, wide.pressure(tension))[:, 0]

    grid = graded(wide.arc.length, _LOOKS)
    own = piece(grid)
    at = np.flatnonzero(own[1:] != own[:-1])
    low, high, first = grid[at], grid[at + 1], own[at]
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        before = piece(middle) == first
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return high


def _response(system: System, even: Point) -> ModeResponse:
    """Solve for every mode and cause about the even belt."""
    wide, e, arc = system.wide, system.elements, system.wide.arc
    tension = e.at_points(even.state.tension[:, :1])[:, 0]
    stress = [v[:, :1] for v in even.stress]
    by_thickness = -stress[0] * stress[1] / arc.shear_modulus
    couple = -wide.shear_stiffness * wide.wave_numbers**2
    _, overrun_t = (float(v[0]) for v in wide.overrun(even.state.entry))
    squeeze, unit = float(system.squeeze[0]), float(wide.compliance_in_wrap[0])
    matrices = system.modal(even)[1:]
    tables = np.empty((4, len(couple), len(CAUSES)))
    for n, (matrix, k) in enumerate(zip(matrices, couple, strict=True)):
        before, after = wide.length_before[n], wide.length_after[n]
        cause = _cause(wide, before / wide.belt_modulus, float(even.state.entry[0]), tension)
        risen = e.integral(cause.rate, e.points)
        # where the tension of the mode stays: creep, what pulls it, what is missed then
        creep = cause.overrun + risen
        share = wide.pulled_share
        pulled = k * (risen + cause.lag)
        pulled -= share * (stress[1] * creep + by_thickness * cause.thickness)
        path = cause.path + e.total(cause.rate)
        last = wide.belt_modulus * path + before * cause.free - after * e.total(pulled)
        last /= before + after + arc.length
        z = -np.linalg.solve(matrix, np.vstack([-e.integral_at_stages(pulled), last]))
        own, first = e.at_points(z[:-1]), z[-1]
        creep += (overrun_t - squeeze * e.points[:, None]) * first
        creep -= unit * e.integral_at_points(z[:-1])
        shear = stress[1] * creep + stress[2] / arc.radius * own + by_thickness * cause.thickness
        lag = creep - cause.overrun + cause.lag - (before / wide.belt_modulus + overrun_t) * first
        end = first + e.total(k * lag - share * shear)
        rate = cause.rate - squeeze * first - unit * own
        creep_end = cause.overrun + overrun_t * first + e.total(rate)
        work = e.total(shear * _rate(system, even) + stress[0] * rate)
        nips = (
            np.array([cause.overrun + overrun_t * first, creep_end]),
            np.array([first, end]),
        )
        tables[:, n] = first, end, creep_end, work - _kept(system, even, cause.thickness, *nips)
    energy = float(e.total(stress[0] * _rate(system, even))[0])
    ends = _ends(system, even)[0]
    energy -= 0.5 * arc.shear_compliance * float(ends[1] ** 2 - ends[0] ** 2)
    return ModeResponse(tables[0], tables[1], tables[2], tables[3], energy)


def _rate(system: System, even: Point) -> Array:
    """Creep per length of the even belt at the points, shape (k, 1) [-]."""
    tension = system.elements.at_points(even.state.tension)
    return (system.drift(even.state) - system.wide.compliance_in_wrap * tension)[:, :1]


def _ends(system: System, even: Point) -> Array:
    """Stress at entry and exit with its slopes, and slip, shape (4, 2)."""
    wide = system.wide
    overrun, _ = wide.overrun(even.state.entry)
    creep = np.array([overrun[0], even.creep_end[0]])
    tension = np.array([even.state.entry[0], even.tension_end[0]])
    return np.array(stresses(system.law, wide.shear[:1], creep, wide.pressure(tension)))


def _kept(system: System, even: Point, thickness: Array, creep: Array, tension: Array) -> Array:
    """How the energy that the lagging keeps in shear changes, by cause [J/m2]."""
    arc = system.wide.arc
    stress, by_creep, by_pressure, _ = _ends(system, even)[:, :, None]
    by_thickness = -stress * by_creep / arc.shear_modulus
    change = by_creep * creep + by_pressure / arc.radius * tension + by_thickness * thickness
    kept = arc.shear_compliance * stress * change
    kept += 0.5 * thickness / arc.shear_modulus * stress**2
    return np.asarray(kept[1] - kept[0])


def _cause(wide: WideArc, before: float, entry: float, tension: Array) -> _Cause:
    """What a unit of each cause does; `before` is Lam1/M of the mode, tension at the points."""
    arc = wide.arc
    on = {key: np.array([float(key == c) for c in CAUSES]) for key in CAUSES}
    thickness = on["lagging"]
    give, by_thickness = float(wide.give[0]), _give_by_thickness(wide)
    overrun = np.zeros(len(CAUSES))
    if arc.overrun is None and give > 0.0:
        overrun = 1.5 * arc.entry_overrun * by_thickness / give * thickness
    softer = (tension if arc.recovery else np.full_like(tension, entry)) - wide.lift
    rate = (on["radius"] + thickness) / wide.pitch - np.outer(softer, by_thickness * thickness)
    lag = on["entry_misfit"] + before * on["entry_profile"]
    path = on["entry_misfit"] + on["exit_misfit"]
    return _Cause(thickness, overrun, rate, lag, path, on["entry_profile"])


def _give_by_thickness(wide: WideArc) -> float:
    """Derivative of h/(R^2 E_c) by the thickness, E_c following the shape of the blocks [1/N]."""
    arc, lagging = wide.arc, wide.lagging
    if arc.thickness == 0.0 or math.isinf(arc.compression_modulus):
        return 0.0
    h = arc.thickness * np.array([1.0 - 1e-4, 1.0 + 1e-4])
    modulus = np.full(2, arc.compression_modulus)
    if lagging is not None:
        modulus = lagging.compression_modulus_at(h)
    low, high = h / (arc.radius**2 * modulus)
    return float((high - low) / (h[1] - h[0]))


def _even(wide: WideArc, strips: int) -> WideArc:
    """The arc without its deviations, in fewer strips."""
    arc, none = wide.arc, np.zeros(strips)
    return replace(
        wide,
        radius_deviation=none,
        thickness=np.full(strips, arc.thickness),
        compression_modulus=np.full(strips, arc.compression_modulus),
        entry_profile=none,
        entry_misfit=none,
        exit_misfit=none,
        length_before=wide.length_before[: strips - 1],
        length_after=wide.length_after[: strips - 1],
        static_profile=None,
        transition=None,
    )
