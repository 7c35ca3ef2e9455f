"""The grammar of refusals, ``file: key: fault, got value. Fix.``, and inputs with a fault each."""

import re
import tomllib
from collections.abc import Callable, Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

from wraparc.calibrate.file import measured_from_document
from wraparc.choose.file import search_from_document
from wraparc.errors import InputError, Problem
from wraparc.files import lagging_from_document
from wraparc.motion.file import motion_from_document
from wraparc.shear_test.plan_file import plan_from_document
from wraparc.study.event_study import event_study_from_document
from wraparc.study.file import study_from_document
from wraparc.train.file import drive_or_train_from_document

MOST_WORDS = 20
EXAMPLES = Path("examples")
LAGGING = next(Path("src/wraparc/catalogue").rglob("full-ceramic.toml"))
#: What may stand in a value's place: other kinds, dimensions, signs, sizes, and ways to write.
BAD: tuple[Any, ...] = (
    True, -1, 0, 1e9, "", "abc", "5", "-5 mm", "1,5 kN", "1 500 m", "3 kn", "nan Pa", "1e400 m",
    "0 deg", "7 J/m m", [], ["a", 1], {}, {"a": 1}, "x" * 300, "\x1b[31m", "150 kN", "9 Mm",
)  # fmt: skip
_UNIT = (
    r"(?:%|[munk]?m[23]?|km|[kM]?N|[kMG]?Pa|deg|degC|m/s|mm/s|kN/m|N/m|kg/m|[kM]?W|kN m|kg m2|rpm"
    r"|h|s|t|t/h|1/m|1/mm|mm/kN|Hz|MB|kPa|J/m2|mm3/\(N m\)|m/Pa)"
)
_QUOTED = re.compile(r'"(?:[^"\\]|\\.)*"')
_NUMBER_AND_UNIT = re.compile(rf"(?<![\w.])([-+]?[\d.,]+(?:e[-+]?\d+)?) {_UNIT}(?![\w/])")


def word_count(problem: Problem) -> int:
    """Return the words of a refusal; a file, a value, a quoted name, a number with unit are one."""
    line = 2 if problem.line is not None else 0  # "line 3"
    got = 2 if problem.value else 0
    texts = [problem.key, problem.message, problem.remedy]
    plain = " ".join(_NUMBER_AND_UNIT.sub("5", _QUOTED.sub("Q", text)) for text in texts)
    return len(plain.split()) + line + got + bool(problem.file)


def faults_of(problem: Problem) -> list[str]:
    """Return what in a refusal is against the grammar."""
    parts = [problem.file, "" if problem.line is None else f"line {problem.line}"]
    place = ", ".join(part for part in parts if part)
    head = "".join(f"{part}: " for part in (place, problem.key) if part)
    got = f", got {problem.value}" if problem.value else ""
    said = str(problem)
    fault, fix = problem.message, problem.remedy
    checks = {
        "order": re.fullmatch(rf"{re.escape(head + fault + got)}\.?(?: [A-Z][^\n]*[.?])?", said),
        "one fault": fault and not re.search(r"[.?!]\s|[.?!:]$", fault),
        "no capital": fault[:1] == fault[:1].lower() or fault.startswith(("A ", "A and")),
        "one fix": not fix or re.fullmatch(r"[A-Z](?:(?!\. [A-Z]|\? ).)*[.?]", fix),
        "one got": said.count(", got ") == bool(got),
        "value once": len(problem.value) < 4 or problem.value not in fault,
        "a line": "\n" not in said and "Traceback" not in said,
        "words": word_count(problem) <= MOST_WORDS,
    }
    return [name for name, right in checks.items() if not right]


def read_whole(document: dict[str, Any], folder: str) -> None:
    """Read a document by what it is."""
    if "law" in document:
        lagging_from_document(document)
    elif "motion" in document:
        motion_from_document(document, folder=folder, allow_paths=True)
    elif "belt" in document and "pulley" in document:
        drive_or_train_from_document(document, folder=folder, allow_paths=True)
    else:
        _reader(document)(document, folder=folder)


def _reader(document: dict[str, Any]) -> Callable[..., object]:
    if "event" in document:
        return event_study_from_document
    if "axis" in document:
        return study_from_document
    if "candidates" in document:
        return search_from_document
    return plan_from_document if "rig" in document else measured_from_document


def sources() -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Yield name, folder and document of every example, and of a lagging."""
    for path in (*sorted(EXAMPLES.rglob("*.toml")), LAGGING):
        yield path.name, str(path.parent), tomllib.loads(path.read_text("utf-8"))


def places(node: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the place of every key of a document, also in its arrays."""
    items: Any = ()
    if isinstance(node, dict):
        items = node.items()
    elif isinstance(node, list):
        items = enumerate(node[:2])
    for key, value in items:
        yield (*place, key)
        yield from places(value, (*place, key))


def spoilt(
    document: dict[str, Any], every: int = 1, first: int = 0
) -> Iterator[tuple[tuple[Any, ...], dict[str, Any]]]:
    """Yield places and copies of a document with a fault there: a bad value, no key, another key.

    Parameters
    ----------
    document
        A sound one.
    every, first
        Which of them: each so many, from a place on.
    """
    number = 0
    for place in places(document):
        for bad in (*BAD, "left out", "misspelt"):
            number += 1
            if (number - first) % every:
                continue
            copy = deepcopy(document)
            *way, last = place
            node = copy
            for step in way:
                node = node[step]
            if bad == "left out":
                del node[last]
            elif bad == "misspelt" and isinstance(node, dict):
                node[f"{last}x"] = node.pop(last)
            else:
                node[last] = deepcopy(bad)
            yield place, copy


def with_value(document: dict[str, Any], place: tuple[Any, ...], value: Any) -> dict[str, Any]:
    """Return a copy of a document with another value at a place."""
    copy = deepcopy(document)
    node: Any = copy
    for step in place[:-1]:
        node = node[step]
    node[place[-1]] = value
    return copy


def refusal_of(document: dict[str, Any], folder: str) -> tuple[Problem, ...]:
    """Return the problems that a document is refused with, none if it is read."""
    try:
        read_whole(document, folder)
    except InputError as error:
        return error.problems
    return ()
