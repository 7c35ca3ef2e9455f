"""All equations of a train at once, by Newton's method, and how the shares answer to the speeds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isfinite, isnan, log, nan

from wraparc.arc.meet import Met
from wraparc.train.linear import Matrix, Row, solution
from wraparc.train.member import COARSE, FINE, Passage
from wraparc.train.system import System

#: Miss of a speed equation and of the logarithm of the last tension that counts as none.
TOLERANCE = 1e-14
#: Weight of a speed equation beside that of the last tension, for comparing misses only.
_SPEED_WEIGHT = 1e3
#: Longest step of a place: of itself, and of the wrap.
_OF_ITSELF, _OF_WRAP = 2.0, 0.02
_MOST, _HALVINGS = 30, 15  # steps
_NEAR = 1e-5  # size from which on a step helps at once, or not at all


@dataclass(frozen=True, eq=False)
class Linear:
    """The equations near a state: unknowns are the places and the level.

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


def linearized(system: System, passages: Sequence[Passage]) -> tuple[Linear, tuple[bool, ...]]:
    """Return the equations near a state, and whether each drive rises with its creep."""
    count = len(passages)
    matrix: Matrix = [[0.0] * (count + 1) for _ in range(count + 1)]
    pulls: Matrix = []
    torques: Matrix = []
    entry = [0.0] * (count + 1)  # slopes of the entry tension
    for i, at in enumerate(passages):
        member = system.members[i]
        leaving = [at.slopes.exit_by_entry * x for x in entry]
        leaving[i] += at.slopes.exit_by_place
        pull = [x - y for x, y in zip(entry, leaving, strict=True)]
        arm, lost = member.arm(at.entry), (at.entry - at.exit) * member.squeeze
        pulls.append(pull)
        torques.append([x * arm - lost * y for x, y in zip(pull, entry, strict=True)])
        if not system.lines[i].follows:
            by_entry, by_place = system.speed_slopes(i, at)
            matrix[i] = [by_entry * x for x in entry]
            matrix[i][i] += by_place
            matrix[i][count] -= 1.0
        entry = leaving
    for i, line in enumerate(system.lines):
        if line.follows:
            pairs = zip(torques[i], torques[line.master], strict=True)
            matrix[i] = [(x - line.ratio * y) / system.torque_scale for x, y in pairs]
    matrix[count] = [x / passages[-1].exit for x in entry]
    rising = tuple(m.rises(at) for m, at in zip(system.members, passages, strict=True))
    return Linear(matrix, pulls, tuple(line.follows for line in system.lines)), rising


def settle(
    system: System,
    passages: Sequence[Passage],
    level: float,
    tol: float = FINE,
    tolerance: float = TOLERANCE,
) -> Settled | None:
    """Meet all equations from a state nearby; None if that fails.

    Each step of the train is one of every arc, from the course that it had and on its mesh. The
    meshes are judged at the start where there are smooth arcs nearby, else at the end.

    Parameters
    ----------
    system
        The equations.
    passages, level
        The state to start from.
    tol
        Misfit of the arcs that is let stand [-].
    tolerance
        Largest miss of a speed equation [-].
    """
    starts = _starts(system, passages)
    if starts is None:
        return None
    places, arcs = [at.place for at in starts], [at.met for at in starts]
    enough, again = tolerance * _SPEED_WEIGHT, False
    # the end of a rest arc is a kink that moves: its mesh is known at the end alone
    smooth = not any(member.holds for member in system.members)
    meshed = tol == COARSE or (smooth and all(arc is not None for arc in arcs))
    at = _point(system, places, arcs, level, tol if meshed else COARSE)
    for _ in range(_MOST):
        linear, rising = linearized(system, at.state)
        new = _stepped(at, system, linear.matrix) if at.size > enough else None
        if new is not None:
            at, again = new, False
        elif not meshed:
            meshed = True
            at = _point(system, _places(at), _arcs(at), at.level, tol)
        elif at.size > enough and not again:  # what the arcs still lacked was more than the miss
            again = True
            at = _point(system, _places(at), _arcs(at), at.level, COARSE)
        else:  # no step is any better: rounding, or no solution
            done = at.size <= 1e3 * enough
            return Settled(at.state, at.level, linear, rising) if done else None
    return None


@dataclass(frozen=True, eq=False)
class _Point:
    """A point of the iteration."""

    level: float
    state: tuple[Passage, ...]
    misses: Row

    @property
    def size(self) -> float:
        """Largest miss, weighted; inf where something is not finite."""
        if not all(isfinite(miss) for miss in self.misses):
            return inf
        speeds = max(abs(miss) for miss in self.misses[:-1])
        return max(_SPEED_WEIGHT * speeds, abs(self.misses[-1]))


def _point(
    system: System, places: Sequence[float], arcs: Sequence[Met | None], level: float, tol: float
) -> _Point:
    entry, state = system.entry, []
    for member, place, near, run in zip(system.members, places, arcs, system.runs, strict=True):
        at = member.passage(max(entry, 1e-6 * system.entry), place, near, tol)
        state.append(at)
        entry = at.exit + run
    return _Point(level, tuple(state), _misses(system, state, level))


def _stepped(at: _Point, system: System, matrix: Matrix) -> _Point | None:
    """Take the step of the linear equations, shortened until it helps."""
    step = solution(matrix, [-miss for miss in at.misses])
    if step is None or not all(isfinite(change) for change in step):
        return None
    scale = 1.0
    for member, passage, change in zip(system.members, at.state, step[:-1], strict=True):
        most = _OF_ITSELF * abs(passage.place) + member.place_of(_OF_WRAP * member.length)
        scale = min(scale, most / max(abs(change), 1e-300))
    for _ in range(_HALVINGS if at.size > _NEAR else 2):
        places = [x + scale * d for x, d in zip(_places(at), step[:-1], strict=True)]
        new = _point(system, places, _arcs(at), at.level + scale * step[-1], COARSE)
        if new.size < at.size:
            return new
        scale *= 0.5
    return None


def _places(at: _Point) -> list[float]:
    return [passage.place for passage in at.state]


def _arcs(at: _Point) -> list[Met | None]:
    return [passage.met for passage in at.state]


def _starts(system: System, passages: Sequence[Passage]) -> list[Passage] | None:
    """Passages with their places; those known by their tensions only are solved for them."""
    starts = []
    for member, at in zip(system.members, passages, strict=True):
        known: Passage | None = at
        if isnan(at.place):
            known = member.between(at.entry, at.exit)
        if known is None:
            return None
        starts.append(known)
    return starts


def _misses(system: System, state: Sequence[Passage], level: float) -> Row:
    torques = [system.torque(i, at.entry, at.exit) for i, at in enumerate(state)]
    misses = [
        (torques[i] - line.ratio * torques[line.master]) / system.torque_scale
        if line.follows
        else system.speed_miss(i, state[i], level)
        for i, line in enumerate(system.lines)
    ]
    return [*misses, log(state[-1].exit / system.exit)]
