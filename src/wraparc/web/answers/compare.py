"""The same drive with other laggings or other belts, side by side, with what they cost."""

import math
from collections.abc import Iterable
from typing import Any

from wraparc import catalogue
from wraparc.arc import ArcResult, Distributed, DriveResult, WrapArc
from wraparc.choose.cost import Price, catalogue_price, energy_cost, lagging_cost
from wraparc.drive import Drive, Lagging, LoadCase
from wraparc.drive.changes import with_belt, with_lagging
from wraparc.errors import InputError
from wraparc.files.lagging_file import load_lagging_conditions
from wraparc.glossary import GLOSSARY
from wraparc.present.sheet import named, percent
from wraparc.present.words import level_of, short
from wraparc.schema.problems import place_text
from wraparc.train import Train, solve_train
from wraparc.units import display
from wraparc.web.answers.documents import read
from wraparc.web.answers.drives import asked_for
from wraparc.web.answers.shown import Data, both, texts_data
from wraparc.web.answers.solving import main_solver
from wraparc.web.errors import problems_data

_NEIGHBOURS = 4
#: Columns: key, title, which is better.
_COLUMNS = (
    ("creep", "Creep at exit", "low"),
    ("of_limit", "Share of the creep limit", "low"),
    ("peak_shear_stress", "Peak shear stress", "low"),
    ("peak_shear_angle", "Peak shear angle", "low"),
    ("margin", "Margin to the creep limit", "high"),
    ("least_slack", "Least slack-side tension", "low"),
    ("power_loss", "Power lost to creep", "low"),
    ("outside", "Share outside tested range", "low"),
    ("cost_lagging", "Lagging over the years", "low"),
    ("cost_energy", "Energy lost over the years", "low"),
    ("cost_total", "Cost over the years", "low"),
)


def compare(request: Data) -> Data:
    """Solve the same pulley and load case with each lagging or belt."""
    drive = _drive(request["document"])
    pulley, case = asked_for(drive, request)
    rows, impossible = [], []
    candidates = list(_candidates(request, drive, pulley.name))
    for name, changed, change in candidates:
        if isinstance(changed, InputError):
            impossible.append({"name": name, "problems": problems_data(changed.problems)})
            continue
        try:
            result = main_solver().solve(WrapArc.of(changed, changed.pulley(pulley.name), case))
        except InputError as error:
            impossible.append({"name": name, "problems": problems_data(error.problems)})
            continue
        rows.append(_row(name, changed, result, change, request))
    present = pulley.lagging.name if request["what"] == "laggings" else drive.belt.name
    for row in rows:
        row["present"] = row["name"] == present
    return {
        "pulley": pulley.name,
        "load_case": case.name,
        "what": request["what"],
        "currency": request["currency"],
        "years": request["years"],
        "present": present,
        "columns": [
            {"key": key, "title": title, "better": better, "meaning": _meaning(key)}
            for key, title, better in _COLUMNS
        ],
        "rows": rows,
        "remarks": texts_data(*(_remarks(request, case),) * 2),
        "not_possible": impossible,
    }


def _drive(document: dict[str, Any]) -> Drive:
    """Return the drive; of a train, with the tensions its division of the load makes."""
    thing = read(document)
    if isinstance(thing, Train):
        method = Distributed(capacities=False)
        return solve_train(thing, method=method, raise_on_failure=False).drive_result().drive
    return thing


Changes = list[Data]
_Candidate = tuple[str, Drive | InputError, Changes]
_OF_BELT = ("name", "kind", "modulus", "rating", "least_pulley_diameter", "sources", "provenance")


def _candidates(request: Data, drive: Drive, pulley: str) -> Iterable[_Candidate]:
    if request["what"] == "belts":
        yield from _belts(request["names"], drive)
        return
    own = drive.pulley(pulley).lagging
    names = request["names"]
    wanted = catalogue.lagging_names() if names is None else names
    if own.name not in wanted and names is None:
        yield own.name, drive, []
    for name in wanted:
        change = [{"path": place_text(("pulley", pulley, "lagging")), "value": name}]
        if name == own.name:
            yield name, drive, []
            continue
        try:
            conditions = load_lagging_conditions(name, allow_paths=False)
            lagging = _like(conditions, own)
            first = lagging is conditions[0]
            condition = None if first else lagging.condition
            change.append({"path": place_text(("pulley", pulley, "condition")), "value": condition})
            yield name, with_lagging(drive, pulley, lagging), change
        except InputError as error:
            yield name, error, change


def _like(conditions: tuple[Lagging, ...], own: Lagging) -> Lagging:
    """Return the lagging in the condition of the present one, else in its first."""
    return next((c for c in conditions if c.condition == own.condition), conditions[0])


def _belts(names: list[str] | None, drive: Drive) -> Iterable[_Candidate]:
    own = drive.belt
    if names is None:
        names = _neighbours(drive)
        if own.name not in names:
            yield own.name, drive, []
    for name in names:
        change: Changes = [{"path": "belt.preset", "value": name}]
        change += [{"path": f"belt.{key}", "value": None} for key in _OF_BELT]
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
        found += sorted(rows[:_NEIGHBOURS], key=lambda b: (b.rating, b.name))
    return [b.name for b in found]


def _row(name: str, drive: Drive, result: ArcResult, change: Changes, request: Data) -> Data:
    lagging = drive.pulley(result.arc.pulley).lagging
    what = lagging if request["what"] == "laggings" else drive.belt
    origin = lagging.source_of("law") if isinstance(what, Lagging) else what.provenance
    cost, note = _cost(drive, lagging, result, request)
    return {
        "name": name,
        "title": lagging.title if isinstance(what, Lagging) else what.kind,
        "condition": lagging.condition,
        "level": level_of(result).value,
        "short": short(result),
        "status_text": str(DriveResult(drive, (result,)).governing.status),
        "cells": {**_cells(result), **cost},
        "cost_note": note,
        "kind": origin.kind.value,
        "source": str(origin),
        "change": change,
    }


def _cells(result: ArcResult) -> Data:
    solved, c = result.status.solved, result.capacities
    nan = math.nan

    def cell(name: str, value: float) -> Data:
        text = both(lambda system: named(name, value, system))
        return {"value": value if math.isfinite(value) else None, **text}

    creep = abs(result.exit_creep) if solved else nan
    share = creep / result.arc.creep_limit
    outside = result.outside_tested_share if solved else nan
    return {
        "creep": cell("exit_creep", creep),
        "of_limit": _share(share),
        "peak_shear_stress": cell("peak_shear_stress", result.peak_shear_stress if solved else nan),
        "peak_shear_angle": cell("peak_shear_angle", result.peak_shear_angle if solved else nan),
        "margin": cell("creep_limit_margin", c.creep_limit_margin),
        "least_slack": cell("least_exit_tension", c.least_exit_tension),
        "power_loss": cell("power_loss", result.energy.power_loss if solved else nan),
        "outside": _share(outside),
    }


def _share(value: float) -> Data:
    text = percent(value)
    return {"value": value if math.isfinite(value) else None, "si": text, "us": text}


def _cost(drive: Drive, lagging: Lagging, result: ArcResult, request: Data) -> tuple[Data, str]:
    """Return what the lagging and the energy cost over the years, and what to know about it."""
    price = _price(lagging, request["currency"])
    area = math.pi * result.arc.diameter * drive.belt.width
    years, notes = request["years"], []
    bought = energy = math.nan
    if price is None:
        notes.append(f"no price in {request['currency']} is known")
    else:
        middle, least, most = lagging_cost(price.cost, area, years)
        bought = float(middle)
        low, high = price.cost.life_years
        notes.append(
            f"{_money(float(least))} to {_money(float(most))} for a life of {high:g} to {low:g} "
            f"years; {price.source}"
        )
    tariff, loss = request["tariff"], result.energy.power_loss
    if tariff is not None and result.status.solved and math.isfinite(loss):
        energy = float(energy_cost(loss, request["hours"], tariff, years))
    elif tariff is not None:
        notes.append("energy needs the belt speed")
    total = bought if tariff is None else bought + energy
    cells = {"cost_lagging": bought, "cost_energy": energy, "cost_total": total}
    return {key: _cost_cell(value) for key, value in cells.items()}, "; ".join(notes)


def _price(lagging: Lagging, currency: str) -> Price | None:
    found = catalogue_price(lagging)
    return found if found is not None and found.cost.currency == currency else None


def _money(value: float) -> str:
    return display(value, "number", digits=3)


def _cost_cell(value: float) -> Data:
    if not math.isfinite(value):
        return {"value": None, "si": "-", "us": "-"}
    return {"value": value, "si": _money(value), "us": _money(value)}


def _meaning(key: str) -> str:
    names = {"creep": "exit_creep", "margin": "creep_limit_margin", "of_limit": "creep_limit"}
    names |= {"least_slack": "least_exit_tension", "outside": "outside_tested_share"}
    entry = GLOSSARY.get(names.get(key, key))
    return entry.meaning if entry else ""


def _remarks(request: Data, case: LoadCase) -> list[str]:
    remarks = [
        "Width, speed, pulley and tensions stay as they are; only what is compared changes.",
    ]
    if request["what"] == "laggings":
        remarks.append("The thickness is that of each lagging, and the diameter stays over it.")
    else:
        remarks.append("The price of the belts is not known here and not counted.")
    if request["tariff"] is not None:
        remarks.append(
            f"Energy is that lost to creep in load case {case.name}, {request['hours']:g} hours a "
            "year."
        )
    return remarks
