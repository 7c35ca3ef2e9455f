"""How results show themselves in a notebook.

A result lives on a low floor and knows neither tables nor pictures. It asks here, by the name of
the view; the top of the package says which function answers (`install`), and it is imported only
when somebody looks.
"""

from importlib import import_module
from typing import Any

#: Name of a view -> "module:function"; the function takes the result and the options.
_ANSWERS: dict[str, str] = {}


def install(**answers: str) -> None:
    """Say which function gives a view, ``html="wraparc.answer:html"``."""
    _ANSWERS.update(answers)


def view(name: str, result: object, **options: Any) -> Any:
    """Return a view of a result, made by the function installed for it."""
    module, _, function = _ANSWERS[name].partition(":")
    return getattr(import_module(module), function)(result, **options)


class Viewable:
    """Something that can be shown: as text, as HTML, as a picture, as a data frame."""

    def __str__(self) -> str:
        """Return the short answer, as ``print`` shows it; `repr` holds all numbers."""
        return str(view("text", self))

    def full(self) -> str:
        """Return all that there is to show of it, as text."""
        return str(view("text", self, full=True))

    def _repr_html_(self) -> str:
        return str(view("html", self))

    def plot(self, **options: Any) -> Any:
        """Return a picture of it, see `wraparc.plot`; needs the extra ``plot``."""
        return view("plot", self, **options)

    def to_frame(self) -> Any:
        """Return its numbers as a pandas DataFrame [SI], columns named as in the glossary.

        Needs the extra ``notebook``.
        """
        return view("frame", self)
