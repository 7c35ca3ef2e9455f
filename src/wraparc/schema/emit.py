"""Documents to TOML text, laid out for people: short tables on one line, values by tomli_w."""

import textwrap
from collections.abc import Iterator, Mapping
from typing import Any

_WIDTH = 100
# Tables that read best on a line of their own.
_ON_ONE_LINE = ("provenance", "knots", "pieces", "rows")
_UNDER = (("sources",),)


def document_text(document: Mapping[str, Any]) -> str:
    """Return a document as TOML text."""
    return "\n".join(_table(document, ())).lstrip("\n") + "\n"


def _table(table: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[str]:
    later: list[tuple[str, Any]] = []
    for key, value in table.items():
        if _is_table(key, value, path) or _is_tables(key, value):
            later.append((key, value))
        else:
            yield f"{_key(key)} = {_value(value)}"
    for key, value in later:
        below = (*path, key)
        name = ".".join(map(_key, below))
        if isinstance(value, list):
            for item in value:
                yield f"\n[[{name}]]"
                yield from _table(item, below)
        else:
            if any(not _is_table(k, v, below) for k, v in value.items()) or not value:
                yield f"\n[{name}]"
            yield from _table(value, below)


def _is_table(key: str, value: object, path: tuple[str, ...]) -> bool:
    if not isinstance(value, Mapping) or key in _ON_ONE_LINE or path[-1:] in _UNDER:
        return False
    return key != "lagging" or not path or len(_value(value)) > _WIDTH


def _is_tables(key: str, value: object) -> bool:
    if not isinstance(value, list) or not value or key in _ON_ONE_LINE:
        return False
    return all(isinstance(item, Mapping) for item in value)


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
