"""Values of fields of a drive file, by column, to arcs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from wraparc.arc.wrap_arc import of_belt
from wraparc.arrays import Array, Integers
from wraparc.batch import Setting
from wraparc.batch.arcs import COLUMNS, Arcs, compression_moduli
from wraparc.batch.laws import LawBank
from wraparc.checks.of_rows import Held, held_by
from wraparc.checks.of_train import MOMENTARY_LOAD, MOTOR_LOAD
from wraparc.drive import Drive, Lagging, Tensions, with_peaks
from wraparc.drive.belt_mass import masses_at
from wraparc.drive.pitch import centrifugal_force, pitch_offset, strain_ratio
from wraparc.drive.tension_rules import LoadGiven
from wraparc.errors import InputError
from wraparc.files.conditions import refuse_several
from wraparc.files.tensions import KEYS, Given, spread
from wraparc.friction import FrictionLaw
from wraparc.schema.overrides import Overrides
from wraparc.schema.problems import Place, Report, place_text
from wraparc.schema.source import Document
from wraparc.schema.tables import Record
from wraparc.study.fields import DRUM_KEYS, FRICTION_FACTOR, SLIP_FACTOR
from wraparc.study.fitted import DrawnFit
from wraparc.study.parameter_study import TRAIN_OUTPUTS, Rows
from wraparc.study.plan import Levels, Values
from wraparc.study.train_columns import Divided, TrainColumns
from wraparc.train import Motor, Motors
from wraparc.train.as_drive import with_speeds
from wraparc.train.file import any_drive_from_document, train_from_document
from wraparc.train.keys import TRAIN_FILE
from wraparc.train.turning import surface_sentence
from wraparc.units import DIMENSION_TEXT, Dimension

_MOST_KEPT = 4096  # drives built for fields that are no column
_OF_PULLEY = {
    "diameter": "diameter",
    "wrap_angle": "wrap_angle",
    "overrun": "overrun",
    "creep_limit": "creep_limit",
}
_OF_LAGGING = {
    "thickness": "lagging_thickness",
    "shear_modulus": "shear_modulus",
    "compression_modulus": "compression_modulus",
    "wear_coefficient": "wear_coefficient",
}
_OF_BELT = {"width": "belt_width", "modulus": "belt_modulus", "speed": "belt_speed"}
_TENSIONS = ("entry_tension", "exit_tension")


@dataclass(frozen=True)
class Field:
    """A field that a study varies.

    Attributes
    ----------
    name
        As the study calls it.
    place
        Its key path, tables by their names.
    dimension
        What it measures, or None for words.
    labels
        The words, in the order of their places.
    """

    name: str
    place: Place
    dimension: Dimension | None
    labels: tuple[Any, ...] = ()

    @classmethod
    def of(cls, axis: Levels, place: Place) -> Field:
        """Return the field of an axis of levels."""
        return cls(axis.field, place, axis.dimension, () if axis.numeric else axis.values)

    def given(self, value: float) -> object:
        """Return a value as a drive file has it."""
        if self.dimension is None:
            return self.labels[int(value)]
        if self.dimension == "number":
            return float(value)
        return f"{float(value)!r} {DIMENSION_TEXT[self.dimension].si_unit}"


@dataclass(frozen=True, eq=False)
class _Base:
    """What a drive says of the pulley, the drive, and the speeds of the belt of a train [m/s]."""

    columns: Mapping[str, float]
    law: FrictionLaw
    drive: Drive
    speeds: Mapping[str, float]

    def turned(self, load_case: str) -> float:
        """Return the speed of the belt where the drums decide it, else nan [m/s]."""
        speed = self.speeds.get(load_case, np.nan)
        return np.nan if speed == self.drive.belt.speed else speed


class DriveSource:
    """A drive file whose fields are varied on one pulley.

    Fields that are a column of the batch kernel, and tensions, are varied for all designs at once.
    For the others a drive is built for every combination of their values, some 1,500 a second.

    Parameters
    ----------
    document
        The drive file, parsed.
    pulley
        The pulley.
    fields
        What is varied.
    fits
        Laws that are drawn.
    slow
        Names of fields that are never taken as columns.
    setting
        How accurately the load of a train is divided.
    """

    def __init__(
        self,
        document: Document,
        pulley: str,
        fields: Sequence[Field],
        fits: Sequence[DrawnFit] = (),
        slow: frozenset[str] = frozenset(),
        setting: Setting = Setting.ENGINEERING,
    ) -> None:
        self.document, self.pulley, self.slow, self.setting = document, pulley, slow, setting
        self.fields, self.fits = tuple(fields), tuple(fits)
        # whether tensions stand at the pulleys, or follow from a train or a conveyor
        self._at_pulleys = not {"train", "conveyor"} & document.keys()
        self.drive, self._turned = _read(document)
        refuse_several(self.drive, "a study needs")
        self._read_tensions()
        lagging = next(r for r in self._pulleys if r["name"] == pulley).get("lagging")
        own = lagging if isinstance(lagging, str) else ""
        self._columns = {
            field.name: column
            for field in self.fields
            if field.dimension is not None
            and field.name not in slow
            and (column := _column(field.place, pulley, own, self.drive))
        }
        self._scaling = {f.place[-1]: f.name for f in self.fields if f.place[-1] in _SCALING}
        #: divides the load of a train anew in every row; None where drives are built for that
        self.divides = TrainColumns.of(document, self.fields) if not (slow or fits) else None
        self._wear = [f.name for f in self.fields if f.place == ("pulley", pulley, "wear")]
        own_keys = {f.name for f in self.fields if f.place[-1] in DRUM_KEYS}
        fast = {*self._columns, *self._scaling.values(), *own_keys}
        self._others = tuple(
            f
            for f in self.fields
            if self.divides is None
            and f.name not in fast
            and (f.name in slow or not self._at_pulleys or not _is_tension(f.place, pulley))
        )
        self._kept: dict[tuple[float, ...], _Base | None] = {}

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_kept": {}}

    def _read_tensions(self) -> None:
        record: Record = TRAIN_FILE.read(self.document, (), Report())
        self._pulleys: list[Record] = record["pulley"]
        self._cases = {case["name"]: case for case in record.get("load_case", ())}
        self._names = [r["name"] for r in self._pulleys]

    def unit_of(self, name: str) -> Dimension | None:
        """Return what a column of values measures."""
        known: dict[str, Dimension | None] = {f.name: f.dimension for f in self.fields}
        for fit in self.fits:
            known.update(fit.columns)
        return known.get(name)

    def remarks(self, drive: Drive) -> Iterator[str]:
        """Yield what a reader must know of the tensions: how a train divides them, the take-up."""
        if "train" in self.document:
            again = ", ".join(f.name for f in self._others)
            if self.divides is not None:
                yield "The load of the train divides anew in every row, as its file says."
                if any(f.place[-1] in ("wear", "speed_trim") for f in self.fields):
                    yield (
                        "Where the file gives shares, the pulleys turn at the speeds that "
                        "those require; wear and trims then shift the load."
                    )
            else:
                yield (
                    f"The load of the train divides as its file says, and pulley {self.pulley} "
                    + (f"(divided anew for each value of {again}) " if again else "")
                    + "has a constant Te whatever else varies; `wraparc solve` divides the load "
                    "anew."
                )
            for pulley in drive.pulleys:
                if pitch_offset(drive.belt, pulley.side) is None:
                    yield surface_sentence(pulley.diameter)
                    break
        take_up = drive.criteria.take_up
        held = "the sum of both tensions" if take_up.fixed else "the slack-side tension"
        held = f"the tension behind pulley {take_up.after}" if take_up.after else held
        yield (
            f"The gross-slip safety is that of a take-up that fixes {held}"
            + (f" ({take_up.kind})." if take_up.kind else "; the file names no take-up.")
        )

    def rows(self, values: Values, size: int, load_case: str) -> Rows:
        """Return designs in a load case."""
        bases, which = self._bases(values, size)
        valid = np.array([b is not None for b in bases], dtype=bool)[which]
        known = [b if b is not None else self._base(self.drive, self._turned) for b in bases]
        columns = {
            name: np.array([b.columns[name] for b in known], dtype=float)[which]
            for name in COLUMNS
            if name not in _TENSIONS
        }
        for field, column in self._columns.items():
            if field in values:
                columns[column] = np.asarray(values[field], dtype=float)
        drives = [b.drive for b in known]
        mass = masses_at([d.belt for d in drives], which, columns["belt_width"])
        lift = np.nan_to_num(centrifugal_force(mass, columns["belt_speed"]))
        columns["centrifugal_force"] = lift
        divided: Divided | None = None
        for name in self._wear:
            if name in values:
                columns["diameter"] = columns["diameter"] - 2.0 * values[name]
                columns["lagging_thickness"] = columns["lagging_thickness"] - values[name]
        valid &= columns["lagging_thickness"] >= 0.0
        self._over_gross_area(columns, values, drives, which)
        if self.divides is not None:
            divided = self.divides.solve(values, size, load_case, self.setting)
            entries, exits = divided.entries, divided.exits
            valid &= divided.valid
        elif self._at_pulleys:
            entries, exits = self._tensions(values, drives, which, load_case)
        else:
            entries, exits = (e[:, which] for e in self._tensions_of(drives, load_case))
        index, most = self._names.index(self.pulley), Tensions.LIMITS["entry"].most
        entry, leaving = entries[index], exits[index]
        for tension in (entry, leaving):
            valid &= (tension > lift) & (tension <= most)
        columns["entry_tension"] = np.where(valid, entry, lift + 2.0)
        columns["exit_tension"] = np.where(valid, leaving, lift + 1.0)
        laws, law = self._laws([b.law for b in known], which, values, size)
        of_train = self._of_train(divided, entries, exits)
        arcs = Arcs(laws=LawBank.of(laws), law=law, **columns)
        turned = np.array([b.turned(load_case) for b in known])[which]
        speeds = np.where(np.isnan(turned), arcs.belt_speed, turned)
        if divided is not None:
            speeds = divided.solved.belt_speed
        ones = np.ones(size)
        return Rows(
            arcs=replace(arcs, belt_speed=speeds * self._strain(arcs, entries)),
            held=self._with_motors(
                held_by(drives, which, self.pulley, load_case, arcs, (entries, exits)),
                of_train,
                load_case,
            ),
            valid=valid,
            friction_factor=values.get(self._scaling.get(FRICTION_FACTOR, ""), ones),
            slip_factor=values.get(self._scaling.get(SLIP_FACTOR, ""), ones),
            drives=drives,
            which=which,
            pulley=self.pulley,
            load_case=load_case,
            lost=divided.lost if divided else np.zeros(size, dtype=np.int8),
            of_train=of_train,
        )

    def _strain(self, arcs: Arcs, entries: Array) -> Array:
        """Speed of the belt where it meets the pulley over that at the first, by its strain [-]."""
        stiffness = arcs.belt_width * arcs.belt_modulus
        entry = entries[self._names.index(self.pulley)]
        return np.asarray(strain_ratio(entry, entries[0], stiffness))

    def _over_gross_area(
        self, columns: dict[str, Array], values: Values, drives: Sequence[Drive], which: Integers
    ) -> None:
        """Set the moduli over the gross area: files have G of the rubber, E_c follows h."""
        varied = {self._columns[f] for f in self._columns if f in values}
        laggings = [d.pulley(self.pulley).lagging for d in drives]
        if "shear_modulus" in varied:
            contact = np.array([lagging.contact_fraction for lagging in laggings])
            columns["shear_modulus"] = columns["shear_modulus"] * contact[which]
        if "compression_modulus" not in varied:
            thickness = columns["lagging_thickness"]
            columns["compression_modulus"] = compression_moduli(laggings, which, thickness)

    def _with_motors(self, held: Held, of_train: Mapping[str, Array], load_case: str) -> Held:
        """Return what rows are held against, with load of the motors and what they bear."""
        division = None if self.divides is None else self.divides.train.case(load_case).division
        if not isinstance(division, Motors) or "motor_load" not in of_train:
            return held
        motor = division.motors[self._names.index(self.pulley)]
        load = np.abs(of_train["motor_load"])
        if not isinstance(motor, Motor):
            return held
        momentary = self.drive.load_case(load_case).kind != "running"
        rule = MOMENTARY_LOAD if momentary else MOTOR_LOAD
        return held.with_motors(load, rule.name, motor.bears(momentary))

    def _of_train(self, divided: Divided | None, entries: Array, exits: Array) -> dict[str, Array]:
        """What the pulley has within the whole drive."""
        pulls = entries - exits
        total = pulls.sum(axis=0)
        none = np.full(len(total), np.nan)
        share = np.divide(
            pulls[self._names.index(self.pulley)], total, where=total != 0.0, out=none
        )
        found = {"share": share}
        if divided is not None:
            drum = divided.solved[self.pulley].of_train
            found |= {name: drum[name] for name in TRAIN_OUTPUTS if name in drum}
        return found

    def _laws(
        self, laws: Sequence[FrictionLaw], which: Integers, values: Values, size: int
    ) -> tuple[list[FrictionLaw], Integers]:
        """Laws, each once, and the place of that of every design."""
        drawn = [fit for fit in self.fits if next(iter(fit.columns)) in values]
        if not drawn:
            places: dict[FrictionLaw, int] = {}
            index = np.array([places.setdefault(law, len(places)) for law in laws])
            return list(places), index[which]
        fit = drawn[0]
        table = np.stack([values[name] for name in fit.columns], axis=1)
        own = [
            with_peaks(laws[which[i]], dict(zip(fit.fit.knots, table[i], strict=True)))
            for i in range(size)
        ]
        return own, np.arange(size)

    def _bases(self, values: Values, size: int) -> tuple[list[_Base | None], Integers]:
        """Drives of the different combinations of fields that are no columns."""
        others = [f for f in self._others if f.name in values]
        if not others:
            return [self._base(self.drive, self._turned)], np.zeros(size, dtype=np.int64)
        table = np.stack([values[f.name] for f in others], axis=1)
        different, which = np.unique(table, axis=0, return_inverse=True)
        return [self._built(others, row) for row in different], which.ravel()

    def _built(self, others: Sequence[Field], row: Array) -> _Base | None:
        """Return the drive of a combination; None if there cannot be one."""
        key = tuple(row.tolist())
        if key not in self._kept:
            if len(self._kept) >= _MOST_KEPT:
                self._kept.clear()
            given = {place_text(f.place): f.given(v) for f, v in zip(others, key, strict=True)}
            try:
                self._kept[key] = self._base(*_read(self.document, given))
            except InputError:
                self._kept[key] = None
        return self._kept[key]

    def _base(self, drive: Drive, speeds: Mapping[str, float]) -> _Base:
        pulley = drive.pulley(self.pulley)
        lagging: Lagging = pulley.lagging
        nan, of = float("nan"), of_belt(drive.belt, pulley.side, lagging.law)
        speed, wear = drive.belt.speed, lagging.wear_coefficient
        columns = {
            "diameter": pulley.diameter,
            "wrap_angle": pulley.wrap_angle,
            "belt_width": drive.belt.width,
            "belt_modulus": drive.belt.modulus,
            "lagging_thickness": lagging.thickness,
            "shear_modulus": lagging.shear_modulus,
            "compression_modulus": lagging.compression_modulus,
            "wear_coefficient": nan if wear is None else wear,
            "overrun": nan if pulley.overrun is None else pulley.overrun,
            "recovery": float(pulley.recovery),
            "creep_limit": drive.creep_limit_of(pulley),
            "belt_speed": nan if speed is None else speed,
            "pitch_offset": of["pitch_offset"] or 0.0,
            "cover_compliance": of["cover_compliance"],
            "centrifugal_force": of["centrifugal"],
        }
        return _Base(columns, lagging.law, drive, speeds)

    def _tensions(
        self, values: Values, drives: Sequence[Drive], which: Integers, load_case: str
    ) -> tuple[Array, Array]:
        """Entry and exit tensions of all pulleys, by the rules of drive files, (pulleys, size)."""
        at, size = {f.place: values[f.name] for f in self.fields if f.name in values}, len(which)
        speed: Any = at.get(("belt", "speed"), self.drive.belt.speed)
        given = []
        for record in self._pulleys:
            name = record["name"]
            diameter: Any = at.get(("pulley", name, "diameter"), record["diameter"])
            offsets = [pitch_offset(d.belt, d.pulley(name).side) or 0.0 for d in drives]
            diameter = diameter + 2.0 * np.array(offsets)[which]
            numbers = _numbers(record, ("pulley", name), at)
            given.append(Given(name, (), LoadGiven(**numbers), {}, diameter))
        if load_case in self._cases:
            given = [self._in_case(item, load_case, at) for item in given]
        missing = float("nan")
        pairs = [
            [np.broadcast_to(missing if end is None else end, (size,)) for end in pair]
            for pair in spread(given, speed)
        ]
        found = np.array(pairs, dtype=float)
        return found[:, 0], found[:, 1]

    def _tensions_of(self, drives: Sequence[Drive], load_case: str) -> tuple[Array, Array]:
        """Entry and exit tensions of all pulleys of some drives, shape (pulleys, drives) each."""
        cases = [drive.load_case(load_case).tensions for drive in drives]
        pairs = [[(t[name].entry, t[name].exit) for t in cases] for name in self._names]
        found = np.array(pairs, dtype=float)
        return found[:, :, 0], found[:, :, 1]

    def _in_case(self, item: Given, case: str, at: Mapping[Place, Array]) -> Given:
        tables = self._cases[case].get("pulley", {})
        table = tables.get(item.name, Record({}, (), {}))
        place = ("load_case", case, "pulley", item.name)
        over = Record(_numbers(table, place, at), (), {})
        speed: Any = at.get(("belt", "speed"), self.drive.belt.speed)
        return item.overridden(over, fixed=self.drive.criteria.take_up.fixed, speed=speed)


def _read(document: Document, given: Overrides = ()) -> tuple[Drive, Mapping[str, float]]:
    """Return the drive of a file, and of a train the speeds of its belt by load case [m/s]."""
    if "train" not in document:
        return any_drive_from_document(document, overrides=given, allow_paths=True), {}
    return with_speeds(train_from_document(document, overrides=given, allow_paths=True))


_SCALING = (FRICTION_FACTOR, SLIP_FACTOR)


def _numbers(record: Mapping[str, Any], place: Place, at: Mapping[Place, Array]) -> dict[str, Any]:
    """Tensions of a table with those of the study put over them."""
    numbers = {key: record[key] for key in KEYS if key in record}
    return numbers | {key: at[(*place, key)] for key in KEYS if (*place, key) in at}


def _is_tension(place: Place, pulley: str) -> bool:
    """Whether a field only makes tensions: the diameter of another pulley does, by a torque."""
    another = place[0] == "pulley" and place[1] != pulley and place[2:] == ("diameter",)
    return another or (place[-1] in KEYS and place[0] in ("pulley", "load_case"))


def _column(place: Place, pulley: str, own_lagging: str, drive: Drive) -> str:
    """Return the column that a field is, or nothing."""
    head, key = place[:-1], str(place[-1])
    if head == ("belt",):
        return _OF_BELT.get(key, "")
    if head == ("pulley", pulley):
        return _OF_PULLEY.get(key, "")
    if head in (("pulley", pulley, "lagging"), ("lagging", own_lagging)):
        return _OF_LAGGING.get(key, "")
    if place == ("creep_limit",) and drive.pulley(pulley).creep_limit is None:
        return "creep_limit"
    return ""
