"""The least slack-side tension and the margins to gross slip: sentence, tables, plain data."""

import math
from collections.abc import Iterator
from typing import Any

from wraparc.answer.sheet import NONE, Row, Table, quantity
from wraparc.arc import ArcResult, DriveResult
from wraparc.arc.sliding import SLIDES
from wraparc.checks import RULES, LeastTension, least_tension, margins_of
from wraparc.drive import Drive
from wraparc.train import TrainResult
from wraparc.units import RESULT_DIGITS, Cell, in_units


def least_sentence(result: DriveResult | TrainResult) -> str:
    """Return the minimum slack-side tension in a sentence; nothing where there is none."""
    found = least_tension(result)
    if found is None:
        return ""
    if math.isinf(found.tension):
        return _none(found, result)
    governs = found.governing
    where = ", ".join(part for part in (governs.title, str(governs.place)) if part)
    now = Cell(found.given, "force", form="typed", name="tension")
    return f"Minimum {least_name(result)} {at_least(found.tension)} ({where}); now {now}."


def at_least(tension: float) -> str:
    """Return a least tension so that it holds as it is shown: rounded upwards."""
    return Cell(tension, "force", RESULT_DIGITS, "up", name="tension")


def at_most(tension: float) -> str:
    """Return a largest tension so that it holds as it is shown: rounded down."""
    return Cell(tension, "force", RESULT_DIGITS, "down", name="tension")


def divides_anew(result: DriveResult | TrainResult) -> bool:
    """Return whether another tension divides the load anew, as of pulleys with given speeds."""
    return isinstance(result, TrainResult) and not all(c.case.pulls_given for c in result)


def _none(found: LeastTension, result: DriveResult | TrainResult) -> str:
    governs, top, name = found.governing, found.highest, least_name(result)
    if math.isinf(governs.tension) and governs.name == "design_standard":
        return f"No {name} passes: {governs.title} does not apply{governs.place.bracket}."
    if math.isinf(governs.tension) or top is None:
        return (
            f"No {name} in the tested pressure range meets {RULES[governs.name].what}"
            f"{governs.place.bracket}."
        )
    return (
        f"No {name} passes: {governs.title} needs {at_least(governs.tension)}, "
        f"{top.title} allows {at_most(top.tension)}."
    )


def least_table(result: DriveResult | TrainResult) -> Table | None:
    """Return what each check requires of the slack side; None where nothing is transmitted."""
    found = least_tension(result)
    if found is None:
        return None
    rows, name = [], least_name(result)
    if not math.isinf(found.tension):
        weight = Cell(found.counterweight, "mass", RESULT_DIGITS, "up")
        now = f"now {Cell(found.given, 'force', form='typed', name='tension')}"
        least = at_least(found.tension)
        symbol = "T2_min" if name == "T2" else ""
        rows.append(Row(f"Minimum {name}", (least, "", now), symbol, name="minimum_tension"))
        status = "if the take-up is a weight"
        rows.append(Row("Counterweight", (weight, "", status), name="counterweight"))
    for figure in sorted(found.figures, key=lambda f: (not f.at_least, -f.tension)):
        text = at_least(figure.tension) if figure.at_least else f"max {at_most(figure.tension)}"
        text = "none" if math.isinf(figure.tension) else text
        counts = figure in found.required or not figure.at_least
        status = "" if counts else "not counted: no tension passes"
        status = "governs" if figure is found.governing else status
        rows.append(Row(figure.title, (text, str(figure.place), status), name=figure.name))
    heads = (f"Minimum {name}", "Place", "Status")
    note = " ".join(_conditions(result))
    return Table(f"Minimum {name} by check", tuple(rows), heads, note, "least")


def _conditions(result: DriveResult | TrainResult) -> Iterator[str]:
    """Yield under what conditions the minimum tension is one."""
    if divides_anew(result):
        yield "Computed at the load shares of now: another tension divides the load anew."
    described = result.drive if isinstance(result, DriveResult) else result.train
    if any(pulley.across for pulley in described.pulleys):
        yield "Computed for even pulleys."


def least_name(result: DriveResult | TrainResult) -> str:
    """Return the name of the tension at the take-up, after "Minimum"."""
    one = result.drive_result() if isinstance(result, TrainResult) else result
    return tension_at(one.drive.take_up_place) if one.drive.take_up_place else slack_name(one.drive)


def slack_name(drive: Drive) -> str:
    """Return the name of the tension of the slack side behind the drives."""
    case = drive.load_case()
    driving = drive.slack_end(case) == case.tensions[drive.pulleys[-1].name].exit
    return "T2" if driving else "slack-side tension T1"


def tension_at(place: str) -> str:
    """Return the name of the tension at a `Drive.take_up_place`."""
    return f"tension {place}" if place else "T2"


def margins_table(result: DriveResult, arc: ArcResult) -> Table | None:
    """Return how much more pull an arc could take until it slides, by what the take-up holds."""
    if not arc.status.solved or abs(arc.arc.effective_tension) <= 1e-6 * arc.arc.entry_tension:
        return None
    if math.isnan(arc.capacities.gross_slip_capacity):
        return None
    found, take_up = margins_of(result, arc), result.drive.criteria.take_up
    assumed = "" if take_up.kind else ", assumed"
    rows, after = [], take_up.after
    where = f"Tension behind {after}" if after else "T2"
    for name, title, value, own in (
        (
            "constant_slack", f"{where} constant (gravity take-up, winch)",
            found.slack_held, not take_up.fixed,
        ),
        ("constant_sum", "T1 + T2 constant (fixed take-up)", found.both_held, take_up.fixed),
        ("constant_tight", "T1 constant", found.tight_held, False),
    ):  # fmt: skip
        text = "none" if math.isinf(value) else f"{quantity(value, 'number')} times Te"
        rows.append(Row(title, (text,), note=f"this drive{assumed}" if own else "", name=name))
    slides = quantity(SLIDES, "length")
    note = (
        f"Te at gross slip: a creep of {slides}, the end of the tested slip or the whole friction, "
        "whichever comes first."
    )
    return Table("Gross-slip safety", tuple(rows), note=note, name="margins")


def least_data(result: DriveResult | TrainResult) -> dict[str, Any] | None:
    """Return the least slack-side tension as plain data [N, kg]; None where there is none."""
    found = least_tension(result)
    if found is None:
        return None
    return {
        "tension": found.tension,
        "given": found.given,
        "governing": found.governing.name,
        "counterweight": found.counterweight,
        "level": found.level.value,
        "figures": [
            {
                "name": f.name,
                "title": f.title,
                "tension": f.tension,
                "at_least": f.at_least,
                "binding": f.binding,
                "pulley": f.place.pulley,
                "load_case": f.place.load_case,
            }
            for f in found.figures
        ],
        "sentence": in_units(least_sentence(result)),
    }


def shown_least(result: DriveResult | TrainResult) -> str:
    """Return the least slack-side tension with its unit, or that there is none."""
    found = least_tension(result)
    return (
        NONE if found is None else "none" if math.isinf(found.tension) else at_least(found.tension)
    )
