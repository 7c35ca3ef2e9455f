"""A step that is tried may ask a law far off its trends: there it has numbers, and no overflow."""

import math

import pytest

from wraparc.files import drive_from_text
from wraparc.friction.compact import friction_at, peak

#: The trend of A passes 0 at 214.6 kPa, beyond the piece: b/A goes to either infinity there.
LAW = """
format = 1
[belt]
modulus = "66 MN/m"
width = "0.7 m"
[[pulley]]
name = "head"
diameter = "0.6 m"
wrap_angle = "180 deg"
lagging = "own"
entry_tension = "20 kN"
exit_tension = "12 kN"
[lagging.own]
thickness = "10 mm"
shear_modulus = "1 MPa"
[lagging.own.law]
kind = "integral-log"
slip_unit = "mm"
pressure_unit = "kPa"
pieces = [
  { from = "38 kPa", to = "186 kPa", A = "-0.397 + 0.00185 p", b = "-0.864 + 0.00378 p" },
]
"""


@pytest.mark.parametrize("side", [1.0 - 1e-12, 1.0 + 1e-12])
def test_a_peak_far_off_its_trend_is_a_number(side: float) -> None:
    law = drive_from_text(LAW).pulleys[0].lagging.law.compact()
    pressure = side * 0.397 / 0.00185 * 1e3
    assert all(math.isfinite(value) for value in peak(law, 0, pressure)[:2])
    assert math.isfinite(friction_at(law, 0, 0, 1e-3, pressure)[0])
