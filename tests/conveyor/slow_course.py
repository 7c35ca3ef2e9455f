"""The tensions of a conveyor by marching along its belt, independent of `wraparc.conveyor`.

Written from the definitions: a metre of belt that is accelerated, lifted and rubs on idlers. The
loop is walked in steps of five metres from the take-up on; the pull of all drives is sought by
secants until the belt returns with the tension of the take-up.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

G = 9.80665
STEP = 5.0


@dataclass(frozen=True)
class Part:
    """A flight: length [m], lift [m], material on it [kg/m], friction factor, idlers [kg/m]."""

    length: float
    lift: float
    material: float
    friction: float
    carry_idlers: float
    return_idlers: float


@dataclass(frozen=True)
class Bend:
    """A pulley that is not driven: where on the loop [m], diameter, shaft and mass of it."""

    at: float
    diameter: float
    shaft: float
    mass: float


@dataclass(frozen=True)
class Loop:
    """A conveyor as numbers; places are metres of belt from the tail pulley on."""

    parts: tuple[Part, ...]
    belt: float
    take_up: float
    take_up_at: float
    drives: tuple[tuple[float, float], ...]  # place and share
    acceleration: float = 0.0
    spread_carry: float = 0.0  # secondary and special resistances per metre [N/m]
    bends: tuple[Bend, ...] = ()
    width: float = 0.0
    thickness: float = 0.0
    points: dict[float, float] = field(default_factory=dict)  # forces at places [N]

    @property
    def length(self) -> float:
        return sum(part.length for part in self.parts)

    def per_metre(self, place: float) -> float:
        """Force that a metre of belt takes at a place of the loop [N/m]."""
        there, carries = place % (2 * self.length), place % (2 * self.length) < self.length
        from_tail = there if carries else 2 * self.length - there
        end = 0.0
        for part in self.parts:
            end += part.length
            if from_tail < end:
                break
        sine = part.lift / part.length
        loaded = self.belt + (part.material if carries else 0.0)
        idlers = part.carry_idlers if carries else part.return_idlers
        rubbing = part.friction * (idlers + loaded * math.sqrt(1 - sine * sine)) * G
        lifting = loaded * G * (sine if carries else -sine)
        speeding = self.acceleration * (loaded + idlers)
        return rubbing + lifting + speeding + (self.spread_carry if carries else 0.0)

    def around(self, pull: float) -> tuple[float, list[tuple[float, float]]]:
        """Tension on return to the take-up, and before and behind each drive [N]."""
        tension, drives = self.take_up, [(math.nan, math.nan)] * len(self.drives)
        steps = round(2 * self.length / STEP)
        for k in range(steps):
            place = (self.take_up_at + k * STEP) % (2 * self.length)
            if k > 0:  # what stands at the take-up itself is met last
                tension = self.passed(place, tension, pull, drives)
            tension += self.per_metre(place + STEP / 2) * STEP
        return self.passed(self.take_up_at, tension, pull, drives), drives

    def passed(
        self, place: float, tension: float, pull: float, drives: list[tuple[float, float]]
    ) -> float:
        for bend in self.bends:
            if abs(bend.at - place) < 1e-6:
                tension = self.bent(bend, tension)
        for i, (at, share) in enumerate(self.drives):
            if abs(at - place) < 1e-6:
                drives[i] = (tension, tension - share * pull)
                tension -= share * pull
        return tension + sum(f for at, f in self.points.items() if abs(at - place) < 1e-6)

    def bent(self, bend: Bend, before: float) -> float:
        """Tension behind a pulley, whose resistance goes by the mean of both sides [N]."""

        def lacking(after: float) -> float:
            mean = 0.5 * (before + after)
            wrap = 9 * self.width * (140 + 0.01 * mean / self.width)
            wrap *= self.thickness / bend.diameter
            load = math.sqrt((2 * mean) ** 2 + (bend.mass * G) ** 2)
            return before + wrap + 0.005 * load * bend.shaft / bend.diameter - after

        return bisect(lacking, before, before + 1e5)

    def solved(self) -> tuple[float, list[tuple[float, float]]]:
        """Pull of all drives, and the tensions at each [N]."""
        one, other = 0.0, 1e5
        lacks = self.around(one)[0] - self.take_up
        for _ in range(8):
            now = self.around(other)[0] - self.take_up
            if abs(now) < 1e-9 or now == lacks:
                break
            one, other, lacks = other, other - now * (other - one) / (now - lacks), now
        return other, self.around(other)[1]


def bisect(of: Callable[[float], float], low: float, high: float) -> float:
    """Where a falling function is 0."""
    for _ in range(80):
        middle = 0.5 * (low + high)
        if of(middle) > 0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
