"""Columns of trains: which there are, and what may stand in them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from wraparc.drive import Belt, Lagging, Limit, Pulley
from wraparc.errors import InputError, Problem, name_remedy, shown
from wraparc.train.motors import Motor, TorqueFollower
from wraparc.train.train import Motors, Train, TrainCase

TENSION = TrainCase.LIMITS["entry_tension"]
_FACTOR = Limit("number", open=True, most=100.0)
#: Columns that a train has once.
OF_TRAIN: Mapping[str, Limit] = {
    "entry_tension": TENSION,
    "exit_tension": TENSION,
    "effective_tension": Limit("force", least=-TENSION.most, most=TENSION.most),
    "belt_width": Belt.LIMITS["width"],
    "belt_modulus": Belt.LIMITS["modulus"],
    "belt_speed": Belt.LIMITS["speed"],
}
#: Columns that every drum has, after the name of its pulley: ``second.wear``.
OF_DRUM: Mapping[str, Limit] = {
    "diameter": Pulley.LIMITS["diameter"],
    "nominal_diameter": Pulley.LIMITS["diameter"],
    "wrap_angle": Pulley.LIMITS["wrap_angle"],
    "overrun": Pulley.LIMITS["overrun"],
    "creep_limit": Pulley.LIMITS["creep_limit"],
    "lagging_thickness": Lagging.LIMITS["thickness"],
    "shear_modulus": Lagging.LIMITS["shear_modulus"],
    "compression_modulus": Lagging.LIMITS["compression_modulus"],
    "wear_coefficient": Lagging.LIMITS["wear_coefficient"],
    "friction_factor": _FACTOR,
    "slip_factor": _FACTOR,
    "wear": Lagging.LIMITS["thickness"],
    "run": Limit("force", least=-TENSION.most, most=TENSION.most),
    "share": Limit("number", least=-100.0, most=100.0),
    "speed_trim": Limit("number", open=True, most=10.0),
}
MAY_BE_MISSING = {"belt_speed", "overrun", "wear_coefficient"}


def key_of(name: str, train: Train) -> tuple[int, str] | None:
    """Return the drum (-1 for none) and the key of a column, None if there is no such one."""
    if name in OF_TRAIN:
        return -1, name
    division = train.cases[0].division
    for i, pulley in enumerate(train.pulleys):
        key = name.removeprefix(f"{pulley.name}.")
        motor = division.motors[i] if isinstance(division, Motors) else None
        if key != name and (key in OF_DRUM or key in of_motor(motor)):
            return i, key
    return None


def of_motor(motor: Motor | TorqueFollower | None) -> Mapping[str, Limit]:
    """Numbers of a motor that may vary, and their limits."""
    return {k: v for k, v in motor.LIMITS.items() if k != "count"} if motor else {}


def refuse_names(
    given: Mapping[str, Any], kinds: Mapping[str, tuple[int, str]], train: Train
) -> None:
    """Raise what is wrong with the names of columns."""
    names = [p.name for p in train.pulleys]
    division = train.cases[0].division
    motors = division.motors if isinstance(division, Motors) else ()
    own = dict.fromkeys(k for m in motors for k in of_motor(m))
    known = [*OF_TRAIN, *(f"{n}.{k}" for n in names for k in (*OF_DRUM, *own))]
    problems = [
        Problem(
            key=f"column {shown(name)}",
            message="no such column",
            remedy=name_remedy(name, known),
        )
        for name in given
        if name not in kinds
    ]
    asked = {key for _, key in kinds.values()}
    if {"entry_tension", "exit_tension", "effective_tension"} <= asked:
        message = "follows from entry_tension and exit_tension"
        problems.append(Problem(key='column "effective_tension"', message=message))
    for a, b in (("share", "speed_trim"), ("speed_trim", "motor")):
        if a in asked and (b in asked or (b == "motor" and motors)):
            message = (
                "decides how the load divides, as the speeds do"
                if b == "speed_trim"
                else "the pulleys turn as their motors do"
            )
            remedy = "Give one of them." if b == "speed_trim" else "Vary a setting of the motor."
            problems.append(Problem(key=f'column "{a}"', message=message, remedy=remedy))
    first = f"{names[0]}.run"
    if first in given:
        message = "the first pulley has no run before it"
        problems.append(Problem(key=f"column {shown(first)}", message=message))
    if problems:
        raise InputError(problems)
