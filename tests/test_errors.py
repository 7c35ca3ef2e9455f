"""What the user reads. Expected sentences are written out: the wording is the interface."""

import copy

import pytest

from wraparc import (
    BreakawayError,
    ConvergenceError,
    InputError,
    Kind,
    MissingExtraError,
    Problem,
    Provenance,
    WraparcError,
)
from wraparc.errors import shown

COMMA = Problem(
    message="a comma can mean decimal point or thousands separator",
    remedy='Write "1.5 kN".',
    file="drive.toml",
    key="pulley.head.exit_tension",
    value='"1,5 kN"',
)


def test_a_problem_names_place_value_cause_and_remedy() -> None:
    assert str(COMMA) == (
        "drive.toml: pulley.head.exit_tension: a comma can mean decimal point or thousands "
        'separator, got "1,5 kN". Write "1.5 kN".'
    )


@pytest.mark.parametrize(
    ("problem", "text"),
    [
        (Problem(message="is empty"), "is empty."),
        (Problem(message="Is it empty?"), "Is it empty?"),
        (Problem(message="is empty", file="a.csv", line=7), "a.csv, line 7: is empty."),
        (Problem(message="is empty", line=7), "line 7: is empty."),
        (Problem(message="is missing", key="belt.width"), "belt.width: is missing."),
        (Problem(message="no unit", value="5", remedy="Write one"), "no unit, got 5. Write one."),
    ],
)
def test_a_problem_leaves_out_what_it_does_not_know(problem: Problem, text: str) -> None:
    assert str(problem) == text


def test_an_input_error_lists_every_problem() -> None:
    assert str(InputError(COMMA)) == str(COMMA)
    both = InputError([COMMA, Problem(message="is missing", key="belt.width")])
    assert len(both.problems) == 2
    assert str(both) == f"2 problems:\n  - {COMMA}\n  - belt.width: is missing."


def test_an_input_error_without_a_problem_is_a_mistake_in_the_program() -> None:
    with pytest.raises(TypeError, match="at least one Problem"):
        InputError([])


def test_the_tree() -> None:
    for kind in (InputError, MissingExtraError, BreakawayError, ConvergenceError):
        assert issubclass(kind, WraparcError)
    assert issubclass(InputError, ValueError)
    assert issubclass(MissingExtraError, ImportError)


def test_a_missing_extra_says_how_to_get_it() -> None:
    error = MissingExtraError("matplotlib", "plot")
    assert str(error) == "needs matplotlib: pip install 'wraparc[plot]'"
    assert (error.library, error.extra) == ("matplotlib", "plot")


def test_a_breakaway_carries_its_result() -> None:
    error = BreakawayError("the belt slips through", result={"capacity": 2.5})
    assert str(error) == "the belt slips through"
    assert error.result == {"capacity": 2.5}


@pytest.mark.parametrize(
    "error",
    [
        InputError([COMMA, COMMA]),
        MissingExtraError("scipy", "fit"),
        BreakawayError("slips", result=(1, 2)),
        ConvergenceError("400 steps"),
    ],
)
def test_errors_survive_the_way_back_from_a_worker(error: WraparcError) -> None:
    # deepcopy takes the same road (__reduce_ex__) as sending to another process.
    again = copy.deepcopy(error)
    assert type(again) is type(error)
    assert str(again) == str(error)
    assert again.args == error.args


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("1,5 kN", '"1,5 kN"'),
        (1200, "1200"),
        (True, "true"),
        (None, "null"),
        ("µm °", '"µm °"'),
        ("\x1b[31mred\n", '"\\u001b[31mred\\n"'),
        ("\u202eevil", '"\\u202eevil"'),
        ("x" * 500, '"' + "x" * 55 + '..."'),
        ([1] * 500, "[1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1..."),
        (float("nan"), "NaN"),
    ],
)
def test_values_are_shown_short_and_harmless(value: object, text: str) -> None:
    assert shown(value) == text
    assert len(text) <= 60
    assert text.isprintable()


def test_a_value_that_contains_itself_is_shown_by_its_type() -> None:
    loop: list[object] = []
    loop.append(loop)
    assert shown(loop) == "<list>"


def test_a_source_is_told_with_its_kind() -> None:
    assert str(Provenance()) == "input"
    assert str(Provenance(Kind.ILLUSTRATIVE)) == "illustrative"
    published = Provenance(Kind.PUBLISHED, "Maker, catalogue", "2012", "rated values")
    assert str(published) == "published: Maker, catalogue, 2012 (rated values)"


def test_published_without_a_source_is_refused() -> None:
    with pytest.raises(InputError) as caught:
        Provenance(Kind.PUBLISHED, source=" ")
    assert str(caught.value) == (
        "a published number without a source. "
        "Name the publication, or call the number given or illustrative."
    )
