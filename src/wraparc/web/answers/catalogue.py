"""The catalogue as plain data."""

import math
from functools import cache

import numpy as np

from wraparc import catalogue
from wraparc.answer.catalogue_sheets import lagging_sheet
from wraparc.drive import SURFACES, Lagging
from wraparc.drive.conditions import covered, published_conditions
from wraparc.files.lagging_file import load_lagging_conditions, pick_condition
from wraparc.provenance import Kind
from wraparc.schema.source import parse
from wraparc.units import Dimension, quantity
from wraparc.web.answers.shown import (
    Answer,
    Data,
    DriveKind,
    Numbers,
    Sheet,
    Text,
    rounded,
    sheet,
    worded,
)
from wraparc.web.examples import examples

_PRESSURES = 5
_POINTS = 80


class CatalogueBelt(Answer):
    """A belt to choose."""

    name: str
    kind: str
    rating: Text
    modulus: Text
    modulus_test: str
    least_pulley_diameter: Text | None
    source: str


class TestedTexts(Answer):
    """Range that a lagging was tested in."""

    __test__ = False  # not a test class, whatever its name suggests to a test collector

    pressure: Text
    slip: Text


class CatalogueLagging(Answer):
    """A lagging to choose."""

    name: str
    title: str
    surface: str
    conditions: list[str]
    thickness: Text
    shear_modulus: Text
    compression_modulus: Text
    kind: Kind
    source: str
    tested: TestedTexts | None
    notes: list[str]


class DesignFriction(Answer):
    """Friction that a standard designs with."""

    standard: str
    surface: str
    condition: str
    friction: list[float]
    source: str


class CatalogueExample(Answer):
    """An example to open."""

    name: str
    title: str
    kind: DriveKind
    pulleys: int


class Catalogue(Answer):
    """Everything there is to choose from; `published` has the conditions of a surface."""

    belts: list[CatalogueBelt]
    laggings: list[CatalogueLagging]
    published: dict[str, list[str]]
    design_friction: list[DesignFriction]
    examples: list[CatalogueExample]


class Curves(Answer):
    """Friction over slip [m] at pressures [Pa]."""

    slip: Numbers
    pressures: Numbers
    friction: list[Numbers]
    tested_slip: float | None


class LaggingAnswer(Sheet):
    """One lagging, its table of a drive document, and its friction."""

    name: str
    condition: str
    document: Data
    law: Curves


@cache
def whole() -> Catalogue:
    """Return belts, laggings, design values of friction and examples."""
    return Catalogue(
        belts=[_belt(belt) for belt in catalogue.belts()],
        laggings=[_lagging(name) for name in catalogue.lagging_names()],
        published={surface: list(published_conditions(surface)) for surface in SURFACES},
        design_friction=[
            DesignFriction(
                standard=value.standard,
                surface=value.surface,
                condition=value.condition,
                friction=list(value.friction),
                source=str(value.provenance),
            )
            for value in catalogue.design_friction()
        ],
        examples=[
            CatalogueExample(
                name=example.name,
                title=str(example.document.get("title", example.name)),
                kind=example.kind,
                pulleys=len(example.document["pulley"]),
            )
            for example in examples()
        ],
    )


def _belt(belt: catalogue.CatalogueBelt) -> CatalogueBelt:
    least = belt.least_pulley_diameter
    return CatalogueBelt(
        name=belt.name,
        kind=belt.kind,
        rating=worded(quantity(belt.rating, "force_per_width")),
        modulus=worded(quantity(belt.modulus, "force_per_width")),
        modulus_test=belt.modulus_test or "not stated",
        least_pulley_diameter=None if least is None else worded(quantity(least, "length")),
        source=str(belt.provenance),
    )


def _lagging(name: str) -> CatalogueLagging:
    conditions = load_lagging_conditions(name, allow_paths=False)
    first = conditions[0]
    origin = first.source_of("law")
    return CatalogueLagging(
        name=name,
        title=first.title,
        surface=first.surface,
        conditions=list(covered(conditions)),
        thickness=_or_rigid(first.thickness, "length"),
        # as a file has it beside blocks: that of the rubber
        shear_modulus=_or_rigid(first.shear_modulus / first.contact_fraction, "pressure"),
        compression_modulus=_or_rigid(first.compression_modulus, "pressure"),
        kind=origin.kind,
        source=str(origin),
        tested=_tested(first),
        notes=list(first.notes),
    )


def _tested(lagging: Lagging) -> TestedTexts | None:
    tested = lagging.law.tested
    if tested is None:
        return None
    low, high = (quantity(p, "pressure") for p in (tested.pressure_min, tested.pressure_max))
    return TestedTexts(
        pressure=worded(f"{low} to {high}"), slip=worded(quantity(tested.slip_max, "length"))
    )


def _or_rigid(value: float, dimension: Dimension) -> Text:
    return worded("rigid" if value == math.inf else quantity(value, dimension))


def lagging(name: str, condition: str | None) -> LaggingAnswer:
    """Return one lagging with its friction curves."""
    conditions = load_lagging_conditions(name, allow_paths=False)
    one = pick_condition(conditions, condition)
    table = parse(catalogue.lagging_text(name))
    table.pop("format", None)
    return LaggingAnswer(
        name=one.name,
        condition=one.condition,
        document=table,
        law=_curves(one),
        **sheet(lagging_sheet(conditions)),
    )


def _curves(one: Lagging) -> Curves:
    """Return friction curves over slip at pressures of the tested range."""
    tested = one.law.tested
    low, high, most = 7e4, 7e5, 1.5e-2
    if tested is not None:
        low, high, most = tested.pressure_min, tested.pressure_max, tested.slip_max
    pressures = np.geomspace(max(low, 1e3), high, _PRESSURES)
    slip = 1.5 * most * np.linspace(0.0, 1.0, _POINTS) ** 1.5
    friction = np.array([one.law.friction(slip, np.full_like(slip, p)) for p in pressures])
    return Curves(
        slip=rounded(slip),
        pressures=rounded(pressures),
        friction=rounded(friction),
        tested_slip=None if tested is None else tested.slip_max,
    )
