"""The form of the book: laws, belts, rules and words for a page that judges drives itself."""

from typing import Any

from wraparc.checks import Level
from wraparc.web.answers.judging import Ask, Words
from wraparc.web.answers.prepared import Law, Plain
from wraparc.web.answers.shown import Table


class BookCatalogue(Plain):
    """What documents may name: belts, and lagging files by name."""

    belts: list[dict[str, Any]]
    laggings: dict[str, dict[str, Any]]


class BookTested(Plain):
    """Range that a law was tested in [Pa, Pa, m, m/s]."""

    pressure_min: float
    pressure_max: float
    slip_max: float
    slip_speed: float


class BookLaw(Plain):
    """A lagging in one condition."""

    condition: str
    law: Law
    steepest_fall: float
    slip_with_shear: bool
    tested: BookTested | None
    grounds: list[str]
    told: list[str]
    checks: list[Words]


class BookLagging(Plain):
    """A lagging [SI], its laws by condition; `first` is the one it has where none is named.

    `wet` is what wet leaves of its dry friction, see `Criteria`.
    """

    name: str
    first: str
    wet: float
    laws: dict[str, BookLaw]


class DesignRow(Plain):
    """Friction that a standard designs with, and the rule in words."""

    standard: str
    surface: str
    condition: str
    friction: float
    rule: str


class ManualRow(Plain):
    """Factor of the table of manual take-ups from a wrap angle on [deg, -]."""

    angle: float
    factor: float
    rule: str


class Standards(Plain):
    """How design standards ask for a slack side; `silent` says why one asks for none."""

    rows: list[DesignRow]
    manual: dict[str, list[ManualRow]]
    own: str
    silent: dict[str, str]


class Heads(Plain):
    """Tables without their rows."""

    checks: Table
    least: dict[str, Table]


class Book(Plain):
    """All of it."""

    levels: list[Level]
    laggings: dict[str, BookLagging]
    catalogue: BookCatalogue
    words: dict[str, list[Words]]
    asks: dict[str, Ask]
    standards: Standards
    grounds: dict[str, str]
    weak_kinds: list[str]
    more_creep: dict[str, float]
    customary_safety: dict[str, float]
    least_names: dict[str, str]
    held: dict[str, str]
    heads: Heads
    usual: dict[str, float]
    sizes: dict[str, dict[str, tuple[float, float]]]
    load: tuple[float, float]
    steepest: float
    design: str
    own: dict[str, Any]
