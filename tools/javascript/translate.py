"""Functions of Python to the text of a JavaScript module."""

from __future__ import annotations

from collections.abc import Iterable
from types import FunctionType
from typing import Any

from javascript.function import Function
from javascript.names import Where, literal

#: What Python has built in. Like Python's, `max` and `min` keep the first of two that do not
#: compare, NaN among them; what is left of a division has the sign of the divisor.
_BUILT_IN = """\
const max = (a, b) => (b > a ? b : a);
const min = (a, b) => (b < a ? b : a);
const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a));
const modulo = (a, b) => (a % b !== 0 && a % b < 0 !== b < 0 ? (a % b) + b : a % b);
const NOTHING = new Float64Array(0);
const zeros = (size) => (size > 0 ? new Float64Array(size) : NOTHING);
"""


class Module:
    """A module in the making: what was asked for, and what that asks for.

    Attributes
    ----------
    package
        Package whose functions are translated; those of others are refused.
    """

    def __init__(self, package: str) -> None:
        self.package = package
        self._functions: dict[str, FunctionType] = {}
        self._texts: list[str] = []
        self._classes: dict[str, tuple[type, str]] = {}
        self._constants: dict[str, str] = {}

    def function(self, wanted: FunctionType) -> str:
        """Return the name of a function, translated with whatever it calls."""
        name = f"{wanted.__module__.rpartition('.')[2]}__{wanted.__name__}"
        if name not in self._functions:
            self._functions[name] = wanted
            self._texts.append(Function(self, wanted, name).text())
        elif self._functions[name] is not wanted:
            where = Where(wanted.__code__.co_filename, wanted.__code__.co_firstlineno)
            where.refuse(f"another function is called {name}")
        return name

    def named_tuple(self, wanted: Any, where: Where) -> str:
        """Return the name of a class of named tuples."""
        name: str = wanted.__name__
        known, _ = self._classes.setdefault(name, (wanted, _class_text(wanted, where)))
        if known is not wanted:
            where.refuse(f"another named tuple is called {name}")
        return name

    def constant(self, name: str, value: object, where: Where) -> str:
        """Return the name of a constant, or what it is where the name means something else."""
        text = literal(value, where)
        if name.isupper() and self._constants.setdefault(name, text) == text:
            return name
        return text

    def text(self) -> str:
        """Return the module, what is used before what uses it."""
        classes = [text for _, text in self._classes.values()]
        constants = [f"const {name} = {text};" for name, text in self._constants.items()]
        return "\n".join([_BUILT_IN, *classes, *constants, "", *self._texts])


def translate(entries: Iterable[FunctionType], package: str) -> str:
    """Return a JavaScript module that exports functions and whatever they call.

    Raises
    ------
    Refused
        With file and line of what is not translated.
    """
    module = Module(package)
    for entry in entries:
        module.function(entry)
    return module.text()


def _class_text(kind: Any, where: Where) -> str:
    """Return a class with the fields of a named tuple, that can be taken apart like one."""
    fields, defaults = kind._fields, kind._field_defaults
    given = [f"{f} = {literal(defaults[f], where)}" if f in defaults else f for f in fields]
    lines = [
        f"export class {kind.__name__} {{",
        f"constructor({', '.join(given)}) {{",
        *(f"this.{field} = {field};" for field in fields),
        "}",
        "*[Symbol.iterator]() {",
        *(f"yield this.{field};" for field in fields),
        "}",
        "}",
        "",
    ]
    return "\n".join(lines)
