"""Changes to a drive by the words that users have for them: wet, worn, bare, another lagging."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from wraparc import catalogue
from wraparc.choose.what_if import Change, redivided
from wraparc.drive import Drive, Lagging, changes
from wraparc.drive.conditions import Condition
from wraparc.errors import InputError, Problem, input_error, placed, shown
from wraparc.files import load_lagging
from wraparc.train import Train
from wraparc.units import parse_number, parse_quantity


@dataclass(frozen=True, kw_only=True)
class Named:
    """Changes as they are asked for; lengths are texts with their unit.

    Attributes
    ----------
    other_carcass
        Steel cord for fabric, fabric for steel cord.
    belts, laggings
        Names of the catalogue.
    thicknesses, worn
        Lagging of another thickness over the same diameter; worn to a thickness.
    wet
        Friction when wet over dry, or the standard whose ratio is taken.
    bare
        The standard whose friction of a bare pulley is taken.
    """

    other_carcass: bool = False
    belts: tuple[str, ...] = ()
    laggings: tuple[str, ...] = ()
    thicknesses: tuple[str, ...] = ()
    worn: tuple[str, ...] = ()
    wet: str = ""
    bare: str = ""


def changes_of(
    read: Drive | Train, drive: Drive, pulley: str, asked: Named, *, allow_paths: bool = True
) -> Iterator[Change]:
    """Yield every change that is asked for, each to the drive as it is.

    Parameters
    ----------
    read
        What was read: the load of a train is divided anew after every change.
    drive
        The same as a drive.
    pulley
        Which pulley is changed.
    asked
        The changes.
    allow_paths
        Whether a lagging may be named by the path of its file.

    Raises
    ------
    InputError
        If a change cannot be made, under the name of its field.
    """
    for title, changed, note in _changes(drive, pulley, asked, allow_paths):
        as_read = changed if isinstance(read, Drive) else redivided(read, changed)
        yield Change(title, as_read, note)


#: Title, the drive, and what to know.
_Changed = tuple[str, Drive, str]


def _changes(drive: Drive, pulley: str, asked: Named, allow_paths: bool) -> Iterator[_Changed]:
    rows = [changes.other_carcass(drive.belt)] if asked.other_carcass else []
    with placed("belt"):
        rows += [catalogue.belt(name) for name in asked.belts]
    for row in rows:
        yield row.name, changes.with_belt(drive, row), f"{row.kind}, {row.provenance}"
    for name in asked.laggings:
        with placed("lagging"):
            lagging = load_lagging(name, allow_paths=allow_paths)
        note = str(lagging.source_of("law"))
        yield lagging.name, changes.with_lagging(drive, pulley, lagging), note
    for text in asked.thicknesses:
        thickness = _length(text, "thickness")
        yield f"h {text}", changes.with_thickness(drive, pulley, thickness), ""
    for text in asked.worn:
        note = "thinner, diameter smaller; what wear takes off the friction is not known"
        worn = changes.worn_to(drive, pulley, _length(text, "worn"))
        yield f"worn to {text}", worn, note
    if asked.wet:
        with placed("wet"):
            yield _wet(drive, pulley, asked.wet)
    if asked.bare:
        changed, source = changes.bare(drive, pulley, asked.bare)
        yield f"bare, {asked.bare}", changed, source


def _wet(drive: Drive, pulley: str, text: str) -> _Changed:
    if text[:1].isdigit() or text[:1] == ".":
        factor = parse_number(text)
        try:
            condition = Condition(name="wet", factor=factor)
        except InputError as error:
            told = (Problem(value=shown(text), message=p.message) for p in error.problems)
            raise InputError([*told]) from error
    else:
        condition = Condition(name="wet", standard=text)
    lagging = drive.pulley(pulley).lagging
    factor, source = condition.factor_of(lagging)
    note = f"friction factor {factor:.3g}, {source}"
    return "wet", changes.with_lagging(drive, pulley, condition.lagging(lagging)), note


def _length(text: str, key: str) -> float:
    with placed(key):
        value = parse_quantity(text, "length")
    message = Lagging.LIMITS["thickness"].refusal(value)
    if value == 0.0:
        message = "leaves no lagging"
    if message:
        remedy = "" if value else "Ask what a bare pulley does."
        raise input_error(key=key, value=shown(text), message=message, remedy=remedy)
    return value
