"""Resistances and tensions of a conveyor against worked examples and closed forms."""

from dataclasses import replace

import pytest

from wraparc import InputError
from wraparc.conveyor import (
    Conveyor,
    State,
    inertia,
    length_coefficient,
    main_resistance,
    slope_resistance,
)
from wraparc.conveyor.resistance import GRAVITY, LENGTH_COEFFICIENTS

# The worked examples take 9.81 m/s2.
ROUNDED = GRAVITY / 9.81
FLAT = Conveyor(
    length=143.0,
    belt_mass=16.44,
    carry_idler_mass=15.5 / 1.2,
    return_idler_mass=13.2 / 3.0,
    capacity=2300.0 / 3.6,
    speed=4.8,
    secondary_resistance=6177.05,
    special_resistance=1912.54,
    take_up_tension=22005.0,
)
UPHILL = Conveyor(
    length=600.0,
    lift=36.0,
    belt_mass=20.0,
    carry_idler_mass=15.0,
    return_idler_mass=5.0,
    material_mass=100.0,
    speed=3.0,
    special_resistance=2e3,
    return_share=0.25,
    start_factor=1.4,
    stop_time=15.0,
    take_up_tension=40e3,
    take_up_distance=150.0,
)


def state(conveyor: Conveyor, name: str) -> State:
    return next(found for found in conveyor.states() if found.name == name)


def test_the_worked_example_of_a_flat_conveyor() -> None:
    """Coal, 2300 t/h over 143 m by ISO 5048: F_H 5142.73 N, F_U 13232.32 N.

    The example of tests/test_flat_conveyor.py of github.com/ScottMcCormack/conveyance, an
    independent implementation; its secondary and special resistances are given here.
    """
    full = state(FLAT, "full")
    assert full.resistances[0].total == pytest.approx(5142.73 * ROUNDED, abs=0.01)
    others = 13232.32 - 5142.73
    assert full.pull == pytest.approx(5142.73 * ROUNDED + others, abs=0.02)
    assert full.exit == 22005.0
    assert full.entry == pytest.approx(22005.0 + full.pull, rel=1e-12)


def test_the_worked_example_with_a_length_coefficient() -> None:
    """By hand, 9.81 m/s2: F_H = 0.02 100 9.81 (10 + 3 + 2 8 + 50) = 1549.98 N; times C(100 m) =
    1.78 it is 2758.96 N; 5 m of lift add 9.81 5 50 = 2452.5 N."""
    flat = Conveyor(
        length=100.0,
        belt_mass=8.0,
        carry_idler_mass=10.0,
        return_idler_mass=3.0,
        material_mass=50.0,
        take_up_tension=10e3,
    )
    assert state(flat, "full").pull == pytest.approx(2758.96 * ROUNDED, abs=0.01)
    lifted = {r.name: r.total for r in state(replace(flat, lift=5.0), "full").resistances}
    assert lifted["slope"] == pytest.approx(2452.5 * ROUNDED, abs=0.01)


@pytest.mark.parametrize(
    ("length", "coefficient"),
    [(80, 1.92), (100, 1.78), (110, 1.74), (200, 1.45), (500, 1.20), (1000, 1.09), (9000, 1.05)],
)
def test_the_length_coefficient_is_that_of_the_table(length: float, coefficient: float) -> None:
    """Values of DIN 22101 as two public implementations have them; linear between."""
    assert length_coefficient(length) == pytest.approx(coefficient, rel=1e-12)


def test_no_value_of_the_table_is_mistyped() -> None:
    """Independent: secondary resistances are those of a belt of some 70 to 105 m, and C falls."""
    lengths, values = map(list, zip(*LENGTH_COEFFICIENTS.items(), strict=True))
    assert lengths == sorted(lengths)
    assert values == sorted(values, reverse=True)
    assert len(set(values)) == len(values)
    for length, value in LENGTH_COEFFICIENTS.items():
        assert 70.0 < (value - 1.0) * length < 105.0, length


def test_there_is_no_length_coefficient_for_short_conveyors() -> None:
    with pytest.raises(InputError, match="below 80 m, where no coefficient C is tabulated"):
        length_coefficient(79.9)


@pytest.mark.parametrize("drive_at", ["head", "tail"])
@pytest.mark.parametrize("lift", [-36.0, 0.0, 36.0])
def test_the_tensions_close_around_the_loop(drive_at: str, lift: float) -> None:
    """Walked strand by strand from the head, with the formulas and nothing else."""
    conveyor = replace(
        UPHILL, drive_at=drive_at, lift=lift, start_factor=None, start_time=20.0,
        take_up_tension=90e3,
    )  # fmt: skip
    accelerations = {"full": 0.0, "empty": 0.0, "start": 3.0 / 20.0, "stop": -3.0 / 15.0}
    states = {found.name: found for found in conveyor.states()}
    assert states.keys() == accelerations.keys()
    for name, acceleration in accelerations.items():
        load = 0.0 if name == "empty" else 100.0
        main = [
            main_resistance(0.02, 600.0, lift, 15.0, 20.0 + load),
            main_resistance(0.02, 600.0, lift, 5.0, 20.0),
        ]
        lumped = 0.17 * sum(main) + 2e3
        carrying = main[0] + 0.75 * lumped + slope_resistance(lift, 20.0 + load)
        carrying += inertia(acceleration, 600.0, 35.0 + load)
        returning = main[1] + 0.25 * lumped + slope_resistance(-lift, 20.0)
        returning += inertia(acceleration, 600.0, 25.0)
        found = states[name]
        assert found.head + returning * 0.25 == pytest.approx(90e3, rel=1e-12)
        assert found.tail == pytest.approx(found.head + returning, rel=1e-12)
        starts, ends = (found.tail, found.entry) if drive_at == "head" else (found.exit, found.head)
        assert ends - starts == pytest.approx(carrying, rel=1e-9)
        assert found.entry - found.exit == pytest.approx(found.pull, rel=1e-12)
        assert found.pull == pytest.approx(carrying + returning, rel=1e-9)


def test_a_start_factor_multiplies_the_pull_of_the_full_conveyor() -> None:
    full, start = state(UPHILL, "full"), state(UPHILL, "start")
    assert start.pull == pytest.approx(1.4 * full.pull, rel=1e-12)
    assert (full.kind, start.kind) == ("running", "starting")


def test_a_horizontal_empty_conveyor_has_friction_alone() -> None:
    """f L g (m'RO + m'RU + 2 m'G) with C = 1.17 at 600 m."""
    flat = replace(UPHILL, lift=0.0, special_resistance=0.0)
    expected = 1.17 * 0.02 * 600.0 * GRAVITY * (15.0 + 5.0 + 2 * 20.0)
    assert state(flat, "empty").pull == pytest.approx(expected, rel=1e-12)


def test_a_loaded_downhill_conveyor_is_held_back() -> None:
    """Its load drives it: T1 < T2 when full, T1 > T2 when empty, where the belt balances itself."""
    downhill = replace(UPHILL, lift=-36.0, start_factor=None, drive_at="tail", take_up_tension=90e3)
    full, empty = state(downhill, "full"), state(downhill, "empty")
    assert full.entry < full.exit
    assert empty.entry > empty.exit
    assert full.resistances[2].total == pytest.approx(-36.0 * GRAVITY * 100.0, rel=1e-12)


def test_the_counterweight_acts_through_its_sheaves() -> None:
    hung = replace(UPHILL, take_up_tension=None, counterweight=8000.0, sheave_ratio=2.0)
    assert hung.take_up == pytest.approx(4000.0 * GRAVITY, rel=1e-12)


def refused(**changes: object) -> list[str]:
    with pytest.raises(InputError) as caught:
        replace(UPHILL, **changes).states()  # type: ignore[arg-type]
    return [f"{p.key}: {p.message}" for p in caught.value.problems]


def test_everything_wrong_is_told_at_once() -> None:
    changes = {"length": -5.0, "belt_mass": 0.0, "capacity": 20.0, "take_up_tension": None}
    assert [told.split(":")[0] for told in refused(**changes, start_time=5.0, speed=None)] == [
        "length", "belt_mass", "capacity", "take_up_tension", "start_time", "capacity",
        "start_time", "stop_time",
    ]  # fmt: skip


def test_what_does_not_fit_together_is_refused() -> None:
    assert refused(lift=700.0) == ["lift: must be less than the length 600 m"]
    assert refused(take_up_distance=601.0)[0].startswith(
        "take_up_distance: must be at most the length"
    )
    assert refused(length=50.0, take_up_distance=0.0)[0].startswith(
        "length: below 80 m, where no coefficient C is tabulated"
    )
    assert refused(drive_at="middle")[0].startswith("drive_at: must be one of head, tail")
    assert "runs by itself" in refused(lift=-36.0, take_up_tension=90e3)[0]
    told = refused(take_up_tension=100.0)
    assert told
    assert all(" in load case " in sentence for sentence in told)


def test_an_unusual_friction_factor_says_so() -> None:
    """The standards give 0.016 to 0.030 for conveyors that are driven."""
    sources = [state(replace(UPHILL, friction_factor=f), "full") for f in (0.016, 0.012)]
    usual, unusual = (found.resistances[0].source for found in sources)
    assert usual.endswith("f = 0.016")
    assert unusual.endswith("f = 0.012, outside the usual 0.016 to 0.030")
