"""The station marched in time: drums, runs, take-up and conveyor around the moving arcs.

See :mod:`wraparc.motion.equations` for what holds at the end of a step.
"""

from __future__ import annotations

import math

from wraparc.errors import input_error
from wraparc.motion.at_rest import rest
from wraparc.motion.drum_state import DrumState
from wraparc.motion.equations import BESIDE, Trial, guessed, solved
from wraparc.motion.event import Event, OnBelt
from wraparc.motion.held import settle
from wraparc.motion.station import Station
from wraparc.motion.station_state import HaltError, StationState

#: Part of the wrap by which a drum may turn back.
_BACK = 0.05
#: Part of a step that ends where something begins or ends, unless it does so nearer to its own.
_NEAR = 0.02
#: A step that fails is halved so often.
_HALVINGS = 6
#: Pieces of lagging in a step, at most, while the joint of old and fresh contact is nearer than
#: this part of a wrap to the exit nip.
_PIECES, _AROUND = 0.25, 0.03
#: Part of the slack-side tension, and of speed, by which a step longer than the finest may end off
#: its guess.
_STRAYS = 1e-4


class March(StationState):
    """A station on the march; `step` takes it one step further.

    Parameters
    ----------
    station, event
        What moves, and what happens.
    step
        [s]; None for a length of its own, in parts where much happens.
    points
        Pieces on the shortest wrap.
    every
        Time between the rows that are asked for, if not every step [s]: no step is longer.
    """

    def __init__(
        self,
        station: Station,
        event: Event,
        step: float | None = None,
        points: int = 100,
        every: float | None = None,
    ) -> None:
        super().__init__(station, event, step, points, every)
        if event.from_rest:
            rest(self)
        else:
            self._run()
        self._place_riders()
        self.belt_before = self.belt()

    def _run(self) -> None:
        """Begin in the steady state."""
        members = self.steady.members
        entries = [m.arc.entry_tension for m in members]
        exits = [m.arc.exit_tension for m in members]
        try:
            settle(self.wraps, entries, exits, lengths=5.0)
        except ArithmeticError as error:
            message = "its steady state could not be reached by marching"
            remedy = "Give more points, or begin at rest."
            key = f"pulley.{self.names[error.args[0]]}"
            raise input_error(key=key, message=message, remedy=remedy) from None
        for d, pair in zip(self.drums, zip(entries, exits, strict=True), strict=True):
            d.omega, d.level = d.duty.speed, 1.0
            d.moment = d.torque = d.moment_of(*pair, 0.0, 0.0)[0]
            d.turning.run(1.0, d.omega, d.torque)
        self.v = self.steady.belt_speed / (1.0 + self.T[0] * self.stretch)

    def _place_riders(self) -> None:
        """Where on the travel of every drum the things that ride on the belt come in."""
        for rider in self.event.of(OnBelt):
            if not isinstance(rider, OnBelt):
                continue
            ahead = self._travel_by(rider.at)
            for d in self.drums:
                if d is not self.drums[0]:
                    ahead += d.run
                d.riders.append((rider, d.arc.travel / d.share + ahead))
                ahead += d.arc.shape.length / d.share

    def _travel_by(self, at: float) -> float:
        """Travel of the belt by a time, as its set speed goes [m]."""
        count = max(int(at / 0.01), 1)
        levels = [self.event.level(at * (j + 0.5) / count) for j in range(count)]
        return self.speed * at * sum(levels) / count

    # --- one step ---

    def step(self, h: float | None = None) -> None:
        """Take one step, in parts where it is hard or, if none was asked for, much happens.

        Raises
        ------
        HaltError
            If the run cannot go on: a slack belt, a drive that breaks away, a drum that turns back.
        """
        h = h or self.h
        if not self.divides:
            self._part(h, _HALVINGS)
            return
        near = _NEAR * h
        cuts = [t for t in self.event.instants if self.t + near < t < self.t + h - near]
        for end in (*cuts, self.t + h):
            ahead = end - self.t
            parts = max(self._parts(ahead), math.ceil(0.5 * ahead / self.went - _NEAR))
            for _ in range(parts):
                self._part(ahead / parts, _HALVINGS)

    def _parts(self, h: float) -> int:
        """In how many parts to take a step: creep jumps where old and fresh contact part."""
        pieces = []
        for d in self.drums:
            ahead = max(d.omega, d.guessed(h, self.onward(h))) * d.radius * d.share * h
            left = d.arc.joint + d.arc.shape.length - d.arc.travel
            if -_AROUND * d.arc.shape.length < left < ahead + _AROUND * d.arc.shape.length:
                pieces.append(ahead / d.arc.spacing)
        return max(math.ceil(max(pieces, default=0.0) / _PIECES), 1)

    def _part(self, h: float, halvings: int) -> None:
        trims = [d.trimming.state() if d.trimming else None for d in self.drums]
        locks = [d.locked for d in self.drums]
        try:
            trial = self._tried(h)
            good = not self.divides or h <= self.finest or self._as_guessed(trial)
        except HaltError:
            if not halvings:
                raise
            good = False
        if not good:
            self.wraps.undo()
            for d, trim, lock in zip(self.drums, trims, locks, strict=True):
                d.locked = lock
                if d.trimming is not None and trim is not None:
                    d.trimming.back(trim)
            self._part(0.5 * h, halvings - 1)
            self._part(0.5 * h, halvings - 1)
            return
        self._accept(trial)
        self.went = h
        self.watch()

    def _as_guessed(self, trial: Trial) -> bool:
        """Whether tensions and speeds went on nearly as they went in the two steps before."""
        guess = guessed(self, trial.h)
        off = [abs(a - b) / self.least for a, b in zip(trial.tensions, guess.tensions, strict=True)]
        off += [
            abs(a - b) / d.duty.speed
            for a, b, d in zip(trial.omega, guess.omega, self.drums, strict=True)
        ]
        return max(off) < _STRAYS

    def _tried(self, h: float) -> Trial:
        """Solve for the end of a step; drums that would turn back against a stop stand."""
        self._command(h)
        for d in self.drums:
            if d.locked and self._released(d):
                d.locked = False
        for _ in range(4):
            trial = solved(self, h)
            stopped = [
                d
                for d, w in zip(self.drums, trial.omega, strict=True)
                if w < 0.0 and not d.locked and (d.backstop or d.braked)
            ]
            if not stopped:
                break
            for d in stopped:
                d.locked = True
            self.wraps.undo()
        return trial

    def _command(self, h: float) -> None:
        """Tell the drives what is asked of them at the end of the step."""
        t1 = self.t + h
        before = t1 - BESIDE * h
        level = self.event.level(before)
        failed = any(before >= f.at for f in self.failures)
        braking = any(f.brakes and before >= f.at for f in self.failures)
        for d in self.drums:
            own = level
            if d.trimming is not None:
                total = math.fsum(o.moment for o in self.drums)
                share = d.moment / total if abs(total) > 1e-9 else d.trimming.goal
                own = level * (1.0 + d.trimming.next(h, share))
            d.turning.fill = self.event.fill(before)
            d.command(h, t1, own, not failed, braking)

    def _released(self, d: DrumState) -> bool:
        """Whether a drum that stands is turned by its motor."""
        if d.braked:
            return False
        if d.held:
            return d.level > 0.0
        lead = self.drums[d.master].torque if d.master >= 0 else 0.0
        return d.driven(0.0, lead)[0] > d.moment

    def _accept(self, trial: Trial) -> None:
        """Take a step for good."""
        h, after, torques = trial.h, trial.tensions, [0.0] * self.n
        for i in self.order:
            d, w1 = self.drums[i], trial.omega[i]
            entry = after[i] + self.run_rises[i]
            moment = d.moment_of(entry, after[i + 1], *d.rises(trial.travels[i]))[0]
            lead = torques[d.master] if d.master >= 0 else 0.0
            if d.locked:
                d.torque, own = moment, 0.0
            else:
                own = d.driven(w1, lead)[0]
                if d.held:
                    own = moment + d.inertia * (w1 - d.omega) / h
                d.torque = own
                d.turning.accept(w1, own - d.extra, lead)
            torques[i], d.moment = own, moment
            arc = d.arc
            d.slope_0, d.slope = d.slope, (trial.m[i] - arc.m) / h
            if arc.moves:
                self.wraps.at_nip(arc, *trial.surfaces[i])
                arc.rise, arc.give, arc.dry = trial.surfaces[i]
            d.turned_back = min(d.turned_back + trial.travels[i] - arc.travel, 0.0)
            d.rate_0, d.rate = d.rate, (w1 - d.omega) / h
            d.omega, d.angle = w1, trial.angles[i]
        self.wraps.finish(trial.m, after[1:])
        for d, name in zip(self.drums, self.names, strict=True):
            if d.turned_back < -_BACK * d.arc.shape.length:
                raise HaltError("turns back", name)
        self.rates_0, self.h_0, self.h_before = self.rates, self.h_before, h
        self.rates = [(a - b) / h for a, b in zip(after, self.T, strict=True)]
        self.v_rate_0, self.v_rate = self.v_rate, (trial.v - self.v) / h
        self.T, self.v, self.t = list(after), trial.v, self.t + h
        if self.slackens(self.T):
            raise self.goes_slack(self.T)
