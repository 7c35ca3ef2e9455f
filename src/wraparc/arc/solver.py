"""The main solver: creep distributed along the arc."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from wraparc.arc.kernel.answer import (
    CAPACITIES,
    Answer,
    Carried,
    answer,
    at_gross_slip,
    find_capacities,
    profile_of,
    profile_size,
)
from wraparc.arc.kernel.quantities import BREAKAWAY, RECORD, SOLVED, Buffer, Shot, zeros
from wraparc.arc.profile import active_length, peak_stress, share_outside
from wraparc.arc.result import ArcResult, Array, Capacities, Energy, Profile, Status
from wraparc.arc.wrap_arc import WrapArc

nan = math.nan
STATUS = {SOLVED: Status.SOLVED, BREAKAWAY: Status.BREAKAWAY}


@dataclass(frozen=True)
class Distributed:
    """Creep distributed along the arc, slip as the state, one root in the entry creep ratio.

    Attributes
    ----------
    steps
        Mesh steps over the arc; 24 keep exit creep, slip and peak shear within 1e-5.
    points
        Equal parts of the wrap at which the profile is given, besides kinks and, where a kick is
        used up, the mesh nodes in front of the point of no slip.
    capacities
        Whether the three capacities are found too.
    """

    steps: int = 24
    points: int = 180
    capacities: bool = True

    @property
    def name(self) -> str:
        """Name in files and reports."""
        return "distributed"

    def solve(self, arc: WrapArc) -> ArcResult:
        """Solve one arc.

        Raises
        ------
        InputError
            If the law is unfit for the arc, see `WrapArc`.
        """
        law, geometry, load = arc.law.compact(), arc.geometry(), arc.load()
        found = answer(law, geometry, load, self.steps)
        if found.outcome == BREAKAWAY:
            found = at_gross_slip(law, geometry, load, self.steps)
        out = zeros(profile_size(law, found, self.points))
        shot, count = profile_of(law, found, arc.exit_tension, self.points, out)
        capacities = Capacities()
        if self.capacities:
            carried = find_capacities(law, geometry, load, CAPACITIES, self.steps)
            capacities = capacities_of(arc, carried)
        return result_of(self.name, arc, found._replace(shot=shot), out, count, capacities)


def capacities_of(arc: WrapArc, carried: Carried) -> Capacities:
    """Capacities and margins as an engineer reads them."""
    actual = max(arc.entry_tension, arc.exit_tension)
    actual /= min(arc.entry_tension, arc.exit_tension)
    creep, slip, gross = map(math.exp, carried[:3])
    return Capacities(
        creep_limit_capacity=creep,
        creep_limit_margin=creep / actual,
        equivalent_friction=math.log(creep) / arc.wrap_angle,
        least_exit_tension=carried.least_slack,
        largest_effective_tension=carried.most_pull,
        tested_slip_capacity=slip,
        tested_slip_margin=slip / actual,
        gross_slip_capacity=gross,
        gross_slip_margin=gross / actual,
        gross_slip_creep=carried.gross_creep,
    )


def result_of(
    method: str,
    arc: WrapArc,
    found: Answer,
    out: Buffer,
    count: int,
    capacities: Capacities,
) -> ArcResult:
    """Return the result of an arc that the kernel has solved and traced."""
    par, shot = found.par, found.shot
    q, slip, creep, _, _, g, zone = shot
    status = STATUS.get(found.outcome, Status.UNSOLVED)
    entry = par.entry_tension  # on breakaway of a braking pulley the exit tension is the one held
    exit_tension = entry * math.exp(q)
    peak, where = peak_stress(out, count)
    tested = arc.law.tested
    outside = nan
    if tested is not None:
        outside = share_outside(
            par, out, count, tested.pressure_min, tested.pressure_max, tested.slip_max
        )
    overrun = par.kick
    distributed = creep - overrun - g * arc.length
    pull = entry - exit_tension
    recovery = arc.recovery_compliance / arc.compliance if arc.compliance > 0.0 else 0.0
    return ArcResult(
        status=status,
        method=method,
        arc=arc,
        profile=_profile(arc, entry, out, count, zone),
        entry_tension=entry,
        exit_tension=arc.exit_tension if status is Status.SOLVED else exit_tension,
        exit_creep=creep,
        creep_shrinkage=(1.0 - recovery) * distributed,
        creep_compression=recovery * distributed + overrun,
        creep_global=g * arc.length,
        exit_slip=slip,
        entry_creep_ratio=g,
        exit_creep_ratio=g + pull * arc.compliance,
        peak_shear_stress=peak,
        peak_shear_angle=math.atan(peak / arc.shear_modulus),
        peak_shear_position=where / arc.radius,
        mean_friction=abs(q) / arc.wrap_angle,
        active_arc=active_length(out, count) / arc.radius,
        outside_tested_share=outside,
        stuck_arc=zone / arc.radius,
        capacities=capacities,
        energy=_energy(arc, g, pull, shot, out[4]),
    )


def _profile(arc: WrapArc, entry_tension: float, out: Buffer, count: int, zone: float) -> Profile:
    rows: Array = np.array(out[: RECORD * count]).reshape(count, RECORD)
    s, q, slip, creep, tau = rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3], rows[:, 4]
    tension = entry_tension * np.exp(q)
    pressure = 2.0 * tension / (arc.width * arc.diameter)
    # a stuck belt has the friction of vanishing slip available
    sliding = ((s > zone) | (zone == 0.0)) & ((slip != 0.0) | (tau == 0.0))
    tiny = np.copysign(1e-300, np.where(tau == 0.0, arc.side, tau))
    friction = arc.law.friction(np.where(sliding, slip, tiny), pressure)
    return Profile(
        position=s / arc.radius,
        tension=tension,
        wrap_pressure=pressure,
        friction=friction,
        friction_used=tau / pressure,
        slip=slip,
        creep=creep,
        shear_stress=tau,
        shear_angle=np.arctan(tau / arc.shear_modulus),
        sliding=sliding.astype(float),
    )


def _energy(arc: WrapArc, g: float, pull: float, shot: Shot, entry_stress: float) -> Energy:
    """Loss and wear of a solved arc, per second where the belt speed is known."""
    _, _, _, stress, work, _, _ = shot
    shear = 0.5 * arc.shear_compliance * (stress * stress - entry_stress * entry_stress)
    exact = pull * (g + 0.5 * pull * arc.compliance)
    miss = arc.width * (work + shear) - exact
    # at a breakaway the surface may run away from the belt altogether
    speed = nan if arc.belt_speed is None or g >= 1.0 else arc.belt_speed / (1.0 - g)
    power, loss = speed * pull, speed * arc.width * (work + shear)
    efficiency = nan
    if abs(pull) > 1e-6 * arc.entry_tension:
        part = arc.width * (work + shear) / abs(pull)
        efficiency = 1.0 - part if pull > 0.0 else 1.0 / (1.0 + part)
    wear = nan
    if arc.wear_coefficient is not None:
        wear = 1e6 * arc.wear_coefficient * work
    return Energy(
        transmitted_power=power,
        sliding_power=speed * arc.width * work,
        shear_loss=speed * arc.width * shear,
        power_loss=loss,
        efficiency=efficiency,
        frictional_energy=work,
        wear_rate=wear,
        identity_error=abs(miss) / max(abs(exact), 1e-6 * arc.entry_tension * abs(g), 1e-300),
    )
