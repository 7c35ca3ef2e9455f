"""How the modulus of a belt was measured, and what that changes.

A drive pulley sees a run-in belt whose tension changes within a second: its elastic modulus. That
is what a test by load cycles measures (ISO 9856: 200 cycles at 0.1 Hz between 2 and 10 % of the
strength, elastic elongation alone). A first stretch (ISO 283, DIN 22102: elongation at 10 % of the
strength) has the permanent elongation in it too, and gives less.
"""

from __future__ import annotations

from typing import NamedTuple

from wraparc.errors import Problem, format_names, shown

#: Tests of a modulus: by load cycles, and by a first stretch.
DYNAMIC, STATIC = "dynamic", "static"
MODULUS_TESTS = (DYNAMIC, STATIC)


class ModulusRatio(NamedTuple):
    """The elastic modulus of a belt over that of its first stretch.

    Attributes
    ----------
    least, most
        Its range [-].
    source
        Where it came from.
    """

    least: float
    most: float
    source: str


#: By carcass, ``1 + M e / k``: permanent elongation e, elastic elongation k/M at the rating k.
MODULUS_RATIOS = {
    "fabric": ModulusRatio(
        1.6,
        2.0,
        "permanent and elastic elongation at the rating of 16 fabric belts (Goodyear EP conveyor "
        "belt catalogue, 2012, p. 15 and 21)",
    ),
    "steel cord": ModulusRatio(
        1.5,
        2.2,
        "permanent elongation of 0.1 to 0.25 % (conveyorbeltguide.com, Testing), elastic "
        "elongation at the rating (Goodyear EP conveyor belt catalogue, 2012)",
    ),
}


def find_ratio(kind: str) -> ModulusRatio:
    """Return the elastic modulus over the static one of a carcass; what is not known is fabric."""
    return MODULUS_RATIOS.get(kind, MODULUS_RATIOS["fabric"])


def measurement_problems(test: str, loads: tuple[float, float] | None) -> list[Problem]:
    """Return what is wrong with the description of a test."""
    problems = []
    if test not in ("", *MODULUS_TESTS):
        message = f"must be one of {format_names(MODULUS_TESTS)}"
        problems.append(Problem(key="modulus_test", value=shown(test), message=message))
    if loads is not None and not 0.0 <= loads[0] < loads[1] <= 1.0:
        message = "must be the lowest and the highest load, from 0 to 100 % of the strength"
        percent = [f"{100.0 * load:g} %" for load in loads]
        remedy = 'Write for example ["2 %", "10 %"].'
        problems.append(
            Problem(key="modulus_loads", value=shown(percent), message=message, remedy=remedy)
        )
    return problems


def format_test(kind: str, test: str, loads: tuple[float, float] | None) -> str:
    """Return how a modulus was measured, in words."""
    if not test:
        return "static or dynamic: not stated"
    range_text = (
        "" if loads is None else (f", {100.0 * loads[0]:g} to {100.0 * loads[1]:g} % of strength")
    )
    if test == DYNAMIC:
        return f"dynamic{range_text}"
    ratio = find_ratio(kind)
    return f"static{range_text}: dynamic {ratio.least:g} to {ratio.most:g} times as much"
