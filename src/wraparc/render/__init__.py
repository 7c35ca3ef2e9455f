"""Answers as text, page and paper: lines, HTML, Markdown, PDF, workbook.

`pdf`, `workbook` and `markdown` return the calculation note of a solved drive; what sets it in
type is imported when it is asked for.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from wraparc.arc import DriveResult
    from wraparc.motion.reported import InTime
    from wraparc.render.note import NoteHead
    from wraparc.train import TrainResult
    from wraparc.units import System

__all__ = ["NoteHead", "markdown", "pdf", "workbook"]


def __getattr__(name: str) -> Any:
    if name == "NoteHead":
        from wraparc.render.note import NoteHead

        return NoteHead
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def pdf(
    results: "Sequence[DriveResult]",
    head: "NoteHead | None" = None,
    *,
    system: "System" = "si",
    train: "TrainResult | None" = None,
    in_time: "InTime | None" = None,
) -> bytes:
    """Return the calculation note of a solved drive as PDF (PDF/A-2a, PDF/UA-1).

    Parameters
    ----------
    results
        The drive by the main solver, then by others, which are set beside it.
    head
        Title block.
    system
        Units to show.
    train
        How the drives share the load, where there are several on the belt.
    in_time
        Events that were followed for the note; their checks count in its verdict.

    Raises
    ------
    MissingExtraError
        If typst is not installed.
    InputError
        If a text has letters that no font at hand can show.
    """
    from wraparc.render.note import NoteHead, make_note
    from wraparc.render.note_pdf import note_pdf

    return note_pdf(make_note(results, head or NoteHead(), system, train, in_time))


def workbook(
    results: "Sequence[DriveResult]",
    head: "NoteHead | None" = None,
    *,
    system: "System" = "si",
    train: "TrainResult | None" = None,
    in_time: "InTime | None" = None,
) -> bytes:
    """Return the calculation note as an Excel workbook; parameters as for `pdf`.

    Raises
    ------
    MissingExtraError
        If xlsxwriter is not installed.
    """
    from wraparc.render.note import NoteHead
    from wraparc.render.note_workbook import note_workbook

    return note_workbook(results, head or NoteHead(), system, train, in_time)


def markdown(
    results: "Sequence[DriveResult]",
    head: "NoteHead | None" = None,
    *,
    system: "System" = "si",
    train: "TrainResult | None" = None,
    in_time: "InTime | None" = None,
) -> str:
    """Return the calculation note as Markdown; parameters as for `pdf`."""
    from wraparc.render.note import NoteHead, make_note
    from wraparc.render.note_markdown import note_markdown

    return note_markdown(make_note(results, head or NoteHead(), system, train, in_time))
