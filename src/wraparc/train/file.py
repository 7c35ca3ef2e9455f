"""Drive files of several drives on one belt to trains."""

import math
import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, cast

from wraparc.drive import DESIGN, Belt, Drive, Pulley
from wraparc.errors import InputError, Problem, nearest, placed, shown
from wraparc.files.conditions import asking, build_conditions, condition_name, in_each_condition
from wraparc.files.drive_build import Laggings, build_belt, build_criteria, build_pulley
from wraparc.files.drive_file import drive_from_document, overridden
from wraparc.files.tensions import KEYS, Given, complete, less_runs, resolve
from wraparc.schema.overrides import Overrides, load
from wraparc.schema.problems import NOTHING, Report, place_text
from wraparc.schema.source import Document, parse, read_tables
from wraparc.schema.tables import Record
from wraparc.train.keys import EQUAL, MOTOR, TRAIN_FILE
from wraparc.train.motors import Motor, TorqueFollower
from wraparc.train.train import Division, Motors, Shares, Speeds, Train, TrainCase
from wraparc.units import display

_MODES = ("share", "speeds", "motor")
_DIVIDE = (
    'Write share = ["50 %", "50 %"], speeds = "equal", or a [train.motor.NAME] for each pulley.'
)
#: How far powers may miss the total pull that the tensions make.
_POWER_SUM = 5e-3


def load_train(
    path: str | os.PathLike[str], *, overrides: Overrides = (), allow_paths: bool = True
) -> Train:
    """Return the train of a drive file.

    A file with a ``[train]`` table says how the load divides; without one the tensions of the
    pulleys say it.

    Parameters
    ----------
    path, overrides, allow_paths
        As for `load_drive`.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    read = load_drive_or_train(path, overrides=overrides, allow_paths=allow_paths)
    return read if isinstance(read, Train) else Train.of(read)


def load_drive_or_train(
    path: str | os.PathLike[str],
    *,
    overrides: Overrides = (),
    allow_paths: bool = True,
    conditions: Sequence[str] = (),
) -> Drive | Train:
    """Return what a drive file describes: a train if it has a ``[train]`` table.

    Parameters
    ----------
    path, overrides, allow_paths
        As for `load_drive`.
    conditions
        Conditions to solve it in, ``("dry", "wet")``, whatever the file says of them.
    """

    def read(document: Document, **more: Any) -> Drive | Train:
        if conditions:
            with placed("--conditions", str(more.get("file", ""))):
                document = asking(document, conditions)
        reader = train_from_document if "train" in document else drive_from_document
        return reader(document, **more)

    return load(path, read, overrides, TRAIN_FILE, allow_paths=allow_paths)


def load_drive(
    path: str | os.PathLike[str], *, overrides: Overrides = (), allow_paths: bool = True
) -> Drive:
    """Return the drive of a drive file, with the tensions of every pulley.

    A train comes with the tensions that its load divides into; where speeds or motors divide it,
    it is solved for them.

    Parameters
    ----------
    path
        The file, TOML or JSON.
    overrides
        Values put over those of the file, ``KEY=VALUE`` or by key path.
    allow_paths
        Whether a lagging may be named by the path of its file.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, any_drive_from_document, overrides, allow_paths=allow_paths)


def any_drive_from_document(document: Document, **more: Any) -> Drive:
    """Return the drive of a drive file that is already parsed, see `load_drive`."""
    whole = overridden(document, more.pop("overrides", ()), file=more.get("file", ""))
    if "train" in whole:
        from wraparc.train.as_drive import as_drive  # takes the solver, which few files need

        return as_drive(train_from_document(whole, **more))
    return drive_from_document(whole, **more)


def train_from_text(text: str, *, file: str = "", folder: str = "") -> Train:
    """Return the train of the text of a drive file; paths of lagging files are refused."""
    return train_from_document(parse(text, file), file=file, folder=folder)


def train_from_document(
    document: Document,
    *,
    file: str = "",
    folder: str = "",
    overrides: Overrides = (),
    allow_paths: bool = False,
) -> Train:
    """Return the train of a drive file that is already parsed; the document is not changed."""
    document = overridden(document, overrides, file=file)
    if "train" not in document:
        drive = drive_from_document(document, file=file, folder=folder, allow_paths=allow_paths)
        return Train.of(drive)
    record, report = read_tables(TRAIN_FILE, document, file)
    belt_record = record.get("belt")
    belt = build_belt(belt_record, report) if isinstance(belt_record, Record) else None
    own = record.get("lagging")
    laggings = Laggings(own if isinstance(own, dict) else {}, folder, allow_paths, report)
    records = [item for item in record.get("pulley") or () if isinstance(item, Record)]
    conditions = build_conditions(record, report)
    pulleys = [build_pulley(item, laggings, conditions, report) for item in records]
    _refuse_pulley_tensions(record, records, report)
    if "conveyor" in record:
        message = "gives the tensions of one drive, and those of a train stand in [train]"
        report.add(("conveyor",), message, "Leave one of them out.")
    criteria = build_criteria(record, report)
    report.raise_all()
    # nothing was reported, so nothing is None
    known = cast(Belt, belt), [cast(Pulley, p) for p in pulleys]
    reader = _Reader(record, *known, report, fixed=criteria.take_up.fixed)
    parts = {key: record[key] for key in ("title", "description", "creep_limit") if key in record}
    cases = reader.cases()
    report.raise_all()
    try:
        return Train(
            belt=reader.belt,
            pulleys=reader.actual,
            cases=in_each_condition(cases, conditions),
            criteria=criteria,
            nominal_diameters=reader.nominal if reader.actual != tuple(reader.pulleys) else (),
            **parts,
        )
    except InputError as error:
        told: dict[tuple[str, str], Problem] = {}  # once only what several cases have from [train]
        for problem in error.problems:
            told.setdefault((problem.message, problem.value), _placed(problem, cases, file))
        raise InputError(told.values()) from None


def _placed(problem: Problem, cases: Sequence[TrainCase], file: str) -> Problem:
    """Return a problem of a load case of the code where the file has it."""
    for case in cases:
        prefix = f"load_case.{case.name}."
        if problem.key.startswith(prefix):
            rest = problem.key.removeprefix(prefix)
            own = () if case.name == DESIGN else ("load_case", case.name)
            return replace(problem, key=f"{place_text((*own, 'train'))}.{rest}", file=file)
    return replace(problem, file=file)


def _refuse_pulley_tensions(record: Record, pulleys: Sequence[Record], report: Report) -> None:
    """Report tensions of single pulleys: in a train they follow."""
    message = "the tensions of single pulleys follow from [train]"
    for pulley in pulleys:
        for key in (key for key in KEYS if key in pulley):
            report.add((*pulley.place, key), message, "Leave it out.", pulley.raw[key])
    for case in record.get("load_case") or ():
        if isinstance(case, Record) and "pulley" in case:
            remedy = "Write a [load_case.train] table."
            report.add((*case.place, "pulley"), message, remedy)


class _Reader:
    """The ``[train]`` table and those of the load cases, with belt and pulleys at hand."""

    def __init__(
        self,
        record: Record,
        belt: Belt,
        pulleys: Sequence[Pulley],
        report: Report,
        *,
        fixed: bool = False,
    ) -> None:
        self.belt, self.pulleys, self._report, self._fixed = belt, pulleys, report, fixed
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
                    case, kind=table.get("kind", "running"), condition=condition_name(table)
                )
            )
        return [case for case in built if case is not None]

    def _case(self, name: str, train: Record, over: Record | None) -> TrainCase | None:
        place = train.place if over is None else over.place
        runs = self._runs(train, over)
        division = self._division(train, over)
        given = self._given(train, over)
        pull = self._powers(train if over is None or "share" not in over else over)
        if pull and len(given.families) < 2:
            given = replace(given, values={**given.values, "effective_tension": pull})
        given = less_runs(given, sum(runs), self.belt.speed)
        tensions = resolve([given], self.belt.speed, self._report).get(given.name)
        if division is None or tensions is None:
            return None
        total = tensions.effective + sum(runs)
        if pull and abs(total - pull) > _POWER_SUM * abs(pull):
            message = (
                f"the powers make a pull of {display(pull, 'force')} at the belt speed, and the "
                f"tensions one of {display(total, 'force')}"
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
            )
        except InputError as error:
            self._report.take(error, place)
            return None

    def _given(self, train: Record, over: Record | None) -> Given:
        given = Given.of("train", train, None)
        if over is None:
            return given
        runs = (0.0, 0.0)
        if self._fixed:
            runs = sum(self._runs(train, None)), sum(self._runs(train, over))
        return given.overridden(over, fixed=self._fixed, speed=self.belt.speed, runs=runs)

    def _runs(self, train: Record, over: Record | None) -> tuple[float, ...]:
        table = dict(train.get("run", {}))
        places = dict.fromkeys(table, train.place)
        if over is not None:
            table |= over.get("run", {})
            places |= dict.fromkeys(over.get("run", {}), over.place)
        names = [p.name for p in self.pulleys]
        for name, place in places.items():
            if name not in names[1:]:
                there = ", ".join(map(shown, names[1:]))
                message = (
                    "the first pulley has no run before it"
                    if name in names
                    else f"no such pulley; runs lead to {there}"
                )
                remedy = nearest(name, names[1:])
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
            self._report.add(record.place, message, "Keep one of them.")
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
            message = f"no such pulley; the pulleys are {', '.join(map(shown, names))}"
            self._report.add((*train.place, "motor", name), message, nearest(name, names))
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
