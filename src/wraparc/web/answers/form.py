"""The form of a drive, made from the keys of the drive file and the words of the glossary."""

from collections.abc import Iterable
from functools import cache

from wraparc.answer import key_figures
from wraparc.conveyor.keys import CONVEYOR, Slope
from wraparc.drive import CREEP_LIMIT, Lagging
from wraparc.drive.usual_sizes import USUAL_SIZES
from wraparc.files.across_keys import ACROSS, PULLEY_END, TRANSITION
from wraparc.files.drive_keys import BELT, CRITERIA, LOAD_CASE, PULLEY, TENSIONS
from wraparc.files.elongation import Elongation
from wraparc.files.lagging_keys import LAGGING_GIVEN
from wraparc.glossary import GLOSSARY
from wraparc.glossary import Quantity as GlossaryQuantity
from wraparc.motion.keys import CONTROL, DRUM, MOTION
from wraparc.schema.kinds import Choice, Count, Flag, Kind, Name, Quantity, Rows, TextOr, WordOr
from wraparc.schema.tables import Entry, Table, Variant
from wraparc.train.keys import TRAIN, TRAIN_FILE
from wraparc.units import (
    DIMENSION_TEXT,
    DIMENSIONS,
    Dimension,
    display,
    display_unit,
    unit_factor,
)
from wraparc.units.display import unit_row
from wraparc.version import __version__
from wraparc.web.answers.shown import Answer, Data

_IN_GLOSSARY = {
    "width": "belt_width", "modulus": "belt_modulus", "speed": "belt_speed",
    "thickness": "belt_thickness", "mass": "belt_mass",
}  # fmt: skip
_IN_KEYS = {
    "belt": _IN_GLOSSARY,
    "lagging": {"thickness": "lagging_thickness"},
    "pulley": {"mass": "pulley_mass"},
}
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
_ACROSS = "pulley[].across."


class Slider(Answer):
    """Ends of a slider [SI], and whether it goes by factors."""

    least: float
    most: float
    step: float
    log: bool


class Field(Answer):
    """One field of the form, and what may stand in it."""

    key: str
    path: str
    title: str
    symbol: str
    help: str
    kind: str
    required: bool
    options: list[str]
    word: str | None
    default: str | bool | None
    slider: Slider | None
    dimension: str | None = None
    allowed: str = ""
    least: float | None = None
    most: float | None = None
    usual: tuple[float, float] | None = None


class Section(Answer):
    """Fields under one heading."""

    key: str
    title: str
    repeated: bool
    fields: list[Field]


class Unit(Answer):
    """A unit, its size [SI], and what reads better, see `wraparc.units.display.UnitRow`."""

    unit: str
    factor: float
    larger: list[tuple[float, str, float, float]]


class Units(Answer):
    """The units of a dimension."""

    si: Unit
    us: Unit
    choices: list[str]
    factors: dict[str, float]
    example: str


class Term(Answer):
    """A quantity of the glossary."""

    symbol: str
    dimension: str
    title: str
    meaning: str


class Figure(Answer):
    """A key figure, see `wraparc.answer.key_figures`."""

    name: str
    better: str
    elsewhere: list[str]


class Form(Answer):
    """The form of a drive, the units, the glossary and the key figures."""

    version: str
    key_figures: list[Figure]
    units: dict[str, Units]
    glossary: dict[str, Term]
    sections: list[Section]
    criteria: list[str]


@cache
def form() -> Form:
    """Return sections with fields, units and glossary."""
    tensions = {entry.key for entry in TENSIONS}
    pulley = [entry for entry in PULLEY.entries if entry.key not in tensions]
    top = [e for e in TRAIN_FILE.entries if not isinstance(e.kind, Table) and _is_field(e)]
    lagging = [e for e in LAGGING_GIVEN.entries if e.key in Lagging.LIMITS]
    case = [e for e in LOAD_CASE.entries if e.key in ("name", "description")]
    criteria = [
        _section(e.key, e.title, f"{e.key}.", e.kind.entries)
        for e in CRITERIA
        if isinstance(e.kind, Table)
    ]
    return Form(
        version=__version__,
        key_figures=[Figure(**figure._asdict()) for figure in key_figures.KEY_FIGURES],
        criteria=[section.key for section in criteria],
        units={dimension: _units(dimension) for dimension in DIMENSIONS},
        glossary={name: _term(quantity) for name, quantity in GLOSSARY.items()},
        sections=[
            _section("drive", "Drive", "", top),
            _section("belt", "Belt", "belt.", BELT.entries),
            _section("pulley", "Pulleys", "pulley[].", pulley, repeated=True),
            _section("tensions", "Tensions", "pulley[].", TENSIONS, repeated=True),
            _section("lagging", "Lagging", "pulley[].lagging.", lagging, repeated=True),
            _section("load_case", "Load cases", "load_case[].", case, repeated=True),
            _section("conveyor", "Conveyor", "conveyor.", filter(_is_plain, CONVEYOR.entries)),
            *_conveyor_parts(),
            *criteria,
            _section("train", "Train", "train.", TRAIN.entries),
            _section("motion", "In time", "motion.", filter(_is_plain, MOTION.entries)),
            _section(
                "motion_drum",
                "Drives in time",
                "motion.drum[].",
                filter(_is_plain, DRUM.entries),
                repeated=True,
            ),
            *(
                _section(f"control {kind}", kind, "motion.drum[].control.", table.entries[1:])
                for kind, table in CONTROL.tables.items()
            ),
            _section("across", "Across the width", _ACROSS, ACROSS.entries, repeated=True),
            _section("transition", "Transition", f"{_ACROSS}before.", TRANSITION.entries),
            _section("gripping", "Other pulley", f"{_ACROSS}after.", PULLEY_END.entries),
        ],
    )


def _conveyor_parts() -> Iterable[Section]:
    """Yield a section a table of the conveyor: its flights, loading points, drives and the rest."""
    for entry in CONVEYOR.entries:
        kind, key = entry.kind, f"conveyor.{entry.key}"
        if isinstance(kind, Table):
            yield _section(key, entry.title, f"{key}.", kind.entries)
        elif isinstance(kind, Rows) and isinstance(kind.kind, Table):
            of = filter(_is_plain, kind.kind.entries)
            yield _section(key, entry.title, f"{key}[].", of, repeated=True)
        elif isinstance(kind, Rows) and isinstance(kind.kind, Variant):
            for name, table in kind.kind.tables.items():
                of = filter(_is_plain, table.entries[1:])
                yield _section(f"{key} {name}", name.capitalize(), f"{key}[].", of, repeated=True)


def _term(quantity: GlossaryQuantity) -> Term:
    return Term(**{name: getattr(quantity, name) for name in Term.model_fields})


def _is_field(entry: Entry) -> bool:
    return entry.key not in ("format", "belt", "pulley", "lagging", "load_case", "train")


def _is_plain(entry: Entry) -> bool:
    """Whether an entry is one value, and no table or list of them."""
    return _kind_name("", entry.kind) != "table"


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


#: Fields whose usual sizes are known, by their place in `USUAL_SIZES`.
_USUAL = {
    "belt.width": 0, "belt.modulus": 1, "belt.speed": 2, "pulley[].diameter": 3,
    "pulley[].wrap_angle": 4, "creep_limit": 6, "pulley[].lagging.thickness": 8,
    "pulley[].lagging.shear_modulus": 9, "pulley[].lagging.compression_modulus": 10,
    "belt.rating": 11,
}  # fmt: skip


def _section(
    key: str, title: str, prefix: str, entries: Iterable[Entry], *, repeated: bool = False
) -> Section:
    names = _IN_KEYS.get(key, {})
    # a run is a length in time, and no rise of tension; a position on a conveyor is no angle
    own = prefix.startswith(("motion.", "conveyor.")) and prefix != "conveyor."
    fields = [
        _field(entry, prefix, "" if own else names.get(entry.key, entry.key)) for entry in entries
    ]
    return Section(key=key, title=title, repeated=repeated, fields=fields)


def _field(entry: Entry, prefix: str, name: str) -> Field:
    path = prefix + entry.key
    worded = entry.kind if isinstance(entry.kind, WordOr) else None
    kind = worded.kind if worded else entry.kind
    quantity = GLOSSARY.get(name)
    return Field(
        key=entry.key,
        path=path,
        title=entry.title or entry.key.replace("_", " ").capitalize(),
        symbol=quantity.symbol if quantity else "",
        help=entry.meaning,
        kind=_kind_name(path, kind),
        required=entry.required,
        options=list(kind.options) if isinstance(kind, Choice) else [],
        # shown where nothing is given: no belt is rigid by leaving its modulus out
        word=worded.word if worded and path != "belt.modulus" else None,
        default=_default(path),
        slider=_slider(path),
        usual=USUAL_SIZES[_USUAL[path]] if path in _USUAL else None,
        **_limits(kind),
    )


def _kind_name(path: str, kind: Kind) -> str:
    if path == "belt.preset":
        return "belt"
    if path == "pulley[].lagging":
        return "lagging"
    if isinstance(kind, Slope):  # 3 % or 2 deg
        return "text"
    if isinstance(kind, Count):
        return "number"
    if isinstance(kind, Quantity):
        return "number" if kind.dimension == "number" else "quantity"
    if isinstance(kind, Choice):
        return "choice"
    if isinstance(kind, Flag):
        return "flag"
    if isinstance(kind, Name):
        return "name"
    if type(kind).__name__ == "Text" or isinstance(kind, Elongation):
        return "text"
    return _kind_name("", kind.text) if isinstance(kind, TextOr) else "table"


def _limits(kind: Kind) -> Data:
    if isinstance(kind, Count):
        return {"dimension": "number"}
    if not isinstance(kind, Quantity) or isinstance(kind, Slope):
        return {}
    limit, dimension = kind.limit, kind.dimension
    if limit is None:
        return {"dimension": dimension}
    least, most = (end if abs(end) < float("inf") else None for end in (limit.least, limit.most))
    return {"dimension": dimension, "allowed": str(limit), "least": least, "most": most}


def _default(path: str) -> str | bool | None:
    if path == "creep_limit":
        return display(CREEP_LIMIT, "length")
    defaults: dict[str, str | bool] = {"pulley[].overrun": "formula", "pulley[].recovery": True}
    return defaults.get(path)


def _slider(path: str) -> Slider | None:
    if path not in _SLIDERS:
        return None
    least, most, log = _SLIDERS[path]
    return Slider(least=least, most=most, step=(most - least) / _STEPS, log=log)


def _units(dimension: Dimension) -> Units:
    choices = list(_CHOICES.get(dimension, tuple(display_unit(dimension)[:1])))
    sized = [*choices, "%"] if dimension == "number" else choices
    return Units(
        si=Unit.model_validate(unit_row(dimension, "si")),
        us=Unit.model_validate(unit_row(dimension, "us")),
        choices=choices,
        factors={u: unit_factor(u, dimension) for u in sized if u not in ("degC", "degF")},
        example=DIMENSION_TEXT[dimension].example,
    )
