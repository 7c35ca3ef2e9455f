"""What a calculation note says, section by section, before anybody sets it in type.

What only trains need is imported for them alone: the note of a single drive must start fast.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Literal, cast

from wraparc.answer.arc_tables import belongs
from wraparc.answer.catalogue_sheets import law_table
from wraparc.answer.checks_table import check_table, checks_summary
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.input_tables import input_tables
from wraparc.answer.inputs import Input, drive_inputs
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.sheet import (
    Row,
    Sheet,
    Table,
    Verdict,
    quantity,
    shown,
)
from wraparc.answer.sources import Sources
from wraparc.arc import DriveResult
from wraparc.checks import Verdict as Judgement
from wraparc.drive import Drive
from wraparc.errors import InputError, Problem, name_remedy
from wraparc.errors import shown as quoted
from wraparc.friction import Equation
from wraparc.render.drawings import (
    Drawing,
    across_drawing,
    budget_drawing,
    profile_drawing,
    pulley_drawing,
    reserve_drawing,
)
from wraparc.render.equations import equations
from wraparc.render.note_sentences import assumptions, warnings
from wraparc.train.whole import Whole
from wraparc.units import GIVEN_DIGITS, System
from wraparc.version import __version__

if TYPE_CHECKING:
    from wraparc.motion.reported import InTime
    from wraparc.train import TrainResult

Paper = Literal["a4", "us-letter"]
PAPERS: tuple[Paper, ...] = ("a4", "us-letter")
PROGRAM = f"wraparc {__version__}"
_LONGEST = 120
_MOST_PULLEYS_DRAWN = 4


#: Columns of a table that leave no room for a further one.
_FILLS = 8
#: Parts of a note, and the tables of the answer that stand there by name; the others are of the
#: arc that governs. What was put in is listed for the whole drive.
_CHECKS, _RESULTS, _ACROSS, _PUT_IN = "checks", "results", "across", "inputs"
_PARTS = {
    "checks": _CHECKS, "least": _CHECKS, "reserve": _CHECKS,
    "probability": _CHECKS,
    "conditions": _RESULTS, "cases": _RESULTS, "figures": _RESULTS, "drives": _RESULTS,
    "loads": _RESULTS,
    "width": _ACROSS, "strips": _ACROSS, "defects": _ACROSS,
    "conveyor": _PUT_IN, "tensions": _PUT_IN, "flights": _PUT_IN, "sag": _PUT_IN,
    "curves": _PUT_IN, "take-up": _PUT_IN, "standstill": _PUT_IN, "inputs": "",
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class NoteHead:
    """What stands in the title block and in the box to sign; plain text, never markup.

    Parameters
    ----------
    title
        Title; that of the drive unless given.
    project, number, revision
        Project or customer, number and revision of the document.
    author
        Who prepared it.
    date
        As it shall be printed.
    file
        Name of the drive file.
    changes
        What was put over it, ``belt.speed=2.8 m/s``.
    paper
        ``a4`` or ``us-letter``.

    Raises
    ------
    InputError
        For texts that are longer than a line, or hold letters that cannot be printed.
    """

    title: str = ""
    project: str = ""
    number: str = ""
    revision: str = ""
    author: str = ""
    date: str = ""
    file: str = ""
    changes: tuple[str, ...] = ()
    paper: Paper = "a4"

    def __post_init__(self) -> None:
        problems = []
        for f in fields(self):
            value = getattr(self, f.name)
            if f.name == "changes":
                value = "".join(c for change in self.changes for c in change if not c.isprintable())
            if not isinstance(value, str) or len(value) > _LONGEST or not value.isprintable():
                message = f"must be printable text of at most {_LONGEST} characters"
                problems.append(Problem(key=f.name, value=quoted(value), message=message))
        if self.paper not in PAPERS:
            message, remedy = "no such paper", name_remedy(self.paper, PAPERS)
            problems.append(
                Problem(key="paper", value=quoted(self.paper), message=message, remedy=remedy)
            )
        if problems:
            raise InputError(problems)


@dataclass(frozen=True)
class Section:
    """A part of a note under one heading: sentences, then tables, pictures and equations.

    `kind` is what its sentences are where they are listed without its heading.
    """

    title: str
    sentences: tuple[str, ...] = ()
    tables: tuple[Table, ...] = ()
    drawings: tuple[Drawing, ...] = ()
    equations: tuple[Equation, ...] = ()
    numbered: bool = False
    kind: str = ""

    def shown(self, system: System) -> "Section":
        """Return it in a system of units."""
        return replace(
            self,
            sentences=shown(self.sentences, system),
            tables=shown(self.tables, system),
            drawings=tuple(drawing.shown(system) for drawing in self.drawings),
        )


@dataclass(frozen=True)
class Note:
    """A calculation note.

    Attributes
    ----------
    head
        Title block.
    title, subtitle, belt
        Headings, and the name of the belt.
    told
        The answer in words.
    judged
        Every check.
    sections
        Everything else.
    """

    head: NoteHead
    title: str
    subtitle: str
    belt: str
    told: Verdict
    judged: Judgement
    about: tuple[tuple[str, str], ...]
    sections: tuple[Section, ...]

    def shown(self, system: System) -> "Note":
        """Return it in a system of units."""
        return replace(
            self,
            told=shown(self.told, system),
            about=shown(self.about, system),
            sections=tuple(section.shown(system) for section in self.sections),
        )

    @property
    def lines(self) -> tuple[tuple[str, str], ...]:
        """Label and text of every line of the answer, those of the first screen."""
        return ((self.told.word, self.told.text), *self.told.lines)

    @property
    def drawings(self) -> tuple[Drawing, ...]:
        """Every picture, in order."""
        return tuple(drawing for section in self.sections for drawing in section.drawings)

    @property
    def title_block(self) -> tuple[tuple[str, str], ...]:
        """What the title block says: name and value, what is empty left out."""
        head = self.head
        pairs = (
            ("Project", head.project), ("Document", head.number), ("Revision", head.revision),
            ("Prepared by", head.author), ("Date", head.date), ("Drive file", head.file),
            ("Changed from the file", "; ".join(head.changes)), ("Program", PROGRAM),
            ("Belt", self.belt), *self.about,
        )  # fmt: skip
        return tuple(pair for pair in pairs if pair[1])


def make_note(
    results: Sequence[DriveResult],
    head: NoteHead,
    system: System = "si",
    train: "TrainResult | None" = None,
    in_time: "InTime | None" = None,
) -> Note:
    """Return the note of a solved drive in a system of units, see `compose_note`."""
    return compose_note(results, head, train, in_time).shown(system)


def compose_note(
    results: Sequence[DriveResult],
    head: NoteHead,
    train: "TrainResult | None" = None,
    in_time: "InTime | None" = None,
) -> Note:
    """Return the note of a solved drive.

    Parameters
    ----------
    results
        The drive by the main solver, then by others.
    head
        Title block.
    train
        How the drives share the load, where there are several on the belt.
    in_time
        Events that were followed for the note; their checks count in its verdict.
    """
    first, of = results[0], Sources()
    judged = judge_uncertain(first if train is None else train)
    answer = _answer(results, train, of)
    told = cast(Verdict, answer.verdict)
    in_time_sections: tuple[Section, ...] = ()
    if in_time is not None:
        from wraparc.render.note_in_time import judged_with, section, told_with

        judged, told = judged_with(judged, in_time), told_with(told, in_time)
        answer = _with_checks(answer, judged, of)
        in_time_sections = (Section("In time: events and vibrations", *section(in_time)),)
    worst = belongs(first.governing)
    sections = [
        *_in_condition(
            first.drive,
            Section(
                "Checks against limits", (checks_summary(judged), *told.sentences),
                _of(answer, _CHECKS), _reserve_pictures(first if train is None else train),
                kind="check",
            ),
            Section("Results by load case", tables=_of(answer, _RESULTS)),
            Section(f"Governing arc: {worst}", drawings=_pictures(results)),
            Section(f"Governing arc in detail: {worst}", tables=_of(answer, "arc")),
        ),
        Section("Across the width", tables=_of(answer, _ACROSS), drawings=_across_pictures(first)),
        *in_time_sections,
        Section("Inputs and where they came from", tables=_inputs(answer, first, of, train)),
        Section("Assumptions", tuple(assumptions(results, train)), kind="assumption"),
        _equation_section(results, train),
        Section("Warnings", tuple(warnings(results)), kind="warning"),
        Section("Sources", of.listed(), numbered=True, kind="source"),
    ]  # fmt: skip
    return Note(
        head=head,
        title=head.title or first.drive.title or "Drive",
        subtitle=first.drive.description,
        belt=first.drive.belt.name,
        told=told,
        judged=judged,
        about=tuple(_about(first.drive)),
        sections=tuple(
            replace(s, tables=tuple(map(_worded, s.tables)))
            for s in sections
            if s.sentences or s.tables or s.drawings or s.equations
        ),
    )


def _answer(results: Sequence[DriveResult], train: "TrainResult | None", of: Sources) -> Sheet:
    """Return the full answer, as on the screen."""
    if train is None:
        return drive_sheet(results, of=of, reserve="all", probability=True)
    from wraparc.answer.train_sheet import train_sheet

    return train_sheet(train, pulleys=results, of=of, reserve="all", probability=True)


def _with_checks(answer: Sheet, judged: Judgement, of: Sources) -> Sheet:
    """Return an answer with the table of all checks, those of events among them."""
    tables = (check_table(judged, of, t.title) if t.name == "checks" else t for t in answer.tables)
    return replace(answer, tables=tuple(tables))


def _of(answer: Sheet, part: str) -> tuple[Table, ...]:
    """Return the tables of an answer that stand in a part of its note."""
    return tuple(table for table in answer.tables if _PARTS.get(table.name, "arc") == part)


def _in_condition(drive: Drive, *sections: Section) -> Iterator[Section]:
    """Name the condition in titles where it is one that no load case names, and not dry."""
    conditions = {p.lagging.condition for p in drive.pulleys}
    told = "" if drive.conditions or conditions == {"dry"} else f", {', '.join(sorted(conditions))}"
    yield from (replace(section, title=f"{section.title}{told}") for section in sections)


def _about(drive: Drive) -> Iterator[tuple[str, str]]:
    """Yield what a reader looks for in the title block: conditions, and the conveyor."""
    conditions = drive.conditions or tuple(
        dict.fromkeys(pulley.lagging.condition for pulley in drive.pulleys)
    )
    yield "Condition of the lagging", ", ".join(conditions)
    of = drive.conveyor
    if of is None:
        return
    parts = [f"length {quantity(of.length, 'length', GIVEN_DIGITS)}"]
    parts.append(f"lift {quantity(of.lift, 'length', GIVEN_DIGITS)}")
    if of.capacity is not None:
        parts.append(f"capacity {quantity(of.capacity, 'mass_flow', GIVEN_DIGITS)}")
    elif of.material_mass is not None:
        parts.append(f"material {quantity(of.material_mass, 'mass_per_length', GIVEN_DIGITS)}")
    yield "Conveyor", ", ".join(parts)


def _worded(table: Table) -> Table:
    """Say beside every colour what it means; in the last cell of a table that fills the page."""
    return replace(table, rows=tuple(_worded_row(row, table) for row in table.rows))


def _worded_row(row: Row, table: Table) -> Row:
    if not row.level:
        return row
    if row.mark and len(table.heads) > _FILLS and not table.has_notes:
        *cells, last = row.values
        return replace(row, values=(*cells, f"{row.level}: {last}"))
    return replace(row, note=": ".join(part for part in (row.mark, row.note) if part))


def _inputs(
    answer: Sheet, result: DriveResult, of: Sources, train: "TrainResult | None"
) -> tuple[Table, ...]:
    laws = (law_table(lagging) for lagging in result.drive.laggings)
    inputs = input_tables(note_inputs(result, train), of, stated=True)
    return (*_of(answer, _PUT_IN), *inputs, *laws)


def note_inputs(result: DriveResult, train: "TrainResult | None") -> tuple[Input, ...]:
    """Return every input of a note."""
    if train is None:
        return drive_inputs(result.drive)
    from wraparc.answer.train_inputs import train_inputs

    return (*drive_inputs(result.drive, divided=True), *train_inputs(train.train))


def _pictures(results: Sequence[DriveResult]) -> tuple[Drawing, ...]:
    """Return the pulleys of the load case that governs, and the arc that does along its wrap."""
    first = results[0]
    worst = first.governing
    position = first.arcs.index(worst)
    pulleys = [r for r in first if r.arc.load_case == worst.arc.load_case]
    pictures = [pulley_drawing(r) for r in pulleys[:_MOST_PULLEYS_DRAWN]]
    if worst.status.solved:
        arcs = (r.arcs[position] for r in results)
        solved = tuple(r for r in arcs if r.status.solved)
        pictures += [budget_drawing(solved), profile_drawing(solved)]
    return tuple(pictures)


def _reserve_pictures(result: Whole) -> tuple[Drawing, ...]:
    """Return the reserve of the verdict, where an input changes it."""
    drawing = reserve_drawing(result)
    return () if drawing is None else (drawing,)


def _across_pictures(result: DriveResult) -> tuple[Drawing, ...]:
    """Return the map of the worst pulley, where one says what is uneven across its width."""
    if not any(pulley.across for pulley in result.drive.pulleys):
        return ()
    from wraparc.answer.across_tables import worst_first

    return (across_drawing(worst_first(result)[0]),)


def _equation_section(results: Sequence[DriveResult], train: "TrainResult | None") -> Section:
    design = any(p.lagging.surface for p in results[0].drive.pulleys)
    listed = equations(
        results[0].arcs, paper=len(results) > 1, train=train is not None, design=design
    )
    return Section("Equations", equations=listed)
