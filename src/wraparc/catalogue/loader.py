"""Sourced data: what ships with the program, and the user's own laggings and belts beside it."""

import math
import tomllib
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from wraparc.catalogue.catalogue_belt import CatalogueBelt
from wraparc.catalogue.own import (
    BELTS_FILE,
    LAGGINGS_FOLDER,
    NAME,
    VARIABLE,
    own_belts,
    own_folder,
    own_laggings,
)
from wraparc.catalogue.standard_belts import modulus_problem, standard_belt
from wraparc.errors import InputError, Problem, did_you_mean, input_error, near, shown
from wraparc.provenance import Kind, Provenance
from wraparc.schema.source import read_text
from wraparc.units import parse_quantity

# Not importlib.resources: its import alone costs more than all the reading here.
_DATA = Path(__file__).with_name("data")


@dataclass(frozen=True, kw_only=True)
class DesignFriction:
    """A constant friction that a standard or practice designs drives with.

    Parameters
    ----------
    standard
        ``CEMA``, ``DIN 22101`` or ``practice``.
    surface
        ``bare``, ``rubber``, ``polyurethane`` or ``ceramic``.
    condition
        ``dry``, ``wet``, ``wet and dirty``, or empty where none is told apart.
    friction
        Lower and upper end of the value [-]; equal for a single value.
    provenance
        Where it was published.
    """

    standard: str
    surface: str
    condition: str
    friction: tuple[float, float]
    provenance: Provenance


@dataclass(frozen=True, kw_only=True)
class LaggingCost:
    """What a lagging costs on one pulley and how long it lasts.

    Parameters
    ----------
    name, surface
        What is bought, and the material that touches the belt.
    material, installation
        Prices [currency].
    currency
        Currency of the prices.
    area
        Lagged area the prices are for [m2].
    life_years
        Shortest and longest life [years].
    ten_year_cost
        Cost over ten years as published [currency].
    provenance
        Where it was published.
    """

    name: str
    surface: str
    material: float
    installation: float
    currency: str
    area: float
    life_years: tuple[float, float]
    ten_year_cost: float
    provenance: Provenance


def belts() -> tuple[CatalogueBelt, ...]:
    """Return every belt, in the order of the data files, the user's own last.

    Raises
    ------
    InputError
        If the user's own cannot be read, or have a name that is taken.
    """
    return _belts(own_folder())


@cache
def _belts(folder: Path | None) -> tuple[CatalogueBelt, ...]:
    own = () if folder is None else own_belts(folder)
    given = [_own_belt(row, origin) for row, origin in own]
    shipped = tuple(_shipped_belts())
    places = [(b.name, f"belt.{n}.name") for n, b in enumerate(given, start=1)]
    file = "" if folder is None else str(folder / BELTS_FILE)
    taken = _taken([b.name for b in shipped], places)
    message = "the catalogue has a belt of this name already"
    remedy = "Give your own belt another name."
    if taken:
        raise InputError(
            Problem(file=file, key=place, value=shown(name), message=message, remedy=remedy)
            for name, place in taken
        )
    return (*shipped, *given)


def _own_belt(row: dict[str, Any], origin: Provenance) -> CatalogueBelt:
    loads = row.get("modulus_loads")
    more = {"provenance": origin, "modulus_loads": None if loads is None else tuple(loads)}
    return CatalogueBelt(**{**row, **more})


def _shipped_belts() -> Iterable[CatalogueBelt]:
    return (
        CatalogueBelt(
            name=row["name"],
            kind=group["kind"],
            rating=parse_quantity(row["rating"], "force_per_width"),
            modulus=parse_quantity(row["modulus"], "force_per_width"),
            least_pulley_diameter=(
                parse_quantity(row["least_pulley_diameter"], "length")
                if "least_pulley_diameter" in row
                else None
            ),
            carcass=parse_quantity(row["carcass"], "length"),
            carcass_mass=row["carcass_mass"],
            cover_mass=1e3 * group["cover_mass"],
            permanent_elongation=_elongation(row, group),
            provenance=_published(group),
            sources={"carcass": replace(_published(group), note=group["carcass_page"])},
        )
        for group in _data("belts")["group"]
        for row in group["belts"]
    )


def _elongation(row: dict[str, Any], group: dict[str, Any]) -> float | None:
    text = row.get("permanent_elongation", group.get("permanent_elongation"))
    return None if text is None else parse_quantity(text, "number")


def belt(name: str, *, with_modulus: bool = True) -> CatalogueBelt:
    """Return a belt by name, of the catalogue or a standard name; case and blanks do not matter.

    Parameters
    ----------
    name
        As the catalogue has it, else ``EP 630/3``, ``ST 2000`` and the like.
    with_modulus
        Whether a belt is refused whose modulus nobody publishes; else it is nan.

    Raises
    ------
    InputError
        If there is none, with the nearest names.
    """
    found = find_belt(name)
    if found is None:
        raise unknown_name("belt", name, (b.name for b in belts()), "wraparc belts")
    problem = modulus_problem(found) if with_modulus else None
    if problem is not None:
        raise InputError(problem)
    return found


def find_belt(name: str) -> CatalogueBelt | None:
    """Return a belt by name as `belt` does, with or without a modulus; None if there is none.

    Raises
    ------
    InputError
        Of a standard name with a typing slip, with the nearest names.
    """
    wanted = _plain(name)
    found = next((b for b in belts() if _plain(b.name) == wanted), None)
    return found or standard_belt(name)


def lagging_names() -> tuple[str, ...]:
    """Return the names of the laggings, sorted, the user's own last.

    Raises
    ------
    InputError
        If one of the user's own has a name that is taken.
    """
    return tuple(_laggings(own_folder()))


def own_lagging_names() -> tuple[str, ...]:
    """Return the names of the user's own laggings."""
    folder = own_folder()
    return () if folder is None else tuple(own_laggings(folder))


def lagging_text(name: str) -> str:
    """Return the lagging file of a catalogue lagging as text.

    Raises
    ------
    InputError
        If there is none, with the nearest names.
    """
    known = _laggings(own_folder())
    if name not in known:
        raise unknown_name("lagging", name, known, "wraparc laggings")
    return _text(known[name])


@cache
def _laggings(folder: Path | None) -> dict[str, Path]:
    """Return the lagging files by name."""
    own = {} if folder is None else own_laggings(folder)
    shipped = own_laggings(_DATA)
    taken = _taken(shipped, [(name, str(path)) for name, path in own.items()])
    message = "the catalogue has a lagging of this name already"
    remedy = "Give file and lagging another name."
    if taken:
        raise InputError(
            Problem(file=place, value=shown(name), message=message, remedy=remedy)
            for name, place in taken
        )
    return {**shipped, **own}


@cache
def _text(path: Path) -> str:
    return read_text(path)


def _taken(shipped: Iterable[str], own: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return names of the user's own with their places, those that are there already."""
    plain = Counter(map(_plain, (*shipped, *(name for name, _ in own))))
    return [(name, place) for name, place in own if plain[_plain(name)] > 1]


def place_of_own(name: str) -> Path:
    """Return where a new lagging of the user's own goes.

    Raises
    ------
    InputError
        If there is no folder of his own, the name is taken, or it is no name of a file.
    """
    folder = own_folder()

    def refused(message: str, remedy: str) -> InputError:
        return input_error(key="--name", value=shown(name), message=message, remedy=remedy)

    if folder is None:
        message = "there is no catalogue of your own"
        raise refused(message, f"Name its folder in the environment variable {VARIABLE}.")
    if not NAME.fullmatch(name):
        message = "is no name of a lagging"
        raise refused(message, "Take letters, digits, hyphens, underscores, 60 at most.")
    _laggings.cache_clear()  # other programs put laggings there too
    there = {_plain(known): path for known, path in _laggings(folder).items()}.get(_plain(name))
    if there is not None:
        ours = there.is_relative_to(folder)
        message = "the catalogue has a lagging of this name already"
        raise refused(message, f"Take another name{f', or delete {there}' if ours else ''}.")
    _laggings.cache_clear()
    return folder / LAGGINGS_FOLDER / f"{name}.toml"


@cache
def design_friction() -> tuple[DesignFriction, ...]:
    """Return the published design values of friction, to compare with."""
    return tuple(
        DesignFriction(
            standard=group["standard"],
            surface=row["surface"],
            condition=row.get("condition", ""),
            friction=(row["friction"][0], row["friction"][1]),
            provenance=_published(group, _friction_note(row)),
        )
        for group in _data("design_friction")["group"]
        for row in group["values"]
    )


@cache
def lagging_costs() -> tuple[LaggingCost, ...]:
    """Return published costs of laggings."""
    data = _data("costs")
    diameter = parse_quantity(data["pulley_diameter"], "length")
    area = math.pi * diameter * parse_quantity(data["pulley_width"], "length")
    return tuple(
        LaggingCost(
            name=row["name"],
            surface=row["surface"],
            material=row["material"],
            installation=data["installation"],
            currency=data["currency"],
            area=area,
            life_years=(row["life_years"][0], row["life_years"][1]),
            ten_year_cost=row["ten_year_cost"],
            provenance=_published(data),
        )
        for row in data["laggings"]
    )


def unknown_name(what: str, name: str, known: Iterable[str], command: str) -> InputError:
    """Return the error for a name that the catalogue does not have, with the nearest ones."""
    by_plain = {_plain(k): k for k in known}
    texts = [shown(by_plain[key]) for key in near(_plain(name), by_plain)]
    remedy = did_you_mean(texts) or f"List them: {command}."
    return input_error(
        message=f"the catalogue has no {what} of this name",
        remedy=remedy,
        value=shown(name),
    )


def _data(name: str) -> dict[str, Any]:
    return tomllib.loads((_DATA / f"{name}.toml").read_text("utf-8"))


def _published(group: dict[str, Any], *notes: str) -> Provenance:
    note = "; ".join(n for n in (group.get("note", ""), *notes) if n)
    return Provenance(Kind.PUBLISHED, group["source"], group.get("date", ""), note)


def _friction_note(row: dict[str, Any]) -> str:
    single = "single value, partly from IS 11592 and REMA" if row.get("single") else ""
    return "; ".join(n for n in (row.get("note", ""), single) if n)


@lru_cache(maxsize=1024)
def _plain(name: str) -> str:
    return "".join(name.casefold().split())
