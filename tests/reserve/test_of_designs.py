"""Designs of a search by their reserve: the same as of each design alone."""

from pathlib import Path

import pytest

from cli.running import wraparc
from reserve.follow import level_of
from wraparc.choose.file import load_search
from wraparc.choose.selection import choose
from wraparc.reserve.of_designs import rank_by_reserve

EXAMPLE = Path(__file__).parents[2] / "examples" / "wet-season" / "choose.toml"


def test_designs_are_ranked_by_their_nearest_worse_change() -> None:
    """Expected: the drive of each design with the change, solved and judged arc by arc."""
    selection = choose(load_search(EXAMPLE))
    ranked = rank_by_reserve(selection)
    assert {of.design for of in ranked} == {int(i) for i in selection.ranking[:12]}
    orders = [(of.level.rank, -of.units) for of in ranked]
    assert orders == sorted(orders)
    followed = 0
    for of in ranked:
        levels = set()
        for result in selection.results(of.design):
            if of.flip is not None:
                levels.add(level_of(result, of.flip.input, of.flip.change))
                before = level_of(result, of.flip.input, 0.97 * of.flip.change)
                assert before != of.flip.level
                followed += 1
        assert of.flip is None or of.flip.level in levels
    assert followed


def test_the_command_lists_them_in_that_order() -> None:
    told = wraparc("choose", EXAMPLE, "--by-reserve", "--table", "ranking", "--json", "-")
    assert told.code == 0, told.err
    plain = wraparc("choose", EXAMPLE, "--table", "ranking")
    assert "reserve" not in plain.out
    listed = wraparc("choose", EXAMPLE, "--by-reserve", "--table", "ranking")
    assert "Designs that pass, by reserve" in listed.out
    assert "Te +66 %: FAILS" in listed.words
    reserves = told.json["by_reserve"]
    assert [of["reserve"] and of["reserve"]["level"] for of in reserves] == [None, "FAILS"]
    assert reserves[1]["reserve"]["change"] == pytest.approx(0.654, abs=0.02)
