"""Trains of the page of one file are those of Python: made from its source, with its numbers."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arc.drives import LAWS
from train.trains import held, random_train
from web.kernel_cases import in_node
from wraparc.arc import Distributed
from wraparc.train import (
    CaseResult,
    FluidCoupling,
    Induction,
    Motor,
    Motors,
    Shares,
    Speeds,
    TorqueFollower,
    Train,
    VariableSpeed,
    solve_train,
)
from wraparc.train.file import load_train
from wraparc.train.solve import Setup, arc_of
from wraparc.web.answers.form import form
from wraparc.web.in_page import Given

EXAMPLES = Path(__file__).parents[2] / "examples"
SOLVER = "train_cases.mjs"
Data = dict[str, Any]


def numbers(train: Train, case: Any) -> Data:
    """A load case as the page gives it to its solver."""
    setup = Setup.of(train, case)
    train, division = setup.train, case.division
    lines = []
    for line, motor in zip(setup.system.lines, setup.motors, strict=True):
        kind = None
        if isinstance(motor, Motor):
            kind = {"kind": type(motor).__name__, **asdict(motor)}
        plain = {k: getattr(line, k) for k in ("speed", "scale", "master", "ratio")}
        lines.append({**plain, "motor": kind, "held": line.motor is None})
    pulls = [a - b for a, b in setup.given_tensions()] if isinstance(division, Shares) else []
    return {
        "laws": [p.lagging.law.compact()._asdict() for p in train.pulleys],
        "given": [given(train, case, p) for p in train.pulleys],
        "tested": [None for _ in train.pulleys],
        "lines": lines,
        "ends": {
            "entry": case.entry_tension,
            "exit": case.exit_tension,
            "runs": list(setup.system.runs),
        },
        "names": [p.name for p in train.pulleys],
        "softening": any(p.lagging.law.steepest_fall() < 0.0 for p in train.pulleys),
        "pulls": pulls,
        "nominal": list(train.nominal),
        "speed": math.nan if train.belt.speed is None else train.belt.speed,
        "reference": setup.reference,
        "form": FORM,
    }


def given(train: Train, case: Any, pulley: Any) -> Data:
    arc = arc_of(train, case, pulley, (case.entry_tension,) * 2)
    found = {**dict.fromkeys(Given._fields, math.nan), **arc.described()._asdict()}
    found["modulus"], found["speed"] = train.belt.modulus, train.belt.speed or math.nan
    found["mass"] = train.belt.mass or math.nan
    found["steepest_fall"] = arc.law.steepest_fall()
    found["cover_compliance"], found["slip_with_shear"] = arc.cover_compliance, arc.slip_with_shear
    return {name: float(found[name]) for name in Given._fields}


def drawn(each: int, seed: int) -> Iterator[tuple[str, Train]]:
    """Random trains of every law: by shares, by the speeds that go with others, by motors."""
    for k, law in enumerate(LAWS):
        rng = np.random.default_rng([seed, k])
        for i in range(each):
            count = 2 + i % 2
            train = random_train(rng, law, count)
            if i % 2:  # a belt of covers and mass, the last drum on its other side
                belt = replace(train.belt, pulley_cover=4e-3, carry_cover=9e-3, carcass=6e-3)
                *others, last = train.pulleys
                pulleys = (*others, replace(last, side="carry"))
                train = replace(train, belt=replace(belt, mass=60.0), pulleys=pulleys)
            yield f"{law}, shares", train
            solved = solve_train(train, method=QUICK, raise_on_failure=False).cases[0]
            if not solved.status.solved:
                continue
            turned = held(train, solved)
            division = turned.cases[0].division
            assert isinstance(division, Speeds)
            size = 3e-5 if train.belt.modulus > 5e7 else 3e-4
            speeds = tuple(v * (1.0 + size * rng.normal()) for v in division.rotation_speeds)
            other = replace(turned.cases[0], division=Speeds(speeds, absolute=bool(i % 3 == 0)))
            yield f"{law}, speeds", replace(turned, cases=(other,))
            motors = tuple(motor(rng, solved, j) for j in range(count))
            driven = replace(turned.cases[0], division=Motors(motors))
            yield f"{law}, motors", replace(turned, cases=(driven,))


def motor(rng: np.random.Generator, solved: CaseResult, index: int) -> Motor | TorqueFollower:
    m = solved.members[index]
    kind = int(rng.integers(4))
    if kind == 3 and index > 0:
        return TorqueFollower(master=solved.members[0].name, ratio=float(rng.uniform(0.5, 1.5)))
    torque = max(abs(m.drum_torque), 1e3)
    speed, gear = 155.0, 155.0 / m.rotation_speed
    common: Data = {
        "rated_power": 1.2 * torque / gear * speed,
        "rated_speed": speed,
        "gear_ratio": gear,
        "gear_efficiency": 0.96,
    }
    if kind == 1:
        return Induction(**common, synchronous_speed=157.0, motor_efficiency=0.95)
    if kind == 2:
        curve: Data = {"coupling_load": (0.0, 1.0, 3.0), "coupling_slip": (0.0, 0.03, 0.2)}
        return FluidCoupling(**common, synchronous_speed=157.0, **curve)
    return VariableSpeed(**common, droop=0.01, torque_limit=float(rng.uniform(0.4, 1.2)))


QUICK = Distributed(capacities=False)
FORM = json.loads(form().model_dump_json())
#: Numbers of a drum that are compared, and how near: slopes are found by differences.
NEAR, SLOPES = 1e-9, 1e-5


@pytest.mark.parametrize("seed", [11])
def test_random_trains_as_in_python(seed: int) -> None:
    # expected: the same functions in Python, interpreted
    trains = list(drawn(2, seed))
    there = in_node([numbers(train, train.cases[0]) for _, train in trains], SOLVER)
    missed: Data = {}
    outcomes, left = set(), []
    for (name, train), found in zip(trains, there, strict=True):
        result = solve_train(train, method=QUICK, raise_on_failure=False).cases[0]
        if found["status"] == "left to the program":
            left.append(name)
            continue
        if (found["status"], found["reason"]) != (result.status, result.reason):
            missed[name] = found["status"], found["reason"], result.status, result.reason
            continue
        outcomes.add(result.status.name)
        misses = apart(result, found)
        if misses:
            missed[name] = misses
    assert missed == {}
    assert {"SOLVED", "BREAKAWAY", "BEYOND_MOTOR"} <= outcomes
    assert len(left) < 0.05 * len(trains), left


def apart(result: CaseResult, found: Data) -> Data:
    """What differs by more than it may."""
    misses: Data = {}

    def near(what: str, here: float, there: float, size: float, tolerance: float) -> None:
        if not (abs(here - there) <= tolerance * size or (here != here and there != there)):
            misses[what] = here, there

    scale = max(m.arc.entry_tension for m in result)
    for i, m in enumerate(result):
        pair, turning = found["pairs"][i], found["turnings"][i]
        near(f"{i} entry", m.arc.entry_tension, pair["entry"], scale, NEAR)
        near(f"{i} exit", m.arc.exit_tension, pair["exit"], scale, NEAR)
        for name, there in turning.items():
            here = m.scalars()[name]
            near(f"{i} {name}", here, there, max(abs(here), 1e-3), NEAR)
        if m.motor is not None:
            for name, there in found["points"][i].items():
                here = getattr(m.motor, name)
                near(f"{i} {name}", here, there, max(abs(here), 1.0), NEAR)
    if result.status.solved:
        slopes = [v for row in result.sensitivity for v in row]
        size = max(map(abs, slopes))
        for k, (here, there) in enumerate(
            zip(slopes, [v for row in found["sensitivity"] for v in row], strict=True)
        ):
            near(f"slope {k}", here, there, size, SLOPES)
        assert len(result.other_splits) == len(found["other_splits"])
    return misses


@pytest.mark.parametrize("name", ["tandem-fabric", "tandem-steel-cord", "triple-steel-cord"])
def test_examples_as_in_python(name: str) -> None:
    train = load_train(EXAMPLES / f"{name}.toml")
    there = in_node([numbers(train, case) for case in train.cases], SOLVER)
    results = solve_train(train, method=QUICK).cases
    assert [apart(r, f) for r, f in zip(results, there, strict=True)] == [{} for _ in results]
    assert [f["status"] for f in there] == [r.status for r in results]
