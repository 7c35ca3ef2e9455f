"""The keys of the ``[train]`` table of a drive file: several drives on one belt."""

from dataclasses import dataclass
from typing import Any, ClassVar

from wraparc.drive import MOST_PULLEYS, Limit, Pulley, Tensions
from wraparc.drive.load_case import UNCERTAIN_OF_CASE
from wraparc.errors import InputError
from wraparc.files.drive_keys import DRIVE, LOAD_CASE
from wraparc.schema.kinds import ByName, Count, Kind, Name, Quantity, Rows
from wraparc.schema.problems import NOTHING, Place, Report
from wraparc.schema.tables import Entry, Table, Variant, limited, need
from wraparc.schema.uncertain import uncertainty_entry
from wraparc.train.motors import (
    FluidCoupling,
    Induction,
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
            'a trim like "99.7 %" or a pulley speed like "71.6 rpm"',
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
    need("rated_power", "Rated shaft power of one motor."),
    need("rated_speed", "Speed of the motor at rated torque."),
    Entry("gear_ratio", "Motor speed over pulley speed; 1 if left out."),
    Entry(
        "gear_efficiency",
        "Power out over power in; 1 if left out.",
        title="Efficiency of the gear",
    ),
    Entry(
        "motor_efficiency",
        "Shaft power over electrical power; without it motor losses are not reported.",
        title="Efficiency of the motor",
    ),
    Entry("count", "Equal motors on the pulley.", Count(1, 8), title="Motors"),
    Entry("brakes", "Whether the motor can brake; true if left out."),
)
_MAINS = (
    need("synchronous_speed", "Speed without slip."),
    Entry(
        "breakdown_ratio",
        "Breakdown torque over rated torque; 2.5 if left out.",
    ),
)
_CURVE = Rows(Quantity("number", Limit("number", most=10.0)), 2, 200)


MOTOR = Variant(
    "kind",
    "What drives the pulley.",
    Table(
        "converter",
        *_COMMON,
        Entry(
            "setting",
            "Set speed over rated speed; 1 if left out.",
            title="Speed setting",
        ),
        Entry(
            "droop",
            "Fall of speed at rated torque over rated speed; 0 if left out.",
        ),
        Entry(
            "torque_limit",
            "Maximum torque over rated torque.",
        ),
        of=VariableSpeed,
    ),
    Table("induction", *_COMMON, *_MAINS, of=Induction),
    Table(
        "fluid-coupling",
        *_COMMON,
        *_MAINS,
        need(
            "coupling_load",
            "Torque over rated torque of the motor, rising from 0.",
            _CURVE,
            title="Torques of the coupling curve",
        ),
        need(
            "coupling_slip",
            "Slip at each of the torques, rising from 0.",
            _CURVE,
            title="Slips of the coupling curve",
        ),
        of=FluidCoupling,
    ),
    Table(
        "follower",
        need("master", "Pulley whose torque is followed.", Name()),
        Entry(
            "ratio",
            "Torque over that of the master; 1 if left out.",
        ),
        of=TorqueFollower,
    ),
)

_TENSION = limited(Tensions, "entry")
#: What a load case may have of its own.
_CASE = (
    Entry(
        "entry_tension",
        "Tension where the belt meets the first pulley.",
        _TENSION,
        title="First entry tension",
    ),
    Entry(
        "exit_tension",
        "Tension where the belt leaves the last pulley.",
        _TENSION,
        title="Last exit tension",
    ),
    Entry(
        "effective_tension",
        "Sum of T1 - T2 over all pulleys.",
        Quantity("force"),
        title="Total effective tension",
    ),
    Entry(
        "power",
        "Power to the belt, total effective tension times belt speed.",
        Quantity("power"),
        title="Total power",
    ),
    Entry(
        "run",
        "Rise of tension over the run from the pulley before, by pulley; 0 if left out.",
        ByName(Quantity("force")),
        title="Runs",
    ),
    Entry(
        "share",
        "Part of the load of each pulley in belt order, or its power: speeds are computed.",
        Rows(_SHARE, 1, MOST_PULLEYS),
        title="Shares",
    ),
    Entry(
        "speeds",
        "Trim or pulley speed of each pulley in belt order, or equal pulley speeds: shares are "
        "computed.",
        SpeedList(),
    ),
)

TRAIN = Table(
    "Train",
    *_CASE,
    uncertainty_entry(UNCERTAIN_OF_CASE),
    Entry(
        "diameters",
        "Present diameter of each pulley, worn; those of the pulleys are then nominal.",
        Rows(limited(Pulley, "diameter"), 1, MOST_PULLEYS),
        title="Actual diameters",
    ),
    Entry("motor", "By pulley: the operating point is computed.", ByName(MOTOR), title="Motors"),
)
TRAIN_CASE = Table("Train in this load case", *_CASE, uncertainty_entry(UNCERTAIN_OF_CASE))

_LOAD_CASE = LOAD_CASE.having(
    Entry("train", "Tensions and division of the load of a train.", TRAIN_CASE)
)
#: A drive file with one drive or several.
TRAIN_FILE = DRIVE.having(
    Entry("load_case", "States of the conveyor.", Rows(_LOAD_CASE, 1), title="Load cases"),
    Entry("train", "How several drives on the belt divide the load.", TRAIN),
)
