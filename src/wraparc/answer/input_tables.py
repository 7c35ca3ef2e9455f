"""Inputs as tables: one below the other for an arc, side by side for a whole drive."""

from collections.abc import Iterable, Sequence

from wraparc.answer.inputs import Input, arc_inputs
from wraparc.answer.sheet import Row, Table
from wraparc.answer.sources import Sources
from wraparc.arc import WrapArc
from wraparc.drive import Drive

_TENSIONS = (
    "T1 at the entry nip, T2 at the exit nip; computed from power or Te where these are inputs."
)
#: Things alike that fit beside each other on a page, with room for their sources.
_ABREAST = 4


def input_table(drive: Drive, arc: WrapArc, of: Sources) -> Table:
    """Return what was given for one arc."""
    title = f"Inputs: pulley {arc.pulley}, load case {arc.load_case}"
    return Table(title, input_rows(arc_inputs(drive, arc), of), name="inputs")


def input_rows(inputs: Iterable[Input], of: Sources) -> tuple[Row, ...]:
    """Return a row for each input that is given."""
    return tuple(
        Row(entry.title, (entry.text(),), entry.symbol, entry.note(of), entry.name)
        for entry in inputs
        if entry.value is not None
    )


def input_tables(
    inputs: Iterable[Input], of: Sources, *, stated: bool = False
) -> tuple[Table, ...]:
    """Return tables of inputs; things alike, as two pulleys, side by side in one.

    Parameters
    ----------
    inputs
        From `drive_inputs` or `train_inputs`.
    of
        Takes up the sources.
    stated
        Whether it is said of what was just given that it was.
    """
    groups: dict[str, list[Input]] = {}
    for entry in inputs:
        if entry.value is not None:
            groups.setdefault(entry.group, []).append(entry)
    alike: dict[tuple[str, ...], list[str]] = {}
    for group, entries in groups.items():
        kind = group.partition(" ")[0]
        alike.setdefault((kind, *(e.title for e in entries)), []).append(group)

    def note(same: Sequence[Input]) -> str:
        notes = [e.note(of) or (e.origin.kind_text if e.origin and stated else "") for e in same]
        return "; ".join(dict.fromkeys(filter(None, notes)))

    tables = []
    for (kind, *_), names in alike.items():
        if kind == "Load":
            rows = tuple(
                Row(
                    name.removeprefix("Load case "),
                    tuple(entry.text() for entry in groups[name]),
                    note=note(groups[name]),
                )
                for name in names
            )
            heads = tuple(entry.symbol for entry in groups[names[0]])
            tables.append(Table("Tensions", rows, heads, _TENSIONS, "inputs"))
            continue
        for start in range(0, len(names), _ABREAST):
            some = names[start : start + _ABREAST]
            rows = tuple(
                Row(same[0].title, tuple(e.text() for e in same), same[0].symbol, note(same))
                for same in zip(*(groups[name] for name in some), strict=True)
            )
            heads = tuple(name.removeprefix(f"{kind} ") for name in some)
            one = len(some) == 1
            title = some[0] if one else f"{kind}s"
            tables.append(Table(title, rows, ("",) if one else heads, name="inputs"))
    return tuple(tables)
