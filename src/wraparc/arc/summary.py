"""One arc from its description to its reported numbers: plain floats and buffers only.

`Distributed` makes its result of them; the page of the calculator runs them translated, while a
slider moves.
"""

from __future__ import annotations

from math import atan, copysign, exp, log, nan, sqrt
from typing import NamedTuple

from wraparc.arc.answer import Answer, operating_point
from wraparc.arc.capacity import Carried
from wraparc.arc.collocation import overrun_at
from wraparc.arc.profile import RECORD, Range, read, records
from wraparc.arc.quantities import SOLVED, Buffer, Geometry, Load, jumps, zeros
from wraparc.arc.traction import held_stress
from wraparc.arrays import Number
from wraparc.drive.pitch import thin_belt
from wraparc.friction import TestedRange
from wraparc.friction.compact import CompactLaw, branch_of, friction_at, segment_of

#: Overrun by formula over delta sqrt(delta/R) [-].
OVERRUN = 1.25
#: Active arc and exit creep of a pulley that idles: less is rounding [m].
IDLE = 1e-9
#: Slip in the direction of the stress that a stuck belt has in front of it [m].
NEXT_SLIP = 1e-300


class Description(NamedTuple):
    """What an arc is, as `WrapArc` has it; nan where it has nothing."""

    entry_tension: float  # T1 [N]
    exit_tension: float  # T2 [N]
    diameter: float  # D [m]
    wrap_angle: float  # phi [rad]
    width: float  # B [m]
    axial_stiffness: float  # EA [N]
    thickness: float  # h [m]
    shear_modulus: float  # G [Pa]
    compression_modulus: float  # E_c [Pa]
    overrun: float  # x_c [m], nan by formula
    recovery: bool
    belt_speed: float  # [m/s]
    wear_coefficient: float  # [m3/J]
    shear_compliance: float  # of lagging and cover [m/Pa]
    pitch_offset: float  # e [m]
    centrifugal: float  # m v^2 [N]


def overrun_coefficient(compliance: Number, radius: Number) -> Number:
    """Overrun by formula over the entry pressure to the power 1.5 [m/Pa^1.5].

    x_c = 1.25 delta sqrt(delta/R) with the compression delta = (h/E_c) p1 of the lagging.

    Parameters
    ----------
    compliance
        h/E_c [m/Pa], >= 0.
    radius
        R over the unloaded lagging [m], > 0.
    """
    found: Number = OVERRUN * compliance**1.5 / radius**0.5
    return found


def recovery_compliance(arc: Description) -> float:
    """Extra compliance kappa = 2 h/(B D R E_c), from the recovery of the lagging [1/N]."""
    if not arc.recovery:
        return 0.0
    squeeze = arc.thickness / arc.compression_modulus
    return 2.0 * squeeze / (arc.width * arc.diameter * (0.5 * arc.diameter))


def geometry_of(arc: Description) -> Geometry:
    """Numbers of the arc for the solver.

    They are those of the arc without thickness that is the same, see `wraparc.drive.pitch`; its
    tensions are those above m v^2.
    """
    radius = 0.5 * arc.diameter
    pitch, wrap, width = thin_belt(radius, arc.wrap_angle, arc.width, arc.pitch_offset)
    given = arc.overrun == arc.overrun
    by_formula = overrun_coefficient(arc.thickness / arc.compression_modulus, radius)
    return Geometry(
        1.0 if arc.entry_tension >= arc.exit_tension else -1.0,
        pitch,
        wrap,
        width,
        1.0 / arc.axial_stiffness + recovery_compliance(arc),
        arc.shear_compliance,
        arc.overrun if given else 0.0,
        0.0 if given else by_formula,
        None,
    )


def too_steep(arc: Description, fall: float) -> bool:
    """Whether friction falls so steeply that slip and shear of the lagging are not unique."""
    tight = max(arc.entry_tension, arc.exit_tension)
    return arc.shear_compliance * pressure_of(arc, tight) * fall <= -1.0


def pressure_of(arc: Description, tension: float) -> float:
    """Wrap pressure at a tension [N], 2 (T - m v^2)/(B D) [Pa]."""
    return 2.0 * (tension - arc.centrifugal) / (arc.width * arc.diameter)


def held_creep(law: CompactLaw, shear: float, pressure: float) -> float:
    """Creep up to which a law that jumps holds the belt without slip at a pressure [m]."""
    return (shear + law.onset_compliance) * held_stress(law, pressure)


def overrun_loosens(law: CompactLaw, geometry: Geometry, pressure: float) -> bool:
    """Whether the overrun is more than a law that jumps holds: no creep at rest is unique then."""
    if not jumps(law):
        return False
    overrun = abs(
        geometry.overrun_constant + geometry.overrun_coefficient * pressure * sqrt(pressure)
    )
    return overrun > 0.0 and overrun > held_creep(law, geometry.shear, pressure)


def solved_arc(
    law: CompactLaw, geometry: Geometry, load: Load, points: int
) -> tuple[Answer, Buffer, int]:
    """Solution of an arc with its profile and the number of records; none where it has none."""
    found = operating_point(law, geometry, load.entry_tension, load.exit_tension)
    if found.outcome != SOLVED:
        return found, zeros(0), 0
    out, count = records(geometry, found.met, points)
    return found, out, count


def range_of(tested: TestedRange | None) -> Range:
    """A tested range as numbers, nan without one."""
    if tested is None:
        return Range(nan, nan, nan)
    return Range(tested.pressure_min, tested.pressure_max, tested.slip_max)


class Summary(NamedTuple):
    """Every reported number of an arc but its capacities and its interval; see `ArcResult`."""

    entry_tension: float
    exit_tension: float
    effective_tension: float
    tension_ratio: float
    exit_creep: float
    creep_shrinkage: float
    creep_compression: float
    creep_global: float
    exit_slip: float
    entry_creep_ratio: float
    exit_creep_ratio: float
    peak_shear_stress: float
    peak_shear_angle: float
    peak_shear_position: float
    mean_friction: float
    active_arc: float
    k_factor: float
    outside_tested_share: float
    stuck_arc: float
    transmitted_power: float
    sliding_power: float
    shear_loss: float
    power_loss: float
    efficiency: float
    frictional_energy: float
    wear_rate: float
    identity_error: float


def spring_rate(axial_stiffness: float, length: float, creep: float) -> float:
    """Spring rate of the belt over its active arc, EA/l [N/m]; nan of an idle pulley.

    Of its active arc and its exit creep nothing but rounding is left, below `IDLE`.
    """
    return axial_stiffness / length if length > IDLE and abs(creep) > IDLE else nan


def summary_of(
    geometry: Geometry, arc: Description, tested: TestedRange | None, found: Answer
) -> Summary:
    """Reported numbers of an arc that is solved; nan where there is none.

    An arc that is not solved has the tensions asked for, and no number of a state.
    """
    if found.outcome != SOLVED:
        return _asked_alone(arc)
    entry, exit_tension, radius = arc.entry_tension, arc.exit_tension, 0.5 * arc.diameter
    told = read(geometry, found.met, range_of(tested))
    pull, g, length = entry - exit_tension, told.creep_ratio, radius * arc.wrap_angle
    kappa = recovery_compliance(arc)
    compliance = 1.0 / arc.axial_stiffness + kappa
    recovery = kappa / compliance if compliance > 0.0 else 0.0
    overrun = overrun_at(geometry, entry - arc.centrifugal)[0]
    distributed = told.creep - overrun - g * length
    kept = (
        0.5
        * arc.shear_compliance
        * (told.stress * told.stress - told.entry_stress * told.entry_stress)
    )
    work = told.loss - kept
    if abs(work) < 1e-12 * (abs(told.loss) + abs(kept)):
        work = 0.0  # rounding: the belt is held all along
    speed = arc.belt_speed / (1.0 - g) if g < 1.0 else nan
    part = geometry.width * told.loss / abs(pull) if abs(pull) > 1e-6 * entry else nan
    efficiency = 1.0 - part if pull > 0.0 else 1.0 / (1.0 + part)
    return Summary(
        entry_tension=entry,
        exit_tension=exit_tension,
        effective_tension=pull,
        tension_ratio=entry / exit_tension,
        exit_creep=told.creep,
        creep_shrinkage=(1.0 - recovery) * distributed,
        creep_compression=recovery * distributed + overrun,
        creep_global=g * length,
        exit_slip=told.slip,
        entry_creep_ratio=g,
        exit_creep_ratio=g + pull * compliance,
        peak_shear_stress=told.peak,
        peak_shear_angle=atan(told.peak / arc.shear_modulus),
        peak_shear_position=told.peak_at / radius,
        mean_friction=abs(log(entry / exit_tension)) / arc.wrap_angle,
        active_arc=told.active / radius,
        k_factor=spring_rate(arc.axial_stiffness, radius * (told.active / radius), told.creep),
        outside_tested_share=told.outside,
        stuck_arc=told.stuck / radius,
        transmitted_power=speed * pull,
        sliding_power=speed * geometry.width * work,
        shear_loss=speed * geometry.width * kept,
        power_loss=speed * geometry.width * told.loss,
        efficiency=efficiency,
        frictional_energy=work,
        wear_rate=1e6 * arc.wear_coefficient * work,
        identity_error=geometry.width
        * told.miss
        / max(abs(geometry.width * told.loss), 1e-6 * entry * abs(g), 1e-300),
    )


def _asked_alone(arc: Description) -> Summary:
    entry, leaving = arc.entry_tension, arc.exit_tension
    return Summary(
        entry, leaving, entry - leaving, entry / leaving,
        nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan, nan,
        nan, nan, nan, nan, nan, nan, nan, nan,
    )  # fmt: skip


class CapacityNumbers(NamedTuple):
    """Capacities and margins as an engineer reads them; see `Capacities`."""

    creep_limit_capacity: float
    creep_limit_margin: float
    equivalent_friction: float
    least_exit_tension: float
    largest_effective_tension: float
    tested_slip_capacity: float
    tested_slip_margin: float
    gross_slip_capacity: float
    extrapolated_gross_slip_margin: float
    gross_slip_creep: float


def capacity_numbers(arc: Description, carried: Carried) -> CapacityNumbers:
    """Capacities and margins of an arc."""
    entry, leaving, wrap_angle = arc.entry_tension, arc.exit_tension, arc.wrap_angle
    actual = max(entry, leaving) / min(entry, leaving)
    creep = tension_ratio_of(arc, carried.creep_limit)
    slip = tension_ratio_of(arc, carried.tested_slip)
    gross = tension_ratio_of(arc, carried.gross_slip)
    return CapacityNumbers(
        creep_limit_capacity=creep,
        creep_limit_margin=creep / actual,
        equivalent_friction=max(log(creep), 0.0) / wrap_angle,
        least_exit_tension=carried.least_slack + arc.centrifugal,
        largest_effective_tension=max(carried.most_pull, 0.0),
        tested_slip_capacity=slip,
        tested_slip_margin=slip / actual,
        gross_slip_capacity=gross,
        extrapolated_gross_slip_margin=gross / actual,
        gross_slip_creep=carried.gross_creep,
    )


def tension_ratio_of(arc: Description, carried: float) -> float:
    """Tight over slack side by ln(tight/slack) of the tensions above m v^2, tight side held [-]."""
    if arc.centrifugal == 0.0:
        return exp(carried)
    tight = max(arc.entry_tension, arc.exit_tension)
    return tight / ((tight - arc.centrifugal) * exp(-carried) + arc.centrifugal)


class Columns(NamedTuple):
    """Quantities along the arc; see `Profile`."""

    position: Buffer
    tension: Buffer
    wrap_pressure: Buffer
    friction: Buffer
    friction_used: Buffer
    slip: Buffer
    creep: Buffer
    shear_stress: Buffer
    shear_angle: Buffer
    sliding: Buffer


def columns_of(law: CompactLaw, arc: Description, rest: float, out: Buffer, count: int) -> Columns:
    """Profile of an arc with a rest arc [m], record by record."""
    columns = Columns(
        zeros(count), zeros(count), zeros(count), zeros(count), zeros(count),
        zeros(count), zeros(count), zeros(count), zeros(count), zeros(count),
    )  # fmt: skip
    side = 1.0 if arc.entry_tension >= arc.exit_tension else -1.0
    for i in range(count):
        o = RECORD * i
        s, slip, tau = out[o], out[o + 2], out[o + 4]
        tension = (arc.entry_tension - arc.centrifugal) * exp(out[o + 1]) + arc.centrifugal
        pressure = pressure_of(arc, tension)
        # a stuck belt has the friction of vanishing slip available
        slides = (s > rest or rest == 0.0) and (slip != 0.0 or tau == 0.0)
        felt = slip if slides else copysign(NEXT_SLIP, side if tau == 0.0 else tau)
        columns.position[i] = s / (0.5 * arc.diameter)
        columns.tension[i] = tension
        columns.wrap_pressure[i] = pressure
        columns.friction[i] = available(law, felt, pressure)
        columns.friction_used[i] = tau / pressure
        columns.slip[i] = slip
        columns.creep[i] = out[o + 3]
        columns.shear_stress[i] = tau
        columns.shear_angle[i] = atan(tau / arc.shear_modulus)
        columns.sliding[i] = 1.0 if slides else 0.0
    return columns


def available(law: CompactLaw, slip: float, pressure: float) -> float:
    """Friction of a law with the sign of the slip [-]."""
    if slip == 0.0:
        return 0.0
    segment, size = segment_of(law, pressure), abs(slip)
    mu, _, _ = friction_at(law, segment, branch_of(law, segment, size, pressure), size, pressure)
    return copysign(mu, slip)


def stretches_outside(
    tested: TestedRange | None, columns: Columns, count: int
) -> tuple[Buffer, int]:
    """Where pressure or slip lie outside the tested range: pairs of places [rad], their number."""
    found, pairs, start = zeros(2 * count + 2), 0, -1
    if tested is None:
        return found, pairs
    position, pressure, slip = columns.position, columns.wrap_pressure, columns.slip
    for i in range(count + 1):
        beyond = i < count and (
            pressure[i] < tested.pressure_min
            or pressure[i] > tested.pressure_max
            or abs(slip[i]) > tested.slip_max
        )
        if beyond and start < 0:
            start = i
        if start >= 0 and not beyond:
            found[2 * pairs] = position[max(start - 1, 0)]
            found[2 * pairs + 1] = position[min(i, count - 1)]
            pairs += 1
            start = -1
    return found, pairs
