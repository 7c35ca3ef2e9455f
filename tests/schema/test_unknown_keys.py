"""Which key may be meant is sought for what is listed: the work does not grow with the faults."""

import json
from typing import Any
from unittest.mock import patch

import pytest

from wraparc import errors
from wraparc.errors import InputError
from wraparc.files import drive_from_document
from wraparc.web.examples import examples


def drive() -> dict[str, Any]:
    """Return a copy of the first example."""
    return dict(json.loads(json.dumps(examples()[0].document)))


def comparisons(document: dict[str, Any]) -> tuple[int, InputError]:
    """Return how many pairs of words are compared until a document is refused, and how."""
    with (
        patch.object(errors, "_likeness", wraps=errors._likeness) as compared,
        pytest.raises(InputError) as refused,
    ):
        drive_from_document(document)
    return compared.call_count, refused.value


@pytest.mark.parametrize(("sources", "many"), [(False, 5000), (True, 200)])
def test_many_unknown_keys_cost_no_more_than_those_listed(sources: bool, many: int) -> None:
    counts = []
    for number in (60, many):
        document = drive()
        belt = document["belt"]
        place = belt.setdefault("sources", {}) if sources else belt
        place.update({f"{i}-modulas": {"kind": "given"} for i in range(number)})
        count, error = comparisons(document)
        assert len(error.problems) == 51
        assert "more problems" in error.problems[-1].message
        assert "modulus" in error.problems[0].remedy
        counts.append(count)
    assert counts[0] == counts[1] > 0


def test_many_words_that_are_no_choice_cost_no_more_than_those_listed() -> None:
    counts = []
    for number in (60, 1000):
        document = drive()
        document["load_case"] = [{"name": f"case {i}", "kind": "runing"} for i in range(number)]
        count, error = comparisons(document)
        assert len(error.problems) == 51
        assert '"running"' in error.problems[0].remedy
        counts.append(count)
    assert counts[0] == counts[1] > 0
