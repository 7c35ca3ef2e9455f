"""The exception tree, and bad input described as data.

A door (command line, web page, notebook) shows ``str(error)``; a program reads
the attributes. Nothing here knows files, units or physics.
"""

import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from importlib import import_module
from importlib.util import find_spec
from typing import Any

_SHOWN_LENGTH = 60
_LEAST_LIKENESS = 0.55


class WraparcError(Exception):
    """Root of every error that wraparc raises on purpose."""


def shown(value: object) -> str:
    """Return a value as an error message shows it: source notation, short, printable.

    Text is quoted, numbers are not, control characters are escaped (a hostile file
    must not steer the terminal), and long values are cut.
    """
    try:
        text = json.dumps(value, ensure_ascii=False, default=str)
    except (ValueError, RecursionError):
        text = f"<{type(value).__name__}>"
    if len(text) > _SHOWN_LENGTH:
        text = text[: _SHOWN_LENGTH - 4] + ('..."' if text.startswith('"') else "...")
    return "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in text)


def near(given: object, known: Iterable[str], most: int = 3) -> list[str]:
    """Return the known words nearest to a given one, the nearest first; none if none is near."""
    if not isinstance(given, str):
        return []
    words = list(known)
    within = [word for word in words if len(given) > 2 and given in word]
    alike = [(_likeness(word, given[:100]), word) for word in words]
    by_likeness = sorted([pair for pair in alike if pair[0] >= _LEAST_LIKENESS], reverse=True)
    return list(dict.fromkeys(within + [word for _, word in by_likeness[:most]]))[:most]


def _likeness(word: str, given: str) -> float:
    """Part of the letters of two words that stand in blocks alike, as Ratcliff and Obershelp."""
    size = len(word) + len(given)
    return 2.0 * _alike(word, given) / size if size else 1.0


def _alike(one: str, other: str) -> int:
    """Count the letters of the longest block in both, and of those before it and behind it."""
    size, at, there = 0, 0, 0
    runs = [0] * (len(other) + 1)
    for i, letter in enumerate(one):
        before = 0
        for j, found in enumerate(other):
            run = before + 1 if letter == found else 0
            before = runs[j + 1]
            runs[j + 1] = run
            if run > size:
                size, at, there = run, i + 1 - run, j + 1 - run
    if size == 0:
        return 0
    first = _alike(one[:at], other[:there])
    return first + size + _alike(one[at + size :], other[there + size :])


def nearest(given: object, known: Iterable[str], most: int = 3) -> str:
    """Return "Did you mean ...?" with the nearest of the known words, or nothing."""
    return did_you_mean([shown(word) for word in near(given, known, most)])


def did_you_mean(texts: Sequence[str]) -> str:
    """Return "Did you mean ...?" of what may be meant, as it is to be shown, or nothing."""
    return f"Did you mean {' or '.join(texts)}?" if texts else ""


def format_names(names: Iterable[object], most: int = 6) -> str:
    """Return names with commas; of many the first, and how many more there are."""
    return format_list([shown(name) for name in names], most)


def format_list(texts: Sequence[str], most: int = 6) -> str:
    """Return texts with commas; of many the first, and how many more there are."""
    more = len(texts) - most
    if more <= 1:  # the last one is as long as its count
        return ", ".join(texts)
    return f"{', '.join(texts[:most])} and {more} more"


def name_remedy(given: object, known: Iterable[str]) -> str:
    """Return which name may be meant, else the names there are; nothing if there are none."""
    names = list(known)
    listed = f"Write one of {format_names(names)}." if names else ""
    return nearest(given, names) or listed


@dataclass(frozen=True, kw_only=True)
class Problem:
    """One thing wrong with an input, told as ``file: key: fault, got value. Fix.`` in this order.

    Parameters
    ----------
    message
        The fault: what is wrong or what is allowed, in a few words.
    remedy
        The fix: an imperative sentence.
    file
        Path as the user gave it.
    key
        Place in the input, for example ``pulley.head.exit_tension`` or ``test[3].file``.
    value
        The value as given, in source notation (see `shown`).
    line
        Line in the file, counted from 1.
    code
        What kind it is, for programs: ``missing`` where nothing stands, ``few_tensions`` where more
        is needed to fix the tensions, ``unknown_key`` where there is no such key; else empty.
    meant
        The key that was probably meant by an unknown one; empty where none is near.
    """

    message: str
    remedy: str = ""
    file: str = ""
    key: str = ""
    value: str = ""
    line: int | None = None
    code: str = ""
    meant: str = ""

    def __str__(self) -> str:
        place = self.file
        if self.line is not None:
            place = f"{place}, line {self.line}" if place else f"line {self.line}"
        fault = f"{self.message}, got {self.value}" if self.value else self.message
        sentence = ": ".join(part for part in (place, self.key, fault) if part)
        return " ".join(part for part in (_stopped(sentence), _stopped(self.remedy)) if part)


def _stopped(sentence: str) -> str:
    return sentence if not sentence or sentence[-1] in ".?!" else sentence + "."


class InputError(WraparcError, ValueError):
    """Input that cannot be used, with everything that is wrong with it.

    Parameters
    ----------
    problems
        One problem or all problems of the input, in the order of the input.
    """

    def __init__(self, problems: Problem | Iterable[Problem]) -> None:
        self.problems: tuple[Problem, ...] = (
            (problems,) if isinstance(problems, Problem) else tuple(problems)
        )
        if not self.problems:
            raise TypeError("InputError needs at least one Problem")
        super().__init__(self.problems)

    def __str__(self) -> str:
        if len(self.problems) == 1:
            return str(self.problems[0])
        lines = "\n".join(f"  - {problem}" for problem in self.problems)
        return f"{len(self.problems)} problems:\n{lines}"


def input_error(
    message: str,
    remedy: str = "",
    *,
    file: str = "",
    key: str = "",
    value: str = "",
    line: int | None = None,
) -> InputError:
    """Return the error of one problem, see `Problem`."""
    return InputError(
        Problem(message=message, remedy=remedy, file=file, key=key, value=value, line=line)
    )


def no_such(what: str, name: object, known: Iterable[str], *, of: str = "the drive") -> InputError:
    """Return the error for a name that nothing has, with the nearest names and all there are."""
    return input_error(
        message=f"{of} has no such {what}",
        remedy=name_remedy(name, known),
        value=shown(name),
    )


@contextmanager
def placed(key: str, file: str = "") -> Iterator[None]:
    """Say of the problems raised within where they are, if they do not say it themselves."""
    try:
        yield
    except InputError as error:
        raise InputError(
            replace(p, key=p.key or key, file=p.file or file) for p in error.problems
        ) from None


class MissingExtraError(WraparcError, ImportError):
    """An optional library is needed and not installed.

    Parameters
    ----------
    library
        What is missing, for example ``matplotlib``.
    extra
        The extra of this package that brings it, for example ``plot``.
    """

    def __init__(self, library: str, extra: str) -> None:
        super().__init__(library, extra)
        self.library = library
        self.extra = extra

    def __str__(self) -> str:
        return f"needs {self.library}: pip install 'wraparc[{self.extra}]'"


def require(extra: str, *libraries: str) -> None:
    """Say what to install where libraries that an extra brings are not all there.

    Raises
    ------
    MissingExtraError
        With the first that is not installed.
    """
    for name in libraries:
        if find_spec(name) is None:
            raise MissingExtraError(name, extra)


def pandas() -> Any:
    """Return pandas, of the extra ``notebook``.

    Raises
    ------
    MissingExtraError
        If it is not installed.
    """
    try:
        return import_module("pandas")
    except ImportError:
        raise MissingExtraError("pandas", "notebook") from None


class BreakawayError(WraparcError):
    """The friction along the arc cannot carry the load: gross slip.

    Parameters
    ----------
    message
        The sentence the user reads.
    result
        The result of the failed solve, with the capacities that could be had.
    """

    def __init__(self, message: str, result: Any = None) -> None:
        super().__init__(message, result)
        self.result = result

    def __str__(self) -> str:
        return str(self.args[0])


class SlackBeltError(WraparcError):
    """A strip of the belt would have to push: it goes slack.

    Parameters
    ----------
    message
        The sentence the user reads, with the strip and by how much.
    result
        The result of the failed solve.
    """

    def __init__(self, message: str, result: Any = None) -> None:
        super().__init__(message, result)
        self.result = result

    def __str__(self) -> str:
        return str(self.args[0])


class ConvergenceError(WraparcError):
    """A numerical method did not reach its stated accuracy."""
