"""Studies: many variants of a drive, in a process of its own and a folder that goes with it."""

import os
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from wraparc.answer.sheet import named
from wraparc.answer.study_document import study_document
from wraparc.answer.study_sheet import study_sheet
from wraparc.answer.study_words import LIMITS, group_name, histogram_sentence
from wraparc.errors import InputError, Problem, shown
from wraparc.files.lagging_file import is_path
from wraparc.render.page import study_page
from wraparc.schema.emit import document_text
from wraparc.schema.problems import place_text
from wraparc.study.executor import Threads
from wraparc.study.file import StudyFile, study_from_document
from wraparc.study.keys import STUDY
from wraparc.study.monte_carlo import Group, Summary, summarise
from wraparc.study.run import Run, part_designs, run_problems, run_study
from wraparc.study.sensitivity import sensitivities
from wraparc.units import DIMENSIONS, Dimension, parse_quantity
from wraparc.web.answers.documents import read, without_none
from wraparc.web.answers.shown import Answer, Data, Sheet, Text, plain, sheet, worded
from wraparc.web.answers.texts import PlanAnswer, file_stem, plan_text
from wraparc.web.asked import StudyRequest
from wraparc.web.progress import tell

_DRIVE = "drive.toml"
_WORDS = ("title", "description", "provenance", "source", "note")
_LEAST_PART, _STEPS = 64, 20  # designs of a part, and parts that progress is told by
_MOST_SPREADS = 40  # groups whose histograms are looked at
_MOST_BYTES = 30_000_000  # of results that are kept for download


class Size(Answer):
    """What a study is called, and how many designs it has."""

    title: str
    rows: int


class Spread(Answer):
    """How a result is spread over the draws of a group [SI]; `limit` is None where there is none.

    `edges` are those of the bars; `without` are draws without a number.
    """

    result: str
    where: Text
    edges: list[float]
    counts: list[int]
    limit: float | None
    limit_told: Text
    at_most: bool
    beyond: int
    without: int
    told: Text


class StudyResult(Sheet):
    """What came out of a study."""

    summary: Data
    spreads: list[Spread]
    pictures: dict[str, str]
    html: str
    parquet: bytes


def text(asked: StudyRequest) -> PlanAnswer:
    """The file of a study; it names the drive file that the page downloads."""
    drive = f"{file_stem(asked.document.get('title'))}.toml"
    title = asked.study.get("title")
    head: Data = {} if title is None else {"title": title}
    study: Data = head | {"drive": drive} | asked.study | {"drive": drive}
    return plan_text(study, STUDY, title, "study")


def check(asked: StudyRequest) -> Size:
    """Say how large a study is, or everything that is wrong with it."""
    with TemporaryDirectory() as folder:
        file = _study(asked, folder)
        problems = run_problems(file.study, Path(folder) / "study.parquet", Run())
    if problems:
        raise InputError(problems)
    return Size(title=file.study.title, rows=file.study.rows)


def run(asked: StudyRequest) -> StudyResult:
    """Solve a study; tells of its progress."""
    if hasattr(os, "nice"):
        os.nice(10)  # others are served meanwhile
    with TemporaryDirectory() as folder:
        file = _study(asked, folder)
        path, total = str(Path(folder) / "study.parquet"), len(file.study.plan)
        tell(0, total, "preparing")
        how = Run(
            executor=Threads(max(1, (os.cpu_count() or 2) - 1)),
            part_designs=max(_LEAST_PART, min(part_designs(file.study), total // _STEPS)),
            progress=lambda done, total: tell(done, total, "solving"),
        )
        run_study(file.study, path, how)
        tell(total, total, "summing up")
        return _result(file, path)


def _study(asked: StudyRequest, folder: str) -> StudyFile:
    """Return the study; its drive is the document, and nothing in it names another file."""
    study, drive = without_none(asked.study), without_none(asked.document)
    problems = list(_paths(study, ()))
    try:
        read(drive)
    except InputError as error:
        problems += error.problems
    if problems:
        raise InputError(problems)
    Path(folder, _DRIVE).write_text(document_text(drive), "utf-8")
    return study_from_document({"format": 1, **study, "drive": _DRIVE}, folder=folder)


def _paths(value: Any, place: tuple[str | int, ...]) -> Iterator[Problem]:
    """Return a problem for every text that could be the path of a file."""
    if isinstance(value, dict):
        for key, item in value.items():
            if key not in _WORDS and not (key == "drive" and not place):
                yield from _paths(item, (*place, key))
    elif isinstance(value, list):
        for number, item in enumerate(value, start=1):
            yield from _paths(item, (*place, number))
    elif isinstance(value, str):
        text = value.partition("=")[2].strip(" \"'") if "=" in value else value
        if (is_path(text) or "\\" in text or "{" in text) and not _is_quantity(text):
            message = "cannot be a path here"
            remedy = "Put the lagging into the drive, and name it."
            key = place_text(place)
            yield Problem(message=message, remedy=remedy, key=key, value=shown(value))


def _is_quantity(text: str) -> bool:
    for dimension in DIMENSIONS:
        try:
            parse_quantity(text, dimension)
        except InputError:
            continue
        return True
    return False


def _result(asked: StudyFile, path: str) -> StudyResult:
    summary = summarise(path)
    local, indices = sensitivities(path, asked.study, asked.sensitivity)
    dimensions = asked.study.plan.quantities
    told = study_sheet(
        summary, dimensions, local=local, indices=indices,
        remarks=asked.remarks, sources=asked.sources,
    )  # fmt: skip
    from wraparc.plot.study import plot_study, study_pictures

    drawn = study_pictures(summary, local, indices, dimensions, spread=False)  # the page draws that
    pictures = {f"{n}.svg": one.to_bytes("svg").decode("utf-8") for n, one in drawn.items()}
    kept = list(pictures.values())
    if indices is None and summary.drawn:
        kept = [plot_study(summary, dimensions).to_bytes("svg").decode("utf-8")]
    return StudyResult(
        summary=plain(study_document(summary, local=local, indices=indices)),
        spreads=list(_spreads(summary, dimensions)),
        pictures=pictures,
        html=study_page(told, kept, summary),
        parquet=Path(path).read_bytes() if os.path.getsize(path) <= _MOST_BYTES else b"",
        **sheet(told),
    )


def _spreads(summary: Summary, units: dict[str, Dimension | None]) -> Iterator[Spread]:
    """Yield how the results of draws are spread, the group first that keeps its limit least."""
    groups = sorted(summary.groups, key=lambda g: -g.over_limit.value) if summary.drawn else []
    for group in groups[:_MOST_SPREADS]:
        for name, found in group.histograms.items():
            if not found.edges:
                continue
            told = f"{LIMITS[name]} {named(name, found.limit.least)}" if found.limit.one else ""
            yield Spread(
                result=name,
                where=worded(_where(group, units)),
                edges=list(found.edges),
                counts=list(found.counts),
                limit=found.limit.least if found.limit.one else None,
                limit_told=worded(told),
                at_most=found.limit.at_most,
                beyond=found.beyond,
                without=found.total - sum(found.counts),
                told=worded(histogram_sentence(name, found)),
            )


def _where(group: Group, units: dict[str, Dimension | None]) -> str:
    parts = (group_name(group, units), group.load_case, group.condition)
    return ", ".join(part for part in parts if part)
