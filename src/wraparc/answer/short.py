"""The short answer: what of a sheet fits one screen, chosen from it and never worded anew.

The verdict with what governs it and what to do leads, then the checks that are missed or nearest
to their limits and the numbers that a design is settled by; then what was not checked, what the
data is worth, and where the rest is. Whatever asks for attention is shown, or counted by its table.
"""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from wraparc.answer.key_figures import key_figures
from wraparc.answer.sheet import NONE, Row, Sheet, Table
from wraparc.checks import Level

#: Remarks of a short answer, longest text under a title.
_REMARKS, _SUBTITLE = 12, 100


@dataclass(frozen=True)
class _Pick:
    """What a short answer shows of the tables of one name.

    Attributes
    ----------
    rows
        How their names in the glossary or their titles begin; all of them if empty.
    most
        Rows at most: those that ask for attention stay, then the first.
    tables
        So many tables at most, the first.
    alone
        Whether it is shown only where it is the only one of its name.
    noted
        Whether what there is to know of its rows is said.
    judged
        Whether its rows that ask for attention are among the checks, and are no news here.
    explained
        Whether its own note is said.
    key
        Whether its rows of key figures are shown.
    """

    rows: tuple[str, ...] = ()
    most: int = 8
    tables: int = 1
    alone: bool = False
    noted: bool = True
    judged: bool = False
    explained: bool = False
    key: bool = False


#: By name, the tables that a short answer shows, in the order of their sheet.
_PICKED: dict[str, _Pick] = {
    # a drive
    "checks": _Pick(),
    "conditions": _Pick(rows=("verdict", "minimum_tension"), judged=True),
    "cases": _Pick(most=9),
    "conveyor": _Pick(),
    "drives": _Pick(
        rows=("share", "effective", "motor_load", "speed_trim", "exit_c"), alone=True, noted=False
    ),
    "width": _Pick(rows=("largest_running", "energy_un", "Not")),
    "result": _Pick(judged=True, key=True),
    "capacity": _Pick(key=True),
    "energy": _Pick(key=True),
    "life": _Pick(rows=("life",)),
    # questions about it
    "trim": _Pick(),
    "changed": _Pick(),
    "changes": _Pick(
        rows=(
            "Result", "Verdict", "entry_t", "exit_t", "effective", "exit_creep", "peak_shear_s",
            "power_loss", "Minimum", "The same", "Belt across",
        ),
        most=12, noted=False,
    ),
    "levels": _Pick(),
    "wear": _Pick(rows=("wear", "life")),
    "values": _Pick(),
    "ranking": _Pick(most=6, explained=True),
    "rejected": _Pick(most=4),
    "drums": _Pick(
        rows=("peak_pull", "peak_torque", "peak_creep", "time_over_limit", "friction_work")
    ),
    "vibrations": _Pick(),
    "controls": _Pick(),
    "estimates": _Pick(),
    "misfit": _Pick(most=6),
    "predicted": _Pick(most=12),
    "learned": _Pick(most=12, tables=2),
    "records": _Pick(),
    # many designs
    "groups": _Pick(tables=1000),
    "together": _Pick(explained=True),
    "indices": _Pick(),
    "alone": _Pick(),
    "designs": _Pick(most=12),
    # laggings and their tests
    "left-out": _Pick(most=4),
    "slips": _Pick(tables=3),
    "lagging": _Pick(most=10),
    "friction": _Pick(most=12),
}  # fmt: skip
#: What is shown of tables that are not picked, and of one without a name: it is all that there is.
_NOTHING, _WHOLE = _Pick(tables=0), _Pick(most=100, tables=100, explained=True)
#: Tables that go on with the one before, where both have the same columns.
_GO_ON = ("capacity", "energy", "life")


def short_sheet(sheet: Sheet, table_hint: str = "", rest: str = "") -> Sheet:
    """Return the short answer of a sheet.

    Parameters
    ----------
    sheet
        All that there is to show.
    table_hint
        How one table is asked for, before its name; nothing where it cannot be.
    rest
        How the rest is reached; nothing is said of it if empty.
    """
    names, seen = Counter(table.name for table in sheet.tables), Counter[str]()
    shown: list[Table] = []
    hidden: list[tuple[Table, Sequence[Row]]] = []
    cut = 0
    for table in sheet.tables:
        pick = _PICKED.get(table.name, _NOTHING) if table.name else _WHOLE
        seen[table.name] += 1
        if seen[table.name] > pick.tables or (pick.alone and names[table.name] > 1):
            hidden.append((table, table.rows))
            continue
        part = table.short
        if part is None:
            wanted = _wanted(table, pick)
            rows = _first(wanted, pick.most)
            cut += len(wanted) - len(rows)
            left = [row for row in table.rows if row not in rows]
            hidden += [] if pick.judged else [(table, left)]
            part = _part(table, rows, pick)
        elif part.rows:
            cut += len(table.rows) - len(part.rows)
        if not part.rows:
            continue
        before = shown[-1] if shown else None
        if before and table.name in _GO_ON and before.heads == part.heads:
            shown[-1] = replace(before, rows=before.rows + part.rows)
        else:
            shown.append(part)
    remarks = (sheet.remarks if sheet.kept is None else sheet.kept)[:_REMARKS]
    ground = () if len(sheet.sources) > 1 else sheet.sources  # what all of it is based on
    left_out = {
        "sentence": len(sheet.verdict.sentences) if sheet.verdict else 0,
        "remark": sum(remark not in remarks for remark in sheet.remarks),
        "row": cut,
        "table": len(sheet.tables) - len(shown),
    }
    bare = Sheet(
        title=sheet.title,
        subtitle=sheet.subtitle if len(sheet.subtitle) <= _SUBTITLE else "",
        verdict=sheet.verdict and replace(sheet.verdict, sentences=()),
        tables=tuple(shown),
        foot=(
            *(table.brief for table in sheet.tables if table.brief),
            *remarks,
            *(source for source in ground if source not in remarks),
            *_attention(hidden, table_hint),
            *([f"More  {rest}"] if rest and any(n > 0 for n in left_out.values()) else []),
        ),
    )
    return _unnumbered(bare, len(sheet.sources))


def _wanted(table: Table, pick: _Pick) -> list[Row]:
    """Return the rows that a pick names, and those that ask for attention."""
    names = {figure.name for figure in key_figures("short")} if pick.key else set()
    every = not pick.rows and not pick.key
    return [
        row
        for row in table.rows
        if every or (_bad(row) and not pick.judged) or row.name in names
        or row.name.startswith(pick.rows) or row.title.startswith(pick.rows)
    ]  # fmt: skip


def _first(rows: Sequence[Row], most: int) -> list[Row]:
    """Return so many rows at most, those that ask for attention before the first ones."""
    first = sorted(range(len(rows)), key=lambda i: (not _bad(rows[i]), i))[:most]
    return [rows[i] for i in sorted(first)]


def _part(table: Table, rows: list[Row], pick: _Pick) -> Table:
    """Return a table of some rows, without columns that are empty in them."""
    told = [k for k in range(len(table.heads)) if any(row.values[k] != NONE for row in rows)]
    if len(told) < len(table.heads):
        rows = [replace(row, values=tuple(row.values[k] for k in told)) for row in rows]
    heads = tuple(table.heads[k] for k in told)
    if not pick.noted:
        rows = [replace(row, note=str(row.level) if _bad(row) else "") for row in rows]
    note = table.note if pick.explained else ""
    return replace(table, rows=tuple(rows), heads=heads, note=note)


def _bad(row: Row) -> bool:
    return row.level is not None and row.level.rank >= Level.ATTENTION.rank


def _attention(hidden: Sequence[tuple[Table, Sequence[Row]]], hint: str) -> Iterator[str]:
    """Say where rows ask for attention that are not shown."""
    for table, rows in hidden:
        bad = Counter(str(row.level) for row in rows if _bad(row))
        if bad:
            told = ", ".join(f"{level} in {count} rows" for level, count in bad.items())
            where = f" ({hint} {table.name})" if hint and table.name else ""
            yield f"{table.title}: {told.replace(' 1 rows', ' 1 row')}{where}."


def _unnumbered(sheet: Sheet, sources: int) -> Sheet:
    """Return a sheet without the numbers of sources, which it does not list."""
    marks = re.compile(rf" ?\[(?:{'|'.join(map(str, range(1, sources + 1)))})\]")

    def plain(row: Row) -> Row:
        return replace(row, note=marks.sub("", row.note)) if sources else row

    tables = (replace(t, rows=tuple(map(plain, t.rows))) for t in sheet.tables)
    return replace(sheet, tables=tuple(tables))
