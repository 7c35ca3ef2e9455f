"""The compiled march across the width against the one in arrays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from across.test_exact import LAWS
from across.wides import CORD, FABRIC, braking, crown, wide
from wraparc.across import AcrossSolver, compiled
from wraparc.across.compiled import COMPILED, PLAIN
from wraparc.across.march import Array
from wraparc.arc import WrapArc


def _miss(found: Array, expected: Array) -> float:
    return float(np.max(np.abs(found - expected)) / np.max(np.abs(expected)))


@pytest.mark.parametrize("name", [*LAWS, "cord"])
def test_compiled_is_what_arrays_give(name: str) -> None:
    """Source: the same equations marched by NumPy; to 1e-10 of the largest value."""
    arc: WrapArc = replace(CORD, overrun=None, recovery=False)
    if name != "cord":
        driven = braking(FABRIC) if name in ("power", "softening") else FABRIC
        tension = 0.8 * driven.entry_tension + 30e3
        arc = replace(driven, law=LAWS[name], entry_tension=tension)
    given = wide(arc, 8, 1e5, radius_deviation=crown(0.4e-3, 8))
    slow = AcrossSolver(marches=PLAIN).solve(given)
    fast = AcrossSolver(marches=COMPILED).solve(given)
    assert fast.status is slow.status
    assert fast.status.solved
    assert fast.iterations == slow.iterations
    for field in ("tension", "creep", "slip", "shear_stress", "frictional_energy", "lag"):
        assert _miss(getattr(fast.fields, field), getattr(slow.fields, field)) < 1e-10
    assert fast.drum_number == pytest.approx(slow.drum_number, rel=1e-10)


def test_without_a_compiler_it_is_arrays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "available", lambda: False)
    monkeypatch.setitem(compiled._ready, "compiled", False)
    assert compiled.prepare() is False
    assert AcrossSolver().marches is PLAIN


def test_what_is_prepared_is_used(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(compiled._ready, "compiled", False)
    assert AcrossSolver().marches is PLAIN
    assert compiled.prepare() is True
    assert AcrossSolver().marches is COMPILED
