"""Other laws side by side: the law that made the tests is found to be the best of them."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from cli.running import wraparc
from shear_test.virtual import fitted, laboratory, single
from wraparc.answer.shear_test_standard import laws_table
from wraparc.answer.sheet import shown
from wraparc.friction import Constant
from wraparc.shear_test.alternatives import AlternativeLaw, alternative_laws


def laws(law: Any, **rig: Any) -> dict[str, AlternativeLaw]:
    plan, records = laboratory(
        pressures=[100e3, 200e3], repeats=2, law=law, shear_compliance=0.0, points=600, **rig
    )
    condition = fitted(replace(plan, thickness=None), records).conditions[0]
    found = alternative_laws(condition)
    assert [law.criterion for law in found] == sorted(law.criterion for law in found)
    assert sum(law.best_of for law in found) == 4
    return {law.name: law for law in found}


@pytest.mark.parametrize(
    ("law", "best"),
    [
        (single(0.8, 16e-3), "integral-log"),
        (
            single(0.8, 4e-3, post_peak_slope=-20.0, residual_friction=0.1),
            "integral-log, then a line",
        ),
        (Constant(friction_coefficient=0.5), "constant"),
    ],
)
def test_the_law_behind_the_tests_is_the_best(law: Any, best: str) -> None:
    found = laws(law)
    assert next(iter(found)) == best
    # noise of 1 % of the largest friction, averaged over the readings of a bin
    assert found[best].remainder < 0.012


def test_parameters_are_counted_with_the_lash() -> None:
    found = laws(single(0.8, 16e-3))
    assert {name: law.parameters for name, law in found.items()} == {
        "integral-log": 3,
        "integral-log, then a line": 4,
        "constant": 2,
        "power of slip": 3,
        "table of 10 slips": 11,
    }
    # the wrong law is far off, in friction and in the criterion
    assert found["constant"].remainder > 10 * found["integral-log"].remainder
    assert found["constant"].criterion > found["integral-log"].criterion + 100


def test_they_stand_side_by_side() -> None:
    plan, records = laboratory(pressures=[200e3], repeats=1, points=300)
    table = shown(laws_table(fitted(plan, records).conditions[0], " (dry)"), "si")
    assert table.title == "Laws side by side (dry)"
    assert table.heads == ("parameters", "remainder", "AICc", "best of 1")
    assert table.rows[0].values[2] == "0.0"
    assert float(table.rows[-1].values[2]) > 0


def test_they_are_asked_for_by_name(tmp_path: Path) -> None:
    assert wraparc("rig", tmp_path / "lab", "--pressures", "69", "--repeats", 1, "--points", 60,
                   "--dialect", "bluehill").code == 0  # fmt: skip
    plan = tmp_path / "lab" / "plan.toml"
    assert "Laws side by side" not in wraparc("fit", plan, "--full").words
    assert "Laws side by side" in wraparc("fit", plan, "--compare-laws", "--full").words
    document = wraparc("fit", plan, "--compare-laws", "--json", "-").json
    laws = document["conditions"][0]["laws"]
    assert len(laws) == 5
    assert {"name", "parameters", "remainder", "criterion", "best_of"} == laws[0].keys()
