"""The verdict that follows from a list of checks, and its one sentence."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from wraparc.checks.check import Check, Level

#: In what ways an input may be weak, the worst first.
DATA_CLASSES = ("illustrative", "untested", "estimated", "calibrated")
#: Words that the line on the data has at most.
DATA_WORDS = 15


class DataLine(NamedTuple):
    """On what data an answer is based.

    Attributes
    ----------
    items
        Class, key and word of every weak input, each once, in its worst class.
    text
        One sentence.
    """

    items: tuple[tuple[str, str, str], ...]
    text: str

    def of_class(self, name: str) -> list[str]:
        """Return the keys of one class."""
        return [key for kind, key, _ in self.items if kind == name]


def data_line(weak: tuple[tuple[str, str, str], ...]) -> DataLine:
    """Return the line on the data of an answer.

    Parameters
    ----------
    weak
        Class, key and word of the weak inputs.
    """
    items: list[tuple[str, str, str]] = []
    seen: list[str] = []
    for kind in DATA_CLASSES:
        for item in weak:
            if item[0] == kind and item[2] not in seen:
                seen.append(item[2])
                items.append(item)
    if not items:
        return DataLine((), "All inputs measured or published.")
    words = {kind: [word for k, _, word in items if k == kind] for kind in DATA_CLASSES}
    listed = [f"{', '.join(words[kind])} {kind}" for kind in DATA_CLASSES if words[kind]]
    text = "; ".join(listed)
    text = f"{text[:1].upper()}{text[1:]}."
    if len(text.split()) > DATA_WORDS:
        counts = [(len(words[kind]), kind) for kind in DATA_CLASSES if words[kind]]
        first, *others = counts
        inputs = "input" if first[0] == 1 else "inputs"
        more = "".join(f", {count} {kind}" for count, kind in others)
        text = f"{first[0]} {inputs} {first[1]}{more} (--table inputs)."
    return DataLine(tuple(items), text)


#: Checks whose limit is by the kind of the load case.
BY_KIND = ("gross_slip", "design_standard", "belt_tension", "momentary_tension", "belt_safety")


@dataclass(frozen=True)
class Verdict:
    """What a list of checks comes to: its worst.

    Attributes
    ----------
    checks
        Every check at every place.
    """

    checks: tuple[Check, ...]

    @cached_property
    def governing(self) -> Check | None:
        """The check that decides, see `Check.order`; where all pass the nearest to its limit."""
        judged = [c for c in self.checks if c.level is not Level.NOT_CHECKED]
        return min(judged, key=_order, default=None)

    @property
    def kind_in_doubt(self) -> Check | None:
        """The check of the kind of the load case that fails, None where its kind is clear.

        A start that is judged as running needs no stronger belt: it is its kind that is missing.
        """
        worst = self.governing
        if worst is None or not worst.missed or worst.name not in BY_KIND:
            return None
        here = (c for c in self.missed if c.name == "case_kind" and c.place.load_case != "")
        return next((c for c in here if c.place.load_case == worst.place.load_case), None)

    @property
    def level(self) -> Level:
        """Level of the worst check; OK where there is none."""
        return Level.OK if self.governing is None else self.governing.level

    @property
    def label(self) -> str:
        """Word of the verdict: its level, and whether an OK is of a dry drive only."""
        dry = self.wet is not None and self.wet.level is Level.NOT_CHECKED
        return f"{Level.OK} (dry)" if dry and self.level is Level.OK else str(self.level)

    @property
    def wet(self) -> Check | None:
        """The estimated creep when wet, where it is largest; None where none is estimated."""
        return next((c for c in self.listed if c.name == "wet_creep"), None)

    @property
    def text(self) -> str:
        """The answer in one sentence; its quantities are cells."""
        worst = self.governing
        if worst is None:
            return "Nothing checked."
        return worst.text if worst.missed else self._passing()

    @property
    def closest(self) -> str:
        """The check nearest to its limit with both and its place; empty where none compares."""
        worst = self.governing
        if worst is None or not math.isfinite(worst.used):
            return ""
        return f"{worst.noun or worst.title} {worst.measured}{worst.place.bracket}"

    def _passing(self) -> str:
        count = self.passed
        text = f"All {count} checks pass." if count != 1 else "1 check passes."
        return f"{text} Closest: {self.closest}." if self.closest else text

    @property
    def also(self) -> tuple[Check, ...]:
        """The further checks that are missed, the worst first."""
        return self.missed[1:]

    @property
    def wet_text(self) -> str:
        """What wet would give, where only dry was solved; empty else."""
        wet = self.wet
        if wet is None or wet.missed:
            return ""
        if wet.level is Level.NOT_CHECKED:
            return f"Not checked: {wet.why}." if self.level is Level.OK else ""
        return f"Creep {wet.texts()[0]} (estimated) passes."

    @cached_property
    def listed(self) -> tuple[Check, ...]:
        """Each check once, at the place that governs it, in the order they are made."""
        worst: dict[str, Check] = {}
        for check in self.checks:
            current = worst.get(check.name, check)
            worst[check.name] = min(current, check, key=_order)
        return tuple(worst.values())

    @cached_property
    def missed(self) -> tuple[Check, ...]:
        """The checks of `listed` that are missed, the governing one first, then the worst."""
        missed, worst = (c for c in self.listed if c.missed), self.governing
        return tuple(sorted(missed, key=lambda check: (check is not worst, *_order(check))))

    @property
    def passed(self) -> int:
        """How many of `listed` pass."""
        return sum(c.compares and not c.missed for c in self.listed)

    @property
    def not_checked(self) -> tuple[Check, ...]:
        """The checks that could not be made."""
        return tuple(c for c in self.listed if c.level is Level.NOT_CHECKED)

    @property
    def data(self) -> DataLine:
        """On what data the answer is based."""
        return data_line(tuple(item for c in self.checks for item in c.weak))

    @property
    def remarks(self) -> tuple[str, ...]:
        """What the data are, a sentence for each pulley that differs, and what is left out."""
        texts = (c.full_text for c in self.checks if c.name in ("data", "belt_mass") and c.full)
        return tuple(dict.fromkeys(texts))

    @property
    def full(self) -> tuple[str, ...]:
        """Reasons, allowances and assumptions of what is missed, and which pulleys brake."""
        texts = [f"{c.title}: {c.full_text}" for c in self.missed if c.full]
        return (*dict.fromkeys(texts), *self._senses())

    def _senses(self) -> list[str]:
        """Say which pulleys brake, or that none pulls, and in how many load cases."""
        every = {c.place.load_case for c in self.checks} - {""}
        senses = [c for c in self.checks if c.name == "sense"]
        texts: list[str] = []
        for title in dict.fromkeys(c.title for c in senses):
            here = {c.place.load_case for c in senses if c.title == title}
            texts.append(f"{title} in {len(here)} of {len(every)} load cases.")
        return texts

    def at(self, pulley: str, load_case: str) -> Verdict:
        """Return the verdict on one pulley in one load case."""
        known = self._at.setdefault(load_case, {})
        if pulley not in known:
            places = dict.fromkeys(("", load_case))
            there = sorted(n for place in places for n in self._places.get(place, ()))
            mine = [self.checks[number] for number in there]
            own = tuple(check for check in mine if check.place.pulley in ("", pulley))
            known[pulley] = self if len(own) == len(self.checks) else Verdict(own)
        return known[pulley]

    def within(self, load_case: str) -> Verdict:
        """Return the verdict on all pulleys in one load case."""
        own = tuple(c for c in self.checks if c.place.load_case in ("", load_case))
        return self if len(own) == len(self.checks) else Verdict(own)

    @cached_property
    def _at(self) -> dict[str, dict[str, Verdict]]:
        return {}

    @cached_property
    def _places(self) -> dict[str, list[int]]:
        found: dict[str, list[int]] = {}
        for number, check in enumerate(self.checks):
            found.setdefault(check.place.load_case, []).append(number)
        return found


def _order(check: Check) -> tuple[float, float]:
    return check.order
