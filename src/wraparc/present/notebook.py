"""Results in a notebook: HTML tables and data frames."""

from functools import singledispatch
from itertools import zip_longest
from typing import Any

from wraparc.across import AcrossResult
from wraparc.arc import ArcResult, DriveResult, Profile
from wraparc.drive import Drive, Lagging
from wraparc.errors import library
from wraparc.present.catalogue_sheets import lagging_sheet
from wraparc.present.drive_sheet import arc_sheet, drive_sheet, input_sheet
from wraparc.present.page import sheet_html
from wraparc.present.sheet import Row, Sheet
from wraparc.train.result import TrainResult


@singledispatch
def sheet_of(thing: Any) -> Sheet:
    """Return what there is to show of a result; a room above registers its own results."""
    raise TypeError(f"nothing known to show of {type(thing).__name__}")


@sheet_of.register
def _(thing: ArcResult) -> Sheet:
    return arc_sheet(thing)


@sheet_of.register
def _(thing: AcrossResult) -> Sheet:
    from wraparc.present.across_tables import answer_table, profile_table

    tables = (answer_table(thing, "si"), profile_table(thing, "si"))
    return Sheet(
        f"Pulley {thing.wide.arc.pulley} across the width", str(thing.status), None, tables
    )


@sheet_of.register
def _(thing: DriveResult) -> Sheet:
    return drive_sheet([thing])


@sheet_of.register
def _(thing: Drive) -> Sheet:
    return input_sheet(thing)


@sheet_of.register
def _(thing: Lagging) -> Sheet:
    return lagging_sheet([thing])


@sheet_of.register
def _(thing: TrainResult) -> Sheet:
    from wraparc.present.train_sheet import train_sheet

    return train_sheet(thing)


@sheet_of.register
def _(thing: Profile) -> Sheet:
    return Sheet(f"Profile of {len(thing)} points", "to_frame() gives them as a data frame")


def html(thing: Any) -> str:
    """Return a result as a piece of HTML."""
    return sheet_html(sheet_of(thing))


def text(thing: Any) -> str:
    """Return a result as a few lines: its answer, and its first table in columns."""
    sheet = sheet_of(thing)
    lines = [sheet.title, *([sheet.subtitle] if sheet.subtitle else [])]
    if sheet.verdict is not None:
        lines.append(f"{sheet.verdict.told}: {sheet.verdict.headline}")
    for table in sheet.tables[:1]:
        rows = [("", *table.heads), *map(_cells, table.rows)]
        widths = [max(map(len, column)) for column in zip_longest(*rows, fillvalue="")]
        lines.append(table.title)
        lines += [
            "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=False)).rstrip()
            for row in rows
        ]
    return "\n".join(line for line in lines if line)


def _cells(row: Row) -> tuple[str, ...]:
    return (row.title, *row.values, *([str(row.level)] if row.level else []))


@singledispatch
def frame(thing: Any) -> Any:
    """Return the numbers of a result as a pandas DataFrame [SI].

    A profile has a row for each point, a belt across its width one for each strip; an arc is its
    profile; a drive and a train have a row for
    each load case and pulley with every scalar.

    Raises
    ------
    MissingExtraError
        Without pandas.
    """
    raise TypeError(f"no data frame of {type(thing).__name__}")


@frame.register
def _(thing: Profile) -> Any:
    return library("pandas", "notebook").DataFrame(dict(thing.columns()))


@frame.register
def _(thing: ArcResult) -> Any:
    return frame(thing.profile)


@frame.register
def _(thing: AcrossResult) -> Any:
    from wraparc.present.across_tables import across_data

    data = across_data(thing)
    return library("pandas", "notebook").DataFrame(
        {"across_position": data["across_position"], **data["across"]}
    )


@frame.register
def _(thing: DriveResult) -> Any:
    rows = [
        {
            "load_case": result.arc.load_case,
            "pulley": result.arc.pulley,
            "status": result.status.name.lower(),
            **result.scalars(),
        }
        for result in thing
    ]
    return library("pandas", "notebook").DataFrame(rows).set_index(["load_case", "pulley"])


@frame.register
def _(thing: TrainResult) -> Any:
    rows = [
        {
            "load_case": case.case.name,
            "pulley": member.name,
            "status": case.status.name.lower(),
            **member.scalars(),
            **member.arc.scalars(),
        }
        for case in thing
        for member in case
    ]
    return library("pandas", "notebook").DataFrame(rows).set_index(["load_case", "pulley"])
