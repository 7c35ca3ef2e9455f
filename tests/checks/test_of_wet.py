"""The creep when wet that is estimated of a drive computed dry only.

Expected values are those of the same drive solved in its wet condition, in which the law is scaled
and not the arc.
"""

from dataclasses import replace
from tomllib import loads

import pytest

from checks.test_of_rows import of_rows, one_by_one
from checks.test_rows import NONE, judged, lagging, quiet
from judgement.rows import BASE, TANDEM, TURNED
from wraparc import Drive, InputError, load_lagging, solve
from wraparc.checks import Check, Level, judge
from wraparc.drive import TakeUp
from wraparc.files import drive_from_document
from wraparc.files.write import drive_document
from wraparc.train import solve_train
from wraparc.train.file import train_from_document
from wraparc.units import in_units

OPEN = replace(NONE, covered=False)
SOFT = load_lagging("diamond-rubber")


def wet_checks(of: Drive) -> list[Check]:
    return [c for c in judge(solve(of, raise_on_failure=False)).checks if c.name == "wet_creep"]


@pytest.mark.parametrize("entry", [80e3, 100e3, 160e3])
def test_the_estimate_is_the_creep_of_the_drive_solved_wet(entry: float) -> None:
    of = quiet(lagging=SOFT, entry=entry, criteria=OPEN)
    (estimate,) = wet_checks(of)
    (wet,) = solve(drive_from_document(drive_document(of) | {"condition": "wet"}))
    assert estimate.value == pytest.approx(abs(wet.exit_creep), rel=1e-6)
    assert estimate.value > 1.05 * abs(solve(of).arcs[0].exit_creep)


def test_an_estimate_beyond_the_limit_asks_for_attention() -> None:
    of = quiet(lagging=SOFT, criteria=OPEN)
    (passes,) = wet_checks(of)
    assert judged(of).level is passes.level is Level.OK
    tight = replace(of, creep_limit=0.99 * passes.value)
    verdict = judged(tight)
    assert [c.name for c in verdict.missed] == ["wet_creep"]
    assert verdict.level is Level.ATTENTION
    assert verdict.label == "ATTENTION"


def test_a_creep_that_exceeds_its_limit_dry_is_told_once() -> None:
    of = quiet(lagging=SOFT, criteria=OPEN, creep_limit=6e-4)
    assert [c.name for c in judged(of).missed] == ["creep"]
    assert of_rows(of) == one_by_one(of)


def test_a_drive_that_slips_wet_has_no_number() -> None:
    of = quiet(lagging=lagging(0.3, surface="bare"), criteria=OPEN, creep_limit=0.06)
    (check,) = wet_checks(of)
    assert check.value == float("inf")
    said = in_units(judged(of).text)
    assert "Gross slip when wet, with dry friction times 0.267 (estimated)" in said


def test_unknown_wet_friction_is_said_in_the_word() -> None:
    of = quiet(lagging=lagging(surface=""), criteria=OPEN)
    verdict = judged(of)
    assert verdict.label == "OK (dry)"
    assert verdict.wet is not None
    assert verdict.wet.level is Level.NOT_CHECKED
    assert verdict.wet_text == "Not checked: plain has no wet friction."


def test_what_is_not_computed_dry_only_has_no_estimate() -> None:
    covered = quiet(lagging=SOFT, criteria=NONE)
    assert wet_checks(covered) == []
    document = drive_document(quiet(lagging=SOFT, criteria=OPEN))
    for condition in ("wet", ["dry", "wet"], "wet and dirty"):
        assert wet_checks(drive_from_document(document | {"condition": condition})) == []
    assert len(wet_checks(drive_from_document(document | {"condition": "dry"}))) == 1


def test_a_load_case_solved_wet_leaves_no_estimate_of_the_others() -> None:
    text = BASE + TURNED.format(entry="50 kN", exit="75 kN")
    dry, wet = (
        loads(text),
        loads(text.replace('kind = "braking"', 'kind = "braking"\ncondition = "wet"')),
    )
    assert len(wet_checks(drive_from_document(dry))) == 2
    assert wet_checks(drive_from_document(wet)) == []
    # and a load case that alone is dry has none
    alone = loads(text.replace('kind = "braking"', 'kind = "braking"\ncondition = "dry"'))
    assert wet_checks(drive_from_document(alone | {"condition": "wet"})) == []


def test_an_idle_pulley_has_no_estimate() -> None:
    assert wet_checks(quiet(lagging=SOFT, criteria=OPEN, entry=60e3)) == []


def test_a_train_has_the_estimate_of_its_drives() -> None:
    result = solve_train(train_from_document(loads(TANDEM)))
    of_train = [c.value for c in judge(result).checks if c.name == "wet_creep"]
    of_drive = [c.value for c in judge(result.drive_result()).checks if c.name == "wet_creep"]
    assert len(of_train) == 2
    assert of_train == of_drive


@pytest.mark.parametrize("text", [BASE, TANDEM])
@pytest.mark.parametrize(
    "condition", ['condition = "wet"', 'condition = ["dry", "Wet and dirty"]', "load case"]
)
def test_a_covered_drive_with_a_wet_condition_is_refused(text: str, condition: str) -> None:
    read = train_from_document if text is TANDEM else drive_from_document
    plain = text.replace("format = 1", "format = 1\ncovered = true")
    assert read(loads(plain)).criteria.covered
    if condition == "load case":
        of_case = "train." if text is TANDEM else "pulley.head."
        given = (
            plain
            + f'[[load_case]]\nname = "rain"\ncondition = "wet"\n{of_case}exit_tension = "70 kN"\n'
        )
    else:
        given = plain.replace("format = 1", f"format = 1\n{condition}").replace(
            "Wet and", "wet and"
        )
    with pytest.raises(InputError, match="covered"):
        read(loads(given))
    dusty = plain.replace(
        "format = 1", 'format = 1\ncondition = { name = "dusty", friction_factor = 0.8 }'
    )
    assert read(loads(dusty)).criteria.covered


def test_covered_is_written_and_read_again() -> None:
    of = quiet(lagging=SOFT, criteria=replace(OPEN, covered=True, take_up=TakeUp(kind="winch")))
    document = drive_document(of)
    assert document["covered"] is True
    assert drive_from_document(document) == of
    assert "covered" not in drive_document(quiet(lagging=SOFT, criteria=OPEN))
