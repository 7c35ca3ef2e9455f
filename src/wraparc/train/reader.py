"""The ``[train]`` table and those of its load cases: tensions, and what divides the load."""

import math
from collections.abc import Sequence
from dataclasses import replace

from wraparc.drive import DESIGN, Belt, Pulley, TakeUp
from wraparc.drive.load_case import UNCERTAIN_OF_CASE
from wraparc.drive.tension_rules import (
    EFFECTIVE,
    BehindTakeUp,
    LoadGiven,
    NipTensions,
    RunsGain,
    behind_take_up,
    ends_of,
    families,
)
from wraparc.errors import InputError, name_remedy
from wraparc.files.conditions import condition_name
from wraparc.files.tensions import ENTRY, EXIT, NO_RUNS, Given, complete, resolve
from wraparc.schema.problems import NOTHING, Report
from wraparc.schema.tables import Record
from wraparc.schema.uncertain import read_uncertainty
from wraparc.train.keys import EQUAL, MOTOR
from wraparc.train.motors import Motor, TorqueFollower
from wraparc.train.train import Division, Motors, Shares, Speeds, TrainCase
from wraparc.units import display

_MODES = ("share", "speeds", "motor")
_DIVIDE = 'Write share = ["50 %", "50 %"], speeds = "equal" or [train.motor.NAME].'
#: How far powers may miss the total pull that the tensions make.
_POWER_SUM = 5e-3


class Reader:
    """The ``[train]`` table and those of the load cases, with belt and pulleys at hand."""

    def __init__(
        self,
        record: Record,
        belt: Belt,
        pulleys: Sequence[Pulley],
        report: Report,
        take_up: TakeUp,
    ) -> None:
        self.belt, self.pulleys, self._report, self._take_up = belt, pulleys, report, take_up
        self._record = record
        self._train: Record = record["train"]
        self.nominal = tuple(p.diameter for p in pulleys)
        self.actual = self._with_actual_diameters()

    def _with_actual_diameters(self) -> tuple[Pulley, ...]:
        diameters = self._train.get("diameters")
        if diameters is None or not self._counted(self._train, "diameters"):
            return tuple(self.pulleys)
        return tuple(
            replace(pulley, diameter=d) for pulley, d in zip(self.pulleys, diameters, strict=True)
        )

    def _counted(self, record: Record, key: str) -> bool:
        """Whether an array has one value for each pulley; reports it if not."""
        if len(record[key]) == len(self.pulleys):
            return True
        message = f"must have one value for each of the {len(self.pulleys)} pulleys, in belt order"
        self._report.add((*record.place, key), message, value=record.raw[key])
        return False

    def cases(self) -> list[TrainCase]:
        """Return the load case of the ``[train]`` table itself, if it is whole, and the others."""
        train, speed = self._train, self.belt.speed
        tables = [c for c in self._record.get("load_case") or () if isinstance(c, Record)]
        built = []
        if not tables or complete([self._given(train, None)], speed) or self._powers(train):
            built.append(self._case(DESIGN, train, None))
        for table in tables:
            over = table.get("train")
            empty = Record({}, (*table.place, "train"), {})
            case = self._case(table["name"], train, over if over is not None else empty)
            built.append(
                case
                and replace(
                    case,
                    kind=table.get("kind", "running"),
                    condition=condition_name(table),
                    description=table.get("description", ""),
                )
            )
        return [case for case in built if case is not None]

    def _case(self, name: str, train: Record, over: Record | None) -> TrainCase | None:
        place = train.place if over is None else over.place
        runs = self._runs(train, over)
        division = self._division(train, over)
        given = self._given(train, over)
        pull = self._powers(train if over is None or "share" not in over else over)
        if pull and len(families(given.values)) < 2:
            given = replace(given, values=given.values._replace(effective_tension=pull))
        given = given.less_runs(sum(runs), self.belt.speed)
        given = self._held(given, train, over, runs, division)
        tensions = resolve([given], self.belt.speed, self._report).get(given.name)
        if division is None or tensions is None:
            return None
        total = tensions.effective + sum(runs)
        if pull and abs(total - pull) > _POWER_SUM * abs(pull):
            message = (
                f"the powers make {display(pull, 'force')}, the tensions {display(total, 'force')}"
            )
            self._report.add((*place, "share"), message, "Leave one of them out.")
            return None
        try:
            return TrainCase(
                name=name,
                entry_tension=tensions.entry,
                exit_tension=tensions.exit,
                division=division,
                runs=runs if any(runs) else (),
                uncertainty=self._uncertainty(train) | self._uncertainty(over),
            )
        except InputError as error:
            self._report.take(error, place)
            return None

    def _uncertainty(self, record: Record | None) -> dict[str, float]:
        return {} if record is None else read_uncertainty(record, UNCERTAIN_OF_CASE, self._report)

    def division(self) -> Division | None:
        """Return what divides the load of every load case, or None after reporting."""
        return self._division(self._train, None)

    def _given(self, train: Record, over: Record | None) -> Given:
        given = Given.of("train", train, None)
        if over is None:
            return given
        runs, fixed = NO_RUNS, self._take_up.fixed
        if fixed:
            runs = RunsGain(sum(self._runs(train, None)), sum(self._runs(train, over)))
        return given.overridden(over, fixed=fixed, speed=self.belt.speed, runs=runs)

    def _held(
        self,
        given: Given,
        train: Record,
        over: Record | None,
        runs: Sequence[float],
        division: Division | None,
    ) -> Given:
        """Return tensions of a load case that gives its pull alone, by a take-up between drives."""
        names, after = [p.name for p in self.pulleys], self._take_up.after
        if over is None or after not in names[:-1] or ENTRY in over or EXIT in over:
            return given
        if division is None or not any(key in over for key in (*EFFECTIVE, *_MODES, "run")):
            return given
        own, base = self._runs(train, None), self._division(train, None)
        if not isinstance(division, Shares) or not isinstance(base, Shares):
            message = "Te alone does not fix the tensions behind the take-up"
            self._report.add(over.place, message, "Give exit_tension too.")
            return given
        first = self._given(train, None).less_runs(sum(own), self.belt.speed)
        k = names.index(after) + 1
        ends = behind_take_up(
            self._ends(given),
            self._ends(first),
            BehindTakeUp(math.fsum(division.fractions[k:]), sum(runs[k - 1 :]), sum(runs)),
            BehindTakeUp(math.fsum(base.fractions[k:]), sum(own[k - 1 :]), sum(own)),
        )
        if ends is None:
            return given
        return replace(given, values=LoadGiven(ends.entry, ends.exit), inherited=())

    def _ends(self, given: Given) -> NipTensions:
        return ends_of(given.values, given.at(self.belt.speed))

    def _runs(self, train: Record, over: Record | None) -> tuple[float, ...]:
        table = dict(train.get("run", {}))
        places = dict.fromkeys(table, train.place)
        if over is not None:
            table |= over.get("run", {})
            places |= dict.fromkeys(over.get("run", {}), over.place)
        names = [p.name for p in self.pulleys]
        for name, place in places.items():
            if name not in names[1:]:
                first = name in names
                message = "the first pulley has no run before it" if first else "no such pulley"
                remedy = name_remedy(name, names[1:])
                self._report.add((*place, "run", name), message, remedy)
        return tuple(table.get(name, 0.0) for name in names[1:])

    def _division(self, train: Record, over: Record | None) -> Division | None:
        """Return what divides the load, or None after reporting."""
        record = train
        if over is not None and any(mode in over for mode in _MODES):
            record = over
        modes = [mode for mode in _MODES if mode in record]
        if len(modes) > 1:
            message = f"{' and '.join(modes)} each decide how the load divides"
            self._report.add(record.place, message, "Remove one of them.")
            return None
        if not modes:
            if "diameters" in train:
                return Speeds(tuple(1.0 / d for d in self.nominal))
            if len(self.pulleys) == 1:
                return Shares((1.0,))
            self._report.add(record.place, "nothing says how the load divides", _DIVIDE)
            return None
        if modes == ["motor"]:
            return self._motors(record["motor"], train)
        return self._shares(record) if modes == ["share"] else self._speeds(record)

    def _shares(self, record: Record) -> Division | None:
        if not self._counted(record, "share") or not self._one_kind(record, "share"):
            return None
        kind, values = record["share"][0][0], [value for _, value in record["share"]]
        total = math.fsum(values) if kind == "power" else 1.0
        if total == 0.0:
            message = "the powers sum to 0, so that there is nothing to share"
            self._report.add((*record.place, "share"), message, value=record.raw["share"])
            return None
        return Shares(tuple(value / total for value in values))

    def _powers(self, record: Record) -> float | None:
        """Return the total pull that powers in place of shares make [N], if they do."""
        values = record.get("share")
        if not values or NOTHING in values or values[0][0] != "power" or not self.belt.speed:
            return None
        return math.fsum(value for _, value in values) / self.belt.speed

    def _speeds(self, record: Record) -> Division | None:
        if record["speeds"] == EQUAL:
            return Speeds((1.0,) * len(self.pulleys))
        if not self._counted(record, "speeds") or not self._one_kind(record, "speeds"):
            return None
        kind, values = record["speeds"][0][0], [value for _, value in record["speeds"]]
        if kind == "rotation_speed":
            return Speeds(tuple(values), absolute=True)
        return Speeds(tuple(v / d for v, d in zip(values, self.nominal, strict=True)))

    def _one_kind(self, record: Record, key: str) -> bool:
        if len({kind for kind, _ in record[key]}) == 1:
            return True
        message = "must be all of one kind"
        self._report.add((*record.place, key), message, value=record.raw[key])
        return False

    def _motors(self, tables: dict[str, Record], train: Record) -> Division | None:
        names = [p.name for p in self.pulleys]
        for name in (name for name in tables if name not in names):
            place = (*train.place, "motor", name)
            self._report.add(place, "no such pulley", name_remedy(name, names))
        missing = [name for name in names if name not in tables]
        for name in missing:
            remedy = f'Write [train.motor.{name}] with kind = "{next(iter(MOTOR.tables))}".'
            self._report.add((*train.place, "motor", name), "missing", remedy)
        if missing or len(tables) != len(names):
            return None
        motors = [self._motor(tables[name]) for name in names]
        made = tuple(motor for motor in motors if motor is not None)
        return Motors(made) if len(made) == len(names) else None

    def _motor(self, record: Record) -> Motor | TorqueFollower | None:
        motor: Motor | TorqueFollower | None = MOTOR.built(record, self._report)
        return motor
