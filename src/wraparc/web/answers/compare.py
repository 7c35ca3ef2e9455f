"""The same drive with other laggings or other belts, side by side, with what they cost."""

import math
from collections.abc import Iterable
from typing import Literal

from wraparc import catalogue
from wraparc.answer.key_figures import figure_of, key_figures
from wraparc.answer.sheet import NONE, named, percent
from wraparc.answer.wear_table import life_data
from wraparc.arc import ArcResult, Status
from wraparc.checks import Level, idle, judge, least_tension
from wraparc.choose.cost import Price, catalogue_price, energy_cost, lagging_cost
from wraparc.choose.what_if import redivided
from wraparc.drive import Drive, Lagging, LoadCase
from wraparc.drive.changes import with_belt, with_lagging
from wraparc.drive.conditions import Condition
from wraparc.errors import InputError
from wraparc.files.lagging_file import load_lagging_conditions
from wraparc.glossary import GLOSSARY
from wraparc.schema.problems import place_text
from wraparc.train import Train
from wraparc.train.whole import Whole, by_pulley, solved
from wraparc.web.answers.documents import asked_for, divided, read
from wraparc.web.answers.shown import Answer, Text, finite, texts, worded
from wraparc.web.asked import CompareRequest
from wraparc.web.errors import ToldProblem, told

#: Belts of each carcass that are compared.
NEIGHBOURS = 4
#: Further columns: key, title, and the key figure that they stand behind.
_FURTHER = (
    ("of_limit", "Share of the creep limit", "exit_creep"),
    ("least_slack", "Minimum T2, all checks", "creep_limit_margin"),
    ("outside", "Share outside tested range", ""),
    ("cost_lagging", "Lagging over the years", ""),
    ("cost_energy", "Energy lost over the years", ""),
    ("cost_total", "Cost over the years", ""),
)


class Compared(Answer):
    """A number of a comparison."""

    value: float | None
    text: Text


class Change(Answer):
    """What to put into the document; None takes the key out."""

    path: str
    value: str | None


class Candidate(Answer):
    """The drive with one lagging or belt: judged in every load case, numbers of the one asked for.

    The least slack-side tension is that of every load case too.
    """

    name: str
    title: str
    condition: str
    level: Level
    label: str
    short: str
    status_text: str
    cells: dict[str, Compared]
    cost_note: str
    kind: str
    source: str
    change: list[Change]
    present: bool


class Column(Answer):
    """A column of a comparison, and which is better."""

    key: str
    title: str
    better: str
    meaning: str


class Impossible(Answer):
    """What cannot be had, and why."""

    name: str
    problems: list[ToldProblem]


class CompareAnswer(Answer):
    """The same drive with each of them."""

    pulley: str
    load_case: str
    load_cases: int
    what: Literal["laggings", "belts"]
    currency: str
    years: float
    present: str
    columns: list[Column]
    rows: list[Candidate]
    remarks: list[Text]
    not_possible: list[Impossible]


#: In place of a slack-side tension that does not exist.
NOT_ANY = "none"
Changes = list[Change]
_Candidate = tuple[str, Drive | InputError, Changes]
_OF_BELT = (
    "name", "kind", "modulus", "modulus_test", "modulus_loads", "rating", "least_pulley_diameter",
    "sources", "provenance",
)  # fmt: skip


def compare(asked: CompareRequest) -> CompareAnswer:
    """The same drive with other laggings or belts, solved and priced."""
    thing = read(asked.document)
    drive = divided(thing) if isinstance(thing, Train) else thing
    pulley, case = asked_for(drive, asked.pulley, asked.load_case)
    present = pulley.lagging.name if asked.what == "laggings" else drive.belt.name
    rows, impossible = [], []
    for name, changed, change in _candidates(asked, drive, pulley.name):
        try:
            if isinstance(changed, InputError):
                raise changed
            whole = solved(redivided(thing, changed) if isinstance(thing, Train) else changed)
        except InputError as error:
            impossible.append(Impossible(name=name, problems=told(error.problems)))
            continue
        arc = by_pulley(whole).arc(pulley.name, case.name)
        rows.append(_row(name, whole, arc, change, asked, present=name == present))
    return CompareAnswer(
        pulley=pulley.name,
        load_case=case.name,
        load_cases=len(drive.load_cases),
        what=asked.what,
        currency=asked.currency,
        years=asked.years,
        present=present,
        columns=columns(),
        rows=rows,
        remarks=texts(remarks(asked, case)),
        not_possible=impossible,
    )


def columns() -> list[Column]:
    """Return what is compared."""
    found = []
    for figure in key_figures("compare"):
        found.append((figure.name, GLOSSARY[figure.name].title, figure.better))
        found += _behind(figure.name)
    return [
        Column(key=key, title=title, better=better, meaning=_meaning(key))
        for key, title, better in (*found, *_behind(""))
    ]


def _behind(name: str) -> list[tuple[str, str, str]]:
    return [(key, title, "low") for key, title, figure in _FURTHER if figure == name]


def _candidates(asked: CompareRequest, drive: Drive, pulley: str) -> Iterable[_Candidate]:
    if asked.what == "belts":
        yield from _belts(asked.names, drive)
        return
    own = drive.pulley(pulley).lagging
    names = asked.names
    wanted = catalogue.lagging_names() if names is None else names
    if own.name not in wanted and names is None:
        yield own.name, drive, []
    for name in wanted:
        change = [Change(path=place_text(("pulley", pulley, "lagging")), value=name)]
        if name == own.name:
            yield name, drive, []
            continue
        try:
            conditions = load_lagging_conditions(name, allow_paths=False)
            lagging = _like(conditions, own)
            first = lagging is conditions[0]
            condition = None if first else lagging.condition
            change.append(Change(path=place_text(("pulley", pulley, "condition")), value=condition))
            yield name, with_lagging(drive, pulley, lagging), change
        except InputError as error:
            yield name, error, change


def _like(conditions: tuple[Lagging, ...], own: Lagging) -> Lagging:
    """Return the lagging in the condition of the present one: a wet drive is compared wet."""
    return Condition(name=own.condition).of(conditions)


def _belts(names: list[str] | None, drive: Drive) -> Iterable[_Candidate]:
    own = drive.belt
    if names is None:
        names = _neighbours(drive)
        if own.name not in names:
            yield own.name, drive, []
    for name in names:
        change = [Change(path="belt.preset", value=name)]
        change += [Change(path=f"belt.{key}", value=None) for key in _OF_BELT]
        if name == own.name:
            yield name, drive, []
            continue
        try:
            yield name, with_belt(drive, catalogue.belt(name)), change
        except InputError as error:
            yield name, error, change


def _neighbours(drive: Drive) -> list[str]:
    """Return the belts of each carcass whose rating is nearest, in the order of rating."""
    rating = drive.belt.rating
    if rating is None:
        tight = max(max(t.entry, t.exit) for c in drive.load_cases for t in c.tensions.values())
        rating = tight / drive.belt.width
    found = []
    for kind in dict.fromkeys(b.kind for b in catalogue.belts()):
        rows = [b for b in catalogue.belts() if b.kind == kind]
        rows.sort(key=lambda b: abs(math.log(b.rating / rating)))
        found += sorted(rows[:NEIGHBOURS], key=lambda b: (b.rating, b.name))
    return [b.name for b in found]


def _row(
    name: str,
    whole: Whole,
    result: ArcResult,
    change: Changes,
    asked: CompareRequest,
    *,
    present: bool,
) -> Candidate:
    drive, judged = by_pulley(whole).drive, judge(whole)
    lagging = drive.pulley(result.arc.pulley).lagging
    what = lagging if asked.what == "laggings" else drive.belt
    origin = lagging.source_of("law") if isinstance(what, Lagging) else what.provenance
    cost, note = _cost(drive, lagging, result, asked)
    return Candidate(
        name=name,
        title=lagging.title if isinstance(what, Lagging) else what.kind,
        condition=lagging.condition,
        level=judged.level,
        label=judged.label,
        short=_short(whole, result),
        status_text=str(result.status),
        cells={**_cells(whole, result), **cost},
        cost_note=note,
        kind=origin.kind.value,
        source=str(origin),
        change=change,
        present=present,
    )


def _short(whole: Whole, result: ArcResult) -> str:
    """Return the answer in a few words, with the pulley and load case it is of unless shown."""
    worst, of, own = judge(whole).governing, by_pulley(whole), result.arc
    if worst is None or not worst.missed:
        return "OK" if any(not idle(r.arc) for r in of) else "not driven"
    place = worst.place
    arc = of.arc(place.pulley or own.pulley, place.load_case or own.load_case)
    words = ["gross slip" if arc.status is Status.BREAKAWAY else worst.label]
    if place.pulley not in ("", own.pulley):
        words.append(f"pulley {place.pulley}")
    if place.load_case not in ("", own.load_case):
        words.append(place.load_case)
    return ", ".join(words)


def _cells(whole: Whole, result: ArcResult) -> dict[str, Compared]:
    least = least_tension(whole)
    names = [figure.name for figure in key_figures("compare")]
    values = {name: figure_of(result, name) for name in names}
    cells = {name: _cell(name, abs(v) if name == "exit_creep" else v) for name, v in values.items()}
    cells["least_slack"] = _cell("least_exit_tension", least.tension if least else math.nan)
    shares = {"of_limit": result.share_of_limit, "outside": result.outside_tested_share}
    return cells | {key: _share(value) for key, value in shares.items()}


def _cell(name: str, value: float) -> Compared:
    if math.isinf(value):
        return Compared(value=None, text=NOT_ANY)
    return Compared(value=finite(value), text=worded(named(name, value)))


def _share(value: float) -> Compared:
    return Compared(value=finite(value), text=worded(percent(value)))


def _cost(
    drive: Drive, lagging: Lagging, result: ArcResult, asked: CompareRequest
) -> tuple[dict[str, Compared], str]:
    """Return what the lagging and the energy cost over the years, and what to know about it."""
    price = _price(lagging, asked.currency)
    area = math.pi * result.arc.diameter * drive.belt.width
    years, notes = asked.years, []
    bought = energy = math.nan
    if price is None:
        notes.append(f"no price in {asked.currency} is known")
    else:
        life = _life(lagging, result, asked.hours)
        middle, least, most = lagging_cost(price.cost, area, years, life)
        bought = float(middle)
        low, high = price.cost.life_years
        if math.isnan(life):
            notes.append(
                f"{_between(_money(float(least)), _money(float(most)))} for the vendor's life of "
                f"{_between(f'{low:g}', f'{high:g}')} years, whatever the creep; {price.source}"
            )
        else:
            notes.append(f"life {life:.3g} years by its wear coefficient; {price.source}")
    tariff, loss = asked.tariff, result.energy.power_loss
    if tariff is not None and result.status.solved and math.isfinite(loss):
        energy = float(energy_cost(loss, asked.hours, tariff, years))
    elif tariff is not None:
        notes.append("energy needs the belt speed")
    total = bought if tariff is None else bought + energy
    cells = {"cost_lagging": bought, "cost_energy": energy, "cost_total": total}
    return {key: _cost_cell(value) for key, value in cells.items()}, "; ".join(notes)


def _life(lagging: Lagging, result: ArcResult, hours: float) -> float:
    """Return the life by the energy that wears a lagging [years]; nan where it is not known."""
    data = life_data(result, lagging)
    if data is None or data["life_hours"] is None or hours <= 0.0:
        return math.nan
    return float(data["life_hours"]) / hours


def _price(lagging: Lagging, currency: str) -> Price | None:
    found = catalogue_price(lagging)
    return found if found is not None and found.cost.currency == currency else None


def _between(least: str, most: str) -> str:
    return least if least == most else f"{least} to {most}"


def _money(value: float) -> str:
    return f"{value:,.0f}"


def _cost_cell(value: float) -> Compared:
    text = _money(value) if math.isfinite(value) else NONE
    return Compared(value=finite(value), text=text)


def _meaning(key: str) -> str:
    names = {"of_limit": "creep_limit", "outside": "outside_tested_share"}
    if key == "least_slack":
        return "Minimum T2 with which every check that a higher T2 helps passes."
    entry = GLOSSARY.get(names.get(key, key))
    return entry.meaning if entry else ""


def remarks(asked: CompareRequest, case: LoadCase) -> list[str]:
    """Return what to know about a comparison."""
    found = [SAME, OF_LAGGINGS if asked.what == "laggings" else OF_BELTS]
    if asked.tariff is not None:
        found.append(
            f"Energy is that lost to creep in load case {case.name}, {asked.hours:g} hours a year."
        )
    return found


SAME = "Width, speed, pulley and tensions stay as they are; only what is compared changes."
OF_LAGGINGS = "The thickness is that of each lagging, and the diameter stays over it."
OF_BELTS = "The price of the belts is not known here and not counted."
