"""All equations of a train at once, by Newton's method, and how the shares answer to the speeds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isfinite, isnan, log, nan

from wraparc.train.linear import Matrix, Row, corrected, solution
from wraparc.train.member import FINE, Passage, Slopes
from wraparc.train.system import System

#: Miss of a speed equation and of the logarithm of the last tension that counts as none.
TOLERANCE = 1e-13
#: Weight of a speed equation beside that of the last tension, for comparing misses only.
_SPEED_WEIGHT = 1e3
_LARGEST_STEP = 1.5  # of an effort


@dataclass(frozen=True, eq=False)
class Linear:
    """The equations near a state: unknowns are the efforts and the level.

    Attributes
    ----------
    matrix
        Slopes of the equations: one per drive, and the last exit tension; (n + 1, n + 1).
    pulls
        Slopes of T1 - T2 of each pulley; (n, n + 1) [N].
    follows
        Which drives follow the torque of another.
    """

    matrix: Matrix
    pulls: Matrix
    follows: tuple[bool, ...]

    def share_slopes(self, total: float) -> Matrix:
        """Slopes d share_i / d ln(speed of drive j), (n, n) [-]; nan where nothing is shared.

        A drive whose torque follows another has no speed of its own: its column is 0.
        """
        count = len(self.pulls)
        slopes = [[nan] * count for _ in range(count)]
        for j in range(count if total != 0.0 else 0):
            right = [0.0] * (count + 1)
            right[j] = 0.0 if self.follows[j] else 1.0
            changes = solution(self.matrix, right)
            if changes is not None:
                for i in range(count):
                    slopes[i][j] = _dot(self.pulls[i], changes) / total
        return slopes


def _dot(one: Row, other: Row) -> float:
    return sum(a * b for a, b in zip(one, other, strict=True))


@dataclass(frozen=True, eq=False)
class Settled:
    """A state that meets all equations.

    Attributes
    ----------
    passages
        One for each pulley.
    level
        ln(V/v0) [-].
    linear
        The equations near it.
    rising
        Whether each drive pulls more if it creeps more; where not, it is past its peak.
    """

    passages: tuple[Passage, ...]
    level: float
    linear: Linear
    rising: tuple[bool, ...]

    @property
    def stable(self) -> bool:
        """Whether every drive is on the rising side of its peak."""
        return all(self.rising)


def linearized(
    system: System, passages: Sequence[Passage], steps: int = FINE
) -> tuple[Linear, tuple[bool, ...]]:
    """Return the equations near a state, and whether each drive rises with its creep."""
    count = len(passages)
    matrix: Matrix = [[0.0] * (count + 1) for _ in range(count + 1)]
    pulls: Matrix = []
    torques: Matrix = []
    entry = [0.0] * (count + 1)  # slopes of the entry tension
    slopes = [m.slopes(at, steps) for m, at in zip(system.members, passages, strict=True)]
    for i, (at, s) in enumerate(zip(passages, slopes, strict=True)):
        member = system.members[i]
        leaving = [s.exit_by_entry * x for x in entry]
        leaving[i] += s.exit_by_effort
        pull = [x - y for x, y in zip(entry, leaving, strict=True)]
        arm, lost = member.arm(at.entry), (at.entry - at.exit) * member.squeeze
        pulls.append(pull)
        torques.append([x * arm - lost * y for x, y in zip(pull, entry, strict=True)])
        if not system.lines[i].follows:
            matrix[i] = _speed_row(system, i, at, s, entry, torques[i])
        entry = leaving
    for i, line in enumerate(system.lines):
        if line.follows:
            pairs = zip(torques[i], torques[line.master], strict=True)
            matrix[i] = [(x - line.ratio * y) / system.torque_scale for x, y in pairs]
    matrix[count] = [x / passages[-1].exit for x in entry]
    rising = tuple(s.exit_by_effort <= 0.0 for s in slopes)
    return Linear(matrix, pulls, tuple(line.follows for line in system.lines)), rising


def _speed_row(system: System, i: int, at: Passage, s: Slopes, entry: Row, torque: Row) -> Row:
    creep = [s.ratio_by_entry * x for x in entry]
    creep[i] += s.ratio_by_effort
    stretch = system.members[i].stretch_slope(at.entry)
    slope = system.lines[i].log_speed_slope(system.torque(i, at.entry, at.exit))
    row = [
        c / (1.0 - at.ratio) + stretch * x - slope * t
        for c, x, t in zip(creep, entry, torque, strict=True)
    ]
    row[len(row) - 1] -= 1.0
    return row


def settle(
    system: System,
    passages: Sequence[Passage],
    level: float,
    steps: int = FINE,
    near: Settled | None = None,
    tolerance: float = TOLERANCE,
) -> Settled | None:
    """Meet all equations from a state nearby; None if that fails.

    Slopes serve for several steps, corrected by what each step shows, as long as the misses shrink
    fast.

    Parameters
    ----------
    system
        The equations.
    passages, level
        The state to start from.
    steps
        Mesh steps of the arcs.
    near
        A state met before, whose slopes may do.
    tolerance
        Largest miss of a speed equation [-].
    """
    efforts = _efforts(system, passages)
    if efforts is None:
        return None
    at = _point(system, efforts, level, steps)
    for i in range(30):
        if i == 0 and near is not None:
            linear, rising = near.linear, near.rising
        else:
            linear, rising = linearized(system, at.state, steps)
        first, matrix = at, linear.matrix
        for k in range(10):
            if at.size <= tolerance * _SPEED_WEIGHT:
                if near is None and not _near(first.state, at.state):
                    linear, rising = linearized(system, at.state, steps)
                return Settled(at.state, at.level, linear, rising)
            new = _stepped(at, system, matrix, k == 0)
            if new is None or new.size >= at.size:
                break
            matrix = _learned(matrix, at, new)
            slow = new.size > 0.3 * at.size
            at = new
            if slow:
                break
        if at is first and (
            i > 0 or near is None
        ):  # no step is any better: rounding, or no solution
            done = at.size <= 1e3 * tolerance * _SPEED_WEIGHT
            return Settled(at.state, at.level, linear, rising) if done else None
    return None


@dataclass(frozen=True, eq=False)
class _Point:
    """A point of the iteration."""

    efforts: tuple[float, ...]
    level: float
    state: tuple[Passage, ...]
    misses: Row
    steps: int

    @property
    def size(self) -> float:
        """Largest miss, weighted; inf where something is not finite."""
        if not all(isfinite(miss) for miss in self.misses):
            return inf
        speeds = max(abs(miss) for miss in self.misses[:-1])
        return max(_SPEED_WEIGHT * speeds, abs(self.misses[-1]))


def _point(system: System, efforts: Sequence[float], level: float, steps: int) -> _Point:
    state = _state(system, efforts, steps)
    return _Point(tuple(efforts), level, state, _misses(system, state, level), steps)


def _stepped(at: _Point, system: System, matrix: Matrix, search: bool) -> _Point | None:
    """Take the step of the linear equations, shortened until it helps if `search`."""
    step = solution(matrix, [-miss for miss in at.misses])
    if step is None or not all(isfinite(change) for change in step):
        return None
    longest = max(abs(change) for change in step[:-1])
    scale = min(1.0, _LARGEST_STEP / max(longest, 1e-300))
    for _ in range(15 if search else 1):
        efforts = [e + scale * d for e, d in zip(at.efforts, step[:-1], strict=True)]
        new = _point(system, efforts, at.level + scale * step[-1], at.steps)
        if new.size < at.size:
            return new
        scale *= 0.5
    return None


def _learned(matrix: Matrix, a: _Point, b: _Point) -> Matrix:
    """Return slopes that are true between two points (Broyden), little changed otherwise."""
    step = [y - x for x, y in zip((*a.efforts, a.level), (*b.efforts, b.level), strict=True)]
    return corrected(matrix, step, [y - x for x, y in zip(a.misses, b.misses, strict=True)])


def _efforts(system: System, passages: Sequence[Passage]) -> list[float] | None:
    """Efforts of passages; those known by their tensions only are solved for them."""
    efforts = []
    for member, at in zip(system.members, passages, strict=True):
        known: Passage | None = at
        if isnan(at.effort):
            known = member.between(at.entry, at.exit)
        if known is None:
            return None
        efforts.append(known.effort)
    return efforts


def _state(system: System, efforts: Sequence[float], steps: int) -> tuple[Passage, ...]:
    entry, state = system.entry, []
    for member, effort, run in zip(system.members, efforts, system.runs, strict=True):
        at = member.passage(max(entry, 1e-6 * system.entry), effort, steps)
        state.append(at)
        entry = at.exit + run
    return tuple(state)


def _misses(system: System, state: Sequence[Passage], level: float) -> Row:
    torques = [system.torque(i, at.entry, at.exit) for i, at in enumerate(state)]
    misses = [
        (torques[i] - line.ratio * torques[line.master]) / system.torque_scale
        if line.follows
        else system.speed_miss(i, state[i], level)
        for i, line in enumerate(system.lines)
    ]
    return [*misses, log(state[-1].exit / system.exit)]


def _near(a: Sequence[Passage], b: Sequence[Passage]) -> bool:
    """Whether two states are so near that slopes of one serve for the other."""
    return all(abs(x.exit / y.exit - 1.0) < 1e-3 for x, y in zip(a, b, strict=True))
