"""Lagging files: every kind of law, conditions, presets, what is estimated and what is given.

Expected friction: the equations of the file written out here, in the units of the file.
"""

import math
from collections.abc import Callable

import numpy as np
import pytest

from wraparc import InputError, Kind
from wraparc.arc import Distributed, WrapArc
from wraparc.drive import Cost, Fit, Lagging
from wraparc.files import drive_from_text, lagging_from_text, load_lagging
from wraparc.friction import (
    Constant,
    ElasticPlastic,
    IntegralLog,
    MeasuredTable,
    PressureKnots,
    PressurePower,
    TestedRange,
)

HEAD = """format = 1
name = "mine"
thickness = "12 mm"
shear_modulus = "2.3 MPa"
compression_modulus = "10 MPa"
"""


def read(law: str, head: str = HEAD) -> Lagging:
    (lagging,) = lagging_from_text(head + law)
    return lagging


def faults(law: str, head: str = HEAD) -> list[str]:
    with pytest.raises(InputError) as caught:
        lagging_from_text(head + law)
    return [str(problem) for problem in caught.value.problems]


# ---- laws ----


def test_simple_laws() -> None:
    constant = '[law]\nkind = "constant"\nfriction = 0.35\n'
    assert read(constant).law == Constant(friction_coefficient=0.35)
    tested = 'tested_pressure = ["34 kPa", "0.69 MPa"]\ntested_slip = "15 mm"\n'
    assert read(constant + tested).law.tested == TestedRange(
        pressure_min=34e3, pressure_max=690e3, slip_max=0.015
    )
    assert read(
        '[law]\nkind = "elastic-plastic"\nfriction = 0.5\nstiffness = "190 kPa/mm"\n'
    ).law == ElasticPlastic(friction_coefficient=0.5, stiffness=190e6)
    assert read(
        '[law]\nkind = "power"\nfriction = 0.5\nreference_pressure = "2 bar"\nexponent = 0.4\n'
    ).law == PressurePower(friction_coefficient=0.5, reference_pressure=200e3, exponent=0.4)


def test_a_measured_table() -> None:
    law = read("""
        [law]
        kind = "table"
        slip = ["0 mm", "5 mm", "0.5 in"]
        rows = [
          { pressure = "10 psi", friction = [0, 0.5, 0.6] },
          { pressure = "200 kPa", friction = [0, 0.4, 0.5] },
        ]
    """).law
    assert law == MeasuredTable(
        slip=(0.0, 0.005, 0.0127),
        pressure=(10 * 6894.757293168361, 200e3),
        values=((0.0, 0.5, 0.6), (0.0, 0.4, 0.5)),
    )


def test_knots() -> None:
    """At a knot, mu = mu_pk r (1 - ln r) up to the peak, then the line down to the residual."""
    lagging = read(
        """
        [law]
        kind = "integral-log"
        tested_slip = "15 mm"
        knots = [
          { pressure = "34 kPa", peak_friction = 1.42, peak_slip = "5 mm",
            post_peak_slope = "-0.016 1/mm", residual_friction = 1.27 },
          { pressure = "172 kPa", peak_friction = 1.06, peak_slip = "0.65 in" },
          { pressure = "300 kPa", peak_friction = 0.8, peak_slip = "20 mm" },
        ]
    """.replace(",\n            post", ", post")
    )
    law = lagging.law
    r = 2.0 / 5.0
    assert law.friction(2e-3, 34e3) == pytest.approx(1.42 * r * (1 - math.log(r)), rel=1e-12)
    assert law.friction(8e-3, 34e3) == pytest.approx(1.42 - 0.016 * 3, rel=1e-12)
    assert law.friction(50e-3, 34e3) == pytest.approx(1.27, rel=1e-12)
    assert law.friction(0.65 * 25.4e-3, 172e3) == pytest.approx(1.06, rel=1e-12)
    assert law.friction(1.0, 172e3) == pytest.approx(1.06, rel=1e-12)
    assert law.tested == TestedRange(pressure_min=34e3, pressure_max=300e3, slip_max=15e-3)
    # where no slope and no level are given, friction stays at its peak
    assert isinstance(law, IntegralLog)
    assert isinstance(law.coefficients, PressureKnots)
    assert law.coefficients.post_peak_slope == (-16.0, 0.0, 0.0)
    assert law.coefficients.residual_friction == (1.27, 1.06, 0.8)


# The equations of a figure: A and b for slip in mm, pressure in kPa; inches and psi besides.
FORMS: list[tuple[str, str, Callable[[float], float], Callable[[float], float]]] = [
    (
        "-0.12 + 1.1e-4 p",
        "-0.50 + 5.0e-4 p",
        lambda p: -0.12 + 1.1e-4 * p,
        lambda p: -0.50 + 5.0e-4 * p,
    ),
    (
        "0.0203 ln(p) - 0.2",
        "0.062 ln(p) - 0.75",
        lambda p: 0.0203 * math.log(p) - 0.2,
        lambda p: 0.062 * math.log(p) - 0.75,
    ),
    (
        "-0.45 p^-0.35",
        "-1.9 p^-0.36",
        lambda p: -0.45 * p**-0.35,
        lambda p: -1.9 * p**-0.36,
    ),
    (
        "-0.1 exp(-0.002 p)",
        "-0.40 + 1e-3 p - 8e-7 p^2",
        lambda p: -0.1 * math.exp(-0.002 * p),
        lambda p: -0.40 + 1e-3 * p - 8e-7 * p**2,
    ),
]
UNITS = [("mm", "kPa", 1e-3, 1e3), ("in", "psi", 0.0254, 6894.757293168361), ("m", "Pa", 1.0, 1.0)]


@pytest.mark.parametrize(("a_text", "b_text", "a", "b"), FORMS)
@pytest.mark.parametrize(("slip_unit", "pressure_unit", "metre", "pascal"), UNITS)
def test_printed_equations_are_converted_exactly(
    a_text: str,
    b_text: str,
    a: Callable[[float], float],
    b: Callable[[float], float],
    slip_unit: str,
    pressure_unit: str,
    metre: float,
    pascal: float,
) -> None:
    """mu = A x ln x - b x in the units of the equations, whatever their forms."""
    low, high = 34 * pascal, 172 * pascal
    law = read(f"""
        [law]
        kind = "integral-log"
        slip_unit = "{slip_unit}"
        pressure_unit = "{pressure_unit}"
        pieces = [
          {{ from = "{low} Pa", to = "{high} Pa", A = "{a_text}", b = "{b_text}" }},
        ]
    """).law
    for p in (34.0, 50.0, 100.0, 172.0):
        peak = math.exp(b(p) / a(p) - 1.0)
        for x in peak * np.array([1e-3, 0.1, 0.5, 0.999]):
            expected = a(p) * x * math.log(x) - b(p) * x
            assert law.friction(x * metre, p * pascal) == pytest.approx(expected, rel=1e-11)
            assert law.friction(-x * metre, p * pascal) == pytest.approx(-expected, rel=1e-11)
        flat = law.friction(2 * peak * metre, p * pascal)
        assert flat == pytest.approx(-a(p) * peak, rel=1e-11)
        assert isinstance(law, IntegralLog)
        at = law.coefficients_ab(p * pascal, metre)
        assert at == pytest.approx((a(p), b(p)), rel=1e-9, abs=1e-12)


PIECES = """
[law]
kind = "integral-log"
slip_unit = "mm"
pressure_unit = "kPa"
tested_slip = "15 mm"
pieces = [
  { from = "34 kPa", to = "172 kPa", A = "-0.08 + 2.2e-4 p", b = "-0.30 + 8e-4 p", post_peak_slope = "-0.02 + 1.16279e-4 p", residual_friction = "0.3 p^-0.1" },
  { from = "172 kPa", to = "690 kPa", A = "-0.04676 + 2.6512e-5 p", b = "-0.1754 + 7.56e-5 p" },
]
"""  # noqa: E501


def test_pieces_with_a_tail_meet_at_the_transition() -> None:
    law = read(PIECES).law
    peak = math.exp((-0.30 + 0.08) / (-0.08 + 0.022) - 1.0)  # at 100 kPa
    top = (0.08 - 0.022) * peak
    line = top + (-0.02 + 1.16279e-2) * 3.0
    assert law.friction((peak + 3.0) * 1e-3, 100e3) == pytest.approx(line, rel=1e-11)
    assert law.friction(1.0, 100e3) == pytest.approx(0.3 * 100**-0.1, rel=1e-11)
    for slip in (4e-3, 40e-3):
        below, above = (float(law.friction(slip, p)) for p in (171.999e3, 172.001e3))
        assert below == pytest.approx(above, rel=0.02)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            'slip_unit = "mm"\n',
            "",
            (
                'law.slip_unit: missing: A and b need it. Write slip_unit = "mm", or the unit of '
                "their fit."
            ),
        ),
        (
            '"kPa"\n',
            '"kpa"\n',
            'law.pressure_unit: unknown unit "kpa", got "kpa". Write for example "kPa".',
        ),
        (
            'slip_unit = "mm"',
            'slip_unit = "kN"',
            'law.slip_unit: a force, where a length is needed, got "kN". Write for example "mm".',
        ),
        (
            'from = "172 kPa"',
            'from = "180 kPa"',
            (
                'law.pieces[2].from: must be "172 kPa", the end of the piece before, got "180 '
                'kPa". Leave no gap and no overlap.'
            ),
        ),
        (
            "-0.08 + 2.2e-4 p",
            "0.08 + 2.2e-4 p",
            "law.pieces[1].A: A must be negative between 34000 and 172000 Pa, else the law "
            'gives no positive friction, got "0.08 + 2.2e-4 p".',
        ),
        (
            "-0.1754",
            "-0.2754",
            "law.pieces[2]: peak slip jumps at the transition pressure 172000 Pa; pieces "
            "must meet within 2 %, got 17.3223 and 184.554.",
        ),
    ],
)
def test_faults_of_pieces(old: str, new: str, expected: str) -> None:
    assert PIECES.count(old) == 1
    assert faults(PIECES.replace(old, new))[-1] == expected


def test_equations_that_are_none() -> None:
    found = faults(PIECES.replace("-0.30 + 8e-4 p", "-0,30").replace("0.3 p^-0.1", "0.3 x"))
    fix = "Write a polynomial, logarithm, power or exponential of p."
    assert found[:2] == [
        f'law.pieces[1].b: no equation over the pressure p, got "-0,30". {fix}',
        f'law.pieces[1].residual_friction: no equation over the pressure p, got "0.3 x". {fix}',
    ]


def test_a_slope_needs_a_level_to_fall_to() -> None:
    knots = """
        [law]
        kind = "integral-log"
        knots = [{ pressure = "1 bar", peak_friction = 1, peak_slip = "5 mm", SLOPE }]
    """.replace("SLOPE", 'post_peak_slope = "-0.016 1/mm"')
    sentence = (
        "residual_friction: missing: post_peak_slope needs it. Give the level that friction "
        "falls to."
    )
    assert faults(knots) == [f"law.knots[1].{sentence}"]
    pieces = PIECES.replace(', residual_friction = "0.3 p^-0.1"', "")
    assert faults(pieces) == [f"law.pieces[1].{sentence}"]


@pytest.mark.parametrize(
    ("law", "expected"),
    [
        (
            '[law]\nkind = "integral-log"\n',
            "law: an integral-log law with neither knots nor pieces. Give one of the two.",
        ),
        (
            PIECES.replace('tested_slip = "15 mm"', 'tested_pressure = ["34 kPa", "690 kPa"]'),
            "law.tested_pressure: contradicts the ends of knots or pieces, "
            'got ["34 kPa", "690 kPa"]. Leave it out.',
        ),
        (
            '[law]\nkind = "constant"\nfriction = 0.3\ntested_slip = "15 mm"\n',
            "law.tested_pressure: missing: tested_slip needs it. Give both or none.",
        ),
        (
            '[law]\nkind = "power"\nfriction = 0.3\nreference_pressure = "2 bar"\nexponent = 1.5\n',
            "law.exponent: the exponent must lie in 0 <= n < 1, got 1.5.",
        ),
        (
            '[law]\nkind = "table"\nslip = ["1 mm", "2 mm"]\n'
            'rows = [{ pressure = "1 bar", friction = [0.1, 0.2] }]\n',
            "law.slip: at least two slips, the first of them 0, are needed, got 2 slips.",
        ),
        (
            '[law]\nkind = "table"\nslip = ["0 mm", "2 mm"]\n'
            'rows = [{ pressure = "1 bar", friction = [0.1, 0.2, 0.3] }]\n',
            "law.rows[1].friction: 3 values for 2 slips. Give one for each slip.",
        ),
    ],
)
def test_faults_of_laws(law: str, expected: str) -> None:
    assert faults(law) == [expected]


# ---- conditions ----

TWO = """
[[law]]
condition = "dry"
kind = "constant"
friction = 0.6
[[law]]
condition = "wet and dirty"
kind = "constant"
friction = 0.25
provenance = { kind = "measured", source = "own tests", date = "2024" }
"""


def test_conditions_are_laws_of_one_lagging() -> None:
    dry, wet = lagging_from_text(HEAD + TWO)
    assert (dry.condition, wet.condition) == ("dry", "wet and dirty")
    assert wet.law == Constant(friction_coefficient=0.25)
    assert wet.source_of("law").kind is Kind.MEASURED
    assert dry.source_of("law").kind is Kind.GIVEN
    assert (dry.thickness, dry.shear_modulus) == (wet.thickness, wet.shear_modulus)


def test_a_condition_that_the_catalogue_has_not() -> None:
    with pytest.raises(InputError) as caught:
        load_lagging("full-ceramic", "wet")
    assert str(caught.value) == (
        'condition: lagging "full-ceramic" has no law for this condition, got "wet". Write '
        'one of "dry".'
    )


# ---- elasticity ----

CONSTANT = '[law]\nkind = "constant"\nfriction = 0.4\n'


def elastic(*lines: str) -> Lagging:
    return read(CONSTANT, 'format = 1\nname = "mine"\n' + "".join(line + "\n" for line in lines))


def test_what_is_not_given_is_estimated_and_says_so() -> None:
    lagging = elastic('thickness = "12 mm"', 'elastic_modulus = "6.9 MPa"')
    assert lagging.shear_modulus == pytest.approx(2.3e6)
    assert lagging.compression_modulus == 6.9e6
    assert lagging.source_of("shear_modulus").note == ("estimated: G = E/3, incompressible rubber")
    assert lagging.source_of("compression_modulus").note == (
        "estimated: E_c = E, no stiffening by the shape of blocks"
    )
    assert "thickness" not in lagging.sources


def test_the_blocks_of_a_thicker_lagging_are_softer() -> None:
    """The height of the blocks is the thickness unless given: S = 40/(4 h), k = 0.5, E = 3 G."""
    block = 'block = { width = "40 mm", stiffening = 0.5 }'
    for h in (10, 20):
        lagging = elastic(f'thickness = "{h} mm"', 'shear_modulus = "2 MPa"', block)
        assert lagging.compression_modulus == pytest.approx(6e6 * (1 + (10 / h) ** 2))
    fixed = block.replace("stiff", 'height = "10 mm", stiff')
    lagging = elastic('thickness = "20 mm"', 'shear_modulus = "2 MPa"', fixed)
    assert lagging.compression_modulus == pytest.approx(12e6)


def test_blocks_on_a_part_of_the_area_shear_by_the_stress_that_they_bear() -> None:
    """Blocks on 4/5 of the area bear tau/f: u = (h/G) tau/f, gamma = atan(tau/(f G)).

    An arc that the shear alone holds, much longer than l = sqrt(c EA/B), c = h/(f G):
    T1 - T2 = (B l/c) u at the exit, by hand from the balance of a solid strip of the width f B.
    """
    block = 'block = { width = "40 mm", contact_fraction = 0.8 }'
    lagging = elastic('thickness = "0.2 mm"', 'shear_modulus = "5 MPa"', block)
    assert "contact fraction 0.8" in str(lagging.source_of("shear_modulus"))
    width, stiffness, pull = 1.2, 1.2 * 12.96e6, 20.0
    arc = WrapArc(
        law=lagging.law, entry_tension=150e3, exit_tension=150e3 - pull, diameter=0.8,
        wrap_angle=3.0, width=width, axial_stiffness=stiffness, thickness=lagging.thickness,
        shear_modulus=lagging.shear_modulus, overrun=0.0,
    )  # fmt: skip
    result = Distributed(capacities=False).solve(arc)
    # k'' = k/l^2 of a strip: G f B k/h = EA k'', so that the force is sqrt(EA G f B/h) u
    creep = pull / math.sqrt(stiffness * 5e6 * 0.8 * width / 0.2e-3)
    assert result.exit_creep == pytest.approx(creep, rel=1e-9)
    assert math.tan(result.peak_shear_angle) == pytest.approx(creep / 0.2e-3, rel=1e-9)
    told = elastic('thickness = "12 mm"', 'elastic_modulus = "6 MPa"', block)
    assert told.shear_modulus == pytest.approx(0.8 * 2e6)
    alone = elastic('thickness = "12 mm"', 'shear_modulus = "2 MPa"')
    assert alone.shear_modulus == 2e6


def test_a_surface_that_does_not_yield() -> None:
    lagging = elastic()
    assert (lagging.thickness, lagging.shear_compliance, lagging.compression_compliance) == (
        0,
        0,
        0,
    )
    lagging = elastic('thickness = "5 mm"', 'shear_modulus = "rigid"')
    assert (lagging.shear_modulus, lagging.compression_modulus) == (math.inf, math.inf)


# ---- cost and fit ----


def test_cost_wear_and_fit_travel_with_the_lagging() -> None:
    lagging = read(
        """
        [law]
        kind = "constant"
        friction = 0.4
        [law.fit]
        parameters = ["friction"]
        values = [0.4]
        covariance = [[1e-4]]
        residual_noise = 0.01
        coverage_factor = 2.57
        date = "2024-05-01"
        method = "robust"
        misfit = ["first point already near the peak"]
        """,
        HEAD + 'wear_coefficient = "0.05 mm3/J"\ncost = { material = 625, installation = 4000, '
        'currency = "AUD", area = "6.28 m2", life_years = [1, 2] }\n',
    )
    assert lagging.wear_coefficient == 0.05e-9
    assert lagging.cost == Cost(
        material=625, installation=4000, currency="AUD", area=6.28, life_years=(1, 2)
    )
    assert lagging.fit == Fit(
        parameters=("friction",), values=(0.4,), covariance=((1e-4,),), residual_noise=0.01,
        coverage_factor=2.57, date="2024-05-01", method="robust",
        misfit=("first point already near the peak",),
    )  # fmt: skip


# ---- laggings inside a drive file ----

DRIVE = """format = 1
[belt]
width = "1 m"
modulus = "10 MN/m"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
entry_tension = "100 kN"
exit_tension = "50 kN"
"""


def inline(lagging: str, more: str = "") -> Lagging:
    return drive_from_text(f"{DRIVE}lagging = {lagging}\n{more}").pulleys[0].lagging


def test_an_inline_lagging_for_comparison() -> None:
    lagging = inline('"cema"', '[lagging.cema]\nlaw = { kind = "constant", friction = 0.35 }\n')
    assert lagging.name == "cema"
    assert lagging.law == Constant(friction_coefficient=0.35)
    assert lagging.shear_compliance == 0.0


def test_a_preset_is_overridden_key_by_key() -> None:
    base = load_lagging("full-ceramic")
    thick = inline('{ preset = "full-ceramic", thickness = "20 mm" }')
    assert (thick.name, thick.thickness, thick.law) == (base.name, 0.02, base.law)
    assert thick.shear_modulus == base.shear_modulus
    # S = 40/(2 20) = 1: E_c = 0.8 (4/3) 6.9 (1 + 0.54) MPa
    assert thick.compression_modulus == pytest.approx(0.8 * 4 / 3 * 6.9e6 * 1.54)
    assert thick.source_of("thickness").kind is Kind.GIVEN
    assert thick.source_of("thickness").note == "instead of that of full-ceramic"
    assert thick.source_of("elastic_modulus").kind is Kind.PUBLISHED
    assert thick.source_of("law").kind is Kind.ILLUSTRATIVE
    stiff = inline('{ preset = "full-ceramic", compression_modulus = "30 MPa" }')
    assert stiff.compression_modulus == 30e6
    assert stiff.source_of("compression_modulus").note == "instead of that of full-ceramic"
    # its blocks shear on, 4/5 of the area of rubber of 2.3 MPa
    assert stiff.shear_modulus == pytest.approx(0.8 * 2.3e6)
    assert stiff.source_of("shear_modulus").kind is Kind.PUBLISHED
    assert "contact fraction 0.8" in stiff.source_of("shear_modulus").note
    both = inline(
        '{ preset = "full-ceramic", shear_modulus = "2 MPa", compression_modulus = "30 MPa" }'
    )
    assert both.shear_modulus == pytest.approx(0.8 * 2e6)


def test_another_law_for_a_preset() -> None:
    other = inline(
        '{ preset = "full-ceramic", law = { condition = "wet", kind = "constant", '
        "friction = 0.4 } }"
    )
    assert (other.condition, other.law) == ("wet", Constant(friction_coefficient=0.4))
    assert other.source_of("law").kind is Kind.GIVEN


def test_a_named_table_below_a_table_of_a_pulley() -> None:
    more = '[lagging.worn]\npreset = "diamond-rubber"\nthickness = "6 mm"\n'
    assert inline('"worn"', more).thickness == 0.006
    softer = inline('{ preset = "worn", shear_modulus = "1 MPa" }', more)  # blocks on 85 %
    assert (softer.name, softer.thickness, softer.shear_modulus) == ("diamond-rubber", 0.006, 85e4)


@pytest.mark.parametrize(
    ("lagging", "more", "expected"),
    [
        (
            '"wron"',
            '[lagging.worn]\npreset = "diamond-rubber"\n',
            (
                'pulley.head.lagging: the catalogue has no lagging of this name, got "wron". Did '
                'you mean "worn"?'
            ),
        ),
        (
            '"worn"',
            '[lagging.worn]\npreset = "diamond_rubber"\n',
            (
                "lagging.worn.preset: the catalogue has no lagging of this name, got "
                '"diamond_rubber". Did you mean "diamond-rubber"?'
            ),
        ),
        (
            '"worn"',
            '[lagging.worn]\nthickness = "6 mm"\n[lagging.worn.law]\nkind = "constant"\n'
            "friction = 0.3\n",
            "lagging.worn.shear_modulus: missing for a lagging with thickness. "
            "Give shear_modulus or elastic_modulus.",
        ),
        (
            '{ preset = "diamond-rubber", thicknes = "6 mm" }',
            "",
            'pulley.head.lagging.thicknes: unknown key. Did you mean "thickness"?',
        ),
        (
            '{ thickness = "6 mm", elastic_modulus = "6 MPa" }',
            "",
            "pulley.head.lagging.law: missing. Add a [law] table, as the examples show.",
        ),
    ],
)
def test_faults_of_inline_laggings(lagging: str, more: str, expected: str) -> None:
    with pytest.raises(InputError) as caught:
        inline(lagging, more)
    assert [str(p) for p in caught.value.problems] == [expected]
