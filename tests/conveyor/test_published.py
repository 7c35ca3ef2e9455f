"""Worked examples of others, within the rounding of their print.

The flat conveyor is the worked example of the public program conveyance (S. McCormack,
github.com/ScottMcCormack/conveyance, tests/flat_conveyor.yaml and test_flat_conveyor.py), by
ISO 5048: coal, 143 m, 2300 t/h, 1200 mm at 4.8 m/s. It takes g = 9.81 m/s2.
"""

import pytest

from wraparc.conveyor import (
    GRAVITY,
    CleanerResistance,
    Conveyor,
    LoadingPoint,
    PointResistance,
    PulleyResistance,
    SkirtResistance,
)
from wraparc.conveyor.local import loading_force

G = 9.81 / GRAVITY
FLAT = {
    "length": 143.0, "belt_mass": 16.44, "carry_idler_mass": 15.5 / 1.2,
    "return_idler_mass": 13.2 / 3.0, "speed": 4.8, "take_up_tension": 22e3, "width": 1.2,
    "thickness": 0.0125,
}  # fmt: skip
COAL = LoadingPoint(
    name="coal", capacity=2300.0 / 3.6, skirt_width=0.75, density=850.0, belt_friction=0.5,
    skirt_friction=0.7,
)  # fmt: skip
SKIRTS = SkirtResistance(length=4.8, width=0.75, density=850.0, friction=0.7)
CLEANERS = CleanerResistance(width=1.2, thickness=0.008, pressure=3e4, friction=0.6, count=4)


def test_the_resistances_of_the_flat_conveyor() -> None:
    """F_H 5142.73 N, F_bA + F_f 3066.7 + 2390.38 N, F_gL 1221.34 N, F_rc 691.2 N, F_U 13232.32 N.

    Both pulleys take 360 N each by the simple rule that it begins with.
    """
    flat = Conveyor(
        **FLAT,  # type: ignore[arg-type]
        loadings=(COAL,),
        locals=(SKIRTS, CLEANERS, PointResistance(at="tail", force=720.0)),
    )
    full = flat.states()[0]
    found = {r.name: r.total for r in full.resistances}
    assert G * found["main"] == pytest.approx(5142.73, abs=0.01)
    # the length over which the material is accelerated goes by 1/g: its skirts do not have g
    assert found["loading"] == pytest.approx(3066.7 + 2390.38, abs=0.1)
    assert G * found["skirt"] == pytest.approx(1221.34, abs=0.01)
    assert found["cleaner"] == pytest.approx(691.2, abs=0.1)
    assert full.pull == pytest.approx(13232.32, rel=5e-4)
    assert flat.material == pytest.approx(133.1, abs=0.05)
    assert full.pull * 4.8 / (0.95 * 0.97) == pytest.approx(68.93e3, rel=5e-4)  # at the motor


def test_the_loading_of_a_conveyor_by_the_indian_standard() -> None:
    """R_a = 757.2 N: 960 t/h landing at rest on 2.84 m/s (scribd.com/doc/179172760, IS 11592)."""
    point = LoadingPoint(name="ash", capacity=960.0 / 3.6)
    assert loading_force(point, 960.0 / 3.6, 2.84) == pytest.approx(757.2, abs=0.2)


def test_the_pulleys_of_the_flat_conveyor() -> None:
    """153 N at the drive between 35237.40 and 22005.08 N, 141 N at the tail."""
    drive = PulleyResistance(diameter=0.6, shaft_diameter=0.14, mass=1050.0)
    tail = PulleyResistance(at="tail", diameter=0.5, shaft_diameter=0.12, mass=800.0)
    for pulley, mean, printed in (
        (drive, 0.5 * (35237.40 + 22005.08), 153.0), (tail, 22005.08, 141.0),
    ):  # fmt: skip
        wrap = pulley.wrap(mean, 1.2, 0.0125, steel=False)
        assert wrap + pulley.bearing(mean) == pytest.approx(printed, abs=0.5)


def test_the_tension_that_keeps_the_flat_conveyor_from_sagging() -> None:
    """22005 N on the carrying strand at a sag of 1 %, 3024 N on the return strand at 2 %."""
    from wraparc.drive import Sag

    loaded = 16.44 + 2300.0 / 3.6 / 4.8
    carry = Sag(spacing=1.2, line_mass=loaded, share=0.01)
    back = Sag(spacing=3.0, line_mass=16.44, share=0.02)
    assert G * carry.tension == pytest.approx(22005.0, abs=1.0)
    assert G * back.tension == pytest.approx(3024.0, abs=1.0)
