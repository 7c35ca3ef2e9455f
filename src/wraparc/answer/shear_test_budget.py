"""The budget of uncertainty of a fitted law, as a table."""

import numpy as np

from wraparc.answer.shear_test_numbers import rig_compliance
from wraparc.answer.sheet import NONE, Row, Table, percent, quantity
from wraparc.shear_test.analysis import ConditionResult
from wraparc.shear_test.budget import Common
from wraparc.units import GIVEN_DIGITS

_FROM = {
    "repeatability": "from the readings",
    "scatter between samples": "from the repeats, or the distance of the curves from the law",
    "form of the law": "from forms that fit as well, and what repeats show to be missing",
}


def budget_table(condition: ConditionResult, name: str) -> Table | None:
    """Return the budget at the middle of the tested pressures; None for a single pressure."""
    fit = condition.fit
    if fit is None:
        return None
    budget = fit.budget(condition.found.points)
    middle = len(budget.pressure) // 2
    combined = budget.combined[middle]
    rows = [
        Row(part, _values(each[middle], combined), note=_origin(part, fit.common))
        for part, each in budget.parts.items()
        if each[middle].any()
    ]
    rows += [
        Row("combined", _values(combined, combined), note="root of the sum of squares"),
        Row(
            f"expanded, k = {budget.coverage_factor:.3g}",
            _values(budget.expanded[middle], None),
            note="95 % interval, to either side",
        ),
    ]
    none = [part for part, each in budget.parts.items() if not each[middle].any()]
    note = (
        f"At {quantity(budget.pressure[middle], 'pressure', GIVEN_DIGITS)}. Standard "
        "uncertainties of peak friction and peak slip, relative, and their shares of the variance; "
        "after the GUM (JCGM 100). Errors of what was measured with are common to all tests: "
        "repeats do not lessen them."
    )
    note += f" Nothing is counted for: {', '.join(none)}." if none else ""
    heads = ("peak friction", "share", "peak slip", "share")
    return Table(f"Budget of uncertainty{name}", tuple(rows), heads, note, "budget")


def _values(part: np.ndarray, combined: np.ndarray | None) -> tuple[str, ...]:
    """Friction and its share, slip and its share."""
    cells = []
    for k in (1, 0):
        cells.append(percent(part[k], 2) if part[k] > 0.0 else NONE)
        share = 0.0 if combined is None else float(part[k] / combined[k]) ** 2
        cells.append(percent(share, 2) if share >= 0.005 else NONE)
    return tuple(cells)


def _origin(part: str, common: Common | None) -> str:
    if part in _FROM or common is None:
        return _FROM[part]
    of = common.limits
    stated = "as stated" if of.stated else "assumed: the plan says nothing"
    if part.endswith("off the figure"):
        return "error of a point, a share of full scale"
    if part == "zero of the force":
        return f"at most {quantity(of.zero, 'force')}, {stated}"
    if part == "compliance of the rig":
        stated = "as stated" if of.compliance is not None else "assumed: the plan says nothing"
        return f"at most {rig_compliance(common.compliance)}, {stated}"
    if part.startswith("modulus"):
        error = of.shear_modulus if part.endswith("sample") else of.cover_shear_modulus
        stated = "as stated" if error is not None else "assumed: 5 Shore A"
        return f"at most {100.0 * of.modulus_error(error):.3g} %, {stated}"
    relative = {
        "pulling force": of.force, "normal force": of.normal_force, "sample area": of.area,
        "travel": of.travel, "temperature": of.temperature,
    }[part]  # fmt: skip
    return f"at most {100.0 * relative:.3g} %, {stated}"
