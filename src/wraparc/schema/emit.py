"""Documents to TOML text, laid out for people: short tables on one line, values by tomli_w."""

import textwrap
from collections.abc import Iterator, Mapping
from typing import Any

from wraparc.schema.below import below, tables_of
from wraparc.schema.kinds import Kind, TextOr

_WIDTH = 100


def document_text(document: Mapping[str, Any], table: Kind | None = None) -> str:
    """Return a document as TOML text; `table`, what it may hold, says what goes on one line."""
    return "\n".join(_table(document, (), table)).lstrip("\n") + "\n"


def _table(table: Mapping[str, Any], path: tuple[str, ...], kind: Kind | None) -> Iterator[str]:
    kinds = {key: below(kind, key, table) for key in table}
    later: list[tuple[str, Any]] = []
    for key, value in table.items():
        if _is_table(value, kinds[key]) or _is_tables(value, kinds[key]):
            later.append((key, value))
        else:
            yield f"{_key(key)} = {_value(value)}"
    for key, value in later:
        inner = (*path, key)
        name = ".".join(map(_key, inner))
        if isinstance(value, list):
            for item in value:
                yield f"\n[[{name}]]"
                yield from _table(item, inner, below(kinds[key], 1))
        else:
            of = kinds[key]
            if any(not _is_table(v, below(of, k, value)) for k, v in value.items()) or not value:
                yield f"\n[{name}]"
            yield from _table(value, inner, of)


def _is_table(value: object, kind: Kind | None) -> bool:
    """Whether a value is written as a table of its own, below a head in brackets."""
    if not isinstance(value, Mapping) or _on_one_line(kind):
        return False
    return not isinstance(kind, TextOr) or len(_value(value)) > _WIDTH


def _is_tables(value: object, kind: Kind | None) -> bool:
    if not isinstance(value, list) or not value or _on_one_line(below(kind, 1)):
        return False
    return all(isinstance(item, Mapping) for item in value)


def _on_one_line(kind: Kind | None) -> bool:
    return any(table.on_one_line for table in tables_of(kind))


def _value(value: object) -> str:
    if isinstance(value, Mapping):
        pairs = ", ".join(f"{_key(key)} = {_value(item)}" for key, item in value.items())
        return f"{{ {pairs} }}" if pairs else "{}"
    if isinstance(value, list | tuple):
        items = [_value(item) for item in value]
        line = f"[{', '.join(items)}]"
        if len(line) <= _WIDTH and not any(isinstance(item, Mapping) for item in value):
            return line
        if all(isinstance(item, int | float) for item in value):
            return "[\n" + _filled(items) + "]"
        return "[\n" + "".join(f"  {item},\n" for item in items) + "]"
    return _dumped("k", value).removeprefix("k = ")


def _filled(items: list[str]) -> str:
    """Numbers side by side, as many as a line takes."""
    text = textwrap.fill(
        ", ".join(items) + ",", _WIDTH, initial_indent="  ", subsequent_indent="  "
    )
    return text + "\n"


def _key(key: str) -> str:
    return _dumped(key, 0).removesuffix(" = 0")


def _dumped(key: str, value: object) -> str:
    import tomli_w  # reading a file needs none of it, and start-up is short

    return tomli_w.dumps({key: value}).removesuffix("\n")
