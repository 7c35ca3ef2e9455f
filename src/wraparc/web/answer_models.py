"""What the API answers, for its OpenAPI document; a test holds real answers against it."""

from typing import Any, Literal

from pydantic import BaseModel, ConfigDict

Numbers = list[float | None]
Level = Literal["OK", "ATTENTION", "FAILS"]


class Answer(BaseModel):
    """Part of an answer."""

    model_config = ConfigDict(extra="forbid")


class Both(Answer):
    """Text in both systems of units."""

    si: str
    us: str


class BothLists(Answer):
    """Texts in both systems of units."""

    si: list[str]
    us: list[str]


class Problem(Answer):
    """One thing wrong, with the sentence of the command line."""

    path: str
    message: str
    value: str
    remedy: str
    line: int | None
    sentence: str


class Problems(Answer):
    """Everything that is wrong."""

    problems: list[Problem]


class Verdict(Answer):
    """The answer in words."""

    level: Level
    headline: Both
    sentences: list[Both]


class Row(Answer):
    """One line of a table."""

    name: str
    title: str
    symbol: str
    values: BothLists
    note: Both
    level: Level | None


class Table(Answer):
    """Rows under one heading."""

    key: str
    title: str
    heads: BothLists
    note: Both
    rows: list[Row]


class Source(Answer):
    """Where a number came from."""

    of: str
    part: str
    kind: Literal["measured", "published", "calibrated", "illustrative", "given"]
    source: str
    date: str
    note: str


class Profile(Answer):
    """Quantities along the arc [SI]; the glossary of the schema names them."""

    position: Numbers
    tension: Numbers
    wrap_pressure: Numbers
    friction: Numbers
    friction_used: Numbers
    slip: Numbers
    creep: Numbers
    shear_stress: Numbers
    shear_angle: Numbers
    sliding: Numbers


class Tested(Answer):
    """Range that the lagging was tested in [Pa, Pa, m]."""

    pressure_min: float
    pressure_max: float
    slip_max: float


class Arc(Answer):
    """One pulley in one load case."""

    pulley: str
    load_case: str
    status: Literal["solved", "breakaway", "unsolved"]
    level: Level
    creep_limit: float
    numbers: dict[str, float | None]
    profile: Profile
    tested: Tested | None
    outside: list[list[float]]
    tables: list[Table]


class FastAnswer(Arc):
    """One arc without capacities."""

    sequence: int
    kind: Literal["drive", "train"]
    verdict: Verdict
    remarks: list[Both]


class Paper(Answer):
    """The same arc by the paper's march."""

    status: str
    numbers: dict[str, float | None]
    profile: Profile


class WholeArc(Arc):
    """One arc with everything there is to say."""

    status_text: str
    short: str
    unbounded: list[str]
    table_sources: list[str]
    paper: Paper


class Place(Answer):
    """Which arc."""

    pulley: str
    load_case: str


class Marks(Answer):
    """What of the numbers must be known."""

    illustrative: bool
    calibrated: bool
    outside_tested: bool


class SolveAnswer(Answer):
    """A solved drive."""

    sequence: int
    kind: Literal["drive", "train"]
    title: str
    description: str
    solved: bool
    within_creep_limit: bool
    governing: Place
    verdict: Verdict
    remarks: list[Both]
    summary: Table | None
    sources: list[Source]
    has: Marks
    arcs: list[WholeArc]
    train: dict[str, Any] | None


class SheetAnswer(Answer):
    """What was read of a drive."""

    kind: Literal["drive", "train"]
    title: str
    subtitle: str
    verdict: Verdict | None
    tables: list[Table]
    remarks: list[Both]
    table_sources: list[str]


class ReadAnswer(Answer):
    """The document of a text, with what is wrong in it."""

    document: dict[str, Any]
    kind: Literal["drive", "train"]
    valid: bool
    problems: list[Problem]


class WriteAnswer(Answer):
    """The text of a document, with what is wrong in it."""

    toml: str
    name: str
    kind: Literal["drive", "train"]
    valid: bool
    problems: list[Problem]


class Quantity(Answer):
    """A quantity as read [SI]; `exact` reads back to the same number."""

    value: float | None
    text: Both | None
    exact: Both | None
    problem: Problem | None


class QuantitiesAnswer(Answer):
    """Quantities as read."""

    items: list[Quantity]


class Cell(Answer):
    """A number of a comparison."""

    value: float | None
    si: str
    us: str


class Change(Answer):
    """What to put into the document; None takes the key out."""

    path: str
    value: str | None


class Candidate(Answer):
    """The drive with one lagging or belt."""

    name: str
    title: str
    condition: str
    level: Level
    short: str
    status_text: str
    cells: dict[str, Cell]
    cost_note: str
    kind: str
    source: str
    change: list[Change]
    present: bool


class Column(Answer):
    """A column of a comparison, and which is better."""

    key: str
    title: str
    better: Literal["low", "high"]
    meaning: str


class Impossible(Answer):
    """What cannot be had, and why."""

    name: str
    problems: list[Problem]


class CompareAnswer(Answer):
    """The same drive with each of them."""

    pulley: str
    load_case: str
    what: Literal["laggings", "belts"]
    currency: str
    years: float
    present: str
    columns: list[Column]
    rows: list[Candidate]
    remarks: list[Both]
    not_possible: list[Impossible]


class DesignRow(Answer):
    """A design in the list."""

    id: int
    name: str
    kind: Literal["drive", "train"]
    versions: int
    created: str
    changed: str
    who: str
    note: str


class Designs(Answer):
    """A part of the list."""

    total: int
    designs: list[DesignRow]


class VersionRow(Answer):
    """A version without its document."""

    version: int
    created: str
    who: str
    note: str
    program: str


class DesignAnswer(Answer):
    """A design and its versions."""

    id: int
    name: str
    kind: Literal["drive", "train"]
    versions: list[VersionRow]
    newest: int
    created: str
    changed: str
    who: str
    note: str


class VersionAnswer(VersionRow):
    """A version with its document."""

    id: int
    name: str
    kind: Literal["drive", "train"]
    document: dict[str, Any]


class Job(Answer):
    """How a study stands."""

    model_config = ConfigDict(extra="allow")

    id: str
    title: str
    state: Literal["queued", "running", "done", "failed", "cancelled"]
    done: int
    total: int
    message: str
    problems: list[Problem]


class Jobs(Answer):
    """All studies."""

    jobs: list[Job]


class About(Answer):
    """What the server is and can do."""

    name: str
    version: str
    fast: bool
    compiled: bool
    database: str
    extras: dict[str, bool]
    token: bool


_WRONG: dict[int | str, dict[str, Any]] = {
    422: {"model": Problems, "description": "Everything that is wrong with the request."},
    503: {"model": Problems, "description": "Busy; try again."},
}


def answers(
    model: type[BaseModel], status: int = 200, *others: int
) -> dict[int | str, dict[str, Any]]:
    """Return what a route says of its answers in the OpenAPI document."""
    more: dict[int | str, dict[str, Any]] = {code: {"model": Problems} for code in others}
    return {status: {"model": model}, **_WRONG, **more}
