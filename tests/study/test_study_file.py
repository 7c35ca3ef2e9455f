"""Study files that cannot be used: every fault is told before any work."""

from pathlib import Path
from typing import Any

import pytest

from study.studies import FRICTION, SAMPLING, TAKE_UP, study_of
from wraparc.errors import InputError
from wraparc.study.file import load_study
from wraparc.study.parameter_study import JUDGED

NORMAL = {"field": "belt.modulus", "distribution": "normal", "mean": "12 MN/m"}

BAD: list[tuple[list[dict[str, Any]], dict[str, Any], str]] = [
    (
        [{**TAKE_UP, "field": "pulley.head.exit_tenson"}],
        {},
        ('no such drive field, got "pulley.head.exit_tenson". Did you mean '
         '"exit_tension"'),
    ),
    ([{**TAKE_UP, "field": "pulley.tail.exit_tension"}], {}, 'nothing called "tail"'),
    ([{**TAKE_UP, "field": "pulley..x"}], {}, "no key path"),
    ([{**TAKE_UP, "field": "belt.width.x"}], {}, "belt.width is a value, with nothing below it"),
    ([{"field": "belt", "values": ["x"]}], {}, "the field is a table, not a value"),
    ([{"field": "description", "values": ["one", "another"]}], {}, "changes nothing on pull"),
    ([{**TAKE_UP, "to": "90 kPa"}], {}, "a pressure, where a force is needed"),
    ([{**TAKE_UP, "to": "40 kN"}], {}, "must differ from the first"),
    ([{**TAKE_UP, "count": 1}], {}, "must be a whole number from 2"),
    ([{**TAKE_UP, "values": ["50 kN"]}], {}, "needs values, from/to/count or a distribution"),
    ([{"field": "belt.modulus"}], {}, "needs values, from/to/count or a distribution"),
    ([{"field": "belt.modulus", "values": ["1 MN/m", "1000 kN/m"]}], {}, "contains a value twice"),
    ([{"field": "belt.modulus", "values": ["nan kN/m"]}], {}, 'finite number, got "nan kN/m"'),
    ([{"field": "pulley.head.lagging", "values": ["diamond-ruber"]}], {}, "Did you mean"),
    (
        [{**NORMAL, "standard_deviation": "-1 MN/m"}],
        {"sampling": SAMPLING},
        "standard_deviation: must be more than 0 and finite",
    ),
    ([NORMAL], {"sampling": SAMPLING}, "standard_deviation: missing"),
    (
        [{**NORMAL, "standard_deviation": "1 MN/m", "mode": "1 MN/m"}],
        {"sampling": SAMPLING},
        "mode: is no number of a normal distribution",
    ),
    ([{**NORMAL, "mean": "-900 MN/m", "standard_deviation": "1 MN/m"}], {"sampling": SAMPLING},
     "of the distribution lies within its limits"),
    ([FRICTION], {}, "sampling: missing, and something is drawn at random"),
    ([TAKE_UP], {"sampling": SAMPLING}, "nothing is drawn at random"),
    ([FRICTION, {**FRICTION, "field": "pulley[1].lagging.friction_factor"}], {"sampling": SAMPLING},
     "two axes vary the same field"),
    ([{"field": "pulley.head.lagging", "distribution": "fit"}], {"sampling": SAMPLING},
     'lagging diamond-rubber has no fit to draw from, got "pulley.head.lagging"'),
    ([{"field": "belt.width", "distribution": "fit"}], {"sampling": SAMPLING},
     'must be the lagging of a pulley, got "belt.width"'),
    ([{"field": "belt.preset", "distribution": "uniform", "from": 1, "to": 2}],
     {"sampling": SAMPLING}, "the field is no number"),
    ([FRICTION], {"sampling": {**SAMPLING, "samples": 0}}, "must be a whole number from 1"),
    ([FRICTION], {"sampling": {**SAMPLING, "method": "sobl"}}, 'Did you mean "sobol"?'),
    ([FRICTION], {"sampling": {"samples": 5}}, "seed: missing"),
    ([TAKE_UP], {"load_cases": ["stat"]}, 'no such load case, got "stat". Did you mean "start"?'),
    ([TAKE_UP], {"pulley": "hed"}, 'no such pulley, got "hed". Did you mean "head"?'),
    ([TAKE_UP], {"drive": "no.toml"}, "no.toml: file not found."),
    ([TAKE_UP], {"outputs": ["exit_crep"]}, ('no such result, got "exit_crep". Did you mean '
                                             '"exit_creep"')),
    ([TAKE_UP], {"sensitivity": {}}, "needs every axis to have a distribution"),
    ([TAKE_UP], {"colour": 1}, "colour: unknown key"),
    ([TAKE_UP], {"condition": [{"name": "wet", "share": 0.2}, {"name": "dry"}]}, "Give all one"),
    ([TAKE_UP], {"condition": [{"name": "wet", "share": 0.2}]}, "add up to 0.2, not to 1"),
    ([TAKE_UP], {"condition": [{"name": "wet"}, {"name": "wet"}]}, "have the same name"),
    ([TAKE_UP], {"condition": [{"name": "wet", "friction_factor": -1}]}, "must be more than 0"),
    ([TAKE_UP], {"set": ["belt.widht=1 m"]}, "Did you mean \"width\"?"),
    ([{**TAKE_UP, "from": "-40 kN"}], {}, "must be between 0.0001 kN"),
    ([], {}, "must have 1 to 200 entries"),
]  # fmt: skip


@pytest.mark.parametrize("number", range(len(BAD)))
def test_what_cannot_be_is_told(number: int) -> None:
    axes, keys, sentence = BAD[number]
    with pytest.raises(InputError) as caught:
        study_of(*axes, **keys)
    assert sentence in str(caught.value)


def test_all_faults_are_told_at_once() -> None:
    with pytest.raises(InputError) as caught:
        study_of({**TAKE_UP, "field": "belt.wdth"}, FRICTION, pulley="tail", outputs=["x"])
    text = str(caught.value)
    for part in ("belt.wdth", "tail", "outputs"):
        assert part in text


def test_a_distribution_is_cut_where_the_field_ends_and_says_so() -> None:
    axis = {**NORMAL, "standard_deviation": "8 MN/m"}
    asked = study_of(axis, sampling=SAMPLING)
    assert (
        "Modulus of the belt: 6.7 % of the distribution is outside its limits" in asked.remarks[0]
    )
    assert asked.study.plan.values(0, 100)["belt.modulus"].min() > 0.0


def test_a_study_takes_its_laggings_along(tmp_path: Path) -> None:
    """Another computer has not the files of this one: they are part of the description."""
    from wraparc.files import load_lagging, save_lagging

    save_lagging([load_lagging("diamond-rubber")], tmp_path / "own.toml")
    asked = study_of(
        TAKE_UP,
        {"field": "pulley.head.lagging.thickness", "values": ["10 mm", "12 mm"]},
        set=[f"pulley.head.lagging={tmp_path / 'own.toml'}"],
    )
    before = asked.study.solve(0, 2)
    (tmp_path / "own.toml").unlink()
    after = asked.study.solve(0, 2)
    assert (before["exit_creep"] == after["exit_creep"]).all()
    assert str(tmp_path) not in str(asked.study.description["drive"])


def test_the_fingerprint_is_that_of_the_numbers() -> None:
    one = study_of(TAKE_UP, title="one").study.fingerprint
    assert study_of(TAKE_UP, title="another").study.fingerprint == one
    for other in (
        study_of({**TAKE_UP, "count": 7}),
        study_of(TAKE_UP, setting="precise"),
        study_of(TAKE_UP, load_cases=["start"]),
        study_of(TAKE_UP, set=["belt.width=1300 mm"]),
        study_of(TAKE_UP, outputs=["exit_creep"]),
    ):
        assert other.study.fingerprint != one


@pytest.mark.parametrize(
    "name", ["take-up-grid", "tolerances", "wet-dry", "sensitivity", "load-cases"]
)
def test_the_examples_can_be_read(name: str) -> None:
    path = Path(__file__).parents[2] / "examples" / "studies" / f"{name}.toml"
    asked = load_study(path)
    assert asked.study.rows >= 24
    assert any("illustrative" in source for source in asked.sources)


def test_what_changes_the_verdict_alone_may_be_varied() -> None:
    axis = {"field": "belt.rating", "values": ["90 kN/m", "200 kN/m"]}
    columns = study_of(axis, load_cases=["design"]).study.solve(0, 2)
    assert [JUDGED["verdict"][code] for code in columns["verdict"]] == ["FAILS", "ATTENTION"]
    governing = [JUDGED["governing"][code] for code in columns["governing"]]
    assert governing == ["belt_tension", "wet_creep"]
    assert columns["exit_creep"][0] == columns["exit_creep"][1]


def wet_governs(*names: str) -> list[bool]:
    """Whether the wet estimate governs, condition by condition, where only it is missed."""
    axis = {"field": "belt.rating", "values": ["200 kN/m", "210 kN/m"]}
    conditions = [{"name": name, "friction_factor": 1.0} for name in names]
    of = study_of(axis, load_cases=["design"], condition=conditions)
    columns = of.study.solve(0, 2)
    return [JUDGED["governing"][code] == "wet_creep" for code in columns["governing"][: len(names)]]


def test_the_wet_estimate_is_of_dry_rows_that_have_no_wet_ones_beside_them() -> None:
    assert wet_governs("dry") == [True]
    assert wet_governs("dry", "dusty") == [True, False]
    assert wet_governs("dry", "wet") == [False, False]


def test_a_wet_condition_of_a_covered_drive_is_refused() -> None:
    axis = {"field": "belt.rating", "values": ["200 kN/m", "210 kN/m"]}
    more = {"load_cases": ["design"], "set": ["covered=true"]}
    study_of(axis, **more, condition=[{"name": "dusty", "friction_factor": 0.9}])
    with pytest.raises(InputError, match="condition: contradicts covered = true"):
        study_of(axis, **more, condition=[{"name": "wet", "friction_factor": 0.9}])


@pytest.mark.parametrize(
    ("field", "cases"),
    [
        ("belt.width", ("design",)),  # 90 kN; the start, 186 kN - 60 kN, is no running case
        ("pulley.head.exit_tension", ("design",)),  # only there
        ("load_case.start.pulley.head.exit_tension", ("start",)),
    ],
)
def test_without_a_load_case_a_study_is_of_the_largest_pull(
    field: str, cases: tuple[str, ...]
) -> None:
    values = ["1200 mm", "1300 mm"] if field == "belt.width" else ["60 kN", "70 kN"]
    assert study_of({"field": field, "values": values}).study.load_cases == cases
