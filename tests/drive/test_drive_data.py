"""Descriptions of a drive: what they refuse, and the few quantities they compute.

Expected values: by hand from the definitions given with each.
"""

import math
import pickle
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from wraparc import InputError, load_lagging
from wraparc.drive import (
    DESIGN,
    Belt,
    Block,
    Cost,
    Drive,
    Fit,
    Lagging,
    LoadCase,
    Pulley,
    Tensions,
    compression_modulus,
)
from wraparc.friction import Constant, TestedRange

BELT = Belt(name="belt", width=1.2, modulus=12.96e6, rating=175e3, speed=3.0)
LAGGING = Lagging(
    name="rubber",
    law=Constant(
        friction_coefficient=0.35,
        tested=TestedRange(pressure_min=34e3, pressure_max=690e3, slip_max=0.015),
    ),
    thickness=0.012,
    shear_modulus=2.3e6,
    compression_modulus=1e7,
)
PULLEY = Pulley(name="head", diameter=0.8, wrap_angle=math.pi, lagging=LAGGING)
CASE = LoadCase(name=DESIGN, tensions={"head": Tensions(entry=150e3, exit=60e3)})
DRIVE = Drive(belt=BELT, pulleys=(PULLEY,), load_cases=(CASE,))


def sentences(make: Callable[[], object]) -> list[str]:
    with pytest.raises(InputError) as caught:
        make()
    return [str(problem) for problem in caught.value.problems]


def test_derived_quantities() -> None:
    assert BELT.axial_stiffness == 12.96e6 * 1.2
    assert LAGGING.shear_compliance == 0.012 / 2.3e6
    assert LAGGING.compression_compliance == 0.012 / 1e7
    assert PULLEY.radius == 0.4
    assert PULLEY.wrap_length == 0.4 * math.pi
    tensions = CASE.tensions["head"]
    assert (tensions.effective, tensions.ratio) == (90e3, 2.5)
    assert DRIVE.creep_limit == 0.25 * 0.0254
    assert DRIVE.creep_limit_of(PULLEY) == DRIVE.creep_limit
    assert DRIVE.creep_limit_of(replace(PULLEY, creep_limit=0.01)) == 0.01
    assert DRIVE.pulley("head") is PULLEY


def test_a_drive_survives_pickling() -> None:
    assert pickle.loads(pickle.dumps(DRIVE)) == DRIVE  # noqa: S301
    assert hash(DRIVE) == hash(replace(DRIVE))


@pytest.mark.parametrize(
    ("make", "expected"),
    [
        (
            lambda: Belt(name=" ", width=0.0, modulus=-1e6, rating=math.nan, speed=0.0),
            [
                'name: must be a printable text of 1 to 60 characters, got " ".',
                "width: must be between 1 mm and 10 m, got 0 mm.",
                "modulus: must be at least 1 kN/m, got -1000 kN/m.",
                "rating: must be finite, got nan kN/m.",
                "speed: must be more than 0 m/s and at most 1000 m/s, got 0 m/s.",
            ],
        ),
        (
            lambda: replace(BELT, width="1200 mm"),  # type: ignore[arg-type]
            ['width: must be a number [m], got "1200 mm".'],
        ),
        (
            lambda: replace(PULLEY, diameter=-0.8, wrap_angle=13.0, overrun=-2.0, creep_limit=0.0),
            [
                "diameter: must be between 1 mm and 1000 m, got -800 mm.",
                "wrap_angle: must be between 1 deg and 720 deg, got 744.8 deg.",
                "overrun: must be between -1000 mm and 1000 mm, got -2000 mm.",
                "creep_limit: must be more than 0 mm and at most 1000 mm, got 0 mm.",
            ],
        ),
        (
            lambda: replace(LAGGING, thickness=-0.012, shear_modulus=0.0, surface="wood"),
            [
                "thickness: must be between 0 mm and 1000 mm, got -12 mm.",
                "shear_modulus: must be at least 1 kPa, got 0 kPa.",
                'surface: must be one of bare, rubber, polyurethane, ceramic, got "wood".',
            ],
        ),
        (
            lambda: Tensions(entry=math.inf, exit=-5.0),
            ["entry: must be finite, got inf kN.", "exit: must be between 0.0001 kN and 1000000 "
                                                "kN, got -0.005 kN."],
        ),
        (
            lambda: Cost(
                material=-1, installation=0, currency="AUD", area=6.28, life_years=(2.0, 1.0)
            ),
            [
                "material: must be at least 0, got -1.",
                "life_years: must be the shortest and the longest life in years, both more "
                "than 0, got [2.0, 1.0].",
            ],
        ),
        (
            lambda: Block(shape="round", width=0.0, height=0.01),  # type: ignore[arg-type]
            [
                "width: must be between 0.1 mm and 10 m, got 0 mm.",
                'shape: must be one of square, strip, got "round".',
            ],
        ),
        (
            lambda: replace(DRIVE, pulleys=()),
            [
                "pulley: a drive needs 1 to 10 pulleys, got 0.",
                'load_case.design: tensions for ["head"], which the drive does not have.',
            ],
        ),
        (
            lambda: replace(
                DRIVE,
                pulleys=(PULLEY, PULLEY, replace(PULLEY, name="tail")),
                load_cases=(CASE, CASE),
                creep_limit=0.0,
            ),
            [
                "creep_limit: must be more than 0 mm and at most 1000 mm, got 0 mm.",
                'pulley.name: used 2 times, got "head". Give each its own name.',
                'load_case.name: used 2 times, got "design". Give each its own name.',
                'load_case.design: no tensions for ["tail"].',
                'load_case.design: no tensions for ["tail"].',
            ],
        ),
    ],
)  # fmt: skip
def test_everything_wrong_is_told_at_once(make: Callable[[], object], expected: list[str]) -> None:
    assert sentences(make) == expected


def test_pulley_and_load_case_by_name() -> None:
    """The first without a name; an unknown name is told with those there are."""
    assert DRIVE.pulley() is DRIVE.pulley("head") is DRIVE.pulleys[0]
    assert DRIVE.load_case() is DRIVE.load_case("design") is DRIVE.load_cases[0]
    assert sentences(lambda: DRIVE.pulley("tail")) == [
        'the drive has no such pulley, got "tail". Write one of "head".'
    ]
    assert sentences(lambda: DRIVE.load_case("desing")) == [
        ('the drive has no such load case, got "desing". Did you mean "design"?')
    ]


# ---- covariance of a fit ----

FIT = Fit(
    parameters=("knots[1].peak_slip", "knots[1].peak_friction"),
    values=(0.016, 1.3),
    covariance=((4e-8, 1e-6), (1e-6, 4e-4)),
    residual_noise=0.01,
)


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({"parameters": ("a", "a")}, "parameters: must name each fitted parameter once, got 2."),
        ({"values": (1.0,)}, "values: must be 2 finite numbers, one for each parameter, got 1."),
        (
            {"covariance": ((1.0, 0.0),)},
            "covariance: must be 2 rows of 2 numbers, one for each parameter, got 1 rows of "
            "[2] numbers.",
        ),
        ({"covariance": ((1.0, 0.5), (0.4, 1.0))}, "covariance: must be symmetric."),
        ({"covariance": ((1.0, math.nan), (0.4, 1.0))}, "covariance: must be finite."),
        (
            {"covariance": ((4e-8, 1e-5), (1e-5, 4e-4))},
            "covariance: must have no negative eigenvalue: no variance is negative.",
        ),
        ({"residual_noise": -0.1}, "residual_noise: must be at least 0, got -0.1."),
    ],
)
def test_a_covariance_that_is_none_is_refused(change: dict[str, object], expected: str) -> None:
    assert sentences(lambda: replace(FIT, **change)) == [expected]  # type: ignore[arg-type]


def test_a_singular_covariance_is_one() -> None:
    """Two parameters that vary as one: eigenvalue 0 up to rounding, in any units."""
    for scale in (1e-9, 1.0, 1e9):
        v = np.array([1.0, 3.0, -0.7]) * np.array([1.0, scale, 1.0 / scale])
        covariance = tuple(tuple(row) for row in np.outer(v, v).tolist())
        Fit(parameters=("a", "b", "c"), values=(1.0, 2.0, 3.0), covariance=covariance)


# ---- compression of blocks ----


def test_compression_modulus_by_hand() -> None:
    """S = 38/(4 12) = 0.79167; E_c = 0.85 6.9 (1 + 2 0.54 S^2) = 9.834872 MPa."""
    square = Block(width=0.038, height=0.012, stiffening=0.54, contact_fraction=0.85)
    assert square.shape_factor == pytest.approx(38 / 48)
    assert compression_modulus(6.9e6, square) == pytest.approx(9.834872e6, rel=1e-6)
    # S = 40/(2 12) = 5/3; E_c = 0.8 (4/3) 6.9 (1 + 0.54 25/9) = 18.4 MPa
    strip = Block(shape="strip", width=0.04, height=0.012, stiffening=0.54, contact_fraction=0.8)
    assert strip.shape_factor == pytest.approx(5 / 3)
    assert compression_modulus(6.9e6, strip) == pytest.approx(18.4e6)


def test_tall_blocks_do_not_stiffen() -> None:
    """Limit of the formula: S -> 0 gives f E."""
    tall = Block(width=1e-4, height=1.0, contact_fraction=0.5)
    assert compression_modulus(1e6, tall) == pytest.approx(0.5e6)


# ---- remarks ----


def test_another_thickness_follows_the_shape_of_the_blocks() -> None:
    """Source: Gent and Lindley for a square block, E_c ~ 1 + 2 k S^2 with S = a/(4 h), by hand."""
    lagging = load_lagging("diamond-rubber")
    block = lagging.block
    assert block is not None
    thick = lagging.with_thickness(20e-3)
    assert thick.block is not None
    assert thick.block.height == pytest.approx(block.height + 8e-3)
    low, high = (1.0 + 2.0 * block.stiffening * (block.width / (4.0 * h)) ** 2
                 for h in (block.height, block.height + 8e-3))  # fmt: skip
    expected = lagging.compression_modulus * high / low
    assert thick.compression_modulus == pytest.approx(expected, rel=1e-12)
    expected_factor = f"S = {block.width / (4.0 * thick.block.height):.3g}"
    assert expected_factor in str(thick.source_of("compression_modulus"))
    # worn down again it is the first one: its blocks were followed, not its number alone
    again = float(thick.compression_modulus_at(np.array([12e-3]))[0])
    assert again == pytest.approx(lagging.compression_modulus, rel=1e-12)
    assert lagging.with_thickness(12e-3) == lagging
    plain = replace(lagging, block=None)
    assert plain.with_thickness(20e-3).compression_modulus == lagging.compression_modulus
