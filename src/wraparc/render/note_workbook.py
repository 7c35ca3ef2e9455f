"""A solved drive as an Excel workbook: numbers as numbers, units in the heads, native charts."""

import io
import math
from collections.abc import Iterable, Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Any

from wraparc.answer.arc_tables import METHOD_TITLES
from wraparc.answer.inputs import Input
from wraparc.answer.sheet import Row
from wraparc.answer.sources import Sources
from wraparc.answer.words import short
from wraparc.arc import ArcResult, DriveResult
from wraparc.checks import Check, Level
from wraparc.errors import MissingExtraError
from wraparc.glossary import GLOSSARY
from wraparc.provenance import Provenance
from wraparc.render.note import PROGRAM, Note, NoteHead, compose_note, note_inputs
from wraparc.units import (
    NOTHING,
    SMALL,
    Dimension,
    System,
    cell_of,
    display_unit,
    in_units,
    on_safe_side,
)

if TYPE_CHECKING:
    from wraparc.motion.reported import InTime
    from wraparc.train import TrainResult

Cell = str | float
_WIDEST = 60
_BLUE, _ORANGE, _RED = "#0072B2", "#D55E00", "#A50F15"


def note_workbook(
    results: Sequence[DriveResult],
    head: NoteHead,
    system: System = "si",
    train: "TrainResult | None" = None,
    in_time: "InTime | None" = None,
) -> bytes:
    """Return an .xlsx of a solved drive, see `make_note` for the parameters.

    Raises
    ------
    MissingExtraError
        If xlsxwriter is not installed.
    """
    try:
        import xlsxwriter
    except ImportError:
        raise MissingExtraError("xlsxwriter", "report") from None
    data = io.BytesIO()
    # no text of the user's may become a formula or a link
    options = {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False}
    with xlsxwriter.Workbook(data, options) as book:
        told = compose_note(results, head, train, in_time)
        note = told.shown(system)
        book.set_properties(_properties(note))
        _Workbook(book, note, results, system, train).write(told)
    return data.getvalue()


def _properties(note: Note) -> dict[str, Any]:
    head = note.head
    told = {
        "title": note.title,
        "author": head.author,
        "subject": head.project,
        "comments": PROGRAM,
    }
    try:
        return told | {"created": datetime.fromisoformat(head.date).replace(tzinfo=None)}
    except ValueError:
        return told


class _Workbook:
    """Writes the sheets of one workbook."""

    def __init__(
        self,
        book: Any,
        note: Note,
        results: Sequence[DriveResult],
        system: System,
        train: "TrainResult | None",
    ) -> None:
        self.book, self.note, self.results = book, note, results
        self.system, self.train = system, train
        self.bold = book.add_format({"bold": True})
        self.head = book.add_format(
            {"bold": True, "text_wrap": True, "valign": "top", "bottom": 1, "bg_color": "#EEEEEE"}
        )
        self.wrapped = book.add_format({"text_wrap": True, "valign": "top"})

    def write(self, told: Note) -> None:
        """Write every sheet; the tables from the cells of a note."""
        self._summary()
        inputs = note_inputs(self.results[0], self.train)
        self._table("Inputs", _INPUT_HEADS, (self._input(e) for e in inputs if e.value is not None))
        self._results()
        self._tables(told)
        self._profile()
        self._all_profiles()
        self._sources(inputs)

    def _put(self, sheet: Any, row: int, column: int, value: Cell, style: Any = None) -> None:
        if isinstance(value, str):
            sheet.write_string(row, column, in_units(value, self.system), style)
        elif math.isnan(value):
            sheet.write_blank(row, column, None, style)
        elif math.isinf(value):
            sheet.write_string(row, column, "infinite", style)
        else:
            sheet.write_number(row, column, value, style)

    def _sheet(self, title: str, landscape: bool = True) -> Any:
        sheet = self.book.add_worksheet(title)
        sheet.set_paper(9 if self.note.head.paper == "a4" else 1)
        if landscape:
            sheet.set_landscape()
        sheet.fit_to_pages(1, 0)
        sheet.set_footer(f"&L{PROGRAM}&R&P of &N")
        return sheet

    def _table(
        self, title: str, heads: Sequence[str], rows: Iterable[Sequence[Cell]], frozen: int = 1
    ) -> Any:
        """Write a table from the top of a new sheet, its heads and first columns frozen."""
        sheet = self._sheet(title)
        widths = [max(9, min(len(head), 16)) for head in heads]
        for column, head in enumerate(heads):
            self._put(sheet, 0, column, head, self.head)
        last = 0
        for last, values in enumerate(rows, start=1):
            for column, value in enumerate(values):
                self._put(sheet, last, column, value)
                if isinstance(value, str):
                    long = len(in_units(value, self.system)) + 1
                    widths[column] = min(max(widths[column], long), _WIDEST)
        for column, width in enumerate(widths):
            sheet.set_column(column, column, width)
        sheet.freeze_panes(1, frozen)
        sheet.repeat_rows(0)
        sheet.autofilter(0, 0, max(last, 1), len(heads) - 1)
        return sheet

    def _unit(self, dimension: Dimension) -> tuple[str, float]:
        return display_unit(dimension, self.system)

    def _headed(self, name: str) -> str:
        unit, _ = self._unit(GLOSSARY[name].dimension)
        return f"{GLOSSARY[name].title} [{unit}]" if unit else GLOSSARY[name].title

    def _scaled(self, name: str, value: float) -> float:
        return value / self._unit(GLOSSARY[name].dimension)[1]

    def _result(self, name: str, value: float) -> float:
        """Return a result in its unit; what is shown as nothing is nothing."""
        number = self._scaled(name, value)
        nothing = abs(number) < NOTHING and GLOSSARY[name].dimension != SMALL
        return 0.0 if nothing else number

    def _summary(self) -> None:
        sheet, note = self._sheet("Summary", landscape=False), self.note
        self._put(sheet, 0, 0, note.title, self.book.add_format({"bold": True, "font_size": 15}))
        row = 1
        for title, value in (*note.title_block, *note.lines):
            self._put(sheet, row, 0, title, self.bold)
            sheet.merge_range(row, 1, row, 8, "", self.wrapped)
            self._put(sheet, row, 1, value, self.wrapped)
            sheet.set_row(row, 15.0 * max(1, math.ceil(len(value) / 95)))
            row += 1
        for column, title in enumerate(_CHECK_HEADS):
            self._put(sheet, row + 1, column, title, self.head)
        sheet.freeze_panes(row + 2, 1)
        for line, check in enumerate(self._checks(), start=row + 2):
            for column, cell in enumerate(self._check(check)):
                self._put(sheet, line, column, cell)
        for column, width in enumerate((46, 10, 12, 12, 8, 12, 14, 42, 60)):
            sheet.set_column(column, column, width)

    def _checks(self) -> list[Check]:
        """Return the checks that compare, and those that could not be made."""
        listed = self.note.judged.listed
        return [c for c in listed if c.compares or c.level is Level.NOT_CHECKED]

    def _check(self, check: Check) -> tuple[Cell, ...]:
        unit, size = self._unit(check.dimension)
        bound = "" if math.isnan(check.limit) else "max" if check.at_most else "min"
        # what is below its accuracy is told so, as everywhere
        value: Cell = check.texts()[0] if check.below else check.value / size
        used: Cell = 100.0 * check.used if math.isfinite(check.used) else "-"
        return (
            check.title, bound, check.limit / size, value, unit or "-",
            used, str(check.level), str(check.place), check.source,
        )  # fmt: skip

    def _input(self, entry: Input) -> tuple[Cell, ...]:
        value: Cell = entry.text()
        unit = ""
        if isinstance(entry.value, float) and math.isfinite(entry.value):
            unit, size = self._unit(entry.dimension)
            value = entry.value / size
        origin = entry.origin
        told = ("computed", "", entry.remark) if origin is None else _told(origin)
        return entry.group, entry.title, entry.symbol, value, unit, *told

    def _results(self) -> None:
        # the balance is among the checks, where it is told whether it is more than rounding
        numbers = self.results[0].arcs[0].scalars()
        names = [n for n in numbers if n in GLOSSARY and n != "identity_error"]
        heads = ["Load case", "Pulley", "Method", "Answer", *map(self._headed, names)]
        shares: tuple[str, ...] = ()
        if self.train is not None:
            shares = tuple(n for n in self.train.cases[0].members[0].scalars() if n in GLOSSARY)
            heads += list(map(self._headed, shares))
        judged = (self.train or self.results[0], *self.results[1:])
        rows: list[list[Cell]] = [
            [
                *_belongs(arc),
                short(of, arc),
                *(self._result(name, arc.scalars()[name]) for name in names),
                *self._member(arc, shares),
            ]
            for result, of in zip(self.results, judged, strict=True)
            for arc in result
        ]
        self._table("Results", heads, rows, frozen=4)

    def _tables(self, told: Note) -> None:
        """Write every number of the tables of a note on a line of its own, as it is filtered by."""

        def line(title: str, row: Row, head: str, value: str) -> list[Cell]:
            number, unit = self._number(value)
            where = title, row.title, row.symbol, head
            return [*where, number, unit, str(row.level or ""), row.note]

        rows = (
            line(table.title or section.title, row, head, value)
            for section in told.sections
            for table in section.tables
            for row in table.rows
            for head, value in zip(table.heads, row.values, strict=True)
        )
        self._table("Tables", _TABLE_HEADS, rows)

    def _number(self, text: str) -> tuple[Cell, str]:
        """Return the number of a cell and its unit; what is more than one number stays a text."""
        cell = cell_of(text)
        ends = cell is not None and cell.form in ("to", "-") and cell.other != cell.value
        if cell is None or cell.form == "unit" or ends:
            return text, ""
        if cell.form in ("percent", "percent fixed", "percent signed"):
            return 100.0 * cell.value, "%"
        unit, size = self._unit(cell.dimension)
        value = cell.value
        if cell.form in ("up", "bare up", "down"):
            value = on_safe_side(value, cell.dimension, self.system, up=cell.form != "down")
        return value / size, unit

    def _member(self, arc: ArcResult, names: Sequence[str]) -> Sequence[float]:
        """Return what a train adds to an arc; nothing for other methods, which know no speeds."""
        if self.train is None or arc.method != self.results[0].arcs[0].method:
            return ()
        member = self.train[arc.arc.load_case][arc.arc.pulley]
        numbers = member.scalars()
        return [self._result(name, numbers.get(name, math.nan)) for name in names]

    def _profile(self) -> None:
        """Write the profile of the arc that governs, by every method, with charts beside it."""
        worst = self.results[0].governing
        if not worst.status.solved:
            return
        arcs = [r.arcs[self.results[0].arcs.index(worst)] for r in self.results]
        arcs = [arc for arc in arcs if arc.status.solved]
        names = [name for name, _ in worst.profile.columns()]
        heads, columns = [], []
        for arc in arcs:
            method = "" if arc is worst else f", {METHOD_TITLES.get(arc.method, arc.method)}"
            heads += [f"{self._headed(name)}{method}" for name in names]
            columns += [
                [self._scaled(name, v) for v in column.tolist()]
                for name, column in arc.profile.columns()
            ]
        limit = self._scaled("creep_limit", math.copysign(worst.arc.creep_limit, worst.arc.side))
        heads.append(self._headed("creep_limit"))
        columns.append([limit] * len(worst.profile))
        longest = max(map(len, columns))
        padded = [column + [math.nan] * (longest - len(column)) for column in columns]
        sheet = self._table("Profile", heads, zip(*padded, strict=True))
        place = len(heads) + 1
        for number, (title, quantities) in enumerate(_CHARTS):
            chart = self._chart(title, quantities, names, arcs, len(heads) - 1)
            sheet.insert_chart(1 + 16 * number, place, chart)

    def _chart(
        self,
        title: str,
        quantities: Sequence[str],
        names: Sequence[str],
        arcs: Sequence[ArcResult],
        limit: int,
    ) -> Any:
        chart = self.book.add_chart({"type": "scatter", "subtype": "straight"})
        for method, arc in enumerate(arcs):
            for k, name in enumerate(quantities):
                first = method * len(names)
                words = GLOSSARY[name].title + (", paper's integration" if method else "")
                colour = "#000000" if method else (_BLUE, _ORANGE)[k]
                line = {"color": colour, "width": 1.0 if method else 2.0}
                if k:
                    line["dash_type"] = "dash"
                rows = len(arc.profile)
                self._series(chart, words, (first, first + names.index(name)), rows, line)
        if "creep" in quantities:
            line = {"color": _RED, "width": 1.5, "dash_type": "round_dot"}
            self._series(chart, "Creep limit", (0, limit), len(arcs[0].profile), line)
        chart.set_title({"name": title, "name_font": {"size": 11}})
        end = math.degrees(arcs[0].arc.wrap_angle)
        chart.set_x_axis({"name": "Wrap angle [deg]", "min": 0, "max": end})
        chart.set_y_axis(
            {"name": self._headed(quantities[0]), "major_gridlines": {"visible": True}}
        )
        chart.set_legend({"position": "bottom"})
        chart.set_size({"width": 620, "height": 310})
        return chart

    def _series(
        self, chart: Any, words: str, columns: tuple[int, int], rows: int, line: dict[str, Any]
    ) -> None:
        along, value = columns
        chart.add_series(
            {
                "name": words,
                "categories": ["Profile", 1, along, rows, along],
                "values": ["Profile", 1, value, rows, value],
                "line": line,
                "marker": {"type": "none"},
            }
        )

    def _all_profiles(self) -> None:
        names = [name for name, _ in self.results[0].arcs[0].profile.columns()]
        heads = ["Load case", "Pulley", "Method", *map(self._headed, names)]
        rows: Iterable[list[Cell]] = (
            [*_belongs(arc), *(self._scaled(n, v) for n, v in zip(names, point, strict=True))]
            for result in self.results
            for arc in result
            for point in zip(*(c.tolist() for _, c in arc.profile.columns()), strict=True)
        )
        self._table("All profiles", heads, rows, frozen=3)

    def _sources(self, inputs: Sequence[Input]) -> None:
        of, rows = Sources(), []
        for entry in inputs:
            if entry.origin is not None:
                of.note(entry.origin)
        rows += [("source", text) for text in of.listed()]
        for section in self.note.sections:
            if section.kind:
                rows += [(section.kind, text) for text in section.sentences]
            rows += [("equation", f"{e.title}: {e.latex}") for e in section.equations]
        sheet = self._table("Sources", ("Kind", "Text"), dict.fromkeys(rows))
        sheet.set_column(1, 1, 120, self.wrapped)


_INPUT_HEADS = ("Of", "Quantity", "Symbol", "Value", "Unit", "Kind", "Source", "Note")
_TABLE_HEADS = ("Table", "Row", "Symbol", "Column", "Value", "Unit", "Answer", "Note")
_CHECK_HEADS = (
    "Check", "Bound", "Limit", "Value", "Unit", "Used [%]", "Status", "Place",
    "Source of the limit",
)  # fmt: skip
_CHARTS = (
    ("Belt tension", ("tension",)),
    ("Friction", ("friction", "friction_used")),
    ("Creep and slip", ("creep", "slip")),
    ("Shear stress", ("shear_stress",)),
)


def _told(origin: Provenance) -> tuple[str, str, str]:
    source = ", ".join(part for part in (origin.source, origin.date) if part)
    return origin.kind_text, source, origin.note


def _belongs(arc: ArcResult) -> tuple[str, str, str]:
    return arc.arc.load_case, arc.arc.pulley, METHOD_TITLES.get(arc.method, arc.method)
