"""What is kept of a run: rows and pictures, thinned so that they do not grow with its length."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from wraparc.arrays import Array
from wraparc.motion.march import March
from wraparc.motion.result import EXTREMES, DrumHistory, Extremes, Outcome, Peak, RunResult
from wraparc.motion.station import Station

#: Rows and pictures that are kept at most; when there are more, every other one is dropped.
_ROWS, _PICTURES, _ACROSS = 4000, 240, 61
#: Part of the time between two rows by which one may come early.
_EARLY = 1e-6

Sink = Callable[[Sequence[float]], None]


def row_names(station: Station) -> list[str]:
    """Names of the numbers of a row, with their units."""
    names = ["time [s]", "belt speed [m/s]"]
    for name in station.names:
        names += [f"{name}: {what}" for what in _COLUMNS]
    return names


_COLUMNS = (
    "entry tension [N]",
    "exit tension [N]",
    "pulley speed [rad/s]",
    "torque [N m]",
    "exit creep [m]",
    "exit slip [m]",
    "peak shear stress [Pa]",
)


@dataclass
class Recorder:
    """Keeps rows and pictures; thins them out when there are too many."""

    march: March
    every: float
    sink: Sink | None
    rows: list[list[float]] = field(default_factory=list)
    pictures: list[tuple[float, list[Array], list[Array]]] = field(default_factory=list)
    work: list[float] = field(default_factory=list)
    count: int = 0

    def __post_init__(self) -> None:
        self.between = self.every
        self.kept, self.next_picture = -math.inf, 0.0
        self.between_pictures = max(self.march.event.duration / _PICTURES, self.march.h, self.every)
        self.streamed, self.told = -math.inf, 0
        n, train = self.march.n, self.march.station.train
        self.limits = [train.creep_limit_of(pulley) for pulley in train.pulleys]
        self.most, self.when = [-math.inf] * (n * len(EXTREMES)), [0.0] * (n * len(EXTREMES))
        self.over, self.before, self.creeps = [0.0] * n, self.march.t, [0.0] * n
        self.work = [0.0] * n
        self.power = [0.0] * n
        self.across = np.linspace(0.0, 1.0, _ACROSS)
        self.travel0 = [d.arc.travel for d in self.march.drums]
        for d in self.march.drums:
            d.arc.work = 0.0
        self.march.watch = self._watch
        self._watch()
        self.take(False)
        self.count = 0

    def stream(self) -> None:
        """Give a row to the sink."""
        if self.sink is not None:
            self.sink(self._row())
            self.told += 1
        self.streamed = self.march.t

    def take(self, last: bool) -> None:
        """Take what the march has come to."""
        m = self.march
        self.count += 1
        if _due(m.t, self.kept, self.between) or last:
            self.rows.append(self._row())
            self.kept = m.t
            if len(self.rows) > _ROWS and not last:
                self.rows = self.rows[::2]
                self.between *= 2.0
        if _due(m.t, self.streamed, self.every) or last:
            self.stream()
        if m.t >= self.next_picture - 1e-9 or last:
            self._picture()

    def _watch(self) -> None:
        """Keep the largest of every step, whatever rows are kept."""
        m, size = self.march, len(EXTREMES)
        for i, d in enumerate(m.drums):
            felt = d.arc.felt
            creep = abs(felt.exit_slip + d.arc.shape.shear * felt.exit_stress)
            entry, exit_ = m.T[i] + m.run_rises[i], m.T[i + 1]
            # in the order of EXTREMES; of least tensions the largest negative
            friction = (creep, abs(felt.most_slip), felt.slip_speed, abs(felt.most_stress))
            found = (*friction, abs(entry - exit_), abs(d.torque), entry, exit_, -entry, -exit_)
            for j, value in enumerate(found, start=size * i):
                if value > self.most[j]:
                    self.most[j], self.when[j] = value, m.t
            self.over[i] += (m.t - self.before) * _part_over(self.creeps[i], creep, self.limits[i])
            self.creeps[i] = creep
            power = d.moment * d.omega
            self.work[i] += 0.5 * (m.t - self.before) * (self.power[i] + power)
            self.power[i] = power
        self.before = m.t

    def _row(self) -> list[float]:
        m = self.march
        row = [m.t, m.v if m.station.conveyor_mass is not None else m.speed]
        for i, d in enumerate(m.drums):
            felt = d.arc.felt
            creep = felt.exit_slip + d.arc.shape.shear * felt.exit_stress
            entry = m.T[i] + m.run_rises[i]
            row += [entry, m.T[i + 1], d.omega, d.torque, creep, felt.exit_slip, felt.most_stress]
        return row

    def _extremes(self, i: int) -> Extremes:
        size = len(EXTREMES)
        peaks = zip(self.most[size * i : size * (i + 1)], self.when[size * i :], strict=False)
        return Extremes(*(Peak(abs(v), t) for v, t in peaks))

    def _picture(self) -> None:
        m, creep, shear = self.march, [], []
        for d in m.drums:
            place = d.arc.place() / d.arc.shape.length
            creep.append(np.interp(self.across, place, d.arc.creep()))
            shear.append(np.interp(self.across, place, d.arc.stress()))
        self.pictures.append((m.t, creep, shear))
        self.next_picture = m.t + self.between_pictures
        if len(self.pictures) > 2 * _PICTURES:
            self.pictures = self.pictures[::2]
            self.between_pictures *= 2.0

    def result(self, outcome: Outcome, reason: str, steps: int) -> RunResult:
        """Return everything, frozen."""
        m = self.march
        table = np.array(self.rows)
        width = len(_COLUMNS)
        columns = [table[:, 2 + width * i : 2 + width * (i + 1)] for i in range(m.n)]
        pulls = [c[:, 0] - c[:, 1] for c in columns]
        total = np.sum(pulls, axis=0)
        small = np.abs(total) < 1e-3 * abs(m.pull)
        drums = []
        for i, c in enumerate(columns):
            share = np.where(small, np.nan, pulls[i] / np.where(small, 1.0, total))
            entry, exit_, speed, torque, creep, slip, shear = (
                _frozen(c[:, j]) for j in range(width)
            )
            drums.append(
                DrumHistory(
                    name=m.station.names[i],
                    entry_tension=entry,
                    exit_tension=exit_,
                    speed=speed,
                    torque=torque,
                    share=_frozen(share),
                    exit_creep=creep,
                    exit_slip=slip,
                    peak_shear=shear,
                    place=_frozen(self.across),
                    creep=_frozen(np.array([p[1][i] for p in self.pictures])),
                    shear=_frozen(np.array([p[2][i] for p in self.pictures])),
                    extremes=self._extremes(i),
                    over_limit=self.over[i],
                    friction_energy=m.drums[i].arc.work,
                    drum_work=self.work[i],
                )
            )
        return RunResult(
            station=m.station,
            event=m.event,
            outcome=outcome,
            reason=reason,
            time=_frozen(table[:, 0]),
            drums=tuple(drums),
            belt_speed=_frozen(table[:, 1]),
            picture_time=_frozen(np.array([p[0] for p in self.pictures])),
            step=m.h,
            steps=steps,
            belt_error=self._belt_error(),
            build_distance=self._build_distance(table, columns),
        )

    def _belt_error(self) -> float:
        """Unstretched belt won or lost, over the stretch of the belt in the train."""
        m = self.march
        if m.station.conveyor_mass is None or m.station.take_up != "fixed":
            return math.nan
        return abs(m.belt() - m.belt_before) / abs(m.belt_before)

    def _build_distance(self, table: Array, columns: list[Array]) -> float:
        if not self.march.event.from_rest or len(table) < 3:
            return math.nan
        travel = np.concatenate(
            [[0.0], np.cumsum(0.5 * np.diff(table[:, 0]) * (table[1:, 1] + table[:-1, 1]))]
        )
        worst = 0.0
        for c in columns:
            creep = c[:, 4]
            off = np.nonzero(np.abs(creep - creep[-1]) > 0.05 * abs(creep[-1]))[0]
            worst = max(worst, float(travel[min(off[-1] + 1, len(travel) - 1)]) if len(off) else 0)
        return worst


def _due(t: float, before: float, every: float) -> bool:
    """Whether a multiple of `every` has been passed since something was done before."""
    return before < 0.0 or math.floor(t / every + _EARLY) > math.floor(before / every + _EARLY)


def _part_over(before: float, after: float, limit: float) -> float:
    """Part of a step in which something is over a limit, that goes straight from end to end."""
    low, high = min(before, after), max(before, after)
    if high <= limit:
        return 0.0
    return 1.0 if low >= limit else (high - limit) / (high - low)


def _frozen(values: Array) -> Array:
    values = np.ascontiguousarray(values)
    values.setflags(write=False)
    return values
