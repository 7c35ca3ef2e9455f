"""Load cases out of the tables that other programs print: tensions by case and pulley."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

from wraparc.drive import CASE_KINDS
from wraparc.drive.case_names import named_kinds
from wraparc.errors import InputError, Problem, format_names, input_error, shown
from wraparc.files.drive_file import drive_from_document
from wraparc.files.tensions import KEYS
from wraparc.machine_tables import (
    NamedColumn,
    NumeralStyle,
    RawTable,
    find_tables,
    plain_name,
    read_bytes,
    read_unit,
)
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.source import Document
from wraparc.units import unit_factor

_EXPORT = "Give a table of load cases with two of T1, T2 and Te."
_DECIMAL = 'Add --decimal "." or --decimal ",".'
#: What a tension is called where no pulley is named.
THE_PULLEY = "drive"
#: Heads of columns by what they hold, without accents and signs: English, German, Spanish, French,
#: Portuguese, Italian.
_CASE = (
    "load case", "loadcase", "case", "condition", "scenario", "lastfall", "betriebszustand",
    "belastungsfall", "caso de carga", "caso", "condicion", "cas de charge", "cas", "condicao",
    "caso di carico", "condizione",
)  # fmt: skip
_PULLEY = (
    "pulley", "drive pulley", "drum", "drive", "trommel", "antriebstrommel", "antrieb", "tambor",
    "polea", "tambor motriz", "accionamiento", "tambour", "poulie", "entrainement", "tamburo",
    "puleggia", "motorizzazione", "acionamento", "polia",
)  # fmt: skip
_TENSIONS = {
    "entry_tension": (
        "t1", "t 1", "f1", "entry tension", "tight side tension", "tight side", "tight", "entry",
        "auflaufende kraft", "auflaufkraft", "auflauf", "lasttrum", "tension de entrada", "entrada",
        "lado tenso", "brin tendu", "tension d entree", "entree", "tensao de entrada",
        "ramo tenso", "ramo teso", "tensione in entrata", "entrata",
    ),
    "exit_tension": (
        "t2", "t 2", "f2", "exit tension", "slack-side tension", "slack-side", "slack", "exit",
        "ablaufende kraft", "ablaufkraft", "ablauf", "leertrum", "tension de salida", "salida",
        "lado flojo", "brin mou", "tension de sortie", "sortie", "tensao de saida", "saida",
        "lado frouxo", "ramo bambo", "ramo lento", "tensione in uscita", "uscita",
    ),
    "effective_tension": (
        "te", "fu", "effective tension", "effective", "umfangskraft", "tension efectiva",
        "fuerza tangencial", "tension effective", "effort tangentiel", "tensao efetiva",
        "forca tangencial", "tensione efficace", "forza periferica", "tiro efficace",
    ),
}  # fmt: skip


_HEADS = {
    role: tuple(map(plain_name, heads))
    for role, heads in {"case": _CASE, "pulley": _PULLEY, **_TENSIONS}.items()
}


@dataclass(frozen=True)
class PrintOut:
    """Load cases of a table.

    Attributes
    ----------
    cases
        Tables of a drive file, in the order of the table.
    pulleys
        Names of the pulleys that have tensions, in the order of the table.
    """

    cases: tuple[dict[str, Any], ...]
    pulleys: tuple[str, ...]


@dataclass(frozen=True)
class _Column:
    """A column of tensions: what it holds, of which pulley, and its unit."""

    index: int
    key: str
    pulley: str
    unit: str
    factor: float


def read_print_out(
    path: str | os.PathLike[str],
    *,
    unit: str = "",
    decimal: str = "",
    pulley: str = "",
    kinds: Mapping[str, str] | None = None,
) -> PrintOut:
    """Read load cases from a table: text with any delimiter, or Excel.

    Parameters
    ----------
    path
        A table with a row for each load case, or for each load case and pulley; columns T1, T2 or
        Te, in a pulley's name if there are several: ``Drive 1 T1 (kN)``.
    unit
        Unit of the tensions where the heads have none.
    decimal
        Decimal sign, where the numbers do not tell.
    pulley
        Name of the pulley where the table has none.
    kinds
        Kind of a load case by its name, where that does not tell.

    Raises
    ------
    InputError
        With what cannot be told, and what to write to tell it.
    """
    file = os.fspath(path)
    tables = find_tables(read_bytes(file, _EXPORT), file).tables
    for table in sorted(tables, key=lambda table: -table.rows):
        named, _ = table.named(lambda name: bool(_role(name)[0]))
        if any(_role(column.name)[0] in KEYS for column in named):
            style = table.found_style(file, _DECIMAL) if not decimal else NumeralStyle(decimal, "")
            return _print_out(table, named, style, file, unit, pulley, dict(kinds or {}))
    raise input_error(file=file, message="contains no table of T1, T2 or Te", remedy=_EXPORT)


def put_into(document: Document, found: PrintOut, file: str = "", folder: str = "") -> Document:
    """Return a drive document with the load cases of a print-out in place of its own.

    Raises
    ------
    InputError
        If it is no drive of its own tensions, or is no drive with these load cases.
    """
    for key in ("conveyor", "train"):
        if key in document:
            message = f"[{key}] gives the load cases of this file already"
            raise input_error(file=file, key=key, message=message, remedy=f"Remove [{key}].")
    names = [str(pulley.get("name", "")) for pulley in document.get("pulley", ())]
    unknown = [name for name in found.pulleys if name not in names]
    if unknown:
        raise input_error(
            file=file,
            key="pulley",
            message=f"no such pulley: {format_names(unknown)}",
            remedy=f"Name the pulleys of the table {format_names(names)}.",
        )
    made = dict(document)
    made["pulley"] = [
        {key: value for key, value in pulley.items() if key not in KEYS}
        for pulley in document.get("pulley", ())
    ]
    made["load_case"] = list(found.cases)
    drive_from_document(made, file=file, folder=folder, allow_paths=True)
    return made


def _role(name: str) -> tuple[str, str]:
    """Return what a column holds, and the pulley in its head: ``("entry_tension", "drive 1")``."""
    plain = plain_name(name)
    for role, heads in _HEADS.items():
        if plain in heads:
            return role, ""
    found = [
        (len(head), role, plain.removesuffix(head).removeprefix(head).strip())
        for role in _TENSIONS
        for head in _HEADS[role]
        if plain.endswith(f" {head}") or plain.startswith(f"{head} ")
    ]
    return max(found)[1:] if found else ("", "")


def _print_out(
    table: RawTable,
    named: Sequence[NamedColumn],
    style: NumeralStyle,
    file: str,
    unit: str,
    pulley: str,
    kinds: dict[str, str],
) -> PrintOut:
    """Return the load cases of a table whose columns are named."""
    names = _texts(table, named, "case")
    if names is None:
        raise input_error(file=file, message="has no column of load cases", remedy=_EXPORT)
    of = _texts(table, named, "pulley")
    columns = [_column(column, unit, file) for column in named if _role(column.name)[0] in KEYS]
    numbers = {column.index: table.numbers(column.index, style) for column in columns}
    cases: dict[str, dict[str, dict[str, str]]] = {}
    sizes: dict[tuple[str, str, str], float] = {}
    problems = []
    for row, name in enumerate(names):
        for column in columns:
            at = column.pulley or (of[row] if of else pulley or THE_PULLEY)
            value = float(numbers[column.index][row])
            tensions = cases.setdefault(name, {}).setdefault(at, {})
            message = "is there twice" if column.key in tensions else ""
            if not isfinite(value):
                message = "no number"
            if message:
                key = f"{name}: {at}: {column.key}"
                line = int(table.lines[row])
                problems.append(Problem(file=file, line=line, key=key, message=message))
            tensions[column.key] = _text(value, column)
            sizes[name, at, column.key] = value * column.factor
    problems += [*_unlike(cases, sizes, file), *_unclear(cases, kinds, file)]
    if problems:
        raise InputError(problems)
    tables = tuple(_case(name, tensions, kinds) for name, tensions in cases.items())
    return PrintOut(tables, tuple(dict.fromkeys(p for case in cases.values() for p in case)))


def _texts(table: RawTable, named: Sequence[NamedColumn], role: str) -> list[str] | None:
    """Return the cells of the column of a role; of load cases, else the first that has words."""
    place = next((c.index for c in named if _role(c.name)[0] == role), None)
    if place is None and role == "case":
        first = table.columns[0]
        words = all(isinstance(cell, str) and any(map(str.isalpha, cell)) for cell in first)
        place = 0 if words and not _role(named[0].name)[0] else None
    return None if place is None else [str(cell).strip() for cell in table.columns[place]]


def _column(column: NamedColumn, unit: str, file: str) -> _Column:
    key, pulley = _role(column.name)
    own = read_unit(column.unit or unit, "force")
    if own is None or own.dimension != "force":
        found = f"the unit {shown(column.unit)}" if column.unit else "no unit"
        raise input_error(
            file=file,
            message=f"column {shown(column.label)} has {found}",
            remedy="Add --unit kN, lbf or kip.",
        )
    return _Column(column.index, key, _as_written(column.name, pulley), own.text, own.factor)


def _as_written(name: str, pulley: str) -> str:
    """Return the name of a pulley as its head has it."""
    at = name.casefold().find(pulley)
    return name[at : at + len(pulley)] if pulley and at >= 0 else pulley


def _text(value: float, column: _Column) -> str:
    """Return a tension as it was printed, in N where its unit is spelt in another way here."""
    try:
        same = unit_factor(column.unit, "force") == column.factor
    except InputError:
        same = False
    number = f"{value:.10g} {column.unit}"
    return number if same else quantity_text(value * column.factor, "force")


#: Difference of T1 - T2 from a Te beside them that rounding in a print-out may make [-].
_ROUNDED = 0.02


def _unlike(
    cases: Mapping[str, dict[str, dict[str, str]]],
    sizes: Mapping[tuple[str, str, str], float],
    file: str,
) -> list[Problem]:
    """Leave out Te beside T1 and T2, and return where it is not their difference."""
    problems = []
    for name, pulleys in cases.items():
        for at, tensions in pulleys.items():
            if len(tensions) < len(_TENSIONS):
                continue
            entry, leaving, pull = (sizes[name, at, key] for key in _TENSIONS)
            if abs(entry - leaving - pull) > _ROUNDED * max(abs(entry), abs(leaving)):
                key, value = f"{name}: {at}", tensions["effective_tension"]
                message, remedy = "T1 - T2 is not Te", "Correct one, or leave it out."
                problems.append(
                    Problem(file=file, key=key, value=value, message=message, remedy=remedy)
                )
            del tensions["effective_tension"]
    return problems


def _unclear(names: Iterable[str], kinds: dict[str, str], file: str) -> list[Problem]:
    """Return what is wrong with the kinds of load cases, told and read."""
    known = list(names)
    problems = [
        Problem(
            file=file,
            key=f"--kind {name}={kind}",
            message="no such load case" if name not in known else "no such kind",
            remedy=f"Write one of {format_names(known if name not in known else CASE_KINDS)}.",
        )
        for name, kind in kinds.items()
        if name not in known or kind not in CASE_KINDS
    ]
    return problems + [
        Problem(
            file=file,
            message=f"load case {shown(name)} may be {' or '.join(named_kinds(name))}",
            remedy=f'Add --kind "{name}=running", starting or braking.',
        )
        for name in known
        if name not in kinds and len(named_kinds(name)) > 1
    ]


def _case(name: str, tensions: dict[str, dict[str, str]], kinds: dict[str, str]) -> dict[str, Any]:
    """Return the table of a load case."""
    kind = kinds.get(name) or next(iter(named_kinds(name)), "running")
    more = {} if kind == "running" else {"kind": kind}
    return {"name": name, **more, "pulley": tensions}
