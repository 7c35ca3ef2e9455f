"""``wraparc field``: what a healthy drive shows, when to alarm, how long the lagging lasts."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

import click

from wraparc.arc import ArcResult, Distributed, WrapArc
from wraparc.calibrate.field_numbers import (
    at_creep_limit,
    field_numbers,
    passes,
    wear_coefficient,
)
from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import deliver
from wraparc.drive import Drive
from wraparc.errors import InputError, Problem, placed, shown
from wraparc.units import Dimension, System, parse_number, parse_quantity


@click.command()
@click.argument("file", type=click.Path())
@units_option
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="As for solve.")
@click.option("--pulley", metavar="NAME", help="Which pulley; the first if left out.")
@click.option("--hours", multiple=True, metavar="CASE=HOURS", help="Hours of running in a year.")
@click.option("--wear-coefficient", metavar="VALUE", help='Energetic wear: "0.001 mm3/J".')
@click.option("--measured-wear", metavar="DEPTH", help="Depth worn off so far, to calibrate it.")
@click.option(
    "--wear-hours",
    multiple=True,
    metavar="CASE=HOURS",
    help="Hours of running in which the measured wear came about.",
)
@click.option(
    "--depth",
    metavar="LENGTH",
    help="Depth of lagging that may be worn off; half its thickness if left out.",
)
@click.option("--json", "json_file", metavar="FILE", help="Write the result as JSON; - prints it.")
def field(
    file: str,
    units: System,
    settings: tuple[str, ...],
    pulley: str | None,
    hours: tuple[str, ...],
    wear_hours: tuple[str, ...],
    json_file: str | None,
    **said: str | None,
) -> int:
    """Show what to expect of a drive FILE on site: speeds to measure, alarm levels, wear."""
    from wraparc.train.file import load_drive

    check_outputs({"--json": (json_file, (".json",))}, [file])
    drive = load_drive(file, overrides=settings)
    with placed("--pulley", file):
        name = drive.pulley(pulley).name
    results = _solved(drive, name)
    limits = {case: at for case, r in results.items() if (at := at_creep_limit(r)) is not None}
    coefficient, source = _coefficient(drive, name, results, wear_hours, said)
    thickness = drive.pulley(name).lagging.thickness
    depth = _length(said["depth"], "--depth") if said["depth"] else 0.5 * thickness
    found = field_numbers(
        results, limits, _hours(hours, "--hours"), coefficient=coefficient, depth=depth
    )
    from wraparc.checks import before
    from wraparc.present.document import json_text
    from wraparc.present.field_sheet import field_document, field_sheet

    deliver(
        {json_file: json_text(field_document(found))} if json_file else {},
        lambda: field_sheet(
            found, drive.title or "Drive", name, source, units, before(drive).qualifier
        ),
    )
    return 0


def _solved(drive: Drive, pulley: str) -> dict[str, ArcResult]:
    return {
        case.name: Distributed().solve(WrapArc.of(drive, drive.pulley(pulley), case))
        for case in drive.load_cases
    }


def _hours(texts: Iterable[str], option: str) -> dict[str, float]:
    found = {}
    for text in texts:
        name, equals, number = text.rpartition("=")
        try:
            if not equals or not name:
                raise InputError(
                    Problem(message="no load case with hours", remedy="Write CASE=HOURS.")
                )
            found[name] = parse_number(number)
        except InputError as error:
            raise InputError(replace(error.problems[0], key=option, value=shown(text))) from None
    return found


def _quantity(text: str | None, dimension: Dimension, option: str) -> float:
    try:
        value = parse_quantity(text or "", dimension)
    except InputError as error:
        raise InputError(replace(error.problems[0], key=option)) from None
    if not value > 0.0:
        raise InputError(Problem(key=option, value=shown(text), message="must be more than 0"))
    return value


def _length(text: str | None, option: str) -> float:
    return _quantity(text, "length", option)


def _coefficient(
    drive: Drive,
    pulley: str,
    results: Mapping[str, ArcResult],
    wear_hours: tuple[str, ...],
    said: Mapping[str, str | None],
) -> tuple[float | None, str]:
    """Return the wear coefficient and where it came from; calibrated from a wear before all."""
    if said["measured_wear"]:
        worn = _length(said["measured_wear"], "--measured-wear")
        hours = _hours(wear_hours, "--wear-hours")
        if not hours:
            message = "needed with --measured-wear: the hours that the wear took"
            remedy = 'Write --wear-hours "design=12000".'
            raise InputError(Problem(key="--wear-hours", message=message, remedy=remedy))
        energy = 0.0
        for name, share in hours.items():
            if name not in results or results[name].arc.belt_speed is None:
                message = "no such load case, or the belt speed is not known"
                raise InputError(Problem(key="--wear-hours", value=shown(name), message=message))
            r = results[name]
            turns = passes(r.arc.belt_speed or 0.0, r.arc.diameter, share)
            energy += turns * abs(r.energy.frictional_energy)
        value = wear_coefficient(worn, energy)
        return value, f"calibrated to the wear measured: {value * 1e9:.3g} mm3/J"
    if said["wear_coefficient"]:
        value = _quantity(said["wear_coefficient"], "wear_coefficient", "--wear-coefficient")
        return value, "wear coefficient as given"
    lagging = drive.pulley(pulley).lagging
    if lagging.wear_coefficient is None:
        return None, ""
    return lagging.wear_coefficient, str(lagging.source_of("wear_coefficient"))
