"""Doors of the command line: each asks one command about a drive file."""

from __future__ import annotations

import contextlib
import json
import math
from pathlib import Path
from typing import Any

import tomli_w

from cli.running import Ran, wraparc
from doors.record import Case, Record, told_of
from doors.verdicts import beside, number, of_json, of_report, of_screen
from wraparc.arc.sliding import SLIDES
from wraparc.checks import Level
from wraparc.train import Train

Data = dict[str, Any]
#: Relative accuracy of numbers in three digits, and of those of pieces that travel.
_SHOWN, _IN_TIME = 6e-3, 1e-2


def refused(ran: Ran, case: Case) -> Record | None:
    """Return what a command refuses; its first words name file or option."""
    if ran.code != 2:
        return None
    told = " ".join(ran.err.split())
    known = [s for s in case.refusal if " ".join(s.split()) in told]
    return Record(refusal=tuple(known) or (told,), code=2)


def solve(case: Case, folder: Path) -> Record | None:
    """``wraparc solve --json``: every number; and the screen begins with the verdict."""
    file = folder / "solve.json"
    ran = wraparc("solve", case.path, "--json", file)
    if ran.code == 2:
        return refused(ran, case)
    data = json.loads(file.read_text("utf-8"))
    verdict = of_json(data["verdict"]) | of_screen(ran.out, case.verdict)
    spots, numbers = {}, {}
    for arc in data["arcs"]:
        place = arc["load_case"], arc["pulley"]
        spots[place] = arc["level"], None
        for _, _, name in filter(lambda key: key[:2] == place, case.record.numbers):
            numbers[*place, name] = math.inf if name in arc["unbounded"] else number(arc[name])
    return Record(verdict=verdict, spots=spots, numbers=numbers, code=ran.code)


def is_one_condition(case: Case) -> bool:
    return not case.arcs.drive.conditions


def what_if(case: Case, folder: Path) -> Record | None:
    """``wraparc what-if`` of no change: before and after are the drive."""
    if case.refusal or not is_one_condition(case):
        return None
    width = case.document["belt"]["width"]
    ran = wraparc("what-if", case.path, "--change", f"belt.width={width}", "--json", "-")
    data = ran.json
    before, after = data["results"]
    place = data["load_case"], data["pulley"]
    told = [
        told_of({(*place, k): number(v) for k, v in row.items() if is_number(v)}, case)
        for row in (before, after)
    ]
    numbers = {k: v for row in told for k, v in row.items() if v != told[0].get(k)} or told[0]
    levels = {before["verdict"], after["verdict"]}
    verdict = beside(data["answer"]["verdict"], case.verdict)
    if len(levels) > 1:
        verdict["level"] = f"{before['verdict']}, {after['verdict']}"
    return Record(verdict=verdict, numbers=numbers)


def is_number(value: Any) -> bool:
    return value is None or isinstance(value, float | int)


def choose(case: Case, folder: Path) -> Record | None:
    """``wraparc choose`` of one candidate: the drive itself."""
    if case.refusal or not is_one_condition(case) or not case.divided:
        return None  # a search is refused that begins with drives that do not carry
    pulley = case.document["pulley"][0]["name"]
    drive = case.arcs.drive
    price = {"material": 1000.0, "installation": 500.0, "area": "3 m2", "life_years": [2.0, 4.0]}
    prices = {drive.pulley(pulley).lagging.name: price}
    cost = {"currency": "AUD", "lagging": prices}
    file = folder / "choose.toml"
    document = {"format": 1, "drive": str(case.path), "pulley": pulley, "candidates": {}}
    conditions = [{"name": drive.pulley(pulley).lagging.condition}]
    document |= {"cost": cost} | (
        {"condition": conditions} if conditions[0]["name"] != "dry" else {}
    )
    file.write_text(tomli_w.dumps(document), "utf-8")
    ran = wraparc("choose", file, "--json", "-")
    if ran.code == 2:
        return Record(refusal=(ran.err,), code=2)
    data, place = ran.json, next(p for p in case.record.numbers if p[-1] == "exit_creep")
    (design,) = data["designs"]
    numbers = {}
    if len(case.arcs) == 1:
        names = {"creep": "exit_creep", "peak_shear_stress": "peak_shear_stress"}
        numbers = {(*place[:2], name): number(design[key]) for key, name in names.items()}
        numbers[*place[:2], "exit_creep"] *= -1.0 if case.record.numbers[place] < 0.0 else 1.0
    return Record(
        verdict=beside(data["answer"]["verdict"], case.verdict), numbers=numbers, code=ran.code
    )


def trim(case: Case, folder: Path) -> Record | None:
    """``wraparc trim`` at the speeds that the drives have."""
    if case.refusal or not isinstance(case.drive, Train):
        return None
    ran = wraparc("trim", case.path, "--points", "3", "--json", "-")
    if ran.code == 2:
        return Record(refusal=(ran.err,), code=2)
    data = ran.json
    first = data["verdict"]
    worse = first["name"] == "trim" and Level(first["level"]).rank > case.verdict.level.rank
    verdict = beside(first, case.verdict, level=not worse)  # how the load is shared may be worse
    if "load_case" not in data:
        return Record(verdict=verdict, code=ran.code)
    of = data["load_case"]
    numbers = {
        (of["load_case"], drive["pulley"], name): number(drive[name])
        for drive in of["drives"]
        for name in ("entry_tension", "exit_tension", "exit_creep")
    }
    return Record(verdict=verdict, numbers=numbers, code=ran.code)


def run(case: Case, folder: Path) -> Record | None:
    """``wraparc run`` of an event in which nothing happens: the drives run steadily."""
    if case.refusal or "motion" not in case.document:
        return None
    ran = wraparc("run", case.path, "--quiet", "--json", "-")
    if ran.code == 2:
        return None  # drives that do not run steadily have no event
    data, numbers = ran.json, {}
    steady = case.arcs.drive.load_case()
    for drum in data["drums"]:
        arc = case.arcs.arc(drum["name"], steady.name)
        if abs(arc.exit_creep) > SLIDES:  # next to no pull moves it
            continue
        for key, name in (("creep", "exit_creep"), ("shear", "peak_shear_stress")):
            size = drum["extremes"][key]["value"]
            numbers[steady.name, drum["name"], name] = math.copysign(size, arc.scalar(name))
    verdict = beside(data["answer"]["verdict"], case.verdict)
    return Record(verdict=verdict, numbers=numbers, near=_IN_TIME)


def report(case: Case, folder: Path) -> Record | None:
    """``wraparc report`` as Markdown: the verdict, and every check as a row."""
    ran = wraparc("report", case.path, "-o", "-")
    if ran.code == 2:
        return refused(ran, case)
    verdict = of_report(ran.out, case.verdict)
    return Record(verdict=verdict, numbers=told_in_table(ran.out, case), near=_SHOWN)


def told_in_table(text: str, case: Case) -> dict[tuple[str, str, str], float]:
    """Return creeps at the exit as the table of load cases shows them."""
    heads: list[str] = []
    found = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line[:1] == "|" else []
        if "creep \\[mm\\]" in cells:
            heads = cells
        elif heads and len(cells) == len(heads):
            for load, pulley, name in case.record.numbers:
                if name == "exit_creep" and cells[0] in (load, f"{load}: {pulley}"):
                    shown = cells[heads.index("creep \\[mm\\]")]
                    with contextlib.suppress(ValueError):
                        found[load, pulley, name] = 1e-3 * float(shown)
        elif heads and not cells:
            break
    return found
