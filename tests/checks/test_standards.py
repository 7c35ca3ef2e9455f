"""What CEMA and DIN 22101 ask, against their published tables."""

import math

import pytest

from checks.test_rows import lagging, named, quiet
from wraparc.checks import Level
from wraparc.checks.design_standard import find_requirement
from wraparc.drive import Criteria, DesignStandard, TakeUp

GRAVITY, FIXED = TakeUp(kind="gravity"), TakeUp(kind="fixed")

#: CEMA, Belt Conveyors for Bulk Materials, table of the wrap factor Cw (5th edition, table 6-8):
#: wrap [deg], automatic take-up bare and lagged, manual take-up bare and lagged; two digits.
CEMA = [
    (180.0, 0.84, 0.50, 1.2, 0.8),
    (200.0, 0.72, 0.42, 1.0, 0.7),
    (210.0, 0.66, 0.38, 1.0, 0.7),
    (220.0, 0.62, 0.35, 0.9, 0.6),
    (240.0, 0.54, 0.30, 0.8, 0.6),
]


@pytest.mark.parametrize(("wrap", "bare", "lagged", "bare_manual", "lagged_manual"), CEMA)
def test_the_wrap_factors_of_cema(
    wrap: float, bare: float, lagged: float, bare_manual: float, lagged_manual: float
) -> None:
    for surface, take_up, expected in (
        ("bare", GRAVITY, bare), ("rubber", GRAVITY, lagged),
        ("bare", FIXED, bare_manual), ("rubber", FIXED, lagged_manual),
    ):  # fmt: skip
        found = find_requirement(
            DesignStandard(name="CEMA"), take_up, lagging(surface=surface), math.radians(wrap)
        )
        assert found is not None
        assert found.wrap_factor == pytest.approx(expected, abs=0.0101)  # the table's last digit
        assert "CEMA" in found.source


def test_between_two_rows_of_the_manual_table_the_safe_one_counts() -> None:
    found = find_requirement(DesignStandard(), FIXED, lagging(), math.radians(190.0))
    assert found is not None
    assert found.wrap_factor == 0.8
    outside = find_requirement(DesignStandard(), FIXED, lagging(), math.radians(170.0))
    assert outside is not None
    assert math.isnan(outside.wrap_factor)
    assert "from 180 deg" in outside.why_not


#: DIN 22101, friction between belt and rubber lagging with grooves: lower end of each value.
DIN = [("dry", 0.40), ("wet", 0.35), ("wet and dirty", 0.25)]


@pytest.mark.parametrize(("condition", "friction"), DIN)
def test_the_friction_of_din_22101_goes_by_the_condition(condition: str, friction: float) -> None:
    found = find_requirement(
        DesignStandard(name="DIN 22101", condition=condition), GRAVITY, lagging(), math.pi
    )
    assert found is not None
    assert found.wrap_factor == pytest.approx(1.0 / math.expm1(friction * math.pi))
    own = find_requirement(
        DesignStandard(name="DIN 22101"), GRAVITY, lagging(condition=condition), math.pi
    )
    assert own == found


def test_a_rule_of_ones_own_and_none() -> None:
    own = find_requirement(
        DesignStandard(name="own", friction=0.3), GRAVITY, lagging(surface=""), math.pi
    )
    assert own is not None
    assert own.wrap_factor == pytest.approx(1.0 / math.expm1(0.3 * math.pi))
    assert find_requirement(DesignStandard(name="none"), GRAVITY, lagging(), math.pi) is None
    silent = find_requirement(DesignStandard(), GRAVITY, lagging(surface=""), math.pi)
    assert silent is not None
    assert silent.why_not == "plain has no surface"


def test_a_printed_drive_factor_keeps_the_standard() -> None:
    """CEMA prints 0.38 at 210 degrees of lagged wrap, where 1/(exp(0.35 phi) - 1) is 0.3835."""
    wrap = {"wrap_angle": math.radians(210.0)}
    kept = named(
        quiet(entry=138e3, leaving=38e3, pulley=wrap, criteria=Criteria()), "design_standard"
    )
    assert kept.level is Level.OK
    assert kept.limit == pytest.approx(38e3)
    # at 180 degrees it prints 0.50 for 0.4992: the exact one is kept too
    exact = named(quiet(entry=149.95e3, leaving=49.95e3, criteria=Criteria()), "design_standard")
    assert exact.level is Level.OK
    assert exact.limit == pytest.approx(1e5 / math.expm1(0.35 * math.pi))
    missed = named(quiet(entry=137.9e3, leaving=37.9e3, pulley=wrap, criteria=Criteria()),
                   "design_standard")  # fmt: skip
    assert missed.level is Level.ATTENTION
