"""Comprehensions and what is said of many values at once."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from javascript.names import local

_WHOLE = {"sum": "$sum", "max": "$maxOf", "min": "$minOf"}
_TESTS = {"any": "some", "all": "every"}
_LISTS = ("tuple", "list")
_MANY = ("zip", "enumerate", "range", "pairwise")


class Sequences:
    """The part of expressions that goes over sequences."""

    own: set[str]

    def of(self, node: ast.expr) -> str:
        """Return an expression."""
        raise NotImplementedError

    def refuse(self, node: ast.AST, why: str) -> str:
        """Raise an error that names the place and the words there."""
        raise NotImplementedError

    def condition(self, node: ast.expr) -> str:
        """Return a condition."""
        raise NotImplementedError

    @contextmanager
    def also(self, names: set[str]) -> Iterator[None]:
        """Know other names for a while."""
        before = self.own
        self.own = before | names
        yield
        self.own = before

    def _starred(self, node: ast.Starred) -> str:
        return f"...{self.of(node.value)}"

    def _listcomp(self, node: ast.ListComp) -> str:
        return self._each(node, "map")

    def _generatorexp(self, node: ast.GeneratorExp) -> str:
        return self._each(node, "map")

    def _each(self, node: ast.ListComp | ast.GeneratorExp, what: str) -> str:
        """Return what is made of each of a sequence, or `some` or `every` of them."""
        if len(node.generators) != 1:
            return self.refuse(node, "one loop at a time")
        loop = node.generators[0]
        found = f"[...{self.of(loop.iter)}]"
        with self.also({n.id for n in ast.walk(loop.target) if isinstance(n, ast.Name)}):
            given = f"({self._taken(loop.target)}) =>"
            for test in loop.ifs:
                found += f".filter({given} {self.condition(test)})"
            plain = isinstance(node.elt, ast.Name) and ast.unparse(loop.target) == node.elt.id
            if what == "map" and plain:
                return found
            made = self.of(node.elt) if what == "map" else self.condition(node.elt)
            return f"{found}.{what}({given} {made})"

    def _taken(self, target: ast.expr) -> str:
        if isinstance(target, ast.Name):
            return local(target.id)
        if isinstance(target, ast.Tuple):
            return f"[{', '.join(map(self._taken, target.elts))}]"
        return self.refuse(target, "nothing that gets a value")

    def _key(self, node: ast.expr) -> str:
        return "Math.abs" if isinstance(node, ast.Name) and node.id == "abs" else self.of(node)

    def of_sequences(self, node: ast.Call) -> str:
        """Return a call that goes over a sequence; empty for another."""
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if not name or name in self.own:
            return ""
        if name in _MANY:  # `strict` is for Python to find
            return f"${name}({', '.join(map(self.of, node.args))})"
        if name == "sorted" and len(node.args) == 1:
            key = [self._key(k.value) for k in node.keywords if k.arg == "key"]
            if len(key) < len(node.keywords):
                return self.refuse(node, "only a key is translated")
            return f"$sorted({', '.join([self.of(node.args[0]), *key])})"
        if name == "next" and len(node.args) == 2:
            return f"$first({self.of(node.args[0])}, {self.of(node.args[1])})"
        if len(node.args) != 1 or node.keywords:
            return ""
        only: Any = node.args[0]
        if name in _TESTS and isinstance(only, ast.GeneratorExp):
            return self._each(only, _TESTS[name])
        if name in _TESTS:
            return f"{self.of(only)}.{_TESTS[name]}((x) => x)"
        if name in _WHOLE:
            return f"{_WHOLE[name]}({self.of(only)})"
        return f"[...{self.of(only)}]" if name in _LISTS else ""
