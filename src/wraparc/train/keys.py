"""The keys of the ``[train]`` table of a drive file: several drives on one belt."""

from dataclasses import dataclass
from typing import Any, ClassVar

from wraparc.drive import MOST_PULLEYS, Limit, Pulley, Tensions
from wraparc.errors import InputError
from wraparc.files.drive_keys import DRIVE, LOAD_CASE
from wraparc.schema.kinds import ByName, Choice, Flag, Kind, Name, Quantity, Rows
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.shared_keys import limited
from wraparc.schema.tables import Entry, Table, Variant
from wraparc.train.motors import (
    FluidCoupling,
    Induction,
    Motor,
    TorqueFollower,
    VariableSpeed,
)
from wraparc.units import parse_quantity

EQUAL = "equal"


@dataclass(frozen=True)
class Either(Kind):
    """A quantity of one of two dimensions, read as its dimension and its SI value."""

    first: Quantity
    second: Quantity
    words: str

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return (dimension, SI value)."""
        for kind in (self.first, self.second):
            try:
                parse_quantity(raw, kind.dimension)
            except InputError:
                continue
            value = kind.read(raw, place, report)
            return NOTHING if value is NOTHING else (kind.dimension, value)
        report.add(place, f"must be {self.words}", value=raw)
        return NOTHING

    def schema(self) -> dict[str, Any]:
        """Either of the two."""
        return {"anyOf": [self.first.schema(), self.second.schema()]}


@dataclass(frozen=True)
class SpeedList(Kind):
    """The word ``equal``, or a speed for each pulley; read as (dimension, values)."""

    rows: ClassVar[Rows] = Rows(
        Either(
            Quantity("number", Limit("number", open=True, most=10.0)),
            Quantity("rotation_speed", Limit("rotation_speed", open=True)),
            'a trim like "99.7 %" or a drum speed like "71.6 rpm"',
        ),
        1,
        MOST_PULLEYS,
    )

    def read(self, raw: object, place: Place, report: Report) -> Any:
        """Return EQUAL, or the values."""
        if raw == EQUAL:
            return EQUAL
        if isinstance(raw, str):
            report.add(place, f'must be "{EQUAL}" or an array of speeds', value=raw)
            return NOTHING
        return self.rows.read(raw, place, report)

    def schema(self) -> dict[str, Any]:
        """The word, or an array."""
        return {"anyOf": [{"const": EQUAL}, self.rows.schema()]}


_SHARE = Either(
    Quantity("number", Limit("number", least=-100.0, most=100.0)),
    Quantity("power"),
    'a share like 0.5 or "50 %", or a power like "300 kW"',
)

_COMMON = (
    Entry(
        "rated_power",
        limited(Motor.LIMITS, "rated_power"),
        "Rated power",
        "Rated shaft power of one motor.",
        required=True,
    ),
    Entry(
        "rated_speed",
        limited(Motor.LIMITS, "rated_speed"),
        "Rated speed",
        "Speed of the motor at rated torque.",
        required=True,
    ),
    Entry(
        "gear_ratio",
        limited(Motor.LIMITS, "gear_ratio"),
        "Gear ratio",
        "Motor speed over drum speed; 1 if left out.",
    ),
    Entry(
        "gear_efficiency",
        limited(Motor.LIMITS, "gear_efficiency"),
        "Efficiency of the gear",
        "Power out over power in; 1 if left out.",
    ),
    Entry("count", limited(Motor.LIMITS, "count"), "Motors", "Equal motors on the drum."),
    Entry("brakes", Flag(), "Brakes", "Whether the motor can hold back; true if left out."),
)
_MAINS = (
    Entry(
        "synchronous_speed",
        limited(Induction.LIMITS, "synchronous_speed"),
        "Synchronous speed",
        "Speed without slip.",
        required=True,
    ),
    Entry(
        "breakdown_ratio",
        limited(Induction.LIMITS, "breakdown_ratio"),
        "Breakdown ratio",
        "Breakdown torque over rated torque; 2.5 if left out.",
    ),
)
_CURVE = Rows(Quantity("number", Limit("number", most=10.0)), 2, 200)


def _motor(kind: str, *entries: Entry) -> Table:
    tag = Entry("kind", Choice((kind,)), "Kind", "What turns the drum.", required=True)
    return Table((tag, *entries), kind)


MOTOR = Variant(
    "kind",
    {
        "converter": _motor(
            "converter",
            *_COMMON,
            Entry(
                "setting",
                limited(VariableSpeed.LIMITS, "setting"),
                "Speed setting",
                "Set speed over rated speed; 1 if left out.",
            ),
            Entry(
                "droop",
                limited(VariableSpeed.LIMITS, "droop"),
                "Droop",
                "Fall of speed at rated torque over rated speed; 0 if left out.",
            ),
            Entry(
                "torque_limit",
                limited(VariableSpeed.LIMITS, "torque_limit"),
                "Torque limit",
                "Largest torque over rated torque.",
            ),
        ),
        "induction": _motor("induction", *_COMMON, *_MAINS),
        "fluid-coupling": _motor(
            "fluid-coupling",
            *_COMMON,
            *_MAINS,
            Entry(
                "coupling_load",
                _CURVE,
                "Torques of the coupling curve",
                "Torque over rated torque of the motor, rising from 0.",
                required=True,
            ),
            Entry(
                "coupling_slip",
                _CURVE,
                "Slips of the coupling curve",
                "Slip at each of the torques, rising from 0.",
                required=True,
            ),
        ),
        "follower": _motor(
            "follower",
            Entry("master", Name(), "Master", "Pulley whose torque is followed.", required=True),
            Entry(
                "ratio",
                limited(TorqueFollower.LIMITS, "ratio"),
                "Ratio",
                "Torque over that of the master; 1 if left out.",
            ),
        ),
    },
)
#: Classes of motors by the kind that they have in a file.
MOTORS: dict[str, type[Motor | TorqueFollower]] = {
    "converter": VariableSpeed,
    "induction": Induction,
    "fluid-coupling": FluidCoupling,
    "follower": TorqueFollower,
}

_TENSION = limited(Tensions.LIMITS, "entry")
#: What a load case may have of its own.
_CASE = (
    Entry(
        "entry_tension",
        _TENSION,
        "First entry tension",
        "Tension where the belt meets the first pulley.",
    ),
    Entry(
        "exit_tension",
        _TENSION,
        "Last exit tension",
        "Tension where the belt leaves the last pulley.",
    ),
    Entry(
        "effective_tension",
        Quantity("force"),
        "Total effective tension",
        "Sum of T1 - T2 over all pulleys.",
    ),
    Entry(
        "power",
        Quantity("power"),
        "Total power",
        "Power to the belt, total effective tension times belt speed.",
    ),
    Entry(
        "run",
        ByName(Quantity("force")),
        "Runs",
        "Rise of tension over the run from the pulley before, by pulley; 0 if left out.",
    ),
    Entry(
        "share",
        Rows(_SHARE, 1, MOST_PULLEYS),
        "Shares",
        "Part of the load of each pulley in belt order, or its power: speeds are computed.",
    ),
    Entry(
        "speeds",
        SpeedList(),
        "Speeds",
        "Trim or drum speed of each pulley in belt order, or equal drum speeds: shares are "
        "computed.",
    ),
)

TRAIN = Table(
    (
        *_CASE,
        Entry(
            "diameters",
            Rows(limited(Pulley.LIMITS, "diameter"), 1, MOST_PULLEYS),
            "Actual diameters",
            "Diameter of each drum as it is now, worn; those of the pulleys are then nominal.",
        ),
        Entry("motor", ByName(MOTOR), "Motors", "By pulley: the operating point is computed."),
    ),
    "Train",
)
TRAIN_CASE = Table(_CASE, "Train in this load case")

_LOAD_CASE = LOAD_CASE.having(
    Entry("train", TRAIN_CASE, "Train", "Tensions and division of the load of a train.")
)
#: A drive file with one drive or several.
TRAIN_FILE = DRIVE.having(
    Entry("load_case", Rows(_LOAD_CASE, 1), "Load cases", "States of the conveyor."),
    Entry("train", TRAIN, "Train", "How several drives on the belt divide the load."),
)
