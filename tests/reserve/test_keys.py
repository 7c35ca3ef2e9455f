"""Keys by which an input of a reserve is changed: the drive that they make has the level named."""

import tomllib
from pathlib import Path
from typing import Any

import pytest

from wraparc.actions.document import setting
from wraparc.answer.reserve_words import rounded_change
from wraparc.checks import judge
from wraparc.checks.action import Change
from wraparc.reserve import Flip, find_reserve
from wraparc.reserve.keys import ReserveKeys
from wraparc.schema.overrides import put_over
from wraparc.train.file import drive_or_train_from_document
from wraparc.train.keys import TRAIN_FILE
from wraparc.train.whole import Whole, solved

EXAMPLES = Path(__file__).parents[2] / "examples"
#: Examples, and the inputs of their reserves that keys change.
DRIVES = {
    "head-drive-fabric": {"effective_tension", "slack_tension", "wrap_angle"},
    "steel-cord-drive": {"effective_tension", "slack_tension", "diameter"},
    "downhill-braking": {"belt_modulus", "slack_tension", "wrap_angle", "diameter"},
    "tandem-fabric": {"effective_tension", "slack_tension", "wrap_angle", "diameter"},
    "uphill-conveyor": {"belt_modulus", "slack_tension", "start_factor"},
}


def document(name: str) -> dict[str, Any]:
    return tomllib.loads((EXAMPLES / f"{name}.toml").read_text("utf-8"))


def settings(result: Whole) -> list[tuple[Flip, tuple[Change, ...]]]:
    keys = ReserveKeys.of(result)
    return [
        (flip, keys.changes(flip.input, 1.0 + rounded_change(flip.change)))
        for flip in find_reserve(result).flips
    ]


def changed(of: dict[str, Any], changes: tuple[Change, ...]) -> Whole:
    values = {change.key: setting(change) for change in changes}
    return solved(drive_or_train_from_document(put_over(of, values, TRAIN_FILE)))


@pytest.mark.parametrize("name", DRIVES)
def test_a_change_by_keys_has_the_level_that_is_named(name: str) -> None:
    # expected: the reserve, which is found without any file; the changed file is read and solved
    of = document(name)
    found = [(flip, changes) for flip, changes in settings(changed(of, ())) if changes]
    assert {flip.input.name for flip, _ in found} == DRIVES[name]
    for flip, changes in found:
        told = (flip.input, flip.change)
        assert judge(changed(of, changes)).level is flip.level, told


def test_what_no_key_changes_has_none() -> None:
    # friction and slip are of the law of a lagging; a conveyor has its own resistances, and an
    # entry tension that all load cases share is no multiple of the effective tension of each
    for name, inputs in (
        ("head-drive-fabric", {"friction"}),
        ("downhill-braking", {"friction", "slip", "effective_tension"}),
        ("uphill-conveyor", {"friction", "slip", "effective_tension"}),
    ):
        found = settings(changed(document(name), ()))
        without = {flip.input.name for flip, changes in found if not changes}
        assert inputs <= without, name


def test_numbers_of_a_lagging_are_put_over_those_of_the_catalogue() -> None:
    # expected: by hand, the number of the present drive and 1.5 times that
    result = changed(document("tandem-fabric"), ())
    keys = ReserveKeys.of(result)
    (of,) = [i for i in find_reserve(result).inputs if i == ("lagging_thickness", i.pulleys, "")]
    first, second = keys.changes(of, 1.5)
    assert first.key == "pulley.first.lagging.thickness"
    assert second.key == "pulley.second.lagging.thickness"
    for change, pulley in zip((first, second), keys.drive.pulleys, strict=True):
        assert change.before == pulley.lagging.thickness
        assert change.after == pytest.approx(1.5 * pulley.lagging.thickness, rel=1e-12)
        assert change.unit == "m"
