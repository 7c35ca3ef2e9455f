"""Every number of a file is asked about where it is a thousand times too large or too small.

Expected: a refusal, or the check of usual sizes missed. The keys are taken from the tables that
read the files, so that a key added there is asked about too, or stands below with its reason.
"""

import re
import tomllib
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest

from judgement.rows import BASE, CONVEYOR, MOTION, MOTORS, PLAIN, TANDEM
from wraparc.answer.choose_sheet import choose_sheet
from wraparc.calibrate.file import CALIBRATE
from wraparc.checks import Level, before
from wraparc.checks.of_run import of_run
from wraparc.checks.usual import usual_sizes
from wraparc.choose.file import search_from_document
from wraparc.choose.selection import choose
from wraparc.drive import Drive
from wraparc.errors import InputError
from wraparc.files.drive_file import drive_from_document
from wraparc.files.drive_keys import DRIVE
from wraparc.motion.file import motion_from_document
from wraparc.motion.keys import MOTION as MOTION_KEYS
from wraparc.schema.kinds import Count, Kind, Percent, Quantity
from wraparc.schema.problems import NOTHING, Report
from wraparc.schema.tables import Table
from wraparc.shear_test.plan_keys import PLAN
from wraparc.study.event_study import EVENT_STUDY
from wraparc.study.keys import STUDY
from wraparc.train.file import train_from_document
from wraparc.train.keys import TRAIN
from wraparc.train.unsolved import unsolved_drive

HEAD = """\
format = 1
condition = "dry"
[belt]
modulus = "12960 kN/m"
rating = "175 kN/m"
strength = "1250 kN/m"
width = "1200 mm"
speed = "3 m/s"
momentary_factor = 1.4
least_pulley_diameter = "600 mm"
largest_wrap_pressure = "600 kPa"
in_plane_shear_stiffness = "100 kN/m"
pulley_cover = "3 mm"
carry_cover = "6 mm"
carcass = "6 mm"
cover_shear_modulus = "1 MPa"
cord_diameter = "6 mm"
cord_pitch = "12 mm"
mass = "20 kg/m"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "190 deg"
lagging = "plain"
mass = "900 kg"
overrun = "0.2 mm"
creep_limit = "6 mm"
entry_tension = "120 kN"
exit_tension = "75 kN"
[pulley.across]
misalignment = 0.0005
deflection = "0.3 mm"
shell_profile = { crown = "1 mm", rows = [["-500 mm", "0 mm"], ["500 mm", "0.5 mm"]] }
worn_depth = { crown = "0.2 mm", rows = [["-500 mm", "0 mm"], ["500 mm", "0.5 mm"]] }
build_up = { crown = "0.2 mm", rows = [["-500 mm", "0 mm"], ["500 mm", "0.5 mm"]] }
before = { kind = "transition", length = "2.9 m", trough_angle = "35 deg", centre_roll = "465 mm" }
after = { kind = "pulley", distance = "4 m" }
[take_up]
kind = "gravity"
sheave_ratio = 2
[design_standard]
name = "own"
friction = 0.35
start_factor = 1.4
[safety_factor]
running = 1.25
starting = 1.1
braking = 1.1
[sag]
idler_spacing = "3 m"
line_mass = "22 kg/m"
share = 0.02
""" + PLAIN.replace(
    'surface = "rubber"',
    'surface = "rubber"\ncompression_modulus = "8 MPa"\nelastic_modulus = "6 MPa"\n'
    'wear_coefficient = "0.05 mm3/J"\nbelt_energy_share = 0.4\nbond_strength = "1 MPa"\n'
    'fatigue_limit = "0.5 MPa"\n'
    'cost = { material = 9000, installation = 4000, currency = "AUD", area = "3 m2", '
    "life_years = [3, 6] }\n"
    'condition_factor = [{ condition = "wet", factor = 0.7, provenance = { kind = "given" } }]',
).replace(
    "friction = 0.5 }",
    'friction = 0.5, tested_pressure = ["34 kPa", "690 kPa"], tested_slip = "20 mm" }',
)
BLOCKS = HEAD.replace(
    'compression_modulus = "8 MPa"',
    'block = { width = "60 mm", height = "12 mm", stiffening = 1, contact_fraction = 0.6 }',
)
TESTS = 'tested_pressure = ["34 kPa", "690 kPa"], tested_slip = "20 mm", '
LAWS = {
    "knots": 'kind = "integral-log", tested_slip = "20 mm", tested_slip_speed = "1 mm/s", knots = ['
    '{ pressure = "40 kPa", peak_friction = 0.9, peak_slip = "9 mm", post_peak_slope = "-0.01 1/mm"'
    ', residual_friction = 0.8 }, { pressure = "600 kPa", peak_friction = 0.5, peak_slip = "9 mm" }'
    "] }",
    "elastic": f'kind = "elastic-plastic", {TESTS}friction = 0.5, stiffness = "60 kPa/mm" }}',
    "of pressure": f'kind = "power", {TESTS}friction = 0.5, reference_pressure = "100 kPa", '
    "exponent = 0.2 }",
    "table": 'kind = "table", slip = ["0 mm", "10 mm"], rows = ['
    '{ pressure = "40 kPa", friction = [0, 0.6] }, { pressure = "600 kPa", friction = [0, 0.5] }'
    "] }",
}
LAW_DRIVES = {
    name: tomllib.loads(f"law = {{ {law}".join(re.split(r"law = \{.*\}", HEAD)))
    for name, law in LAWS.items()
}
LIMITED = HEAD.replace('creep_limit = "6 mm"\n', "")
PULLS = {
    key: f'creep_limit = "8 mm"\n{LIMITED}'.replace('entry_tension = "120 kN"', f'{key} = "{text}"')
    for key, text in (("effective_tension", "45 kN"), ("power", "135 kW"), ("torque", "18 kN m"))
}
BELT = CONVEYOR.replace(
    "take_up_tension",
    'length_coefficient = 1.15\nspecial_resistance = "2 kN"\nfriction_factor = 0.022\n'
    'start_time = "20 s"\nstop_time = "15 s"\ntake_up_distance = "100 m"\nreturn_share = 0.1\n'
    "take_up_tension",
)
OTHER_BELT = (
    CONVEYOR.replace("take_up_tension = \"40 kN\"", 'counterweight = "8000 kg"\nstart_factor = 1.4')
    .replace("capacity = \"1000 t/h\"", 'material_mass = "92 kg/m"\nsecondary_resistance = "4 kN"')
)  # fmt: skip
FLIGHTS = (
    CONVEYOR.replace("width =", 'thickness = "15 mm"\nwidth =')
    .replace('capacity = "1000 t/h"\n', "")
    .replace(
        'take_up_tension = "40 kN"\n',
        """take_up_tension = "40 kN"
carry_spacing = "1.2 m"
return_spacing = "3 m"
sag_limit = 0.01
rest_friction = 0.5
stop_time = "40 s"
cema = { idler_friction = "1.5 lbf", temperature_factor = 1.2, ky = 0.02, other = "2 kN" }
[conveyor.travel]
temperature_range = 50
thermal_expansion = 0.00012
splice_length = "6 m"
permanent_elongation = 0.002
[[conveyor.flight]]
name = "level"
length = "400 m"
lift = "2 m"
friction_factor = 0.021
carry_idler_mass = "17 kg/m"
return_idler_mass = "7 kg/m"
[[conveyor.flight]]
name = "ramp"
length = "200 m"
slope = "5.16 deg"
curve_radius = "300 m"
carry_spacing = "1.1 m"
return_spacing = "3.2 m"
[[conveyor.loading]]
name = "mine"
capacity = "600 t/h"
material_speed = "1 m/s"
skirt_width = "0.8 m"
acceleration_length = "2 m"
belt_friction = 0.5
skirt_friction = 0.6
density = "1600 kg/m3"
[[conveyor.loading]]
name = "plant"
position = "300 m"
material_mass = "40 kg/m"
[[conveyor.load_case]]
name = "heavy"
loaded = "inclines"
factor.ramp = 1.2
[[conveyor.drive]]
pulley = "head"
brake_share = 1.0
[[conveyor.resistance]]
kind = "pulley"
at = "tail"
diameter = "800 mm"
shaft_diameter = "140 mm"
wrap_angle = "180 deg"
mass = "900 kg"
[[conveyor.resistance]]
kind = "cleaner"
at = "return"
position = "20 m"
width = "1.1 m"
thickness = "8 mm"
pressure = "40 kPa"
friction = 0.6
count = 2
[[conveyor.resistance]]
kind = "skirt"
position = "5 m"
length = "4 m"
width = "0.8 m"
density = "1600 kg/m3"
friction = 0.6
[[conveyor.resistance]]
kind = "tilt"
strand = "return"
angle = "1.5 deg"
trough_coefficient = 0.4
friction = 0.3
length = "100 m"
[[conveyor.resistance]]
kind = "force"
force = "800 N"
""",
    )
)
CONVERTER = MOTORS.replace('kind = "induction"', 'kind = "converter"').replace(
    'synchronous_speed = "1500 rpm"\n',
    "setting = 1.0\ndroop = 0.01\ntorque_limit = 1.6\ngear_efficiency = 0.96\n"
    "motor_efficiency = 0.95\n",
)
COUPLED = MOTORS.replace('kind = "induction"', 'kind = "fluid-coupling"').replace(
    "gear_ratio", "coupling_load = [0, 1, 2]\ncoupling_slip = [0, 0.03, 0.2]\ngear_ratio"
)
INDUCTION = MOTORS.replace("gear_ratio", "breakdown_ratio = 2.5\ngear_ratio")
SHARED = TANDEM.replace('["50 %", "50 %"]', '["50 %", "50 %"]\ndiameters = ["790 mm", "800 mm"]')
CONTROLS = {
    "droop": 'kind = "droop", rated_torque = "14 kN m", droop = 0.01, lag = "0.1 s", '
    "torque_limit = 2.5",
    "speed-loop": 'kind = "speed-loop", bandwidth = 1.0, reset = "1 s", lag = "0.1 s"',
    "induction": 'kind = "induction", starting_ratio = 2.0, rated_slip = 0.01, '
    "breakdown_ratio = 2.5",
    "fluid-coupling": 'kind = "fluid-coupling", pump_inertia = "300 kg m2", coupling_slip = 0.03, '
    "coupling_limit = 1.8",
    "follower": 'kind = "follower", master = "one", ratio = 1.0, lag = "0.1 s", '
    'dead_time = "0.05 s", damping = 0.01',
}
IN_TIME = (
    MOTION.replace("carry_run", 'winch_speed = "0.1 m/s"\nlift_share = 0.3\ncarry_run')
    .replace(
        "[motion.drum.two]\n",
        '[motion.drum.two]\nbrake_torque = "20 kN m"\nrun = "3 m"\nmotor_inertia = "6 kg m2"\n'
        'gear_ratio = 20\ntrim = { gain = 0.5, filter_time = "5 s", dead_time = "0.5 s" }\n',
    )
    .replace('[{ kind = "load-step", at = "0.5 s", factor = 1.2 }]', "[]")
)
HAPPENS = (
    'kind = "start", time = "20 s", at = "0.5 s"', 'kind = "stop", time = "20 s"',
    'kind = "load-step", factor = 1.2, time = "2 s"',
    'kind = "wet-patch", length = "3 m", friction = 0.5',
    'kind = "splice", length = "2 m", rise = "1 mm", compliance = 1.5',
    'kind = "run-out", pulley = "one", run_out = "0.5 mm", order = 2',
    'kind = "lagging-joints", pulley = "one", joint_rise = "1 mm", joints = 4, '
    'joint_width = "40 mm"',
    'kind = "torque-ripple", pulley = "one", ripple = 0.02',
)  # fmt: skip
ONE = "is a part of the whole, and may be little of it"
SMALL = "as little as this is none of it"
#: Ends of key paths, where nothing sensible can be said of them, and why.
FREE = {
    r"conveyor\..*position$": ("down", SMALL),
    r"conveyor\.rest_friction": ("down", ONE),
    r"load_case\.factor": ("down", "a flight may be all but empty"),
    r"conveyor\.(lift|special_resistance|take_up_distance)": ("down", SMALL),
    r"across\.(misalignment|deflection|shell_profile|worn_depth|build_up)": ("down", SMALL),
    r"(overrun|rise|run_out|joint_rise|ripple|lag|damping|filter_time)$": ("down", SMALL),
    r"(return_share|lift_share)": ("down", ONE),
    r"cost\.(material|installation|life_years)": ("both", "prices are of any currency"),
    r"train\.effective_tension": ("down", "a train may idle"),
    r"motion\.drum\.two\.(motor_inertia|gear_ratio)$": ("down", "it adds little to the drum"),
    r"motion\.drum\.(one|two)\.inertia": ("down", "small drums have it"),
    r"motion\.return_run": ("up", "belts are that long"),
    r"law\.(stiffness|knots.peak_slip)": ("both", "up to a law of constant friction"),
    r"law\.knots\.(residual_friction|post_peak_slope)": ("down", "a floor that tests do not reach"),
    r"law\.(reference_pressure|exponent)": ("down", "it is the friction that is asked about"),
    r"happens\.factor": ("down", "a load may be taken away"),
}


def leaves(thing: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], Any]]:
    """Numbers of a document by their paths: plain ones, and texts that begin with one."""
    items = thing.items() if isinstance(thing, dict) else enumerate(thing)
    for key, value in items:
        if isinstance(value, dict | list):
            yield from leaves(value, (*path, key))
        elif re.match(r"-?\d+(\.\d+)?($| ?[a-zA-Z%])", str(value)):
            yield (*path, key), value


def scaled(document: Any, path: tuple[Any, ...], factor: float) -> Any:
    """The document with one number times a factor."""
    copy = deepcopy(document)
    node = copy
    for step in path[:-1]:
        node = node[step]
    value = node[path[-1]]
    if isinstance(value, str):
        number, unit = re.match(r"(-?\d+(?:\.\d+)?) ?(.*)", value).groups()  # type: ignore[union-attr]
        node[path[-1]] = f"{float(number) * factor:.12g} {unit}"
    else:
        node[path[-1]] = value * factor
    return copy


def asked(document: Any) -> bool:
    """Whether a drive of any kind is refused, or asked about for its sizes."""
    try:
        if "motion" in document:
            motion = motion_from_document(document)
            drive = unsolved_drive(motion.station.train)
            checks = [*usual_sizes(drive, *of_run(motion.station, motion.events[0]))]
        elif "train" in document:
            checks = [*before(train_from_document(document)).checks]
        else:
            drive = drive_from_document(document)
            assert isinstance(drive, Drive)
            checks = [*before(drive).checks]
    except InputError:
        return True
    return any(c.name == "usual_sizes" and c.missed for c in checks)


def documents() -> dict[str, Any]:
    texts = {
        "head": HEAD, "blocks": BLOCKS, **PULLS, "conveyor": BELT, "other conveyor": OTHER_BELT,
        "flights": FLIGHTS,
        "induction": INDUCTION, "converter": CONVERTER, "coupled": COUPLED, "shares": SHARED,
        **{
            f"control {name}": IN_TIME.replace("[]", f"[{{ {HAPPENS[0]} }}]").replace(
                "[motion.drum.two]\n", f"[motion.drum.two]\ncontrol = {{ {control} }}\n"
            )
            for name, control in CONTROLS.items()
        },
        **{
            f"event {number}": IN_TIME.replace("[]", f"[{{ {happens} }}]")
            for number, happens in enumerate(HAPPENS)
        },
    }  # fmt: skip
    return {name: tomllib.loads(text) for name, text in texts.items()} | LAW_DRIVES


DOCUMENTS = documents()


def named(path: tuple[Any, ...]) -> str:
    return ".".join(str(step) for step in path if not isinstance(step, int))


CASES = {
    (named(path), factor): (name, path)
    for name, document in reversed(DOCUMENTS.items())
    for path, _ in leaves(document)
    for factor in (1e3, 1e-3)
}


#: Keys of numbers that no document here has, and why.
ELSEWHERE = {
    "x": "the wrap angle that follows is asked about", "y": "the same",
    "friction_factor": "the friction that is left is asked about",
    "friction_factors": "the same", "slip_speed": "the friction that is left is asked about",
    "temperature": "the same", "format": "another format is refused",
    "factor": "of a profile: its heights are asked about", "strips": "a count with its own ends",
    "uncertainty": "of a profile: it widens an interval alone",
    "rows": "of a profile: its heights are asked about",
    "entry_profile": "a strip that goes slack or is overloaded is a check of its own",
    "count": "one to eight motors", "modulus_loads": "a percentage of 100 % at most",
    "continuity": "of pieces: a step that is larger is refused", "from": "of pieces: as tests",
    "to": "the same", "residual_noise": "written by fit", "covariance": "written by fit",
    "post_peak_slope": "the friction at the end of the tests is asked about",
    "coverage_factor": "written by fit", "values": "written by fit",
}  # fmt: skip


def numbers_in(kind: Kind, key: str, depth: int = 0) -> Iterator[str]:
    """Keys below a kind that hold numbers."""
    if isinstance(kind, Quantity | Count):
        yield key
    elif isinstance(kind, Table):
        for entry in kind.entries:
            yield from numbers_in(entry.kind, entry.key, depth + 1)
    elif depth < 12:
        for value in vars(kind).values():
            parts = value.values() if isinstance(value, dict) else value
            for part in (
                parts if isinstance(parts, list | tuple) or parts is not value else (value,)
            ):
                if isinstance(part, Kind):
                    yield from numbers_in(part, key, depth + 1)


@pytest.mark.parametrize("table", [DRIVE, TRAIN, MOTION_KEYS], ids=["drive", "train", "motion"])
def test_every_key_is_tried_or_stands_here_with_its_reason(table: Table) -> None:
    tried = {
        step for document in DOCUMENTS.values() for path, _ in leaves(document) for step in path
    }
    found = set(numbers_in(table, ""))
    assert len(found) > 5
    assert sorted(found - tried - set(ELSEWHERE)) == []


@pytest.mark.parametrize("name", DOCUMENTS)
def test_as_they_are_nothing_is_asked(name: str) -> None:
    assert not asked(DOCUMENTS[name])


@pytest.mark.parametrize(("key", "factor"), CASES, ids=[f"{k} {f:g}" for k, f in CASES])
def test_a_slip_of_unit_is_refused_or_asked_about(key: str, factor: float) -> None:
    name, path = CASES[key, factor]
    side = "up" if factor > 1.0 else "down"
    free = any(re.search(of, key) and where in (side, "both") for of, (where, _) in FREE.items())
    assert free or asked(scaled(DOCUMENTS[name], path, factor)), name


SEARCH = tomllib.loads("""
format = 1
drive = "drive.toml"
[candidates]
laggings = ["diamond-rubber"]
thicknesses = ["12 mm"]
diameters = ["800 mm"]
wrap_angles = ["190 deg"]
slack_tensions = ["75 kN"]
[limits]
creep = "8 mm"
bond_stress = "1 MPa"
creep_limit_margin = 1
tested_slip_margin = 1
gross_slip_safety = 1.25
rating_share.design = 1
sag = { idler_spacing = "3 m", line_mass = "22 kg/m", share = 0.02 }
[[condition]]
name = "wet"
friction_factor = 0.8
[cost]
currency = "AUD"
years = 10
hours.design = 6000
face_width = "1.3 m"
lagging.diamond-rubber = { material = 9, installation = 9, area = "3 m2", life_years = [3, 6] }
""")
#: Of a choose file, likewise: ends, and why.
FREE_IN_SEARCH = {
    r"(material|installation|hours)": ("both", "prices are of any currency, hours of any plant"),
    r"limits\.(creep|bond_stress|rating_share)": (
        "up",
        "it does not hold here, and the drive's does",
    ),
    r"limits\.sag": ("down", "it asks for nothing"),
    r"cost\.(years|face_width)": ("both", "between what its limits allow"),
    r"condition\.friction_factor": ("", ""),
}


@pytest.mark.parametrize(
    ("path", "factor"),
    [(path, factor) for path, _ in leaves(SEARCH) for factor in (1e3, 1e-3) if path != ("format",)],
    ids=lambda of: named(of) if isinstance(of, tuple) else f"{of:g}",
)
def test_a_slip_of_unit_in_a_choose_file_is_no_bare_ok(
    path: tuple[Any, ...], factor: float, tmp_path: Path
) -> None:
    (tmp_path / "drive.toml").write_text(BASE, "utf-8")
    side = "up" if factor > 1.0 else "down"
    free = FREE_IN_SEARCH.items()
    if any(re.search(of, named(path)) and where in (side, "both") for of, (where, _) in free):
        return
    try:
        search = search_from_document(scaled(SEARCH, path, factor), folder=str(tmp_path))
    except InputError:
        return
    told = choose_sheet(choose(search)).verdict
    assert told is not None
    assert told.level is not Level.OK


#: Usual values of keys of other files, and why one that is a thousand times off is taken by its
#: kind; those of drives in it are asked about above, as designs are.
OTHERS = {
    "sample_area": "0.04 m2", "stress_area": "0.04 m2", "pressure": "100 kPa",
    "normal_force": "4 kN", "transition_pressure": "200 kPa", "largest_lash": "3 mm",
    "thickness": "12 mm", "roughness": "0.3 mm", "slip_max": "20 mm", "peak_slip": "9 mm",
    "lash": "0.5 mm", "cover_thickness": "5 mm", "least_friction": 0.02, "most_friction": 3.0,
    "peak_friction": 0.7, "faces": 2, "friction_factor": 0.8, "share": 0.5,
    "cover_shear_modulus": "1 MPa", "shear_modulus": "2.3 MPa", "elastic_modulus": "6.9 MPa",
    "compression_modulus": "9.8 MPa", "speed": "10 mm/min", "temperature": "293 K",
    "zero": "5 N", "drum_speed": "3.05 m/s", "belt_speed": "3 m/s", "entry_tension": "120 kN",
    "exit_tension": "75 kN",     "diameter": "1 mm", "pitch_offset": "1 mm",
    "geometric_standard_deviation": 1.1, "samples": 1000,
}  # fmt: skip
TAKEN = {
    **dict.fromkeys(
        ("zero", "drum_speed", "belt_speed", "entry_tension", "exit_tension", "roughness", "lash",
         "peak_slip", "peak_friction", "least_friction", "most_friction", "slip_max",
         "stress_area", "largest_lash", "speed", "cover_shear_modulus", "transition_pressure"),
        "the results tell: a curve, a test or a fit that does not follow is said",
    ),
    **dict.fromkeys(
        ("thickness", "shear_modulus", "elastic_modulus", "compression_modulus"),
        "a drive of that lagging asks",
    ),
    **dict.fromkeys(("diameter", "pitch_offset"), "an error that is little is none"),
    "temperature": "told beside the tests, and in no number",
    "friction_factor": "the friction that is left slides, or is told",
    "geometric_standard_deviation": "the spread is told",
    "cover_thickness": "0 mm where nothing shears", "share": "shares sum to one",
}  # fmt: skip
COUNTS = {
    "faces",
    "table",
    "block",
    "order",
    "pieces",
    "count",
    "seed",
    "samples",
    "points",
    "format",
}


def kinds_in(kind: Kind, key: str, depth: int = 0) -> Iterator[tuple[str, Quantity]]:
    """Quantities below a kind with their keys."""
    if isinstance(kind, Quantity):
        yield key, kind
    elif isinstance(kind, Table):
        for entry in kind.entries:
            yield from kinds_in(entry.kind, entry.key, depth + 1)
    elif depth < 12:
        for part in vars(kind).values():
            for one in part if isinstance(part, list | tuple) else (part,):
                if isinstance(one, Kind):
                    yield from kinds_in(one, key, depth + 1)


@pytest.mark.parametrize("table", [PLAN, CALIBRATE, STUDY, EVENT_STUDY], ids=lambda t: t.title)
def test_keys_of_other_files_are_refused_or_stand_here_with_their_reason(table: Table) -> None:
    for key, kind in kinds_in(table, ""):
        if key in COUNTS or isinstance(kind, Percent):  # a part that is little is none
            continue
        usual_value = OTHERS[key]
        assert kind.read(usual_value, (key,), Report()) is not NOTHING
        for factor in (1e3, 1e-3):
            value = scaled({"key": usual_value}, ("key",), factor)["key"]
            refused = kind.read(value, (key,), Report()) is NOTHING
            assert refused or key in TAKEN, (key, value)


#: What is asked about at ten times as much already: ratios, and what hardly differs between drives.
TENFOLD = (
    "belt.width", "belt.speed", "belt.momentary_factor", "belt.pulley_cover", "belt.carry_cover",
    "belt.carcass", "belt.cord_diameter", "belt.cord_pitch",
    "belt.cover_shear_modulus", "belt.mass", "belt.strength", "pulley.diameter",
    "take_up.sheave_ratio", "design_standard.friction", "design_standard.start_factor",
    "safety_factor.running", "safety_factor.starting", "safety_factor.braking",
    "sag.idler_spacing", "sag.share", "lagging.plain.law.friction",
    "lagging.plain.condition_factor.factor", "pulley.across.before.length",
    "train.motor.one.rated_power", "train.motor.one.rated_speed",
    "train.motor.one.gear_ratio", "train.motor.one.setting",
    "train.motor.one.gear_efficiency", "train.motor.one.motor_efficiency",
    "train.motor.one.torque_limit", "train.motor.one.breakdown_ratio",
    "conveyor.belt_mass", "conveyor.carry_idler_mass", "conveyor.return_idler_mass",
    "conveyor.friction_factor", "conveyor.length_coefficient", "conveyor.start_factor",
    "motion.drum.two.control.coupling_slip", "motion.drum.two.control.starting_ratio",
    "motion.event.happens.friction", "motion.event.happens.factor",
)  # fmt: skip


@pytest.mark.parametrize("key", TENFOLD)
def test_ten_times_as_much_is_refused_or_asked_about(key: str) -> None:
    name, path = CASES[key, 1e3]
    assert asked(scaled(DOCUMENTS[name], path, 10.0))


@pytest.mark.parametrize("key", ["belt_mass", "carry_idler_mass", "return_idler_mass"])
def test_a_tenth_of_the_masses_of_a_conveyor_is_asked_about(key: str) -> None:
    """2.2 kg/m of belt, 1.2 m wide, is less than the lightest cover: T1 would come out too low."""
    name, path = CASES[f"conveyor.{key}", 1e-3]
    assert asked(scaled(DOCUMENTS[name], path, 0.1))
