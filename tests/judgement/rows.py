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
    Row("keeps its checks, computed dry", (), ("OK",),
        ("dry only", "exceeds"), ALIKE, level="OK"),
    Row("creeps a little more than allowed", tensions("150 kN", "60 kN"),
        ("Creeps", "6.35 mm", "up to 12.7 mm"), ("OK", "gross slip,"), ALIKE,
        level="ATTENTION"),
    Row("creeps seven times the limit, three times the tested slip", tensions("150 kN", "10 kN"),
        ("43.6 mm",), ("larger limit", "may allow", "Raise the slack-side", "OK"),
        ("solve", "what-if"), level="ATTENTION"),
    Row("no creep carries the pull", (*tensions("180 kN", "1 kN"),),
        ("no creep carries the pull", "leaves the tests"), ("at 1 times", "at most 1 times"),
        level="FAILS"),
    Row("at the edge of what friction ever carries",
        (*tensions("450 kN", "200 kN"), ("800 mm", "500 mm"),
         ("Plylon Plus 1000/4", "Flexsteel ST5000")),
        ("no creep carries the pull",), ("at 1 times", "2.25"), level="FAILS"),
    Row("the belt is overloaded", tensions("280 kN", "240 kN"),
        ("The belt tension 280 kN", "210 kN"), ("Raise the slack-side",),
        ALIKE, level="FAILS"),
    Row("a belt of no rating, at more than 15 % of its strength",
        (*tensions("420 kN", "300 kN"), ("800 mm", "1250 mm"),
         ('preset = "Plylon Plus 1000/4"',
          'name = "ST2000"\nkind = "steel cord"\nmodulus = "144000 kN/m"')),
        ("strength of the belt is 5.71 times its tension", "below 6.67 times"), ("OK",),
        ALIKE, level="ATTENTION"),
    Row("a start of the same belt", (*event('kind = "start", time = "5 s"', "8 s"),
        ("60 kN", "110 kN"), ("70 kN", "160 kN"), ("800 mm", "1250 mm"),
        ('preset = "Plylon Plus 1000/4"',
         'name = "ST2000"\nkind = "steel cord"\nmodulus = "144000 kN/m"')),
        ("strength of the belt is",), ("OK",), ("run",), base=MOTION),
    Row("below the standard", (*tensions("60 kN", "16.4 kN"), ('"CEMA"', '"CEMA"\nbinding = true')),
        ("below the", "CEMA"), ("OK",), ALIKE, level="FAILS"),
    Row("the pulley is too small for its belt", (("Plylon Plus 1000/4", "Flexsteel ST5000"),
                                                ("800 mm", "1000 mm")),
        ("smaller than the least for its belt",), ("OK",), level="FAILS"),
    Row("pressed beyond the tests", (*tensions("205 kN", "180 kN"), ("800 mm", "400 mm")),
        ("above the 690 kPa",), ("Raise the slack-side",), level="ATTENTION"),
    Row("pressed less than tested", tensions("24 kN", "14 kN"),
        ("below the 34 kPa",), ("Lower the",), level="ATTENTION"),
    Row("the wet drive creeps, the dry one does not",
        (*tensions("145 kN", "72 kN"), ("format = 1", 'format = 1\ncondition = ["dry", "wet"]')),
        ("wet", "Creeps"), ("dry only",), level="ATTENTION"),
    Row("asked wet alone", (("format = 1", 'format = 1\ncondition = "wet"'),),
        ("was not tested wet",), ("dry only",), level="ATTENTION"),
    Row("constant friction slides on a thin lagging",
        (*tensions("150 kN", "34 kN"), ('"diamond-rubber"', '"plain"'), ("", PLAIN),
         ("diameter", 'creep_limit = "20 mm"\ndiameter')),
        ("The belt slides (creep of 63.5 mm)", "1.25"), ("OK",),
        level="ATTENTION"),
    Row("a belt so soft that it slides by its own stretch",
        (*tensions("150 kN", "50 kN"), ('preset = "Plylon Plus 1000/4"', 'modulus = "60 kN/m"'),
         ('"diamond-rubber"', '"plain"'), ("", PLAIN)),
        ("The belt slides (creep of 63.5 mm)",), ("OK",), level="FAILS"),
    Row("the drives share as they are told", (), ("Keep two at a trim of", "hold it within"),
        ("FAILS",), ("trim",), base=TANDEM),
    Row("one drive carries more", (("50 %\", \"50 %", "70 %\", \"30 %"),),
        ("Set two to a trim of", "in the place of"), (), ("trim",), base=TANDEM),
    Row("the drum that carries less is the one that creeps more",
        (("190 deg", "240 deg"), ("200 deg", "150 deg"), ("50 %\", \"50 %", "75 %\", \"25 %"),
         ("70 kN", "30 kN"), ("60 kN", "130 kN")),
        ("two equalises the load at a trim of", "but the largest creep then rises from",
         "over its limit"),
        ("Set two",), ("trim",), base=TANDEM),
    Row("a small snub pulley that nothing drives",
        (("Plylon Plus 1000/4", "Flexsteel ST1000"), ("800 mm", "1000 mm"),
         ("exit_tension = \"75 kN\"\n", "exit_tension = \"75 kN\"\n[[pulley]]\nname = \"snub\"\n"
          "diameter = \"500 mm\"\nwrap_angle = \"30 deg\"\nlagging = \"diamond-rubber\"\n"
          "entry_tension = \"75 kN\"\nexit_tension = \"75 kN\"\n")),
        ("OK",), ("snub",), ("solve", "note"), level="OK"),
    Row("the empty belt stands first, what-if", EMPTY_FIRST,
        ("load case full", "7.36 mm"), ("0.850 mm",), ("what-if",), level="ATTENTION"),
    Row("a start creeps too much, what-if",
        ((PLAIN_TENSIONS, PLAIN_TENSIONS.replace("120 kN", "110 kN")),
         ("[design_standard]", START.format("165 kN"))),
        ("load case start", "6.88 mm"), ("2.64 mm",), ("what-if",), level="ATTENTION"),
    Row("the empty belt stands first, trim", EMPTY_FIRST_TRAIN,
        ("99.574 %", "load case full"), ("99.946",), ("trim",), base=MOTION),
    Row("the empty belt stands first, run",
        (*EMPTY_FIRST_TRAIN, *event('kind = "start", time = "40 s"', "45 s")),
        ("more than the belt allows, 210 kN",), ("OK",), ("run",), base=MOTION, level="FAILS"),
    Row("a wet patch that grips better than the dry belt",
        event('kind = "wet-patch", length = "3 m", friction = 1.5'),
        ("Unusual friction", "1.5"), ("OK",), ("run",), base=MOTION,
        level="ATTENTION"),
    Row("a belt of a tenth of its mass", (("22 kg/m", "2.2 kg/m"),),
        ("Unusual belt mass of the conveyor, 2.2 kg/m",), ("OK",), ("solve", "note"),
        base=CONVEYOR, level="ATTENTION"),
    Row("motors ten times too large", (("110 kW", "1100 kW"),),
        ("rated power of the motors", "Is 1.22 meant?"), ("OK",), ("solve", "note"),
        base=MOTORS, level="ATTENTION"),
    Row("drives that fight", (("50 %\", \"50 %", "130 %\", \"-30 %"),),
        ("work against each other",), ("OK",), ("solve",), base=TANDEM, level="ATTENTION"),
    # 40 kN at 3 m/s is 120 kW a drum, of motors of 110 kW
    Row("every motor is too small", (("60 kN", "80 kN"),),
        ("rated torque", "Take larger motors: no other division"), ("OK", "Divide the load"),
        base=MOTORS, level="FAILS"),
    Row("drums of two diameters that turn alike",
        (('share = ["50 %", "50 %"]', 'speeds = "equal"'), ("60 kN", "100 kN"), ("70 kN", "45 kN"),
         ('name = "two"\ndiameter = "800 mm"', 'name = "two"\ndiameter = "830 mm"'),
         ("diamond-rubber", "full-ceramic")),
        ("work against each other with", "Bring their speeds closer"), ("OK", "stronger belt"),
        base=TANDEM, level="FAILS"),
    Row("motors that cannot hold back",
        (("1480 rpm\"", "1480 rpm\"\nbrakes = false"), ('"60 kN"', '"-60 kN"'),
         ("70 kN", "140 kN")),
        ("No operating point", "it cannot hold back", "Set brakes = true"), ("OK",), base=MOTORS,
        level="FAILS"),
    Row("shares that fight", (("50 %\", \"50 %", "120 %\", \"-20 %"),),
        ("work against each other", "Correct the shares"), ("OK", "speeds"), base=TANDEM,
        level="ATTENTION"),
    Row("a tandem too slack", (("70 kN", "20 kN"), ("60 kN", "90 kN")),
        ("two",), ("FAILS",), ("solve",), base=TANDEM),
    Row("take-up that holds nothing alike",
        (("[design_standard]", '[[load_case]]\nname = "empty"\npulley.head.entry_tension = '
          '"60 kN"\npulley.head.exit_tension = "30 kN"\n[take_up]\nkind = "gravity"\n'
          "[design_standard]"),),
        ("gravity take-up holds",), ("OK",), level="ATTENTION"),
    Row("a take-up that keeps its tension in drive and stop",
        (("", TURNED.format(entry="50 kN", exit="75 kN")),),
        ("OK",), ("take-up holds",), ("solve", "page")),
    Row("a stop that the least tension of driving leaves slack",
        (("120 kN", "76 kN"), ("75 kN", "41.2 kN"),
         ("", TURNED.format(entry="16.2 kN", exit="41.2 kN"))),
        ("ATTENTION", "load case stop", "33.75 kPa"), ("OK",), ("solve", "page")),
    Row("the least take-up tension of a stop",
        (("120 kN", "76 kN"), ("75 kN", "41.4 kN"),
         ("", TURNED.format(entry="16.4 kN", exit="41.4 kN"))),
        ("OK",), (), ("solve", "page")),
    Row("a choice that a stop leaves slack at less",
        (("", TURNED.format(entry="57 kN", exit="75 kN")),),
        ("wrap 180 deg with a tension at the take-up behind pulley head of 40 kN",), (),
        ("choose",)),
    Row("a tandem whose take-up keeps its tension in drive and stop",
        (("", '[[load_case]]\nname = "stop"\nkind = "braking"\ntrain.effective_tension = "-40 kN"\n'
          '[take_up]\nkind = "gravity"\n'),),
        ("OK",), ("take-up holds",), base=TANDEM),
    Row("a conveyor with the counterweight that its stop needs",
        (*STOPPED, ('take_up_tension = "40 kN"',
                    'counterweight = "6615 kg"\nstart_time = "15 s"\nstop_time = "5 s"')),
        ("OK",), (), ("solve", "page"), base=CONVEYOR),
    Row("a conveyor with less than that",
        (*STOPPED, ('take_up_tension = "40 kN"',
                    'counterweight = "6545 kg"\nstart_time = "15 s"\nstop_time = "5 s"')),
        ("ATTENTION", "load case stop", "wrap pressure"), ("OK",), ("solve", "page"),
        base=CONVEYOR),
    Row("a tail drive with its take-up beside it, as told",
        (*STOPPED[:2], ('"20 m"', '"-60 m"'),
         ('"40 kN"', '"29.7 kN"\ndrive_at = "tail"\ntake_up_distance = "600 m"')),
        ("OK",), (), ("solve", "page"), base=CONVEYOR),
    Row("a tail drive with less",
        (*STOPPED[:2], ('"20 m"', '"-60 m"'),
         ('"40 kN"', '"29.5 kN"\ndrive_at = "tail"\ntake_up_distance = "600 m"')),
        ("ATTENTION", "load case empty", "wrap pressure"), ("OK",), ("solve", "page"),
        base=CONVEYOR),
    Row("sags", (("[design_standard]", '[sag]\nidler_spacing = "3 m"\nline_mass = "450 kg/m"\n'
                  "[design_standard]"),),
        ("sags more",), ("OK", "Lower the"), level="ATTENTION"),
    # wet
    Row("the dry drive creeps too much when wet", tensions("135 kN", "62 kN"),
        ("Wet creep 7.11", "(estimated) exceeds the 6.35", "covered = true"), ("OK", "All"), ALIKE,
        level="ATTENTION"),
    Row("the dry drive slips through when wet",
        (*tensions("100 kN", "70 kN"), ('"diamond-rubber"', '"bare"'), ("", BARE)),
        ("Gross slip when wet (estimated)",), ("OK", "All"), level="ATTENTION"),
    Row("a covered drive that would creep too much when wet",
        (*tensions("135 kN", "62 kN"), ("format = 1", "format = 1\ncovered = true")),
        ("OK", "All 9"), ("wet", "Wet", "dry"), ALIKE, level="OK"),
    Row("nothing is known of the friction when wet",
        (('"CEMA"', '"none"'), ('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace('surface = "rubber"\n', ""))),
        ("OK (dry)",), ("Wet creep",), ALIKE, level="OK"),
    Row("another question about a drive that was computed dry", tensions("135 kN", "62 kN"),
        ("ATTENTION", "over creep limit wet"), ("OK",),
        ("what-if",)),
    Row("levels of speed from a drive that was computed dry",
        (*tensions("135 kN", "62 kN"), ("speed", 'pulley_cover = "4 mm"\ncarcass = "6 mm"\nspeed')),
        ("ATTENTION", "over creep limit wet"), ("OK",), ("field",)),
    Row("levels of speed from a belt of unknown thickness", tensions("135 kN", "62 kN"),
        ("ATTENTION", "between drum and belt"), ("OK",), ("field",)),
    Row("wet and dirty", (("format = 1", 'format = 1\ncondition = ["dry", "wet and dirty"]'),),
        ("was not tested wet and dirty",), ("OK",), ("solve", "page"), level="ATTENTION"),
    # sizes
    Row("a wrap that no drive pulley has", (("180 deg", "30 deg"), *tensions("80 kN", "77 kN")),
        ("30 deg", "120 deg to 270 deg", "snub"), ("OK",), level="ATTENTION"),
    Row("wraps of two pulleys added up", (("180 deg", "420 deg"),),
        ("420 deg", "sum of two pulleys"), ("OK",), level="ATTENTION"),
    Row("radians read as degrees", (("180 deg", "3.3 deg"), *tensions("76 kN", "75.9 kN")),
        ("3.3 rad?",), ("snub", "OK"), level="ATTENTION"),
    Row("a creep limit of a quarter of a metre",
        (("diameter", 'creep_limit = "250 mm"\ndiameter'),),
        ("creep limit", "250 mm", "25 mm"), ("OK",), level="ATTENTION"),
    Row("the rating typed as the modulus",
        (('preset = "Plylon Plus 1000/4"', 'modulus = "1000 kN/m"\nrating = "1000 kN/m"'),),
        ("rating or the strength given as the modulus",), ("OK",), level="ATTENTION"),
    # EP 630/4 breaks at 630 kN/m and is rated a tenth of it; modulus over rating is 70 to 120
    Row("the strength of a fabric belt typed as its rating",
        (*tensions("200 kN", "110 kN"), ('preset = "Plylon Plus 1000/4"',
         'name = "EP 630/4"\nkind = "fabric"\nmodulus = "10000 kN/m"\nrating = "630 kN/m"')),
        ("strength over the rating of the belt, 1; ", "Is the rating the strength?"), ("OK",),
        ALIKE, level="ATTENTION"),
    Row("the strength typed as the rating, the modulus right",
        (('preset = "Plylon Plus 1000/4"',
          'name = "EP1000/4"\nkind = "fabric"\nmodulus = "12960 kN/m"\nrating = "1000 kN/m"'),),
        ("Is the rating the strength?",), ("OK", "modulus"), level="ATTENTION"),
    Row("the strength typed as the rating, of a belt whose name tells none",
        (('preset = "Plylon Plus 1000/4"',
          'kind = "fabric"\nmodulus = "12960 kN/m"\nrating = "1000 kN/m"'),),
        ("Is the strength given as the rating, or as the modulus?",), ("OK",), level="ATTENTION"),
    Row("a strength below the tension, and a rating above it",
        (*tensions("200 kN", "120 kN"), ('preset = "Plylon Plus 1000/4"',
         'name = "X"\nkind = "fabric"\nmodulus = "16200 kN/m"\nrating = "175 kN/m"\n'
         'strength = "100 kN/m"')),
        ("strength of the belt is 0.6 times its tension", "8 times", "over the rating"), ("OK",),
        ALIKE, level="FAILS"),
    Row("the rating of the whole width typed as that per width",
        (('preset = "Plylon Plus 1000/4"\nwidth = "1200 mm"\nspeed = "3 m/s"',
          'name = "ST1000"\nkind = "steel cord"\nmodulus = "72000 kN/m"\nrating = "300 kN/m"\n'
          'width = "2 m"\nspeed = "4 m/s"'), ("180 deg", "210 deg"), ("800 mm", "1 m"),
         ("diamond-rubber", "full-ceramic"), *tensions("440 kN", "90 kN")),
        ("4.55 times its tension", "6.67 times", "Is the rating that of the whole width?"), ("OK",),
        ALIKE, level="ATTENTION"),
    Row("watts for kilowatts", (('entry_tension = "120 kN"', 'power = "160 W"'),),
        ("0.16 kW", "160 kW"), ("OK",), level="ATTENTION"),
    Row("a lagging of centimetres",
        (('"diamond-rubber"', '"plain"'), ("", PLAIN.replace("3 mm", "12 cm"))),
        ("thickness of lagging plain, 120 mm", "12 mm"), ("OK",), level="ATTENTION"),
    Row("a width of inches times forty", (("1200 mm", "1200 in"),),
        ("width of the belt, 30.48 m",), ("OK",), level="ATTENTION"),
    Row("a speed of metres a minute", (("3 m/s", "300 m/s"),), ("300 m/min",), ("OK",),
        level="ATTENTION"),
    Row("a pulley too small for the rating of its belt", (("800 mm", "200 mm"),),
        ("Creeps", "at its rating on pulley head, 1750 kPa", "Check the diameter and the rating."),
        ("OK", "Raise"), level="ATTENTION"),
    Row("an overrun that no lagging makes", (("diameter", 'overrun = "4 mm"\ndiameter'),),
        ("overrun", "4 mm", "2 mm"), ("OK",), level="ATTENTION"),
    Row("an odd size hides behind gross slip", (("180 deg", "3.14 deg"),),
        ("Gross slip", "3.14 deg; 120 deg to 270 deg is", "Action: Check the unit: 3.14 rad?"),
        ("OK",), level="FAILS"),
    Row("a sheave ratio of twenty",
        (("[design_standard]", SHEAVES),),
        ("sheave ratio of the take-up, 20", "Is 2 meant?"), ("OK",), ALIKE, level="ATTENTION"),
    Row("a belt that may bear ten times its rating",
        (("width", "momentary_factor = 10\nwidth"),),
        ("momentary factor of the belt, 10", "Is 1 meant?"), ("OK",), level="ATTENTION"),
    Row("a cover of hundredths of a millimetre",
        (("speed", 'pulley_cover = "0.05 mm"\ncarry_cover = "4 mm"\ncarcass = "6 mm"\nspeed'),),
        ("pulley cover of the belt, 0.05 mm",), ("OK",), level="ATTENTION"),
    Row("a rule of its own that asks for hardly anything",
        (('"CEMA"', '"own"\nfriction = 1.5'),),
        ("friction of the design standard, 1.5", "Is 0.15 meant?"), ("OK",), level="ATTENTION"),
    Row("friction of five", (('"diamond-rubber"', '"plain"'),
                             ("", PLAIN.replace("friction = 0.5", "friction = 5.0"))),
        ("friction of lagging plain, 5", "Is 0.5 meant?"), ("OK",), level="ATTENTION"),
    Row("friction of five in a study", (('"diamond-rubber"', '"plain"'),
                                        ("", PLAIN.replace("friction = 0.5", "friction = 5.0"))),
        ("An unusual size governs all", "ATTENTION"), ("OK",), ("study",)),
    Row("a sheave ratio of twenty in a search", (("[design_standard]", SHEAVES),),
        ("ATTENTION", "sheave ratio of the take-up, 20"), ("OK",), ("choose",)),
    Row("more friction wet than dry",
        (('"diamond-rubber"', '"plain"'), ("format = 1", 'format = 1\ncondition = ["dry", "wet"]'),
         ("", PLAIN.replace("surface", 'condition_factor = [{ condition = "wet", factor = 9, '
                            'provenance = { kind = "given" } }]\nsurface'))),
        ("factor on the friction of lagging plain, wet, 9",), ("OK",), level="ATTENTION"),
    Row("wear of thousands of cubic millimetres",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'wear_coefficient = "5000 mm3/J"\nsurface'))),
        ("wear coefficient of lagging plain, 5000 mm3/J",), ("OK",), level="ATTENTION"),
    # vendors: 4e-4 to 8e-4 mm3/J
    Row("wear of cubic millimetres",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'wear_coefficient = "5 mm3/J"\nsurface'))),
        ("wear coefficient of lagging plain, 5 mm3/J",), ("OK",), level="ATTENTION"),
    Row("a creep limit of a quarter of an inch in millimetres",
        (("diameter", 'creep_limit = "0.25 mm"\ndiameter'),),
        ("0.25 mm; ", "0.25 in?"), ("OK",), ("solve", "page"),
        level="ATTENTION"),
    Row("an overrun of half a centimetre", (("diameter", 'overrun = "5 mm"\ndiameter'),),
        ("overrun", "5 mm", "2 mm", "0.5 mm?"), ("OK", "0.005 mm"), level="ATTENTION"),
    Row("a creep limit of centimetres", (("diameter", 'creep_limit = "6.35 cm"\ndiameter'),),
        ("creep limit of pulley head, 63.5 mm", "Check the unit: 6.35 mm"), ("OK",),
        level="ATTENTION"),
    Row("nothing is pulled", tensions("75 kN", "75 kN"), ("pulls nothing (T1 = T2)",), (),
        level="OK"),
    Row("a pulley of grams", (("diameter", 'mass = "900 g"\ndiameter'),),
        ("mass of pulley head, 0.9 kg", "Check the unit: 900 kg"), ("OK",), level="ATTENTION"),
    # conveyors
    Row("a start of four times the pull", (("lift", "start_factor = 4\nlift"),),
        ("Creeps 19.3 mm", "start factor of the conveyor, 4"), ("OK",), base=CONVEYOR,
        level="ATTENTION"),
    Row("a conveyor that keeps its checks", (), ("OK",), (), ALIKE, base=CONVEYOR,
        level="OK"),
    Row("a belt of grams", (("22 kg/m", "22 g/m"),), ("belt mass", "22 kg/m"), ("OK",),
        ALIKE, base=CONVEYOR, level="ATTENTION"),
    Row("idlers of grams", (("16 kg/m", "16 g/m"),), ("carry idler mass", "16 kg/m"), ("OK",),
        base=CONVEYOR, level="ATTENTION"),
    Row("a capacity of kilograms an hour", (("1000 t/h", "100 kg/h"),),
        ("capacity of the conveyor", "100 t/h"), ("OK",), base=CONVEYOR, level="ATTENTION"),
    Row("a start of minutes", (("lift", 'start_time = "20 min"\nlift'),),
        ("start time", "1200 s", "20 s"), ("OK",), base=CONVEYOR, level="ATTENTION"),
    Row("a conveyor that brakes", (('"20 m"', '"-60 m"'),), ("brakes (T1 < T2) in 1 of 2",),
        ("OK",), base=CONVEYOR, level="ATTENTION"),
    Row("a resistance of newtons", (("lift", 'special_resistance = "1.5 N"\nlift'),),
        ("special resistance", "1.5 kN"), ("OK",), base=CONVEYOR, level="ATTENTION"),
    Row("steeper than any belt", (('"20 m"', '"360 m"'), ("1000 t/h", "100 t/h"),
                                  ('"40 kN"', '"120 kN"')),
        ("lift over length", "0.6"), ("OK",), base=CONVEYOR, level="ATTENTION"),
    Row("heaped beyond its trough", (("3 m/s", "0.2 m/s"), ("600 m", "100 m"), ('"20 m"', '"2 m"'),
                                     ('"40 kN"', '"120 kN"')),
        ("load per length", "1390 kg/m"), ("OK",), base=CONVEYOR, level="ATTENTION"),
    # belt, lagging, standard
    Row("it brakes", tensions("70 kN", "110 kN"), ("OK", "Pulley head brakes (T1 < T2)"),
        (), ("solve", "page"), level="OK"),
    Row("overloaded while starting", (("[design_standard]", START.format("270 kN")),),
        ("load case start", "129 % of the rating", "momentary factor"), ("OK", "Raise"),
        level="FAILS"),
    Row("creeps while starting alone", (("[design_standard]", START.format("200 kN")),),
        ("load case start", "Creeps 10.4 mm"), ("OK",), ("solve", "page"), level="ATTENTION"),
    Row("the standard says nothing on this wrap",
        (("180 deg", "170 deg"), ("", 'binding = true\n[take_up]\nkind = "fixed"\n')),
        ("cannot be applied", "180 to 240 degrees"), ("OK", "surface"), ("solve", "page"),
        level="FAILS"),
    Row("below a rule of its own", (*tensions("76 kN", "30 kN"),
                                    ('"CEMA"', '"own"\nfriction = 0.2\nbinding = true')),
        ("below the", "your own rule; friction 0.20"), ("OK",), level="FAILS"),
    Row("a safety factor that no tension gives", (("", "[safety_factor]\nrunning = 5\n"),),
        ("3.76 times the pull, below 5; safety factor running", "No slack-side tension"),
        ("OK", "Raise"), ("solve", "page"), level="ATTENTION"),
    Row("the bond gives way",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'bond_strength = "40 kPa"\nsurface'))),
        ("lagging and bond, 108 kPa", "40 kPa"), ("OK",), level="ATTENTION"),
    Row("the lagging tires",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'fatigue_limit = "40 kPa"\nsurface'))),
        ("At every pass", "fatigue limit 40 kPa"), ("OK",), level="ATTENTION"),
    Row("the face presses too hard",
        (('1000/4"', '1000/4"\nlargest_wrap_pressure = "200 kPa"'),),
        ("presses on the pulley face with 250 kPa",), ("OK",), ("solve", "page"),
        level="ATTENTION"),
    Row("other questions about a bond that gives way",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'bond_strength = "40 kPa"\nsurface'))),
        ("ATTENTION", "As it is: bond overstressed"), ("OK",), ("what-if", "field")),
    # several drives
    Row("motors overloaded", (('["800 mm"', '["786 mm"'),),
        ("Pulley two", "141 % of their rated torque"), ("OK",), ("solve", "note"), base=MOTORS,
        level="FAILS"),
    Row("the trim of overloaded motors", (('["800 mm"', '["786 mm"'),),
        ("FAILS", "two carries 86.4 %", "As it is: motor overloaded"), ("OK",), ("trim",),
        base=MOTORS),
    Row("motors of watts", (("110 kW", "110 W"),), ("No operating point",), ("OK",), base=MOTORS,
        level="FAILS"),
    Row("a gear of ten to one too few", (("20.67", "2.067"),), ("Change its set speed or gear",),
        ("OK",), ("solve", "trim"), base=MOTORS, level="FAILS"),
    Row("a gear of a thousand times", (("20.67", "2067"),),
        ("gear ratio of the motor of pulley one, 2067",), ("OK",), base=MOTORS,
        level="ATTENTION"),
    Row("drums that turn ten times as fast as their belt",
        (('share = ["50 %", "50 %"]', 'speeds = ["716 rpm", "714 rpm"]'),),
        ("speed of the drum over that of the belt of pulley one, 10",), ("OK",), base=TANDEM,
        level="ATTENTION"),
    # 985 rpm over 20.7 turns a drum of 0.8 m at 1.99 m/s; 100 rpm at 4.19 m/s
    Row("motors that turn the drums slower than the belt is given",
        (("1500 rpm", "1000 rpm"), ("1480 rpm", "985 rpm")),
        ("speed of the drum over that of the belt of pulley one, 0.665; 0.95",
         "2.00 m/s by the drum, which was taken, and 3 m/s by the speed of the belt"), ("OK",),
        ("solve", "note"), base=MOTORS, level="ATTENTION"),
    Row("motors of 60 Hz on gears for 50 Hz",
        (("1500 rpm", "1800 rpm"), ("1480 rpm", "1780 rpm")),
        ("speed of the drum over that of the belt", "by the drum, which was taken, and 3 m/s"),
        ("OK",), base=MOTORS, level="ATTENTION"),
    Row("speeds of drums that are not that of the belt",
        (('share = ["50 %", "50 %"]', 'speeds = ["100 rpm", "99.7 rpm"]'),),
        ("by the drum, which was taken, and 3 m/s",), ("OK",), ("solve", "note"), base=TANDEM,
        level="ATTENTION"),
    Row("motors that waste all they take",
        (("gear_ratio", "motor_efficiency = 0.05\ngear_ratio"),),
        ("motor efficiency of the motor of pulley one, 0.05", "Is 0.5 meant?"), ("OK",),
        base=MOTORS, level="ATTENTION"),
    Row("drums in the wrong order",
        (("[train]\n", ""), ('effective_tension = "60 kN"\nshare = ["50 %", "50 %"]\n', ""),
         ('exit_tension = "70 kN"\n', ""),
         ('name = "one"', 'name = "one"\nentry_tension = "130 kN"\nexit_tension = "90 kN"'),
         ('name = "two"', 'name = "two"\nentry_tension = "170 kN"\nexit_tension = "130 kN"')),
        ("leaves pulley one with 90 kN", "enters pulley two with 170 kN"), ("OK",), base=TANDEM,
        level="ATTENTION"),
    Row("a gear of twice the speed", (("20.67", "41.34"),),
        ("speed of the drum over that of the belt",), ("OK",), base=MOTORS, level="ATTENTION"),
    Row("the trim under an overloaded belt", (("70 kN", "160 kN"),),
        ("FAILS", "Keep two at a trim of", "As it is: over belt rating (pulley one"), ("OK",),
        ("trim",), base=TANDEM),
    Row("the trim of drives that slip when wet",
        (("70 kN", "60 kN"), ("60 kN", "25 kN"), ('"diamond-rubber"', '"bare"'), ("", BARE)),
        ("ATTENTION", "Keep two at a trim of", "gross slip when wet"), ("OK",), ("trim",),
        base=TANDEM),
    Row("the trim of drives that fight", (('50 %", "50 %', '130 %", "-30 %'),),
        ("ATTENTION", "Set two to a trim of", "As it is: drives fight"), ("OK",), ("trim",),
        base=TANDEM),
    # in time
    Row("an event that keeps its checks", (), ("OK", "152 kN"), (), ("run",), base=MOTION),
    Row("a start too hard", event('kind = "start", time = "9 s"'),
        ("FAILS", "219 kN at 3.09 s", "210 kN"), ("OK",), ("run",), base=MOTION),
    Row("a long wet patch", event('kind = "wet-patch", at = "0.5 s", length = "30 m", '
                                  "friction = 0.05"),
        ("FAILS", "slides on the pulley", "gross slip"), ("OK",), ("run",), base=MOTION),
    Row("a short wet patch on a slack belt",
        (*event('kind = "wet-patch", at = "0.5 s", length = "3 m", friction = 0.3', "3 s"),
         ("70 kN", "20 kN"), ("60 kN", "90 kN")),
        ("ATTENTION", "Creeps 19.1 mm", "is over it for"), ("OK",), ("run",), base=MOTION),
    Row("the belt goes slack in an emergency",
        (*event('kind = "emergency-stop", at = "0.5 s"', "2 s"),
         ('"2200 kg m2"', '"2200 kg m2"\nbrake_torque = "60 kN m"')),
        ("FAILS", "goes slack before one"), ("OK",), ("run",), base=MOTION),
    Row("motors too small for a load step",
        (*event('kind = "load-step", at = "0.5 s", factor = 1.6', "3 s"),
         ('"2200 kg m2"', '"2200 kg m2"\ncontrol = { kind = "droop", rated_torque = "8 kN m" }')),
        ("FAILS", "rated torque"), ("OK",), ("run",), base=MOTION),
    Row("a start not followed to its end", event('kind = "start", time = "20 s"', "4 s"),
        ("ATTENTION", "At the end of the run"), ("OK",), ("run",), base=MOTION),
    Row("a mass of kilograms", (("100 t", "100 kg"), ('"4 s"', '"1 s"')),
        ("ATTENTION", "over the weight of the conveyor_mass"), ("OK",), ("run",), base=MOTION),
    Row("a run of millimetres", (('"50 m"', '"50 mm"'), ('"4 s"', '"1 s"')),
        ("ATTENTION", "carry run, 50 mm", "50 m"), ("OK",), ("run",), base=MOTION),
    Row("a gear ratio of ten times",  # 8 kg m2 at 250^2: 31 times the 100 t at the belt
        (('"2200 kg m2"', '"800 kg m2"\nmotor_inertia = "8 kg m2"\ngear_ratio = 250'),
         ('"4 s"', '"1 s"')),
        ("ATTENTION", "over the conveyor_mass", "gear_ratio"), ("OK",), ("run",), base=MOTION),
    Row("an inertia of tonnes", (('"2200 kg m2"', '"2200 t m2"'), ('"4 s"', '"1 s"')),
        ("ATTENTION", "inertia of drum one", "2200 kg m2"), ("OK",), ("run",), base=MOTION),
    Row("what happens when nobody looks any more",
        event('kind = "load-step", at = "500 s", factor = 1.6', "1 s"),
        ("ATTENTION", "begin (at) of what happens of event start, 500 s", "earlier time"), ("OK",),
        ("run",), base=MOTION),
    Row("a run-out of centimetres",
        event('kind = "run-out", pulley = "two", run_out = "2 cm"', "1 s"),
        ("ATTENTION", "run out of event start, 20 mm", "2 mm"), ("OK",), ("run",), base=MOTION),
    Row("a step of the load of drives below their standard",
        (*event('kind = "load-step", factor = 1.02', "4 s"), ("70 kN", "10 kN"),
         ('"diamond-rubber"', '"plain"'), ("", PLAIN + '[design_standard]\nname = "CEMA"\n')),
        ("ATTENTION", "Steady: below standard (pulley two"), ("OK",), ("run",), base=MOTION),
    Row("vibrations of drives below their standard",
        (("70 kN", "10 kN"), ('"diamond-rubber"', '"plain"'),
         ("", PLAIN + '[design_standard]\nname = "CEMA"\n')),
        ("ATTENTION", "As it is: below standard (pulley two"), ("OK",), ("stability",),
        base=MOTION),
    Row("vibrations of drives under an overloaded belt", (("70 kN", "160 kN"),),
        ("FAILS", "As it is: over belt rating (pulley one"), ("OK",), ("stability",),
        base=MOTION),
    # selection and studies
    Row("the cheapest has more wrap and tension for nothing", (),
        ("OK", "Choose full-ceramic, wrap 180 deg with a slack-side tension of 20 kN:"),
        ("210 deg",), ("choose",)),
    Row("every candidate is below the standard", (("", '[take_up]\nkind = "fixed"\n'),
                                                  ("120 kN", "245 kN"), ("75 kN", "130 kN")),
        ("ATTENTION", "Choose", "is below", "Cw"), ("OK, on",), ("choose",)),
    Row("a study of a drive computed dry", (), ("OK", "keep every check"), ("dry",),
        ("study",)),
    Row("a study without the load case that fails",
        (("[design_standard]", START.format("290 kN")),),
        ("OK, load case design only", "keep every check"), (), ("study",)),
    Row("a study of tensions that no take-up holds",
        (("[design_standard]", '[take_up]\nkind = "fixed"\n\n' + START.format("150 kN")),),
        ("OK", "tensions that its take-up does not hold"), (), ("study",)),
    Row("a study of an overloaded belt", tensions("290 kN", "240 kN"),
        ("FAILS", "all fail", "The rating of the belt governs"), ("OK",), ("study",)),
    Row("a study of a bond that gives way",
        (('"diamond-rubber"', '"plain"'),
         ("", PLAIN.replace("surface", 'bond_strength = "40 kPa"\nsurface'))),
        ("ATTENTION", "The bond strength of the lagging governs"), ("OK",), ("study",)),
)  # fmt: skip
