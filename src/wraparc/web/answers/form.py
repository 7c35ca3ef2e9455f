"""The form of a drive, made from the keys of the drive file and the words of the glossary."""

from functools import cache
from typing import Any

from wraparc.drive import CREEP_LIMIT
from wraparc.files.drive_keys import BELT, LOAD_CASE, PULLEY, TENSIONS
from wraparc.files.lagging_keys import LAGGING_GIVEN
from wraparc.glossary import GLOSSARY
from wraparc.schema.kinds import Choice, Flag, Kind, Name, Quantity, TextOr, WordOr
from wraparc.schema.tables import Entry, Table
from wraparc.train.keys import TRAIN, TRAIN_FILE
from wraparc.units import DIMENSION_TEXT, DIMENSIONS, Dimension, display, display_unit, unit_factor
from wraparc.version import __version__
from wraparc.web.answers.shown import Data, both

_IN_GLOSSARY = {"width": "belt_width", "modulus": "belt_modulus", "speed": "belt_speed"}
_IN_LAGGING = {"thickness": "lagging_thickness"}
#: Keys of a lagging that a form has a field for; the others come with the lagging.
_OF_LAGGING = ("thickness", "shear_modulus", "compression_modulus", "elastic_modulus")
_ADVANCED = {
    "sources", "provenance", "kind", "least_pulley_diameter", "rating", "condition", "overrun",
    "recovery", "description", "format",
}  # fmt: skip
#: Ends of sliders [SI], and whether they go by factors.
_SLIDERS: dict[str, tuple[float, float, bool]] = {
    "pulley[].entry_tension": (5e3, 1e6, True),
    "pulley[].exit_tension": (2e3, 5e5, True),
    "pulley[].effective_tension": (-5e5, 5e5, False),
    "pulley[].diameter": (0.2, 2.0, False),
    "pulley[].wrap_angle": (1.5707963267948966, 4.1887902047863905, False),
    "pulley[].creep_limit": (1e-3, 2.5e-2, False),
    "pulley[].lagging.thickness": (2e-3, 3e-2, False),
    "belt.width": (0.4, 2.8, False),
    "belt.modulus": (1e6, 3e8, True),
    "belt.speed": (0.5, 10.0, False),
    "creep_limit": (1e-3, 2.5e-2, False),
}
_STEPS = 200


@cache
def form() -> Data:
    """Return sections with fields, units and glossary."""
    tensions = {entry.key for entry in TENSIONS}
    pulley = [entry for entry in PULLEY.entries if entry.key not in tensions]
    top = [e for e in TRAIN_FILE.entries if not isinstance(e.kind, Table) and _is_field(e)]
    lagging = [e for e in LAGGING_GIVEN.entries if e.key in _OF_LAGGING]
    case = [e for e in LOAD_CASE.entries if e.key in ("name", "description")]
    return {
        "version": __version__,
        "units": {dimension: _units(dimension) for dimension in DIMENSIONS},
        "glossary": {
            name: {
                "symbol": q.symbol,
                "dimension": q.dimension,
                "title": q.title,
                "meaning": q.meaning,
            }
            for name, q in GLOSSARY.items()
        },
        "sections": [
            _section("drive", "Drive", "", top),
            _section("belt", "Belt", "belt.", BELT.entries),
            _section("pulley", "Pulleys", "pulley[].", pulley, repeated=True),
            _section("tensions", "Tensions", "pulley[].", TENSIONS, repeated=True),
            _section("lagging", "Lagging", "pulley[].lagging.", lagging, repeated=True),
            _section("load_case", "Load cases", "load_case[].", case, repeated=True),
            _section("train", "Train", "train.", TRAIN.entries),
        ],
    }


def _is_field(entry: Entry) -> bool:
    return entry.key not in ("format", "belt", "pulley", "lagging", "load_case", "train")


def _section(key: str, title: str, prefix: str, entries: Any, *, repeated: bool = False) -> Data:
    names = _IN_GLOSSARY if key == "belt" else _IN_LAGGING if key == "lagging" else {}
    fields = [_field(entry, prefix, names.get(entry.key, entry.key)) for entry in entries]
    return {"key": key, "title": title, "repeated": repeated, "fields": fields}


def _field(entry: Entry, prefix: str, name: str) -> Data:
    path = prefix + entry.key
    worded = entry.kind if isinstance(entry.kind, WordOr) else None
    kind = worded.kind if worded else entry.kind
    quantity = GLOSSARY.get(name)
    return {
        "key": entry.key,
        "path": path,
        "title": entry.title or entry.key.replace("_", " ").capitalize(),
        "symbol": quantity.symbol if quantity else "",
        "help": entry.meaning,
        "kind": _kind_name(path, kind),
        "required": entry.required,
        "advanced": entry.key in _ADVANCED or path.startswith("load_case"),
        "options": list(kind.options) if isinstance(kind, Choice) else [],
        "word": worded.word if worded else None,
        "default": _default(path),
        "slider": _slider(path),
        **_limits(kind),
    }


def _kind_name(path: str, kind: Kind) -> str:
    if path == "belt.preset":
        return "belt"
    if path == "pulley[].lagging":
        return "lagging"
    if isinstance(kind, Quantity):
        return "number" if kind.dimension == "number" else "quantity"
    if isinstance(kind, Choice):
        return "choice"
    if isinstance(kind, Flag):
        return "flag"
    if isinstance(kind, Name):
        return "name"
    if type(kind).__name__ == "Text":
        return "text"
    if isinstance(kind, TextOr):
        return "lagging"
    return "table"


def _limits(kind: Kind) -> Data:
    empty: Data = {"dimension": None, "allowed": "", "least": None, "most": None, "range": None}
    if not isinstance(kind, Quantity):
        return empty
    limit, dimension = kind.limit, kind.dimension
    if limit is None:
        return {**empty, "dimension": dimension}
    ends = [end if abs(end) < float("inf") else None for end in (limit.least, limit.most)]
    return {
        "dimension": dimension,
        "allowed": str(limit),
        "least": ends[0],
        "most": ends[1],
        "range": both(
            lambda system: [
                None if end is None else display(end, dimension, system) for end in ends
            ]
        ),
    }


def _default(path: str) -> str | bool | None:
    if path == "creep_limit":
        return display(CREEP_LIMIT, "length")
    defaults: dict[str, str | bool] = {"pulley[].overrun": "formula", "pulley[].recovery": True}
    return defaults.get(path)


def _slider(path: str) -> Data | None:
    if path not in _SLIDERS:
        return None
    least, most, log = _SLIDERS[path]
    return {"least": least, "most": most, "step": (most - least) / _STEPS, "log": log}


def _units(dimension: Dimension) -> Data:
    def unit(system: Any) -> Data:
        text, factor = display_unit(dimension, system)
        return {"unit": text, "factor": factor}

    return {
        **both(unit),
        "choices": _choices(dimension),
        "factors": {
            unit: unit_factor(unit, dimension)
            for unit in (*_choices(dimension), *(("%",) if dimension == "number" else ()))
            if unit not in ("degC", "degF")
        },
        "example": DIMENSION_TEXT[dimension].example,
    }


_CHOICES: dict[str, tuple[str, ...]] = {
    "length": ("mm", "m", "cm", "in", "ft"),
    "force": ("kN", "N", "MN", "lbf", "klbf", "kgf"),
    "force_per_width": ("kN/m", "N/mm", "MN/m", "PIW"),
    "pressure": ("kPa", "MPa", "bar", "psi", "ksi"),
    "speed": ("m/s", "fpm", "fps"),
    "angle": ("deg", "rad"),
    "power": ("kW", "MW", "hp", "PS"),
    "torque": ("kN m", "N m", "lbf ft"),
    "area": ("m2", "cm2", "mm2", "in2", "ft2"),
    "rotation_speed": ("rpm", "rad/s"),
    "mass": ("kg", "t", "lbm"),
    "temperature": ("degC", "degF", "K"),
}


def _choices(dimension: Dimension) -> list[str]:
    return list(_CHOICES.get(dimension, tuple(display_unit(dimension)[:1])))
