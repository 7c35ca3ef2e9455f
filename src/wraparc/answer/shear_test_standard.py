"""Friction by pressure as test reports state it: static, kinetic, at standard slips."""

import math

import numpy as np

from wraparc.answer.sheet import NONE, Row, Table, headed
from wraparc.shear_test.alternatives import alternative_laws
from wraparc.shear_test.analysis import ConditionResult
from wraparc.shear_test.standard_values import (
    STANDARD_SLIPS,
    StandardValues,
    Statistic,
    law_at_slips,
    standard_values,
)
from wraparc.units import bare, count, fixed, plus_minus, quantity, unit_of

_DEVIATION = "s: standard deviation between tests."


def standard_tables(condition: ConditionResult, name: str) -> list[Table]:
    """Return static and kinetic friction, and friction at standard slips, by pressure."""
    values = standard_values(condition)
    return [
        _static_table(values, name),
        _slips_table(values, name),
        _law_table(condition, name),
    ]


def _law_table(condition: ConditionResult, name: str) -> Table:
    """The law at the standard slips, with its expanded uncertainty."""
    found = condition.found
    rows = []
    for k, (friction, expanded) in enumerate(zip(*law_at_slips(condition), strict=True)):
        reached = max(
            t.fit.slip_max
            for t, level in zip(found.tests, found.levels, strict=True)
            if level == np.unique(found.levels)[k]
        )
        cells = [
            f"[{text}]" if slip > reached else text
            for slip, text in zip(
                STANDARD_SLIPS, map(plus_minus, friction, np.nan_to_num(expanded)), strict=True
            )
        ]
        rows.append(Row(_pressure(found.level_pressures()[k]), tuple(cells)))
    note = (
        f"First column: pressure [{unit_of('pressure')}]. \u00b1: expanded uncertainty, every part "
        "of the budget included. In brackets: outside the slip of the tests."
    )
    heads = tuple(map(_slip, STANDARD_SLIPS))
    title, some = f"Law at standard slips{name}", {0, len(rows) // 2, len(rows) - 1}
    picked = [Row(rows[k].title, rows[k].values[1::2]) for k in sorted(some)]
    brief = Table(title, tuple(picked), heads[1::2], note)
    return Table(title, tuple(rows), heads, note, "slips", brief)


def _static_table(values: tuple[StandardValues, ...], name: str) -> Table:
    rows = []
    for of in values:
        first, last = of.kinetic_slip
        more = f"still rising at the end of {of.rising} of {of.tests}" if of.rising else ""
        rows.append(
            Row(
                title=_pressure(of.pressure),
                values=(
                    count(of.tests),
                    f"> {fixed(of.static.mean, 3)}" if of.rising == of.tests else _mean(of.static),
                    _deviation(of.static),
                    _mean(of.kinetic),
                    _deviation(of.kinetic),
                    _slips(first, last),
                ),
                note=more,
            )
        )
    note = (
        f"First column: pressure [{unit_of('pressure')}]. Mean of the tests; "
        f"{_DEVIATION} Static: the highest friction of each test. Kinetic: its mean over the slip "
        "stated, from 1.25 peak slips on; - where no test goes that far. After ISO 8295 and ASTM "
        "D1894, but for two things: the peak comes after millimetres of creep, not at the start, "
        "and the lagging shears between belt covers instead of under a sled."
    )
    heads = ("tests", "static", "s", "kinetic", "s", headed("over slip", "length"))
    return Table(f"Static and kinetic friction{name}", tuple(rows), heads, note, "static")


def _slips_table(values: tuple[StandardValues, ...], name: str) -> Table:
    rows = []
    for of in values:
        cells = [count(of.tests)]
        for known, law in zip(of.at_slip, of.beyond, strict=True):
            fewer = f" ({known.count})" if 0 < known.count < of.tests else ""
            cells += [
                f"[{fixed(law, 3)}]" if not known.count else f"{_mean(known)}{fewer}",
                _deviation(known),
            ]
        rows.append(Row(_pressure(of.pressure), tuple(cells)))
    heads = ["tests"]
    for slip in STANDARD_SLIPS:
        heads += [_slip(slip), "s"]
    note = (
        f"First column: pressure [{unit_of('pressure')}]. Mean of the measured "
        f"friction at that slip; {_DEVIATION} In brackets [ ]: no test reached that slip, and the "
        "number is the law, extrapolated. A number in ( ): how many tests reached it, if not all."
    )
    return Table(f"Friction at standard slips{name}", tuple(rows), tuple(heads), note, "measured")


def _pressure(pressure: float) -> str:
    return bare(pressure, "pressure")


def _slip(slip: float) -> str:
    return quantity(slip, "length")


def _slips(first: float, last: float) -> str:
    if math.isnan(first):
        return NONE
    return f"{bare(first, 'length')} to {bare(last, 'length')}"


def _mean(of: Statistic) -> str:
    return fixed(of.mean, 3)


def _deviation(of: Statistic) -> str:
    return bare(of.deviation, "number", 2)


def laws_table(condition: ConditionResult, name: str) -> Table:
    """Other laws for the same curves, the best first."""
    laws = alternative_laws(condition)
    rows = tuple(
        Row(
            law.name,
            (
                count(law.parameters),
                bare(law.remainder, "number", 2),
                fixed(law.criterion - laws[0].criterion, 1),
                count(law.best_of),
            ),
        )
        for law in laws
    )
    note = (
        "Every law fitted to the same readings of every test, with a lash and a noise of its own. "
        "Parameters of a test; root mean square of what is left over; difference of Akaike's "
        "criterion (AICc) to the best law, summed over the tests: 10 and more speak clearly "
        "against a law; tests that the law describes best. The lagging file contains the "
        "integral-log law whatever this table says."
    )
    heads = ("parameters", "remainder", "AICc", f"best of {len(condition.tests)}")
    return Table(f"Laws side by side{name}", rows, heads, note, "laws")
