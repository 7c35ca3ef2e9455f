"""The keys of the ``[motion]`` table of a drive file: what moves, and what happens to it."""

from wraparc.motion.control import (
    CoupledMotor,
    Droop,
    ExactSpeed,
    Follower,
    InductionMotor,
    SpeedLoop,
    Trim,
)
from wraparc.motion.event import (
    SHAPES,
    Event,
    LoadStep,
    Measured,
    OnBelt,
    OnDrum,
    PowerFailure,
    Start,
    Stop,
)
from wraparc.motion.station import TAKE_UPS, Drum, Station
from wraparc.schema.kinds import ByName, Choice, Flag, Name, Quantity, Rows, Text
from wraparc.schema.limits import Limit
from wraparc.schema.tables import Entry, Table, Variant, need

_RATING = Entry(
    "rated_torque", "Torque at the pulley that ratios refer to; that of the load case if left out."
)
_LAG = (
    Entry("lag", "Of the torque behind what is asked; 0 if left out."),
    Entry("torque_limit", "Maximum torque over rated torque; 2.5 if left out."),
)
_MOTOR = (
    Entry("rated_slip", "Slip of the motor at rated torque; 1 % if left out."),
    Entry("breakdown_ratio", "Breakdown torque over rated torque; 2.5 if left out."),
)
CONTROL = Variant(
    "kind",
    "How the pulley is driven.",
    Table("exact-speed", _RATING, of=ExactSpeed),
    Table(
        "droop",
        _RATING,
        Entry("droop", "Fall of speed at rated torque over set speed; 1 % if left out."),
        *_LAG,
        of=Droop,
    ),
    Table(
        "speed-loop",
        _RATING,
        need("bandwidth", "Of the loop with the inertia of the pulley, in hertz."),
        need("reset", "Time of the integral part.", example='reset = "1 s"'),
        *_LAG,
        of=SpeedLoop,
    ),
    Table(
        "induction",
        _RATING,
        need("starting_ratio", "Starting torque over rated torque."),
        *_MOTOR,
        of=InductionMotor,
    ),
    Table(
        "fluid-coupling",
        _RATING,
        need("pump_inertia", "Of motor and pump, as seen at the pulley."),
        Entry("coupling_slip", "At rated torque; 3 % if left out."),
        Entry("coupling_limit", "Torque at standstill over rated torque; 1.8 if left out."),
        *_MOTOR,
        Entry("starting_ratio", "Starting torque of the motor over rated; 1.8 if left out."),
        of=CoupledMotor,
    ),
    Table(
        "follower",
        _RATING,
        need("master", "Pulley whose torque is followed.", Name()),
        Entry("ratio", "Torque over that of the master; that of the load case if left out."),
        Entry("lag", "Of the torque behind the master's; 0.1 s if left out."),
        Entry("dead_time", "Of the torque behind the master's; 0 if left out."),
        Entry("damping", "Droop of an added speed feedback; none if left out."),
        of=Follower,
    ),
)
TRIM = Table(
    "Load sharing",
    need("gain", "Change of the speed trim per second and share.", example="gain = 0.01"),
    Entry("filter_time", "Of the measured share; 0 if left out."),
    Entry("dead_time", "Of the measured share; 0 if left out."),
    of=Trim,
)
DRUM = Table(
    "Pulley",
    need(
        "inertia",
        "As seen at the pulley shaft: of pulley and gear, and of the motors unless stated "
        "separately.",
    ),
    Entry(
        "motor_inertia",
        "Of its motors and couplings together, at their own shafts.",
        Quantity("moment_of_inertia", Limit("moment_of_inertia", open=True, most=1e6)),
    ),
    Entry(
        "gear_ratio",
        "Motor speed over pulley speed, for the motor inertia; that of its motor in the train if "
        "left out.",
        Quantity("number", Limit("number", open=True, most=1e4)),
    ),
    Entry("run", "Belt from the pulley before to this one; 3 m if left out.", title="Run before"),
    Entry("control", "How it is driven; droop of 1 % if left out.", CONTROL),
    Entry("trim", "Load sharing by a slow trim of its speed.", TRIM, title="Load sharing"),
    Entry("backstop", "Whether it cannot turn back; true if left out."),
    Entry("brake_torque", "Of its brake at the pulley; 0 if left out."),
    of=Drum,
)
_AT = Entry("at", "When it begins; 0 if left out.", title="Begins at")
_SHAPE = (
    Entry("shape", "S-curve if left out; direct is direct on line.", Choice(SHAPES), title="Shape"),
    Entry("time", "How long it takes; 20 s if left out."),
)
_PULLEY = need("pulley", "The pulley that it turns with.", Name(), example='pulley = "second"')
HAPPENING = Variant(
    "kind",
    "What happens.",
    Table("start", _AT, *_SHAPE, of=Start),
    Table("stop", _AT, *_SHAPE, of=Stop),
    Table("emergency-stop", _AT, of=PowerFailure),
    Table("power-failure", _AT, of=PowerFailure),
    Table(
        "load-step",
        _AT,
        need("factor", "Resistance over that of the load case."),
        Entry("time", "How long the change takes; at once if left out."),
        of=LoadStep,
    ),
    Table(
        "wet-patch",
        _AT,
        need("length", "On the belt."),
        need("friction", "Friction there over that of the dry belt."),
        of=OnBelt,
    ),
    Table(
        "splice",
        _AT,
        need("length", "On the belt."),
        Entry("rise", "Height of its cords over those beside it; 0 if left out."),
        Entry("compliance", "Of the belt there over that beside it; 1 if left out."),
        of=OnBelt,
    ),
    Table(
        "run-out",
        _AT,
        _PULLEY,
        need("run_out", "Amplitude of the radius.", example='run_out = "0.5 mm"'),
        Entry("order", "Waves per revolution; 1 if left out."),
        of=OnDrum,
    ),
    Table(
        "lagging-joints",
        _AT,
        _PULLEY,
        need("joint_rise", "Height over the lagging, negative below it."),
        Entry("joints", "On the shell; 4 if left out."),
        Entry("joint_width", "Along the shell; 40 mm if left out."),
        of=OnDrum,
    ),
    Table(
        "torque-ripple",
        _AT,
        _PULLEY,
        need("ripple", "Amplitude over the steady torque."),
        Entry("order", "Waves per revolution; 1 if left out."),
        of=OnDrum,
    ),
    Table(
        "measured",
        _AT,
        _PULLEY,
        Entry(
            "file",
            "CSV of two columns: time [s], and speed [rpm] or torque [kN m] of the pulley.",
            Text(500),
        ),
        Entry(
            "record", "The lines of such a file, in place of its name.", Text(200_000, lines=True)
        ),
        of=Measured,
    ),
)
EVENT = Table(
    "Event",
    need("name", "What it is called.", Name(), example='name = "start"'),
    Entry("duration", "How long it is looked at; 60 s if left out."),
    need(
        "happens", "What happens, in any order.", Rows(HAPPENING, 1, 50), example="happens = [..]"
    ),
    Entry(
        "report",
        "Whether the calculation note follows it and counts its checks; false if left out.",
        Flag(),
        title="In the note",
    ),
    of=Event,
)
MOTION = Table(
    "Motion",
    Entry(
        "load_case",
        "That runs; the running one of maximum effective tension if left out.",
        Name(),
        title="Load case",
    ),
    Entry(
        "conveyor_mass",
        "Belt, load and idlers, moving with the belt; without it the outer tensions are constant.",
    ),
    Entry(
        "carry_run",
        "Belt stretched before the first pulley; 50 m if left out.",
        title="Carrying run",
    ),
    Entry("return_run", "Belt stretched behind the last pulley; 20 m if left out."),
    Entry("lift_share", "Part of the resistance that acts at rest too; 0 if left out."),
    Entry("take_up", "Gravity if left out.", Choice(TAKE_UPS), title="Take-up"),
    Entry("winch_speed", "Maximum belt speed of the winch; 0.1 m/s if left out."),
    Entry("source", "Where the numbers came from.", Text(500)),
    need(
        "drum",
        "The drives, by pulley.",
        ByName(DRUM),
        title="Pulleys",
        example="a [motion.drum.NAME] table for each pulley",
    ),
    Entry("event", "What may happen.", Rows(EVENT, 1, 50), title="Events"),
    of=Station,
)
