"""Texts that users read, as the sources have them, each with its place."""

import ast
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

import click

import wraparc
from wraparc.cli.group import COMMANDS
from wraparc.glossary import GLOSSARY
from wraparc.web.answers.form import form

SOURCE = Path(wraparc.__file__).parent
ROOT = Path(__file__).parents[2]
PAGE = (SOURCE / "web" / "static", SOURCE / "web" / "one_file")
#: Files of the page that are made from others, and what others wrote.
MADE = {"built", "vendor", "kernel.js", "reader.js", "cells.js", "train_kernel.js"}
#: Parts of answers that are files, what a user has written in one, and ends of refusals.
WRITTEN = {"toml", "html", "svg", "document", "drive", "description", "title", "sources", "allowed"}
#: Functions that mention one of these write refusals, which have a grammar of their own.
REFUSES = re.compile(r"problem|error|refus|fault|advice|report|^check$|_say$", re.IGNORECASE)
#: Modules with parts of refusals alone: "must be", and what follows it.
PARTS = {"friction/simple.py", "machine_tables/columns.py", "schema/limits.py"}
#: Calls whose texts are names of the code.
NAMES = re.compile(r"re\.\w+|TypeVar|NamedTuple")
#: Code blocks of which only comments are prose, and Python's and JavaScript's strings.
FENCE = re.compile(r"\s*(`{3,}|~{3,})(.*)")
STRING = re.compile(r"`(?:[^`\\]|\\.)*`|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'", re.DOTALL)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


class Text(NamedTuple):
    """A text and its place."""

    place: str
    text: str


def answer_texts(answer: Any, place: str) -> Iterator[Text]:
    """Yield the texts of an answer, without the keys of its JSON and files written by users."""
    if isinstance(answer, str):
        if is_shown(answer):
            yield Text(place, answer)
    elif isinstance(answer, list | tuple):
        for value in answer:
            yield from answer_texts(value, place)
    elif isinstance(answer, dict):
        for key, value in answer.items():
            if key not in WRITTEN:
                yield from answer_texts(value, f"{place}.{key}")


def documents() -> Iterator[Text]:
    """Yield the paragraphs of the documentation; of code blocks comments and what is printed."""
    for file in sorted([*ROOT.glob("docs/**/*.md"), ROOT / "README.md"]):
        fence, began, lines = "", 1, list[str]()
        name = file.relative_to(ROOT)
        for number, line in enumerate([*file.read_text("utf-8").splitlines(), ""], 1):
            mark = FENCE.match(line)
            is_code = mark and not mark[2].startswith(("{only", "{toctree")) and line != "````"
            if mark and (is_code or fence):
                fence = "" if fence == mark[1] else fence or mark[1]
            elif fence:
                yield Text(f"{name}:{number}", of_code(line))
                continue
            if mark or not line.strip() or line.lstrip().startswith(("|", "#", "-", "*")):
                yield Text(f"{name}:{began}", prose(" ".join(lines)))
                began, lines = number, []
            lines += [] if mark else [line.strip()]
        yield Text(f"{name}:{began}", prose(" ".join(lines)))


def data_files() -> Iterator[Text]:
    """Yield comments and texts of the shipped examples and of the catalogue."""
    for file in sorted([*ROOT.glob("examples/**/*.toml"), *SOURCE.rglob("*.toml")]):
        for number, line in enumerate(file.read_text("utf-8").splitlines(), 1):
            yield Text(f"{file.relative_to(ROOT)}:{number}", of_code(line))


def of_code(line: str) -> str:
    """Return what a line of code prints, or says in a comment."""
    strings = [text for text in re.findall(r'"([^"]*)"', line) if is_shown(text)]
    printed = re.sub(r"\{[^{}]*\}|--table \w+", "{}", " | ".join(strings))
    return f"{printed} {line.partition('# ')[2]}"


def prose(text: str) -> str:
    """Return Markdown without its code, the addresses of its links and its roles."""
    return re.sub(r"`+[^`]*`+|\]\([^)]*\)|\{\w+\}|<[^>]*>", "``", text)


def help_texts() -> Iterator[Text]:
    """Yield the help of every command and of its options."""
    for name, of in COMMANDS.items():
        module, _, function = of.where.partition(":")
        command: click.Command = getattr(import_module(module), function)
        yield Text(f"wraparc {name}", of.help)
        info = command.to_info_dict(click.Context(command))
        yield Text(f"wraparc {name} --help", info["help"] or "")
        for option in info["params"]:
            words = (option.get("help") or "").partition("one table alone:")[0]  # names of tables
            yield Text(f"wraparc {name} {option['name']}", words)


def quantities() -> Iterator[Text]:
    """Yield titles and meanings of the glossary."""
    for name, quantity in GLOSSARY.items():
        yield Text(f"glossary: {name}", f"{quantity.title}: {quantity.meaning}")


def form_texts() -> Iterator[Text]:
    """Yield titles, choices and help of the fields of the page."""
    for section in form().sections:
        for field in section.fields:
            place = f"form: {section.key} {field.key}"
            yield Text(place, f"{section.title}: {field.title}: {field.help} {field.word or ''}")


def page_texts() -> Iterator[Text]:
    """Yield the literals of the page's modules that have a space or a capital, and its HTML."""
    for file in sorted(file for folder in PAGE for file in folder.rglob("*.[jh]*[sl]")):
        if MADE.isdisjoint(file.parts):
            text, name = file.read_text("utf-8"), file.relative_to(SOURCE)
            found = [text] if file.suffix == ".html" else _script_strings(text)
            yield from (Text(str(name), literal) for literal in found)


def _script_strings(text: str) -> Iterator[str]:
    for match in re.finditer(f"{COMMENT.pattern}|({STRING.pattern})", text, re.DOTALL):
        literal = re.sub(r"\$\{[^{}]*\}", "{}", (match[1] or "")[1:-1])
        if is_shown(literal) and not re.search(r"[;{]\n|=> ", literal):
            yield literal


def is_shown(literal: str) -> bool:
    """Return whether a literal is a text: words, or one word with a capital; no key or name."""
    return " " in literal.strip() or re.fullmatch(r"[A-Z][a-z]+[.:]?", literal) is not None


def source_texts() -> Iterator[Text]:
    """Yield the literals of the package that are texts, but for those of refusals."""
    for file in sorted(SOURCE.rglob("*.py")):
        name = file.relative_to(SOURCE)
        if name.as_posix() in PARTS:
            continue
        reader = _Literals()
        reader.visit(ast.parse(file.read_text("utf-8")))
        yield from (Text(f"{name}:{line}", text) for line, text in reader.texts if is_shown(text))


class _Literals(ast.NodeVisitor):
    """Literals of a module that users may read: no docstrings, patterns, keys or refusals."""

    def __init__(self) -> None:
        self.texts: list[tuple[int, str]] = []

    def visit_Constant(self, node: ast.Constant) -> None:
        if isinstance(node.value, str):
            self.texts.append((node.lineno, re.sub(r"\{\w*\}", "{}", node.value)))

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        parts = [v.value if isinstance(v, ast.Constant) else "{}" for v in node.values]
        self.texts.append((node.lineno, "".join(map(str, parts))))
        for value in node.values:
            if isinstance(value, ast.FormattedValue):
                self.visit(value.value)

    def visit_Expr(self, node: ast.Expr) -> None:
        if not isinstance(node.value, ast.Constant):  # a docstring
            self.generic_visit(node)

    def visit_Raise(self, node: ast.Raise) -> None:
        """Leave what is raised to the grammar of refusals."""

    def visit_FunctionDef(self, node: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
        if not any(REFUSES.search(name) for name in _names(node)):
            for part in (*node.args.defaults, *node.decorator_list, *node.body):
                self.visit(part)

    visit_AsyncFunctionDef = visit_FunctionDef  # noqa: N815 - named by `ast`

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None and not REFUSES.search(ast.unparse(node.annotation)):
            self.visit(node.value)

    def visit_Assign(self, node: ast.Assign) -> None:
        if ast.unparse(node.targets[0]) != "_MODULES":
            self.visit(node.value)

    def visit_Call(self, node: ast.Call) -> None:
        called = ast.unparse(node.func)
        if not NAMES.fullmatch(called) and not REFUSES.search(called):
            self.generic_visit(node)

    def visit_Subscript(self, node: ast.Subscript) -> None:
        self.visit(node.value)


def _names(node: ast.AST) -> Iterator[str]:
    for part in ast.walk(node):
        if isinstance(part, ast.Name):
            yield part.id
        elif isinstance(part, ast.Attribute):
            yield part.attr
