"""``wraparc family``: creep along the wrap for a family of tension ratios."""

import click

from wraparc.cli.options import check_outputs, units_option
from wraparc.cli.output import Content, deliver
from wraparc.errors import placed
from wraparc.units import System, parse_number


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--ratios",
    required=True,
    metavar="R1,R2,...",
    help="Tight-side over slack-side tensions: 1.5,2,3. The tight side stays as it is.",
)
@units_option
@click.option("--pulley", metavar="NAME", help="Which pulley; the first if left out.")
@click.option("--load-case", metavar="NAME", help="Which load case; the first if left out.")
@click.option("--json", "json_file", metavar="FILE", help="Write the curves as JSON; - prints it.")
@click.option("--plot", "plot_file", metavar="FILE", help="Draw the curves: .svg, .png or .pdf.")
def family(
    file: str,
    ratios: str,
    units: System,
    pulley: str | None,
    load_case: str | None,
    json_file: str | None,
    plot_file: str | None,
) -> int:
    """Show how creep grows along the wrap as the tension ratio of a drive FILE is raised.

    One curve for each ratio, creep over wrap angle, with the tight side held at its tension.
    """
    from wraparc.arc import WrapArc
    from wraparc.arc.family import tension_ratio_family
    from wraparc.present.document import json_text
    from wraparc.present.family_sheet import family_document, family_sheet
    from wraparc.train.file import load_drive

    suffixes = (".svg", ".png", ".pdf")
    check_outputs({"--json": (json_file, (".json",)), "--plot": (plot_file, suffixes)}, [file])
    drive = load_drive(file)
    with placed("--pulley", file):
        place = drive.pulley(pulley)
    with placed("--load-case", file):
        case = drive.load_case(load_case)
    with placed("--ratios"):
        wanted = [parse_number(text.strip()) for text in ratios.split(",") if text.strip()]
    results = tension_ratio_family(WrapArc.of(drive, place, case), wanted)
    title = drive.title or "Family of tension ratios"
    files: dict[str, Content] = {}
    if json_file:
        files[json_file] = json_text(family_document(results))
    if plot_file:
        from wraparc.plot.family import plot_family

        where = f"pulley {place.name}, load case {case.name}"
        files[plot_file] = plot_family(results, units, title=f"{title} - {where}").save
    deliver(files, lambda: family_sheet(drive, results, title, units))
    return 0 if all(r.status.solved for r in results) else 1
