"""Which design keeps every limit and costs least, as `wraparc choose` tells it."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from wraparc import catalogue
from wraparc.answer.choose_sheet import choose_sheet
from wraparc.choose.file import search_from_document
from wraparc.choose.search import Search
from wraparc.choose.selection import choose
from wraparc.errors import InputError, Problem, name_remedy, shown
from wraparc.schema.emit import document_text
from wraparc.web.answers.documents import read, without_none
from wraparc.web.answers.shown import Sheet, sheet
from wraparc.web.asked import ChooseRequest

_DRIVE = "drive.toml"
#: Most designs: who asks for more has a choose file.
MOST = 20_000
_LISTS = ("laggings", "belts", "thicknesses", "diameters", "wrap_angles")


def chosen(asked: ChooseRequest) -> Sheet:
    """Every combination of the candidates, solved, judged and priced; the cheapest first."""
    selection = choose(_search(asked))
    return Sheet(**sheet(choose_sheet(selection)))


def _search(asked: ChooseRequest) -> Search:
    drive = without_none(asked.document)
    read(drive)
    _check(asked)
    candidates: dict[str, Any] = {k: v for k in _LISTS if (v := getattr(asked, k))}
    if asked.least_slack:
        candidates["slack_tensions"] = "least"
    elif asked.slack_tensions:
        candidates["slack_tensions"] = asked.slack_tensions
    cost: dict[str, Any] = {"currency": asked.currency, "years": asked.years}
    if asked.tariff is not None:
        cost |= {"tariff": asked.tariff, "hours": asked.hours}
    document = {"format": 1, "drive": _DRIVE, "candidates": candidates, "cost": cost}
    if asked.pulley:
        document["pulley"] = asked.pulley
    with TemporaryDirectory() as folder:
        Path(folder, _DRIVE).write_text(document_text(drive), "utf-8")
        return search_from_document(document, folder=folder)


def _check(asked: ChooseRequest) -> None:
    """Refuse laggings that are no names of the catalogue, and too many designs."""
    known = catalogue.lagging_names()
    problems = [
        Problem(
            key=f"candidates.laggings[{i}]",
            value=shown(name),
            message="the catalogue has no lagging of this name",
            remedy=name_remedy(name, known),
        )
        for i, name in enumerate(asked.laggings, start=1)
        if name not in known
    ]
    count = max(len(asked.slack_tensions), 1)
    for name in _LISTS:
        count *= max(len(getattr(asked, name)), 1)
    if count > MOST:
        problems.append(
            Problem(
                key="candidates",
                message=f"{count:,} designs, at most {MOST:,} on a page",
                remedy="Leave some out, or run wraparc choose FILE.",
            )
        )
    if problems:
        raise InputError(problems)
