"""Keys of the layers and mass of a belt, and of the side that a pulley meets.

Expected values: the layers as given; e is the cover that meets the pulley and half of the carcass;
pulls of torques as 2 M over the diameter of the tension member.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from wraparc import InputError, WrapArc
from wraparc.answer.document import result_document
from wraparc.answer.inputs import drive_inputs
from wraparc.arc import Distributed, DriveResult, solve
from wraparc.checks import Level, judge
from wraparc.drive import Drive
from wraparc.drive.pitch import cover_compliance, layers_of, pitch_offset
from wraparc.files import drive_from_text, drive_text
from wraparc.train.file import train_from_text
from wraparc.units import in_units

LAYERS = 'pulley_cover = "3 mm"\ncarry_cover = "7 mm"\ncarcass = "6 mm"\nmass = "20 kg/m"'
TEXT = """
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
{belt}
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
exit_tension = "60 kN"
{pulley}
"""


def drive(belt: str = LAYERS, pulley: str = 'entry_tension = "150 kN"') -> Drive:
    return drive_from_text(TEXT.format(belt=belt, pulley=pulley))


def arc(of: Drive) -> WrapArc:
    return WrapArc.of(of, of.pulleys[0], of.load_cases[0])


def told(error: pytest.ExceptionInfo[InputError]) -> str:
    return "\n".join(map(str, error.value.problems))


def test_what_a_file_gives_an_arc_has() -> None:
    one = arc(drive())
    assert one.pitch_offset == pytest.approx(3e-3 + 3e-3, rel=1e-15)
    assert one.centrifugal == pytest.approx(20.0 * 9.0, rel=1e-15)
    assert arc(drive(pulley='entry_tension = "150 kN"\nside = "carry"')).pitch_offset == (
        pytest.approx(7e-3 + 3e-3, rel=1e-15)
    )
    assert arc(drive(belt="")).pitch_offset is None


@pytest.mark.parametrize("left_out", ["pulley_cover", "carry_cover", "carcass"])
def test_one_layer_follows_from_the_thickness(left_out: str) -> None:
    kept = [line for line in LAYERS.split("\n") if left_out not in line]
    belt = drive("\n".join([*kept, 'thickness = "16 mm"'])).belt
    assert layers_of(belt) == pytest.approx((3e-3, 7e-3, 6e-3), rel=1e-12)


def test_a_thickness_alone_tells_no_offset() -> None:
    assert pitch_offset(drive('thickness = "16 mm"').belt, "pulley") is None


def test_a_cover_without_a_modulus_is_estimated_and_says_so() -> None:
    of = drive()
    assert cover_compliance(of.belt, "pulley") == pytest.approx(3e-3 / 1e6)
    judged = judge(solve(of))
    assert "cover_shear_modulus" in judged.data.of_class("estimated")
    assert "cover shear modulus, G estimated." in judged.data.text
    assert "Estimated: cover shear modulus of belt, " in " ".join(judged.remarks)
    stated = drive(LAYERS + '\ncover_shear_modulus = "1.5 MPa"')
    assert cover_compliance(stated.belt, "carry") == pytest.approx(7e-3 / 1.5e6)


def test_a_torque_pulls_at_the_tension_member() -> None:
    """2 M/(D + 2 e): 40 kN m at 800 + 12 mm."""
    one = arc(drive(pulley='torque = "40 kN m"'))
    assert one.effective_tension == pytest.approx(80e3 / 0.812, rel=1e-12)


def test_what_is_written_reads_back_equal() -> None:
    of = drive(LAYERS + '\ncover_shear_modulus = "1.2 MPa"',
               'entry_tension = "150 kN"\nside = "carry"')  # fmt: skip
    again = drive_from_text(drive_text(of))
    assert again == of
    assert again.pulleys[0].side == "carry"
    assert again.belt.mass == 20.0


def test_everything_wrong_is_told_at_once() -> None:
    with pytest.raises(InputError) as error:
        drive(
            'pulley_cover = "80 mm"\nthickness = "61 mm"\nmass = "-1 kg/m"\ncarcass = "0 mm"\n'
            'cover_shear_modulus = "1 kPa"',
            'entry_tension = "150 kN"\nside = "back"',
        )
    text = told(error)
    for part in (
        "belt.pulley_cover: must be between 0 mm and 60 mm, got \"80 mm\".",
        "belt.thickness", "belt.mass", "belt.carcass", "belt.cover_shear_modulus",
        "pulley.head.side", 'must be one of "pulley", "carry"',
    ):  # fmt: skip
        assert part in text, (part, text)


@pytest.mark.parametrize(
    ("belt", "said"),
    [
        (
            'thickness = "5 mm"\npulley_cover = "6 mm"',
            'must be more than pulley_cover = 6 mm, got "5 mm"',
        ),
        (
            'thickness = "10 mm"\npulley_cover = "4 mm"\ncarry_cover = "6 mm"',
            "must be more than pulley_cover + carry_cover = 10 mm",
        ),
        (
            'pulley_cover = "30 mm"\ncarry_cover = "30 mm"\ncarcass = "9 mm"',
            "pulley_cover + carry_cover + carcass must be at most 60 mm",
        ),
        (
            LAYERS + '\nthickness = "30 mm"',
            "must be at most pulley_cover + carry_cover + carcass = 16 mm",
        ),
    ],
)
def test_layers_that_do_not_go_together(belt: str, said: str) -> None:
    with pytest.raises(InputError) as error:
        drive(belt)
    assert said in told(error)
    assert "belt." in told(error)


def test_a_carry_side_without_a_carry_cover() -> None:
    with pytest.raises(InputError) as error:
        drive('pulley_cover = "3 mm"\ncarcass = "6 mm"', 'entry_tension = "150 kN"\nside = "carry"')
    assert "needs carry_cover of the belt" in told(error)


def test_the_mass_of_the_whole_belt() -> None:
    """200 kg/m are asked about; 20 t press on no pulley at 3 m/s: 180 kN."""
    checks = judge(solve(drive('mass = "200 kg/m"'))).checks
    asked = [c for c in checks if c.name == "usual_sizes"]
    assert [c.level for c in asked] == [Level.ATTENTION]
    assert in_units(asked[0].text) == "Belt mass 200 kg/m is outside the usual 1.2 to 156 kg/m."
    assert asked[0].action_text == "Check belt.mass: per length of belt."
    with pytest.raises(InputError) as error:
        drive('mass = "20 t/m"'.replace("20 t/m", "20000 kg/m"))
    assert "Give the mass of one metre of belt." in told(error)


def covered(cover: str, limit: str) -> DriveResult:
    text = TEXT.format(belt=f'pulley_cover = "{cover}"\ncarcass = "6 mm"',
                       pulley='entry_tension = "150 kN"')  # fmt: skip
    return solve(
        drive_from_text(text.replace("format = 1", f'format = 1\ncreep_limit = "{limit}"'))
    )


def test_a_law_that_does_not_say_what_its_slip_includes() -> None:
    """The cover is left out; the creep with it is shown, and asked about where it is too much.

    Expected: the same arc with the cover in series.
    """
    result = covered("8 mm", "20 mm")
    (one,) = result.arcs
    assert one.arc.cover_compliance == 0.0
    series = replace(one.arc, cover_compliance=8e-3 / 1e6, cover_left_out=0.0)
    creep = Distributed(capacities=False).solve(series).exit_creep
    assert one.covered_creep == pytest.approx(creep, rel=1e-6)
    assert creep > 1.05 * one.exit_creep
    between = 0.5 * (creep + one.exit_creep)
    for limit, level in ((2.0 * creep, Level.OK), (between, Level.ATTENTION)):
        checks = judge(covered("8 mm", f"{1e3 * limit!r} mm")).checks
        assert [c.level for c in checks if c.name == "cover_creep"] == [level]
        assert [c.level for c in checks if c.name == "creep"] == [Level.OK]


def test_a_law_that_says_what_its_slip_includes() -> None:
    """Neither: both shear in series; the lagging's: the cover does; the cover's: the lagging."""
    one = arc(drive())
    own, cover = one.thickness / one.shear_modulus, 3e-3 / 1e6
    for includes, series in (
        ((), own + cover), (("lagging shear",), cover), (("cover shear",), own),
        (("lagging shear", "cover shear"), 0.0),
    ):  # fmt: skip
        of = drive()
        law = of.pulleys[0].lagging.law
        object.__setattr__(law, "slip_includes", includes)
        try:
            assert arc(of).shear_compliance == pytest.approx(series, rel=1e-15)
        finally:
            object.__delattr__(law, "slip_includes")


HEAVY = 'pulley_cover = "8 mm"\ncarcass = "6 mm"\nthickness = "10 mm"\nmass = "20000 kg/m"'
SECOND = """
[[pulley]]
name = "second"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "diamond-rubber"
side = "carry"
"""
ALL = (
    'pulley.head.side: must be one of "pulley", "carry"',
    'must be at least pulley_cover + carcass = 14 mm, got "10 mm"',
    "pulley.second.side: needs carry_cover of the belt",
    "Give the mass of one metre of belt.",
)


@pytest.mark.parametrize("door", ["drive", "train"])
def test_what_belt_and_drums_have_wrong_together_is_told_at_once(door: str) -> None:
    """Layers, sides and mass: though neither the belt nor the first drum can be made."""
    text = TEXT.format(belt=HEAVY, pulley='side = "back"\nentry_tension = "150 kN"') + SECOND
    if door == "drive":
        text += 'entry_tension = "60 kN"\nexit_tension = "30 kN"\n'
    else:
        own = 'exit_tension = "60 kN"\n', 'entry_tension = "150 kN"\n'
        text = text.replace(own[0], "").replace(own[1], "")
        text += (
            '[train]\nentry_tension = "150 kN"\nexit_tension = "60 kN"\nshare = ["50 %", "50 %"]\n'
        )
    with pytest.raises(InputError) as error:
        train_from_text(text)
    for part in ALL:
        assert part in told(error), (part, told(error))
    assert len(error.value.problems) == len(ALL)


@pytest.mark.parametrize("odd", ['mass = "20 t"', 'speed = "3 mm"', 'rating = "-1 N/mm"'])
def test_layers_are_told_beside_another_fault_of_the_belt(odd: str) -> None:
    belt = f'{odd}\npulley_cover = "8 mm"\ncarcass = "6 mm"\nthickness = "10 mm"'
    text = TEXT.format(belt=belt, pulley='entry_tension = "150 kN"')
    text = text.replace('speed = "3 m/s"\n', "") if "speed" in odd else text
    with pytest.raises(InputError) as error:
        drive_from_text(text)
    assert f"belt.{odd.split(maxsplit=1)[0]}: " in told(error)
    assert 'must be at least pulley_cover + carcass = 14 mm, got "10 mm"' in told(error)
    assert len(error.value.problems) == 2


@pytest.mark.parametrize(
    ("belt", "pulley", "said"),
    [
        ('pulley_cover = "nan mm"', "", "not a finite number"),
        ("pulley_cover = 3", "", "no unit, where a length is needed"),
        ("pulley_cover = true", "", "neither text nor a number"),
        ('pulley_covers = "3 mm"', "", 'Did you mean "pulley_cover" or "carry_cover"?'),
        ('carcass = "-6 mm"', "", "more than 0 mm and at most 60 mm"),
        ('thickness = "1e400 mm"', "", "not a finite number"),
        ('mass = "20 kg"', "", "a mass, where a mass per length is needed"),
        ('mass = "inf kg/m"', "", "not a finite number"),
        ('mass = "45 lbf/ft"', "", "a force per width, where a mass per length is needed"),
        ('cover_shear_modulus = "0 MPa"', "", "between 100 kPa and 100 MPa"),
        ("", 'side = "Carry"', 'Did you mean "carry"?'),
        ("", 'side = ["carry"]', 'must be one of "pulley", "carry"'),
        ('thickness = "16 mm"', 'side = "carry"', "needs carry_cover of the belt"),
    ],
)
def test_odd_input_of_a_belt(belt: str, pulley: str, said: str) -> None:
    with pytest.raises(InputError) as error:
        drive(belt, f'entry_tension = "150 kN"\n{pulley}')
    assert said in told(error)
    assert len(error.value.problems) == 1


def test_the_inputs_of_an_answer_say_where_the_tension_member_runs() -> None:
    """Carry cover and half of the carcass: 7 + 3 mm; of a side alone, that it is met."""
    pulley = 'entry_tension = "150 kN"\nside = "carry"'
    result = solve(drive(pulley=pulley))
    (told_of,) = [i for i in drive_inputs(result.drive) if i.name == "pitch_offset"]
    assert told_of.value == pytest.approx(10e-3)
    assert told_of.remark == "carry side of the belt"
    assert result_document([result])["drive"]["pulleys"][0]["side"] == "carry"
    own = TEXT.replace('preset = "Plylon Plus 1000/4"', 'name = "own"\nmodulus = "12960 kN/m"')
    result = solve(drive_from_text(own.format(belt="", pulley=pulley)))
    told_so = {i.title: i.value for i in drive_inputs(result.drive)}
    assert told_so["Meets the"] == "carry side of the belt"
