"""What the keys of a conveyor say twice, or not at all."""

from collections.abc import Collection

from wraparc.errors import Problem

# Two ways to say one thing, and whether one of them is needed.
_EITHER = (
    ("material_mass", "capacity", 'material_mass = "120 kg/m"'),
    ("take_up_tension", "counterweight", 'take_up_tension = "40 kN"'),
    ("length_coefficient", "secondary_resistance", ""),
    ("start_factor", "start_time", ""),
)
_NEED_SPEED = ("capacity", "start_time", "stop_time")


def choices(given: Collection[str]) -> list[Problem]:
    """Return what is said twice or not at all, and what needs the belt speed.

    Parameters
    ----------
    given
        Names of the fields that are given, `speed` among them.
    """
    problems = []
    loads = "loading" in given
    for first, second, example in _EITHER:
        if loads and second == "capacity":
            both = [key for key in (first, second) if key in given]
            message, remedy = "means the same as [[conveyor.loading]]", "Leave one of them out."
            problems += [Problem(key=key, message=message, remedy=remedy) for key in both]
            continue
        if first in given and second in given:
            message = f"means the same as {first}"
            problems.append(Problem(key=second, message=message, remedy="Leave one of them out."))
        elif example != "" and first not in given and second not in given:
            remedy = f"Write {example}, or {second}."
            problems.append(Problem(key=first, message="missing", remedy=remedy, code="missing"))
    for key in _NEED_SPEED:
        if key in given and "speed" not in given:
            remedy = 'Write speed = "3 m/s" in [belt].'
            problems.append(Problem(key=key, message="needs the belt speed", remedy=remedy))
    return problems
