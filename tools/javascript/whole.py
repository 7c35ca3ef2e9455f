"""Functions, classes and constants of Python, translated whole: what reads documents.

`translate` knows numbers alone and writes them as JavaScript computes fastest. Here everything
keeps the meaning of Python, by the functions of `static/python.js`: what is empty is false, equal
is what has equal parts, dicts keep any key. Constants are taken as they are in the running
program, so that a table of keys comes along row by row, with what is asked of its rows alone.
"""

from __future__ import annotations

import ast
import builtins
import dataclasses
import enum
import hashlib
import importlib
import inspect
import itertools
import math
import re
import sys
import textwrap
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from decimal import Decimal
from functools import cached_property
from types import BuiltinFunctionType, FunctionType, MethodType, ModuleType, UnionType
from typing import Any, cast
from weakref import WeakKeyDictionary

from javascript.names import Refused, Where, is_named_tuple, literal, local

_ABSENT = object()
#: The name of a constant in the making.
_CONSTANT = re.compile(r"\$c\d+\b")
_BUILT_IN = {
    **{getattr(builtins, name): name for name in (
        "len", "isinstance", "str", "repr", "int", "float", "bool", "list", "tuple", "set", "any",
        "frozenset", "dict", "all", "sum", "abs", "min", "max", "sorted", "zip", "enumerate",
        "range", "map", "next", "reversed", "iter", "ord", "type", "getattr", "round", "filter",
    )},
    itertools.pairwise: "pairwise", Counter: "Counter", Decimal: "Decimal",
}  # fmt: skip
_TYPES = (str, int, float, bool, dict, list, tuple, Mapping, Sequence)
_ERRORS = {
    kind: f"${kind.__name__}"
    for kind in (KeyError, StopIteration, OverflowError, TypeError, ValueError)
}
_BASES = {dict: "$Dict", Exception: "$Error", ValueError: "$ValueError", object: "$Object"}
_OPERATORS = {
    ast.Add: "$add", ast.Sub: "$sub", ast.Mult: "$mul", ast.Pow: "$pow", ast.BitOr: "$merged",
    ast.BitAnd: "$common",
}  # fmt: skip
_PLAIN = {ast.Div: "/", ast.Mod: "%"}
_COMPARED = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}
#: Methods of texts, lists, dicts, sets and patterns.
_METHODS = frozenset(
    re.findall(
        r"\w+",
        """
    strip lstrip rstrip lower upper capitalize casefold startswith endswith replace removeprefix
    removesuffix partition rpartition split join isprintable isdecimal isascii translate get items
    keys values setdefault pop update append count index isdisjoint match fullmatch search findall
    sub group end start
""",
    )
)
#: Most arguments of those that JavaScript has without the limits, places and counts of Python.
_MOST = {"replace": 2, "split": 1, "startswith": 1, "endswith": 1, "count": 1, "index": 1, "sub": 2}


class Module:
    """A module in the making.

    Attributes
    ----------
    instead
        Functions in the place of others; by name where JavaScript has them.
    frozen
        Functions that always return the same, which is taken as it is.
    without
        Methods that are left out, by name; of one class with it.
    unasked
        Fields of classes that nothing asks a constant for.
    elsewhere
        What another module exports, by name: it is imported from there.
    enums
        Enumerations whose members have more than their values.
    """

    def __init__(
        self,
        package: str,
        instead: Mapping[Any, Any],
        frozen: Iterable[Any] = (),
        without: Iterable[str | tuple[type, str]] = (),
        unasked: Iterable[tuple[type, str]] = (),
        elsewhere: Mapping[str, object] | None = None,
        enums: Iterable[type[enum.Enum]] = (),
    ) -> None:
        self.package, self.instead, self.elsewhere = package, instead, elsewhere or {}
        self.taken = set[str]()  # from there
        self.enums = tuple(enums)
        self._of_members: dict[str, dict[Any, Any]] = {}
        self.frozen, self.without = frozenset(frozen), frozenset(without)
        self.unasked = frozenset(unasked)
        self.natives = set[str]()
        self.left_out = dict[str, str]()
        self.reached, self.by_name = set[str](), set[str]()
        self.called = dict[str, Where]()  # methods of objects
        self.classes: dict[str, Any] = {}
        self._functions: dict[str, tuple[Any, str]] = {}
        self._methods: dict[tuple[str, str], str] = {}
        self._constants: dict[int, tuple[str, Any]] = {}
        self._lines: dict[str, str] = {}
        self._named = dict[str, Any]()
        self._made = dict[int, tuple[Any, Any]]()
        self._alike = dict[tuple[str, ...], tuple[str, ...]]()

    def value(self, value: Any, where: Where) -> str:
        """Return how a value of the running program is written."""
        if isinstance(value, enum.Enum):
            return self.value(value.value, where)
        if value is None or isinstance(value, bool | int | float | str):
            return literal(value, where)
        if self._hashable(value) and value in self.instead:
            other = self.instead[value]
            return self._native(other) if isinstance(other, str) else self.function(other, where)
        if self._hashable(value) and value in self.frozen:
            return f"(() => {self.value(value(), where)})"
        if self._hashable(value) and value in _BUILT_IN:
            return f"$b.{_BUILT_IN[value]}"
        if isinstance(value, BuiltinFunctionType) and hasattr(math, value.__name__):
            return f"$math.{value.__name__}"
        if hasattr(value, "__wrapped__") or isinstance(value, FunctionType):
            return self.function(value, where)
        if isinstance(value, type):
            return self.kind(value, where)
        if isinstance(value, MethodType):
            owner = self.value(value.__self__, where)
            self.reached.add(value.__name__)
            return f"{owner}.{value.__name__}"
        return self._constant(value, where)

    @staticmethod
    def _hashable(value: Any) -> bool:
        return isinstance(value, type | FunctionType | BuiltinFunctionType) or hasattr(
            value, "__wrapped__"
        )

    def _native(self, name: str) -> str:
        self.natives.add(name)
        return name

    def function(self, wanted: Any, where: Where) -> str:
        """Return the name of a function, translated with whatever it calls."""
        plain = inspect.unwrap(wanted)
        if plain.__module__.partition(".")[0] != self.package:
            where.refuse(f"{plain.__module__}.{plain.__qualname__} is not of the package")
        name = f"{plain.__module__.rpartition('.')[2]}__{plain.__name__}"
        if self.elsewhere.get(name) is plain:
            self.taken.add(name)
            return name
        if name not in self._functions:
            self._functions[name] = (plain, "")
            text = Function(self, plain, name).text()
            if plain is not wanted:
                text = f"{text}\nconst $kept_{name} = new Map();"
            self._functions[name] = (plain, text)
        elif self._functions[name][0] is not plain:
            where.refuse(f"another function is called {name}")
        return f"$once({name}, $kept_{name})" if plain is not wanted else name

    def kind(self, wanted: Any, where: Where) -> str:
        """Return the name of a class."""
        if wanted in _ERRORS:
            return _ERRORS[wanted]
        if wanted in _TYPES:
            return f'"{wanted.__name__}"'
        if issubclass(wanted, enum.Enum):
            return "$b.str"
        if wanted.__module__.partition(".")[0] != self.package:
            where.refuse(f"the class {wanted.__module__}.{wanted.__qualname__} is not translated")
        name: str = wanted.__name__
        for base in wanted.__bases__:
            if base.__module__.partition(".")[0] == self.package:
                self.kind(base, where)
        if self.classes.setdefault(name, wanted) is not wanted:
            name = f"{wanted.__module__.rpartition('.')[2]}${name}"
            if self.classes.setdefault(name, wanted) is not wanted:
                where.refuse(f"another class is called {name}")
        return name

    def name_of(self, kind: Any) -> str:
        """Return the name of a class that is there."""
        return next(name for name, known in self.classes.items() if known is kind)

    def told_of_members(self, attribute: str) -> str:
        """Return what members of enumerations have under a name, by their values; empty for none.

        In JavaScript a member is its value alone.
        """
        if attribute not in self._of_members:
            found = {
                member.value: getattr(member, attribute)
                for kind in self.enums
                if attribute in {**vars(kind), **vars(next(iter(kind)))}
                for member in kind
            }
            self._of_members[attribute] = found
        found = self._of_members[attribute]
        return self._constant(found, Where(attribute, 0)) if found else ""

    def _constant(self, value: Any, where: Where) -> str:
        if isinstance(value, tuple | list) and not is_named_tuple(type(value)) and len(value) < 1:
            return "[]"
        if id(value) not in self._constants:
            self._constants[id(value)] = (f"$c{len(self._constants)}", value)
        return self._constants[id(value)][0]

    def _written(self, value: Any, where: Where) -> str:
        """Return what a constant is made of."""

        def each(values: Iterable[Any]) -> str:
            return ", ".join(self.value(v, where) for v in values)

        if isinstance(value, WeakKeyDictionary):
            return "new WeakMap()"
        if isinstance(value, Decimal):
            return f'$Decimal.of("{value}")'
        if isinstance(value, re.Pattern):
            return _pattern(value)
        if isinstance(value, (dict, Mapping)):
            return f"new Map([{', '.join(f'[{each(pair)}]' for pair in value.items())}])"
        if isinstance(value, set | frozenset):
            return f"new Set([{each(sorted(value, key=str))}])"
        if is_named_tuple(type(value)):
            return f"new {self.kind(type(value), where)}({each(value)})"
        if isinstance(value, tuple | list):
            return f"[{each(value)}]"
        kind = self.kind(type(value), where)
        found = getattr(value, "__dict__", {})
        own = {k: v for k, v in found.items() if k in self.reached and not _lazy(type(value), k)}
        own = {k: v for k, v in own.items() if (type(value), k) not in self.unasked}
        names = self._constant(self._alike.setdefault(tuple(own), (*own,)), where)
        return f"$made({kind}, {names}, [{each(own.values())}])"

    def export(self, name: str, value: Any) -> None:
        """Give something under a name."""
        self._named[name] = value

    def text(self) -> str:
        """Return the module."""
        where = Where("exports", 0)
        exports = {name: self.value(value, where) for name, value in self._named.items()}
        size = -1
        while size != self._size():
            size = self._size()
            for kind in [*self.classes.values()]:
                self._translate_methods(kind)
            classes = [self._class_text(name, kind) for name, kind in [*self.classes.items()]]
            statics = [*self._statics()]
            lines: dict[str, str] = {}
            done = set[int]()
            for name, value in [*self._constants.values()]:
                self._emit(name, value, lines, done)
            self._lines = lines
        for name, there in self.called.items():
            if any(hasattr(kind, name) for kind in (str, list, dict, set)) and not any(
                method == name for _, method in self._methods
            ):
                there.refuse(f"`python.js` has no method {name}")
        constants = [f"const {name} = {text};" for name, text in self._lines.items()]
        named = [f"export {{ {text} as {name} }};" for name, text in exports.items()]
        functions = [text for _, text in self._functions.values()]
        text = "\n".join([*functions, *classes, *constants, *statics, *named, ""])
        names = self._lasting()
        return _CONSTANT.sub(lambda found: names[found[0]], text)

    def _lasting(self) -> dict[str, str]:
        """Return names of constants by what they are, in the place of their numbers.

        One is called by the global that it is, or by its place in one, so that a row that comes to
        a table changes no other's name.
        """
        translated = [*self.classes.values(), *(of for of, _ in self._functions.values())]
        known = {
            id(value): f"{module}.{name}"
            for module in sorted({of.__module__ for of in translated}, reverse=True)
            for name, value in vars(sys.modules[module]).items()
        } | {id(names): " ".join(names) for names in self._alike.values()}
        places = {n: known[id(v)] for n, v in self._constants.values() if id(v) in known}
        within = {inner for text in self._lines.values() for inner in _CONSTANT.findall(text)}

        def put_parts(of: str) -> None:
            alike = Counter[str]()
            for inner in _CONSTANT.findall(self._lines[of]):
                plain = _CONSTANT.sub("", self._lines[inner])
                label = next(iter(re.findall(r'"[^"]*"', plain)), plain[:9])
                alike[label] += 1
                if inner not in places:
                    places[inner] = f"{places[of]}/{label}{alike[label]}"
                    put_parts(inner)

        for name in [*places]:
            put_parts(name)
        for name in [n for n in self._lines if n not in within and n not in places]:
            places[name] = _CONSTANT.sub("", self._lines[name])
            put_parts(name)
        lasting: dict[str, str] = {}
        for name, place in places.items():
            told = hashlib.sha256(place.encode()).hexdigest()
            size = next(n for n in range(4, 64) if f"$c{told[:n]}" not in lasting)
            lasting[f"$c{told[:size]}"] = name
        return {name: called for called, name in lasting.items()}

    def _size(self) -> int:
        found: tuple[Any, ...] = (self.classes, self._functions, self._methods, self._constants)
        return sum(map(len, (*found, self.reached, self.by_name)))

    def _emit(self, name: str, value: Any, lines: dict[str, str], done: set[int]) -> None:
        """Write a constant behind those that it is made of."""
        if id(value) in done:
            return
        done.add(id(value))
        text = self._written(value, Where(name, 0))
        for inner in _CONSTANT.findall(text):
            known = next((v for n, v in self._constants.values() if n == inner), None)
            self._emit(inner, known, lines, done)
        lines[name] = text

    def _translate_methods(self, kind: Any) -> None:
        name = self.name_of(kind)
        for attribute, found in [*vars(kind).items()]:
            key = name, attribute
            always = attribute in ("__init__", "__post_init__", "__str__", "__iter__")
            if key in self._methods or not (always or attribute in self.reached):
                continue
            if attribute == "__init__" and _generated(kind):
                continue
            how, of = "", found
            if isinstance(found, (classmethod, staticmethod)):
                how, of = "static ", found.__func__
            elif isinstance(found, property | cached_property):
                how, of = "get ", found.fget if isinstance(found, property) else found.func
            foreign = getattr(of, "__module__", "").partition(".")[0] != self.package
            left = foreign or {attribute, (kind, attribute)} & self.without or _abstract(of)
            if left or not isinstance(of, FunctionType):
                continue
            called = "$init" if attribute == "__init__" else attribute
            if isinstance(found, cached_property):
                how, called = "", f"$find_{attribute}"
            self._methods[key] = ""
            static = isinstance(found, staticmethod)
            before = [{**known} for known in (self._functions, self.classes, self._constants)]
            try:
                self._methods[key] = Function(self, of, called).method(how, static=static)
            except Refused as refused:  # of its name alone: what asks for arrays is not called
                self._functions, self.classes, self._constants = before
                self.left_out[f"{name}.{attribute}"] = str(refused)

    def _class_text(self, name: str, kind: Any) -> str:
        bases = [b for b in kind.__bases__ if b in self.classes.values()]
        other = next((_BASES[b] for b in kind.__bases__ if b in _BASES), "$Object")
        above = self.name_of(bases[0]) if bases else "$Tuple" if is_named_tuple(kind) else other
        lines, end = [f"class {name} extends {above} {{"], "}"
        if _generated(kind):
            named = _fields(kind)
            usual = (f"{f}: () => {self._default(d)}" for f, d in named.items() if d is not _ABSENT)
            names = literal([*named], Where(name, 0))
            end = f"}}\n$sig({name}, {names}, false, {{{', '.join(usual)}}});"
        own = {of: text for (at, of), text in self._methods.items() if at == name}
        lazy = [of for of in own if _lazy(kind, of)]
        lines += [f'get {of}() {{ return $kept(this, "{of}", this.$find_{of}()); }}' for of in lazy]
        return "\n".join([*lines, *own.values(), end])

    def _default(self, default: Any) -> str:
        where = Where("defaults", 0)
        if isinstance(default, _Factory):
            made = default.make
            if made in (dict, list):
                return "new Map()" if made is dict else "[]"
            if isinstance(made, type):
                return f"new {self.kind(made, where)}()"
            return self.value(self._made.setdefault(id(made), (made, made()))[1], where)
        return self.value(default, where)

    def _statics(self) -> Iterable[str]:
        """Yield what classes know of their fields, and what their objects have from them."""
        for name, kind in self.classes.items():
            yield from self._of_fields(name, kind)
            for attribute, found in vars(kind).items():
                yield from self._of_class(name, kind, attribute, found)
        for name, (function, _) in self._functions.items():
            if name in self.by_name:
                yield _signature(name, function, 0)

    @staticmethod
    def _of_fields(name: str, kind: Any) -> Iterable[str]:
        if _generated(kind):
            names, compared = [*_fields(kind)], [*_fields(kind)]
            if not is_named_tuple(kind):
                compared = [f.name for f in dataclasses.fields(kind) if f.compare]
            if is_named_tuple(kind) or kind.__dataclass_params__.eq:
                told = f"{name}.$names" if compared == names else literal(compared, Where(name, 0))
                yield f"{name}.$compared = {told};"
        elif "__init__" in vars(kind):
            yield _signature(name, vars(kind)["__init__"], 1)

    def _of_class(self, name: str, kind: Any, attribute: str, found: Any) -> Iterable[str]:
        if (name, attribute) in self._methods and attribute in self.by_name:
            at = name if isinstance(found, classmethod) else f"{name}.prototype"
            yield _signature(f"{at}.{attribute}", getattr(found, "__func__", found), 1)
        hidden = attribute[0] == "_" or (_generated(kind) and attribute in _fields(kind))
        plain = isinstance(found, str | int | float | tuple | Mapping)
        plain = plain or type(found).__module__.startswith(self.package)
        if attribute in self.reached and plain and not hidden:
            value = self.value(found, Where(name, 0))
            yield f"{name}.{attribute} = {name}.prototype.{attribute} = {value};"


@dataclasses.dataclass(frozen=True)
class _Factory:
    make: Any


def _generated(kind: Any) -> bool:
    made = "__dataclass_fields__" in vars(kind) and "__init__" in vars(kind)
    return is_named_tuple(kind) or made


def _lazy(kind: Any, name: str) -> bool:
    return isinstance(inspect.getattr_static(kind, name, None), cached_property)


def _fields(kind: Any) -> dict[str, Any]:
    """Return the fields of a class, those by name alone too, with their defaults."""
    if is_named_tuple(kind):
        return {f: kind._field_defaults.get(f, _ABSENT) for f in kind._fields}
    found: dict[str, Any] = {}
    for f in dataclasses.fields(kind):
        found[f.name] = _ABSENT
        if f.default is not dataclasses.MISSING:
            found[f.name] = f.default
        if f.default_factory is not dataclasses.MISSING:
            found[f.name] = _Factory(f.default_factory)
    return found


def _signature(name: str, of: Any, skipped: int) -> str:
    given = [*inspect.signature(of).parameters.values()][skipped:]
    names = [p.name for p in given if p.kind not in (p.VAR_POSITIONAL, p.VAR_KEYWORD)]
    more, kinds = any(p.kind is p.VAR_KEYWORD for p in given), {p.kind for p in given}
    if {inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.KEYWORD_ONLY} <= kinds:
        return f"$sig({name}, null);"
    return f"$sig({name}, {literal(names, Where(name, 0))}, {str(more).lower()});"


def _pattern(pattern: re.Pattern[str]) -> str:
    """Return a regular expression; those whose signs JavaScript reads otherwise are refused."""
    source, flags = pattern.pattern, ""
    if pattern.flags & re.VERBOSE:
        source = re.sub(r"\s+", "", source)
    if pattern.flags & re.IGNORECASE:
        flags += "i"
    source = source.replace("(?P<", "(?<").replace(r"\Z", "$")
    if re.search(r"[*+?}]\+|\(\?\(", source):
        Where(source, 0).refuse("a regular expression that JavaScript does not have")
    return f"$re({literal(source, Where(source, 0))}, {literal(flags, Where(source, 0))})"


class Function:
    """One function or method."""

    def __init__(self, module: Module, of: FunctionType, name: str) -> None:
        self.module, self.of_python, self.name = module, of, name
        text = textwrap.dedent(inspect.getsource(of))
        self.tree: Any = ast.parse(text).body[0]
        self.known = {**vars(builtins), **of.__globals__}
        self.known |= inspect.getclosurevars(of).nonlocals
        self.names: list[set[str]] = []
        self.itself = ""

    def where(self, node: ast.AST) -> Where:
        """Return where something stands."""
        code = self.of_python.__code__
        return Where(code.co_filename, code.co_firstlineno + getattr(node, "lineno", 1) - 1)

    def refuse(self, node: ast.AST, why: str) -> str:
        """Raise an error that names the place and the words there."""
        self.where(node).refuse(f"{why}: {ast.unparse(node)[:80]}")

    # the whole

    def text(self) -> str:
        """Return a function of the module."""
        return self._function(self.tree, self.name, self.of_python)

    def method(self, how: str = "", *, static: bool = False) -> str:
        """Return a method of a class."""
        tree = self.tree
        if not static:
            self.itself = tree.args.args[0].arg
            tree.args.args = tree.args.args[1:]
        text = self._function(tree, self.name, self.of_python)
        text = text.removeprefix("function")
        star, text = ("*", text[1:]) if text.startswith("*") else ("", text)
        itself = f"const {local(self.itself)} = this; " if self.itself else ""
        head, _, body = text.strip().partition(") {\n")
        return f"{how}{star}{head}) {{\n{itself}{body}"

    def _function(self, node: Any, name: str, of: Any = None) -> str:
        args, defaults = self._arguments(node.args, of)
        own = {a.arg for a in (*node.args.args, *node.args.kwonlyargs)}
        own |= {a.arg for a in (node.args.vararg, node.args.kwarg) if a}
        own |= {self.itself} if self.itself else set()
        assigned = _assigned(node)
        self.names.append(own | assigned | {n.name for n in node.body if _is_function(n)})
        body = "\n".join(map(self.statement, node.body))
        self.names.pop()
        there = sorted(assigned - own)
        declared = f"let {', '.join(map(local, there))};\n" if there else ""
        star = "*" if _yields(node) else ""
        return f"function{star} {name}({', '.join(args)}) {{\n{declared}{defaults}{body}\n}}"

    def _arguments(self, args: ast.arguments, of: Any) -> tuple[list[str], str]:
        found, by_name = [], []
        given = dict(inspect.signature(of).parameters) if of else {}
        all_ = [*args.args, *args.kwonlyargs]
        own = [None] * (len(args.args) - len(args.defaults)) + [*args.defaults, *args.kw_defaults]
        for a, default in zip(all_, own, strict=True):
            text = local(a.arg)
            if default is not None:
                value = given[a.arg].default if of else _ABSENT
                told = (
                    self.of(default)
                    if value is _ABSENT
                    else self.module.value(value, self.where(default))
                )
                text += f" = {told}"
            if args.vararg and a in args.kwonlyargs:
                by_name.append(f"{a.arg}: {text}")
            else:
                found.append(text)
        if args.kwarg:
            found.append(f"{local(args.kwarg.arg)} = new Map()")
        if args.vararg:
            found.append(f"...{local(args.vararg.arg)}")
        if by_name and args.vararg:
            return found, f"const {{{', '.join(by_name)}}} = $named({local(args.vararg.arg)});\n"
        return found, ""

    # statements

    def statement(self, node: ast.stmt) -> str:
        """Return a statement."""
        write = getattr(self, f"_{type(node).__name__.lower()}_", None)
        return write(node) if write else self.refuse(node, "the statement is not translated")

    def _block(self, body: list[ast.stmt]) -> str:
        return "{\n" + "\n".join(map(self.statement, body)) + "\n}"

    def _expr_(self, node: ast.Expr) -> str:
        if isinstance(node.value, ast.Constant):
            return ""
        if isinstance(node.value, ast.Yield):
            return f"yield {self.of(node.value.value)};"
        if isinstance(node.value, ast.YieldFrom):
            return f"yield* $iter({self.of(node.value.value)});"
        return f"{self.of(node.value)};"

    def _return_(self, node: ast.Return) -> str:
        return f"return {self.of(node.value) if node.value else 'null'};"

    def _pass_(self, _: ast.Pass) -> str:
        return ""

    def _assert_(self, _: ast.Assert) -> str:
        return ""

    def _break_(self, _: ast.Break) -> str:
        return "break;"

    def _continue_(self, _: ast.Continue) -> str:
        return "continue;"

    def _importfrom_(self, node: ast.ImportFrom) -> str:
        module = importlib.import_module(node.module or "")
        for name in node.names:
            self.known[name.asname or name.name] = getattr(module, name.name)
        return ""

    def _functiondef_(self, node: ast.FunctionDef) -> str:
        names = [a.arg for a in (*node.args.args, *node.args.kwonlyargs)]
        more = str(bool(node.args.kwarg)).lower()
        sign = f"$sig({local(node.name)}, {literal(names, self.where(node))}, {more});"
        return f"{self._function(node, local(node.name))}\n{sign}"

    def _assign_(self, node: ast.Assign) -> str:
        value = self.of(node.value)
        lines = []
        for target in node.targets:
            lines.append(self._put(target, value))
            value = self.of(target) if len(node.targets) > 1 else value
        return " ".join(lines)

    def _put(self, target: ast.expr, value: str) -> str:
        if isinstance(target, ast.Subscript):
            return f"$put({self.of(target.value)}, {self.of(target.slice)}, {value});"
        if isinstance(target, ast.Tuple) and any(isinstance(e, ast.Subscript) for e in target.elts):
            names = [f"$v{i}" for i in range(len(target.elts))]
            puts = map(self._put, target.elts, names)
            return f"{{ const [{', '.join(names)}] = {value}; {' '.join(puts)} }}"
        return f"({self._target(target)} = {value});"

    def _target(self, target: ast.expr) -> str:
        if isinstance(target, ast.Tuple | ast.List):
            return f"[{', '.join(map(self._target, target.elts))}]"
        if isinstance(target, ast.Starred):
            return f"...{self._target(target.value)}"
        if isinstance(target, ast.Attribute):
            return f"{self.of(target.value)}.{target.attr}"
        return local(target.id) if isinstance(target, ast.Name) else self.refuse(target, "target")

    def _annassign_(self, node: ast.AnnAssign) -> str:
        return self._put(node.target, self.of(node.value)) if node.value else ""

    def _augassign_(self, node: ast.AugAssign) -> str:
        value = self._binop(ast.BinOp(node.target, node.op, node.value))
        return self._put(node.target, value)

    def _if_(self, node: ast.If) -> str:
        other = f" else {self._block(node.orelse)}" if node.orelse else ""
        return f"if ({self.condition(node.test)}) {self._block(node.body)}{other}"

    def _while_(self, node: ast.While) -> str:
        return f"while ({self.condition(node.test)}) {self._block(node.body)}"

    def _for_(self, node: ast.For) -> str:
        if node.orelse:
            return self.refuse(node, "a loop with an else")
        each = f"for ({self._target(node.target)} of $iter({self.of(node.iter)})) "
        return each + self._block(node.body)

    def _raise_(self, node: ast.Raise) -> str:
        return f"throw {self.of(node.exc) if node.exc else '$error'};"

    def _try_(self, node: ast.Try) -> str:
        lines = ""
        for handler in node.handlers:
            kinds = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]
            tests = " || ".join(f"$error instanceof {self.of(k)}" for k in kinds if k)
            name = f"{local(handler.name)} = $error;\n" if handler.name else ""
            body = name + "\n".join(map(self.statement, handler.body))
            lines += f"if ({tests}) {{\n{body}\n}} else "
        if node.finalbody or node.orelse:
            return self.refuse(node, "only try and except are translated")
        return f"try {self._block(node.body)} catch ($error) {{\n{lines}throw $error;\n}}"

    # expressions

    def of(self, node: Any) -> str:
        """Return an expression."""
        kind = type(node).__name__
        write: Callable[[Any], str] | None = getattr(self, f"_{kind.lower()}", None)
        return write(node) if write else self.refuse(node, f"{kind} is not translated")

    def value(self, node: ast.expr) -> Any:
        """Return what a name of the module stands for, or a mark for a variable."""
        if isinstance(node, ast.Name) and not any(node.id in names for names in self.names):
            return self.known.get(node.id, _ABSENT)
        if isinstance(node, ast.Attribute):
            base = self.value(node.value)
            if base is not _ABSENT and not isinstance(base, dict | str | re.Pattern):
                found = getattr(base, node.attr, _ABSENT)
                bound = isinstance(found, MethodType) and not isinstance(base, type)
                return _ABSENT if bound or isinstance(found, property) else found
        return _ABSENT

    def condition(self, node: ast.expr) -> str:
        """Return whether something is true."""
        if isinstance(node, ast.BoolOp):
            sign = " && " if isinstance(node.op, ast.And) else " || "
            return f"({sign.join(map(self.condition, node.values))})"
        if isinstance(node, ast.Compare) or (
            isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not)
        ):
            return self.of(node)
        return f"$truth({self.of(node)})"

    def _constant(self, node: ast.Constant) -> str:
        return literal(node.value, self.where(node))

    def _name(self, node: ast.Name) -> str:
        if any(node.id in names for names in self.names):
            return local(node.id)
        value = self.value(node)
        return self.refuse(node, "unknown") if value is _ABSENT else self._known(node, value)

    def _known(self, node: ast.AST, value: Any) -> str:
        if isinstance(value, ModuleType):
            return self.refuse(node, "a module")
        return self.module.value(value, self.where(node))

    def _attribute(self, node: ast.Attribute) -> str:
        base, value = self.value(node.value), self.value(node)
        if isinstance(base, type) and isinstance(value, FunctionType | MethodType):
            self.module.reached.add(node.attr)
            return f"{self.module.kind(base, self.where(node))}.{node.attr}"
        if value is not _ABSENT:
            return self._known(node, value)
        self.module.reached.add(node.attr)
        told = self.module.told_of_members(node.attr)
        if told:
            return f"$told({told}, {self.of(node.value)}, {literal(node.attr, self.where(node))})"
        return f"{self.of(node.value)}.{node.attr}"

    def _elements(self, nodes: list[ast.expr]) -> str:
        return f"[{', '.join(map(self.of, nodes))}]"

    def _tuple(self, node: ast.Tuple) -> str:
        return self._elements(node.elts)

    def _list(self, node: ast.List) -> str:
        return self._elements(node.elts)

    def _set(self, node: ast.Set) -> str:
        return f"new Set({self._elements(node.elts)})"

    def _starred(self, node: ast.Starred) -> str:
        return f"...$iter({self.of(node.value)})"

    def _dict(self, node: ast.Dict) -> str:
        pairs = [
            f"[{self.of(k)}, {self.of(v)}]" if k else f"...{self.of(v)}"
            for k, v in zip(node.keys, node.values, strict=True)
        ]
        return f"$map([{', '.join(pairs)}])"

    def _joinedstr(self, node: ast.JoinedStr) -> str:
        return "(" + " + ".join(['""', *map(self.of, node.values)]) + ")"

    def _formattedvalue(self, node: ast.FormattedValue) -> str:
        text = self.of(node.value)
        if node.conversion == ord("r"):
            return f"$repr({text})"
        return (
            f"$format({text}, {self.of(node.format_spec)})"
            if node.format_spec
            else (f"$str({text})")
        )

    def _binop(self, node: ast.BinOp) -> str:
        left, right = self.of(node.left), self.of(node.right)
        if type(node.op) in _PLAIN:
            return f"({left} {_PLAIN[type(node.op)]} {right})"
        if isinstance(node.op, ast.FloorDiv):
            return f"Math.floor({left} / {right})"
        name = _OPERATORS.get(type(node.op))
        return f"{name}({left}, {right})" if name else self.refuse(node, "operator")

    def _unaryop(self, node: ast.UnaryOp) -> str:
        if isinstance(node.op, ast.Not):
            return f"!{self.condition(node.operand)}"
        if isinstance(node.op, ast.USub):
            return f"$neg({self.of(node.operand)})"
        return self.refuse(node, "operator")

    def _boolop(self, node: ast.BoolOp) -> str:
        name = "$and" if isinstance(node.op, ast.And) else "$or"
        *first, last = map(self.of, node.values)
        for one in reversed(first):
            last = f"{name}({one}, () => {last})"
        return last

    def _ifexp(self, node: ast.IfExp) -> str:
        return f"({self.condition(node.test)} ? {self.of(node.body)} : {self.of(node.orelse)})"

    def _namedexpr(self, node: ast.NamedExpr) -> str:
        return f"({local(node.target.id)} = {self.of(node.value)})"

    def _compare(self, node: ast.Compare) -> str:
        sides = [node.left, *node.comparators]
        pairs = zip(sides, node.ops, sides[1:], strict=False)
        return f"({' && '.join(self._pair(node, *pair) for pair in pairs)})"

    def _pair(self, node: ast.Compare, left: ast.expr, sign: ast.cmpop, right: ast.expr) -> str:
        one, other = self.of(left), self.of(right)
        if isinstance(sign, ast.In | ast.NotIn):
            return f"{'!' if isinstance(sign, ast.NotIn) else ''}$in({one}, {other})"
        if isinstance(sign, ast.Eq | ast.NotEq):
            return f"{'!' if isinstance(sign, ast.NotEq) else ''}$eq({one}, {other})"
        if isinstance(sign, ast.Is | ast.IsNot):
            equal = "==" if isinstance(right, ast.Constant) and right.value is None else "==="
            return f"{one} {'!' + equal[1:] if isinstance(sign, ast.IsNot) else equal} {other}"
        return f"{one} {_COMPARED[type(sign)]} {other}"

    def _subscript(self, node: ast.Subscript) -> str:
        base, at = self.of(node.value), node.slice
        if isinstance(at, ast.Slice):
            ends = [self.of(end) if end else "null" for end in (at.lower, at.upper)]
            return f"$slice({base}, {', '.join(ends)})"
        return f"$at({base}, {self.of(at)})"

    def _lambda(self, node: ast.Lambda) -> str:
        given = [*node.args.args]
        own = [None] * (len(given) - len(node.args.defaults)) + [*node.args.defaults]
        # `lambda c=c:` holds the c of its turn, which each turn has anyway
        kept = [a.arg for a, d in zip(given, own, strict=True) if d is None]
        rest = f", ...{node.args.vararg.arg}" if node.args.vararg else ""
        self.names.append({*kept})
        text = f"(({', '.join(map(local, kept))}{rest}) => {self.of(node.body)})"
        self.names.pop()
        return text

    # comprehensions

    def _generated(self, node: Any, element: Callable[[], str]) -> str:
        """Return a generator of the elements."""
        loops, ends = "", ""
        self.names.append(set())
        for part in node.generators:
            over = self.of(part.iter)
            self.names[-1] |= {n.id for n in ast.walk(part.target) if isinstance(n, ast.Name)}
            loops += f"for (const {self._target(part.target)} of $iter({over})) {{ "
            tests = " && ".join(map(self.condition, part.ifs))
            loops += f"if (!({tests})) continue; " if tests else ""
            ends += "}"
        text = f"(function* () {{ {loops}yield {element()}; {ends} }})()"
        self.names.pop()
        return text

    def _generatorexp(self, node: ast.GeneratorExp) -> str:
        return self._generated(node, lambda: self.of(node.elt))

    def _listcomp(self, node: ast.ListComp) -> str:
        return f"[...{self._generated(node, lambda: self.of(node.elt))}]"

    def _setcomp(self, node: ast.SetComp) -> str:
        return f"new Set({self._generated(node, lambda: self.of(node.elt))})"

    def _dictcomp(self, node: ast.DictComp) -> str:
        pair = lambda: f"[{self.of(node.key)}, {self.of(node.value)}]"  # noqa: E731
        return f"$map([...{self._generated(node, pair)}])"

    # calls

    def _call(self, node: ast.Call) -> str:
        if isinstance(node.func, ast.Subscript) and isinstance(self.value(node.func.value), type):
            node.func = node.func.value  # list[Problem]()
        called = self.value(node.func)
        special = self._special(node, called)
        if special:
            return special
        args = [self._argument(a) for a in node.args]
        if isinstance(node.func, ast.Attribute) and called is _ABSENT:
            return self._of_object(node, node.func, args)
        function = self.of(node.func)
        kind = isinstance(called, type) and not isinstance(called, enum.EnumMeta)
        kind = kind and called not in _BUILT_IN and called not in self.module.instead
        if kind and hasattr(called, "__total__"):  # a dict whose keys are known
            return f"$map({self._by_name(node)})"
        in_order = self._in_order(node, args, called) if node.keywords else args
        if in_order is not None:
            new = kind or (function == local(self.itself) and self.itself == "cls")
            return f"{'new ' if new else ''}{function}({', '.join(in_order)})"
        if (called is not _ABSENT and called in _BUILT_IN) or function.startswith("$math"):
            given = ", ".join(f"{k.arg}: {self.of(k.value)}" for k in node.keywords)
            mark = "" if function.startswith("$math") else "$k"
            return f"{function}({', '.join([*args, f'{mark}({{{given}}})'])})"
        if isinstance(called, FunctionType):
            self.module.by_name.add(function)
        return f"$call({function}, [{', '.join(args)}], {self._by_name(node)})"

    def _in_order(self, node: ast.Call, args: list[str], called: Any) -> list[str] | None:
        """Return arguments by name in the order of a function or class; None if not known."""
        known = isinstance(called, type | FunctionType) and called not in _BUILT_IN
        by = {keyword.arg: keyword.value for keyword in node.keywords}
        if not known or None in by or any(isinstance(a, ast.Starred) for a in node.args):
            return None
        if isinstance(called, type) and _generated(called):
            names = [*_fields(called)]
        else:
            given = [*inspect.signature(called).parameters.values()]
            if any(p.kind in (p.VAR_POSITIONAL, p.VAR_KEYWORD) for p in given):
                return None
            names = [p.name for p in given]
        last = max(names.index(str(name)) for name in by)
        rest = names[len(args) : last + 1]
        return [*args, *(self.of(by[name]) if name in by else "undefined" for name in rest)]

    def _argument(self, node: ast.expr) -> str:
        """Return an argument: a method keeps its object."""
        if isinstance(node, ast.Attribute) and self.value(node) is _ABSENT:
            self.module.reached.add(node.attr)
            return f'$bound({self.of(node.value)}, "{node.attr}")'
        return self.of(node)

    def _by_name(self, node: ast.Call) -> str:
        parts = [
            f'["{k.arg}", {self.of(k.value)}]' if k.arg else f"...{self.of(k.value)}"
            for k in node.keywords
        ]
        return f"[{', '.join(parts)}]"

    def _special(self, node: ast.Call, called: Any) -> str:
        """Return a call that JavaScript writes in a way of its own; empty for none."""
        if called is super:
            return "super"
        if called is cast:
            return self.of(node.args[1])
        if called is dataclasses.replace:
            return f"$replaced({self.of(node.args[0])}, new Map({self._by_name(node)}))"
        if called is isinstance:
            kinds = self._types(node.args[1])
            return f"$b.isinstance({self.of(node.args[0])}, {', '.join(kinds)})"
        if called is dataclasses.fields:
            return f"$fields({self.of(node.args[0])})"
        return self._by_text(node, ast.unparse(node.func), called)

    def _by_text(self, node: ast.Call, text: str, called: Any) -> str:
        """Return such a call of a function that is known by its name."""
        if text == "re.compile":
            made = eval(ast.unparse(node), self.known)  # noqa: S307 - of our own source
            return self.module.value(made, self.where(node))
        if text == "object.__setattr__":
            itself, name, value = node.args
            return f"({self.of(itself)}.{name.value} = {self.of(value)})"  # type: ignore[attr-defined]
        if text == "dict.fromkeys":
            return f"$b.fromkeys({', '.join(map(self.of, node.args))})"
        if text in ("re.search", "re.sub", "re.fullmatch"):
            pattern, *rest = node.args
            constant = self.module.value(re.compile(ast.literal_eval(pattern)), self.where(node))
            return f"$m.{node.func.attr}({constant}, {', '.join(map(self.of, rest))})"  # type: ignore[attr-defined]
        if called is getattr and isinstance(node.args[1], ast.Constant):
            self.module.reached.add(str(node.args[1].value))
        return ""

    def _types(self, node: ast.expr) -> list[str]:
        if isinstance(node, ast.BinOp):
            return [*self._types(node.left), *self._types(node.right)]
        value = self.value(node)
        if isinstance(value, UnionType):
            return [self.module.kind(kind, self.where(node)) for kind in value.__args__]
        if isinstance(value, type):
            return [self.module.kind(value, self.where(node))]
        return [self.of(node)]

    def _of_object(self, node: ast.Call, func: ast.Attribute, args: list[str]) -> str:
        base, name = self.of(func.value), func.attr
        self.module.reached.add(name)
        if base == "super":
            name = "$init" if name == "__init__" else name
            return f"super.{name}({', '.join(args)})"
        if name == "sort":
            given = ", ".join(f"{k.arg}: {self.of(k.value)}" for k in node.keywords)
            return f"{base}.splice(0, Infinity, ...$b.sorted({base}, $k({{{given}}})))"
        if name == "format":
            return f"$m.format({base}, [{', '.join(args)}], $map({self._by_name(node)}))"
        if name == "_replace":
            return f"$replaced({base}, new Map({self._by_name(node)}))"
        if node.keywords:
            self.module.by_name.add(name)
            return f'$method({base}, "{name}", [{", ".join(args)}], {self._by_name(node)})'
        if name in _METHODS:
            if len(args) > _MOST.get(name, len(args)):
                return self.refuse(node, "has more arguments than JavaScript's takes")
            return f"$m.{name}({', '.join([base, *args])})"
        self.module.called.setdefault(name, self.where(node))
        return f"{base}.{name}({', '.join(args)})"


def _is_function(node: ast.AST) -> bool:
    return isinstance(node, ast.FunctionDef)


def _within(node: Any) -> Iterable[ast.AST]:
    """Yield what stands in a function, not in functions within it."""
    waiting = [*node.body] if isinstance(node.body, list) else [node.body]
    while waiting:
        one = waiting.pop()
        yield one
        if not isinstance(one, ast.FunctionDef | ast.Lambda):
            waiting += ast.iter_child_nodes(one)


def _assigned(node: Any) -> set[str]:
    """Return the variables of a function, those of its comprehensions left out."""
    comprehended = {
        id(name)
        for one in _within(node)
        if isinstance(one, ast.comprehension)
        for name in ast.walk(one.target)
    }
    names = {
        one.id
        for one in _within(node)
        if isinstance(one, ast.Name)
        and isinstance(one.ctx, ast.Store)
        and id(one) not in comprehended
    }
    return names | {h.name for h in _within(node) if isinstance(h, ast.ExceptHandler) and h.name}


def _yields(node: Any) -> bool:
    return any(isinstance(one, ast.Yield | ast.YieldFrom) for one in _within(node))


def _abstract(of: Any) -> bool:
    return getattr(of, "__isabstractmethod__", False)
