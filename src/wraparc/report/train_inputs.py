"""The inputs of a train that a single drive has not: loads, how they are divided, motors."""

import math
from collections.abc import Iterator
from dataclasses import fields

from wraparc.report.inputs import Input
from wraparc.train import Motor, Motors, Pulls, Shares, Speeds, TorqueFollower, Train, TrainCase
from wraparc.units import Dimension

_DIMENSIONS: dict[str, Dimension] = {
    "rated_power": "power",
    "rated_speed": "rotation_speed",
    "synchronous_speed": "rotation_speed",
}
_KINDS = {
    "VariableSpeed": "speed control",
    "Induction": "induction motor",
    "FluidCoupling": "induction motor with fluid coupling",
}


def train_inputs(train: Train) -> tuple[Input, ...]:
    """Return loads, division and motors of a train, all from its file."""
    return tuple(_inputs(train))


def _inputs(train: Train) -> Iterator[Input]:
    for pulley, nominal in zip(train.pulleys, train.nominal, strict=True):
        if nominal != pulley.diameter:
            group = f"Nominal diameter {pulley.name}"
            yield Input(group, "Nominal diameter", nominal, "length", "D_n")
    for case in train.cases:
        yield from _case(train, case)
    divisions = dict.fromkeys(
        case.division for case in train.cases if isinstance(case.division, Motors)
    )
    for division in divisions:
        for pulley, motor in zip(train.pulleys, division.motors, strict=True):
            yield from _motor(f"Motor {pulley.name}", motor)


def _case(train: Train, case: TrainCase) -> Iterator[Input]:
    group = f"Case {case.name}"
    yield Input(group, "Tension at the first entry", case.entry_tension, "force", "T1")
    yield Input(group, "Tension at the last exit", case.exit_tension, "force", "T2")
    for pulley, run in zip(train.pulleys[1:], case.runs, strict=False):
        yield Input(group, f"Rise of tension before {pulley.name}", run, "force", "dT")
    yield Input(group, "Load divided", _division(case))


def _division(case: TrainCase) -> str:
    division = case.division
    if isinstance(division, Shares):
        return "shares " + ", ".join(f"{100.0 * share:.4g} %" for share in division.fractions)
    if isinstance(division, Pulls):
        return "by given pulls"
    if isinstance(division, Speeds):
        first = division.rotation_speeds[0]
        ratios = ", ".join(f"{100.0 * speed / first:.5g} %" for speed in division.rotation_speeds)
        return f"by given drum speeds, {ratios} of the first"
    return "by the motors"


def _motor(group: str, motor: Motor | TorqueFollower) -> Iterator[Input]:
    if isinstance(motor, TorqueFollower):
        words = f"follows the torque of {motor.master}, times {motor.ratio:g}"
        yield Input(group, "Motor", words)
        return
    kind = type(motor).__name__
    yield Input(group, "Motor", _KINDS.get(kind, kind))
    for f in fields(motor):
        value = getattr(motor, f.name)
        title = f.name.replace("_", " ").capitalize()
        if isinstance(value, bool):
            yield Input(group, title, "yes" if value else "no")
        elif isinstance(value, tuple):
            yield Input(group, title, ", ".join(f"{number:g}" for number in value))
        elif math.isinf(value):
            yield Input(group, title, "none")
        else:
            yield Input(group, title, float(value), _DIMENSIONS.get(f.name, "number"))
