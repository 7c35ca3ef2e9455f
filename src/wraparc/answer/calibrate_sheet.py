"""Calibrations in words and tables."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from wraparc.answer.sheet import Row, Sheet, Table, Verdict, named, percent, quantity
from wraparc.calibrate.calibration import FAR, Calibration, Estimate, Number, Problemset
from wraparc.calibrate.problem import OPEN_ZERO
from wraparc.checks import Level
from wraparc.checks.action import Action
from wraparc.checks.of_arc import COVER_UNKNOWN
from wraparc.glossary import GLOSSARY
from wraparc.units import Dimension, fixed

#: parameter -> title, dimension
_PARAMETERS: dict[str, tuple[str, Dimension]] = {
    "friction": ("Friction, factor on the law", "number"),
    "peak_slip": ("Peak slip, factor on the law", "number"),
    "shear_modulus": ("Shear modulus of the lagging", "pressure"),
    "overrun": ("Entry overrun", "length"),
    "belt_modulus": ("Belt modulus", "force_per_width"),
}
_ERRORS = {
    "speed_zero": "Zero of the speed ratio",
    "entry_tension": "Entry tension T1",
    "exit_tension": "Exit tension T2",
    "effective_tension": "Effective tension T1 - T2",
    "compression": "Compression of the lagging",
    "lagging_shear": "Shear of the lagging",
    "cover_shear": "Shear of the belt cover",
    "torque_offset": "Torque at no load",
    "take_up": "Friction of the take-up",
    "modulus": "Belt modulus",
    "slip_axis": "Slip axis of the law",
    "speed_by_torque": "Speed by torque",
    "readings": "Readings",
}


def _error_title(name: str) -> str:
    """Return what an error is of, and of which record."""
    key, _, record = name.partition(".")
    title = _ERRORS.get(key, name.replace("_", " "))
    return f"{title} ({record})" if record else title


#: Standard deviations beyond which an error is not what was stated of it [-].
_UNLIKELY = 3.0
_MOST_CORRELATED = 0.9
#: Misfit that is no noise any more: of a course over its largest value, of a number over its
#: standard deviation [-].
_FAR_TRACE, _FAR_NUMBER = 0.1, 4.0
#: Part of a standard deviation below which a misfit is what a search leaves [-].
_NOISE = 1e-2
_OTHER = "Check tensions, units and signs, and that the file describes the drive that was measured."


def calibrate_sheet(
    found: Calibration,
    problem: Problemset,
    title: str,
    description: str = "",
    sources: tuple[str, ...] = (),
) -> Sheet:
    """Return the answer of a calibration: estimates, what the data cannot tell, correlations."""
    rows = [_row(e) for e in found.estimates]
    tables = [
        Table(
            "Estimates",
            tuple(rows),
            ("value", "95 % interval", "spread by the data", "expected"),
            "Spread: one standard deviation. Expected: half the 95 % interval that such data "
            "promise before they are fitted. Intervals are from the curvature at the best fit, or "
            "from the profile likelihood where the curvature at the drive file's values disagrees.",
            "estimates",
        ),
        _widths(found),
        _deviations(found, problem),
        _correlations(found),
        _misfits(found, problem),
    ]
    return Sheet(
        title=title or "Calibration",
        subtitle=description,
        verdict=_verdict(found, problem),
        tables=tuple(t for t in tables if t.rows),
        remarks=tuple(_remarks(found)),
        sources=sources,
    )


def _row(e: Estimate) -> Row:
    title, dimension = _PARAMETERS[e.name]
    spread = "none" if math.isinf(e.spread) else percent(e.spread, 2)
    if e.name == "overrun" and math.isfinite(e.spread):
        spread = quantity(e.spread * 1e-4, "length")
    expected = "nothing" if math.isinf(e.expected) else percent(e.expected, 2)
    if e.name == "overrun" and math.isfinite(e.expected):
        expected = quantity(e.expected * 1e-4, "length")
    if e.value is None or e.low is None or e.high is None:
        return Row(title, ("not identified", "-", spread, expected), level=Level.ATTENTION)
    value, low, high = (quantity(v, dimension) for v in (e.value, e.low, e.high))
    note = "from the prior, not from the data" if e.from_prior else ""
    return Row(title, (value, f"{low} to {high}", spread, expected), note=note)


def _verdict(found: Calibration, problem: Problemset) -> Verdict:
    apart, covered = tuple(_apart(found, problem)), tuple(_covered(found, outside=True))
    untold = [e.name for e in found.estimates if e.value is None]
    more = (*apart, *covered, *_mixed_words(found))
    if untold:
        names = ", ".join(n.replace("_", " ") for n in untold)
        return Verdict(
            Level.ATTENTION, f"Not identified: {names}.", more, action=_MORE_DATA, data=_DATA,
            name="calibrate",
        )  # fmt: skip
    count = len(found.estimates)
    text = f"{count} parameter{'s' if count > 1 else ''} identified"
    if count <= _NAMED:
        text += f": {', '.join(_estimate_text(e) for e in found.estimates)}"
    if apart:
        text = f"Drive deviates from {len(apart)} of {found.data} measured values; {text}"
    level = Level.ATTENTION if apart or covered else Level.OK
    action = Action(_OTHER) if apart else Action(_COVER) if covered else None
    return Verdict(level, f"{text}.", more, action=action, data=_DATA, name="calibrate")


#: What a calibration is worth, whatever its inputs.
_DATA = "Inputs assumed: no validation."
_MORE_DATA = Action("Give a prior, fix some parameters, or measure another quantity.")
_COVER = "State slip_includes in the lagging."
#: Parameters that the sentence names, at most, and their words in it.
_NAMED = 2
_WORDS = {
    "friction": "friction factor", "peak_slip": "peak slip factor", "shear_modulus": "G",
    "overrun": "overrun", "belt_modulus": "belt modulus",
}  # fmt: skip


def _estimate_text(estimate: Estimate) -> str:
    """Return a parameter with its value, ``friction factor 0.787``."""
    return f"{_WORDS[estimate.name]} {_row(estimate).values[0]}"


def _apart(found: Calibration, problem: Problemset) -> Iterator[str]:
    """Yield what the best fit leaves of the data that is more than noise."""
    count = len(problem.numbers)
    for n, miss in zip(problem.numbers, found.misfit, strict=False):
        if abs(miss) > _FAR_NUMBER * n.sd:
            yield (
                f"{number_title(n, problem)}: the best fit misses the measured "
                f"{number_text(n, n.value)} by {number_text(n, abs(miss))}. "
                f"{_OTHER}"
            )
    for d in found.deviations:
        if abs(math.log(d.factor)) > _UNLIKELY * d.stated:
            yield (
                f"{_error_title(d.name)}: the best fit moves it by {percent(d.factor - 1.0, 2)}, "
                f"where {percent(d.stated, 2)} is stated as its standard deviation. {_OTHER}"
            )
    for t, miss in zip(problem.traces, found.misfit[count:], strict=True):
        most = float(np.abs(t.value).max())
        if miss > _FAR_TRACE * most:
            yield (
                f"{GLOSSARY[t.quantity].title} along the arc, {t.load_case}: the best fit misses "
                f"it by {named(t.quantity, miss)} in the mean, {percent(miss / most, 2)} "
                f"of its maximum. {_OTHER}"
            )


def _covered(found: Calibration, *, outside: bool) -> Iterator[str]:
    """Yield the estimates with the belt cover in series, beyond their intervals or within."""
    there = [
        f"{e.name.replace('_', ' ')} is {quantity(found.covered[e.name], _PARAMETERS[e.name][1])}"
        for e in found.estimates
        if e.name in found.covered
        and e.low is not None
        and e.high is not None
        and outside is not (e.low <= found.covered[e.name] <= e.high)
    ]
    if there:
        where = ", outside its interval. State slip_includes in the lagging" if outside else ""
        yield f"{COVER_UNKNOWN}: with the cover in series {', '.join(there)}{where}."


def number_title(n: Number, problem: Problemset) -> str:
    """Return what a number is and where it was measured."""
    what = GLOSSARY[n.quantity].title
    if n.apparent:
        what = f"Shaft to belt, {'exit' if n.quantity.startswith('exit') else 'entry'}"
    return f"{what}, {'zero record' if n is problem.zero else n.load_case}"


def number_text(n: Number, value: float) -> str:
    """Return a value of a number in words: what tachometers show is a percentage."""
    if n.apparent:
        return percent(_unless_noise(value, n.sd))
    return named(n.quantity, value)


def _misfit_text(n: Number, miss: float) -> str:
    """Return what the best fit misses a number by; what a search leaves is only bounded."""
    least = _NOISE * n.sd
    return number_text(n, miss) if miss >= least else f"< {number_text(n, least)}"


def _unless_noise(value: float, size: float) -> float:
    """Return a value, 0 where it is none beside a standard deviation: what a search leaves."""
    return value if abs(value) > _NOISE * size else 0.0


def _widths(found: Calibration) -> Table:
    """Shares of the variance of every parameter by what it comes from."""
    told = [e for e in found.estimates if e.parts]
    parts = list(told[0].parts) if told else []
    rows = [Row(_error_title(p), tuple(percent(e.parts[p], 2) for e in told)) for p in parts]
    heads = tuple(e.name.replace("_", " ") for e in told)
    return Table("What the intervals come from, shares of the variance", tuple(rows), heads)


def _deviations(found: Calibration, problem: Problemset) -> Table:
    rows = [
        Row(
            _error_title(d.name),
            (
                "open"
                if d.stated >= OPEN_ZERO and d.name == "speed_zero"
                else _stated(d.name, d.stated, problem),
                percent(_unless_noise(d.factor - 1.0, d.stated), 2),
                percent(d.left, 2),
            ),
        )
        for d in found.deviations
    ]
    note = (
        "Standard deviations, common to all load cases. The zero of the speed ratio contains "
        "the radius of the wheel, the diameter of the pulley and the thickness of the belt: each "
        "shifts every ratio alike, so no record separates them."
    )
    heads = ("stated", "estimated error", "left")
    return Table("Errors of what was measured with", tuple(rows), heads, note)


def _stated(name: str, sd: float, problem: Problemset) -> str:
    """Return a standard deviation, and that it is assumed where it is."""
    is_assumed = name.partition(".")[0] in problem.assumed
    return f"{percent(sd, 2)}, assumed" if is_assumed else percent(sd, 2)


def _mixed_words(found: Calibration) -> Iterator[str]:
    if found.far:
        names = " and ".join(n.replace("_", " ") for n in found.far)
        yield (
            f"The best fit puts {names} more than {FAR:g} times off the drive file: either such "
            "data cannot identify them, or another input of the drive is wrong."
        )
    if found.loose:
        names = " and ".join(n.replace("_", " ") for n in found.loose)
        yield (
            f"The data constrain {names} too loosely: values far from the best fit describe the "
            "data as well once the other parameters are refitted."
        )
    for group in found.mixed:
        words = [_error_title(n).lower() for n in group]
        if len(words) == 1:
            yield f"The data hardly depend on {words[0]}."
        elif words:
            yield (
                f"The data cannot separate {' and '.join(words)}: a change in one is compensated "
                "by the others."
            )


def _correlations(found: Calibration) -> Table:
    names = [e.name.replace("_", " ") for e in found.estimates]
    if len(names) < 2:
        return Table("Correlations", ())
    rows = [
        Row(name, tuple(fixed(float(v), 2, "signed") for v in row))
        for name, row in zip(names, found.correlation.tolist(), strict=True)
    ]
    return Table("Correlations of the estimates", tuple(rows), tuple(names), name="correlations")


def _misfits(found: Calibration, problem: Problemset) -> Table:
    rows = []
    for n, miss in zip(problem.numbers, found.misfit, strict=False):
        rows.append(
            Row(
                number_title(n, problem),
                (number_text(n, n.value), _misfit_text(n, abs(miss))),
            )
        )
    for t, miss in zip(problem.traces, found.misfit[len(problem.numbers) :], strict=True):
        title = f"{GLOSSARY[t.quantity].title} along the arc, {t.load_case}"
        most = named(t.quantity, float(np.abs(t.value).max()))
        rows.append(Row(title, (f"up to {most}", named(t.quantity, miss))))
    return Table("Misfit", tuple(rows), ("measured", "rms misfit"), name="misfit")


def _remarks(found: Calibration) -> Iterator[str]:
    yield from _covered(found, outside=False)
    if found.offset is not None:
        yield (
            "By the zero record, with pulley and wheel as stated, the tension member runs "
            f"{named('pitch_offset', found.offset)} above the lagging surface."
        )
    names = [e.name.replace("_", " ") for e in found.estimates]
    for i in range(len(names)):
        for k in range(i):
            r = float(found.correlation[i, k])
            if abs(r) > _MOST_CORRELATED:
                yield f"{names[k]} and {names[i]} are strongly correlated ({r:+.3f})."
    stated = {d.name for d in found.deviations} | {e.name for e in found.estimates}
    exact = [
        what
        for what, of in (
            ("the tensions", ("entry_tension", "exit_tension", "effective_tension")),
            ("the modulus of the lagging", ("lagging_shear", "shear_modulus")),
        )
        if not stated.intersection(of)
    ]
    if exact:
        yield (
            f"Taken as exact: {' and '.join(exact)}. Their errors enter the intervals where "
            "[errors] states them."
        )
    yield (
        "Calibration makes the model agree with the data it was calibrated to; that agreement is "
        "no validation."
    )
    if any(e.name == "friction" for e in found.estimates):
        yield "Factors scale the whole friction law, equally at every slip and pressure."


def calibrate_document(found: Calibration) -> dict[str, Any]:
    """Return a calibration as plain data [SI] for JSON."""
    return {
        "format": 1,
        "estimates": [
            {
                "name": e.name,
                "value": e.value,
                "low": e.low,
                "high": e.high,
                "spread": e.spread,
                "from_prior": e.from_prior,
                "expected": None if math.isinf(e.expected) else e.expected,
                "parts": dict(e.parts),
            }
            for e in found.estimates
        ],
        "errors": [
            {"name": d.name, "factor": d.factor, "stated": d.stated, "left": d.left}
            for d in found.deviations
        ],
        "pitch_offset": found.offset,
        "with_cover_in_series": dict(found.covered),
        "correlation": found.correlation.tolist(),
        "not_told_apart": [list(group) for group in found.mixed],
        "too_loose": list(found.loose),
        "misfit": list(found.misfit),
        "data": found.data,
    }
