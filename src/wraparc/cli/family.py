"""``wraparc family``: creep along the wrap for a family of tension ratios."""

import click

from wraparc.cli.answer import Answer, answers
from wraparc.cli.options import place_options
from wraparc.cli.output import Content
from wraparc.cli.solve import code_told
from wraparc.errors import placed
from wraparc.units import parse_number


@click.command()
@click.option(
    "--ratios",
    required=True,
    metavar="R1,R2,...",
    help="Tight-side over slack-side tensions: 1.5,2,3. The tight-side tension stays constant.",
)
@place_options
@answers(
    settings=False,
    json="Write the curves as JSON; - prints them.",
    plot="Draw the curves: .svg, .png or .pdf.",
)
def family(
    answer: Answer, file: str, ratios: str, pulley: str | None, load_case: str | None
) -> int:
    """Show how creep grows along the wrap as the tension ratio of a drive FILE is raised.

    One curve for each ratio, creep over wrap angle, at constant tight-side tension.
    """
    from wraparc.answer.family_sheet import family_document, family_sheet
    from wraparc.arc import WrapArc
    from wraparc.arc.family import tension_ratio_family
    from wraparc.train.file import load_drive

    drive = load_drive(file)
    with placed("--pulley", file):
        place = drive.pulley(pulley)
    with placed("--load-case", file):
        case = drive.load_case(load_case)
    with placed("--ratios"):
        wanted = [parse_number(text.strip()) for text in ratios.split(",") if text.strip()]
    results = tension_ratio_family(WrapArc.of(drive, place, case), wanted)
    title = drive.title or "Family of tension ratios"

    def picture() -> Content:
        from wraparc.plot.family import plot_family

        where = f"pulley {place.name}, load case {case.name}"
        return plot_family(results, answer.units, title=f"{title} - {where}").save

    answer.write("plot", picture)
    told = family_sheet(drive, results, title)
    answer.give(lambda: told, lambda: family_document(results))
    return code_told(told)
