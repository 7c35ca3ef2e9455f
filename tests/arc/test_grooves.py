"""Laggings of blocks beside a twin that knows blocks and grooves, and no modulus of the gross area.

The rubber of modulus G covers the fraction f of the surface. A strip of belt as wide as the pulley
presses and pulls on strips of rubber that are f B wide together: they bear p/f and tau/f, and each
shears by h tau/(f G) and is squeezed by h p/(f E) at the stiffness of its own shape.
"""

import tomllib
from dataclasses import replace
from math import atan, copysign, exp, inf, sqrt
from pathlib import Path
from typing import Any

import pytest
from scipy.optimize import brentq

import wraparc.catalogue
from arc.twin import Twin
from wraparc.arc import Distributed, WrapArc
from wraparc.files import load_lagging

DATA = Path(wraparc.catalogue.__file__).parent / "data" / "laggings"
DRIVES = {"driving": (150e3, 70e3), "lightly driving": (60e3, 52e3), "braking": (55e3, 110e3)}


class Grooved(Twin):
    """An arc over blocks, described by its lagging file alone."""

    def __init__(self, arc: WrapArc, table: dict[str, Any]) -> None:
        # of the arc only what is no part of the elasticity of its lagging
        super().__init__(replace(arc, thickness=0.0, shear_modulus=inf, compression_modulus=inf))
        block, self.height = table["block"], 1e-3 * millimetres(table["thickness"])
        self.part = block["contact_fraction"]
        young = 1e6 * float(table["elastic_modulus"].removesuffix(" MPa"))
        self.modulus = young / 3.0  # of rubber, which keeps its volume
        shape = 1e-3 * millimetres(block["width"]) / self.height
        factors = (4 / 3, 1 / 4) if block.get("shape") == "strip" else (1, 2 / 16)
        stiffness = factors[0] * young * (1 + factors[1] * block["stiffening"] * shape**2)
        # the surface of the blocks runs nearer to the shell by so much for every newton of tension
        squeeze = self.height * self.pressure(1.0) / self.part / stiffness
        self.compliance += squeeze / self.radius
        delta = squeeze * arc.entry_tension
        self.overrun_constant = 1.25 * delta * sqrt(delta / self.radius)

    def bears(self, u: float, p: float) -> float:
        """Shear stress of the blocks [Pa]: friction over the area that they have."""
        mu, size = self.mu(p), abs(u)
        if size == 0.0:
            return 0.0

        def lacks(x: float) -> float:
            shear: float = self.height * (mu(x) * p / self.part) / self.modulus
            return x + shear - size

        x = float(brentq(lacks, 0.0, size, xtol=1e-18, rtol=1e-15))
        return copysign(mu(x) * p / self.part, u)

    def stress(self, u: float, p: float) -> tuple[float, float]:
        tau = self.bears(u, p)
        return tau, u - self.height * tau / self.modulus

    def _rates(self, g: float, xi: float, q: float, u: float) -> tuple[float, float]:
        tension, ds = self.arc.entry_tension * exp(q), 4 * self.length * xi**3
        force = self.bears(u, self.pressure(tension)) * self.part * self.arc.width
        return -force / tension * ds, (
            g + (self.arc.entry_tension - tension) * self.compliance
        ) * ds


def millimetres(text: str) -> float:
    return float(text.removesuffix(" mm"))


@pytest.mark.parametrize("drive", DRIVES)
@pytest.mark.parametrize("name", ["diamond-rubber", "medium-ceramic", "full-ceramic"])
def test_shipped_blocks_shear_and_yield_by_what_they_bear(name: str, drive: str) -> None:
    """Creep, slip and shear angle: the contact fraction is counted once, in shear and squeeze."""
    lagging, (entry, leaving) = load_lagging(name), DRIVES[drive]
    arc = WrapArc(
        law=lagging.law, entry_tension=entry, exit_tension=leaving, diameter=0.8,
        wrap_angle=3.3, width=1.2, axial_stiffness=1.2 * 12.96e6, thickness=lagging.thickness,
        shear_modulus=lagging.shear_modulus, compression_modulus=lagging.compression_modulus,
    )  # fmt: skip
    result = Distributed(capacities=False).solve(arc)
    twin = Grooved(arc, tomllib.loads((DATA / f"{name}.toml").read_text("utf-8")))
    _, told = twin.solve_near(result.entry_creep_ratio)
    assert result.exit_creep == pytest.approx(told.creep, rel=1e-6)
    assert result.exit_slip == pytest.approx(told.slip, rel=1e-6)
    assert result.peak_shear_angle == pytest.approx(atan(told.peak_stress / twin.modulus), rel=1e-6)
