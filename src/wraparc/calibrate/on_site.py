"""What to expect of a drive on site, as it is asked for: speeds, alarm levels, wear."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from wraparc.arc import ArcResult
from wraparc.calibrate.field_numbers import (
    FieldNumbers,
    at_creep_limit,
    field_numbers,
    wear_coefficient,
)
from wraparc.drive import Drive
from wraparc.drive.pitch import turns_an_hour
from wraparc.errors import input_error, shown
from wraparc.train.whole import Whole, by_pulley
from wraparc.units import display, positive_quantity


@dataclass(frozen=True, kw_only=True)
class OnSite:
    """What is known of the site; quantities are texts with their unit.

    Attributes
    ----------
    hours, wear_hours
        Hours of running in a year, and those that the measured wear took, by load case.
    wear_coefficient
        Energetic wear, ``0.001 mm3/J``; that of the lagging where empty.
    measured_wear
        Depth worn off so far, which calibrates the coefficient.
    depth
        Depth that may be worn off; half the thickness where empty.
    """

    hours: Mapping[str, float] = field(default_factory=dict)
    wear_hours: Mapping[str, float] = field(default_factory=dict)
    wear_coefficient: str = ""
    measured_wear: str = ""
    depth: str = ""


def on_site(whole: Whole, pulley: str, asked: OnSite) -> tuple[FieldNumbers | None, str]:
    """Return what to expect of a pulley of a solved drive, and the source of its wear coefficient.

    There is nothing to expect where the pulley slips in a load case.

    Raises
    ------
    InputError
        If something asked cannot be used, under the name of its field.
    """
    drive = by_pulley(whole).drive
    results = {case.name: by_pulley(whole).arc(pulley, case.name) for case in drive.load_cases}
    if not all(r.status.solved for r in results.values()):
        return None, ""
    limits = {case: at for case, r in results.items() if (at := at_creep_limit(r)) is not None}
    coefficient, source = _coefficient(drive, pulley, results, asked)
    thickness = drive.pulley(pulley).lagging.thickness
    depth = _depth(asked.depth, "depth", thickness) if asked.depth else 0.5 * thickness
    found = field_numbers(results, limits, asked.hours, coefficient=coefficient, depth=depth)
    return found, source


def _coefficient(
    drive: Drive, pulley: str, results: Mapping[str, ArcResult], asked: OnSite
) -> tuple[float | None, str]:
    """Return the wear coefficient and where it came from; calibrated from a wear before all."""
    if asked.measured_wear:
        thickness = drive.pulley(pulley).lagging.thickness
        worn = _depth(asked.measured_wear, "measured_wear", thickness)
        value = wear_coefficient(worn, _energy(results, asked.wear_hours))
        return value, f"calibrated to the wear measured: {value * 1e9:.3g} mm3/J"
    if asked.wear_coefficient:
        value = positive_quantity(asked.wear_coefficient, "wear_coefficient", "wear_coefficient")
        return value, "wear coefficient as input"
    lagging = drive.pulley(pulley).lagging
    if lagging.wear_coefficient is None:
        return None, ""
    return lagging.wear_coefficient, str(lagging.source_of("wear_coefficient"))


def _energy(results: Mapping[str, ArcResult], hours: Mapping[str, float]) -> float:
    """Return the frictional energy of hours of running [J/m2]."""
    if not hours:
        message = "missing: the hours of a measured wear"
        remedy = "Write design=12000 for 12,000 h of load case design."
        raise input_error(key="wear_hours", message=message, remedy=remedy)
    energy = 0.0
    for name, share in hours.items():
        if name not in results or results[name].arc.belt_speed is None:
            message = "no such load case, or the belt speed is not known"
            raise input_error(key="wear_hours", value=shown(name), message=message)
        result = results[name]
        arc = result.arc
        turns = share * turns_an_hour(arc.belt_speed or 0.0, arc.radius + arc.offset)
        energy += turns * abs(result.energy.frictional_energy)
    return energy


def _depth(text: str, key: str, thickness: float) -> float:
    """Return a depth of wear [m], of a lagging that is so thick [m]."""
    depth = positive_quantity(text, "length", key)
    if depth > thickness:
        message = f"must be at most the lagging thickness {display(thickness, 'length')}"
        raise input_error(key=key, value=shown(text), message=message)
    return depth
