"""The equations of a train in one load case, and a search that cannot miss their solution.

With the level lambda = -ln(v0/V), v0 the speed of the unstretched belt and V a reference, a drum
that turns at omega(M) asks of its pulley

    -ln(1 - g) + ln(1 + T1/EA) - ln(1 - delta/R) = ln(omega(M) R/V) + lambda.

For a level, the belt can be followed from the first entry nip to the last exit nip, pulley by
pulley: the left side rises with the creep of each pulley, and so each step has one answer. The
last exit tension falls as the level rises; the level at which it is the given one is the solution,
whatever the number of pulleys.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import asinh, cosh, inf, isnan, log, log1p, nan, sinh
from typing import NamedTuple

from wraparc.train.member import COARSE, LARGEST_RATIO, Member, Passage
from wraparc.train.motors import Motor
from wraparc.train.roots import rising_root, sloped_root

_LEVEL_SCALE = 1e-5
_LEVEL_END = asinh(LARGEST_RATIO / _LEVEL_SCALE)
_SCAN = 18
_TURNED = 1e-9  # miss of the speed of a drum, in a search
_FIRST_RATIO = 1.5e-3  # first guess of an entry creep ratio
_TIP, _TIP_STEPS = 1e-4, 12  # of search variable: how near a turn of the curve is found, in steps


@dataclass(frozen=True)
class Line:
    """What turns one drum.

    Attributes
    ----------
    speed
        ln(omega R/V) of a drum whose speed is held [-].
    motor, scale
        What gives its speed otherwise, and R/V [s]; or None.
    master, ratio
        Index of the drive that is followed and the ratio of torques; or -1.
    give
        Fall of ln(speed) per torque of a held speed [1/(N m)]: for a start only, see
        :mod:`wraparc.train.locate`.
    """

    speed: float = 0.0
    motor: Motor | None = None
    scale: float = 1.0
    master: int = -1
    ratio: float = 1.0
    give: float = 0.0

    @property
    def follows(self) -> bool:
        """Whether the torque follows another drive."""
        return self.master >= 0

    def log_speed(self, torque: float) -> float:
        """ln(omega R/V) at a drum torque [N m]."""
        if self.motor is None:
            return self.speed - self.give * torque
        return log(self.motor.drum_speed(torque) * self.scale)

    def log_speed_slope(self, torque: float) -> float:
        """Its slope, at most 0 [1/(N m)]."""
        if self.motor is None:
            return -self.give
        step = 1e-6 * self.motor.drum_torque
        return 0.5 * (self.log_speed(torque + step) - self.log_speed(torque - step)) / step


@dataclass(frozen=True)
class System:
    """One load case of a train as numbers.

    Attributes
    ----------
    members, lines
        Pulleys and what turns them.
    entry, exit
        First entry and last exit tension [N].
    runs
        Rise of tension behind each pulley; 0 behind the last [N].
    """

    members: tuple[Member, ...]
    lines: tuple[Line, ...]
    entry: float
    exit: float
    runs: tuple[float, ...]

    @property
    def pull(self) -> float:
        """Total effective tension [N]."""
        return self.entry + sum(self.runs) - self.exit

    @property
    def torque_scale(self) -> float:
        """A torque to measure others by [N m]."""
        return max(self.entry, self.exit) * self.members[0].radius

    def torque(self, i: int, entry: float, exit_: float) -> float:
        """Torque on a drum, (T1 - T2)(R - delta) [N m]."""
        return (entry - exit_) * self.members[i].arm(entry)

    def speed_miss(self, i: int, at: Passage, level: float) -> float:
        """Left less right side of the equation of a pulley [-]."""
        member, line = self.members[i], self.lines[i]
        left = -log1p(-min(at.ratio, 0.99)) + member.stretch_log(at.entry)
        return left - line.log_speed(self.torque(i, at.entry, at.exit)) - level

    def speed_slopes(self, i: int, at: Passage) -> tuple[float, float]:
        """Slopes of `speed_miss` by the entry tension [1/N] and by the place [1/m]."""
        member, slopes = self.members[i], at.slopes
        arm, leaves = member.arm(at.entry), 1.0 - min(at.ratio, 0.99)
        by_torque = self.lines[i].log_speed_slope(self.torque(i, at.entry, at.exit))
        torque_by_entry = (1.0 - slopes.exit_by_entry) * arm - (at.entry - at.exit) * member.squeeze
        by_entry = slopes.ratio_by_entry / leaves + member.stretch_slope(at.entry)
        return (
            by_entry - by_torque * torque_by_entry,
            slopes.ratio_by_place / leaves + by_torque * slopes.exit_by_place * arm,
        )


def mean_level(system: System) -> float:
    """Level at which the drives together creep about nothing."""
    tension, share = 0.5 * (system.entry + system.exit), system.pull / len(system.members)
    levels = [
        member.stretch_log(tension) - line.log_speed(share * member.arm(system.entry))
        for member, line in zip(system.members, system.lines, strict=True)
        if not line.follows
    ]
    return sum(levels) / len(levels)


def first_place(system: System, i: int) -> float:
    """Where a pulley may be, before anything is known [m]."""
    member = system.members[i]
    place = member.place_of(_FIRST_RATIO * member.length)
    return place if system.pull >= 0.0 else -place


def guessed(system: System) -> tuple[list[Passage], float]:
    """Passages of a train of which nothing is known but their places, and a level."""
    places = [first_place(system, i) for i in range(len(system.members))]
    return [Passage(system.entry, system.exit, x) for x in places], mean_level(system)


class Followed(NamedTuple):
    """The belt followed at a level.

    Attributes
    ----------
    passages
        One for each pulley.
    by_level
        Slope of the last exit tension by the level [N].
    """

    passages: list[Passage]
    by_level: float


class Node(NamedTuple):
    """A place of the curve that a search goes along: w, the miss there and its slope [-]."""

    w: float
    miss: float
    slope: float


class Search:
    """Follows the belt at one level after the other, each time starting from the last answers."""

    def __init__(self, system: System, tol: float = COARSE) -> None:
        self._system = system
        self._tol = tol
        self._last: list[Passage | None] = [None for _ in system.members]
        share = system.pull / len(system.members)
        self._torques = [share * member.arm(system.entry) for member in system.members]
        leads = [
            line.master for i, line in enumerate(system.lines) if line.follows and i < line.master
        ]
        self._early = [
            lead for i, lead in enumerate(leads) if not any(lead == other for other in leads[:i])
        ]
        self._center = mean_level(system)
        self._w = nan  # search variable found last

    def level(self, w: float) -> float:
        """Level of the search variable w."""
        return self._center + _LEVEL_SCALE * sinh(w)

    def follow(self, level: float) -> Followed:
        """Send the belt over all pulleys at a level."""
        system, entry, rise = self._system, self._system.entry, 0.0
        passages: list[Passage] = []
        torques: list[float] = []  # slopes by the level
        for i, (line, run) in enumerate(zip(system.lines, system.runs, strict=True)):
            member = system.members[i]
            arm = member.arm(entry)
            if line.follows:
                lead, torque, turns = line.master, self._torques[line.master], 0.0
                if lead < i:
                    torque = system.torque(lead, passages[lead].entry, passages[lead].exit)
                    turns = torques[lead]
                # how it creeps does not matter here
                out = max(entry - line.ratio * torque / arm, 1e-6 * entry)
                at, grows = Passage(entry, out), rise - line.ratio * turns / arm
            else:
                at = self._turned(i, entry, level)
                by_entry, by_place = system.speed_slopes(i, at)
                moved = (1.0 - by_entry * rise) / by_place if by_place > 0.0 else 0.0
                grows = at.slopes.exit_by_entry * rise + at.slopes.exit_by_place * moved
                self._last[i] = at
            torques.append((rise - grows) * arm - (entry - at.exit) * member.squeeze * rise)
            passages.append(at)
            entry, rise = max(at.exit + run, 1e-6 * system.entry), grows
        return Followed(passages, rise)

    def _turned(self, i: int, entry: float, level: float) -> Passage:
        """Return a pulley whose speed is known, perhaps as a function of its torque."""
        system, member, last = self._system, self._system.members[i], self._last[i]
        end = member.largest_place
        found: list[Passage] = [] if last is None else [last]

        def miss(place: float) -> tuple[float, float]:
            near = found[len(found) - 1].met if len(found) > 0 else None
            at = member.passage(entry, place, near, self._tol)
            found.append(at)
            return system.speed_miss(i, at, level), system.speed_slopes(i, at)[1]

        if last is None:
            place = first_place(system, i)
        else:
            by_entry, by_place = system.speed_slopes(i, last)
            short = system.speed_miss(i, last, level) + by_entry * (entry - last.entry)
            place = last.place - short / by_place if by_place > 0.0 else last.place
        sloped_root(miss, place, -end, end, _TURNED)
        return found[len(found) - 1]

    def miss(self, w: float) -> Node:
        """ln(given / reached exit tension): rises with the level."""
        found = self.follow(self.level(w))
        last = found.passages[len(found.passages) - 1].exit
        slope = -found.by_level / last * _LEVEL_SCALE * cosh(w)
        return Node(w, log(self._system.exit / last), slope)

    def solution(self, tolerance: float = 1e-5) -> tuple[float, float]:
        """Search variable of the solution, and the miss there (not small: there is none)."""
        scale = self._system.torque_scale
        for _ in range(20 if len(self._early) > 0 else 0):
            # the torque that a drive ahead of its master goes by: the more it takes, the less is
            # left for the master, so that assumed less found torque rises
            before = list(self._torques)
            for lead in self._early:
                self._lead(lead, before[lead], tolerance)
            if all(abs(self._torques[i] - before[i]) < 1e-4 * scale for i in self._early):
                break
        return self._solution(tolerance)

    def _lead(self, lead: int, start: float, tolerance: float) -> None:
        """Find the torque of a drive that another one ahead of it follows."""
        scale = self._system.torque_scale

        def miss(torque: float) -> float:
            return self._torque_miss(lead, tolerance, torque)

        rising_root(miss, start, 0.1 * scale, -scale, scale, 1e-5 * scale)

    def _solution(self, tolerance: float) -> tuple[float, float]:
        guess = self._w
        if isnan(guess):
            guess = asinh(_FIRST_RATIO / _LEVEL_SCALE)
            guess = guess if self._system.pull >= 0.0 else -guess
        self._w, miss = self._root(guess, -_LEVEL_END, _LEVEL_END, tolerance)
        return self._w, miss

    def _root(self, w: float, low: float, high: float, tolerance: float) -> tuple[float, float]:
        def miss(x: float) -> tuple[float, float]:
            at = self.miss(x)
            return at.miss, at.slope

        return sloped_root(miss, w, low, high, tolerance)

    def _torque_miss(self, lead: int, tolerance: float, torque: float) -> float:
        """Assumed less found torque of a drive that another one ahead of it follows [N m]."""
        self._torques[lead] = torque
        w, _ = self._solution(tolerance)
        at = self.follow(self.level(w)).passages[lead]
        return torque - self._system.torque(lead, at.entry, at.exit)

    def all_solutions(self, tolerance: float = 1e-6) -> list[float]:
        """Search variables of all solutions, from a scan over all levels.

        Between the nodes of the scan, a turn of the curve towards zero is followed to its tip.
        """
        if len(self._early) > 0:
            self.solution(tolerance)
        nodes = [self.miss(w) for w in self._levels()]
        tips = [self._tip(a, b) for a, b in pairwise(nodes) if _turns(a, b)]
        nodes = sorted([*nodes, *tips], key=lambda node: node.w)
        found = []
        for a, b in pairwise(nodes):
            if (a.miss < 0.0) != (b.miss < 0.0):
                found.append(self._crossing(a, b, tolerance))
        return found

    def _crossing(self, a: Node, b: Node, tolerance: float) -> float:
        """Where the curve crosses zero between two nodes, either way."""
        way = 1.0 if a.miss < 0.0 else -1.0

        def miss(w: float) -> tuple[float, float]:
            at = self.miss(w)
            return way * at.miss, way * at.slope

        share = a.miss / (a.miss - b.miss)
        return sloped_root(miss, a.w + share * (b.w - a.w), a.w, b.w, tolerance)[0]

    def _levels(self) -> list[float]:
        """Levels to look at, from that of no creep towards more pull, and beyond it if needed."""
        sign = 1.0 if self._system.pull >= 0.0 else -1.0
        nodes = [sign * _LEVEL_END * k / _SCAN for k in range(_SCAN + 1)]
        if sign * self.miss(0.0).miss > 0.0:
            nodes = [*nodes, *[-w for w in nodes[1:]]]
        return sorted(nodes)

    def _tip(self, a: Node, b: Node) -> Node:
        """Where the curve comes nearest to zero between a and b, or has crossed it."""
        way = 1.0 if a.miss > 0.0 else -1.0
        best = a if way * a.miss < way * b.miss else b
        for _ in range(_TIP_STEPS):
            at = self.miss((a.w * b.slope - b.w * a.slope) / (b.slope - a.slope))
            if way * at.miss < way * best.miss:
                best = at
            if way * at.miss < 0.0 or b.w - a.w < _TIP:
                break
            if way * at.slope < 0.0:
                a = at
            else:
                b = at
        return best

    def strongest(self) -> float:
        """Search variable of the level at which the train pulls (or brakes) most."""
        sign = 1.0 if self._system.pull >= 0.0 else -1.0
        best, best_value = 0.0, -inf
        for w in sorted(self._levels(), key=abs):
            value = sign * self.miss(w).miss
            if sign * w >= 0.0 and value > best_value + 1e-9:
                best, best_value = w, value
        return best


def _turns(a: Node, b: Node) -> bool:
    """Whether the curve turns between two nodes on one side of zero, towards it and away."""
    way = 1.0 if a.miss > 0.0 else -1.0
    return way * b.miss > 0.0 and way * a.slope < 0.0 < way * b.slope
