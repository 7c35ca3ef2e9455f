"""What is calibrated to what: parameters, measurements, and the drive with parameters put in."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from wraparc.arc import Distributed, Method, WrapArc
from wraparc.drive import Drive
from wraparc.drive.changes import with_pulley
from wraparc.errors import InputError, Problem

Array = NDArray[np.float64]

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
#: unit of the overrun in the fit [m]
OVERRUN_UNIT = 1e-4


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
    """

    quantity: str
    value: float
    sd: float
    load_case: str


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
    method: Method = field(default_factory=lambda: Distributed(points=120, capacities=False))

    def __post_init__(self) -> None:
        data = len(self.numbers) + sum(len(t.position) for t in self.traces)
        known = data + len(self.priors)
        if known < len(self.parameters):
            what = "1 number" if known == 1 else f"{known} numbers"
            raise InputError(
                Problem(
                    key="parameters",
                    value=", ".join(self.parameters),
                    message=f"{len(self.parameters)} parameters, and only {what} to find them from",
                    remedy="Calibrate fewer, measure more, or give priors.",
                )
            )

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
        }


def calibrated_drive(drive: Drive, pulley: str, values: Mapping[str, float]) -> Drive:
    """Return the drive with parameters put in: factors on the law; moduli and overrun [SI]."""
    base = drive.pulley(pulley)
    law = base.lagging.law.scaled(values.get("friction", 1.0), values.get("peak_slip", 1.0))
    lagging = replace(
        base.lagging, law=law, shear_modulus=values.get("shear_modulus", base.lagging.shear_modulus)
    )
    changed = with_pulley(
        drive, replace(base, lagging=lagging, overrun=values.get("overrun", base.overrun))
    )
    if "belt_modulus" in values:
        changed = replace(changed, belt=replace(drive.belt, modulus=values["belt_modulus"]))
    return changed


def variable_of(name: str, value: float) -> float:
    """Return the variable that is fitted for a value [SI]."""
    return value / OVERRUN_UNIT if name == "overrun" else math.log(value)


def value_of(name: str, variable: float) -> float:
    """Return the value [SI] of a variable that is fitted."""
    return variable * OVERRUN_UNIT if name == "overrun" else math.exp(variable)
