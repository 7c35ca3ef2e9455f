"""What the page answers itself is what the server would: every shipped drive, every slider."""

import json
import subprocess
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from wraparc.arc import Distributed, WrapArc
from wraparc.drive import Drive
from wraparc.errors import InputError
from wraparc.units import display_unit
from wraparc.web.answers.documents import asked_for, json_like, read
from wraparc.web.answers.drives import solve_fast
from wraparc.web.answers.form import form
from wraparc.web.answers.prepared import prepared
from wraparc.web.answers.shown import Profile, numbers, outside, status_of
from wraparc.web.asked import FastRequest
from wraparc.web.examples import examples

Data = dict[str, Any]
POINTS = 24
DRIVES = {e.name: json_like(e.document) for e in examples() if e.kind == "drive"}
MORE: dict[str, Data] = {
    "by power": {"entry_tension": "140 kN", "power": "250 kW"},
    "by torque": {"exit_tension": "60 kN", "torque": "30 kN m"},
    "by pull": {"exit_tension": "60 kN", "effective_tension": "-20 kN"},
    "overrun": {"entry_tension": "140 kN", "exit_tension": "60 kN", "overrun": "0.05 mm"},
}
TENSIONS = ("entry_tension", "exit_tension", "effective_tension", "torque", "power")


def drives() -> Iterator[tuple[str, Data, str | None]]:
    """Yield every shipped drive of one pulley, in its first and its last case, and other loads."""
    for name, document in DRIVES.items():
        yield name, document, None
        if document.get("load_case"):
            yield name, document, document["load_case"][-1]["name"]
    plain = {k: v for k, v in DRIVES["head-drive-fabric"].items() if k != "load_case"}
    for name, load in MORE.items():
        pulley = {k: v for k, v in plain["pulley"][0].items() if k not in TENSIONS}
        yield name, {**plain, "pulley": [{**pulley, **load}]}, None


def answered(document: Data, case: str | None) -> Data:
    """Return the answer of the server without its judgement, which may take a while."""
    drive = read(document)
    assert isinstance(drive, Drive)
    pulley, load = asked_for(drive, None, case)
    result = Distributed(points=POINTS, capacities=False).solve(WrapArc.of(drive, pulley, load))
    ready = prepared(document, drive, pulley, load)
    return {
        "status": status_of(result),
        "pulley": pulley.name,
        "load_case": load.name,
        "creep_limit": result.arc.creep_limit,
        "numbers": numbers(result.scalars()),
        "profile": Profile.of(result.profile).model_dump(),
        "tested": None if result.arc.law.tested is None else asdict(result.arc.law.tested),
        "outside": outside(result),
        "prepared": ready and json.loads(ready.model_dump_json()),
    }


def with_value(document: Data, path: list[Any], text: str) -> Data:
    changed = deepcopy(document)
    table: Any = changed
    for step in path[:-1]:
        table = table[step]
    table[path[-1]] = text
    return changed


def moved(document: Data, answer: Data, factor: float) -> Iterator[tuple[str, Data]]:
    """Yield the drive with each number that the page may move by a factor."""
    prepared = answer["prepared"] or {"inputs": [], "given": {}}
    for entry in prepared["inputs"]:
        unit, size = display_unit(entry["dimension"])
        value = float(prepared["given"][entry["name"]]) * factor / size
        if entry["name"] == "thickness" and not isinstance(document["pulley"][0]["lagging"], dict):
            document = deepcopy(document)
            document["pulley"][0]["lagging"] = {"preset": document["pulley"][0]["lagging"]}
        yield entry["name"], with_value(document, entry["path"], f"{value:.6g} {unit}")


def in_node(cases: list[Data]) -> list[Any]:
    told = {"form": json.loads(form().model_dump_json()), "cases": cases}
    program = Path(__file__).with_name("own_answers.mjs")
    done = subprocess.run(
        ["node", str(program)], input=json.dumps(told),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[Any] = json.loads(done.stdout)
    return found


def test_every_moved_number_is_answered_as_by_the_server() -> None:
    # expected: the server's own answer to the changed drive
    names, cases = [], []
    for name, document, case in drives():
        before = answered(document, case)
        for what, changed in moved(document, before, 1.03):
            base = {"doc": document, "answer": before}
            if what == "thickness" and isinstance(document["pulley"][0]["lagging"], str):
                written = with_value(changed, ["pulley", 0, "lagging", "thickness"], "12.5 mm")
                base = {"doc": written, "answer": answered(written, case)}
            try:
                found = answered(changed, case)
            except InputError:
                continue  # e.g. a number that the take-up of another case contradicts
            names.append((name, case, what))
            cases.append({"base": base, "doc": changed, "found": found})
    wrong: dict[Any, Any] = {}
    for of, case_, told in zip(names, cases, in_node(cases), strict=True):
        wrong |= {(*of, what): told for what in _misses(told, case_["found"])}
    assert wrong == {}
    assert len(cases) > 60


def test_the_answer_of_the_server_carries_what_the_page_needs() -> None:
    # expected: a number that was moved there and back gives what was answered first
    document = DRIVES["head-drive-fabric"]
    asked = FastRequest(document=document, points=POINTS, prepared=True)
    before = json.loads(solve_fast(asked).model_dump_json())
    same = deepcopy(document)
    told = in_node([{"base": {"doc": document, "answer": before}, "doc": same, "found": before}])
    assert told[0]["differences"] == []
    assert told[0]["own"]["level"] == ""  # no verdict of its own
    assert told[0]["own"]["levels"] == {}


def test_what_more_has_changed_is_left_to_the_server() -> None:
    document = DRIVES["head-drive-fabric"]
    before = answered(document, None)
    pulley = document["pulley"][0]
    others = [
        {**document, "title": "another"},
        {**document, "pulley": [{**pulley, "lagging": "full-ceramic"}]},
        {**document, "pulley": [{**pulley, "diameter": "0 mm"}]},
        {**document, "pulley": [{**pulley, "diameter": "wide"}]},
        {**document, "pulley": [{**pulley, "exit_tension": "2 GN"}]},
        {**document, "pulley": [pulley, pulley]},
        {k: v for k, v in document.items() if k != "belt"},
    ]
    base = {"doc": document, "answer": before}
    assert in_node([{"base": base, "doc": doc, "found": before} for doc in others]) == [None] * len(
        others
    )


def test_drives_that_depend_on_more_are_not_prepared() -> None:
    document = DRIVES["uphill-conveyor"]  # its tensions come from its resistances
    assert answered(document, None)["prepared"] is None


@pytest.mark.parametrize(("load", "with_"), [("by torque", "diameter"), ("by power", "speed")])
def test_a_pull_that_another_case_takes_over_holds_what_makes_it(load: str, with_: str) -> None:
    # the pull of the pulley is a torque or a power: what the page moves must not leave it behind
    plain = DRIVES["head-drive-fabric"]
    kept = {k: v for k, v in plain["pulley"][0].items() if k not in TENSIONS}
    tension = next(key for key in MORE[load] if key.endswith("_tension"))
    start = {"name": "start", "pulley": {"head": {tension: "145 kN"}}}
    document = {**plain, "pulley": [{**kept, **MORE[load]}], "load_case": [start]}
    of = {entry["name"] for entry in answered(document, "start")["prepared"]["inputs"]}
    assert with_ not in of
    assert {"wrap_angle", "width", "modulus"} < of
    assert not of & {"entry_tension", "exit_tension", "effective_tension"}


def _misses(told: Any, found: Data) -> list[str]:
    if told is None:
        return ["not answered"]
    own = told["own"]
    plain: list[str] = [k for k in found if k not in ("prepared", "numbers", "profile", "outside")]
    wrong: list[str] = [k for k in plain if own[k] != found[k]] + told["differences"]
    for name, column in found["profile"].items():
        size = max(map(abs, column)) or 1.0
        if own["profile"][name] != pytest.approx(column, rel=1e-5, abs=1e-5 * size):
            wrong.append(name)
    if not np.allclose(own["outside"], found["outside"], rtol=1e-9):
        wrong.append("outside")
    return wrong
