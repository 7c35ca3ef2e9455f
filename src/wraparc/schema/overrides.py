"""Values put over those of a document before it is checked: ``pulley.head.exit_tension=55 kN``."""

import datetime as dt
import json
import os
import re
import tomllib
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from wraparc.errors import InputError, Problem, input_error, name_remedy, shown
from wraparc.schema.below import below, own_key
from wraparc.schema.file_kinds import parse_kind
from wraparc.schema.kinds import Kind, table_labels
from wraparc.schema.problems import Place, place_text
from wraparc.schema.source import Document

#: By key path, or texts ``PATH=VALUE``.
Overrides = Mapping[str, object] | Iterable[str]

_STEP = re.compile(
    r"""(?P<bare>[A-Za-z0-9_-]+) | "(?P<quoted>(?:[^"\\]|\\.)*)" | \[(?P<index>[0-9]{1,6})\]""",
    re.VERBOSE,
)
_LONGEST = 2000
_T = TypeVar("_T")


def parse_override(text: str) -> tuple[str, object]:
    """Return key path and value of ``PATH=VALUE``, as given on a command line.

    The value is read as TOML where it is a number, true, false, an array, an inline table
    or text in quotes; anything else is text: ``belt.width=1400 mm`` needs no quotes. An
    empty value takes the key away (None).

    Raises
    ------
    InputError
        If there is no path or no equals sign.
    """
    path, equals, value = text.partition("=")
    if not equals or not path.strip():
        raise _refused(text, "no setting of a key", "Write KEY=VALUE, belt.width=1400 mm.")
    return path.strip(), _value(value.strip())


def parse_path(path: str) -> Place:
    """Return the steps of a key path: keys, names, and positions from 1 in brackets.

    ``pulley.head.exit_tension``, ``pulley[1].diameter``, ``pulley."head 2".power``.
    """
    steps: list[str | int] = []
    position = 0
    while position < len(path):
        match = _STEP.match(path, position)
        if match is None:
            break
        if match["index"]:
            steps.append(int(match["index"]))
        elif match["quoted"] is not None:
            steps.append(_unquoted(match["quoted"], path))
        else:
            steps.append(match["bare"])
        position = match.end()
        if position < len(path) and path[position] == "." and position + 1 < len(path):
            position += 1
        elif position < len(path) and path[position] != "[":
            break
    if position < len(path) or not steps or isinstance(steps[0], int) or len(path) > _LONGEST:
        remedy = 'Write keys with dots between them: pulley.head.diameter, pulley."head 2".power.'
        raise _refused(path, "no key path", remedy)
    return tuple(steps)


def put_over(
    document: Document, overrides: Overrides, table: Kind | None = None, *, file: str = ""
) -> Document:
    """Return a document with values put over its own; the document itself is not changed.

    Parameters
    ----------
    document
        Tables of a file.
    overrides
        By key path or as texts. A table of an array is found by its name or by position.
        None takes a key away. A path that goes on below a text that may also be a table
        (``pulley.head.lagging.thickness``) makes it a table with that preset.
    table
        What the document may hold: tells other words for keys, and texts that may be tables.
    file
        What to call the document in messages.

    Raises
    ------
    InputError
        If a path leads nowhere, with the names there are.
    """
    pairs = overrides.items() if isinstance(overrides, Mapping) else map(parse_override, overrides)
    result: Any = document
    for path, value in pairs:
        steps = parse_path(path)
        try:
            result = _put(result, steps, (), value, table)
        except InputError as error:
            raise InputError(
                Problem(message=p.message, remedy=p.remedy, file=file, key=path, value=shown(value))
                for p in error.problems
            ) from None
    return dict(result)


def read_document(
    path: str | os.PathLike[str],
    overrides: Overrides = (),
    table: Kind | None = None,
    file_kind: str = "",
) -> Document:
    """Return the document of a file with values put over its own.

    Parameters
    ----------
    path
        The file.
    overrides, table
        As for `put_over`.
    file_kind
        What kind of file it must be, see `wraparc.schema.file_kinds`; any if empty.

    Raises
    ------
    InputError
        If the file cannot be read, is no TOML, of another kind, or an override does not fit.
    """
    return put_over(parse_kind(path, file_kind), overrides, table, file=os.fspath(path))


def load(
    path: str | os.PathLike[str],
    read: Callable[..., _T],
    overrides: Overrides = (),
    table: Kind | None = None,
    file_kind: str = "",
    **more: Any,
) -> _T:
    """Return what `read` makes of the document of a file, told its name and its folder."""
    name = os.fspath(path)
    document = read_document(path, overrides, table, file_kind)
    return read(document, file=name, folder=os.path.dirname(name), **more)


def _put(node: object, steps: Place, done: Place, value: object, kind: Kind | None) -> Any:
    """Return a copy of a node with the value at the place; what is not on the way is shared."""
    if not steps:
        return value
    step, rest = steps[0], steps[1:]
    if isinstance(node, list):
        index = _index(node, step, done)
        changed = _put(node[index], rest, (*done, step), value, below(kind, index))
        kept = [] if not rest and value is None else [changed]
        return [*node[:index], *kept, *node[index + 1 :]]
    if isinstance(node, str) and below(kind, "preset"):
        node = {"preset": node}
    if not isinstance(node, dict) or isinstance(step, int):
        where = f"{place_text(done)} has" if done else "this file has"
        raise input_error(message=f"{where} nothing called {place_text((step,))}")
    step = own_key(kind, step)
    node = {own_key(kind, key): item for key, item in node.items()}
    if not rest and value is None:
        return {key: item for key, item in node.items() if key != step}
    inner = below(kind, step, node)
    return {**node, step: _put(node.get(step, {}), rest, (*done, step), value, inner)}


def _index(rows: list[Any], step: str | int, done: Place) -> int:
    """Return the index of the row of a name, or of a position from 1."""
    labels = table_labels(rows)
    if step in labels and not isinstance(step, int):
        return labels.index(step)
    position = step if isinstance(step, int) else int(step) if step.isdecimal() else 0
    if 1 <= position <= len(rows):
        return position - 1
    names = [str(label) for label in labels]
    raise input_error(
        message=f"{place_text(done)} has nothing called {shown(step)}",
        remedy=name_remedy(step, names),
    )


def _value(text: str) -> object:
    if not text:
        return None
    if text[0] in "\"'[{" or text in ("true", "false") or re.match(r"[+-]?[0-9.]", text):
        try:
            read = tomllib.loads(f"v = {text}")
        except (ValueError, RecursionError):
            return text
        value = read.get("v")
        dates = (dt.date, dt.time)
        if read.keys() == {"v"} and not isinstance(value, dates):
            return value
    return text


def _unquoted(text: str, path: str) -> str:
    try:
        return str(json.loads(f'"{text}"'))
    except ValueError:
        raise _refused(path, "no key path", "Mind the quotes.") from None


def _refused(text: str, message: str, remedy: str) -> InputError:
    return input_error(message=message, remedy=remedy, value=shown(text))
