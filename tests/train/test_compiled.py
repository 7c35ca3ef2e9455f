"""The march of a pulley of a train, compiled, against the interpreter."""

import math

import numpy as np
import pytest

from arc.drives import LAWS, random_arc
from wraparc.arc.kernel.effort import shoot_from
from wraparc.arc.kernel.quantities import parameters_at, zeros
from wraparc.train import compiled


@pytest.mark.parametrize("name", LAWS)
def test_compiled_is_what_the_interpreter_gives(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Source: the same function, interpreted; exp and log round differently."""
    monkeypatch.setitem(compiled._ready, "compiled", False)
    assert compiled.prepare()
    rng = np.random.default_rng(5)
    for _ in range(6):
        arc = random_arc(LAWS[name], rng)
        par, law = parameters_at(arc.entry_tension, arc.geometry()), arc.law.compact()
        for z in (0.3, 1.2):
            shot, _ = shoot_from(law, par, z, 24, 0, zeros(0))
            found = tuple(compiled.shoot(law, par, z, 24))
            assert found == pytest.approx(tuple(shot), rel=1e-9, abs=1e-15)


def test_more_than_numbers_hold_is_not_finite(monkeypatch: pytest.MonkeyPatch) -> None:
    arc = random_arc(LAWS["rubber"], np.random.default_rng(5))
    par, law = parameters_at(arc.entry_tension, arc.geometry()), arc.law.compact()
    for ready in (False, True):
        monkeypatch.setitem(compiled._ready, "compiled", ready)
        shot = compiled.shoot(law, par._replace(radius=1e-4, side=-1.0), 8e2, 24)
        assert not math.isfinite(shot.log_tension)
    assert math.isfinite(compiled.shoot(law, par, 1.0, 24).log_tension)
