"""The overrun at the entry nip: its formula, and what one towards travel would do.

Expected values: by hand, and tests/arc/twin.py, SciPy's DOP853 on creep and tension.
"""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq

from arc.drives import ARC
from arc.twin import Twin
from wraparc.arc import WrapArc
from wraparc.arc.wrap_arc import overrun_coefficient
from wraparc.batch.arcs import Arcs
from wraparc.batch.laws import LawBank

SIZE = 1e-4


def test_the_formula() -> None:
    """delta = (h/E_c) p1 = 12 mm/9 MPa x 400 kPa = 0.5333 mm; 1.25 delta sqrt(delta/0.4 m)."""
    delta = 0.012 / 9e6 * 400e3
    found = overrun_coefficient(0.012 / 9e6, 0.4) * 400e3**1.5
    assert found == pytest.approx(1.25 * delta * math.sqrt(delta / 0.4), rel=1e-14)


def test_one_arc_and_a_batch_have_it_from_the_same_function() -> None:
    arc = replace(ARC, overrun=None, compression_modulus=9e6)
    columns = {
        "entry_tension": arc.entry_tension, "exit_tension": arc.exit_tension,
        "diameter": arc.diameter, "wrap_angle": arc.wrap_angle, "belt_width": arc.width,
        "belt_modulus": arc.axial_stiffness / arc.width, "lagging_thickness": arc.thickness,
        "shear_modulus": arc.shear_modulus, "compression_modulus": arc.compression_modulus,
    }  # fmt: skip
    batch = Arcs(
        laws=LawBank.of([arc.law]),
        law=np.zeros(1, dtype=np.int64),
        **{name: np.array([value]) for name, value in columns.items()},
        **dict.fromkeys(("overrun", "belt_speed", "wear_coefficient"), np.array([math.nan])),
        recovery=np.ones(1),
        creep_limit=np.array([arc.creep_limit]),
    )
    assert arc.geometry().kick_coefficient in batch.inputs()[0]
    pressure = arc.entry_pressure
    assert arc.entry_overrun == pytest.approx(
        arc.geometry().kick_coefficient * pressure**1.5, rel=1e-14
    )


def creep_with(arc: WrapArc, overrun: float) -> float:
    """Creep at the exit by the twin, which takes an overrun of either sign [m]."""
    twin = Twin(replace(arc, overrun=abs(overrun)))
    twin.kick = overrun
    goal = math.log(arc.exit_tension / arc.entry_tension)
    g = brentq(lambda ratio: twin.integrate(ratio).log_tension - goal, -1e-3, 3e-2, rtol=1e-9)
    return twin.integrate(float(g)).creep


def test_an_overrun_towards_travel_adds_the_creep_that_one_rearward_saves() -> None:
    """What the refusal of a negative overrun tells to do, for friction without memory.

    A driving pulley then works against its drive until slip passes zero, and creeps more than with
    no overrun at all: neither 0 nor the rearward size is the worse case.
    """
    none, rearward, forward = (creep_with(ARC, x) for x in (0.0, SIZE, -SIZE))
    assert rearward < none < forward
    assert forward - none == pytest.approx(none - rearward, rel=0.1)
    assert forward == pytest.approx(2.0 * none - rearward, rel=1e-2)
