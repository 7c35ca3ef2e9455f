"""Doors of the server: the API by a client inside this process."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from doors.record import Case, Record
from doors.verdicts import number, of_api
from web.calculators import API, client

Data = dict[str, Any]


def api(cases: Sequence[Case], folder: Path) -> list[Record | None]:
    """``POST /solve`` of every document."""
    with client() as server:
        return [solved(case, server) for case in cases]


def solved(case: Case, server: Any) -> Record:
    answer = server.post(f"{API}/solve", json={"document": case.document})
    data = answer.json()
    if answer.status_code != 200:
        problems = tuple(p["message"] for p in data.get("problems", ())) or (answer.text,)
        return Record(refusal=case.refusal if case.refusal else problems)
    spots, numbers = {}, dict[tuple[str, str, str], float]()
    for arc in data["arcs"]:
        place = arc["load_case"], arc["pulley"]
        spots[place] = arc["level"], None
        unbounded = set(arc["unbounded"])
        numbers |= {
            (*place, name): float("inf") if name in unbounded else number(value)
            for name, value in arc["numbers"].items()
            if (*place, name) in case.record.numbers
        }
    return Record(verdict=of_api(data["verdict"]), spots=spots, numbers=numbers)


def compare(cases: Sequence[Case], folder: Path) -> list[Record | None]:
    """``POST /compare`` of the drive with itself: one candidate, the present lagging."""
    with client() as server:
        return [with_itself(case, server) for case in cases]


def with_itself(case: Case, server: Any) -> Record | None:
    if case.refusal:
        return None
    pulley = case.document["pulley"][0]["name"]
    own = case.arcs.drive.pulley(pulley).lagging.name
    asked = {"document": case.document, "pulley": pulley, "names": [own]}
    answer = server.post(f"{API}/compare", json=asked)
    data = answer.json()
    if answer.status_code != 200:
        return Record(refusal=(answer.text,))
    (row,) = data["rows"] or [None]
    if row is None:
        return Record(refusal=(str(data["not_possible"]),))
    place = data["load_case"], data["pulley"]
    names = ("exit_creep", "peak_shear_stress")
    numbers = {(*place, name): number(row["cells"][name]["value"]) for name in names}
    known = case.record.numbers
    creep = *place, "exit_creep"
    if known[creep] < 0.0:
        numbers[creep] = -numbers[creep]
    return Record(verdict={"level": row["level"]}, numbers=numbers)
