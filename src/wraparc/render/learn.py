"""The report of a drive that was learned from its logs: PDF."""

from dataclasses import dataclass

from wraparc.answer.learn_sheet import learn_sheet
from wraparc.answer.sheet import Sheet, shown
from wraparc.learn.grid import moment_of
from wraparc.learn.learn import Learned
from wraparc.plot.learn import learned_pictures
from wraparc.render.drawings import Drawing
from wraparc.render.note import PROGRAM, Section
from wraparc.render.note_pdf import sections_data
from wraparc.render.typesetting import typeset_pdf
from wraparc.units import System


@dataclass(frozen=True)
class LearnedReport:
    """The answer with its pictures, ready to be typeset.

    Attributes
    ----------
    sheet
        Verdict, tables and remarks in a system of units.
    drawings
        Two pictures of each pulley.
    date
        Last day of the log.
    """

    sheet: Sheet
    drawings: tuple[Drawing, ...]
    date: str

    def pdf(self) -> bytes:
        """Return it as PDF.

        Raises
        ------
        MissingExtraError
            If typst or matplotlib is not installed.
        """
        sheet, verdict = self.sheet, self.sheet.verdict
        sections = (
            Section("", tables=sheet.tables[:1]),
            Section("", drawings=self.drawings),
            # each by itself: side by side they would be too narrow
            *(Section("", tables=(table,)) for table in sheet.tables[1:]),
            Section("Remarks", sentences=sheet.remarks),
        )
        data = {
            "kind": "Logs of a plant · friction, zero and alarm line of a drive",
            "title": sheet.title,
            "subtitle": sheet.subtitle,
            "author": "",
            "date": self.date,
            "paper": "a4",
            "box": (),
            "footer": (PROGRAM, self.date),
            "single": False,
            "signatures": (("Prepared", "", ""), ("Checked", "", ""), ("Approved", "", "")),
            "level": str(verdict.level) if verdict else "OK",
            "headline": verdict.text if verdict else "",
            "lines": ((verdict.word, verdict.text), *verdict.lines) if verdict else (),
            "sections": sections_data(s for s in sections if s.sentences or s.tables or s.drawings),
        }
        return typeset_pdf(data, self.drawings, self.date)


def learned_report(learned: Learned, system: System = "si") -> LearnedReport:
    """Return the report of what was learned."""
    last = moment_of(learned.grid.start + float(learned.grid.time[-1]))

    drawings = tuple(
        Drawing(of.draw, of.caption, of.caption) for of in learned_pictures(learned, system)
    )
    return LearnedReport(shown(learn_sheet(learned), system), drawings, last.date().isoformat())
