"""``wraparc calibrate`` and ``wraparc overlay``: what an existing drive really does."""

import json

import click

from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import check_outputs
from wraparc.errors import input_error, placed, shown
from wraparc.saving import save_file

_TOLD, _NOT_TOLD = 0, 1
_PULLEY = click.option(
    "--pulley", metavar="NAME", help="Which pulley, where the drive has several."
)


@click.command()
@_PULLEY
@click.option("--name", metavar="NAME", help="Name of that lagging.")
@answers(
    "estimates",
    "correlations",
    "misfit",
    output="Write the calibrated lagging as a file.",
    json="",
)
def calibrate(
    answer: Answer, file: str, settings: tuple[str, ...], pulley: str | None, name: str | None
) -> int:
    """Calibrate friction and elasticities of a drive to what a calibrate FILE says was measured.

    Exit code 1 if the data do not identify every parameter: no lagging file is written.
    """
    from wraparc.answer.calibrate_sheet import calibrate_document, calibrate_sheet
    from wraparc.calibrate.calibration import calibrate as fit
    from wraparc.calibrate.file import calibrated_lagging, load_measured
    from wraparc.files import lagging_text

    measured = load_measured(file, overrides=[*settings, *_pulley(pulley)])
    if not measured.problem.parameters:
        raise input_error(
            file=file,
            key="parameters",
            message="no parameters to find",
            remedy='Write parameters = ["friction"], or see the data with wraparc overlay.',
        )
    found = fit(measured.problem)
    if found.told:
        answer.write(
            "output", lambda: lagging_text(calibrated_lagging(found, measured, name or ""))
        )
    about = measured.title, measured.description, tuple(map(str, measured.sources))
    answer.give(
        lambda: calibrate_sheet(found, measured.problem, *about), lambda: calibrate_document(found)
    )
    output = answer.paths["output"]
    if output and not found.told:
        click.echo(f"{output} not written: the data do not identify every parameter.", err=True)
    return _TOLD if found.told else _NOT_TOLD


def _pulley(name: str | None) -> list[str]:
    """Return the pulley that was named, as a setting over the file."""
    return [] if name is None else [f"pulley={json.dumps(name)}"]


@click.command()
@_PULLEY
@answers("predicted", "records", plot="Draw the measurements over the prediction.")
def overlay(answer: Answer, file: str, settings: tuple[str, ...], pulley: str | None) -> int:
    """Compare the measurements that a calibrate FILE lists with the prediction of both methods."""
    from wraparc.answer.overlay_sheet import overlay_sheet
    from wraparc.calibrate.file import load_measured, overlays

    measured = load_measured(
        file, overrides=[*settings, *_pulley(pulley), "parameters=[]", "prior={}"]
    )
    problem, predicted = measured.problem, overlays(measured)
    if answer.paths["plot"]:
        from wraparc.plot.overlay import plot_overlay

        answer.write("plot", lambda: plot_overlay(problem.traces, predicted, answer.units).save)
    answer.give(lambda: overlay_sheet(problem, measured.folded, predicted, measured.title))
    return _TOLD


@click.command("virtual-record")
@click.argument("file", type=click.Path())
@click.argument("output", type=click.Path())
@_PULLEY
@click.option("--load-case", metavar="NAME", help="Which load case; the running one of maximum Te.")
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
        raise input_error(file=file, key="--pulley", message=message, remedy=remedy)
    with placed("--pulley", file):
        on = drive.pulley(pulley)
    with placed("--load-case", file):
        arc = WrapArc.of(drive, on, drive.load_case(load_case))
    result = Distributed(points=360, capacities=False).solve(arc)
    if not result.status.solved:
        raise input_error(file=file, message=f"no record of it: {result.status}")
    record = make(result, samples=samples, revolutions=revolutions, noise=noise, seed=seed)
    save_file(output, record_text(record))
    click.echo(f"Wrote {output}", err=True)
    return _TOLD
