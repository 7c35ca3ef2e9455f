"""How each door tells the verdict of a drive, in one form: the only place that knows their words.

A verdict is level, name, pulley, load_case, value, limit and text, of which a door tells some.
"""

from __future__ import annotations

import math
from typing import Any

from worded import worded
from wraparc.checks import Verdict
from wraparc.units import in_units

Data = dict[str, Any]


def verdict_of(verdict: Verdict) -> Data:
    """Return the verdict that the library finds."""
    worst = verdict.governing
    told = {"level": str(verdict.level), "text": in_units(verdict.text)}
    if worst is None:
        return told
    place = {"pulley": worst.place.pulley, "load_case": worst.place.load_case}
    return {**told, "name": worst.name, **place, "value": worst.value, "limit": worst.limit}


def sentence_of(verdict: Verdict) -> str:
    """Return what is not kept, as a sentence that other commands tell too; else nothing."""
    worst = verdict.governing
    return plain(in_units(verdict.text)) if worst is not None and worst.missed else ""


def plain(text: str) -> str:
    return " ".join(text.split())


def of_json(data: Data) -> Data:
    """Return the verdict of the JSON of ``solve``."""
    made = {"level": data["level"], "text": data["text"], "name": data["name"]}
    place = data["place"] or {}
    made |= {key: place.get(key) or "" for key in ("pulley", "load_case")}
    # JSON has no word for what has no bound
    return made | {key: data[key] for key in ("value", "limit") if data[key] is not None}


def of_api(data: Data) -> Data:
    """Return the verdict of the JSON of the server."""
    return {"level": data["level"], "text": worded(data["text"])}


def of_screen(out: str, verdict: Verdict) -> Data:
    """Return the text that a screen begins with, that of the library where it begins so."""
    begins = plain(in_units(verdict.text)) in plain(out)
    return {} if begins else {"text": out[:300]}


def beside(data: Data, verdict: Verdict, *, level: bool = True) -> Data:
    """Return the verdict that a command tells first or beside its own sentence.

    Parameters
    ----------
    data
        The verdict of its answer in JSON: of the command, with what it says of the drive.
    verdict
        What the library says of the drive.
    level
        Whether the level of the answer is that of the drive alone.
    """
    texts = [data["text"], *(other["text"] for other in data["also"])]
    told, own = plain(" ".join(map(worded, texts))), sentence_of(verdict)
    made: Data = {"level": data["level"]} if level else {}
    return made if own in told else made | {"text": told}


def of_report(text: str, verdict: Verdict) -> Data:
    """Return the verdict that a calculation report in Markdown leads with."""
    word, _, rest = text.partition("- **")[2].partition("**")
    level = next((w for w in ("OK",) if word.startswith(w)), word)
    told = plain(rest.partition("\n- **")[0].replace("\\", ""))
    return {"level": level} if sentence_of(verdict) in told else {"level": level, "text": told}


def number(value: Any) -> float:
    """Return a number as JSON has it: none is nan."""
    return math.nan if value is None else float(value)
