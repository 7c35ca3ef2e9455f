"""Expressions of Python to JavaScript."""

from __future__ import annotations

import ast
import dataclasses
import inspect
import math
import re
from collections.abc import Callable
from enum import EnumType
from types import BuiltinFunctionType, FunctionType, ModuleType
from typing import TYPE_CHECKING, Any

from javascript.names import REQUIRED, Where, fields_of, is_class, is_named_tuple, literal, local
from javascript.sequences import Sequences

if TYPE_CHECKING:
    from javascript.translate import Module

#: Functions of `math` that JavaScript has under the same name.
_MATH = frozenset({
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "ceil", "cos", "cosh", "exp",
    "expm1", "floor", "hypot", "log", "log10", "log1p", "log2", "pow", "sin", "sinh", "sqrt",
    "tan", "tanh", "trunc",
})  # fmt: skip
_BUILT_IN = {"abs": "Math.abs({})", "int": "Math.trunc({})", "float": "{}", "len": "{}.length"}
_ARITHMETIC: dict[type[ast.operator], str] = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.BitAnd: "&", ast.BitOr: "|",
}  # fmt: skip
_COMPARED: dict[type[ast.cmpop], str] = {
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "===", ast.NotEq: "!==",
    ast.Is: "===", ast.IsNot: "!==",
}  # fmt: skip
_ABSENT = object()


class Expressions(Sequences):
    """Expressions of one function.

    Attributes
    ----------
    module
        The module in the making.
    own
        Names of the function's parameters and variables.
    known
        Names of the module that the function stands in.
    file, first
        Where it stands.
    """

    def __init__(
        self, module: Module, own: set[str], known: dict[str, Any], file: str, first: int
    ) -> None:
        self.module, self.own, self.known = module, own, known
        self.itself = ""  # the name of the object whose method this is
        self.file, self.first = file, first

    def where(self, node: ast.AST) -> Where:
        """Return where something stands."""
        return Where(self.file, self.first + getattr(node, "lineno", 1) - 1)

    def refuse(self, node: ast.AST, why: str) -> str:
        """Raise an error that names the place and the words there."""
        self.where(node).refuse(f"{why}: {ast.unparse(node)[:80]}")

    def of(self, node: ast.expr) -> str:
        """Return an expression."""
        kind = type(node).__name__
        write: Callable[[Any], str] | None = getattr(self, f"_{kind.lower()}", None)
        return write(node) if write else self.refuse(node, f"{kind} is not translated")

    def value(self, node: ast.expr) -> object:
        """Return what a name of the module stands for, or a mark for a variable."""
        if isinstance(node, ast.Name) and node.id not in self.own:
            return self.known.get(node.id, _ABSENT)
        if isinstance(node, ast.Attribute):
            base = self.value(node.value)
            if isinstance(base, ModuleType | EnumType):
                return getattr(base, node.attr, _ABSENT)
        return _ABSENT

    def _constant(self, node: ast.Constant) -> str:
        return literal(node.value, self.where(node))

    def _joinedstr(self, node: ast.JoinedStr) -> str:
        """Return a text with texts and numbers in it, or one number in so many digits."""
        only = node.values[0]
        spec = only.format_spec if isinstance(only, ast.FormattedValue) else None
        digits = re.fullmatch(r"f'\.(\d+)e'", ast.unparse(spec)) if spec else None
        if digits and isinstance(only, ast.FormattedValue) and len(node.values) == 1:
            return f"({self.of(only.value)}).toExponential({digits[1]})"
        parts = " + ".join(self._told(node, part) for part in node.values)
        return f'("" + {parts})'

    def _told(self, node: ast.JoinedStr, part: ast.expr) -> str:
        if isinstance(part, ast.Constant):
            return self.of(part)
        if isinstance(part, ast.FormattedValue) and part.conversion < 0:
            if part.format_spec is None:
                return f"$text({self.of(part.value)})"
            spec = re.fullmatch(r"f'(\+?)(?:\.(\d+))?([efg])'", ast.unparse(part.format_spec))
            if spec:
                sign = "true" if spec[1] else "false"
                return f'$told({self.of(part.value)}, {sign}, {spec[2] or 6}, "{spec[3]}")'
        return self.refuse(node, "a text in a text is translated so, or a number in so many digits")

    def _name(self, node: ast.Name) -> str:
        if node.id in self.own:
            return "this" if node.id == self.itself else local(node.id)
        return self._known(node, node.id)

    def _attribute(self, node: ast.Attribute) -> str:
        if self.value(node) is not _ABSENT:
            return self._known(node, node.attr)
        self.module.reached(node.attr)
        return f"{self.of(node.value)}.{node.attr}"

    def _known(self, node: ast.expr, name: str) -> str:
        value = self.value(node)
        if value is _ABSENT:
            return self.refuse(node, "an unknown name")
        if is_named_tuple(type(value)):
            self.module.kind(type(value), self.where(node))
        if isinstance(value, FunctionType):
            native = self.module.instead.get(value)
            return self.module.native(native) if native else self.module.function(value)
        return self.module.constant(name, value, self.where(node))

    def _tuple(self, node: ast.Tuple) -> str:
        return f"[{', '.join(map(self.of, node.elts))}]"

    def _list(self, node: ast.List) -> str:
        return f"[{', '.join(map(self.of, node.elts))}]"

    def _binop(self, node: ast.BinOp) -> str:
        left, right = self.of(node.left), self.of(node.right)
        if any(isinstance(side, ast.List | ast.Tuple) for side in (node.left, node.right)):
            if isinstance(node.op, ast.Mult) and isinstance(node.left, ast.List | ast.Tuple):
                return f"$repeated({left}, {right})"
            return self.refuse(node, "lists are not added")
        if isinstance(node.op, ast.FloorDiv):
            return f"Math.floor({left} / {right})"
        if isinstance(node.op, ast.Mod):
            return f"modulo({left}, {right})"
        if isinstance(node.op, ast.Pow):
            return f"(({left}) ** ({right}))"
        if type(node.op) not in _ARITHMETIC:
            return self.refuse(node, "the operator is not translated")
        return f"({left} {_ARITHMETIC[type(node.op)]} {right})"

    def _unaryop(self, node: ast.UnaryOp) -> str:
        if isinstance(node.op, ast.Not):
            return f"!({self.condition(node.operand)})"
        if isinstance(node.op, ast.USub):
            return f"(-{self.of(node.operand)})"
        return self.refuse(node, "the operator is not translated")

    def _boolop(self, node: ast.BoolOp) -> str:
        sign = " && " if isinstance(node.op, ast.And) else " || "
        return f"({sign.join(map(self.condition, node.values))})"

    def condition(self, node: ast.expr) -> str:
        """Return a condition; what is empty or not a number counts otherwise in JavaScript."""
        if isinstance(node, ast.List | ast.Tuple | ast.Dict | ast.Constant):
            return self.refuse(node, "a condition must compare")
        if isinstance(node, ast.BinOp) and not isinstance(node.op, ast.BitAnd):
            return self.refuse(node, "a condition must compare")
        return self.of(node)

    def _ifexp(self, node: ast.IfExp) -> str:
        return f"({self.condition(node.test)} ? {self.of(node.body)} : {self.of(node.orelse)})"

    def _compare(self, node: ast.Compare) -> str:
        amid = [n for side in node.comparators[:-1] for n in ast.walk(side)]
        if any(isinstance(n, ast.Call) and self.value(n.func) is not _ABSENT for n in amid):
            return self.refuse(node, "a call amid a comparison")
        sides = [node.left, *node.comparators]
        found = [self._pair(node, *pair) for pair in zip(sides, node.ops, sides[1:], strict=False)]
        return f"({' && '.join(found)})"

    def _pair(self, node: ast.Compare, left: ast.expr, sign: ast.cmpop, right: ast.expr) -> str:
        one = self.of(left)
        if isinstance(sign, ast.In | ast.NotIn):
            no = "!" if isinstance(sign, ast.NotIn) else ""
            if isinstance(right, ast.Name) and right.id in self.own:
                return f"{no}{self.of(right)}.includes({one})"
            if not isinstance(right, ast.Tuple):
                return self.refuse(node, "`in` takes a tuple that is written out, or a variable")
            found = " || ".join(f"{one} === {self.of(other)}" for other in right.elts)
            return f"{'!' if isinstance(sign, ast.NotIn) else ''}({found})"
        return f"{one} {_COMPARED[type(sign)]} {self.of(right)}"

    def _subscript(self, node: ast.Subscript) -> str:
        base, at = self.of(node.value), node.slice
        if isinstance(at, ast.UnaryOp) and isinstance(node.ctx, ast.Load):
            return f"{base}.at({self.of(at)})"
        if isinstance(at, ast.Slice) and at.step is None and isinstance(node.ctx, ast.Load):
            ends = [
                self.of(at.lower) if at.lower else "0",
                *([self.of(at.upper)] if at.upper else []),
            ]
            return f"{base}.slice({', '.join(ends)})"
        if isinstance(at, ast.Slice | ast.UnaryOp):
            return self.refuse(node, "only places from the start are translated")
        return f"{base}[{self.of(at)}]"

    def _lambda(self, node: ast.Lambda) -> str:
        names = [a.arg for a in node.args.args]
        with self.also(set(names)):
            return f"(({', '.join(map(local, names))}) => {self.of(node.body)})"

    def _call(self, node: ast.Call) -> str:
        called = self.value(node.func)
        if isinstance(node.func, ast.Attribute) and node.func.attr == "_replace":
            return self._replaced(node, node.func.value)
        if called is dataclasses.replace:
            return self._replaced(node, node.args[0])
        of_many = self.of_sequences(node)
        if of_many:
            return of_many
        args = [self.of(arg) for arg in node.args]
        if is_named_tuple(called) or is_class(called):
            return self._made(node, called, args)
        if any(isinstance(a, ast.Starred) for a in node.args):
            return self.refuse(node, "arguments go by their place")
        return self._of_function(node, called, args)

    def _of_function(self, node: ast.Call, called: object, args: list[str]) -> str:
        wanted, called = called, self.module.instead.get(called, called)
        if isinstance(called, str):
            return f"{self.module.native(called)}({', '.join(self._placed(node, wanted, args))})"
        if isinstance(called, FunctionType):
            return self._own(node, called, args)
        if node.keywords:
            return self.refuse(node, "arguments go by their place")
        if isinstance(called, BuiltinFunctionType):
            return self._of_math(node, called, args)
        if isinstance(node.func, ast.Attribute):
            return self._method(node, node.func, args)
        if isinstance(node.func, ast.Name) and node.func.id in self.own:
            return f"{local(node.func.id)}({', '.join(args)})"
        return "super" if ast.unparse(node) == "super()" else self._built_in(node, args)

    def _method(self, node: ast.Call, func: ast.Attribute, args: list[str]) -> str:
        """Return a call of a method: one of the classes that are translated has it."""
        base, name = self.of(func.value), func.attr
        if name == "append":
            return f"{base}.push({', '.join(args)})"
        if name == "insert":
            return f"{base}.splice({args[0]}, 0, {args[1]})"
        if name == "join":
            return f"{args[0]}.join({base})"
        self.module.called(name, self.where(node))
        return f"{base}.{name}({', '.join(args)})"

    def _made(self, node: ast.Call, called: Any, args: list[str]) -> str:
        """Return a named tuple or an object; fields given by name stand in their place."""
        name = self.module.kind(called, self.where(node))
        if not is_named_tuple(called) and not dataclasses.is_dataclass(called):
            return f"new {name}({', '.join(self._placed(node, called.__init__, args, 1))})"
        named = {k.arg: self.of(k.value) for k in node.keywords}
        known = fields_of(called)
        fields = [*known][len(args) :]
        while fields and fields[-1] not in named:
            fields = fields[:-1]  # those have their defaults
        if set(named) - set(fields) or any(
            known[field] is REQUIRED
            for field in known
            if field not in [*known][: len(args)] and field not in named
        ):
            return self.refuse(node, "a field is left out")
        given = [named.get(field, "undefined") for field in fields]
        return f"new {name}({', '.join([*args, *given])})"

    def _placed(self, node: ast.Call, called: Any, args: list[str], skipped: int = 0) -> list[str]:
        """Return arguments in their places; those left out have their defaults."""
        names = [*inspect.signature(called).parameters][skipped + len(args) :]
        named = {k.arg: self.of(k.value) for k in node.keywords}
        if set(named) - set(names):
            return [self.refuse(node, "an argument that is none")]
        while names and names[-1] not in named:
            names = names[:-1]
        return [*args, *(named.get(name, "undefined") for name in names)]

    def _replaced(self, node: ast.Call, of: ast.expr) -> str:
        """Return a copy of a named tuple or an object with other values."""
        base = self.of(of)
        changed = ", ".join(f"{k.arg}: {self.of(k.value)}" for k in node.keywords)
        return f"Object.assign(Object.create(Object.getPrototypeOf({base})), {base}, {{{changed}}})"

    def _of_math(self, node: ast.Call, called: BuiltinFunctionType, args: list[str]) -> str:
        name = called.__name__
        if called is getattr(math, name, None):
            if name in _MATH:
                return f"Math.{name}({', '.join(args)})"
            if name == "copysign":
                return f"copysign({', '.join(args)})"
            if name == "isfinite":
                return f"Number.isFinite({args[0]})"
            if name == "isinf":
                return f"(Math.abs({args[0]}) === Infinity)"
            if name == "isnan":
                return f"Number.isNaN({args[0]})"
        return self.refuse(node, "a function that JavaScript does not have")

    def _own(self, node: ast.Call, called: FunctionType, args: list[str]) -> str:
        if called.__name__ == "zeros":  # the one that compiled code replaces too
            return f"zeros({', '.join(args)})"
        if called.__module__.partition(".")[0] != self.module.package:
            return self.refuse(node, "a function of another package")
        placed = ", ".join(self._placed(node, called, args))
        return f"{self.module.function(called)}({placed})"

    def _built_in(self, node: ast.Call, args: list[str]) -> str:
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name in ("max", "min") and len(args) > 1:
            found = args[0]
            for other in args[1:]:
                found = f"{name}({found}, {other})"
            return found
        if name == "getattr" and len(args) == 2:
            return f"{args[0]}[{args[1]}]"
        if name in _BUILT_IN and len(args) == 1:
            return _BUILT_IN[name].format(args[0])
        return self.refuse(node, "the call is not translated")
