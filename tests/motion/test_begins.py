"""A run that begins in the running state begins in the one that `solve` finds."""

from pathlib import Path

import pytest

from wraparc.motion.file import motion_from_text
from wraparc.motion.march import March
from wraparc.motion.station_state import steady_of

TANDEM = (Path(__file__).parents[2] / "examples" / "tandem-fabric.toml").read_text("utf-8")
#: Friction that holds until it slips, on little rubber: most of the wrap sticks.
THIN = """
[lagging.thin]
thickness = "3 mm"
shear_modulus = "2.3 MPa"
compression_modulus = "rigid"
law = { kind = "constant", friction = 0.5 }
"""


@pytest.mark.parametrize("points", [50, 100])
def test_thin_lagging_of_constant_friction_starts_from_the_solved_state(points: int) -> None:
    motion = motion_from_text(TANDEM.replace('"diamond-rubber"', '"thin"') + THIN)
    march = March(motion.station, motion.event("run-out"), points=points)
    for drum, member in zip(march.drums, steady_of(motion.station).members, strict=True):
        # expected: the closed march of `solve`; pieces of a wrap miss it by 1/points^2 and so
        assert float(drum.arc.creep()[-1]) == pytest.approx(member.arc.exit_creep, rel=5e-4)
        assert drum.arc.entry == pytest.approx(member.arc.entry_tension, rel=1e-9)
