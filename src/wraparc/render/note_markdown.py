"""A note as Markdown: for a wiki, a ticket, a diff."""

import re
from collections.abc import Iterator

from wraparc.answer.sheet import Table
from wraparc.render.note import Note, Section
from wraparc.render.note_pdf import letters

# What Markdown, or the HTML in it, would take for markup.
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|~$&!])")


def note_markdown(note: Note) -> str:
    """Return a note as Markdown (GitHub's tables, equations in LaTeX between dollar signs)."""
    return "\n".join(_lines(note)) + "\n"


def plain(text: str) -> str:
    """Return a text so that Markdown shows it letter by letter."""
    return _SPECIAL.sub(r"\\\1", text)


def _lines(note: Note) -> Iterator[str]:
    head = note.head
    yield f"# {plain(note.title)}"
    if note.subtitle:
        yield from ("", plain(note.subtitle))
    yield ""
    for title, value in note.title_block:
        yield f"- {title}: {plain(value)}"
    yield ""
    for label, text in note.lines:
        yield f"- **{label}** {plain(text)}"
    for section in note.sections:
        yield from ("", f"## {plain(section.title)}")
        yield from _section(section)
    yield from ("", "## Signatures", "", "| | Prepared | Checked | Approved |", "|---|---|---|---|")
    yield f"| Name | {plain(head.author)} | | |"
    yield "| Signature | | | |"
    yield f"| Date | {plain(head.date)} | | |"


def _section(section: Section) -> Iterator[str]:
    if section.sentences:
        yield ""
        for number, sentence in enumerate(section.sentences, start=1):
            yield f"{number}. {plain(sentence)}" if section.numbered else f"- {plain(sentence)}"
    for drawing in section.drawings:
        yield from ("", plain(drawing.alt))
    for equation in section.equations:
        yield from ("", f"{plain(equation.title)}:", "", f"$${equation.latex}$$")
    for table in section.tables:
        yield from _table(table)


def _table(table: Table) -> Iterator[str]:
    yield ""
    if table.title:
        yield from (f"### {plain(table.title)}", "")
    symbols, notes = ([""] if wanted else [] for wanted in (table.has_symbols, table.has_notes))
    heads = ["", *symbols, *table.heads, *notes]
    yield _row(letters(head) for head in heads)
    right = len(table.heads) > 1
    marks = ["---"] * (1 + len(symbols)) + ["--:" if right else "---"] * len(table.heads)
    yield "|" + "|".join(marks + ["---"] * len(notes)) + "|"
    for row in table.rows:
        symbol = [letters(row.symbol)] if symbols else []
        yield _row((row.title, *symbol, *row.values, *([row.note] if notes else [])))
    if table.note:
        yield from ("", plain(table.note))


def _row(cells: "Iterator[str] | tuple[str, ...]") -> str:
    return "| " + " | ".join(plain(cell) for cell in cells) + " |"
