"""Results of many trains by column."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.arrays import Array, Codes, Flags
from wraparc.batch import STATUSES, BatchResult
from wraparc.drive.pitch import pitch_radius, strain_ratio
from wraparc.errors import pandas
from wraparc.train.motor_rows import MotorRows
from wraparc.train.result import TrainStatus
from wraparc.train.rows import TrainRows
from wraparc.train.train import Train

if TYPE_CHECKING:
    import pandas as pd


SOLVED, BREAKAWAY, UNSOLVED, REFUSED, BEYOND_MOTOR = range(5)
#: What each number of the column ``status`` says.
TRAIN_STATUSES: Mapping[int, str] = {
    SOLVED: TrainStatus.SOLVED.value,
    BREAKAWAY: TrainStatus.BREAKAWAY.value,
    UNSOLVED: TrainStatus.UNSOLVED.value,
    REFUSED: STATUSES[REFUSED],
    BEYOND_MOTOR: TrainStatus.BEYOND_MOTOR.value,
}
_WORDS = ("solved", "breakaway", "unsolved", "refused", "outside a motor curve")


@dataclass(frozen=True, eq=False, repr=False)
class TrainBatchResult:
    """What many trains have to say.

    Attributes
    ----------
    rows
        What was solved.
    status
        0 solved, 1 breakaway, 2 unsolved, 3 refused, 4 outside a motor curve, see
        `TRAIN_STATUSES`; shape (n,).
    drums
        Columns of every drum by the name of its pulley.
    belt_speed
        At the first entry nip, shape (n,) [m/s]; nan where it is not known.
    speed_error
        Largest miss of the speeds asked for, shape (n,) [-]; 0 where none are.
    fallen
        Which drums break away, shape (n, drums).
    reasons
        What stands in the way, by row, where the solver of one train had to find it out.
    """

    rows: TrainRows
    status: Codes
    drums: Mapping[str, DrumColumns]
    belt_speed: Array
    speed_error: Array
    fallen: Flags
    reasons: Mapping[int, str]

    def __len__(self) -> int:
        return len(self.status)

    def __getitem__(self, pulley: str) -> DrumColumns:
        return self.drums[pulley]

    def __repr__(self) -> str:
        counts = np.bincount(self.status, minlength=len(_WORDS))
        said = ", ".join(f"{c} {w}" for c, w in zip(counts, _WORDS, strict=True) if c)
        return f"<TrainBatchResult: {len(self)} trains, {said}>"

    @property
    def solved(self) -> Flags:
        """Which trains carry their load, shape (n,)."""
        return np.asarray(self.status == SOLVED)

    @property
    def shares(self) -> Array:
        """Shares of the drums in belt order, shape (n, drums) [-]."""
        return np.stack([drum["share"] for drum in self.drums.values()], axis=1)

    def train(self, row: int) -> Train:
        """Return the train of a row, for `solve_train`: its profiles, and the whole of a reason."""
        return self.rows.row(row)

    def reason(self, row: int) -> str:
        """Return what stands in the way of a row; empty where it is solved."""
        status = int(self.status[row])
        if status == SOLVED:
            return ""
        if row in self.reasons:
            return self.reasons[row]
        gone = [n for n, f in zip(self.rows.names, self.fallen[row], strict=True) if f]
        if status == BREAKAWAY and gone:
            return f"Gross slip on {' and '.join(gone)}."
        return TRAIN_STATUSES[status]

    def to_frame(self) -> pd.DataFrame:
        """Return all columns as a pandas DataFrame, those of a drum as ``second.exit_creep``.

        Raises
        ------
        MissingExtraError
            If pandas is not installed.
        """
        columns: dict[str, Any] = {"status": self.status, "belt_speed": self.belt_speed}
        for pulley, drum in self.drums.items():
            columns |= {f"{pulley}.{name}": column for name, column in drum.items()}
        frame: pd.DataFrame = pandas().DataFrame(columns)
        return frame


@dataclass(frozen=True, eq=False, repr=False)
class DrumColumns(Mapping[str, Array]):
    """One drum of many trains, a column a quantity, shape (n,) each [SI].

    The columns of `wraparc.batch.BatchResult`, and those of `wraparc.train.MemberResult`; nan where
    the train has no balance.

    Attributes
    ----------
    arcs
        The arcs of the drum, solved.
    of_train
        The columns that the drum has within the train.
    """

    arcs: BatchResult
    of_train: Mapping[str, Array]

    def __getitem__(self, name: str) -> Array:
        return self.of_train[name] if name in self.of_train else self.arcs[name]

    def __iter__(self) -> Iterator[str]:
        yield from self.of_train
        yield from (name for name in self.arcs if name not in self.of_train)

    def __len__(self) -> int:
        return len(list(iter(self)))

    def __repr__(self) -> str:
        return f"<DrumColumns: {len(self.arcs.arcs)} rows, {len(self)} columns>"


def drum_columns(
    rows: TrainRows, arcs: list[BatchResult], belt_speed: Array, found: Flags
) -> list[dict[str, Array]]:
    """Columns that the drums have within their trains, see `wraparc.train.MemberResult`."""
    stiffness, total = rows.stiffness, rows.total
    entry = [r.arcs.entry_tension for r in arcs]
    ratio = [r["entry_creep_ratio"] for r in arcs]
    radius, offset = ([0.5 * r.arcs.diameter for r in arcs], [r.arcs.pitch_offset for r in arcs])
    pressed = [
        2.0 * r.arcs.lagging_thickness / (r.arcs.compression_modulus * r.arcs.belt_width
                                          * r.arcs.diameter)
        * (r.arcs.entry_tension - r.arcs.centrifugal_force)
        for r in arcs
    ]  # fmt: skip
    nominal = rows.drums["nominal_diameter"]
    made = []
    for i, drum in enumerate(arcs):
        pull = np.where(found, drum["effective_tension"], np.nan)
        stretch = strain_ratio(entry[i], entry[0], stiffness)
        speed_ratio = stretch * (1.0 - ratio[0]) / (1.0 - ratio[i])
        arm, first = (pitch_radius(radius[k], pressed[k], offset[k]) for k in (i, 0))
        surface = belt_speed * stretch / (1.0 - ratio[i])
        columns = {
            "share": np.where(total != 0.0, pull / np.where(total != 0.0, total, 1.0), np.nan),
            "speed_ratio": speed_ratio,
            "contraction_term": np.where(found, (entry[i] - entry[0]) / stiffness, np.nan),
            "creep_term": ratio[i] - ratio[0],
            "compression_term": pressed[i] / radius[i] - pressed[0] / radius[0],
            "thickness_term": (1.0 + offset[0] / radius[0]) / (1.0 + offset[i] / radius[i]) - 1.0,
            "drum_ratio": speed_ratio * first / arm * radius[i] / radius[0],
            "surface_speed": surface,
            "rotation_speed": surface / arm,
            "speed_trim": speed_ratio * first / arm * nominal[:, i] / nominal[:, 0],
            "drum_torque": pull * arm,
            "drum_power": surface * pull,
        }
        motor = rows.motors[i] if rows.motors else None
        if isinstance(motor, MotorRows):
            columns |= _motor_columns(motor, columns["drum_torque"], columns["rotation_speed"])
        made.append(columns)
    return made


def _motor_columns(motor: MotorRows, torque: Array, rotation: Array) -> dict[str, Array]:
    """Where the motors of a drum work, see `wraparc.train.MotorPoint`."""
    load = motor.load(torque)
    each, count = load * motor.rated_torque, motor.motor.count
    gear_speed = rotation * motor.of("gear_ratio")
    speed = motor.motor_speed(load, gear_speed)
    shaft = count * each * speed
    electrical = np.full_like(shaft, np.nan)
    eta = motor.of("motor_efficiency")
    if eta is not None:
        electrical = np.where(shaft >= 0.0, shaft / eta, shaft * eta)
    return {
        "motor_load": load,
        "motor_torque": each,
        "motor_speed": speed,
        "motor_power": each * speed,
        "gear_speed": gear_speed,
        "electrical_power": electrical,
        "motor_loss": electrical - shaft,
        "coupling_loss": count * each * (speed - gear_speed),
        "gear_loss": count * each * gear_speed - torque * rotation,
    }
