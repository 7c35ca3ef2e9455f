"""Equations of a note: every law has its own, and they follow what was used."""

from dataclasses import replace

from answer.drives import solved
from wraparc.friction import FrictionLaw
from wraparc.render.equations import equations


def test_every_law_has_its_equation() -> None:
    laws = [c for c in FrictionLaw.__subclasses__() if c.__module__.startswith("wraparc.")]
    assert len({law.title for law in laws}) == len({law.equation for law in laws}) == len(laws)


def test_equations_follow_what_was_used() -> None:
    arcs = solved().arcs
    titles = [e.title for e in equations(arcs, paper=False, train=False, design=False)]
    assert any(t.startswith("Entry overrun") for t in titles)
    given = [replace(arcs[0], arc=replace(arcs[0].arc, overrun=0.0, recovery=False))]
    fewer = [e.title for e in equations(given, paper=False, train=False, design=False)]
    assert not any(t.startswith("Entry overrun") for t in fewer)
    assert any("recovery" in t for t in titles)
    assert not any("recovery" in t for t in fewer)
    for e in equations(arcs, paper=True, train=True, design=True):
        assert e.words
        assert e.latex.count("{") == e.latex.count("}")
