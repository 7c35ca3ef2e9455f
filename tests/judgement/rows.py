"""Drives made to fail in one way each, and the words that stand in the first two lines of answers.

A row is a drive file, changed from one that keeps its checks, with the words that its headline must
and must not have. Every door that is named in a row answers; its first two lines are looked at.
Rows are added here; `test_rows.py` reads them.
"""

from dataclasses import dataclass, field

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
        Arguments of commands whose answers are looked at, FILE standing for the drive.
    base
        The file that is changed.
    level
        Word that the answer begins with.
    """

    name: str
    changes: tuple[tuple[str, str], ...]
    must: tuple[str, ...]
    must_not: tuple[str, ...] = ()
    doors: tuple[tuple[str, ...], ...] = field(default=(("solve", "FILE"),))
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


WHAT_IF = ("what-if", "FILE", "--thickness", "18 mm")
SOLVE, TRIM = ("solve", "FILE"), ("trim", "FILE")


def tensions(entry: str, leaving: str) -> tuple[tuple[str, str], ...]:
    """Return other tensions of the base."""
    return (("120 kN", entry), ("75 kN", leaving))


ROWS = (
    Row("keeps its checks, computed dry", (), ("OK", "dry only", "wet"), level="OK"),
    Row("creeps a little more than allowed", tensions("150 kN", "60 kN"),
        ("Creeps", "6.35 mm", "up to 12.7 mm"), ("OK", "gross slip,"), level="ATTENTION"),
    Row("creeps seven times the limit, three times the tested slip", tensions("150 kN", "10 kN"),
        ("43.0 mm",), ("larger limit", "may allow", "Raise the slack-side", "OK"),
        (SOLVE, WHAT_IF), level="ATTENTION"),
    Row("no creep carries the pull", (*tensions("180 kN", "1 kN"),),
        ("no creep carries the pull", "end of the tests"), ("at 1 times", "at most 1 times"),
        level="FAILS"),
    Row("at the edge of what friction ever carries",
        (*tensions("450 kN", "200 kN"), ("800 mm", "500 mm"),
         ("Plylon Plus 1000/4", "Flexsteel ST5000")),
        ("no creep carries the pull",), ("at 1 times", "2.25"), level="FAILS"),
    Row("the belt is overloaded", tensions("280 kN", "240 kN"),
        ("The belt tension 280 kN", "210 kN"), ("Raise the slack-side",),
        level="FAILS"),
    Row("below the standard", (*tensions("60 kN", "16.4 kN"), ('"CEMA"', '"CEMA"\nbinding = true')),
        ("below the", "CEMA"), ("OK",), level="FAILS"),
    Row("the pulley is too small for its belt", (("Plylon Plus 1000/4", "Flexsteel ST5000"),
                                                ("800 mm", "1000 mm")),
        ("smaller than the least drive pulley",), ("OK",), level="FAILS"),
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
        ("FAILS",), (TRIM,), base=TANDEM),
    Row("one drive carries more", (("50 %\", \"50 %", "70 %\", \"30 %"),),
        ("Set two to a trim of", "in the place of"), (), (TRIM,), base=TANDEM),
    Row("drives that fight", (("50 %\", \"50 %", "130 %\", \"-30 %"),),
        ("work against each other",), ("OK",), (SOLVE,), base=TANDEM, level="ATTENTION"),
    Row("a tandem too slack", (("70 kN", "20 kN"), ("60 kN", "90 kN")),
        ("two",), ("FAILS",), (SOLVE,), base=TANDEM),
    Row("take-up that holds nothing alike",
        (("[design_standard]", '[[load_case]]\nname = "empty"\npulley.head.entry_tension = '
          '"60 kN"\npulley.head.exit_tension = "30 kN"\n[take_up]\nkind = "gravity"\n'
          "[design_standard]"),),
        ("gravity take-up holds",), ("OK",), level="ATTENTION"),
    Row("sags", (("[design_standard]", '[sag]\nidler_spacing = "3 m"\nline_mass = "450 kg/m"\n'
                  "[design_standard]"),),
        ("sags more",), ("OK", "Lower the"), level="ATTENTION"),
)  # fmt: skip
