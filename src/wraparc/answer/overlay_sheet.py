"""What was measured of a drive beside its prediction, in words and tables."""

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from wraparc.answer.calibrate_sheet import number_text, number_title
from wraparc.answer.sheet import Row, Sheet, Table, Verdict, named, percent
from wraparc.arc import ArcResult
from wraparc.calibrate.calibration import Number, Problemset
from wraparc.calibrate.fold import Folded
from wraparc.calibrate.problem import Trace, predicted_number
from wraparc.checks import Level, Place
from wraparc.checks.action import Action
from wraparc.checks.of_arc import COVER_UNKNOWN
from wraparc.glossary import GLOSSARY
from wraparc.train.turning import surface_sentence

#: Standard deviations of a number, and share of a course, within which a prediction agrees [-].
_AGREES, _COURSE_AGREES = 2.0, 0.1


class _Comparison(NamedTuple):
    """One measured value with its prediction: words, and the difference over what is allowed."""

    what: str
    predicted: str
    measured: str
    share: float
    excess: float
    load_case: str


def overlay_sheet(
    problem: Problemset,
    folded: tuple[tuple[str, Folded], ...],
    predicted: Mapping[str, tuple[ArcResult, ...]],
    title: str,
) -> Sheet:
    """Return measured values beside the prediction of both methods."""
    rows = []
    for n in problem.numbers:
        if n.tensions is not None:
            continue  # no load case of the drive
        results = predicted[n.load_case]
        values = [predicted_number(r, n) for r in results]
        texts = [number_text(n, v) for v in (n.value, *values)]
        rows.append(Row(number_title(n, problem), tuple(texts)))
    for t in problem.traces:
        at_peak = [float(np.abs(t.value).max())]
        apart = []
        for r in predicted[t.load_case]:
            if not r.status.solved:
                at_peak.append(math.nan)
                apart.append(math.nan)
                continue
            course = getattr(r.profile, t.quantity)
            here = np.interp(t.position, r.profile.position, course)
            at_peak.append(float(np.abs(here).max()))
            apart.append(float(np.sqrt(np.mean((here - t.value) ** 2))))
        name = f"{GLOSSARY[t.quantity].title}, {t.load_case}"
        rows.append(Row(f"{name}: maximum", tuple(named(t.quantity, v) for v in at_peak)))
        texts = ["-", *(named(t.quantity, v) for v in apart)]
        rows.append(Row(f"{name}: rms difference", tuple(texts)))
    heads = ("measured", *(r.method for r in next(iter(predicted.values()), ())))
    tables = [Table("Measured and predicted", tuple(rows), heads, name="predicted")]
    if folded:
        tables.append(_records(folded))
    first = next(iter(predicted.values()), ())
    by_surface = any(n.apparent for n in problem.numbers) and any(
        r.arc.pitch_offset is None for r in first
    )
    covered = any(r.arc.cover_left_out > 0.0 for r in first)
    notes = (
        *((surface_sentence(first[0].arc.diameter),) if by_surface else ()),
        *((f"{COVER_UNKNOWN}: it is left out.",) if covered else ()),
        *(note for _, f in folded for note in f.notes),
        *(
            f"Load case {r.arc.load_case}, {r.method}: {r.status}"
            for results in predicted.values()
            for r in results
            if not r.status.solved
        ),
    )
    return Sheet(
        title=title or "Measured drive",
        verdict=_verdict(problem, predicted),
        tables=tuple(tables),
        remarks=notes,
    )


def _records(folded: tuple[tuple[str, Folded], ...]) -> Table:
    rows = [
        Row(
            case,
            (
                str(f.revolutions),
                named("position", f.entry),
                named("position", f.leaving),
                named("position", f.seen),
            ),
        )
        for case, f in folded
    ]
    heads = ("contact arcs", "entry nip at", "exit nip at", "signals seen over")
    return Table("Records", tuple(rows), heads, name="records")


def _verdict(problem: Problemset, predicted: Mapping[str, tuple[ArcResult, ...]]) -> Verdict | None:
    """Return which measured value the prediction of the main solver is farthest from."""
    unsolved = [case for case, (first, *_) in predicted.items() if not first.status.solved]
    if unsolved:
        text = f"Gross slip predicted, none measured{Place(load_case=unsolved[0]).bracket}."
        return Verdict(Level.ATTENTION, text, action=_CALIBRATE, name="overlay")
    found = [*_numbers(problem, predicted), *_courses(problem, predicted)]
    if not found:
        return None
    worst = max(found, key=lambda one: one.excess)
    predicted_text = f"Predicted {worst.what} {worst.predicted}"
    where = Place(load_case=worst.load_case).bracket
    if worst.excess <= 1.0:
        text = f"{predicted_text} is within the error of the measured {worst.measured}{where}."
        return Verdict(Level.OK, text, name="overlay")
    side = "below" if worst.share < 0.0 else "above"
    by = f"{percent(abs(worst.share))} " if math.isfinite(worst.share) else ""
    text = f"{predicted_text} is {by}{side} the measured {worst.measured}{where}."
    return Verdict(Level.ATTENTION, text, action=_CALIBRATE, name="overlay")


_CALIBRATE = Action("Calibrate the lagging to these data (wraparc calibrate).")


def _numbers(
    problem: Problemset, predicted: Mapping[str, tuple[ArcResult, ...]]
) -> Iterator[_Comparison]:
    for n in problem.numbers:
        if n.tensions is not None:
            continue
        value = predicted_number(predicted[n.load_case][0], n)
        apart = value - n.value
        # what tachometers show may be about nothing: a share of it says nothing
        share = (
            apart / abs(n.value) if n.value and not n.apparent else math.copysign(math.inf, apart)
        )
        texts = number_text(n, value), number_text(n, n.value)
        yield _Comparison(_noun(n), *texts, share, abs(apart) / (_AGREES * n.sd), n.load_case)


def _courses(
    problem: Problemset, predicted: Mapping[str, tuple[ArcResult, ...]]
) -> Iterator[_Comparison]:
    for t in problem.traces:
        most, value = float(np.abs(t.value).max()), _largest(t, predicted[t.load_case][0])
        share = value / most - 1.0
        texts = named(t.quantity, value), named(t.quantity, most)
        what = f"maximum {GLOSSARY[t.quantity].title.lower()}"
        yield _Comparison(what, *texts, share, abs(share) / _COURSE_AGREES, t.load_case)


def _largest(t: Trace, result: ArcResult) -> float:
    course = getattr(result.profile, t.quantity)
    return float(np.abs(np.interp(t.position, result.profile.position, course)).max())


def _noun(n: Number) -> str:
    """Return what a number is within a sentence."""
    if n.apparent:
        return f"shaft-to-belt difference at {n.nip}"
    return "creep" if n.quantity == "exit_creep" else GLOSSARY[n.quantity].title.lower()
