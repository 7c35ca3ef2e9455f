"""``wraparc learn``: a drive from the trend logs of its control system."""

import sys

import click

from wraparc.cli.answer import Answer, answers

_DONE = 0
#: Tables of the answer, by name.
_TABLES = ("learned", "alarm", "episodes", "errors", "left-out", "tags")


@click.command()
@click.argument("files", type=click.Path(), nargs=-1, required=True)
@click.option("--report", "report_file", metavar="FILE", help="Write the report: .pdf.")
@answers(
    *_TABLES, argument="", checked=False, output="Write the learned drive as a drive file.",
    json="", plot="",
)  # fmt: skip
def learn(
    answer: Answer, files: tuple[str, ...], settings: tuple[str, ...], report_file: str | None
) -> int:
    """Learn zero, friction and alarm line of a drive from its trend logs.

    FILES are logs and a drive file, or one learn file that names them. A tag is recognised by its
    name; missing information is requested, never guessed.
    """
    from wraparc.answer.learn_sheet import learn_document, learn_sheet
    from wraparc.learn.file import load_plan
    from wraparc.learn.learn import learn as learn_plan

    plan = load_plan(files, settings)
    written = {"--report": (report_file, (".pdf",))}
    answer.check([*files, *plan.logs, plan.drive_file], written)
    if report_file:
        from wraparc.plot import require_matplotlib

        require_matplotlib()
    shown = _show_step if sys.stderr.isatty() else None
    learned = learn_plan(plan, shown)
    if answer.paths["output"]:
        from wraparc.learn.write import learned_text

        answer.write("output", lambda: learned_text(learned))
    if answer.paths["plot"]:
        from wraparc.plot.learn import plot_learned

        answer.write("plot", lambda: plot_learned(learned, answer.units).save)
    if report_file:
        from wraparc.render.learn import learned_report

        answer.files[report_file] = learned_report(learned, answer.units).pdf()
    answer.give(lambda: learn_sheet(learned), lambda: learn_document(learned))
    return _DONE


def _show_step(step: str, share: float) -> None:
    """Show on a terminal what is being done; nothing of it stays."""
    click.echo(f"\r{100.0 * share:3.0f} % {step:<10}\r", nl=False, err=True)
