"""What the name of a test file tells, as ``wet-0034kPa-1.csv`` does."""

import re
from dataclasses import dataclass

from wraparc.shear_test.digitised import guessed_pressure

#: Words for a condition, as files are named, and the condition that they mean.
_CONDITIONS = {
    "dry": "dry", "wet": "wet", "clay": "clay", "mud": "mud", "muddy": "mud", "moist": "moist",
    "damp": "moist", "ice": "ice", "icy": "ice", "frozen": "ice", "dusty": "dusty",
    "trocken": "dry", "nass": "wet", "seco": "dry", "mojado": "wet", "sec": "dry",
    "humide": "wet", "suchy": "dry", "mokry": "wet",
}  # fmt: skip
_DATE = re.compile(r"\d{4}-\d\d-\d\d")
_WORD = re.compile(r"[^\W\d_]+")
#: A number of one or two digits at the end of the name, set apart.
_NUMBER = re.compile(r"[-_ #(](?:no|nr|run|test|rep|repeat)?[-_ .]?(\d{1,2})\)?$", re.IGNORECASE)


@dataclass(frozen=True)
class NamedTest:
    """Pressure, condition and number of a test by the name of its file; None where untold."""

    pressure: str | None
    condition: str | None
    number: str | None


def read_name(file: str) -> NamedTest:
    """Return what the name of a file tells of its test."""
    stem = file.rpartition(".")[0] or file
    words = [_CONDITIONS.get(word.lower()) for word in _WORD.findall(stem)]
    known = list(dict.fromkeys(word for word in words if word))
    number = _NUMBER.search(_DATE.sub("", stem))
    return NamedTest(
        pressure=guessed_pressure(file),
        condition=known[0] if len(known) == 1 else None,
        number=number[1].lstrip("0") or None if number else None,
    )
