"""``wraparc read``, ``wraparc fit`` and ``wraparc rig``: shear tests to a lagging file."""

import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from wraparc.cli.answer import Answer, answers
from wraparc.cli.pipe import say
from wraparc.cli.show import Wanted, show
from wraparc.errors import InputError, Problem, input_error, shown
from wraparc.saving import interrupted

if TYPE_CHECKING:
    from wraparc.answer.sheet import Sheet
    from wraparc.shear_test import Choices

_DONE, _MISFIT = 0, 1


@click.command()
@click.argument("files", type=click.Path(), nargs=-1, required=True)
@click.option("--travel", metavar="COLUMN", help="Column of the travel, by name or number.")
@click.option("--force", metavar="COLUMN", help="Column of the pulling force.")
@click.option("--normal-force", metavar="COLUMN", help="Column of the measured normal force.")
@click.option("--time", metavar="COLUMN", help="Column of the time.")
@click.option(
    "--unit",
    "units",
    multiple=True,
    metavar="COLUMN=UNIT",
    help="Unit of a column where the file has none: --unit Load=N.",
)
@click.option("--decimal", type=click.Choice([".", ","]), help="Decimal sign.")
@click.option("--delimiter", metavar="WORD", help="tab, semicolon, comma, bar or blanks.")
@click.option("--encoding", metavar="NAME", help="For example cp1250.")
@click.option("--sheet", metavar="NAME", help="Sheet of a workbook.")
@click.option("--table", type=int, metavar="N", help="Which table of the file, from 1.")
@click.option(
    "--block", type=int, metavar="N", help="Which of the tests in a table, from 1; all if left out."
)
@click.option(
    "--stress-area", metavar="AREA", help="What a stress was divided by: --stress-area '400 cm2'."
)
def read(
    files: tuple[str, ...], units: tuple[str, ...], stress_area: str | None, **said: Any
) -> int:
    """Read FILES of test machines, or logs, and show their columns, units, ranges and rows.

    Missing information is requested, never guessed.
    """
    from wraparc.answer.shear_test_record import record_sheet
    from wraparc.schema.file_kinds import refuse_toml
    from wraparc.shear_test import Choices, read_machine_tests

    choices = Choices(units=_units(units), stress_area=_area(stress_area), **said)
    problems: list[Problem] = []
    shown_before = False
    for file in files:
        try:
            refuse_toml(file)
            records = read_machine_tests(file, choices)
        except InputError as error:
            log = None if problems else _log(file, choices)
            if log is None:
                problems += error.problems
                continue
            show(log, Wanted(full=True))
            shown_before = True
            continue
        for record in records:
            if shown_before:
                say("")
            show(record_sheet(record), Wanted(full=True))
            shown_before = True
    if problems:
        raise InputError(problems)
    return _DONE


def _log(file: str, choices: "Choices") -> "Sheet | None":
    """Return the sheet of a file that is the log of a drive; None where it is none."""
    from wraparc.answer.log_sheet import log_sheet
    from wraparc.machine_tables import read_bytes, read_log
    from wraparc.machine_tables.log_names import are_of_drive

    if choices.travel or choices.force or not os.path.isfile(file):
        return None
    try:
        log = read_log(read_bytes(file), file)
    except InputError:
        return None
    if log is None or not are_of_drive(tag.name for tag in log.tags):
        return None
    return log_sheet(log, file)


def _area(given: str | None) -> float | None:
    from wraparc.units import parse_quantity

    try:
        area = None if given is None else parse_quantity(given, "area")
    except InputError as error:
        raise InputError([replace(p, key="--stress-area") for p in error.problems]) from None
    if area is not None and not area > 0.0:
        message, remedy = "must be above 0", "Write for example --stress-area '400 cm2'."
        raise input_error(message=message, remedy=remedy, key="--stress-area")
    return area


def _units(given: tuple[str, ...]) -> dict[str, str]:
    units = {}
    for text in given:
        column, sign, unit = text.rpartition("=")
        if not sign or not column.strip() or not unit.strip():
            raise input_error(
                message="must be a column and its unit",
                remedy="Write for example --unit Load=N.",
                key="--unit",
                value=shown(text),
            )
        units[column.strip()] = unit.strip()
    return units


@click.command()
@click.option(
    "--name",
    metavar="NAME",
    help="Put the lagging into your own catalogue, the folder WRAPARC_CATALOGUE, by this name.",
)
@click.option(
    "--report",
    "reports",
    multiple=True,
    metavar="FILE",
    help="Write the report: .pdf, .png or .html; may be repeated.",
)
@click.option(
    "--accept-misfit",
    metavar="REASON",
    help="Write the lagging file of a law that does not describe its tests, with the reason in it.",
)
@click.option(
    "--compare-laws",
    is_flag=True,
    help="Fit other laws to the same tests and show them side by side, with AICc.",
)
@click.option("--bayes", is_flag=True, help="Sample the law's parameters with emcee.")
@answers(
    "law", "slips", "static", "measured", "tests", "coefficients", "budget", "equations", "forms",
    "prediction", "shear", "files", "remarks", "left-out", "unused", "rig", "laws",
    settings=False, argument="plan", checked=False, output="Write the lagging file, .toml.",
    json="",
)  # fmt: skip
def fit(
    answer: Answer,
    plan: str,
    name: str | None,
    reports: tuple[str, ...],
    accept_misfit: str | None,
    compare_laws: bool,
    bayes: bool,
) -> int:
    """Fit the friction law of a lagging to the tests of a PLAN.

    Tests that cannot be used are left out, each with the reason; the law is fitted to the others.
    A law that does not describe its tests is reported, but its lagging file is written only where
    the misfit is accepted.
    """
    from wraparc.answer.shear_test_document import plan_document
    from wraparc.answer.shear_test_tables import counted, plan_sheet
    from wraparc.catalogue import place_of_own
    from wraparc.files.write import lagging_text
    from wraparc.render.shear_test import SUFFIXES, make_report
    from wraparc.shear_test import fit_plan
    from wraparc.shear_test.analysis import checked_reason
    from wraparc.shear_test.plan_file import load_plan

    answer.check([plan], {f"--report {path}": (path, SUFFIXES) for path in reports})
    own = place_of_own(name) if name else None
    if accept_misfit is not None:
        accept_misfit = checked_reason(accept_misfit, "--accept-misfit")
    result = fit_plan(load_plan(plan), progress=_progress())
    if bayes:
        from wraparc.shear_test.bayes import sampled

        result = sampled(result)
    if accept_misfit is not None:
        result = result.accepting(accept_misfit)
    if result.may_be_written:
        answer.write("output", lambda: lagging_text(result.laggings))
    if own and result.may_be_written:
        own.parent.mkdir(exist_ok=True)
        named = [replace(one, name=own.stem) for one in result.laggings]
        answer.files[str(own)] = lagging_text(named)
    if reports:
        save = make_report(result, answer.units, laws=compare_laws).save
        answer.files |= dict.fromkeys(reports, save)
    answer.give(
        lambda: plan_sheet(result, laws=compare_laws),
        lambda: plan_document(result, laws=compare_laws),
    )
    output = answer.paths["output"]
    if not (output or own) or result.may_be_written:
        return _DONE
    click.echo(
        f"{output or own} not written: fit rejected ({counted(result.misfit)}). Fix, repeat or "
        'leave out those tests, or use --accept-misfit "reason".',
        err=True,
    )
    return _MISFIT


def _progress() -> Any:
    """Return what tells of progress on a terminal, or None."""
    import sys

    if not sys.stderr.isatty():
        return None

    def tell(done: int, total: int, what: str) -> None:
        end = "\r" if done < total else "\r" + " " * 79 + "\r"
        click.echo(f"{done}/{total} {what[-60:]:<60}" + end, err=True, nl=False)

    return tell


@click.command()
@click.argument("folder", type=click.Path())
@click.option(
    "--lagging",
    default="diamond-rubber",
    show_default=True,
    help="Lagging to test, of the catalogue or a file.",
)
@click.option(
    "--pressures",
    default="34 69 103 138 207 276 414 690",
    show_default=True,
    help="Set pressures [kPa].",
)
@click.option(
    "--condition",
    "conditions",
    multiple=True,
    metavar="NAME[=FACTOR]",
    help="Such as dry, or wet=0.7: friction times 0.7. Each becomes a law. dry if left out.",
)
@click.option(
    "--repeats",
    type=click.IntRange(1, 20),
    default=3,
    show_default=True,
    help="Tests at every pressure.",
)
@click.option(
    "--points",
    type=click.IntRange(20, 200_000),
    default=400,
    show_default=True,
    help="Readings of every test.",
)
@click.option(
    "--noise",
    type=click.FloatRange(0, 0.5),
    default=0.01,
    show_default=True,
    help="Noise of the force over its maximum.",
)
@click.option(
    "--lash",
    type=click.FloatRange(0, 5),
    default=0.5,
    show_default=True,
    help="Clearance of the rig [mm].",
)
@click.option(
    "--scatter",
    type=click.FloatRange(0, 0.5),
    default=0.02,
    show_default=True,
    help="Scatter of friction and peak slip between samples.",
)
@click.option(
    "--cover",
    type=click.FloatRange(0, 30),
    default=0.0,
    show_default=True,
    help="Belt cover that shears in the rig [mm].",
)
@click.option(
    "--cover-modulus",
    type=click.FloatRange(0.1, 100),
    default=1.0,
    show_default=True,
    help="Its shear modulus [MPa].",
)
@click.option(
    "--dialect",
    "dialects",
    multiple=True,
    help="How machines write; several are taken in turn. All but the workbook if left out.",
)
@click.option("--seed", type=int, default=1, show_default=True, help="Seed of noise and scatter.")
def rig(folder: str, lagging: str, pressures: str, **said: Any) -> int:
    """Simulate shear tests of a known friction law: a FOLDER of files, with the plan to fit them.

    For trying the reader and the fit, and for teaching: the files look like those of test
    machines, and the law to be recovered is known.
    """
    from wraparc.cli.virtual_tests import write_virtual_tests

    path = Path(folder)
    if path.exists() and (not path.is_dir() or any(path.iterdir())):
        raise input_error(
            message="is there already and not an empty folder",
            remedy="Name a new folder.",
            value=shown(os.fspath(folder)),
        )
    kept = f"The tests in {folder} are not all there: remove it, and begin anew."
    with interrupted(lambda: kept):
        plan = write_virtual_tests(path, lagging, pressures, **said)
    say(f"Plan: {plan}\nFit it:  wraparc fit {plan} -o {path / 'lagging.toml'}")
    return _DONE
