"""Scaled laws against the law they scale, design ratios against the published values."""

from dataclasses import replace

import numpy as np
import pytest

from wraparc import (
    CoefficientPieces,
    Constant,
    ElasticPlastic,
    FrictionLaw,
    InputError,
    IntegralLog,
    Kind,
    MeasuredTable,
    Piece,
    PressurePower,
    Trend,
    load_lagging,
)
from wraparc.catalogue import lagging_costs
from wraparc.choose.cost import catalogue_price, energy_cost, lagging_cost, purchases
from wraparc.drive.conditions import Condition, design_ratio

PIECES = IntegralLog(
    coefficients=CoefficientPieces(
        pressure=(5e4, 5e5),
        pieces=(
            Piece(
                a=Trend(form="power", coefficients=(-1.0, -0.2), sign=-1),
                b=Trend(coefficients=(-0.15, 1e-8)),
                post_peak_slope=Trend(coefficients=(-5.0,)),
                residual_friction=Trend(coefficients=(0.2,)),
            ),
        ),
        slip_unit=1e-3,
    )
)
LAWS: dict[str, FrictionLaw] = {
    "knots": load_lagging("full-ceramic").law,
    "pieces": PIECES,
    "constant": Constant(friction_coefficient=0.35),
    "elastic": ElasticPlastic(stiffness=4e7, friction_coefficient=0.4),
    "power": PressurePower(friction_coefficient=0.5, reference_pressure=2e5, exponent=0.3),
    "table": MeasuredTable(
        slip=(0.0, 2e-3, 8e-3), pressure=(1e5, 3e5), values=((0.0, 0.5, 0.8), (0.0, 0.4, 0.6))
    ),
}


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize(("friction", "slip"), [(0.8, 1.0), (1.0, 1.3), (0.7, 0.6)])
def test_a_scaled_law_is_the_law_scaled(name: str, friction: float, slip: float) -> None:
    """Its definition: mu'(x, p) = f mu(x/s, p), on a grid past every peak."""
    law = LAWS[name]
    x = np.linspace(0.0, 30e-3, 61)[:, None]
    p = np.array([4e4, 1.5e5, 4e5, 8e5])
    got = law.scaled(friction, slip).friction(x, p)
    assert np.allclose(got, friction * law.friction(x / slip, p), rtol=1e-12, atol=1e-15)


def test_design_ratios_are_those_of_the_published_values() -> None:
    """DIN 22101 family: rubber wet 0.35 over dry 0.40-0.45; ceramic 0.35-0.40 over 0.40-0.45."""
    ratio, source = design_ratio("DIN 22101", "rubber", "wet")
    assert ratio == pytest.approx(0.35 / 0.425)
    assert source.kind is Kind.PUBLISHED
    assert "rubber wet 0.35 over dry 0.4-0.45" in source.note
    assert design_ratio("DIN 22101", "ceramic", "wet")[0] == pytest.approx(0.375 / 0.425)
    with pytest.raises(InputError, match='no design values dry and "wet" of surface "rubber"'):
        design_ratio("CEMA", "rubber", "wet")


def test_a_condition_marks_where_its_friction_came_from() -> None:
    rubber = load_lagging("diamond-rubber")
    wet = Condition(name="wet", standard="DIN 22101").lagging(rubber)
    assert wet.condition == "wet"
    assert wet.source_of("law") == rubber.source_of("law"), "a scaled law stands on the tested one"
    assert wet.sources["condition"].kind is Kind.PUBLISHED
    assert wet.source_of("thickness") == rubber.source_of("thickness")
    assert Condition(name="dry").lagging(rubber) is rubber
    by_surface = Condition(name="wet", factor=0.9, factors={"rubber": 0.7})
    assert by_surface.factor_of(rubber)[0] == 0.7
    with pytest.raises(InputError, match="has no friction in this condition"):
        Condition(name="dusty").lagging(rubber)


def test_without_a_standard_the_ratio_is_of_one_table() -> None:
    """DIN 22101: ceramic wet 0.35-0.40 over 0.40-0.45, rubber 0.35 over 0.40-0.45: their order."""
    ceramic, rubber = (load_lagging(n) for n in ("full-ceramic", "diamond-rubber"))
    factor, source = Condition(name="wet").factor_of(ceramic)
    assert factor == pytest.approx(0.375 / 0.425)
    assert "middle values, 0.778 to 1" in source.note
    dirty = Condition(name="wet and dirty").factor_of(ceramic)[0]
    assert dirty == pytest.approx(0.35 / 0.425)
    assert Condition(name="wet and dirty").factor_of(rubber)[0] < dirty < factor
    assert Condition(name="wet").factor_of(rubber)[0] == pytest.approx(0.35 / 0.425)


def test_a_law_tested_wet_is_scaled_to_dry_by_the_inverse() -> None:
    rubber = load_lagging("diamond-rubber")
    wet = Condition(name="wet", standard="DIN 22101").lagging(rubber)
    factor, _ = Condition(name="dry", standard="DIN 22101").factor_of(wet)
    assert factor == pytest.approx(0.425 / 0.35)


def test_a_law_of_the_condition_is_taken_before_any_is_scaled() -> None:
    rubber = load_lagging("diamond-rubber")
    tested = replace(rubber, condition="wet", law=rubber.law.scaled(0.5))
    assert Condition(name="wet", factor=0.9).of((rubber, tested)) is tested
    scaled = Condition(name="wet and dirty").of((tested, rubber))
    expected = 0.275 / 0.425 * rubber.law.friction(5e-3, 2e5)
    assert scaled.law.friction(5e-3, 2e5) == pytest.approx(float(expected))


def test_ten_year_costs_are_the_vendors() -> None:
    """Elastotec's own: 8,600 and 8,950 for ceramic; 27,750 between lives of 1 and 2 years."""
    for row in lagging_costs():
        price = catalogue_price(load_lagging("full-ceramic"), row.name)
        assert price is not None
        middle, least, most = lagging_cost(price.cost, row.area, 10.0)
        if row.surface == "ceramic":
            assert middle == least == most == row.ten_year_cost
        else:
            assert least < row.ten_year_cost < most
            assert (float(least), float(most)) == (5 * 4625.0, 10 * 4625.0)


def test_lagging_is_bought_whole() -> None:
    assert purchases(10.0, [10.0, 9.9, 3.0, 20.0]).tolist() == [1, 2, 4, 1]


def test_energy_is_priced_by_the_hour() -> None:
    """2 kW over 5000 h a year and 10 years are 100,000 kWh."""
    assert energy_cost(2000.0, 5000.0, 0.2, 10.0) == pytest.approx(20_000.0)
