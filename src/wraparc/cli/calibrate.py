"""``wraparc calibrate`` and ``wraparc overlay``: what an existing drive really does."""

import json

import click

from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import Content, deliver
from wraparc.errors import InputError, Problem, placed, shown
from wraparc.saving import save_file
from wraparc.units import System

_TOLD, _NOT_TOLD = 0, 1


@click.command()
@click.argument("file", type=click.Path())
@units_option
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="As for solve.")
@click.option("--pulley", metavar="NAME", help="Which pulley, where the drive has several.")
@click.option("-o", "--output", metavar="FILE", help="Write the calibrated lagging as a file.")
@click.option("--name", metavar="NAME", help="Name of that lagging.")
@click.option("--json", "json_file", metavar="FILE", help="Write the result as JSON; - prints it.")
def calibrate(
    file: str,
    units: System,
    settings: tuple[str, ...],
    pulley: str | None,
    output: str | None,
    name: str | None,
    json_file: str | None,
) -> int:
    """Calibrate friction and elasticities of a drive to what a calibrate FILE says was measured.

    Exit code 1 if the measurements leave some parameter open: it gets no number then, and no
    lagging file is written.
    """
    from wraparc.calibrate.calibration import calibrate as fit
    from wraparc.calibrate.file import calibrated_lagging, load_measured
    from wraparc.files import lagging_text
    from wraparc.present.calibrate_sheet import calibrate_document, calibrate_sheet
    from wraparc.present.document import json_text

    outputs: dict[str, tuple[str | None, tuple[str, ...]]]
    outputs = {"--json": (json_file, (".json",)), "--output": (output, (".toml",))}
    check_outputs(outputs, [file])
    measured = load_measured(file, overrides=[*settings, *_pulley(pulley)])
    if not measured.problem.parameters:
        raise InputError(
            Problem(
                file=file,
                key="parameters",
                message="no parameters to find",
                remedy='Write parameters = ["friction"], or see the data with wraparc overlay.',
            )
        )
    found = fit(measured.problem)
    files: dict[str, Content] = {}
    if json_file:
        files[json_file] = json_text(calibrate_document(found))
    if output and found.told:
        files[output] = lagging_text(calibrated_lagging(found, measured, name or ""))
    sources = tuple(str(s) for s in measured.sources)
    deliver(
        files,
        lambda: calibrate_sheet(
            found, measured.problem, measured.title, measured.description, sources, units
        ),
    )
    if output and not found.told:
        click.echo(f"{output} was not written: the data do not tell every parameter.", err=True)
    return _TOLD if found.told else _NOT_TOLD


def _pulley(name: str | None) -> list[str]:
    """Return the pulley that was named, as a setting over the file."""
    return [] if name is None else [f"pulley={json.dumps(name)}"]


@click.command()
@click.argument("file", type=click.Path())
@units_option
@click.option("--set", "settings", multiple=True, metavar="KEY=VALUE", help="As for solve.")
@click.option("--pulley", metavar="NAME", help="Which pulley, where the drive has several.")
@click.option(
    "--plot", "plot_file", metavar="FILE", help="Draw the measurements over the prediction."
)
def overlay(
    file: str, units: System, settings: tuple[str, ...], pulley: str | None, plot_file: str | None
) -> int:
    """Compare the measurements that a calibrate FILE lists with the prediction of both methods."""
    from wraparc.calibrate.file import load_measured, overlays
    from wraparc.present.calibrate_sheet import overlay_sheet

    check_outputs({"--plot": (plot_file, (".svg", ".png", ".pdf"))}, [file])
    if plot_file:
        from wraparc.plot import require_matplotlib

        require_matplotlib()
    measured = load_measured(
        file, overrides=[*settings, *_pulley(pulley), "parameters=[]", "prior={}"]
    )
    predicted = overlays(measured)
    files: dict[str, Content] = {}
    if plot_file:
        from wraparc.plot.overlay import plot_overlay

        files[plot_file] = plot_overlay(measured.problem.traces, predicted, units).save
    problem = measured.problem
    deliver(
        files, lambda: overlay_sheet(problem, measured.folded, predicted, measured.title, units)
    )
    return _TOLD


@click.command("virtual-record")
@click.argument("file", type=click.Path())
@click.argument("output", type=click.Path())
@click.option("--pulley", metavar="NAME", help="Which pulley, where the drive has several.")
@click.option("--load-case", metavar="NAME", help="Which load case; the first if left out.")
@click.option(
    "--samples",
    type=click.IntRange(100, 2_000_000),
    default=3600,
    show_default=True,
    help="Readings in the record.",
)
@click.option(
    "--revolutions",
    type=click.FloatRange(0.1, 1e5),
    default=5.0,
    show_default=True,
    help="Turns of the pulley.",
)
@click.option(
    "--noise",
    type=click.FloatRange(0, 1),
    default=0.01,
    show_default=True,
    help="Noise of every reading over its value.",
)
@click.option("--seed", type=int, default=1, show_default=True, help="Seed of the noise.")
def virtual_record(
    file: str,
    output: str,
    pulley: str | None,
    load_case: str | None,
    samples: int,
    revolutions: float,
    noise: float,
    seed: int,
) -> int:
    """Write to OUTPUT, as CSV, what an instrumented pulley of a drive FILE would record."""
    from wraparc.arc import Distributed, WrapArc
    from wraparc.calibrate.virtual_pulley import record_text
    from wraparc.calibrate.virtual_pulley import virtual_record as make
    from wraparc.train.file import load_drive

    check_outputs({"OUTPUT": (output, (".csv",))}, [file])
    drive = load_drive(file)
    if pulley is None and len(drive.pulleys) > 1:
        there = ", ".join(shown(p.name) for p in drive.pulleys)
        remedy = f"Write which of {there}."
        message = "the drive has several pulleys"
        raise InputError(Problem(file=file, key="--pulley", message=message, remedy=remedy))
    with placed("--pulley", file):
        on = drive.pulley(pulley)
    with placed("--load-case", file):
        arc = WrapArc.of(drive, on, drive.load_case(load_case))
    result = Distributed(points=360, capacities=False).solve(arc)
    if not result.status.solved:
        raise InputError(Problem(file=file, message=f"no record of it: {result.status}"))
    record = make(result, samples=samples, revolutions=revolutions, noise=noise, seed=seed)
    save_file(output, record_text(record))
    click.echo(f"Wrote {output}", err=True)
    return _TOLD
