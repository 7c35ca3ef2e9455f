"""Which value of an input gives a wanted result: every one in a range, by search."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from wraparc.arc import ArcResult, Distributed, DriveResult, Method, WrapArc
from wraparc.drive import Limit
from wraparc.errors import InputError, input_error, name_remedy, placed, shown
from wraparc.glossary import GLOSSARY
from wraparc.schema.kinds import Quantity
from wraparc.schema.overrides import parse_path, put_over
from wraparc.schema.quantity_text import quantity_text
from wraparc.schema.source import Document
from wraparc.study.fields import SCALING, canonical, kind_of
from wraparc.study.parameter_study import CAPACITY_OUTPUTS, OUTPUTS
from wraparc.train.file import any_drive_from_document, drive_or_train_from_document
from wraparc.train.keys import TRAIN_FILE
from wraparc.train.whole import Whole, by_pulley, solved
from wraparc.units import Dimension, parse_quantity

#: Values tried over the range before any is searched for between two of them.
POINTS = 49
#: The range is from the present value over this factor to the present value times it.
REACH = 3.0
#: Found values are met to this part of themselves.
PRECISE = 1e-10
_MOST_STEPS = 80
#: A result that jumps over the wanted value never has it: how near it must come, in its own scale.
_NEAR = 1e-6
#: What can be wanted.
RESULTS = (
    *(name for name in OUTPUTS if name in GLOSSARY),
    "peak_shear_angle",
    "mean_friction",
    "creep_limit_capacity",
    "equivalent_friction",
    "wear_rate",
)


@dataclass(frozen=True, kw_only=True)
class Goal:
    """What is sought.

    Attributes
    ----------
    field
        Key path of the input, as for ``--set``.
    result
        Name of the result in the glossary.
    value
        Its wanted value, as text with its unit.
    pulley, load_case
        Of the result; the first where empty.
    least, most
        Ends of the range of the input, as text; by the present value where empty.
    now
        The present value of an input that the document leaves to a preset, as text.
    """

    field: str
    result: str
    value: str
    pulley: str = ""
    load_case: str = ""
    least: str = ""
    most: str = ""
    now: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Sought:
    """What was found.

    Attributes
    ----------
    field, dimension
        Key path of the input, and what it measures.
    result, wanted
        Name of the result and its wanted value [SI].
    pulley, load_case
        Of the result.
    now, result_now
        The input and the result as they are [SI]; nan where there is none.
    values
        Values of the input that give it, the nearest to the present one first [SI].
    wholes
        The whole drive solved with each, as every door solves it.
    tried, results
        Values that were tried over the range and what they give [SI]; nan where nothing.
    """

    field: str
    dimension: Dimension
    result: str
    wanted: float
    pulley: str
    load_case: str
    now: float
    result_now: float
    values: tuple[float, ...]
    wholes: tuple[Whole, ...]
    tried: tuple[float, ...]
    results: tuple[float, ...]

    @cached_property
    def drives(self) -> tuple[DriveResult, ...]:
        """The same pulley by pulley."""
        return tuple(map(by_pulley, self.wholes))


def seek(document: Document, goal: Goal, *, method: Method | None = None, **where: Any) -> Sought:
    """Return every value of an input in a range that gives a wanted result.

    The range is tried at some fifty values in equal ratios; between two with the wanted one
    between them it is searched by false position (Illinois) to 1e-10 of the value. Two values
    nearer to each other than a step of the range are missed.

    Parameters
    ----------
    document
        Tables of a drive file.
    goal
        What is sought.
    method
        What solves; the main solver if left out.
    **where
        ``file``, ``folder`` and ``allow_paths``, as for `any_drive_from_document`.

    Raises
    ------
    InputError
        If the input is no quantity, the result unknown, or the document wrong as it is.
    """
    kind = _kind(goal.field, document)
    dimension = _result_dimension(goal.result)
    with placed("value"):
        wanted = parse_quantity(goal.value, dimension)
    drive = any_drive_from_document(document, **where)
    with placed("pulley"):
        pulley = drive.pulley(goal.pulley or None).name
    with placed("load_case"):
        case = drive.load_case(goal.load_case or None).name
    now = _now(document, goal, kind.dimension)
    ends = _range(goal, now, kind)
    solver = method or Distributed(capacities=goal.result in CAPACITY_OUTPUTS)

    def arc_at(value: float) -> ArcResult | None:
        try:
            made = any_drive_from_document(_put(document, goal.field, value, kind), **where)
        except InputError:
            return None  # what no drive can have lies in the range
        return solver.solve(WrapArc.of(made, made.pulley(pulley), made.load_case(case)))

    def result_at(value: float) -> float:
        found = arc_at(value)
        usable = found is not None and found.status.solved
        return found.scalar(goal.result) if found is not None and usable else math.nan

    tried = _tried(*ends, now)
    results = [result_at(value) for value in tried]
    values = sorted(_roots(result_at, tried, results, wanted), key=lambda v: abs(v - now))
    return Sought(
        field=goal.field,
        dimension=kind.dimension,
        result=goal.result,
        wanted=wanted,
        pulley=pulley,
        load_case=case,
        now=now,
        result_now=result_at(now) if math.isfinite(now) else math.nan,
        values=tuple(values),
        wholes=tuple(_whole(_put(document, goal.field, v, kind), method, where) for v in values),
        tried=tuple(tried),
        results=tuple(results),
    )


def _whole(document: Document, method: Method | None, where: dict[str, Any]) -> Whole:
    return solved(drive_or_train_from_document(document, **where), method)


def _kind(field: str, document: Document) -> Quantity:
    """Return what may stand at a key path: a quantity that a drive file has."""
    with placed("field"):
        steps = canonical(parse_path(field), document)
        kind = kind_of(steps)
    of_study = len(steps) == 4 and steps[3] in SCALING
    if isinstance(kind, Quantity) and not of_study:
        return kind
    message = "is no quantity of a drive file"
    remedy = "Name one, such as pulley.head.wrap_angle."
    raise input_error(key="field", value=shown(field), message=message, remedy=remedy)


def _result_dimension(name: str) -> Dimension:
    if name in RESULTS:
        return GLOSSARY[name].dimension
    raise input_error(
        key="result",
        value=shown(name),
        message="no result of a pulley",
        remedy=name_remedy(name, RESULTS),
    )


def _now(document: Document, goal: Goal, dimension: Dimension) -> float:
    """Return the present value of the input, nan where there is none."""
    node: Any = document
    for step in canonical(parse_path(goal.field), document):
        if isinstance(node, list):
            node = next((row for row in node if row.get("name") == step), None)
        else:
            node = node.get(step) if isinstance(node, dict) else None
    with placed("now"):
        text = goal.now if node is None else node
        return parse_quantity(text, dimension) if text != "" else math.nan


def _range(goal: Goal, now: float, kind: Quantity) -> tuple[float, float]:
    """Return the ends of the range within what the input may be."""
    about = sorted((now / REACH, now * REACH)) if math.isfinite(now) else (math.nan, math.nan)
    ends = []
    for key, text, otherwise in (("least", goal.least, about[0]), ("most", goal.most, about[1])):
        with placed(key):
            ends.append(parse_quantity(text, kind.dimension) if text else otherwise)
    limit = kind.limit or Limit(kind.dimension, -math.inf)
    least, most = max(ends[0], limit.least), min(ends[1], limit.most)
    if least < most:
        return least, most
    message = "has no value to start from" if math.isnan(sum(ends)) else "is an empty range"
    remedy = "Give both ends, the smaller first."
    raise input_error(key="field", value=shown(goal.field), message=message, remedy=remedy)


def _tried(least: float, most: float, now: float) -> list[float]:
    even = least <= 0.0
    made = (np.linspace if even else np.geomspace)(least, most, POINTS).tolist()
    inside = [now] if least < now < most else []
    return sorted({*made, *inside})


def _put(document: Document, field: str, value: float, kind: Quantity) -> Document:
    number = kind.dimension == "number"
    text: object = value if number else quantity_text(value, kind.dimension)
    return put_over(document, {field: text}, TRAIN_FILE)


def _roots(
    result_at: Callable[[float], float],
    tried: Sequence[float],
    results: Sequence[float],
    wanted: float,
) -> Iterator[float]:
    """Yield the values at which a result is the wanted one."""
    over = [r - wanted for r in results]
    yield from (value for value, o in zip(tried, over, strict=True) if o == 0.0)
    for (a, fa), (b, fb) in zip(
        zip(tried, over, strict=True), zip(tried[1:], over[1:], strict=True), strict=False
    ):
        if fa * fb < 0.0:
            value, left = _illinois(lambda v: result_at(v) - wanted, a, fa, b, fb)
            if abs(left) <= _NEAR * max(abs(wanted), abs(fa), abs(fb)):
                yield value


def _illinois(
    of: Callable[[float], float], a: float, fa: float, b: float, fb: float
) -> tuple[float, float]:
    """Return where a function is zero between two values of other signs, and what it is there."""
    for _ in range(_MOST_STEPS):
        c = (a * fb - b * fa) / (fb - fa)
        fc = of(c)
        if fc == 0.0 or math.isnan(fc) or abs(b - a) <= PRECISE * abs(c):
            return c, fc
        if fc * fb < 0.0:
            a, fa = b, fb
        else:
            fa *= 0.5
        if abs(c - b) <= PRECISE * abs(c):
            return c, fc
        b, fb = c, fc
    return b, fb
