"""Drives made to fail in one way each, and the words that stand in the first two lines of answers.

A row is a drive file, changed from one that keeps its checks, with the words that its headline must
and must not have. Every door that is named in a row answers; its first two lines are looked at.
Where doors show the same headline by the same function, one of them is asked on every row and the
others on a few. Rows are added here; `test_rows.py` reads them.
"""

from dataclasses import dataclass

BASE = """\
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
entry_tension = "120 kN"
exit_tension = "75 kN"
[design_standard]
name = "CEMA"
"""
PLAIN = """
[lagging.plain]
thickness = "3 mm"
shear_modulus = "2.3 MPa"
surface = "rubber"
law = { kind = "constant", friction = 0.5 }
"""
TANDEM = """\
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
[[pulley]]
name = "one"
diameter = "800 mm"
wrap_angle = "190 deg"
lagging = "diamond-rubber"
[[pulley]]
name = "two"
diameter = "800 mm"
wrap_angle = "200 deg"
lagging = "diamond-rubber"
[train]
exit_tension = "70 kN"
effective_tension = "60 kN"
share = ["50 %", "50 %"]
"""


CONVEYOR = BASE.replace(
    'entry_tension = "120 kN"\nexit_tension = "75 kN"\n',
    """[conveyor]
length = "600 m"
lift = "20 m"
capacity = "1000 t/h"
belt_mass = "22 kg/m"
carry_idler_mass = "16 kg/m"
return_idler_mass = "6 kg/m"
take_up_tension = "40 kN"
""",
)
TURNED = """
[[load_case]]
name = "stop"
kind = "braking"
pulley.head.entry_tension = "{entry}"
pulley.head.exit_tension = "{exit}"
[take_up]
kind = "gravity"
"""
STOPPED = (("800 mm", "1000 mm"), ("180 deg", "200 deg"), ("600 m", "300 m"), ('"20 m"', '"5 m"'))
BARE = """
[lagging.bare]
thickness = "0 mm"
surface = "bare"
law = { kind = "constant", friction = 0.15 }
"""
MOTORS = TANDEM.replace(
    'share = ["50 %", "50 %"]',
    'diameters = ["800 mm", "800 mm"]'
    + "".join(
        f"""
[train.motor.{name}]
kind = "induction"
rated_power = "110 kW"
synchronous_speed = "1500 rpm"
rated_speed = "1480 rpm"
gear_ratio = 20.67"""
        for name in ("one", "two")
    ),
)
#: Drives in time; the event is changed.
MOTION = (
    TANDEM
    + """
[motion]
conveyor_mass = "100 t"
carry_run = "50 m"
return_run = "20 m"
[motion.drum.one]
inertia = "2200 kg m2"
[motion.drum.two]
inertia = "2200 kg m2"
[[motion.event]]
name = "start"
duration = "4 s"
happens = [{ kind = "load-step", at = "0.5 s", factor = 1.2 }]
"""
)
HAPPENS = 'kind = "load-step", at = "0.5 s", factor = 1.2'
PLAIN_TENSIONS = 'entry_tension = "120 kN"\nexit_tension = "75 kN"\n'
START = """[[load_case]]
name = "start"
kind = "starting"
pulley.head.entry_tension = "{}"
[design_standard]"""


SHEAVES = '[take_up]\nkind = "gravity"\nsheave_ratio = 20\n[design_standard]'


@dataclass(frozen=True)
class Row:
    """A drive and what its answers say.

    Attributes
    ----------
    name
        In what way it fails.
    changes
        Texts of the drive file and what stands there instead; an empty one is added at its end.
    must, must_not
        Words of the first two lines.
    doors
        Names of `DOORS` whose answers are looked at.
    base
        The file that is changed.
    level
        Word that the answer begins with.
    """

    name: str
    changes: tuple[tuple[str, str], ...]
    must: tuple[str, ...]
    must_not: tuple[str, ...] = ()
    doors: tuple[str, ...] = ("solve",)
    base: str = BASE
    level: str = ""

    @property
    def text(self) -> str:
        """The drive file."""
        text = self.base
        for old, new in self.changes:
            if old and old not in text:
                raise AssertionError(f"{self.name}: the file has no {old!r}")
            text = text.replace(old, new) if old else text + new
        return text


#: Arguments of a door, FILE standing for the drive, PLAN and SEARCH for files beside it, NOTE for
#: what is written; the page answers by itself.
DOORS = {
    "solve": ("solve", "FILE"),
    "what-if": ("what-if", "FILE", "--thickness", "18 mm"),
    "trim": ("trim", "FILE", "--points", "5"),
    "field": ("field", "FILE"),
    "run": ("run", "FILE", "--quiet", "--points", "20"),
    "stability": ("stability", "FILE"),
    "choose": ("choose", "SEARCH"),
    "study": ("study", "PLAN", "-o", "ROWS"),
    "note": ("report", "FILE", "-o", "NOTE"),
    "page": (),
}
#: Doors that lead with the headline of `solve`.
ALIKE = ("solve", "note", "page")
PLAN = """\
format = 1
drive = "drive.toml"
[[axis]]
field = "pulley.head.exit_tension"
values = ["{slack}", "{slack}1"]
"""
SEARCH = """\
format = 1
drive = "drive.toml"
[candidates]
laggings = ["diamond-rubber", "full-ceramic"]
wrap_angles = ["180 deg", "210 deg"]
slack_tensions = ["20 kN", "40 kN", "75 kN"]
[cost]
currency = "AUD"
tariff = 0.2
hours.design = 6000
"""


def tensions(entry: str, leaving: str) -> tuple[tuple[str, str], ...]:
    """Return other tensions of the base."""
    return (("120 kN", entry), ("75 kN", leaving))


def event(happens: str, duration: str = "4 s") -> tuple[tuple[str, str], ...]:
    """Return another event of `MOTION`."""
    return ((HAPPENS, happens), ('"4 s"', f'"{duration}"'))


#: An empty belt as the first load case, a full one behind it.
EMPTY_FIRST = (
    (PLAIN_TENSIONS, ""),
    ("", "".join(
        f'[[load_case]]\nname = "{name}"\npulley.head.entry_tension = "{entry}"\n'
        'pulley.head.exit_tension = "75 kN"\n'
        for name, entry in (("empty", "90 kN"), ("full", "170 kN"))
    )),
)  # fmt: skip
EMPTY_FIRST_TRAIN = (
    ('exit_tension = "70 kN"\neffective_tension = "60 kN"\n', ""),
    ("[motion]\n", "".join(
        f'[[load_case]]\nname = "{name}"\ntrain.exit_tension = "70 kN"\n'
        f'train.effective_tension = "{pull}"\n'
        for name, pull in (("empty", "15 kN"), ("full", "130 kN"))
    ) + "[motion]\n"),
)  # fmt: skip
ROWS = (
    Row("keeps its checks, computed dry", (),
        ("OK", "All 10 checks pass.",
         "Closest: wet creep (estimated) 3.65 of 6.35 mm (head, design)."),
        ("dry", "exceeds"), ALIKE, level="OK"),
    Row("creeps a little more than allowed", tensions("150 kN", "60 kN"),
        ("Creep 7.49 mm exceeds the 6.35 mm limit (head, design).",), ("OK", "ross slip"), ALIKE,
        level="ATTENTION"),
    Row("creeps seven times the limit, three times the tested slip", tensions("150 kN", "10 kN"),
        ("Tested friction transmits 0.584 times Te, minimum 1.25", "Creep 43.6 mm"),
        ("allow", "Raise T2", "OK"),
        ("solve", "what-if"), level="ATTENTION"),
    Row("no creep carries the pull", (*tensions("180 kN", "1 kN"),),
        ("Gross slip: safety 0.0995 is below 1 (head, design).",), ("safety 1 ",),
        level="FAILS"),
    Row("at the edge of what friction ever carries",
        (*tensions("450 kN", "200 kN"), ("800 mm", "500 mm"),
         ("Plylon Plus 1000/4", "Flexsteel ST5000")),
        ("Gross slip: safety 0.575 is below 1 (head, design).",), ("safety 1 ",), level="FAILS"),
    Row("the belt is overloaded", tensions("280 kN", "240 kN"),
        ("Belt tension 280 kN exceeds the 210 kN rating (head, design).",), ("Raise T2",),
        ALIKE, level="FAILS"),
    Row("a belt of no rating, at more than 15 % of its strength",
        (*tensions("420 kN", "300 kN"), ("800 mm", "1250 mm"),
         ('preset = "Plylon Plus 1000/4"',
          'name = "ST2000"\nkind = "steel cord"\nmodulus = "144000 kN/m"')),
        ("Belt safety factor 5.71 is below the 6.67 minimum (head, design).",), ("OK",),
        ALIKE, level="ATTENTION"),
    Row("a start of the same belt", (*event('kind = "start", time = "5 s"', "8 s"),
        ("60 kN", "110 kN"), ("70 kN", "160 kN"), ("800 mm", "1250 mm"),
        ('preset = "Plylon Plus 1000/4"',
         'name = "ST2000"\nkind = "steel cord"\nmodulus = "144000 kN/m"')),
        ("Belt safety factor 6.01 is below the 6.67 minimum (one, entry, start, 2.24 s).",),
        ("OK",), ("run",), base=MOTION),
    Row("below the standard", (*tensions("60 kN", "16.4 kN"), ('"CEMA"', '"CEMA"\nbinding = true')),
        ("T2 16.4 kN is below the CEMA minimum 21.8 kN (head, design).",), ("OK",), ALIKE,
        level="FAILS"),
    Row("the pulley is too small for its belt", (("Plylon Plus 1000/4", "Flexsteel ST5000"),
                                                ("800 mm", "1000 mm")),
        ("Pulley diameter 1000 mm is below the belt minimum 1800 mm (head).",), ("OK",),
        level="FAILS"),
    Row("pressed beyond the tests", (*tensions("205 kN", "180 kN"), ("800 mm", "400 mm")),
        ("Wrap pressure 854 kPa exceeds the tested 690 kPa (head, design).",), ("Raise T2",),
        level="ATTENTION"),
    Row("pressed less than tested", tensions("24 kN", "14 kN"),
        ("Wrap pressure 29.2 kPa is below the tested 34 kPa (head, design).",), ("Lower T2",),
        level="ATTENTION"),
    Row("the wet drive creeps, the dry one does not",
        (*tensions("145 kN", "72 kN"), ("format = 1", 'format = 1\ncondition = ["dry", "wet"]')),
        ("Creep 6.66 mm exceeds the 6.35 mm limit (head, design, wet).",), ("OK",),
        level="ATTENTION"),
    Row("asked wet alone", (("format = 1", 'format = 1\ncondition = "wet"'),),
        ("diamond-rubber not tested wet: dry friction times 0.824 used (head, design).",), ("OK",),
        level="ATTENTION"),
    Row("constant friction slides on a thin lagging",
        (*tensions("150 kN", "34 kN"), ('"diamond-rubber"', '"plain"'), ("", PLAIN),
         ("diameter", 'creep_limit = "20 mm"\ndiameter')),
        ("Gross-slip safety 1.11 is below the 1.25 minimum (head, design).",), ("OK",),
        level="ATTENTION"),
    Row("a belt so soft that it slides by its own stretch",
        (*tensions("150 kN", "50 kN"), ('preset = "Plylon Plus 1000/4"', 'modulus = "60 kN/m"'),
         ('"diamond-rubber"', '"plain"'), ("", PLAIN)),
        ("Gross slip: safety 0.257 is below 1 (head, design).",), ("OK",), level="FAILS"),
    Row("the drives share as they are told", (),
        ("OK", "Equal load sharing at trim ", "Set trim to ", "for ±5 % load share."),
        ("FAILS",), ("trim",), base=TANDEM),
    Row("one drive carries more", (("50 %\", \"50 %", "70 %\", \"30 %"),),
        ("ATTENTION Load share of two is 30 %, equal share 50 % (design).", "Set trim from "), (),
        ("trim",), base=TANDEM),
    Row("the drum that carries less is the one that creeps more",
        (("190 deg", "240 deg"), ("200 deg", "150 deg"), ("50 %\", \"50 %", "75 %\", \"25 %"),
         ("70 kN", "30 kN"), ("60 kN", "130 kN")),
        ("ATTENTION Load share of two is 25 %, equal share 50 % (design).",
         "Leave trim at ", ": equal sharing at ", " raises creep from "),
        ("Set trim",), ("trim",), base=TANDEM),
    Row("a small snub pulley that nothing drives",
        (("Plylon Plus 1000/4", "Flexsteel ST1000"), ("800 mm", "1000 mm"),
         ("exit_tension = \"75 kN\"\n", "exit_tension = \"75 kN\"\n[[pulley]]\nname = \"snub\"\n"
          "diameter = \"500 mm\"\nwrap_angle = \"30 deg\"\nlagging = \"diamond-rubber\"\n"
          "entry_tension = \"75 kN\"\nexit_tension = \"75 kN\"\n")),
        ("OK",), ("snub",), ("solve", "note"), level="OK"),
    Row("the empty belt stands first, what-if", EMPTY_FIRST,
        ("Creep 7.36 mm exceeds the 6.35 mm limit (head, full).",), ("0.850 mm",), ("what-if",),
        level="ATTENTION"),
    Row("a start creeps too much, what-if",
        ((PLAIN_TENSIONS, PLAIN_TENSIONS.replace("120 kN", "110 kN")),
         ("[design_standard]", START.format("165 kN"))),
        ("Creep 6.88 mm exceeds the 6.35 mm limit (head, start).",), ("2.64 mm",), ("what-if",),
        level="ATTENTION"),
    Row("the empty belt stands first, trim", EMPTY_FIRST_TRAIN,
        ("Equal load sharing at trim 99.574 % (two, full).",), ("99.946",), ("trim",), base=MOTION),
    Row("the empty belt stands first, run",
        (*EMPTY_FIRST_TRAIN, *event('kind = "start", time = "40 s"', "45 s")),
        ("Belt tension 234 kN exceeds the 210 kN rating (one, entry, start, 7.88 s).",), ("OK",),
        ("run",), base=MOTION, level="FAILS"),
    Row("a wet patch that grips better than the dry belt",
        event('kind = "wet-patch", length = "3 m", friction = 1.5'),
        ("Friction of event start 1.5 is outside the usual 0.02 to 1.",), ("OK",), ("run",),
        base=MOTION,
        level="ATTENTION"),
    Row("a belt of a tenth of its mass", (("22 kg/m", "2.2 kg/m"),),
        ("Conveyor belt mass 2.2 kg/m is outside the usual 3.6 to 120 kg/m.",), ("OK",),
        ("solve", "note"),
        base=CONVEYOR, level="ATTENTION"),
    Row("motors ten times too large", (("110 kW", "1100 kW"),),
        ("Motor power over required power 12.2 is outside the usual 0 to 6.", "rated_power"),
        ("OK",), ("solve", "note"),
        base=MOTORS, level="ATTENTION"),
    Row("drives that fight", (("50 %\", \"50 %", "130 %\", \"-30 %"),),
        ("Drives oppose each other by 18 kN (design).", "Set every load share above 0 %."), ("OK",),
        ("solve",), base=TANDEM, level="ATTENTION"),
    # 40 kN at 3 m/s is 120 kW a drum, of motors of 110 kW
    Row("every motor is too small", (("60 kN", "80 kN"),),
        ("Motor torque 117 % exceeds the 100 % rating (two, design).",
         "Use motors of 129 kW or more (now 110 kW)."), ("OK", "torque sharing"),
        base=MOTORS, level="FAILS"),
    Row("drums of two diameters that turn alike",
        (('share = ["50 %", "50 %"]', 'speeds = "equal"'), ("60 kN", "100 kN"), ("70 kN", "45 kN"),
         ('name = "two"\ndiameter = "800 mm"', 'name = "two"\ndiameter = "830 mm"'),
         ("diamond-rubber", "full-ceramic")),
        ("Drives oppose each other by 281 kN (design).", "torque sharing or closer speeds"),
        ("OK", "Use a belt"),
        base=TANDEM, level="FAILS"),
    Row("motors that cannot hold back",
        (("1480 rpm\"", "1480 rpm\"\nbrakes = false"), ('"60 kN"', '"-60 kN"'),
         ("70 kN", "140 kN")),
        ("The belt drives the motors: no operating point (one, design).", "Set brakes = true"),
        ("OK",),
        base=MOTORS,
        level="FAILS"),
    Row("shares that fight", (("50 %\", \"50 %", "120 %\", \"-20 %"),),
        ("Drives oppose each other by 12 kN (design).", "Set every load share above 0 %."),
        ("OK", "speeds"), base=TANDEM,
        level="ATTENTION"),
    Row("a tandem too slack", (("70 kN", "20 kN"), ("60 kN", "90 kN")),
        ("two",), ("FAILS",), ("solve",), base=TANDEM),
    Row("take-up that holds nothing alike",
        (("[design_standard]", '[[load_case]]\nname = "empty"\npulley.head.entry_tension = '
          '"60 kN"\npulley.head.exit_tension = "30 kN"\n[take_up]\nkind = "gravity"\n'
          "[design_standard]"),),
        ("Gravity take-up needs equal T2: empty has 30 kN, design has 75 kN.",), ("OK",),
        level="ATTENTION"),
    Row("a take-up that keeps its tension in drive and stop",
        (("", TURNED.format(entry="50 kN", exit="75 kN")),),
        ("OK",), ("take-up",), ("solve", "page")),
    Row("a stop that the least tension of driving leaves slack",
        (("120 kN", "76 kN"), ("75 kN", "41.2 kN"),
         ("", TURNED.format(entry="16.2 kN", exit="41.2 kN"))),
        ("Wrap pressure 33.75 kPa is below the tested 34 kPa (head, stop).",), ("OK",),
        ("solve", "page")),
    Row("the least take-up tension of a stop",
        (("120 kN", "76 kN"), ("75 kN", "41.4 kN"),
         ("", TURNED.format(entry="16.4 kN", exit="41.4 kN"))),
        ("OK",), (), ("solve", "page")),
    Row("a choice that a stop leaves slack at less",
        (("", TURNED.format(entry="57 kN", exit="75 kN")),),
        ("wrap 180 deg with tension at the take-up behind pulley head 40 kN,",), (),
        ("choose",)),
    Row("a tandem whose take-up keeps its tension in drive and stop",
        (("", '[[load_case]]\nname = "stop"\nkind = "braking"\ntrain.effective_tension = "-40 kN"\n'
          '[take_up]\nkind = "gravity"\n'),),
        ("OK",), ("take-up",), base=TANDEM),
    Row("a conveyor with the counterweight that its stop needs",
        (*STOPPED, ('take_up_tension = "40 kN"',
                    'counterweight = "6615 kg"\nstart_time = "15 s"\nstop_time = "5 s"')),
        ("OK",), (), ("solve", "page"), base=CONVEYOR),
    Row("a conveyor with less than that",
        (*STOPPED, ('take_up_tension = "40 kN"',
                    'counterweight = "6545 kg"\nstart_time = "15 s"\nstop_time = "5 s"')),
        ("Wrap pressure 33.5 kPa is below the tested 34 kPa (head, stop).",), ("OK",),
        ("solve", "page"),
        base=CONVEYOR),
    Row("a tail drive with its take-up beside it, as told",
        (*STOPPED[:2], ('"20 m"', '"-60 m"'),
         ('"40 kN"', '"29.7 kN"\ndrive_at = "tail"\ntake_up_distance = "600 m"')),
        ("OK",), (), ("solve", "page"), base=CONVEYOR),
    Row("a tail drive with less",
        (*STOPPED[:2], ('"20 m"', '"-60 m"'),
         ('"40 kN"', '"29.5 kN"\ndrive_at = "tail"\ntake_up_distance = "600 m"')),
        ("Wrap pressure 33.7 kPa is below the tested 34 kPa (head, empty).",), ("OK",),
        ("solve", "page"),
        base=CONVEYOR),
    Row("sags", (("[design_standard]", '[sag]\nidler_spacing = "3 m"\nline_mass = "450 kg/m"\n'
                  "[design_standard]"),),
        ("Slack-side tension 75 kN is below the 82.8 kN for 2 % sag (head, design).",),
        ("OK", "Lower T2"), level="ATTENTION"),
    # wet
    Row("the dry drive creeps too much when wet", tensions("135 kN", "62 kN"),
        ("Wet creep 7.11 mm (estimated) exceeds the 6.35 mm limit (head, design).",),
        ("OK", "All"), ALIKE,
        level="ATTENTION"),
    Row("the dry drive slips through when wet",
        (*tensions("100 kN", "70 kN"), ('"diamond-rubber"', '"bare"'), ("", BARE)),
        ("Gross slip when wet, with dry friction times ",), ("OK", "All"), level="ATTENTION"),
    Row("a covered drive that would creep too much when wet",
        (*tensions("135 kN", "62 kN"), ("format = 1", "format = 1\ncovered = true")),
        ("OK", "All 9"), ("wet", "Wet", "dry"), ALIKE, level="OK"),
    Row("nothing is known of the friction when wet",
        (('"CEMA"', '"none"'), ('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace('surface = "rubber"\n', ""))),
        ("OK (dry)",), ("Wet creep",), ALIKE, level="OK"),
    Row("another question about a drive that was computed dry", tensions("135 kN", "62 kN"),
        ("ATTENTION", "Wet creep 7.11 mm (estimated) exceeds the 6.35 mm limit"), ("OK",),
        ("what-if",)),
    Row("levels of speed from a drive that was computed dry",
        (*tensions("135 kN", "62 kN"), ("speed", 'pulley_cover = "4 mm"\ncarcass = "6 mm"\nspeed')),
        ("ATTENTION", "Wet creep 7.27 mm (estimated) exceeds the 6.35 mm limit"), ("OK",),
        ("field",)),
    Row("levels of speed from a belt of unknown thickness", tensions("135 kN", "62 kN"),
        ("ATTENTION", "Normal speed difference up to 0.733 %",
         "Give pulley_cover, carry_cover and carcass: "),
        ("OK",), ("field",)),
    Row("wet and dirty", (("format = 1", 'format = 1\ncondition = ["dry", "wet and dirty"]'),),
        ("diamond-rubber not tested wet and dirty: dry friction times 0.647 (",), ("OK",),
        ("solve", "page"), level="ATTENTION"),
    # sizes
    Row("a wrap that no drive pulley has", (("180 deg", "30 deg"), *tensions("80 kN", "77 kN")),
        ("Wrap 30 deg is outside the usual 120 to 270 deg (head).",), ("OK",), level="ATTENTION"),
    Row("wraps of two pulleys added up", (("180 deg", "420 deg"),),
        ("Wrap 420 deg exceeds 270 deg on one pulley (head).", "Give each pulley its own wrap."),
        ("OK",), level="ATTENTION"),
    Row("radians read as degrees", (("180 deg", "3.3 deg"), *tensions("76 kN", "75.9 kN")),
        ("Wrap 3.3 deg is outside the usual 120 to 270 deg (head).", ": 3.3 rad?"), ("OK",),
        level="ATTENTION"),
    Row("a creep limit of a quarter of a metre",
        (("diameter", 'creep_limit = "250 mm"\ndiameter'),),
        ("Creep limit 250 mm is outside the usual 0.5 to 61 mm (head).", ": 25 mm"), ("OK",),
        level="ATTENTION"),
    Row("the rating typed as the modulus",
        (('preset = "Plylon Plus 1000/4"', 'modulus = "1000 kN/m"\nrating = "1000 kN/m"'),),
        ("Creep 9.30 mm", "Belt modulus over rating 1 is outside the usual 15 to 1000."), ("OK",),
        level="ATTENTION"),
    # EP 630/4 breaks at 630 kN/m and is rated a tenth of it; modulus over rating is 70 to 120
    Row("the strength of a fabric belt typed as its rating",
        (*tensions("200 kN", "110 kN"), ('preset = "Plylon Plus 1000/4"',
         'name = "EP 630/4"\nkind = "fabric"\nmodulus = "10000 kN/m"\nrating = "630 kN/m"')),
        ("Belt safety factor 3.78 is below the 8 minimum (head, design).",
         "Belt strength over rating 1 is outside the usual 4 to 20."), ("OK",),
        ALIKE, level="ATTENTION"),
    Row("the strength typed as the rating, the modulus right",
        (('preset = "Plylon Plus 1000/4"',
          'name = "EP1000/4"\nkind = "fabric"\nmodulus = "12960 kN/m"\nrating = "1000 kN/m"'),),
        ("Belt strength over rating 1 is outside the usual 4 to 20.",
         "Check belt.strength and belt.rating: both per width."), ("OK", "modulus"),
         level="ATTENTION"),
    Row("the strength typed as the rating, of a belt whose name tells none",
        (('preset = "Plylon Plus 1000/4"',
          'kind = "fabric"\nmodulus = "12960 kN/m"\nrating = "1000 kN/m"'),),
        ("Belt modulus over rating 12.96 is outside the usual 15 to 1000.",
         "Check belt.modulus and belt.rating: both per width."), ("OK",), level="ATTENTION"),
    Row("a strength below the tension, and a rating above it",
        (*tensions("200 kN", "120 kN"), ('preset = "Plylon Plus 1000/4"',
         'name = "X"\nkind = "fabric"\nmodulus = "16200 kN/m"\nrating = "175 kN/m"\n'
         'strength = "100 kN/m"')),
        ("Belt safety factor 0.6 is below the 8 minimum (head, design).",
         "Belt strength over rating 0.571 is outside the usual 4 to 20."), ("OK",),
        ALIKE, level="FAILS"),
    Row("the rating of the whole width typed as that per width",
        (('preset = "Plylon Plus 1000/4"\nwidth = "1200 mm"\nspeed = "3 m/s"',
          'name = "ST1000"\nkind = "steel cord"\nmodulus = "72000 kN/m"\nrating = "300 kN/m"\n'
          'width = "2 m"\nspeed = "4 m/s"'), ("180 deg", "210 deg"), ("800 mm", "1 m"),
         ("diamond-rubber", "full-ceramic"), *tensions("440 kN", "90 kN")),
        ("Belt safety factor 4.55 is below the 6.67 minimum (head, design).",
         "Belt strength over rating 3.33 is outside the usual 4 to 20."), ("OK",),
        ALIKE, level="ATTENTION"),
    Row("watts for kilowatts", (('entry_tension = "120 kN"', 'power = "160 W"'),),
        ("Power 0.16 kW is outside the usual 0.25 to 20000 kW (head, design).", ": 160 kW"),
        ("OK",), level="ATTENTION"),
    Row("a lagging of centimetres",
        (('"diamond-rubber"', '"plain"'), ("", PLAIN.replace("3 mm", "12 cm"))),
        ("Lagging thickness 120 mm is outside the usual 0 to 60 mm (head).", ": 12 mm"),
        ("OK",), level="ATTENTION"),
    Row("a width of inches times five", (("1200 mm", "240 in"),),
        ("Wrap pressure 30.8 kPa", "Belt width 6096 mm is outside the usual 200 to 4000 mm."),
        ("OK",), level="ATTENTION"),
    Row("a speed of metres a minute", (("3 m/s", "300 m/s"),),
        ("Belt speed 300 m/s is outside the usual 0.05 to 15 m/s.", "300 m/min"), ("OK",),
        level="ATTENTION"),
    Row("a pulley too small for the rating of its belt", (("800 mm", "200 mm"),),
        ("Creep 10.9 mm", "Wrap pressure at the belt rating 1750 kPa is outside the usual"),
        ("OK", "Raise"), level="ATTENTION"),
    Row("an overrun that no lagging makes", (("diameter", 'overrun = "4 mm"\ndiameter'),),
        ("Overrun 4 mm is outside the usual -2 to 2 mm (head).",), ("OK",), level="ATTENTION"),
    Row("an odd size hides behind gross slip", (("180 deg", "3.14 deg"),),
        ("Gross slip: safety 0.0544 is below 1 (head, design).",
         "Wrap 3.14 deg is outside the usual 120 to 270 deg (head)."),
        ("OK",), level="FAILS"),
    Row("a sheave ratio of twenty",
        (("[design_standard]", SHEAVES),),
        ("Sheave ratio of the take-up 20 is outside the usual 0.2 to 8.", ": 2?"), ("OK",),
        ALIKE, level="ATTENTION"),
    Row("a belt that may bear ten times its rating",
        (("width", "momentary_factor = 10\nwidth"),),
        ("Momentary factor of the belt 10 is outside the usual 1 to 2.", ": 1?"), ("OK",),
        level="ATTENTION"),
    Row("a cover of hundredths of a millimetre",
        (("speed", 'pulley_cover = "0.05 mm"\ncarry_cover = "4 mm"\ncarcass = "6 mm"\nspeed'),),
        ("Pulley cover of the belt 0.05 mm is outside the usual 0.4 to 25 mm.",), ("OK",),
        level="ATTENTION"),
    Row("a rule of its own that asks for hardly anything",
        (('"CEMA"', '"own"\nfriction = 1.5'),),
        ("Friction of the design standard 1.5 is outside the usual 0.1 to 0.9.", ": 0.15?"),
        ("OK",), level="ATTENTION"),
    Row("friction of five", (('"diamond-rubber"', '"plain"'),
                             ("", PLAIN.replace("friction = 0.5", "friction = 5.0"))),
        ("Friction of lagging plain 5 is outside the usual 0.03 to 1.9.", ": 0.5?"), ("OK",),
        level="ATTENTION"),
    Row("friction of five in a study", (('"diamond-rubber"', '"plain"'),
                                        ("", PLAIN.replace("friction = 0.5", "friction = 5.0"))),
        ("governing: an implausible input.", "ATTENTION"), ("OK",), ("study",)),
    Row("a sheave ratio of twenty in a search", (("[design_standard]", SHEAVES),),
        ("ATTENTION", "Sheave ratio of the take-up 20 is outside the usual 0.2 to 8."), ("OK",),
        ("choose",)),
    Row("more friction wet than dry",
        (('"diamond-rubber"', '"plain"'), ("format = 1", 'format = 1\ncondition = ["dry", "wet"]'),
         ("", PLAIN.replace("surface", 'condition_factor = [{ condition = "wet", factor = 9, '
                            'provenance = { kind = "given" } }]\nsurface'))),
        ("plain not tested wet: dry friction times 9 used (head, design, wet).",
         "Factor on the friction of plain, wet 9 is outside the usual 0.05 to 1.3."), ("OK",),
         level="ATTENTION"),
    Row("wear of thousands of cubic millimetres",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'wear_coefficient = "5000 mm3/J"\nsurface'))),
        ("Wear coefficient of plain 5000 mm3/J is outside the usual 0.0001 to 0.1 mm3/J.",),
        ("OK",), level="ATTENTION"),
    # vendors: 4e-4 to 8e-4 mm3/J
    Row("wear of cubic millimetres",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'wear_coefficient = "5 mm3/J"\nsurface'))),
        ("Wear coefficient of plain 5 mm3/J is outside the usual 0.0001 to 0.1 mm3/J.",), ("OK",),
        level="ATTENTION"),
    Row("a creep limit of a quarter of an inch in millimetres",
        (("diameter", 'creep_limit = "0.25 mm"\ndiameter'),),
        ("Creep limit 0.25 mm is outside the usual 0.5 to 61 mm (head).",), ("OK",),
        ("solve", "page"),
        level="ATTENTION"),
    Row("an overrun of half a centimetre", (("diameter", 'overrun = "5 mm"\ndiameter'),),
        ("Overrun 5 mm is outside the usual -2 to 2 mm (head).", "0.5 mm?"), ("OK", "0.005 mm"),
        level="ATTENTION"),
    Row("a creep limit of centimetres", (("diameter", 'creep_limit = "6.35 cm"\ndiameter'),),
        ("Creep limit 63.5 mm is outside the usual 0.5 to 61 mm (head).", ": 6.35 mm"), ("OK",),
        level="ATTENTION"),
    Row("nothing is pulled", tensions("75 kN", "75 kN"), ("All 8 checks pass.",), (),
        level="OK"),
    Row("a pulley of grams", (("diameter", 'mass = "900 g"\ndiameter'),),
        ("Pulley mass 0.9 kg is outside the usual 94.7 to 7100 kg (head).", ": 900 kg"),
        ("OK",), level="ATTENTION"),
    # conveyors
    Row("a start of four times the pull", (("lift", "start_factor = 4\nlift"),),
        ("Tested friction transmits 0.867 times Te, minimum 1.1 (head, start).",
         "Creep 19.3 mm"), ("OK",), base=CONVEYOR,
        level="ATTENTION"),
    Row("a conveyor that keeps its checks", (), ("OK",), (), ALIKE, base=CONVEYOR,
        level="OK"),
    Row("a belt of grams", (("22 kg/m", "22 g/m"),),
        ("Conveyor belt mass 0.022 kg/m is outside the usual 3.6 to 120 kg/m.",), ("OK",),
        ALIKE, base=CONVEYOR, level="ATTENTION"),
    Row("idlers of grams", (("16 kg/m", "16 g/m"),),
        ("Conveyor carry idler mass 0.016 kg/m is outside the usual", ": 16 kg/m"), ("OK",),
        base=CONVEYOR, level="ATTENTION"),
    Row("a capacity of kilograms an hour", (("1000 t/h", "100 kg/h"),),
        ("Conveyor capacity 0.1 t/h is outside the usual", ": 100 t/h"), ("OK",),
        base=CONVEYOR, level="ATTENTION"),
    Row("a start of minutes", (("lift", 'start_time = "20 min"\nlift'),),
        ("Conveyor start time 1200 s is outside the usual 1 to 600 s.", ": 20 s"), ("OK",),
        base=CONVEYOR, level="ATTENTION"),
    Row("a conveyor that brakes", (('"20 m"', '"-60 m"'),),
        ("Creep 6.41 mm exceeds the 6.35 mm limit (head, full).", "Slack-side tension T1"),
        ("OK",), base=CONVEYOR, level="ATTENTION"),
    Row("a resistance of newtons", (("lift", 'special_resistance = "1.5 N"\nlift'),),
        ("Conveyor special resistance 0.0015 kN is outside the usual", ": 1.5 kN"), ("OK",),
        base=CONVEYOR, level="ATTENTION"),
    Row("steeper than any belt", (('"20 m"', '"360 m"'), ("1000 t/h", "100 t/h"),
                                  ('"40 kN"', '"120 kN"')),
        ("Conveyor lift over length 0.6 is outside the usual -0.5 to 0.5.",), ("OK",),
        base=CONVEYOR, level="ATTENTION"),
    Row("heaped beyond its trough", (("3 m/s", "0.2 m/s"), ("600 m", "100 m"), ('"20 m"', '"2 m"'),
                                     ('"40 kN"', '"120 kN"')),
        ("Material per length of belt 1390 kg/m is outside the usual",), ("OK",), base=CONVEYOR,
        level="ATTENTION"),
    # belt, lagging, standard
    Row("it brakes", tensions("70 kN", "110 kN"), ("OK", "All 10 checks pass."),
        (), ("solve", "page"), level="OK"),
    Row("overloaded while starting", (("[design_standard]", START.format("270 kN")),),
        ("Belt tension 270 kN exceeds the 210 kN rating (head, start).", "Also ATTENTION:"),
        ("OK", "Raise"),
        level="FAILS"),
    Row("creeps while starting alone", (("[design_standard]", START.format("200 kN")),),
        ("Creep 10.4 mm exceeds the 6.35 mm limit (head, start).",), ("OK",), ("solve", "page"),
        level="ATTENTION"),
    Row("the standard says nothing on this wrap",
        (("180 deg", "170 deg"), ("", 'binding = true\n[take_up]\nkind = "fixed"\n')),
        ("CEMA does not apply: wrap 170 deg, manual take-up factors from 180 deg",),
        ("OK", "surface"), ("solve", "page"),
        level="FAILS"),
    Row("below a rule of its own", (*tensions("76 kN", "30 kN"),
                                    ('"CEMA"', '"own"\nfriction = 0.2\nbinding = true')),
        ("T2 30 kN is below the design standard minimum 52.7 kN (head, design).",), ("OK",),
        level="FAILS"),
    Row("a safety factor that no tension gives", (("", "[safety_factor]\nrunning = 5\n"),),
        ("Tested friction transmits 3.76 times Te, minimum 5 (head, design).",),
        ("OK", "Raise"), ("solve", "page"), level="ATTENTION"),
    Row("a start that is judged as running",
        (("[design_standard]", START.replace('kind = "starting"\n', "").format("130 kN")),),
        ("Load case start is judged as running.", 'Set kind = "starting" in load case start.'),
        ("OK", "(start"), ("solve", "page", "note"), level="ATTENTION"),
    Row("the bond gives way",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'bond_strength = "40 kPa"\nsurface'))),
        ("Bond shear stress 108 kPa exceeds the strength 40 kPa (head, design).",), ("OK",),
        level="ATTENTION"),
    Row("the lagging tires",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'fatigue_limit = "40 kPa"\nsurface'))),
        ("Cyclic shear stress 108 kPa exceeds the fatigue limit 40 kPa (head, design).",), ("OK",),
        level="ATTENTION"),
    Row("the face presses too hard",
        (('1000/4"', '1000/4"\nlargest_wrap_pressure = "200 kPa"'),),
        ("Face pressure 250 kPa exceeds the belt limit 200 kPa (head, design).",), ("OK",),
        ("solve", "page"),
        level="ATTENTION"),
    Row("other questions about a bond that gives way",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'bond_strength = "40 kPa"\nsurface'))),
        ("ATTENTION", "Bond shear stress 108 kPa exceeds the strength 40 kPa (head, design)."),
        ("OK",), ("what-if", "field")),
    # several drives
    Row("motors overloaded", (('["800 mm"', '["786 mm"'),),
        ("Motor torque 141 % exceeds the 100 % rating (two, design).",), ("OK",),
        ("solve", "note"), base=MOTORS,
        level="FAILS"),
    Row("the trim of overloaded motors", (('["800 mm"', '["786 mm"'),),
        ("FAILS", "Load share of two is 86.4 %",
         "Motor torque 141 % exceeds the 100 % rating"), ("OK",),
        ("trim",),
        base=MOTORS),
    Row("motors of watts", (("110 kW", "110 W"),),
        ("Motor torque ", "%, the end of its curve (one, design)."), ("OK",), base=MOTORS,
        level="FAILS"),
    Row("a gear of ten to one too few", (("20.67", "2.067"),),
        ("Motor torque ", "%, the end of its curve (one, design).", "Check gear_ratio"),
        ("OK",), ("solve", "trim"), base=MOTORS, level="FAILS"),
    Row("a gear of a thousand times", (("20.67", "2067"),),
        ("Pulley speed 30.0 mm/s does not match belt speed 3 m/s (one).", "gear_ratio"), ("OK",),
        base=MOTORS,
        level="ATTENTION"),
    Row("drums that turn ten times as fast as their belt",
        (('share = ["50 %", "50 %"]', 'speeds = ["716 rpm", "714 rpm"]'),),
        ("Pulley speed 30.0 m/s does not match belt speed 3 m/s (one).",), ("OK",), base=TANDEM,
        level="ATTENTION"),
    # 985 rpm over 20.7 turns a drum of 0.8 m at 1.99 m/s; 100 rpm at 4.19 m/s
    Row("motors that turn the drums slower than the belt is given",
        (("1500 rpm", "1000 rpm"), ("1480 rpm", "985 rpm")),
        ("Pulley speed 2.00 m/s does not match belt speed 3 m/s (one).",), ("OK",),
        ("solve", "note"), base=MOTORS, level="ATTENTION"),
    Row("motors of 60 Hz on gears for 50 Hz",
        (("1500 rpm", "1800 rpm"), ("1480 rpm", "1780 rpm")),
        ("Motor torque 106 % exceeds the 100 % rating (two, design).",
         "Pulley speed 3.61 m/s does not match belt speed 3 m/s (one)."),
        ("OK",), base=MOTORS, level="ATTENTION"),
    Row("speeds of drums that are not that of the belt",
        (('share = ["50 %", "50 %"]', 'speeds = ["100 rpm", "99.7 rpm"]'),),
        ("Pulley speed 4.19 m/s does not match belt speed 3 m/s (one).",), ("OK",),
        ("solve", "note"), base=TANDEM,
        level="ATTENTION"),
    Row("motors that waste all they take",
        (("gear_ratio", "motor_efficiency = 0.05\ngear_ratio"),),
        ("Motor efficiency of the motor of pulley one 0.05 is outside the usual", ": 0.5?"),
        ("OK",),
        base=MOTORS, level="ATTENTION"),
    Row("drums in the wrong order",
        (("[train]\n", ""), ('effective_tension = "60 kN"\nshare = ["50 %", "50 %"]\n', ""),
         ('exit_tension = "70 kN"\n', ""),
         ('name = "one"', 'name = "one"\nentry_tension = "130 kN"\nexit_tension = "90 kN"'),
         ('name = "two"', 'name = "two"\nentry_tension = "170 kN"\nexit_tension = "130 kN"')),
        ("Belt leaves one at 90 kN but enters two at 170 kN (two, design).",), ("OK",), base=TANDEM,
        level="ATTENTION"),
    Row("a gear of twice the speed", (("20.67", "41.34"),),
        ("Pulley speed 1.50 m/s does not match belt speed 3 m/s (one).",), ("OK",), base=MOTORS,
        level="ATTENTION"),
    Row("the trim under an overloaded belt", (("70 kN", "160 kN"),),
        ("FAILS", "Equal load sharing at trim ",
         "Belt tension 220 kN exceeds the 210 kN rating (one"),
        ("OK",),
        ("trim",), base=TANDEM),
    Row("the trim of drives that slip when wet",
        (("70 kN", "60 kN"), ("60 kN", "25 kN"), ('"diamond-rubber"', '"bare"'), ("", BARE)),
        ("ATTENTION", "Equal load sharing at trim ", "Gross slip when wet, with dry "), ("OK",),
        ("trim",),
        base=TANDEM),
    Row("the trim of drives that fight", (('50 %", "50 %', '130 %", "-30 %'),),
        ("ATTENTION", "Load share of two is -30 %, equal share 50 %",
         "Drives oppose each other by 18 kN (design)."),
        ("OK",), ("trim",),
        base=TANDEM),
    # in time
    Row("an event that keeps its checks", (),
        ("OK", "Closest: belt tension 152 of 210 kN (one, entry, start, 2.31 s)."), (), ("run",),
        base=MOTION),
    Row("a start too hard", event('kind = "start", time = "9 s"'),
        ("FAILS", "Belt tension 219 kN exceeds the 210 kN rating (one, entry, start, 3.09 s)."),
        ("OK",), ("run",), base=MOTION),
    Row("a long wet patch", event('kind = "wet-patch", at = "0.5 s", length = "30 m", '
                                  "friction = 0.05"),
        ("FAILS", "Gross slip: creep 261 mm exceeds 63.5 mm (one, start, 4.00 s)."), ("OK",),
        ("run",), base=MOTION),
    Row("a short wet patch on a slack belt",
        (*event('kind = "wet-patch", at = "0.5 s", length = "3 m", friction = 0.3', "3 s"),
         ("70 kN", "20 kN"), ("60 kN", "90 kN")),
        ("ATTENTION", "Creep 19.1 mm exceeds the 6.35 mm limit (two, start, 2.78 s)."), ("OK",),
        ("run",), base=MOTION),
    Row("the belt goes slack in an emergency",
        (*event('kind = "emergency-stop", at = "0.5 s"', "2 s"),
         ('"2200 kg m2"', '"2200 kg m2"\nbrake_torque = "60 kN m"')),
        ("FAILS", "Belt goes slack before one at 0.7731 s (start)."), ("OK",), ("run",),
        base=MOTION),
    Row("motors too small for a load step",
        (*event('kind = "load-step", at = "0.5 s", factor = 1.6', "3 s"),
         ('"2200 kg m2"', '"2200 kg m2"\ncontrol = { kind = "droop", rated_torque = "8 kN m" }')),
        ("FAILS", "Motor torque 250 % exceeds the 100 % rating (one, start)."), ("OK",), ("run",),
        base=MOTION),
    Row("a start not followed to its end", event('kind = "start", time = "20 s"', "4 s"),
        ("ATTENTION", "Belt speed 0.115 m/s at the end, not 3 m/s (start)."), ("OK",), ("run",),
        base=MOTION),
    Row("a mass of kilograms", (("100 t", "100 kg"), ('"4 s"', '"1 s"')),
        ("ATTENTION", "Te over the weight of conveyor_mass 88.7 is outside the usual 0 to 1.2."),
        ("OK",), ("run",), base=MOTION),
    Row("a run of millimetres", (('"50 m"', '"50 mm"'), ('"4 s"', '"1 s"')),
        ("ATTENTION", "Carry run 50 mm is outside the usual 500 mm to 30000 m.", ": 50 m"),
        ("OK",), ("run",), base=MOTION),
    Row("a gear ratio of ten times",  # 8 kg m2 at 250^2: 31 times the 100 t at the belt
        (('"2200 kg m2"', '"800 kg m2"\nmotor_inertia = "8 kg m2"\ngear_ratio = 250'),
         ('"4 s"', '"1 s"')),
        ("ATTENTION", "Inertia at the belt over conveyor_mass 62.6 is outside the usual",
         "gear_ratio"), ("OK",), ("run",), base=MOTION),
    Row("an inertia of tonnes", (('"2200 kg m2"', '"2200 t m2"'), ('"4 s"', '"1 s"')),
        ("ATTENTION", "Inertia of pulley one 2200000 kg m2 is outside", "2200 kg m2?"), ("OK",),
        ("run",), base=MOTION),
    Row("what happens when nobody looks any more",
        event('kind = "load-step", at = "500 s", factor = 1.6', "1 s"),
        ("ATTENTION", "Event start starts at 500 s, after the end 1 s.", "Give an earlier time."),
        ("OK",),        ("run",), base=MOTION),
    Row("a run-out of centimetres",
        event('kind = "run-out", pulley = "two", run_out = "2 cm"', "1 s"),
        ("ATTENTION", "Run out of event start 20 mm is outside the usual -10 to 10 mm."), ("OK",),
        ("run",), base=MOTION),
    Row("a step of the load of drives below their standard",
        (*event('kind = "load-step", factor = 1.02', "4 s"), ("70 kN", "10 kN"),
         ('"diamond-rubber"', '"plain"'), ("", PLAIN + '[design_standard]\nname = "CEMA"\n')),
        ("ATTENTION", "T2 10 kN is below the CEMA minimum 12.6 kN (two, design)."), ("OK",),
        ("run",), base=MOTION),
    Row("vibrations of drives below their standard",
        (("70 kN", "10 kN"), ('"diamond-rubber"', '"plain"'),
         ("", PLAIN + '[design_standard]\nname = "CEMA"\n')),
        ("ATTENTION", "T2 10 kN is below the CEMA minimum 12.6 kN (two, design)."), ("OK",),
        ("stability",),
        base=MOTION),
    Row("vibrations of drives under an overloaded belt", (("70 kN", "160 kN"),),
        ("FAILS", "Belt tension 220 kN exceeds the 210 kN rating (one, design)."), ("OK",),
        ("stability",),
        base=MOTION),
    # selection and studies
    Row("the cheapest has more wrap and tension for nothing", (),
        ("OK", "Lowest cost: full-ceramic, wrap 180 deg with T2 20 kN,"),
        ("210 deg",), ("choose",)),
    Row("every candidate is below the standard", (("", '[take_up]\nkind = "fixed"\n'),
                                                  ("120 kN", "245 kN"), ("75 kN", "130 kN")),
        ("ATTENTION", "Lowest cost", "T2 40 kN is below the CEMA minimum 92 kN"), ("OK",),
        ("choose",)),
    Row("a study of a drive computed dry", (), ("OK All ", " designs pass."), ("dry",),
        ("study",)),
    Row("a study without the load case that fails",
        (("[design_standard]", START.format("290 kN")),),
        ("OK, load case design only", " pass."), (), ("study",)),
    Row("a study of tensions that no take-up holds",
        (("[design_standard]", '[take_up]\nkind = "fixed"\n\n' + START.format("150 kN")),),
        ("OK", "tensions that its take-up does not fix"), (), ("study",)),
    Row("a study of an overloaded belt", tensions("290 kN", "240 kN"),
        ("FAILS All ", " fail; governing: the rating of the belt."), ("OK",), ("study",)),
    Row("a study of a bond that gives way",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'bond_strength = "40 kPa"\nsurface'))),
        ("ATTENTION", "governing: the bond strength of the lagging."), ("OK",), ("study",)),
)  # fmt: skip
