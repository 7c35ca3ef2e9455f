"""The tables of a drive file, their keys already read, to belt, laggings and pulleys."""

from collections.abc import Iterable, Mapping
from typing import Any

from wraparc import catalogue
from wraparc.catalogue.belt_modulus import STATIC
from wraparc.catalogue.standard_belts import modulus_problem, standard_belt
from wraparc.conveyor import Point, wrap_angle
from wraparc.conveyor.keys import POINT_KEYS
from wraparc.drive import (
    Belt,
    Criteria,
    Lagging,
    Pulley,
    Sag,
)
from wraparc.drive.belt import LAYERS, THICKNESS, UNCERTAIN_OF_BELT
from wraparc.drive.belt_mass import layer_mass, layer_source
from wraparc.drive.changes import BELT_KEYS, belt_sources
from wraparc.drive.drive import flying_problems, side_problems
from wraparc.drive.pulley import UNCERTAIN_OF_PULLEY
from wraparc.errors import InputError, Problem
from wraparc.files.across_keys import build_across
from wraparc.files.conditions import Conditions, at_its_place, condition_of
from wraparc.files.drive_keys import BELT, CRITERIA, PULLEY, SAG
from wraparc.files.lagging_build import build_laggings
from wraparc.files.lagging_file import catalogue_laggings, is_path, lagging_record
from wraparc.files.lagging_keys import LAGGING_GIVEN
from wraparc.provenance import Provenance
from wraparc.schema.origins import own_provenance, read_sources
from wraparc.schema.problems import Place, Report
from wraparc.schema.tables import Record
from wraparc.schema.uncertain import read_uncertainty

_FROM_PATH = Provenance(note="from the coordinates of the pulleys")
_PRESET_KEYS = ("name", *BELT_KEYS)
#: Keys that tell the carcass of a belt, which then is no usual one of its name.
_CARCASS_KEYS = {"carcass", "thickness", "cord_diameter"}
_MODULUS_KEYS = ("modulus_test", "modulus_loads", "modulus_ends")
# Keys of a lagging that hold numbers.
_NUMBERS = {e.key for e in LAGGING_GIVEN.entries} - {
    "preset", "name", "title", "description", "surface", "notes", "sources", "provenance",
}  # fmt: skip
# Keys of which a table may hold one: giving it drops the others of the preset.
_EITHER = (("compression_modulus", "block", "replaced_block"),)


def build_belt(record: Record, report: Report) -> Belt | None:
    """Return the belt of a ``[belt]`` table, or None after reporting.

    One whose layers are at fault, which was reported, comes without its thickness: what else is
    wrong with it is told as well, see `report_together`.
    """
    sources = read_sources(record, (e.key for e in BELT.entries), report)
    uncertainty = read_uncertainty(record, UNCERTAIN_OF_BELT, report)
    own = own_provenance(record, report) or Provenance()
    more: dict[str, Any] = {"name": "belt", "provenance": own}
    named = _named_belt(record, report)
    unnamed = "modulus" not in record and not record.sound("name", "preset")
    if named is None and ("preset" in record or unnamed):
        return None
    if named is not None:
        more = {key: getattr(named, key) for key in (*_PRESET_KEYS, "provenance")}
        if "modulus" in record:  # how that of the maker was measured says nothing of it
            more = {key: value for key, value in more.items() if key not in _MODULUS_KEYS}
        published = belt_sources(named)
        more["carcass_ends"] = None if _CARCASS_KEYS & {*record} else named.carcass_ends
        if "thickness" in record or "cord_diameter" in record:  # the carcass follows from them
            more, published = {**more, "carcass": None}, _without(published, "carcass")
        mass = _preset_mass(record, named)
        if mass is not None:
            more, published = {**more, "mass": mass}, published | {"mass": layer_source(named)}
        sources = published | {key: own for key in Belt.LIMITS if key in record} | sources
    if "elongation" in record:
        by_elongation = _modulus_of_elongation(record, more, report)
        if by_elongation is None:
            return None
        more |= by_elongation
        note = f"by elongation, {record['elongation']}"
        sources = {**sources, "modulus": Provenance(note=note)}
    elif not {"modulus"} & {*more, *record} and record.sound("modulus", "elongation"):
        remedy = 'Write modulus = "12960 kN/m" or preset = "EP 630/3".'
        report.add((*record.place, "modulus"), "missing", remedy)
        return None
    more = {key: v for key, v in more.items() if key == "provenance" or key not in record}
    origins = {"sources": sources, "uncertainty": uncertainty}
    built: Belt | None = BELT.built(record, report, **origins, **more)
    known = "modulus" in more or "modulus" in record
    if built is not None or not (known and record.sound("width", "modulus")):
        return built
    values = {key: value for key, value in record.items() if key not in record.faulty}
    sound = Record(values, record.place, record.raw)
    # what its layers have wrong together, where another number of it is at fault
    layers = report if not record.sound() and record.sound(*LAYERS, THICKNESS) else Report()
    built = BELT.built(sound, layers, sources={}, **more)
    sound.pop(THICKNESS, None)
    return built or BELT.built(sound, Report(), sources={}, **more)


def _without(sources: dict[str, Provenance], key: str) -> dict[str, Provenance]:
    return {name: of for name, of in sources.items() if name != key}


def _named_belt(record: Record, report: Report) -> catalogue.CatalogueBelt | None:
    """Return the belt that a table names by ``preset``, or by a standard name alone.

    A standard ``name`` beside a modulus is a name and nothing more: the belt is then described by
    its own keys.
    """
    stated = "modulus" in record or "elongation" in record
    if "preset" in record:
        place, name = (*record.place, "preset"), record["preset"]
        return report.tried(lambda: catalogue.belt(name, with_modulus=not stated), place, name)
    if "modulus" in record or "name" not in record or not record.sound("modulus", "elongation"):
        return None
    place, name = (*record.place, "name"), record["name"]
    before = len(report.problems)
    found = report.tried(lambda: standard_belt(name), place, name)
    problem = None if found is None or stated else modulus_problem(found)
    if problem is not None:
        report.add(place, problem.message, problem.remedy, name)
    if len(report.problems) > before:
        record.faulty.add("name")
        return None
    return found


def _modulus_of_elongation(
    record: Record, named: Mapping[str, Any], report: Report
) -> dict[str, Any] | None:
    """Return the modulus by the elongation at a share of the strength, and how it was measured.

    M = (share x strength)/elongation [N/m] of a first stretch; None after reporting.
    """
    place = (*record.place, "elongation")
    if "modulus" in record:
        report.add(place, "modulus gives it already", "Leave one of them out.")
        return None
    strength = record.get("strength", named.get("strength"))
    if strength is None:
        remedy = 'Write strength = "630 kN/m", or name the belt EP 630/3.'
        if record.sound("strength"):
            report.add(place, "needs the strength of the belt", remedy)
        return None
    of = record["elongation"]
    return {
        "modulus": of.share * strength / of.strain,
        "modulus_test": STATIC,
        "modulus_loads": (0.0, of.share),
        "modulus_ends": None,
    }


def _preset_mass(record: Record, preset: catalogue.CatalogueBelt) -> float | None:
    """Return the mass of a preset with known covers [kg/m], None where it is not known."""
    pulley, carry = (
        record.get(key, getattr(preset, key)) for key in ("pulley_cover", "carry_cover")
    )
    own = {"carcass", "cord_diameter", "mass"} & {*record}
    if "width" not in record or pulley is None or carry is None or own:
        return None
    return layer_mass(preset, record["width"], pulley, carry)


def report_together(
    record: object,
    belt: Belt | None,
    pulleys: Iterable[Pulley | None],
    tensions: Mapping[str, float],
    report: Report,
) -> None:
    """Report what belt and drums have wrong together, where a drive cannot be made to tell it.

    Parameters
    ----------
    record, belt
        The ``[belt]`` table, and the belt as far as it could be made.
    pulleys
        As far as they could be made.
    tensions
        The least tension of every load case, by the key where it stands [N].
    report
        Takes what is wrong, if it has something already.
    """
    if not report.problems or belt is None or not isinstance(record, Record):
        return
    found = [p for key, least in tensions.items() for p in flying_problems(belt, key, least)]
    if record.sound(*LAYERS, THICKNESS):
        found += side_problems(belt, [pulley for pulley in pulleys if pulley is not None])
    if found:
        report.take(InputError(found), ())


class Laggings:
    """The laggings that a drive file can name: its own, those of the catalogue, files.

    Parameters
    ----------
    own
        Tables of the drive file by name.
    folder
        What the path of a lagging file is relative to.
    allow_paths
        Whether files may be named at all.
    report
        Takes what is wrong.
    """

    def __init__(self, own: dict[str, Any], folder: str, allow_paths: bool, report: Report) -> None:
        self._report = report
        self._folder = folder
        self._allow_paths = allow_paths
        self._names = tuple(own)
        self._own: dict[str, Record | None] = {}
        self._built: dict[str, tuple[Lagging, ...]] = {}
        self._own = {
            name: self._merged(record, name) if isinstance(record, Record) else None
            for name, record in own.items()
        }
        self._built = {
            name: build_laggings(record, report) if record else ()
            for name, record in self._own.items()
        }

    def of(self, value: object, place: Place) -> tuple[Lagging, ...]:
        """Return a lagging in all its conditions, by name, path or table; none if faulty."""
        if isinstance(value, Record):
            merged = self._merged(value, "")
            return build_laggings(merged, self._report) if merged else ()
        if value in self._built:
            return self._built[str(value)]
        name = str(value)
        record = self._found(name, place)
        if record is None:
            return ()
        if is_path(name):
            return build_laggings(record, self._report)
        kept = self._report.tried(lambda: catalogue_laggings(name), place, name)
        return kept or ()

    def _found(self, name: str, place: Place) -> Record | None:
        """Return what a name or path stands for, outside the drive file or in it."""
        if name in self._own:
            return self._own[name] if self._built[name] else None
        try:
            known = (*self._names, *catalogue.lagging_names())
            if not is_path(name) and name not in known:
                raise catalogue.unknown_name("lagging", name, known, "wraparc laggings")
            return lagging_record(name, self._folder, self._allow_paths)[0]
        except InputError as error:
            self._report.take(_at_home(error), place, name)
            return None

    def _merged(self, given: Record, name: str) -> Record | None:
        """Return a lagging table with its preset below it, or None after reporting."""
        base = None
        if "preset" in given:
            base = self._found(given["preset"], (*given.place, "preset"))
            if base is None:
                return None
        values = dict(base or {})
        for group in _EITHER:
            if any(key in given for key in group):
                for key in group:
                    values.pop(key, None)
        owner = str(given.place[-2]) if len(given.place) > 1 else "lagging"
        values = {"name": name or owner, **values, **given}
        if base is not None:
            values |= _merged_origins(base, given)
            blocks = base.get("block", base.get("replaced_block"))
            if "compression_modulus" in given and blocks is not None:
                values["replaced_block"] = blocks
        return Record(values, given.place, given.raw, given.faulty)


def _merged_origins(base: Record, given: Record) -> dict[str, Any]:
    """Return provenance and sources of a preset with some of its numbers replaced."""
    own = given.get("provenance") or _given_instead(given)
    sources = {key: of for key, of in base.get("sources", {}).items() if key not in given}
    sources |= {key: own for key in given if key in _NUMBERS}
    provenance = {"provenance": base["provenance"]} if "provenance" in base else {}
    return {"sources": sources | given.get("sources", {}), **provenance}


def _given_instead(given: Record) -> Record:
    """Return the provenance of a number that stands in for one of the preset."""
    note = f"instead of that of {given['preset']}"
    return Record({"kind": "given", "note": note}, given.place, {})


def _at_home(error: InputError) -> InputError:
    """Return the error of a file that could not be opened as one of the place that named it."""
    return InputError(
        problem
        if problem.key or problem.line or not problem.file
        else Problem(message=f"{problem.file}: {problem.message}", remedy=problem.remedy)
        for problem in error.problems
    )


def build_pulley(
    record: Record, laggings: Laggings, conditions: Conditions, report: Report
) -> Pulley | None:
    """Return the pulley of a ``[[pulley]]`` table, or None after reporting."""
    sources = read_sources(record, (e.key for e in PULLEY.entries), report)
    uncertainty = read_uncertainty(record, UNCERTAIN_OF_PULLEY, report)
    laws: tuple[Lagging, ...] = ()
    if "lagging" in record:
        laws = laggings.of(record["lagging"], (*record.place, "lagging"))
    if not laws:
        return None
    own = [(c, place) for c, place in conditions.main[:1]]
    if "condition" in record:
        place = (*record.place, "condition")
        own = [(condition_of(record["condition"], report), place)]
    found = [
        report.tried(lambda c=c: at_its_place(c, laws), place)  # type: ignore[misc]
        for c, place in (*own, *conditions.several)
    ]
    sure = [lagging for lagging in found if lagging is not None]
    if len(sure) < len(found):
        return None
    lagging = sure[0] if own else laws[0]
    by_name = {lag.condition: lag for lag in sure[len(own) :]}
    more: dict[str, Any] = {"conditions": tuple(by_name.values()), "uncertainty": uncertainty}
    if "belt_path" in record:
        wrap = _wrap_of(record, report)
        if wrap is None:
            return None
        more["wrap_angle"], sources = wrap, {"wrap_angle": _FROM_PATH, **sources}
    if "across" in record:
        found_before = len(report.problems)
        more["across"] = build_across(record["across"], report)
        if len(report.problems) > found_before:
            return None
    built: Pulley | None = PULLEY.built(record, report, lagging=lagging, sources=sources, **more)
    return built


def _wrap_of(record: Record, report: Report) -> float | None:
    """Return the wrap angle of a pulley from its belt path, or None after reporting."""
    path = record["belt_path"]
    if "wrap_angle" in record:
        remedy = "Leave one of them out."
        report.add((*record.place, "wrap_angle"), "belt_path gives it already", remedy)
        return None
    if not isinstance(path, Record) or not path.sound() or "diameter" not in record:
        return None

    def point(given: Record, **more: Any) -> Point:
        return Point(**{key: given[key] for key in POINT_KEYS if key in given}, **more)

    own = point(path, diameter=record["diameter"])
    return report.tried(
        lambda: wrap_angle(point(path["before"]), own, point(path["after"])), path.place
    )


def build_criteria(record: Record, belt: Belt | None, report: Report) -> Criteria:
    """Return what a drive is held against; what is wrong is reported."""
    parts = {
        e.attribute: e.kind.built(record.get(e.key), report) for e in CRITERIA if e.key != "sag"
    }
    parts["sag"] = build_sag(record.get("sag"), _mass(record, belt), report)
    return Criteria(**{name: part for name, part in parts.items() if part is not None})


def build_sag(record: object, mass: float | None, report: Report) -> Sag | None:
    """Return what a ``[sag]`` table asks for; a belt of a mass [kg/m] hangs there if left out."""
    if not isinstance(record, Record):
        return None
    more: dict[str, Any] = {}
    if not {"line_mass"} & {*record, *record.faulty}:
        if mass is None:
            remedy = 'Write for example line_mass = "22 kg/m", or mass in [belt].'
            report.add((*record.place, "line_mass"), "missing", remedy)
            return None
        more["line_mass"] = mass
    built: Sag | None = SAG.built(record, report, **more)
    return built


def _mass(record: Record, belt: Belt | None) -> float | None:
    """Return the mass of the belt, that of a conveyor before one computed of layers [kg/m]."""
    conveyor = record.get("conveyor")
    of_conveyor: float | None = None
    if isinstance(conveyor, Record) and "belt_mass" in conveyor:
        of_conveyor = conveyor["belt_mass"]
    return belt.mass if belt is not None and of_conveyor is None else of_conveyor
