"""Whatever is in a file, the answer is a drive or sentences: nothing else is ever raised."""

import string
from typing import Any

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from files.samples import EXAMPLE_DRIVES
from files.samples import example as example_file
from wraparc import InputError
from wraparc.catalogue import lagging_names, lagging_text
from wraparc.files import (
    drive_from_document,
    drive_from_text,
    lagging_from_document,
    lagging_from_text,
    overridden,
)
from wraparc.schema.source import decoded, parse

DRIVES = [example_file(name).read_text("utf-8") for name in EXAMPLE_DRIVES]
LAGGINGS = [lagging_text(name) for name in lagging_names()]
EVERYTHING = """format = 1
[belt]
width = "1 m"
modulus = "10 MN/m"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = { preset = "own", thickness = "5 mm" }
entry_tension = "100 kN"
exit_tension = "50 kN"
[lagging.own]
thickness = "12 mm"
elastic_modulus = "6.9 MPa"
block = { shape = "strip", width = "30 mm" }
cost = { material = 1, installation = 2, currency = "EUR", area = "6 m2", life_years = [1, 2] }
sources = { law = { kind = "measured", source = "x" } }
[[lagging.own.law]]
kind = "integral-log"
slip_unit = "mm"
pressure_unit = "kPa"
pieces = [
  { from = "34 kPa", to = "172 kPa", A = "-0.08 + 2.2e-4 p", b = "-0.30 + 8e-4 p" },
]
[[lagging.own.law]]
condition = "wet"
kind = "table"
slip = ["0 mm", "5 mm"]
rows = [{ pressure = "10 psi", friction = [0, 0.5] }]
[[lagging.own.law]]
condition = "dirty"
kind = "elastic-plastic"
friction = 0.3
stiffness = "190 kPa/mm"
fit = { parameters = ["friction"], values = [0.3], covariance = [[1e-4]] }
[[load_case]]
name = "start"
pulley.head.torque = "30 kN m"
pulley.head.exit_tension = "50 kN"
"""
DRIVES.append(EVERYTHING)


def answered(problem: InputError) -> None:
    """Every problem is a sentence that can be shown as it is."""
    assert problem.problems
    for found in problem.problems:
        sentence = str(found)
        assert sentence.strip()
        assert len(sentence) < 3000
        assert all(c.isprintable() for c in sentence), sentence


def read(text: str) -> None:
    for reader in (drive_from_text, lagging_from_text):
        try:
            reader(text)
        except InputError as problem:
            answered(problem)


def test_the_samples_are_good() -> None:
    for text in DRIVES:
        drive_from_text(text)
    for text in LAGGINGS:
        lagging_from_text(text)


@given(st.text(max_size=200))
@example("\ufeffformat = 1")
@example("format = 1\r\n\r")
@example('"\\ud800" = 1')
@example("a = '''\n")
def test_any_text(text: str) -> None:
    read(text)


@given(st.binary(max_size=200))
def test_any_bytes(data: bytes) -> None:
    try:
        text = decoded(data, "in.toml")
    except InputError as problem:
        answered(problem)
    else:
        read(text)


@settings(max_examples=300)
@given(
    st.sampled_from(DRIVES + LAGGINGS),
    st.lists(
        st.tuples(
            st.integers(0, 4000),
            st.integers(0, 12),
            st.text(string.printable + "é°µ\u2212\x00\x1b", max_size=8),
        ),
        min_size=1,
        max_size=4,
    ),
)
def test_good_files_with_characters_changed(text: str, edits: list[tuple[int, int, str]]) -> None:
    for position, length, insert in edits:
        at = position % (len(text) + 1)
        text = text[:at] + insert + text[at + length :]
    read(text)


NUMBERS = st.sampled_from(
    ["0", "-0", "1", "-1", "1e-300", "1e300", "1e308", "9" * 60, "1e-320", "nan", "inf", "1,5"]
) | st.floats().map(str)
UNITS = st.sampled_from(["", "mm", "m", "kN", "kPa", "deg", "1/mm", "kN/m", "m/s", "W", "%", "x y"])
QUANTITIES = st.builds(lambda number, unit: f"{number} {unit}", NUMBERS, UNITS)
SCALARS: st.SearchStrategy[object] = st.one_of(
    QUANTITIES,
    st.text(max_size=10),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.dates(),
    st.none().map(lambda _: {}),
    st.just([]),
)
ANYTHING = st.recursive(
    SCALARS,
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3)
    ),
    max_leaves=5,
)


def places(node: Any, place: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the place of everything in a document."""
    items: Any = ()
    if isinstance(node, dict):
        items = node.items()
    elif isinstance(node, list):
        items = enumerate(node)
    return [place, *(found for key, item in items for found in places(item, (*place, key)))][
        0 if place else 1 :
    ]


def with_value(node: Any, place: tuple[Any, ...], value: object) -> Any:
    if not place:
        return value
    copy = node.copy()
    copy[place[0]] = with_value(node[place[0]], place[1:], value)
    return copy


@settings(max_examples=400, suppress_health_check=[HealthCheck.too_slow])
@given(st.data())
def test_good_documents_with_values_changed(data: st.DataObject) -> None:
    text = data.draw(st.sampled_from(DRIVES + LAGGINGS))
    document = parse(text)
    for _ in range(data.draw(st.integers(1, 3))):
        place = data.draw(st.sampled_from(places(document)))
        document = with_value(document, place, data.draw(QUANTITIES | ANYTHING))
    reader = drive_from_document if text in DRIVES else lagging_from_document
    try:
        reader(document)
    except InputError as problem:
        answered(problem)


@settings(max_examples=200)
@given(
    st.lists(
        st.sampled_from(["pulley.head.", "belt.", "load_case[1].", "lagging.own.", ""])
        .flatmap(lambda head: st.text(max_size=12).map(lambda tail: head + tail))
        .flatmap(lambda path: st.text(max_size=12).map(lambda value: f"{path}={value}"))
        | st.text(max_size=30),
        min_size=1,
        max_size=3,
    )
)
def test_any_override(overrides: list[str]) -> None:
    try:
        document = overridden(parse(EVERYTHING), overrides)
        drive_from_document(document)
    except InputError as problem:
        answered(problem)


def test_a_key_without_a_name_hides_nothing() -> None:
    """Seen when an empty name stood for the key that makes others needless."""
    document = with_value(parse(lagging_text("diamond-rubber")), ("block",), {"": {}})
    with pytest.raises(InputError, match=r"block\.width: missing"):
        lagging_from_document(document)
