"""Places in a document, and the problems found there, collected so that all are told at once."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Final, TypeVar

from wraparc.errors import InputError, Problem, shown

#: A place in a document: keys, names of tables in arrays, and positions counted from 1.
Place = tuple[str | int, ...]

_BARE = re.compile(r"[A-Za-z0-9_-]{1,60}")
_STEP = re.compile(r"\.?([A-Za-z_][A-Za-z0-9_-]*)|\[(\d+)\]")
_MOST = 50


_T = TypeVar("_T")


class _Nothing:
    def __repr__(self) -> str:
        return "NOTHING"


#: What a value is when it could not be read; the reason is in the report.
NOTHING: Final = _Nothing()


def place_text(place: Place) -> str:
    """Return a place as people write it: ``pulley.head.exit_tension``, ``law[2].knots[3]``."""
    text = ""
    for step in place:
        if isinstance(step, int):
            text += f"[{step}]"
            continue
        key = step if _BARE.fullmatch(step) else shown(step)
        text += f".{key}" if text else key
    return text


def value_at(raw: object, place: Place) -> object:
    """Return what a document holds at a place, or NOTHING."""
    for step in place:
        if isinstance(step, int) and isinstance(raw, Sequence) and 0 < step <= len(raw):
            raw = raw[step - 1]
        elif isinstance(raw, Mapping) and step in raw:
            raw = raw[step]
        else:
            return NOTHING
    return raw


def _renamed(key: str, names: Mapping[str, str]) -> Place:
    """Return the place of a key in the names of the code, in the names of the file."""
    place: list[str | int] = []
    path: list[str] = []
    for name, position in _STEP.findall(key):
        if name:
            path.append(name)
            place.append(names.get(".".join(path), name))
        else:
            place.append(int(position))
    return tuple(place)


class Report:
    """The problems of one input, in the order they were found."""

    def __init__(self, file: str = "") -> None:
        self.file = file
        self.problems: list[Problem] = []
        self._left_out = 0

    @property
    def full(self) -> bool:
        """Whether further problems will only be counted."""
        return len(self.problems) >= _MOST

    def add(
        self,
        place: Place,
        message: str,
        remedy: str = "",
        value: object = NOTHING,
        *,
        code: str = "",
        meant: str = "",
    ) -> None:
        """Add one problem; that something is missing is a code, too."""
        if self.full:
            self._left_out += 1
            return
        given = "" if value is NOTHING else shown(value)
        code = "missing" if message == "missing" else code
        key = place_text(place)
        problem = Problem(message=message, remedy=remedy, key=key, value=given)
        self._append(replace(problem, code=code, meant=meant))

    def take(
        self,
        error: InputError,
        place: Place,
        raw: object = NOTHING,
        names: Mapping[str, str] | None = None,
    ) -> None:
        """Add the problems of an error from further down, put where the user wrote.

        Parameters
        ----------
        error
            Its keys are places below `place`, in the names of the code.
        place
            Where in this input they belong.
        raw
            The document at `place`: values are shown as they were given there.
        names
            Keys of the file by names of the code where they differ, ``pieces.a`` -> ``A``.
        """
        for problem in error.problems:
            if problem.file:
                self._append(problem)
                continue
            below = _renamed(problem.key, names or {})
            given = value_at(raw, below)
            value = problem.value if given is NOTHING else shown(given)
            if isinstance(given, list | dict):
                value = problem.value
            key = place_text(place + below)
            self._append(replace(problem, key=key, value=value, file=self.file))

    def tried(
        self,
        make: Callable[[], _T],
        place: Place,
        raw: object = NOTHING,
        names: Mapping[str, str] | None = None,
    ) -> _T | None:
        """Return what a function makes, or None after taking the problems it raises."""
        try:
            return make()
        except InputError as error:
            self.take(error, place, raw, names)
            return None

    def sure(self, make: Callable[[], _T | None], place: Place = ()) -> _T:
        """Return what a function makes; raise everything that is wrong by now, if anything is."""
        made = self.tried(make, place)
        self.raise_all()
        assert made is not None  # noqa: S101 - else it was reported
        return made

    def _append(self, problem: Problem) -> None:
        problem = problem if problem.file else replace(problem, file=self.file)
        if problem in self.problems:  # what several load cases have from one place
            return
        if len(self.problems) < _MOST:
            self.problems.append(problem)
        else:
            self._left_out += 1

    def raise_all(self) -> None:
        """Raise everything as one `InputError`, if there is anything."""
        if self._left_out:
            message = f"{self._left_out} more problems are not listed"
            self.problems.append(Problem(message=message, file=self.file))
        if self.problems:
            raise InputError(self.problems)
