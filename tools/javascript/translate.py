"""Functions of Python to the text of a JavaScript module."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from types import FunctionType
from typing import Any

from javascript.function import Function
from javascript.names import REQUIRED, Where, fields_of, is_named_tuple, literal, local

#: What Python has built in. Like Python's, `max` and `min` keep the first of two that do not
#: compare, NaN among them; what is left of a division has the sign of the divisor.
_BUILT_IN = """\
const max = (a, b) => (b > a ? b : a);
const min = (a, b) => (b < a ? b : a);
const copysign = (a, b) => (b < 0 || Object.is(b, -0) ? -Math.abs(a) : Math.abs(a));
const modulo = (a, b) => (a % b !== 0 && a % b < 0 !== b < 0 ? (a % b) + b : a % b);
const EMPTY = /* @__PURE__ */ new Float64Array(0);
const zeros = (size) => (size > 0 ? new Float64Array(size) : EMPTY);
"""
#: The same, where more than numbers are translated.
_OF_SEQUENCES = """\
const $sum = (of) => of.reduce((a, b) => a + b, 0);
const $maxOf = (of) => of.reduce((a, b) => max(a, b));
const $minOf = (of) => of.reduce((a, b) => min(a, b));
const $made = (length, each) => Array.from({ length }, (_, i) => each(i));
const $zip = (...of) => $made(Math.min(...of.map((x) => x.length)), (i) => of.map((x) => x[i]));
const $pairwise = (of) => $zip(of, of.slice(1));
const $enumerate = (of) => Array.from(of, (x, i) => [i, x]);
const $range = (a, b) => (b === undefined ? $made(a, (i) => i) : $made(b - a, (i) => a + i));
const $repeated = (of, times) => $made(times, () => of).flat();
const $sorted = (of, key = (x) => x) => [...of].sort((a, b) => key(a) - key(b));
const $first = (of, other) => (of.length > 0 ? of[0] : other);
const $even = (x, how, digits) => {
  const [all, power] = x[how](100).split("e");
  const cut = all.slice(0, all.indexOf(".") + 1 + digits);
  const tie = /^50*$/.test(all.slice(cut.length)) && /[02468]\\.?$/.test(cut);
  return tie ? cut.replace(/\\.$/, "") + (power ? `e${power}` : "") : x[how](digits);
};
const $told = (x, sign, digits, how) => {
  const scientific = how === "f" ? "" : $even(x, "toExponential", digits - (how === "g"));
  let text = scientific || $even(x, "toFixed", digits);
  const power = Number(text.split("e")[1]);
  if (how === "g" && power >= -4 && power < digits) text = $even(x, "toFixed", digits - 1 - power);
  if (how === "g" && text.includes(".")) text = text.replace(/\\.?0+(?=e|$)/, "");
  text = text.replace(/e([+-])(\\d)$/, "e$10$2");
  return sign && !text.startsWith("-") ? `+${text}` : text;
};
const $text = (x) => {
  if (typeof x !== "string") throw new TypeError(`${x} is no text`);
  return x;
};
"""


class Module:
    """A module in the making: what was asked for, and what that asks for.

    Attributes
    ----------
    package
        Package whose functions are translated; those of others are refused.
    instead
        Functions in the place of others; by name those that are JavaScript from the start.
    elsewhere
        What another module exports, by name.
    """

    def __init__(
        self, package: str, instead: Mapping[Any, Any], elsewhere: Mapping[str, object]
    ) -> None:
        self.package, self.instead, self.elsewhere = package, instead, elsewhere
        self.taken = set[str]()  # from there
        self.natives = set[str]()  # functions that JavaScript has in the place of Python's
        self._functions: dict[str, FunctionType] = {}
        self._texts: list[str] = []
        self._classes: dict[str, type] = {}
        self._constants: dict[str, str] = {}
        self._names = set[str]()  # of what is reached in objects
        self._called: dict[str, Where] = {}
        self._methods: dict[tuple[str, str], str] = {}

    def function(self, wanted: FunctionType) -> str:
        """Return the name of a function, translated with whatever it calls."""
        name = f"{wanted.__module__.rpartition('.')[2]}__{wanted.__name__}"
        if self.elsewhere.get(name) is wanted:
            self.taken.add(name)
            return name
        if name not in self._functions:
            self._functions[name] = wanted
            self._texts.append(Function(self, wanted, name).text())
        elif self._functions[name] is not wanted:
            where = Where(wanted.__code__.co_filename, wanted.__code__.co_firstlineno)
            where.refuse(f"another function is called {name}")
        return name

    def native(self, name: str) -> str:
        """Return the name of a function that is JavaScript from the start."""
        self.natives.add(name)
        return name

    def kind(self, wanted: Any, where: Where) -> str:
        """Return the name of a class: of named tuples, or of objects."""
        name: str = wanted.__name__
        if self.elsewhere.get(name) is wanted:
            self.taken.add(name)
            return name
        if not is_named_tuple(wanted):
            for base in wanted.__bases__:
                if base.__module__.partition(".")[0] == self.package:
                    self.kind(base, where)
        if self._classes.setdefault(name, wanted) is not wanted:
            where.refuse(f"another class is called {name}")
        return name

    @property
    def exports(self) -> dict[str, object]:
        """What it exports, by name."""
        return {**self._functions, **self._classes}

    def reached(self, name: str) -> None:
        """Take note that something of this name is wanted of an object."""
        self._names.add(name)

    def called(self, name: str, where: Where) -> None:
        """Take note that a method is called."""
        self._names.add(name)
        self._called.setdefault(name, where)

    def constant(self, name: str, value: object, where: Where) -> str:
        """Return the name of a constant, or what it is where the name means something else."""
        text = literal(value, where)
        if name.isupper() and self._constants.setdefault(name, text) == text:
            return name
        return text

    def text(self) -> str:
        """Return the module, what is used before what uses it."""
        while self._more():
            pass
        for name, where in self._called.items():
            if all(name != method for _, method in self._methods):
                where.refuse(f"no class has the method {name}")
        classes = [self._class_text(kind) for kind in self._classes.values()]
        constants = [f"const {name} = {text};" for name, text in self._constants.items()]
        parts = "\n".join([*classes, *constants, "", *self._texts])
        many = [_OF_SEQUENCES] if "$" in parts else []
        return "\n".join([_BUILT_IN, *many, parts])

    def _more(self) -> bool:
        """Translate methods that are wanted and were not yet; whether there were any."""
        before = len(self._methods)
        for kind in [*self._classes.values()]:
            if is_named_tuple(kind):
                continue
            for name, found in vars(kind).items():
                key = kind.__name__, name
                wanted = name in self._names or (name == "__init__" and not fields(kind))
                if wanted and key not in self._methods:
                    told = self._method(name, found)
                    if told:
                        self._methods[key] = told
        return len(self._methods) > before

    def _method(self, name: str, found: Any) -> str:
        if isinstance(found, FunctionType):
            of = "constructor" if name == "__init__" else name
            return Function(self, found, of).method()
        get = found.func if isinstance(found, cached_property) else getattr(found, "fget", None)
        return Function(self, get, name).method("get") if isinstance(get, FunctionType) else ""

    def _class_text(self, kind: Any) -> str:
        """Return a class with its fields, and the methods that are wanted."""
        where = Where(kind.__module__, 1)
        above = [b.__name__ for b in kind.__bases__ if b.__name__ in self._classes]
        named = fields(kind)
        given = [
            local(f) + ("" if named[f] is REQUIRED else f" = {literal(named[f], where)}")
            for f in named
        ]
        lines = [f"export class {kind.__name__}{' extends ' + above[0] if above else ''} {{"]
        if named:
            lines += [f"constructor({', '.join(given)}) {{", *(["super();"] if above else [])]
            lines += [*(f"this.{field} = {local(field)};" for field in named), "}"]
        if is_named_tuple(kind):
            each = (f"yield this.{field};" for field in named)
            lines += ["*[Symbol.iterator]() {", *each, "}"]
        lines += [text for (of, _), text in self._methods.items() if of == kind.__name__]
        return "\n".join([*lines, "}", ""])


def fields(kind: Any) -> dict[str, Any]:
    """Return the fields of a class; none where it makes its objects by a function of its own."""
    return {} if "__init__" in vars(kind) and not _generated(kind) else fields_of(kind)


def _generated(kind: Any) -> bool:
    return is_named_tuple(kind) or hasattr(kind, "__dataclass_fields__")


def translated(
    entries: Iterable[Callable[..., Any]],
    package: str,
    instead: Mapping[Any, Any] | None = None,
    elsewhere: Mapping[str, object] | None = None,
) -> Module:
    """Return the module that exports functions and classes, and whatever they call.

    Parameters
    ----------
    entries
        The functions and classes.
    package
        Whose functions are translated.
    instead
        Functions that stand in the place of others; by name where JavaScript has them.
    elsewhere
        What another module exports, by name: it is imported from there.

    Raises
    ------
    Refused
        With file and line of what is not translated.
    """
    module = Module(package, instead or {}, elsewhere or {})
    for entry in entries:
        if isinstance(entry, type):
            module.kind(entry, Where(entry.__module__, 1))
        elif isinstance(entry, FunctionType):
            module.function(entry)
    return module


def translate(entries: Iterable[Callable[..., Any]], package: str) -> str:
    """Return the text of a module, see `translated`."""
    return translated(entries, package).text()
