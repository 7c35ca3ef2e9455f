"""Choose files: TOML to a search."""

import os
from collections.abc import Sequence
from typing import Any, TypeVar

from wraparc import catalogue
from wraparc.choose.cost import Costing, Price, catalogue_price
from wraparc.choose.keys import BELT_COST, CHOOSE, COST, LAGGING_COST, LIMITS
from wraparc.choose.search import Limits, Search
from wraparc.drive import Belt, Cost, Drive, Lagging
from wraparc.drive.changes import with_belt
from wraparc.drive.conditions import DRY, Condition
from wraparc.errors import InputError, Problem, nearest, shown
from wraparc.files.conditions import condition_of
from wraparc.files.drive_build import build_sag
from wraparc.files.lagging_file import is_path, load_lagging
from wraparc.provenance import Provenance
from wraparc.schema.origins import own_provenance
from wraparc.schema.overrides import Overrides, load
from wraparc.schema.problems import Place, Report
from wraparc.schema.source import Document, read_whole
from wraparc.schema.tables import Record
from wraparc.train import Train
from wraparc.train.drive_parts import check_cases, drive_of, pulley_of
from wraparc.train.file import load_drive_or_train

_T = TypeVar("_T")
_COST_KEYS = ("material", "installation", "area", "life_years")


def load_search(path: str | os.PathLike[str], *, overrides: Overrides = ()) -> Search:
    """Return the search of a choose file; the files it names are relative to it.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    return load(path, search_from_document, overrides, file_kind="choose")


def search_from_document(document: Document, *, file: str = "", folder: str = "") -> Search:
    """Return the search of a choose file that is already parsed."""
    _refuse_old(document)
    record, report = read_whole(CHOOSE, document, file)
    drive = report.sure(lambda: drive_of(record, folder, report))
    pulley = pulley_of(record, drive, report)
    _refuse_between(drive, report)
    candidates: Record = record["candidates"]
    laggings = _laggings(candidates, drive, pulley, folder, report)
    belts = _belts(candidates, drive, report)
    conditions = tuple(condition_of(r, report) for r in record.get("condition", ()))
    costing = _costing(record["cost"], laggings, drive, report)
    limits = _limits(record.get("limits"), drive, report)
    report.raise_all()
    base = drive.pulley(pulley)
    slack = candidates.get("slack_tensions", ())
    search = report.sure(
        lambda: Search(
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
            train=_train(record, folder),
        )
    )
    report.sure(search.conditioned)  # whether every lagging has its friction in every condition
    return search


def _train(record: Record, folder: str) -> Train | None:
    """Return the train that the drive is of, if its file has one."""
    described = load_drive_or_train(os.path.join(folder, record["drive"]))
    return described if isinstance(described, Train) else None


def _refuse_old(document: Document) -> None:
    """Refuse a limit of the extrapolated margin to gross slip."""
    limits = document.get("limits")
    if isinstance(limits, dict) and "gross_slip_margin" in limits:
        raise InputError(
            [
                Problem(
                    key="limits.gross_slip_margin",
                    value=shown(limits["gross_slip_margin"]),
                    message="no check compares this extrapolated ratio",
                    remedy="Give limits.gross_slip_safety.",
                )
            ]
        )


def _refuse_between(drive: Drive, report: Report) -> None:
    """Report a take-up between drives: designs are given a slack-side tension."""
    take_up = drive.criteria.take_up
    if take_up.after not in ("", drive.pulleys[-1].name):
        message = "choosing needs the take-up at the slack side"
        remedy = "Leave it out to choose."
        report.add(("drive", "take_up", "after"), message, remedy, take_up.after)


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
            found.append(with_belt(drive, row).belt)
    return _unlike(found, ("candidates", "belts"), report)


_Named = TypeVar("_Named", Belt, Lagging)


def _unlike(found: Sequence[_Named], place: Place, report: Report) -> tuple[_Named, ...]:
    names = [thing.name for thing in found]
    for name in sorted({name for name in names if names.count(name) > 1}):
        report.add(place, f"{shown(name)} stands there more than once", "Remove one of them.")
    return tuple(found)


def _limits(record: Any, drive: Drive, report: Report) -> Limits:
    if not isinstance(record, Record):
        return Limits()
    share = record.get("rating_share", {})
    check_cases(((name, (*record.place, "rating_share", name)) for name in share), drive, report)
    rating = share if record.get("belt_rating", True) else None
    sag = build_sag(record.get("sag"), drive.belt.mass, report)
    return LIMITS.built(record, report, rating=rating, sag=sag) or Limits()


def _costing(record: Record, laggings: Sequence[Lagging], drive: Drive, report: Report) -> Costing:
    given = record.get("lagging", {})
    names = [lagging.name for lagging in laggings]
    for name in given:
        if name not in names:
            place = ("cost", "lagging", name)
            remedy = "" if report.full else nearest(name, names)
            report.add(place, "no lagging among the candidates", remedy)
    hours = record.get("hours", {})
    check_cases(((name, (*record.place, "hours", name)) for name in hours), drive, report)
    prices = {}
    for lagging in laggings:
        price = _price(lagging, given.get(lagging.name), record["currency"], report)
        if price is not None:
            prices[lagging.name] = price
    belts = {name: BELT_COST.built(r, report) for name, r in record.get("belt", {}).items()}
    made: Costing = COST.built(record, report, laggings=prices, belts=belts, hours=hours)
    return made


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
    cost: Cost | None = LAGGING_COST.built(record, report, currency=currency)
    source = own_provenance(record, report) or Provenance()
    return None if cost is None else Price(cost=cost, source=source)
