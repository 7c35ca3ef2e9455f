"""What a machine file says of its test beside the readings: pressure, load, temperature, speed.

In a column that does not change, or above the table. It is used where the plan says nothing, and
held against the plan where that says something else.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from wraparc.arrays import Array
from wraparc.errors import InputError
from wraparc.machine_tables import NamedColumn, plain_name
from wraparc.shear_test.roles import Role, is_demand, suitability
from wraparc.units import Dimension, dimension_of, in_each, parse_quantity, quantity

# What a column or a line is about, by its name: the quantity, its dimension, and its names.
_NAMES: tuple[tuple[str, Dimension, re.Pattern[str]], ...] = (
    (
        "pressure",
        "pressure",
        re.compile(
            r"pressure|\bdruck|pressung|\bpression|presion|pressao|cisnien|nacisk|\btlak|\btryck"
            r"|basinc|давлени|压力|压强|圧力|面圧|압력|\bp n\b|\bpn\b"
        ),
    ),
    (
        "temperature",
        "temperature",
        re.compile(
            r"temp|temperatur|teplot|sicaklik|температур|温度|온도|warmte"
        ),
    ),
    (
        "speed",
        "speed",
        re.compile(
            r"speed|velocit|geschwind|vitesse|velocid|predkosc|rychlost|snelheid|hastighet|\bhiz"
            r"|скорост|速度|속도"
        ),
    ),
    (
        "area",
        "area",
        re.compile(r"(sample|contact|specimen|proben|kontakt|eprouvette|probeta|provino).*"
                   r"(area|flache|surface|aire|superfic)"),
    ),
)  # fmt: skip
# What presses elsewhere: air, oil, a pump.
_ELSEWHERE = re.compile(
    r"hydraul|\boil|\bol\b|\bair\b|luft|atmos|ambient|barom|supply|pump|pneum|vacu|vaku|system"
    r"|versorg|umgeb|shear|scher|schub|cisail|cisalh|taglio|peak|\bmax"
)
_CONDITION = re.compile(
    r"condition|zustand|\betat|condicion|condicao|condizion|\bstan\b|\bstav\b|toestand|tillstand"
    r"|durum|состояни|状态|状態|상태|surface|oberflache"
)
_WORDS = {
    "dry": "dry trocken sec seche seco seca asciutto asciutta secco suchy sucha suche sucho droog "
    "torr torrt kuru сухой сухая 干 干燥 乾燥 건조",
    "wet": "wet nass mouille mouillee mojado mojada humedo molhado molhada umido bagnato bagnata "
    "mokry mokra mokre nat vat vatt islak мокрый мокрая влажный 湿 潮湿 濡れ 湿潤 습윤",
}
_CONDITIONS = {word: name for name, words in _WORDS.items() for word in words.split()}
_LINE = re.compile(
    r"^(?P<name>[^\d:=]{3,60}?)\s*(?:[(\[\uff08](?P<before>[^)\]\uff09]+)[)\]\uff09])?\s*[:=\uff1a]?\s+"
    r"(?P<number>[-+]?\d[\d.,]*)\s*(?P<after>[^\s\d;]\S*)?$"
)
_SPELLED = (("KPA", "kPa"), ("kpa", "kPa"), ("Kpa", "kPa"))
# A column that changes by more than this, over its middle, says no one value.
_ONE_VALUE = 0.05


class Stated(NamedTuple):
    """What a file says: of what, its value [SI] or word, and where it stands."""

    of: str
    value: float
    word: str
    place: str

    @property
    def text(self) -> str:
        """The value in words."""
        return self.word or stated_text(self.of, self.value)


def stated_text(of: str, value: float) -> str:
    """Return a value as a sentence shows it."""
    if of == "speed":
        return in_each(value, "speed", "mm/min", "in/min")
    if of == "area":
        return in_each(value, "area", "cm2", "in2")
    return quantity(value, "force" if of == "normal force" else of)  # type: ignore[arg-type]


def stated_in_file(
    named: Sequence[NamedColumn],
    data: Mapping[int, Array],
    words: Mapping[int, str],
    header: Sequence[Sequence[str]],
    used: Sequence[int],
) -> tuple[Stated, ...]:
    """Return what the columns that are no readings, and the lines above them, say.

    Parameters
    ----------
    named, data
        Columns of the test, and the numbers of each.
    words
        The one word of each column that has no other.
    header
        Lines above the table, as cells.
    used
        Columns that are readings of the test.
    """
    found = [item for c in named if c.index not in used for item in _in_column(c, data, words)]
    said = {item.of for item in found}
    above = [item for row in header for item in _in_line(row) if item.of not in said]
    # what stands there more than once, and is not the same, says nothing of one test
    alike = {
        of: {round(item.value, 9) for item in above if item.of == of} for of in
        {item.of for item in above}
    }  # fmt: skip
    return (*found, *(i for i in dict.fromkeys(above) if len(alike[i.of]) == 1))


def _in_column(
    column: NamedColumn, data: Mapping[int, Array], words: Mapping[int, str]
) -> Iterator[Stated]:
    place, name = f"its column {column.label}", plain_name(column.name)
    if column.index in words:
        word = _CONDITIONS.get(plain_name(words[column.index]))
        if word and _CONDITION.search(name):
            yield Stated("condition", 0.0, word, place)
        return
    values = data[column.index]
    values = values[np.isfinite(values)]
    of = _quantity(name, column.unit)
    if of is None or not len(values):
        return
    middle = values[len(values) // 5 :]
    value = float(np.median(middle))
    spread = float(np.quantile(middle, 0.9) - np.quantile(middle, 0.1))
    if of in {"pressure", "area"} and spread > _ONE_VALUE * abs(value):
        return
    known = _si(value, column.unit, of)
    if known is not None:
        yield Stated(of, known, "", place)


def _in_line(row: Sequence[str]) -> Iterator[Stated]:
    text = " ".join(cell.strip() for cell in row if cell.strip())
    name, sign, word = text.partition(":")
    if sign and _CONDITION.search(plain_name(name)):
        known = _CONDITIONS.get(plain_name(word))
        if known:
            yield Stated("condition", 0.0, known, f"its head ({name.strip()[:40]})")
        return
    match = _LINE.match(text)
    if match is None or is_demand(match["name"]):
        return
    unit = (match["before"] or match["after"] or "").strip()
    name = match["name"].strip(" ,;:=")
    if suitability(name, Role.NORMAL_FORCE) > 0.0 and dimension_of(_spelled(unit)) == "force":
        of: str | None = "normal force"
    else:
        of = _quantity(plain_name(name), unit)
    number = _number(match["number"])
    if of is None or number is None:
        return
    value = _si(number, unit, of)
    if value is not None:
        yield Stated(of, value, "", f"its head ({name[:40]})")


def _number(text: str) -> float | None:
    """Number of a head; None where its comma may be either sign."""
    plain = text.rstrip(".,")
    if "," in plain and "." in plain:
        last = max(plain.rfind(","), plain.rfind("."))
        plain = re.sub(r"[.,]", "", plain[:last]) + "." + plain[last + 1 :]
    elif plain.count(",") + plain.count(".") > 1 or re.fullmatch(r"[-+]?[1-9]\d{0,2},\d{3}", plain):
        return None
    try:
        return float(plain.replace(",", "."))
    except ValueError:
        return None


def _spelled(unit: str) -> str:
    for old, new in _SPELLED:
        unit = unit.replace(old, new)
    return unit.strip("[]()<>")


def _quantity(name: str, unit: str) -> str | None:
    """What a name is about, where its unit is one of it."""
    if _ELSEWHERE.search(name):
        return None
    measured = dimension_of(_spelled(unit)) if unit.strip() else None
    return next((of for of, d, names in _NAMES if d == measured and names.search(name)), None)


def _si(value: float, unit: str, of: str) -> float | None:
    dimension: Dimension = next((d for name, d, _ in _NAMES if name == of), "force")
    try:
        known = parse_quantity(f"{value!r} {_spelled(unit)}", dimension)
    except InputError:
        return None
    return known if of == "temperature" or known > 0.0 else None
