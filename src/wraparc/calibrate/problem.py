"""What is calibrated to what: parameters, measurements, and the drive with parameters put in."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from wraparc.arc import ArcResult, Distributed, Method, WrapArc
from wraparc.arrays import Array
from wraparc.drive import Drive, Tensions
from wraparc.drive.changes import with_pulley
from wraparc.drive.pitch import belt_to_shaft, strain_ratio
from wraparc.errors import input_error

#: A load case, and tensions where they are not those of the load case.
State = tuple[str, Tensions | None]
Nip = Literal["entry", "exit"]

#: what can be calibrated, and how: factors and moduli by their logarithm, the overrun as it is
PARAMETERS = ("friction", "peak_slip", "shear_modulus", "overrun", "belt_modulus")
#: single numbers that can be measured: names of the results
QUANTITIES = (
    "exit_creep",
    "exit_slip",
    "peak_shear_angle",
    "peak_shear_stress",
    "entry_creep_ratio",
    "exit_creep_ratio",
)
#: what is measured with errors of its own, common to all load cases: factors near 1
ERRORS = (
    "speed_zero",
    "entry_tension",
    "exit_tension",
    "effective_tension",
    "compression",
    "lagging_shear",
    "cover_shear",
    "torque_offset",
    "take_up",
    "modulus",
    "slip_axis",
    "speed_by_torque",
)
#: those that the record of a plant has beside its gains, and how large they usually are [-]:
#: assumed where the file says that its record is of a plant
PLANT_ERRORS = {
    "torque_offset": 0.02,
    "take_up": 0.036,
    "modulus": 0.10,
    "slip_axis": 0.10,
    "speed_by_torque": 0.0004,
}
#: standard deviation of the zero of the speed ratio where only a zero record tells it [-]: more
#: than any belt is thick
OPEN_ZERO = 0.1
#: unit of the overrun in the fit [m]
OVERRUN_UNIT = 1e-4


def usual_method() -> Method:
    """Return what solves the arcs of a calibration."""
    return Distributed(points=120, capacities=False)


@dataclass(frozen=True, kw_only=True)
class Prior:
    """What is known of a parameter beforehand: mean and standard deviation, in its own unit."""

    mean: float
    sd: float


@dataclass(frozen=True, kw_only=True)
class Number:
    """One measured number.

    Attributes
    ----------
    quantity
        One of `QUANTITIES`.
    value, sd
        Measured value and its standard deviation [SI].
    load_case
        In which load case.
    apparent
        Whether the value compares the belt with the shaft of the drum, 1 - v/(omega R), see
        `tachometer_ratio`; a creep ratio compares it with the surface under it.
    tensions
        T1 and T2 of a record of its own, such as the zero record; those of the load case if None.
    """

    quantity: str
    value: float
    sd: float
    load_case: str
    apparent: bool = False
    tensions: Tensions | None = None

    @property
    def state(self) -> State:
        """In which load case and at which tensions it was measured."""
        return self.load_case, self.tensions

    @property
    def nip(self) -> Nip:
        """The nip of a creep ratio: a tachometer before the drum or behind it."""
        return "entry" if self.quantity == "entry_creep_ratio" else "exit"


@dataclass(frozen=True, eq=False, kw_only=True)
class Trace:
    """A measured course along the arc.

    Attributes
    ----------
    quantity
        ``creep`` or ``shear_angle``.
    position
        theta from the entry nip, shape (n,) [rad].
    value
        Measured values, driving positive, shape (n,) [SI].
    sd
        Standard deviation of one value [SI], or None to find it from the misfit.
    load_case
        In which load case.
    """

    quantity: str
    position: Array
    value: Array
    sd: float | None
    load_case: str


@dataclass(frozen=True, eq=False, kw_only=True)
class Problemset:
    """What is calibrated to what.

    Attributes
    ----------
    drive, pulley
        The drive and the name of its pulley.
    parameters
        Names of what is to be found.
    numbers, traces
        Measurements.
    priors
        By parameter.
    errors
        Standard deviations of the logarithms of what of `ERRORS` the drive was measured with [-]:
        these are fitted along, each held by its own. The take-up moves another way before each
        record, so ``take_up.`` has the name of a load case behind it, or ``zero``.
    assumed
        Those of the errors that are assumed.
    zero
        The record at little load that zeroes the speed ratio, or None.
    method
        What solves the arc.

    Raises
    ------
    InputError
        If there are fewer data than parameters.
    """

    drive: Drive
    pulley: str
    parameters: tuple[str, ...]
    numbers: tuple[Number, ...] = ()
    traces: tuple[Trace, ...] = ()
    priors: Mapping[str, Prior] = field(default_factory=dict)
    errors: Mapping[str, float] = field(default_factory=dict)
    assumed: tuple[str, ...] = ()
    zero: Number | None = None
    method: Method = field(default_factory=usual_method)

    def __post_init__(self) -> None:
        data = sum(n is not self.zero for n in self.numbers)
        data += sum(len(t.position) for t in self.traces)
        known = data + len(self.priors)
        if known < len(self.parameters):
            what = "1 number" if known == 1 else f"{known} numbers"
            raise input_error(
                key="parameters",
                value=", ".join(self.parameters),
                message=f"{len(self.parameters)} parameters, and only {what} to find them from",
                remedy="Calibrate fewer, measure more, or give priors.",
            )

    @property
    def covered(self) -> Problemset | None:
        """The problem with the cover of the belt in series, where the law may include its shear.

        None where the law says so, and where there is no such cover.
        """
        on = self.drive.pulley(self.pulley)
        if WrapArc.of(self.drive, on, self.drive.load_cases[0]).cover_left_out == 0.0:
            return None
        lagging = replace(on.lagging, law=replace(on.lagging.law, slip_includes=()))
        return replace(self, drive=with_pulley(self.drive, replace(on, lagging=lagging)))

    @property
    def used(self) -> tuple[State, ...]:
        """Load cases and tensions that something was measured at."""
        used = [n.state for n in self.numbers] + [(t.load_case, None) for t in self.traces]
        return tuple(dict.fromkeys(used))

    @property
    def variables(self) -> tuple[str, ...]:
        """What is fitted: the parameters, and the errors beside them."""
        return self.parameters + tuple(self.errors)

    @property
    def start(self) -> dict[str, float]:
        """Values of the parameters in the drive as it is [SI]."""
        pulley = self.drive.pulley(self.pulley)
        case = self.drive.load_cases[0]
        overrun = max(WrapArc.of(self.drive, pulley, case).entry_overrun, 0.0)  # fitted rearward
        return {
            "friction": 1.0,
            "peak_slip": 1.0,
            "shear_modulus": pulley.lagging.shear_modulus,
            "overrun": overrun,
            "belt_modulus": self.drive.belt.modulus,
            **dict.fromkeys((*ERRORS, *self.errors), 1.0),
        }


def calibrated_drive(drive: Drive, pulley: str, values: Mapping[str, float]) -> Drive:
    """Return the drive with parameters put in: factors on the law; moduli and overrun [SI]."""
    base = drive.pulley(pulley)
    slip = values.get("peak_slip", 1.0) * values.get("slip_axis", 1.0)
    law = base.lagging.law.scaled(values.get("friction", 1.0), slip)
    lagging = replace(
        base.lagging, law=law, shear_modulus=values.get("shear_modulus", base.lagging.shear_modulus)
    )
    changed = with_pulley(
        drive, replace(base, lagging=lagging, overrun=values.get("overrun", base.overrun))
    )
    modulus = values.get("belt_modulus", drive.belt.modulus) * values.get("modulus", 1.0)
    if modulus != drive.belt.modulus:
        changed = replace(changed, belt=replace(drive.belt, modulus=modulus))
    return changed


def arc_of(
    drive: Drive,
    pulley: str,
    state: State,
    errors: Mapping[str, float],
) -> WrapArc:
    """Return the arc of a pulley as it really was, where what was measured is off by factors.

    Parameters
    ----------
    drive, pulley
        The drive and the name of its pulley.
    state
        Load case, and tensions where they are not those of the load case.
    errors
        Factors by name, of `ERRORS`; 1 where there is none. A factor on the effective tension
        holds the exit tension, or the entry tension where only that has a factor.
    """
    arc = WrapArc.of(drive, drive.pulley(pulley), drive.load_case(state[0]))
    entry, leaving = arc.entry_tension, arc.exit_tension
    if state[1] is not None:
        entry, leaving = state[1].entry, state[1].exit
    pull = (entry - leaving) * errors.get("effective_tension", 1.0)
    pull += (errors.get("torque_offset", 1.0) - 1.0) * most_pull(drive, pulley)
    entry *= errors.get("entry_tension", 1.0)
    leaving *= errors.get("exit_tension", 1.0) * errors.get(take_up_error(state), 1.0)
    by_torque = "effective_tension" in errors or "torque_offset" in errors
    if by_torque and "entry_tension" in errors:
        leaving = entry - pull
    elif by_torque:
        entry = leaving + pull
    return replace(
        arc,
        entry_tension=entry,
        exit_tension=leaving,
        compression_modulus=arc.compression_modulus / errors.get("compression", 1.0),
        shear_modulus=arc.shear_modulus / errors.get("lagging_shear", 1.0),
        cover_compliance=arc.cover_compliance * errors.get("cover_shear", 1.0),
    )


def take_up_error(state: State) -> str:
    """Return the name of the error by the friction of the take-up, of one record."""
    return "take_up.zero" if state[1] is not None else f"take_up.{state[0]}"


def most_pull(drive: Drive, pulley: str) -> float:
    """Return the largest effective tension of the load cases, which stands for rated torque [N]."""
    arcs = (WrapArc.of(drive, drive.pulley(pulley), case) for case in drive.load_cases)
    return max(abs(arc.entry_tension - arc.exit_tension) for arc in arcs)


def speed_over_shaft(arc: WrapArc, creep_ratio: float, nip: Nip) -> float:
    """Return the speed of the belt over that of the drum's shaft, v/(omega R) [-].

    (R - delta + e)(1 - g)/R before the drum, and behind it (1 + T2/EA)/(1 + T1/EA) times that, with
    the compression delta at the entry: behind the drum a belt follows its strain alone. Shaft and
    belt are compared at the radius over the unloaded lagging.

    Parameters
    ----------
    arc
        The arc; without its offset e the belt runs at the lagging surface.
    creep_ratio
        g at the entry nip [-].
    nip
        Where the belt is measured: before the drum (``entry``) or behind it (``exit``).
    """
    met = belt_to_shaft(arc.radius, arc.pitch_radius, creep_ratio)
    return met * strain_of(arc) if nip == "exit" else met


def strain_of(arc: WrapArc) -> float:
    """Return the speed of the belt behind a drum over that before it [-]."""
    return strain_ratio(arc.exit_tension, arc.entry_tension, arc.axial_stiffness)


def tachometer_ratio(result: ArcResult, nip: Nip, zero: float = 1.0) -> float:
    """Return what a tachometer pair shows, 1 - v/(omega R) [-], see `speed_over_shaft`.

    Parameters
    ----------
    result
        A solved arc.
    nip
        Where the belt is measured.
    zero
        What the measured ratio of the speeds is off by, a factor near 1 [-].
    """
    return 1.0 - zero * speed_over_shaft(result.arc, result.entry_creep_ratio, nip)


def predicted_number(result: ArcResult, number: Number, zero: float = 1.0) -> float:
    """Return what an arc predicts of a measured number; `zero` as of `tachometer_ratio` [SI]."""
    if number.apparent:
        return tachometer_ratio(result, number.nip, zero)
    return result.scalar(number.quantity)


def offset_by(arc: WrapArc, creep_ratio: float, zero: Number) -> float:
    """Return the offset e that a zero record shows [m].

    Parameters
    ----------
    arc
        The arc of the record.
    creep_ratio
        g at its entry nip [-].
    zero
        What was measured.
    """
    pitch = arc.pitch_radius * (1.0 - zero.value) / speed_over_shaft(arc, creep_ratio, zero.nip)
    return pitch - arc.radius + arc.compression


def variable_of(name: str, value: float) -> float:
    """Return the variable that is fitted for a value [SI]."""
    return value / OVERRUN_UNIT if name == "overrun" else math.log(value)


def value_of(name: str, variable: float) -> float:
    """Return the value [SI] of a variable that is fitted."""
    return variable * OVERRUN_UNIT if name == "overrun" else math.exp(variable)
