"""Columns of trains to their rows: read, checked, and what divides the load of each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arc import Distributed
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch.columns import (
    Column,
    columns_of,
    length_problems,
    read_column,
    refused,
    row_problem,
)
from wraparc.batch.laws import LawBank
from wraparc.drive import Limit
from wraparc.errors import Problem, input_error
from wraparc.train.columns import (
    MAY_BE_MISSING,
    OF_DRUM,
    OF_TRAIN,
    TENSION,
    key_of,
    of_motor,
    refuse_names,
)
from wraparc.train.motor_rows import MotorRows
from wraparc.train.motors import Motor, TorqueFollower
from wraparc.train.result import CaseResult, TrainResult
from wraparc.train.rows import Followers, TrainRows
from wraparc.train.solve import solve_case
from wraparc.train.train import Motors, Pulls, Shares, Speeds, Train
from wraparc.train.walk import held
from wraparc.units import display

_SHARE_SUM = 1e-6
_QUICK = Distributed(capacities=False)


@dataclass(frozen=True, eq=False)
class Read:
    """Columns that have been read.

    Attributes
    ----------
    rows
        The trains; those that cannot be have the numbers of the train they come from.
    good
        Which of them can be, shape (n,).
    problems
        What is wrong, with all rows.
    start
        Where to look for the balance first.
    """

    rows: TrainRows
    good: Flags
    problems: tuple[Problem, ...]
    start: tuple[float, ...]


def read_rows(train: Train, columns: Mapping[str, ArrayLike], case: str = "") -> Read:
    """Return the trains of some columns, see `wraparc.train.solve_train_batch`.

    Raises
    ------
    InputError
        With every column that there is not, or that does not go with the others.
    """
    given = columns_of(columns)
    found = train.case(case)
    alone = replace(found, condition="")  # the laggings are in it
    base = replace(train.in_case(found), cases=(alone,))
    base = replace(base, nominal_diameters=base.nominal)
    kinds = {name: key for name in given if (key := key_of(name, base))}
    refuse_names(given, kinds, base)
    asked = {key for _, key in kinds.values()}
    solved = None
    given_pulls = isinstance(alone.division, Shares | Pulls)
    if not given_pulls or (asked & {"speed_trim", "wear"} and "share" not in asked):
        solved = solve_case(base, alone, _QUICK)
    base, start = _division(base, asked, solved)
    with np.errstate(all="ignore"):  # of rows that cannot be
        return _Reader(base, given, kinds).read(start)


def _division(
    train: Train, asked: set[str], solved: CaseResult | None
) -> tuple[Train, tuple[float, ...]]:
    """Return the train with what divides the load of its rows, and shares to start from.

    Given shares stay or become given; where one drum wears or is trimmed, the drums keep the speeds
    at which the load divides as given.
    """
    case, count = train.cases[0], len(train.pulleys)
    total = case.effective_tension
    start = (1.0 / count,) * count
    if isinstance(case.division, Shares):
        start = case.division.fractions
    elif isinstance(case.division, Pulls) and total != 0.0:
        start = tuple(pull / total for pull in case.division.effective_tensions)
    if solved is None and "share" not in asked:
        return train, start
    if solved is not None and solved.status.solved and total != 0.0:
        start = solved.shares
    if "share" in asked:
        return replace(train, cases=(replace(case, division=Shares(start)),)), start
    if solved is not None and isinstance(case.division, Shares | Pulls):
        if not solved.status.solved:
            message = f"has no solution that the drums could keep their speeds of: {solved.reason}"
            raise input_error(key=f"load case {case.name}", message=message)
        train = held(TrainResult(train, (solved,)))[0]
    return train, start


class _Reader:
    """Columns being read."""

    def __init__(
        self, train: Train, given: Mapping[str, Any], kinds: Mapping[str, tuple[int, str]]
    ) -> None:
        self.train, self.case = train, train.cases[0]
        self.names = [p.name for p in train.pulleys]
        self.problems: list[Problem] = []
        read = {name: read_column(raw) for name, raw in given.items()}
        self.n, problems = length_problems({k: v.value.shape for k, v in read.items()})
        self.problems += problems
        self.good = np.ones(self.n, dtype=bool)
        self.columns = {kinds[name]: self._column(name, kinds[name], c) for name, c in read.items()}

    def _limit(self, drum: int, key: str) -> Limit:
        if drum < 0:
            return OF_TRAIN[key]
        if key in OF_DRUM:
            return OF_DRUM[key]
        assert isinstance(self.case.division, Motors)  # noqa: S101 - else there is no such column
        return self.case.division.motors[drum].LIMITS[key]

    def _column(self, name: str, kind: tuple[int, str], column: Column) -> Array:
        limit, value = self._limit(*kind), column.value
        good = (value >= limit.least) & (value <= limit.most)
        good &= (value > limit.least) | (not limit.open)
        good &= np.isfinite(value) | ((value > 0.0) & limit.rigid)
        missing = kind[1] in MAY_BE_MISSING
        if missing:
            good |= np.isnan(value)
        self.problems += refused(
            name, column, np.asarray(good), f"must be {limit}", dimension=limit.dimension,
            may_be_missing=missing,
        )  # fmt: skip
        if value.shape not in ((), (1,), (self.n,)):
            return np.full(self.n, np.nan)  # its length is a problem already
        self.good &= np.broadcast_to(good, (self.n,))
        return np.broadcast_to(value, (self.n,)).copy()

    def read(self, start: tuple[float, ...]) -> Read:
        drums = {key: self._of_drums(key) for key in OF_DRUM if key not in ("share", "speed_trim")}
        wear, thickness = drums.pop("wear"), drums["lagging_thickness"]
        self._say("wear", wear > thickness, "must be at most the lagging thickness", wear)
        drums["lagging_thickness"] = np.maximum(thickness - wear, 0.0)
        drums["diameter"] = drums["diameter"] - 2.0 * wear
        for i, pulley in enumerate(self.train.pulleys):
            if (i, "compression_modulus") not in self.columns:  # it follows the thickness
                left = drums["lagging_thickness"][:, i]
                drums["compression_modulus"][:, i] = pulley.lagging.compression_modulus_at(left)
        whole = self._whole(drums["run"][:, 1:].sum(axis=1))
        rows = TrainRows(
            train=self.train,
            whole=whole,
            drums=drums,
            bank=LawBank.of([p.lagging.law for p in self.train.pulleys]),
        )
        self._say_flying(rows)
        rows = self._divided(rows)
        bad = np.flatnonzero(~self.good)
        if len(bad):
            rows = self._mended(rows, bad)
        return Read(rows, self.good, tuple(self.problems), start)

    def _mended(self, rows: TrainRows, bad: Integers) -> TrainRows:
        """Return the rows, the bad ones those of the train itself."""
        base = _Reader(self.train, {}, {}).read(()).rows

        def put(value: Array | None, of_base: Array | None) -> Array | None:
            if value is not None and of_base is not None:
                value[bad] = of_base[0]
            return value

        for name, value in rows.whole.items():
            put(value, base.whole[name])
        for name, value in rows.drums.items():
            put(value, base.drums[name])
        put(rows.pulls, base.pulls)
        put(rows.speeds, base.speeds)
        for one, other in zip(rows.motors, base.motors, strict=True):
            if isinstance(one, MotorRows):
                for name, value in one.own.items():
                    value[bad] = getattr(one.motor, name)
            elif isinstance(other, Followers):
                put(one.ratio, other.ratio)
        return rows

    def _of_drums(self, key: str) -> Array:
        """A column of every drum, shape (n, drums)."""
        made = np.tile(np.array([self._default(i, key) for i in range(len(self.names))]),
                       (self.n, 1))  # fmt: skip
        for i in range(len(self.names)):
            if (i, key) in self.columns:
                made[:, i] = self.columns[i, key]
        return made

    def _default(self, i: int, key: str) -> float:
        pulley = self.train.pulleys[i]
        if key in ("friction_factor", "slip_factor"):
            return 1.0
        if key == "wear":
            return 0.0
        if key == "run":
            return self.case.run(i - 1) if i else 0.0
        if key == "nominal_diameter":
            return self.train.nominal[i]
        if key == "creep_limit":
            return self.train.creep_limit_of(pulley)
        if key in ("diameter", "wrap_angle", "overrun"):
            value = getattr(pulley, key)
        else:
            attribute = "thickness" if key == "lagging_thickness" else key
            value = getattr(pulley.lagging, attribute)
        return np.nan if value is None else float(value)

    def _whole(self, runs: Array) -> dict[str, Array]:
        belt, columns = self.train.belt, self.columns
        default = {
            "belt_width": belt.width,
            "belt_modulus": belt.modulus,
            "belt_speed": np.nan if belt.speed is None else belt.speed,
            "entry_tension": self.case.entry_tension,
            "exit_tension": self.case.exit_tension,
        }
        whole = {k: columns.get((-1, k), np.full(self.n, v)) for k, v in default.items()}
        pull = columns.get((-1, "effective_tension"))
        if pull is not None and (-1, "entry_tension") in columns:
            whole["exit_tension"] = whole["entry_tension"] - pull + runs
            self._say_tension("exit_tension", whole["exit_tension"])
        elif pull is not None:  # the tension behind the drives is held
            whole["entry_tension"] = whole["exit_tension"] + pull - runs
            self._say_tension("entry_tension", whole["entry_tension"])
        return whole

    def _say_tension(self, name: str, value: Array) -> None:
        """Say where a pull leaves a tension that no belt has."""
        bad = self.good & ~((value > 0.0) & (value <= TENSION.most))
        rows = np.flatnonzero(bad)
        if len(rows):
            message = f"makes the {name.replace('_', ' ')} so much, and it must be {TENSION}"
            told = display(float(value[rows[0]]), "force")
            self.problems.append(row_problem("effective_tension", rows.tolist(), told, message))
        self.good &= ~bad

    def _say_flying(self, rows: TrainRows) -> None:
        """Say where the belt is so fast for its mass that it presses on no pulley."""
        whole, lift = rows.whole, rows.lift
        least = np.minimum(whole["entry_tension"], whole["exit_tension"])
        bad = np.flatnonzero(self.good & (least <= lift))
        if len(bad):
            name = "belt_speed" if (-1, "belt_speed") in self.columns else "exit_tension"
            told = display(float(whole[name][bad[0]]), OF_TRAIN[name].dimension)
            flung, there = (display(float(value[bad[0]]), "force") for value in (lift, least))
            message = f"the belt presses on no pulley: m v^2 = {flung}, its minimum tension {there}"
            self.problems.append(row_problem(name, bad.tolist(), told, message))
            self.good[bad] = False

    def _say(self, key: str, bad: Flags, message: str, value: Array) -> None:
        """Say what is wrong with a column of drums, and mark its rows."""
        dimension = OF_DRUM[key].dimension
        for i, name in enumerate(self.names):
            rows = np.flatnonzero(bad[:, i] & self.good)
            if len(rows):
                told = display(float(value[rows[0], i]), dimension)
                problem = row_problem(f"{name}.{key}", rows.tolist(), told, message)
                self.problems.append(problem)
        self.good &= ~bad.any(axis=1)

    def _divided(self, rows: TrainRows) -> TrainRows:
        """Return the rows with what divides their load."""
        division = self.case.division
        if isinstance(division, Motors):
            return replace(rows, motors=tuple(self._motor(i, m) for i, m in
                                              enumerate(division.motors)))  # fmt: skip
        if isinstance(division, Speeds):
            return replace(rows, speeds=self._speeds(rows, division), absolute=division.absolute)
        if isinstance(division, Shares):
            fractions = self._fractions(division.fractions)
            pulls = fractions * rows.total[:, None]
        else:
            base = self.case.effective_tension
            scale = rows.total / base if base != 0.0 else np.ones(self.n)
            pulls = np.array(division.effective_tensions) * scale[:, None]
        leaving = rows.whole["entry_tension"][:, None] - np.cumsum(pulls, axis=1)
        leaving += np.cumsum(rows.drums["run"], axis=1)
        rows_ = np.flatnonzero(self.good & (leaving[:, :-1] <= rows.lift[:, None]).any(axis=1))
        if len(rows_):
            least = display(float(leaving[rows_[0]].min()), "force")
            message = "the pulls leave no tension in the belt, and a belt cannot push"
            self.problems.append(row_problem("share", rows_.tolist(), least, message))
            self.good[rows_] = False
        return replace(rows, pulls=pulls)

    def _fractions(self, base: tuple[float, ...]) -> Array:
        """Shares of the rows: the drums without a column divide the rest as they did."""
        fractions = np.tile(np.array(base), (self.n, 1))
        own = [i for i in range(len(base)) if (i, "share") in self.columns]
        others = [i for i in range(len(base)) if i not in own]
        if not own:
            return fractions
        for i in own:
            fractions[:, i] = self.columns[i, "share"]
        rest, parts = 1.0 - fractions[:, own].sum(axis=1), fractions[:, others]
        if others and sum(base[i] for i in others) != 0.0:
            fractions[:, others] = parts * (rest / parts.sum(axis=1))[:, None]
        elif others:
            fractions[:, others] = (rest / len(others))[:, None]
        else:
            bad = np.repeat((np.abs(rest) > _SHARE_SUM)[:, None], len(base), axis=1)
            self._say("share", bad, "the shares of all drums must sum to 1", fractions)
        return fractions

    def _speeds(self, rows: TrainRows, division: Speeds) -> Array:
        """Speeds of the drums: trims hold where their nominal diameters are given."""
        omega, base = np.array(division.rotation_speeds), np.array(self.train.nominal)
        nominal, first = rows.drums["nominal_diameter"], omega[0] * base[0]
        speeds = np.tile(omega, (self.n, 1))
        if not division.absolute:
            speeds = speeds * (base / nominal)
        for i in range(len(omega)):
            if (i, "speed_trim") in self.columns:
                speeds[:, i] = first * self.columns[i, "speed_trim"] / nominal[:, i]
        return speeds

    def _motor(self, i: int, motor: Motor | TorqueFollower) -> MotorRows | Followers:
        if isinstance(motor, TorqueFollower):
            ratio = self.columns.get((i, "ratio"), np.full(self.n, motor.ratio))
            return Followers(master=self.names.index(motor.master), ratio=ratio)
        own = {k: self.columns[i, k] for k in of_motor(motor) if (i, k) in self.columns}
        made = MotorRows(motor, own)
        if {"rated_speed", "synchronous_speed"} & own.keys() and hasattr(motor, "rated_slip"):
            rated, top = (
                np.broadcast_to(made.of(k), (self.n,)) for k in ("rated_speed", "synchronous_speed")
            )
            rows = np.flatnonzero(self.good & ~((0.8 * top <= rated) & (rated < top)))
            if len(rows):
                told = display(float(rated[rows[0]]), "rotation_speed")
                message = "must be below the synchronous speed by at most 20 %"
                name = f"{self.names[i]}.rated_speed"
                self.problems.append(row_problem(name, rows.tolist(), told, message))
                self.good[rows] = False
        return made
