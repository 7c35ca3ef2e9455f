"""The inputs of a train that a single drive has not: loads, how they are divided, motors."""

import math
from collections.abc import Iterator
from dataclasses import fields

from wraparc.answer.inputs import Input
from wraparc.train import Motor, Motors, Pulls, Shares, Speeds, TorqueFollower, Train, TrainCase
from wraparc.units import Dimension

_MOTORS = {
    "VariableSpeed": "speed control",
    "Induction": "induction motor",
    "FluidCoupling": "induction motor with fluid coupling",
}
_MOTOR_DIMENSIONS: dict[str, Dimension] = {
    "rated_power": "power",
    "rated_speed": "rotation_speed",
    "synchronous_speed": "rotation_speed",
}


def train_inputs(train: Train) -> Iterator[Input]:
    """Yield what a train has besides its drive: loads, how they divide, motors."""
    for pulley, nominal in zip(train.pulleys, train.nominal, strict=True):
        if nominal != pulley.diameter:
            group = f"Nominal diameter {pulley.name}"
            yield Input(group, "Nominal diameter", nominal, "length", "D_n")
    for case in train.cases:
        yield from _case(train, case)
    divisions = dict.fromkeys(c.division for c in train.cases if isinstance(c.division, Motors))
    for division in divisions:
        for pulley, motor in zip(train.pulleys, division.motors, strict=True):
            yield from _motor(f"Motor {pulley.name}", motor)


def _case(train: Train, case: TrainCase) -> Iterator[Input]:
    group = f"Case {case.name}"
    yield Input(group, "Tension at the first entry", case.entry_tension, "force", "T1")
    yield Input(group, "Tension at the last exit", case.exit_tension, "force", "T2")
    pull = case.effective_tension
    yield Input(group, "Te of all drives", pull, "force", "Te", None, "T1 - T2, less the runs")
    for pulley, run in zip(train.pulleys[1:], case.runs, strict=False):
        yield Input(group, f"Rise of tension before {pulley.name}", run, "force", "dT")
    yield Input(group, "Load divided", _division(case))


def _division(case: TrainCase) -> str:
    match case.division:
        case Shares(fractions):
            return "shares " + ", ".join(f"{100.0 * share:.4g} %" for share in fractions)
        case Pulls():
            return "by input Te"
        case Speeds(speeds):
            ratios = ", ".join(f"{100.0 * speed / speeds[0]:.5g} %" for speed in speeds)
            return f"by input pulley speeds, {ratios} of the first"
        case _:
            return "by the motors"


def _motor(group: str, motor: Motor | TorqueFollower) -> Iterator[Input]:
    if isinstance(motor, TorqueFollower):
        words = f"follows the torque of {motor.master}, times {motor.ratio:g}"
        yield Input(group, "Motor", words)
        return
    kind = type(motor).__name__
    yield Input(group, "Motor", _MOTORS.get(kind, kind))
    for f in fields(motor):
        value = getattr(motor, f.name)
        title = f.name.replace("_", " ").capitalize()
        if value is None:
            continue
        if isinstance(value, bool):
            yield Input(group, title, "yes" if value else "no")
        elif isinstance(value, tuple):
            yield Input(group, title, ", ".join(f"{number:g}" for number in value))
        elif math.isinf(value):
            yield Input(group, title, "none")
        else:
            yield Input(group, title, float(value), _MOTOR_DIMENSIONS.get(f.name, "number"))
