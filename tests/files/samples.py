"""Drives and laggings of every kind, drawn at random, for tests of writing and reading."""

import math
from collections.abc import Callable
from itertools import accumulate
from pathlib import Path
from typing import Literal

from hypothesis import strategies as st

from wraparc import Kind, Provenance
from wraparc.catalogue import belts
from wraparc.drive import Belt, Cost, Drive, Fit, Lagging, LoadCase, Pulley, Tensions
from wraparc.files import load_lagging
from wraparc.files.lagging_keys import LAGGING_FILE
from wraparc.friction import (
    CoefficientPieces,
    Constant,
    ElasticPlastic,
    FrictionLaw,
    IntegralLog,
    MeasuredTable,
    Piece,
    PressureKnots,
    PressurePower,
    TestedRange,
    Trend,
)
from wraparc.schema.kinds import Text

#: The example drives that one drive file alone describes.
EXAMPLE_DRIVES = (
    "downhill-braking",
    "head-drive-fabric",
    "steel-cord-drive",
    "test-pulley-calibrated",
    "uphill-conveyor",
    "worn-head-drive-fabric",
    "worn-head-drive-steel-cord",
)


def example(name: str) -> Path:
    """Return the path of an example file."""
    return Path(__file__).parents[2] / "examples" / f"{name}.toml"


def numbers(least: float, most: float) -> st.SearchStrategy[float]:
    return st.floats(least, most, allow_nan=False, allow_infinity=False)


def ascending(least: float, most: float, count: int) -> st.SearchStrategy[tuple[float, ...]]:
    """Numbers at least a hundredth of the range apart, so that no spline overflows."""
    steps = st.lists(numbers(0.05, 1.0), min_size=count, max_size=count)

    def scaled(parts: list[float]) -> tuple[float, ...]:
        total = sum(parts) + 0.05
        return tuple(least + (most - least) * value / total for value in accumulate(parts))

    return steps.map(scaled)


NAMES = st.text(
    st.characters(categories=("L", "N", "P", "Zs"), include_characters='".\\#='),
    min_size=1,
    max_size=20,
).filter(lambda text: bool(text.strip()) and text.isprintable())
TEXTS = st.text(st.characters(categories=("L", "N", "P", "S")), max_size=30).filter(
    lambda text: text.isprintable()
)
PROVENANCES = st.builds(
    Provenance, st.sampled_from(Kind), TEXTS.map(lambda text: text + "x"), TEXTS, TEXTS
)


def sources(*keys: str) -> st.SearchStrategy[dict[str, Provenance]]:
    return st.dictionaries(st.sampled_from(keys), PROVENANCES, max_size=3)


TESTED = st.none() | st.builds(
    TestedRange,
    pressure_min=numbers(1e3, 1e5),
    pressure_max=numbers(2e5, 1e6),
    slip_max=numbers(1e-3, 0.1),
)
FRICTIONS = numbers(0.01, 3.0)


@st.composite
def knots(draw: st.DrawFn) -> IntegralLog:
    count = draw(st.integers(1, 5))

    def column(values: st.SearchStrategy[float]) -> tuple[float, ...]:
        return tuple(draw(values) for _ in range(count))

    tail = draw(st.booleans())
    coefficients = PressureKnots(
        pressure=draw(ascending(1e4, 1e6, count)),
        peak_friction=column(FRICTIONS),
        peak_slip=column(numbers(1e-4, 0.1)),
        post_peak_slope=column(numbers(-100.0, 0.0)) if tail else (),
        residual_friction=column(FRICTIONS) if tail else (),
    )
    ends = coefficients.pressure[0], coefficients.pressure[-1]
    tested = TestedRange(
        pressure_min=ends[0], pressure_max=ends[1], slip_max=draw(numbers(1e-3, 1))
    )
    return IntegralLog(coefficients=coefficients, tested=draw(st.sampled_from([None, tested])))


def exponential(value: float, form: Literal["power", "exponential"]) -> Trend:
    sign = 1 if value > 0.0 else -1
    return Trend(form=form, coefficients=(math.log(abs(value)), 0.0), sign=sign)


#: The same number as polynomial, logarithm, power and exponential.
FORMS: tuple[Callable[[float], Trend], ...] = (
    lambda value: Trend(coefficients=(value,)),
    lambda value: Trend(form="logarithmic", coefficients=(value, 0.0)),
    lambda value: exponential(value, "power"),
    lambda value: exponential(value, "exponential"),
)


@st.composite
def pieces(draw: st.DrawFn) -> IntegralLog:
    """Pieces that meet: A and b of each are those of the one before, written in another form."""
    unit = draw(st.sampled_from([1e-3, 0.0254, 1.0]))
    pressure = draw(ascending(3e4, 7e5, 3))
    slip, friction = draw(numbers(1e-3, 0.03)) / unit, draw(numbers(0.2, 2.0))
    a = -friction / slip
    b = a * (1.0 + math.log(slip))
    tail = draw(st.booleans())
    more = {
        "post_peak_slope": draw(st.sampled_from(FORMS))(-draw(numbers(0.1, 50.0))),
        "residual_friction": draw(st.sampled_from(FORMS))(draw(numbers(0.1, 1.0))),
    }
    made = tuple(
        Piece(
            a=draw(st.sampled_from(FORMS))(a),
            b=draw(st.sampled_from(FORMS))(b if abs(b) > 1e-9 else a),
            **(more if tail else {}),
        )
        for _ in range(2)
    )
    coefficients = CoefficientPieces(pressure=pressure, pieces=made, slip_unit=unit)
    tested = TestedRange(pressure_min=pressure[0], pressure_max=pressure[-1], slip_max=0.015)
    return IntegralLog(coefficients=coefficients, tested=draw(st.sampled_from([None, tested])))


@st.composite
def tables(draw: st.DrawFn) -> MeasuredTable:
    rows, columns = draw(st.integers(1, 4)), draw(st.integers(1, 4))
    row = st.tuples(*[FRICTIONS] * columns).map(lambda values: (0.0, *values))
    return MeasuredTable(
        slip=(0.0, *draw(ascending(1e-4, 0.05, columns))),
        pressure=draw(ascending(1e4, 1e6, rows)),
        values=tuple(draw(row) for _ in range(rows)),
    )


LAWS: st.SearchStrategy[FrictionLaw] = st.one_of(
    st.builds(Constant, friction_coefficient=FRICTIONS, tested=TESTED),
    st.builds(
        ElasticPlastic, stiffness=numbers(1e6, 1e9), friction_coefficient=FRICTIONS, tested=TESTED
    ),
    st.builds(
        PressurePower,
        friction_coefficient=FRICTIONS,
        reference_pressure=numbers(1e4, 1e6),
        exponent=numbers(0.0, 0.99),
        tested=TESTED,
    ),
    knots(),
    pieces(),
    tables(),
)

FITS = st.builds(
    lambda values, noise, factor: Fit(
        parameters=tuple(f"p{i}" for i in range(len(values))),
        values=tuple(values),
        covariance=tuple(
            tuple(v * v if i == j else 0.0 for j in range(len(values)))
            for i, v in enumerate(values)
        ),
        residual_noise=noise,
        coverage_factor=factor,
    ),
    st.lists(numbers(-10.0, 10.0), min_size=1, max_size=4),
    st.none() | numbers(0.0, 0.1),
    numbers(1.0, 12.7),
)
COSTS = st.builds(
    Cost,
    material=numbers(0.0, 1e5),
    installation=numbers(0.0, 1e5),
    currency=st.sampled_from(["AUD", "EUR"]),
    area=numbers(0.1, 100.0),
    life_years=st.tuples(numbers(0.1, 5.0), numbers(5.0, 20.0)),
)

#: Texts and quantities of a lagging by their rows and limits: one that is added is tried at once.
_OF_ROWS: dict[str, st.SearchStrategy[object]] = {
    entry.attribute: TEXTS for entry in LAGGING_FILE.entries if isinstance(entry.kind, Text)
} | {
    key: st.none() | numbers(limit.least or 1e-12, min(limit.most, 1e9))
    for key, limit in Lagging.LIMITS.items()
}
LAGGINGS = st.builds(
    Lagging,
    **_OF_ROWS
    | {
        "name": NAMES,
        "law": LAWS,
        "thickness": st.just(0.0) | numbers(1e-3, 0.05),
        "shear_modulus": st.just(math.inf) | numbers(1e5, 1e8),
        "compression_modulus": st.just(math.inf) | numbers(1e5, 1e8),
        "condition": NAMES,
        "surface": st.sampled_from(["", "rubber", "ceramic"]),
        "cost": st.none() | COSTS,
        "fit": st.none() | FITS,
        "provenance": PROVENANCES,
        "sources": sources("law", "thickness", "shear_modulus", "block"),
        "notes": st.lists(TEXTS, max_size=2).map(tuple),
    },
)

OWN_BELTS = st.builds(
    Belt,
    name=NAMES,
    width=numbers(0.1, 4.0),
    modulus=numbers(1e5, 1e9),
    rating=st.none() | numbers(1e4, 1e6),
    speed=st.none() | numbers(0.1, 10.0),
    kind=TEXTS,
    least_pulley_diameter=st.none() | numbers(0.1, 3.0),
    provenance=PROVENANCES,
    sources=sources("width", "modulus", "speed"),
)
# What reading a preset makes: the maker's numbers, some of them replaced.
PRESET_BELTS = st.builds(
    lambda preset, width, modulus: Belt(
        name=preset.name,
        width=width,
        modulus=modulus or preset.modulus,
        rating=preset.rating,
        kind=preset.kind,
        least_pulley_diameter=preset.least_pulley_diameter,
        provenance=preset.provenance,
        sources={"width": Provenance()} | ({"modulus": Provenance()} if modulus else {}),
    ),
    st.sampled_from(belts()),
    numbers(0.1, 4.0),
    st.none() | numbers(1e5, 1e9),
)
CATALOGUE_LAGGINGS = st.sampled_from(["diamond-rubber", "full-ceramic"]).map(load_lagging)
PULLEYS = st.builds(
    Pulley,
    name=NAMES,
    diameter=numbers(0.1, 3.0),
    wrap_angle=numbers(0.1, 4.0 * math.pi),
    lagging=CATALOGUE_LAGGINGS | LAGGINGS,
    overrun=st.none() | numbers(-1e-3, 1e-3),
    recovery=st.booleans(),
    creep_limit=st.none() | numbers(1e-3, 0.1),
    sources=sources("diameter", "entry_tension"),
)
TENSIONS = st.builds(Tensions, entry=numbers(1e3, 1e6), exit=numbers(1e3, 1e6))


@st.composite
def drives(draw: st.DrawFn) -> Drive:
    pulleys = draw(st.lists(PULLEYS, min_size=1, max_size=3, unique_by=lambda p: p.name))
    names = draw(st.lists(st.just("design") | NAMES, min_size=1, max_size=3, unique=True))
    names.sort(key=lambda name: name != "design")
    cases = [
        LoadCase(name=name, tensions={p.name: draw(TENSIONS) for p in pulleys}) for name in names
    ]
    return Drive(
        title=draw(TEXTS),
        description=draw(TEXTS),
        belt=draw(OWN_BELTS | PRESET_BELTS),
        pulleys=tuple(pulleys),
        load_cases=tuple(cases),
        creep_limit=draw(st.just(6.35e-3) | numbers(1e-3, 0.1)),
    )
