"""What names and constants of Python become in JavaScript."""

from __future__ import annotations

import dataclasses
import json
import math
from typing import Any, NamedTuple, NoReturn

#: Names that a function of Python may use and JavaScript keeps for itself.
RESERVED = frozenset({
    "arguments", "case", "catch", "const", "debugger", "default", "delete", "do", "enum", "eval",
    "export", "extends", "function", "implements", "instanceof", "interface", "let", "new",
    "package", "private", "protected", "public", "static", "super", "switch", "this", "throw",
    "typeof", "var", "void",
})  # fmt: skip


#: Marks a field or an argument without a default.
REQUIRED = object()


class Refused(Exception):  # noqa: N818 - it reads as what happened
    """A construct that is not translated."""


class Where(NamedTuple):
    """A place in a source file."""

    file: str
    line: int

    def refuse(self, why: str) -> NoReturn:
        """Raise an error that names the place."""
        raise Refused(f"{self.file}:{self.line}: {why}")


def local(name: str) -> str:
    """Return the name of a variable."""
    return f"{name}_" if name in RESERVED else name


def is_named_tuple(kind: object) -> bool:
    """Whether something is a class of named tuples."""
    return isinstance(kind, type) and issubclass(kind, tuple) and hasattr(kind, "_fields")


def is_class(kind: object) -> bool:
    """Whether something is a class that is translated: of the package's own making, no tuple."""
    return isinstance(kind, type) and (dataclasses.is_dataclass(kind) or "__init__" in vars(kind))


def fields_of(kind: Any) -> dict[str, Any]:
    """Return the fields of a named tuple or data class by name, `REQUIRED` or their defaults."""
    if is_named_tuple(kind):
        return {f: kind._field_defaults.get(f, REQUIRED) for f in kind._fields}
    found = {}
    for field in dataclasses.fields(kind):
        missing = field.default is dataclasses.MISSING
        found[field.name] = REQUIRED if missing else field.default
    return found


def literal(value: object, where: Where) -> str:
    """Return a constant as JavaScript writes it."""
    if value is None:
        return "null"
    if isinstance(value, str):
        return json.dumps(str(value), ensure_ascii=False)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int):
        return repr(value)
    if isinstance(value, float):
        return _number(value)
    if is_named_tuple(type(value)):
        return f"new {type(value).__name__}({_literals(value, where)})"
    if isinstance(value, tuple | list):
        return f"[{_literals(value, where)}]"
    return where.refuse(f"the constant {repr(value)[:60]} is not translated")


def _literals(values: Any, where: Where) -> str:
    return ", ".join(literal(value, where) for value in values)


def _number(value: float) -> str:
    if math.isnan(value):
        return "NaN"
    if math.isinf(value):
        return "Infinity" if value > 0.0 else "-Infinity"
    return repr(value)
