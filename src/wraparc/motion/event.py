"""What happens to a station in time: starts, stops, loads, and what rides on belt and drums."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import ClassVar, Literal

from wraparc.drive import Limit
from wraparc.errors import Problem
from wraparc.schema.limits import limit_problems, raise_all

Kind = Literal[
    "start", "stop", "emergency-stop", "power-failure", "load-step", "wet-patch", "splice",
    "run-out", "lagging-joints", "torque-ripple", "measured",
]  # fmt: skip
Shape = Literal["ramp", "s-curve", "direct", "coupling-fill"]
SHAPES: tuple[Shape, ...] = ("ramp", "s-curve", "direct", "coupling-fill")


@dataclass(frozen=True, kw_only=True)
class Happening:
    """One thing that happens.

    Attributes
    ----------
    at
        When it begins [s].
    """

    LIMITS: ClassVar[dict[str, Limit]] = {"at": Limit("time", most=1e6)}
    at: float = 0.0

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))


@dataclass(frozen=True, kw_only=True)
class Start(Happening):
    """The drives go from rest to their speed.

    Attributes
    ----------
    shape
        Of the set speed: ``ramp``, ``s-curve``, ``direct`` on line, or ``coupling-fill``, which
        fills the couplings of motors that run up without load.
    time
        How long it takes [s].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Happening.LIMITS | {"time": Limit("time", most=1e4)}
    shape: Shape = "s-curve"
    time: float = 20.0

    def level(self, t: float) -> float:
        """Set speed, or filling, over that of the steady state [-]."""
        return _risen(self.shape, t - self.at, self.time)


@dataclass(frozen=True, kw_only=True)
class Stop(Start):
    """The set speed goes to 0."""

    def level(self, t: float) -> float:
        """Set speed over that of the steady state [-]."""
        return 1.0 - _risen(self.shape, t - self.at, self.time)


def _risen(shape: Shape, t: float, time: float) -> float:
    if shape == "direct" or time <= 0.0:
        return 1.0 if t >= 0.0 else 0.0
    w = min(max(t / time, 0.0), 1.0)
    return 0.5 * (1.0 - math.cos(math.pi * w)) if shape == "s-curve" else w


@dataclass(frozen=True, kw_only=True)
class PowerFailure(Happening):
    """All motors lose their torque.

    Attributes
    ----------
    brakes
        Whether the brakes come on: an emergency stop.
    """

    brakes: bool = False


@dataclass(frozen=True, kw_only=True)
class LoadStep(Happening):
    """The resistance of the conveyor, or the outer tension, changes.

    Attributes
    ----------
    factor
        New resistance over that of the load case [-].
    time
        How long the change takes [s].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Happening.LIMITS | {
        "factor": Limit("number", least=-10.0, most=10.0),
        "time": Limit("time", most=1e4),
    }
    factor: float
    time: float = 0.0

    def share(self, t: float) -> float:
        """Resistance over that of the load case [-]."""
        return 1.0 + (self.factor - 1.0) * _risen("ramp", t - self.at, self.time)


@dataclass(frozen=True, kw_only=True)
class OnBelt(Happening):
    """Something that rides on the belt and enters the first drum at its time.

    Attributes
    ----------
    length
        On the belt [m].
    friction
        Friction there over that of the dry belt: a wet patch [-].
    rise
        Height of its cords over those beside it: a splice [m].
    compliance
        Of the belt there over that beside it [-].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Happening.LIMITS | {
        "length": Limit("length", open=True, most=1e4),
        "friction": Limit("number", least=0.01, most=2.0),
        "rise": Limit("length", least=-0.1, most=0.1),
        "compliance": Limit("number", least=0.05, most=20.0),
    }
    length: float
    friction: float = 1.0
    rise: float = 0.0
    compliance: float = 1.0

    def part(self, along: float, edge: float) -> float:
        """How much of it is at a distance behind its front [-]: 0, over its edges, 1.

        Parameters
        ----------
        along
            Distance behind the front [m].
        edge
            Length over which it begins and ends [m].
        """
        return min(max(min(along, self.length - along) / edge + 0.5, 0.0), 1.0)


@dataclass(frozen=True, kw_only=True)
class OnDrum(Happening):
    """Something that turns with a drum.

    Attributes
    ----------
    pulley
        Its name.
    run_out
        Amplitude of the radius [m].
    ripple
        Amplitude of the motor's torque over its steady torque [-].
    order
        Waves a turn [-].
    joint_rise, joints, joint_width
        Height of the joints of the lagging, how many there are, how wide each is [m, -, m].
    """

    LIMITS: ClassVar[dict[str, Limit]] = Happening.LIMITS | {
        "run_out": Limit("length", least=-0.05, most=0.05),
        "ripple": Limit("number", least=-1.0, most=1.0),
        "order": Limit("number", least=1, most=200),
        "joint_rise": Limit("length", least=-0.05, most=0.05),
        "joints": Limit("number", least=1, most=100),
        "joint_width": Limit("length", open=True, most=1.0),
    }
    pulley: str
    run_out: float = 0.0
    ripple: float = 0.0
    order: float = 1.0
    joint_rise: float = 0.0
    joints: float = 4.0
    joint_width: float = 0.04

    def rise(self, angle: float, radius: float) -> float:
        """Extra radius at an angle of the drum [rad] of a radius [m]."""
        rise = self.run_out * math.cos(self.order * angle)
        if self.joint_rise:
            part = (angle / (2.0 * math.pi) * self.joints) % 1.0
            away = min(part, 1.0 - part) * 2.0 * math.pi * radius / self.joints
            if away < 0.5 * self.joint_width:  # a smooth bump
                rise += self.joint_rise * math.cos(math.pi * away / self.joint_width) ** 2
        return rise


@dataclass(frozen=True, kw_only=True)
class Measured(Happening):
    """A measured speed or torque of a drum in time.

    Attributes
    ----------
    pulley
        Its name.
    times
        From the beginning of the record [s].
    values
        Drum speed [rad/s] or torque at the drum [N m].
    what
        ``speed`` or ``torque``.
    """

    pulley: str
    times: tuple[float, ...]
    values: tuple[float, ...]
    what: Literal["speed", "torque"] = "speed"

    def __post_init__(self) -> None:
        super().__post_init__()
        problems = []
        if len(self.times) < 2 or len(self.times) != len(self.values):
            problems.append(Problem(key="times", message="must be as many as values, two or more"))
        elif any(b <= a for a, b in zip(self.times, self.times[1:], strict=False)):
            problems.append(Problem(key="times", message="must ascend"))
        if not all(map(math.isfinite, (*self.times, *self.values))):
            message = "a value is missing or not a number"
            remedy = "Cut the record before the gap."
            problems.append(Problem(key="values", message=message, remedy=remedy))
        raise_all(problems)

    def value(self, t: float) -> float:
        """Value at a time, between the samples linearly, held outside."""
        import bisect

        t -= self.at
        if t <= self.times[0]:
            return self.values[0]
        if t >= self.times[-1]:
            return self.values[-1]
        i = bisect.bisect_right(self.times, t)
        a, b = self.times[i - 1], self.times[i]
        w = (t - a) / (b - a)
        return self.values[i - 1] + w * (self.values[i] - self.values[i - 1])


@dataclass(frozen=True, kw_only=True)
class Event:
    """What happens, in order, and for how long it is looked at.

    Attributes
    ----------
    name
        What it is called.
    duration
        Of the run [s].
    happenings
        What happens.
    report
        Whether the calculation note follows it and counts its checks.
    """

    LIMITS: ClassVar[dict[str, Limit]] = {"duration": Limit("time", open=True, most=1e6)}
    name: str = "event"
    duration: float = 60.0
    happenings: tuple[Happening, ...] = field(default=())
    report: bool = False

    def __post_init__(self) -> None:
        raise_all(limit_problems(self, self.LIMITS))

    def of(self, kind: type[Happening]) -> list[Happening]:
        """Return what happens of a kind (with its own kinds)."""
        return [h for h in self.happenings if isinstance(h, kind)]

    @cached_property
    def moves(self) -> tuple[Start, ...]:
        """Starts and stops in time."""
        moves = (h for h in self.happenings if isinstance(h, Start))
        return tuple(sorted(moves, key=lambda h: h.at))

    @cached_property
    def instants(self) -> tuple[float, ...]:
        """When something begins or comes to its end [s]; what rides or turns is left out."""
        times = {h.at for h in self.happenings if isinstance(h, Start | LoadStep | PowerFailure)}
        times |= {h.at + h.time for h in self.happenings if isinstance(h, Start | LoadStep)}
        return tuple(sorted(times))

    @property
    def from_rest(self) -> bool:
        """Whether the station stands when it begins."""
        return bool(self.moves) and type(self.moves[0]) is Start

    def level(self, t: float) -> float:
        """Set speed over that of the steady state [-]."""
        level = 0.0 if self.from_rest else 1.0
        for move in self.moves:
            if t >= move.at:
                level = move.level(t)
        return level

    def fill(self, t: float) -> float:
        """How full the fluid couplings are [-]."""
        filled = 1.0
        for move in self.moves:
            if t >= move.at and move.shape == "coupling-fill" and type(move) is Start:
                filled = max(move.level(t), 1e-6)
        return filled
