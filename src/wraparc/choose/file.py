"""Choose files: TOML to a search."""

import os
from collections.abc import Sequence
from typing import Any, TypeVar

from wraparc import catalogue
from wraparc.choose.cost import BeltPrice, Costing, Price, catalogue_price
from wraparc.choose.keys import CHOOSE
from wraparc.choose.search import Limits, Search
from wraparc.drive import Belt, Cost, Drive, Lagging, Sag
from wraparc.drive.changes import belt_of
from wraparc.drive.conditions import DRY, Condition
from wraparc.errors import InputError, nearest, shown
from wraparc.files.drive_build import SAG_KEYS
from wraparc.files.drive_parts import check_cases, drive_of, pulley_of
from wraparc.files.lagging_file import is_path, load_lagging
from wraparc.provenance import Provenance
from wraparc.schema.origins import own_provenance
from wraparc.schema.overrides import Overrides, read_document
from wraparc.schema.problems import Place, Report
from wraparc.schema.source import Document, check_format
from wraparc.schema.tables import Record

_T = TypeVar("_T")
_COST_KEYS = ("material", "installation", "area", "life_years")


def load_search(path: str | os.PathLike[str], *, overrides: Overrides = ()) -> Search:
    """Return the search of a choose file; the files it names are relative to it.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    name = os.fspath(path)
    document = read_document(path, overrides)
    return search_from_document(document, file=name, folder=os.path.dirname(name))


def search_from_document(document: Document, *, file: str = "", folder: str = "") -> Search:
    """Return the search of a choose file that is already parsed."""
    check_format(document, file)
    report = Report(file)
    record: Record = CHOOSE.read(document, (), report)
    report.raise_all()
    drive = drive_of(record, folder, report)
    report.raise_all()
    assert drive is not None  # noqa: S101 - else it was reported
    pulley = pulley_of(record, drive, report)
    candidates: Record = record["candidates"]
    laggings = _laggings(candidates, drive, pulley, folder, report)
    belts = _belts(candidates, drive, report)
    conditions = tuple(_condition(r, report) for r in record.get("condition", ()))
    costing = _costing(record["cost"], laggings, drive, report)
    limits = _limits(record.get("limits"), drive, report)
    report.raise_all()
    base = drive.pulley(pulley)
    slack = candidates.get("slack_tensions", ())
    try:
        search = Search(
            drive=drive,
            pulley=pulley,
            laggings=laggings,
            belts=belts,
            thicknesses=tuple(candidates.get("thicknesses", ())),
            diameters=tuple(candidates.get("diameters", (base.diameter,))),
            wrap_angles=tuple(candidates.get("wrap_angles", (base.wrap_angle,))),
            slack_tensions=_slack(candidates, slack),
            conditions=conditions or (Condition(name=DRY),),
            limits=limits,
            costing=costing,
            title=record.get("title", ""),
        )
        search.conditioned()  # whether every lagging has its friction in every condition
    except InputError as error:
        report.take(error, ())
        raise InputError(report.problems) from None
    return search


def _slack(candidates: Record, slack: Any) -> tuple[float, ...] | None:
    if "slack_tensions" not in candidates:
        return None
    return () if slack is None else tuple(slack)


def _laggings(
    candidates: Record, drive: Drive, pulley: str, folder: str, report: Report
) -> tuple[Lagging, ...]:
    if "laggings" not in candidates:
        return (drive.pulley(pulley).lagging,)
    found = []
    for position, name in enumerate(candidates["laggings"], start=1):
        path = os.path.join(folder, name) if is_path(name) else name
        place = ("candidates", "laggings", position)
        lagging = report.tried(lambda path=path: load_lagging(path), place)  # type: ignore[misc]
        if lagging is not None:
            found.append(lagging)
    return _unlike(found, ("candidates", "laggings"), report)


def _belts(candidates: Record, drive: Drive, report: Report) -> tuple[Belt, ...]:
    if "belts" not in candidates:
        return (drive.belt,)
    found = []
    for position, name in enumerate(candidates["belts"], start=1):
        place = ("candidates", "belts", position)
        row = report.tried(lambda name=name: catalogue.belt(name), place)  # type: ignore[misc]
        if row is not None:
            found.append(belt_of(row, drive.belt))
    return _unlike(found, ("candidates", "belts"), report)


_Named = TypeVar("_Named", Belt, Lagging)


def _unlike(found: Sequence[_Named], place: Place, report: Report) -> tuple[_Named, ...]:
    names = [thing.name for thing in found]
    for name in sorted({name for name in names if names.count(name) > 1}):
        report.add(place, f"{shown(name)} stands there more than once", "Keep one of them.")
    return tuple(found)


def _condition(record: Record, report: Report) -> Condition:
    return Condition(
        name=record["name"],
        factor=record.get("friction_factor"),
        factors=record.get("friction_factors", {}),
        standard=record.get("standard", ""),
        source=own_provenance(record, report) or Provenance(),
    )


def _limits(record: Any, drive: Drive, report: Report) -> Limits:
    if not isinstance(record, Record):
        return Limits()
    share = record.get("rating_share", {})
    check_cases(((name, (*record.place, "rating_share", name)) for name in share), drive, report)
    keys = (
        "creep",
        "bond_stress",
        "creep_limit_margin",
        "tested_slip_margin",
        "gross_slip_margin",
        "tested_pressure",
        "least_pulley_diameter",
    )
    return Limits(
        rating=share if record.get("belt_rating", True) else None,
        sag=_sag(record.get("sag")),
        **{key: record[key] for key in keys if key in record},
    )


def _sag(record: Any) -> Sag | None:
    if not isinstance(record, Record) or not record.sound():
        return None
    return Sag(**{SAG_KEYS.get(key, key): value for key, value in record.items()})


def _costing(record: Record, laggings: Sequence[Lagging], drive: Drive, report: Report) -> Costing:
    given = record.get("lagging", {})
    names = [lagging.name for lagging in laggings]
    for name in given:
        if name not in names:
            place = ("cost", "lagging", name)
            report.add(place, "no lagging among the candidates", nearest(name, names))
    hours = record.get("hours", {})
    check_cases(((name, (*record.place, "hours", name)) for name in hours), drive, report)
    prices = {}
    for lagging in laggings:
        price = _price(lagging, given.get(lagging.name), record["currency"], report)
        if price is not None:
            prices[lagging.name] = price
    return Costing(
        currency=record["currency"],
        laggings=prices,
        belts={
            name: BeltPrice(price=r["price"], life_years=r["life_years"])
            for name, r in record.get("belt", {}).items()
        },
        hours=hours,
        **{key: record[key] for key in ("years", "tariff", "face_width") if key in record},
    )


def _price(lagging: Lagging, record: Any, currency: str, report: Report) -> Price | None:
    if not isinstance(record, Record):
        return catalogue_price(lagging)
    if "preset" in record:
        return catalogue_price(lagging, record["preset"])
    missing = [key for key in _COST_KEYS if key not in record]
    if missing:
        remedy = f"Add {', '.join(missing)}, or write preset."
        report.add(record.place, "the cost is not complete", remedy)
        return None
    values = {key: record[key] for key in _COST_KEYS} | {"currency": currency}
    values["life_years"] = tuple(values["life_years"])
    try:
        return Price(cost=Cost(**values), source=own_provenance(record, report) or Provenance())
    except InputError as error:
        report.take(error, record.place, record.raw)
        return None
