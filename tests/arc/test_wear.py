"""Wear along the wrap against the energy of the solver, life against its definition by hand."""

import math
from dataclasses import replace

import pytest

from answer.drives import drive, solved
from wraparc import load_lagging, solve
from wraparc.answer.sheet import shown
from wraparc.answer.wear_table import life_data, life_table, wear_table
from wraparc.arc.wear import coefficient_of_life, frictional_power, wear_life
from wraparc.choose.cost import lagging_cost
from wraparc.drive import Cost
from wraparc.drive.pitch import turns_an_hour

#: 3 m/s on a drum of 0.8 m, by hand: 3 * 3600 / (pi 0.8).
PASSES = 4297.183463481174


@pytest.mark.parametrize("leaving", [60e3, 100e3, 190e3])
@pytest.mark.parametrize("parts", [1, 6, 40])
def test_the_parts_sum_to_the_sliding_power(leaving: float, parts: int) -> None:
    """The identity of the energy balance: sum of power and area is v_s B int tau dx."""
    result = solved(150e3, leaving).arcs[0]
    edges, power = frictional_power(result, parts)
    arc = result.arc
    area = arc.width * arc.radius * (edges[1:] - edges[:-1])
    assert float((area * power).sum()) == pytest.approx(result.energy.sliding_power, rel=1e-12)
    assert edges[-1] == arc.wrap_angle


def test_each_part_is_the_product_of_shear_stress_and_slip_speed() -> None:
    """tau v_s dx/ds at the middle of a narrow part, dx/ds = g + (T1 - T)/EA' - (h/G) dtau/ds."""
    result = solved().arcs[0]
    edges, power = frictional_power(result, 90)
    p, arc = result.profile, result.arc
    k = 60
    here = 0.5 * (edges[k] + edges[k + 1])
    at = min(range(len(p)), key=lambda i: abs(p.position[i] - here))
    slope = (p.shear_stress[at + 1] - p.shear_stress[at - 1]) / (
        arc.radius * (p.position[at + 1] - p.position[at - 1])
    )
    rate = result.entry_creep_ratio + (arc.entry_tension - p.tension[at]) * arc.compliance
    speed = 3.0 / (1.0 - result.entry_creep_ratio)
    expected = p.shear_stress[at] * speed * (rate - arc.shear_compliance * slope)
    assert power[k] == pytest.approx(expected, rel=0.02)


def test_without_a_belt_speed_there_is_no_power() -> None:
    still = drive()
    result = solve(replace(still, belt=replace(still.belt, speed=None))).arcs[0]
    assert math.isnan(frictional_power(result)[1][0])
    assert shown(wear_table(result, load_lagging("diamond-rubber")), "si") is None
    assert shown(life_table(result, load_lagging("diamond-rubber")), "si") is None


def test_life_is_depth_over_wear() -> None:
    assert turns_an_hour(3.0, 0.4) == pytest.approx(PASSES)
    hours = wear_life(6e-3, 2e-13, 280.0, PASSES)
    assert hours == pytest.approx(6e-3 / (2e-13 * 280.0 * PASSES))
    assert coefficient_of_life(6e-3, hours, 280.0, PASSES) == pytest.approx(2e-13)
    assert wear_life(6e-3, 0.0, 280.0, PASSES) == math.inf


def test_more_creep_wears_sooner_where_a_vendor_states_one_life() -> None:
    lagging = replace(load_lagging("diamond-rubber"), wear_coefficient=2e-13)
    lives = []
    for leaving in (60e3, 100e3):
        data = life_data(solve(drive(150e3, leaving, lagging)).arcs[0], lagging)
        assert data is not None
        lives.append(data["life_hours"])
        (vendor,) = data["vendors"]
        assert vendor["years"] == [1, 2]
        for years, k in zip((2, 1), vendor["coefficient"], strict=True):
            hours = wear_life(data["depth"], k, data["frictional_energy"], PASSES)
            assert hours == pytest.approx(6000.0 * years)
    assert lives[0] < 0.5 * lives[1]


def test_energy_is_split_where_a_ratio_is_given() -> None:
    lagging = replace(load_lagging("diamond-rubber"), belt_energy_share=0.25)
    table = shown(wear_table(solved().arcs[0], lagging), "si")
    assert table is not None
    assert table.heads == ("frictional power", "belt", "lagging")
    whole, belt, rest = (float(v.split()[0].replace(",", "")) for v in table.rows[-1].values)
    # each is told in three digits
    assert belt == pytest.approx(0.25 * whole, rel=5e-3)
    assert belt + rest == pytest.approx(whole, rel=5e-3)
    told = wear_table(solved().arcs[0], load_lagging("diamond-rubber"))
    assert told is not None
    assert "is not said" in told.note


def test_a_lagging_whose_wear_is_known_is_bought_by_it() -> None:
    """Two years of life over ten: five laggings, where the vendor's 1 to 2 years take 5 to 10."""
    cost = Cost(material=100.0, installation=0.0, currency="AUD", area=1.0, life_years=(1, 2))
    assert [float(v) for v in lagging_cost(cost, 1.0, 10.0)] == [700.0, 500.0, 1000.0]
    assert [float(v) for v in lagging_cost(cost, 1.0, 10.0, 4.0)] == [300.0] * 3
