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

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import asinh, expm1, inf, isnan, log, log1p, nan, sinh

from wraparc.arc.kernel.effort import CREEP_SCALE, largest_effort
from wraparc.train.member import COARSE, Member, Passage
from wraparc.train.motors import Motor
from wraparc.train.roots import bracketed_root, rising_root

#: Largest entry creep ratio that is considered, either way.
LARGEST_RATIO = 0.5
_LEVEL_SCALE = 1e-5
_LEVEL_END = asinh(LARGEST_RATIO / _LEVEL_SCALE)
_SCAN = 18
_TURNED = 1e-9  # miss of a drum that gives way, in a search


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
    corrections
        What to add to the left side of each equation; empty for nothing [-].
    """

    members: tuple[Member, ...]
    lines: tuple[Line, ...]
    entry: float
    exit: float
    runs: tuple[float, ...]
    corrections: tuple[float, ...] = ()

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
        if len(self.corrections) > 0:
            left += self.corrections[i]
        return left - line.log_speed(self.torque(i, at.entry, at.exit)) - level


class Search:
    """Follows the belt at one level after the other, each time starting from the last answers."""

    def __init__(self, system: System, steps: int = COARSE) -> None:
        self._system = system
        self._steps = steps
        count = len(system.members)
        self._efforts = [nan] * count
        self._slopes = [0.0] * count  # of the speed equations, by effort
        share = system.pull / count
        self._torques = [share * member.arm(system.entry) for member in system.members]
        leads = [
            line.master for i, line in enumerate(system.lines) if line.follows and i < line.master
        ]
        self._early = [
            lead for i, lead in enumerate(leads) if not any(lead == other for other in leads[:i])
        ]
        self._center = self._mean_level()
        self._w = nan  # search variable found last

    def _mean_level(self) -> float:
        """Level at which the drives together creep about nothing."""
        system = self._system
        tension = 0.5 * (system.entry + system.exit)
        levels = [
            member.stretch_log(tension) - line.log_speed(torque)
            for member, line, torque in zip(
                system.members, system.lines, self._torques, strict=True
            )
            if not line.follows
        ]
        return sum(levels) / len(levels)

    def level(self, w: float) -> float:
        """Level of the search variable w."""
        return self._center + _LEVEL_SCALE * sinh(w)

    def follow(self, level: float) -> list[Passage]:
        """Send the belt over all pulleys at a level."""
        system, entry = self._system, self._system.entry
        passages: list[Passage] = []
        for i, (line, run) in enumerate(zip(system.lines, system.runs, strict=True)):
            if line.follows:
                lead = line.master
                torque = self._torques[lead]
                if lead < i:
                    torque = system.torque(lead, passages[lead].entry, passages[lead].exit)
                pull = line.ratio * torque / system.members[i].arm(entry)
                # how it creeps does not matter here
                out = max(entry - pull, 1e-6 * entry)
                passages.append(Passage(entry, out, nan, nan, nan, nan, False))
            else:
                passages.append(self._turned(i, entry, level))
            entry = max(passages[-1].exit + run, 1e-6 * system.entry)
        return passages

    def _turned(self, i: int, entry: float, level: float) -> Passage:
        """Return a pulley whose speed is known, perhaps as a function of its torque."""
        system, member, line = self._system, self._system.members[i], self._system.lines[i]
        if line.motor is None and line.give == 0.0 and not member.holds:
            ratio = -expm1(member.stretch_log(entry) - line.speed - level)
            ratio = min(max(ratio, -LARGEST_RATIO), LARGEST_RATIO)
            return member.passage(entry, member.effort_at(ratio), self._steps)
        found: list[tuple[float, Passage]] = []
        steps = self._steps

        def miss(effort: float) -> float:
            at = member.passage(entry, effort, steps)
            found.append((effort, at))
            return system.speed_miss(i, at, level)

        end = self._largest_effort(i, entry)
        guess = self._efforts[i]
        if isnan(guess):
            guess = 0.5 if member.holds else member.effort_at(1e-3)
            guess = guess if system.pull >= 0.0 else -guess
        effort, _ = rising_root(miss, guess, 0.3, -end, end, _TURNED, self._slopes[i])
        self._efforts[i] = effort
        self._slopes[i] = self._slope(i, [at for _, at in found[-2:]], level)
        return next((at for tried, at in found if tried == effort), found[-1][1])

    def _slope(self, i: int, two: list[Passage], level: float) -> float:
        """Slope of a speed equation by effort between two passages, 0 where it cannot be told."""
        if len(two) < 2 or two[0].effort == two[1].effort:
            return 0.0
        a = self._system.speed_miss(i, two[0], level)
        b = self._system.speed_miss(i, two[1], level)
        return max((b - a) / (two[1].effort - two[0].effort), 0.0)

    def _largest_effort(self, i: int, entry: float) -> float:
        member = self._system.members[i]
        if not member.holds:
            return member.effort_at(LARGEST_RATIO)
        par = member.parameters(entry, 1.0)
        top = largest_effort(member.law, par)
        if member.rests:
            return 1.0 + LARGEST_RATIO * par.length / CREEP_SCALE
        return 1.0 + top

    def miss(self, w: float) -> float:
        """ln(given / reached exit tension): rises with the level."""
        return log(self._system.exit / self.follow(self.level(w))[-1].exit)

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
            guess = asinh(1.5e-3 / _LEVEL_SCALE)
            guess = guess if self._system.pull >= 0.0 else -guess
        w, miss = rising_root(self._of_level(), guess, 0.3, -_LEVEL_END, _LEVEL_END, tolerance)
        self._w = w
        return w, miss

    def _of_level(self) -> Callable[[float], float]:
        def miss(w: float) -> float:
            return self.miss(w)

        return miss

    def _torque_miss(self, lead: int, tolerance: float, torque: float) -> float:
        """Assumed less found torque of a drive that another one ahead of it follows [N m]."""
        self._torques[lead] = torque
        w, _ = self._solution(tolerance)
        at = self.follow(self.level(w))[lead]
        return torque - self._system.torque(lead, at.entry, at.exit)

    def all_solutions(self, tolerance: float = 1e-6) -> list[float]:
        """Search variables of all solutions, from a scan over all levels.

        Between the nodes of the scan, a turn of the curve towards zero is followed to its tip.
        """
        if len(self._early) > 0:
            self.solution(tolerance)
        points = [(w, self.miss(w)) for w in self._nodes()]
        for (a, fa), (b, fb), (c, fc) in zip(points[:-2], points[1:-1], points[2:], strict=True):
            if abs(fb) < min(abs(fa), abs(fc)) and (fa > 0.0) == (fb > 0.0) == (fc > 0.0):
                points.append(self._tip(a, (b, fb), c))
        miss = self._of_level()
        return [
            bracketed_root(miss, a, fa, b, fb, tolerance)[0]
            for (a, fa), (b, fb) in pairwise(sorted(points, key=lambda point: point[0]))
            if (fa < 0.0) != (fb < 0.0)
        ]

    def _nodes(self) -> list[float]:
        """Levels to look at, from that of no creep towards more pull, and beyond it if needed."""
        sign = 1.0 if self._system.pull >= 0.0 else -1.0
        nodes = [sign * _LEVEL_END * k / _SCAN for k in range(_SCAN + 1)]
        if sign * self.miss(0.0) > 0.0:
            nodes = [*nodes, *[-w for w in nodes[1:]]]
        return sorted(nodes)

    def _tip(self, a: float, at: tuple[float, float], c: float) -> tuple[float, float]:
        """Where the curve comes nearest to zero between a and c, or has crossed it."""
        for _ in range(40):
            b, fb = at
            w = 0.62 * b + 0.38 * (a if b - a > c - b else c)
            f = self.miss(w)
            if (f > 0.0) != (fb > 0.0):
                return w, f
            if abs(f) < abs(fb):
                a, c = (b, c) if w > b else (a, b)
                at = w, f
            else:
                a, c = (a, w) if w > b else (w, c)
            if c - a < 1e-4:
                break
        return at

    def strongest(self) -> float:
        """Search variable of the level at which the train pulls (or brakes) most."""
        sign = 1.0 if self._system.pull >= 0.0 else -1.0
        best, best_value = 0.0, -inf
        for w in sorted(self._nodes(), key=abs):
            value = sign * self.miss(w)
            if sign * w >= 0.0 and value > best_value + 1e-9:
                best, best_value = w, value
        return best
