"""One function of Python to JavaScript: its statements."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Callable, Iterable
from types import FunctionType
from typing import TYPE_CHECKING, Any, get_origin, get_type_hints

from javascript.expressions import Expressions
from javascript.names import is_named_tuple, literal, local

if TYPE_CHECKING:
    from javascript.translate import Module

_IN_PLACE: dict[type[ast.operator], str] = {
    ast.Add: "+=", ast.Sub: "-=", ast.Mult: "*=", ast.Div: "/=",
}  # fmt: skip


class Function:
    """One function.

    Parameters
    ----------
    module
        The module in the making.
    function
        The function.
    name
        Its name there.
    """

    def __init__(self, module: Module, function: FunctionType, name: str) -> None:
        lines, first = inspect.getsourcelines(function)
        tree = ast.parse(textwrap.dedent("".join(lines))).body[0]
        assert isinstance(tree, ast.FunctionDef)  # noqa: S101 - a function is what was asked for
        self.name, self.defaults = name, function.__defaults__ or ()
        self._begin(tree)
        own = {*self.arguments, *self.variables}
        file = function.__code__.co_filename
        self.ex = Expressions(module, own, function.__globals__, file, first)
        self.of = self.ex.of

    def _begin(self, tree: ast.FunctionDef) -> None:
        self.tree = tree
        self.arguments = [a.arg for a in tree.args.args]
        self.variables = _stored(tree) - set(self.arguments)
        self.declared: set[str] = set()
        self.spare = 0

    def text(self) -> str:
        """Return the function, with the first line of its description."""
        told = (ast.get_docstring(self.tree) or "").partition("\n")[0]
        star = self._star()
        head = f"export function{star} {self.name}({self._given(self.arguments)}) {{"
        lines = [*([f"/** {told} */"] if told else []), head, *self._within(), "}", ""]
        return "\n".join(lines)

    def method(self, way: str = "") -> str:
        """Return it as the method of a class; `way` is ``get`` for a property."""
        self.ex.itself = self.arguments[0]
        way = way or self._star()
        head = f"{way} {self.name}({self._given(self.arguments[1:])}) {{"
        return "\n".join([head, *self._within(), "}"])

    def _star(self) -> str:
        yields = (isinstance(n, ast.Yield | ast.YieldFrom) for n in ast.walk(self.tree))
        return "*" if any(yields) else ""

    def _given(self, names: list[str]) -> str:
        args = self.tree.args
        if args.kwonlyargs or args.vararg or args.kwarg or args.posonlyargs:
            self.ex.refuse(self.tree, "arguments go by their place")
        where, plain = self.ex.where(self.tree), len(names) - len(self.defaults)
        told = [f" = {literal(value, where)}" for value in self.defaults]
        return ", ".join(
            f"{local(name)}{told[i - plain] if i >= plain else ''}" for i, name in enumerate(names)
        )

    def _within(self) -> list[str]:
        body = self._top(self.tree.body)
        above = sorted(map(local, self.variables - self.declared))
        return [*([f"let {', '.join(above)};"] if above else []), *body]

    def _functiondef(self, node: ast.FunctionDef) -> list[str]:
        """Return a function within the function."""
        kept = self.tree, self.arguments, self.variables, self.declared, self.defaults
        self.defaults = ()
        spare = self.spare
        self._begin(node)
        if node.args.defaults or node.decorator_list:
            self.ex.refuse(node, "a function within a function has plain arguments")
        with self.ex.also({*self.arguments, *self.variables}):
            given = self._given(self.arguments)
            lines = [f"const {local(node.name)} = ({given}) => {{", *self._within(), "};"]
        self.tree, self.arguments, self.variables, self.declared, self.defaults = kept
        self.spare += spare
        return lines

    def _top(self, body: list[ast.stmt]) -> list[str]:
        """Return the outermost statements: a variable is declared where it first gets a value."""
        lines: list[str] = []
        met = set(self.arguments)
        for statement in body:
            if isinstance(statement, ast.FunctionDef):
                self.declared.add(statement.name)
            new = _stored(statement) - met
            plain = isinstance(statement, ast.Assign | ast.AnnAssign)
            if plain and new and new == _stored(statement) and self._names_only(statement):
                self.declared |= new
                text = self._statement(statement)
                lines += [f"let {line}" if not line.startswith("const ") else line for line in text]
            else:
                lines += self._statement(statement)
            met |= new
        return lines

    def _names_only(self, node: ast.stmt) -> bool:
        """Whether an assignment gives values to plain names, each once."""
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", node)]
        if len(targets) != 1:
            return False
        inner = targets[0].elts if isinstance(targets[0], ast.Tuple) else targets
        names = [n.id for n in inner if isinstance(n, ast.Name)]
        return len(names) == len(inner) == len(set(names))

    def _block(self, body: Iterable[ast.stmt]) -> list[str]:
        return [line for statement in body for line in self._statement(statement)]

    def _statement(self, node: ast.stmt) -> list[str]:
        kind = type(node).__name__
        write: Callable[[Any], list[str]] | None = getattr(self, f"_{kind.lower()}", None)
        if write is None:
            self.ex.refuse(node, f"{kind} is not translated")
            return []
        return write(node)

    def _expr(self, node: ast.Expr) -> list[str]:
        if isinstance(node.value, ast.Constant):
            return []  # a description
        if isinstance(node.value, ast.Yield) and node.value.value is not None:
            return [f"yield {self.of(node.value.value)};"]
        if isinstance(node.value, ast.YieldFrom):
            return [f"yield* {self.of(node.value.value)};"]
        return [f"{self.of(node.value)};"]

    def _return(self, node: ast.Return) -> list[str]:
        return [f"return {self.of(node.value)};" if node.value else "return;"]

    def _pass(self, node: ast.Pass) -> list[str]:
        return []

    def _break(self, node: ast.Break) -> list[str]:
        return ["break;"]

    def _continue(self, node: ast.Continue) -> list[str]:
        return ["continue;"]

    def _annassign(self, node: ast.AnnAssign) -> list[str]:
        if node.value is None:
            self.ex.refuse(node, "a variable gets a value where it is named")
            return []
        return [f"{self._target(node.target)} = {self.of(node.value)};"]

    def _augassign(self, node: ast.AugAssign) -> list[str]:
        if type(node.op) not in _IN_PLACE:
            self.ex.refuse(node, "the operator is not translated")
        if isinstance(node.value, ast.List | ast.ListComp):
            return [f"{self._target(node.target)}.push(...{self.of(node.value)});"]
        return [f"{self._target(node.target)} {_IN_PLACE[type(node.op)]} {self.of(node.value)};"]

    def _assign(self, node: ast.Assign) -> list[str]:
        first = node.targets[0]
        if len(node.targets) == 1 and isinstance(first, ast.Tuple):
            return self._unpacked(first, node.value)
        targets = " = ".join(map(self._target, node.targets))
        return [f"{targets} = {self.of(node.value)};"]

    def _unpacked(self, target: ast.Tuple, value: ast.expr) -> list[str]:
        """Return values given one by one, where that means the same: it costs no arrays."""
        plain = all(isinstance(t, ast.Name) for t in target.elts)
        if plain and isinstance(value, ast.Tuple) and not _stored(target) & _read(value):
            pairs = zip(target.elts, value.elts, strict=True)
            return [f"{self._target(t)} = {self.of(v)};" for t, v in pairs]
        parts = self._parts(value, len(target.elts))
        if parts:
            self.spare += 1
            kept = f"found{self.spare}"
            targets = [(self._target(t), part) for t, part in zip(target.elts, parts, strict=True)]
            given = [f"{t} = {kept}{part};" for t, part in targets if t]
            return [f"const {kept} = {self.of(value)};", *given]
        return [f"{self._target(target)} = {self.of(value)};"]

    def _parts(self, value: ast.expr, count: int) -> list[str]:
        """Return how to reach the parts of what a call returns, by what it says it returns."""
        called = self.ex.value(value.func) if isinstance(value, ast.Call) else None
        if not isinstance(called, FunctionType):
            return []
        returned = get_type_hints(called).get("return")
        if is_named_tuple(returned):
            return [f".{field}" for field in getattr(returned, "_fields", ())][:count]
        return [f"[{i}]" for i in range(count)] if get_origin(returned) is tuple else []

    def _target(self, node: ast.expr) -> str:
        if isinstance(node, ast.Name):
            return "" if node.id == "_" else local(node.id)
        if isinstance(node, ast.Tuple):
            return f"[{', '.join(map(self._target, node.elts))}]"
        if isinstance(node, ast.Subscript | ast.Attribute):
            return self.of(node)
        return self.ex.refuse(node, "nothing that gets a value")

    def _if(self, node: ast.If) -> list[str]:
        lines = [f"if ({self.ex.condition(node.test)}) {{", *self._block(node.body)]
        if len(node.orelse) == 1 and isinstance(node.orelse[0], ast.If):
            head, *rest = self._if(node.orelse[0])
            return [*lines, f"}} else {head}", *rest]
        if node.orelse:
            lines += ["} else {", *self._block(node.orelse)]
        return [*lines, "}"]

    def _while(self, node: ast.While) -> list[str]:
        if node.orelse:
            self.ex.refuse(node, "a loop with else is not translated")
        forever = isinstance(node.test, ast.Constant) and node.test.value is True
        test = "true" if forever else self.ex.condition(node.test)
        return [f"while ({test}) {{", *self._block(node.body), "}"]

    def _for(self, node: ast.For) -> list[str]:
        if node.orelse:
            self.ex.refuse(node, "a loop with else is not translated")
        self.spare += 1
        each = f"each{self.spare}"
        head = self._range(node.iter, each)
        if not head:
            head = f"for (const {each} of {self.of(node.iter)}) {{"
        target = self._target(node.target)
        given = f"{target} = {each};"
        return [head, *([given] if target else []), *self._block(node.body), "}"]

    def _range(self, over: ast.expr, each: str) -> str:
        """Return the head of a loop over whole numbers; empty for another."""
        if not (isinstance(over, ast.Call) and isinstance(over.func, ast.Name)):
            return ""
        if over.func.id != "range":
            return ""
        args = [self.of(arg) for arg in over.args]
        start, stop, *step = ["0", *args] if len(args) == 1 else args
        down = bool(step) and isinstance(over.args[2], ast.UnaryOp)
        if step and not down and not isinstance(over.args[2], ast.Constant):
            self.ex.refuse(over, "which way a loop goes must be plain")
        way = f"{each} > end{self.spare}" if down else f"{each} < end{self.spare}"
        by = f"{each} += {step[0]}" if step else f"{each}++"
        return f"for (let {each} = {start}, end{self.spare} = {stop}; {way}; {by}) {{"


def _stored(node: ast.AST) -> set[str]:
    """Return the names that get a value; not the mark of what nobody wants.

    Neither those within a function of its own, nor those of a comprehension.
    """
    found = set[str]()
    for inner in ast.iter_child_nodes(node):
        if isinstance(inner, ast.FunctionDef):
            found.add(inner.name)
        elif isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Store):
            found.add(inner.id)
        elif not isinstance(inner, ast.Lambda | ast.ListComp | ast.GeneratorExp):
            found |= _stored(inner)
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        found.add(node.id)
    return found - {"_"}


def _read(node: ast.AST) -> set[str]:
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
