"""What the drive page needs to answer a moved slider itself."""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pydantic import ConfigDict, GetJsonSchemaHandler

from wraparc.arc import WrapArc
from wraparc.drive import Belt, Drive, LoadCase, Pulley, Tensions
from wraparc.drive.belt_mass import is_of_layers
from wraparc.drive.load_case import DESIGN
from wraparc.drive.tension_rules import EFFECTIVE
from wraparc.files.tensions import KEYS
from wraparc.files.tensions import Given as GivenLoad
from wraparc.friction import FrictionLaw
from wraparc.schema.limits import Limit
from wraparc.schema.source import Document
from wraparc.schema.tables import Record
from wraparc.units import Dimension, parse_quantity
from wraparc.web.answers.shown import Answer
from wraparc.web.in_page import Given

_PULLEY = ("diameter", "wrap_angle")
_BELT = ("width", "modulus", "speed")
#: With what a pull is given.
_WITH = {"torque": "diameter", "power": "speed"}
#: Keys of the independent quantities that give the tensions.
_PLAIN = KEYS[:3]
#: What makes the tensions of a drive depend on more than the numbers of its pulley and belt.
_ELSEWHERE = ("conveyor", "train")


class Plain(Answer):
    """Numbers, those that JSON has none for as words: Infinity, NaN."""

    model_config = ConfigDict(ser_json_inf_nan="strings")

    @classmethod
    def __get_pydantic_json_schema__(
        cls, core: Any, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """Return the form of it, in which a number may be a word."""
        found = handler(core)
        _name_words(handler.resolve_ref_schema(found))
        return found


def _name_words(form: Any) -> None:
    """Say of every number in a JSON schema by which words it may be told."""
    if isinstance(form, dict) and form.get("type") == "number":
        del form["type"]
        form["anyOf"] = [{"type": "number"}, {"enum": ["NaN", "Infinity", "-Infinity"]}]
    elif isinstance(form, dict | list):
        for part in form.values() if isinstance(form, dict) else form:
            _name_words(part)


class Law(Answer):
    """A friction law as numbers, see `wraparc.friction.CompactLaw`."""

    kind: int
    edges: list[float]
    coefficients: list[float]
    slips: list[float]
    onset_compliance: float


def law_of(law: FrictionLaw) -> Law:
    """Return a law as numbers."""
    compact = law.compact()
    return Law(
        kind=compact.kind,
        edges=list(compact.edges),
        coefficients=list(compact.coefficients),
        slips=list(compact.slips),
        onset_compliance=compact.onset_compliance,
    )


class Input(Plain):
    """A number of the document that the page may move, with what it may be [SI]."""

    path: list[str | int]
    name: str
    dimension: Dimension
    least: float
    most: float
    open: bool


class Prepared(Plain):
    """An arc as numbers."""

    law: Law
    given: dict[str, float]
    inputs: list[Input]


def prepared(document: Document, drive: Drive, pulley: Pulley, case: LoadCase) -> Prepared | None:
    """Return the arc of a drive of one pulley as numbers; None where a document says more."""
    if len(drive.pulleys) > 1 or any(key in document for key in _ELSEWHERE):
        return None
    arc = WrapArc.of(drive, pulley, case)
    law = law_of(arc.law)
    tensions = _tensions(document, drive, arc, case)
    given = {
        **{name: float(value) for name, value in arc.described()._asdict().items()},
        **dict.fromkeys(KEYS, math.nan),
        **tensions,
        "modulus": drive.belt.modulus,
        "speed": math.nan if drive.belt.speed is None else drive.belt.speed,
        "creep_limit": arc.creep_limit,
        "cover_compliance": arc.cover_compliance,
        "mass": math.nan if drive.belt.mass is None else drive.belt.mass,
        "belt_speed": math.nan,
        "slip_with_shear": float(arc.slip_with_shear),
        "steepest_fall": arc.law.steepest_fall(),
    }
    inputs = list(_inputs(document, drive, pulley, case, tensions))
    return Prepared(law=law, given={name: given[name] for name in Given._fields}, inputs=inputs)


def _tensions(document: Document, drive: Drive, arc: WrapArc, case: LoadCase) -> dict[str, float]:
    """Return by what the tensions are given: by the pulley in the design case, else by the case."""
    table = document["pulley"][0]
    if not _of_pulley(case):
        found = {
            "entry_tension": arc.entry_tension,
            "exit_tension": arc.exit_tension,
            "effective_tension": arc.effective_tension,
        }
        given, taken = _kinds(_own(document, case)), _taken(document, drive, case)
        return {key: found[key] for key in ((*given, taken) if taken else KEYS[:2])}
    return dict(_record(table))


def elsewhere(document: Document, drive: Drive, case: LoadCase) -> list[list[str | int]]:
    """Return the tensions of the pulley that a load case has nothing from."""
    if _of_pulley(case):
        return []
    taken = _taken(document, drive, case)
    left = _PLAIN if taken or len(_kinds(_own(document, case))) > 1 else ()
    return [["pulley", 0, key] for key in left if key != taken]


def _kinds(keys: Iterable[str]) -> set[str]:
    """Return the independent quantities that keys give."""
    return {_PLAIN[-1] if key in EFFECTIVE else key for key in keys if key in KEYS}


def _own(document: Document, case: LoadCase) -> dict[str, Any]:
    """Return what a load case gives of the tensions itself."""
    for table in document.get("load_case") or []:
        if case.name in (table.get("name"), f"{table.get('name')}, {case.condition}"):
            given: dict[str, Any] = next(iter((table.get("pulley") or {}).values()), {})
            return {key: value for key, value in given.items() if value is not None}
    return {}


def _taken(document: Document, drive: Drive, case: LoadCase) -> str:
    """Return the one tension or pull that a load case takes over from its pulley, if plain."""
    own, pulley = _own(document, case), drive.pulleys[0]
    base = GivenLoad.of(pulley.name, _record(document["pulley"][0]), pulley.diameter)
    fixed, speed = drive.criteria.take_up.fixed, drive.belt.speed
    kept = _kinds(base.overridden(_record(own), fixed=fixed, speed=speed).inherited)
    return kept.pop() if len(_kinds(own)) == 1 == len(kept) else ""


def _record(table: Mapping[str, Any]) -> Record:
    """Return the tensions of a table as they are read."""
    dimensions: dict[str, Dimension] = {"torque": "torque", "power": "power"}
    given = [key for key in KEYS if table.get(key) is not None]
    return Record({k: _read(table[k], dimensions.get(k, "force")) for k in given}, (), table)


def _read(value: Any, dimension: Dimension) -> float:
    return parse_quantity(value, dimension) if isinstance(value, str) else float(value)


def _inputs(
    document: Document, drive: Drive, pulley: Pulley, case: LoadCase, tensions: dict[str, float]
) -> Iterator[Input]:
    """Yield the numbers that change the arc in one plain way and nothing else."""
    limits = {**Belt.LIMITS, **Pulley.LIMITS, **pulley.lagging.LIMITS}
    at: tuple[str | int, ...] = ("pulley", 0)
    # a mass of the layers grows with the width
    held = {"width"} if is_of_layers(drive.belt) else set[str]()
    if not _of_pulley(case):  # a case may take its pull from the numbers of the pulley
        held |= {with_ for key, with_ in _WITH.items() if _somewhere(document, key)}
    for name in _BELT:
        if name not in held:
            yield _input(("belt", name), name, limits[name])
    for name in _PULLEY:
        if name not in held:
            yield _input((*at, name), name, limits[name])
    own = pulley.creep_limit is not None
    yield _input((*at, "creep_limit") if own else ("creep_limit",), "creep_limit", _CREEP)
    taken = _taken(document, drive, case)
    for name in sorted(tensions.keys() - _WITH.keys()):
        if _of_pulley(case) or (name == taken and document["pulley"][0].get(name) is not None):
            yield _input((*at, name), name, _PULL if name == "effective_tension" else _TENSION)
    if pulley.lagging_in(case.condition).block is None:  # else the modulus follows the thickness
        yield _input((*at, "lagging", "thickness"), "thickness", limits["thickness"])


_CREEP, _TENSION = Drive.LIMITS["creep_limit"], Tensions.LIMITS["entry"]
_PULL = Limit("force", least=-math.inf)


def _input(path: tuple[str | int, ...], name: str, limit: Limit) -> Input:
    return Input(
        path=list(path),
        name=name,
        dimension=limit.dimension,
        least=limit.least,
        most=limit.most,
        open=limit.open,
    )


def _of_pulley(case: LoadCase) -> bool:
    """Whether the tensions of a load case are those that the pulley itself gives."""
    return case.name in (DESIGN, f"{DESIGN}, {case.condition}")


def _somewhere(document: Document, key: str) -> bool:
    """Whether a pulley or a load case gives a key."""
    cases = document.get("load_case") or []
    of_cases = [table for case in cases for table in (case.get("pulley") or {}).values()]
    return any(key in table for table in (*document["pulley"], *of_cases))
