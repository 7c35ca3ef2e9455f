"""Gross slip of one arc, compiled, against the interpreter: the same functions."""

import numpy as np
import pytest

from arc.drives import LAWS, random_arc
from wraparc.checks import compiled
from wraparc.checks.gross_slip import Grip, Rise, pull_factor


@pytest.mark.parametrize("name", LAWS)
def test_compiled_is_what_the_interpreter_gives(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Source: the same functions, interpreted; exp and log round differently."""
    rng = np.random.default_rng(7)
    for _ in range(4):
        arc = random_arc(LAWS[name], rng)
        pull = abs(arc.effective_tension)
        found = []
        for ready in (False, True):
            monkeypatch.setitem(compiled._ready, "compiled", ready)
            rises = (Rise(pull, 0.0), Rise(0.5 * pull, -0.5 * pull), Rise(0.0, -pull))
            found.append([pull_factor(arc, Grip(arc), rise) for rise in rises])
        assert found[1] == pytest.approx(found[0], rel=1e-9)


def test_it_is_in_use_once_it_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(compiled._ready, "compiled", False)
    assert compiled.prepare()
    assert compiled._ready["compiled"]
