"""Results in a notebook: HTML tables and data frames."""

from functools import singledispatch
from typing import Any

from wraparc.across import AcrossResult
from wraparc.answer.catalogue_sheets import lagging_sheet
from wraparc.answer.drive_sheet import arc_sheet, drive_sheet, input_sheet
from wraparc.answer.sheet import Sheet, shown
from wraparc.answer.short import short_sheet
from wraparc.arc import ArcResult, DriveResult, Profile
from wraparc.drive import Drive, Lagging
from wraparc.errors import pandas
from wraparc.render.lines import plain_text
from wraparc.render.page import sheet_html
from wraparc.train.result import TrainResult

#: Columns of text.
_WIDTH = 80


@singledispatch
def sheet_of(thing: Any) -> Sheet:
    """Return what there is to show of a result; a room above registers its own results."""
    raise TypeError(f"nothing known to show of {type(thing).__name__}")


@sheet_of.register
def _(thing: ArcResult) -> Sheet:
    return arc_sheet(thing)


@sheet_of.register
def _(thing: AcrossResult) -> Sheet:
    from wraparc.answer.across_tables import answer_table, profile_table

    tables = (answer_table(thing), profile_table(thing))
    return Sheet(
        f"Pulley {thing.wide.arc.pulley} across the width", str(thing.status), None, tables
    )


@sheet_of.register
def _(thing: DriveResult) -> Sheet:
    return drive_sheet([thing], reserve="line")


@sheet_of.register
def _(thing: Drive) -> Sheet:
    return input_sheet(thing)


@sheet_of.register
def _(thing: Lagging) -> Sheet:
    return lagging_sheet([thing])


@sheet_of.register
def _(thing: TrainResult) -> Sheet:
    from wraparc.answer.train_sheet import train_sheet

    return train_sheet(thing, reserve="line")


@sheet_of.register
def _(thing: Profile) -> Sheet:
    return Sheet(f"Profile of {len(thing)} points", "to_frame() gives them as a data frame")


def html(thing: Any) -> str:
    """Return the short answer of a result as a piece of HTML."""
    return sheet_html(_short(thing))


def text(thing: Any, *, full: bool = False) -> str:
    """Return the short answer of a result as text, or all there is to show of it."""
    return plain_text(shown(_full(thing), "si") if full else _short(thing), _WIDTH)


def _full(thing: Any) -> Sheet:
    """Return all there is to show of a result: of a verdict the change of every input."""
    if isinstance(thing, DriveResult):
        return drive_sheet([thing], reserve="all")
    if isinstance(thing, TrainResult):
        from wraparc.answer.train_sheet import train_sheet

        return train_sheet(thing, reserve="all")
    return sheet_of(thing)


def _short(thing: Any) -> Sheet:
    return short_sheet(shown(sheet_of(thing), "si"), rest=".full()")


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
    return pandas().DataFrame(dict(thing.columns()))


@frame.register
def _(thing: ArcResult) -> Any:
    return frame(thing.profile)


@frame.register
def _(thing: AcrossResult) -> Any:
    from wraparc.answer.across_tables import across_data

    data = across_data(thing)
    return pandas().DataFrame({"across_position": data["across_position"], **data["across"]})


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
    return pandas().DataFrame(rows).set_index(["load_case", "pulley"])


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
    return pandas().DataFrame(rows).set_index(["load_case", "pulley"])
