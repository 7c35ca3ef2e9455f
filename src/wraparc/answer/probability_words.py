"""How probable the level of a verdict is: a line, a table and plain data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from wraparc.answer.reserve_words import input_name, source_text
from wraparc.answer.sheet import Row, Table, Verdict
from wraparc.checks import Level
from wraparc.drive import Drive
from wraparc.reserve import STATED, Probability, Uncertainty, find_probability
from wraparc.train.whole import Whole, by_pulley
from wraparc.units import fixed, percent


def with_probability(own: Verdict, result: Whole) -> Verdict:
    """Return the verdict on a drive with how probable an OK is."""
    found = find_probability(result)
    return replace(own, probability=probability_text(found), shares=found)


def probability_text(of: Probability) -> str:
    """Return one sentence on how many of the draws are OK."""
    if of.reason:
        return f"Not calculated: {of.reason}."
    stated = any(uncertainty.kind == STATED for _, uncertainty in of.inputs)
    which = "the stated and usual" if stated else "the usual"
    share = share_text(of.shares[Level.OK])
    return f"{Level.OK} in {share} of {of.draws:,} draws of {which} uncertainties."


def share_text(share: float) -> str:
    """Return a part of all draws in percent; none and all are said of these alone."""
    percent = round(100.0 * share)
    if percent in (0, 100) and share not in (0.0, 1.0):
        return "< 1 %" if percent == 0 else "> 99 %"
    return f"{percent:d} %"


def probability_table(result: Whole) -> Table:
    """Return the parts of the draws by level, and what was drawn."""
    found, drive = find_probability(result), by_pulley(result).drive
    rows = [Row(str(level), (share_text(share), "")) for level, share in found.shares.items()]
    rows += _inputs(found.inputs, drive)
    note = "Inputs normal about their values, 95 % within the uncertainty; all drawn at once."
    if found.reason:
        rows, note = [Row("none", ("", ""))], probability_text(found)
    heads = ("of draws", "uncertainty")
    return Table("Probability of the verdict", tuple(rows), heads, note, "probability")


def _inputs(inputs: Sequence[tuple[Any, Uncertainty]], drive: Drive) -> list[Row]:
    return [
        Row(
            input_name(of, drive),
            ("", uncertainty_text(uncertainty)),
            note=source_text(uncertainty),
        )
        for of, uncertainty in inputs
    ]


def uncertainty_text(of: Uncertainty) -> str:
    """Return an uncertainty in percent, to either side where these differ."""
    up, down = of.value, of.towards(-1.0)
    if up == down:
        return percent(up, 2)
    return f"{fixed(-down, 0, 'percent signed')} to {fixed(up, 0, 'percent signed')}"


def probability_data(of: Probability) -> dict[str, Any]:
    """Return the parts of the draws as plain data."""
    names = {Level.OK: "ok", Level.ATTENTION: "attention", Level.FAILS: "fails"}
    shares = {name: of.shares.get(level) for level, name in names.items()}
    return {"draws": of.draws, **shares}
