"""The least slack-side tension and the margins to gross slip: sentence, tables, plain data."""

import math
from typing import Any

from wraparc.answer.sheet import NONE, Row, Table, named, quantity
from wraparc.arc import ArcResult, DriveResult
from wraparc.arc.sliding import SLIDES
from wraparc.checks import RULES, LeastTension, least_tension, margins_of
from wraparc.train import TrainResult
from wraparc.units import RESULT_DIGITS, Cell, in_units


def least_sentence(result: DriveResult | TrainResult) -> str:
    """Return the least slack-side tension in a sentence; nothing where there is none to tell."""
    found = least_tension(result)
    if found is None:
        return ""
    least, given = at_least(found.tension), named("tension", found.given)
    governs = found.governing
    why = RULES[governs.name].what
    if math.isinf(found.tension):
        return _none(found, result)
    what = least_name(result)
    as_now = ", the load divided as it is," if divides_anew(result) else ""
    described = result.drive if isinstance(result, DriveResult) else result.train
    if any(pulley.across for pulley in described.pulleys):
        as_now += ", were the pulley even,"
    text = (
        f"The least {what} with which every check that it helps passes{as_now} is {least}, set by "
        f"{why} ({governs.place}); given {given}"
    )
    standard = found.standard
    if standard is not None and found.tension < standard.tension * (1.0 - 1e-9):
        asked = at_least(standard.tension)
        text += f"; that is below the {asked} that {standard.title} asks for"
    return f"{text}."


def at_least(tension: float) -> str:
    """Return a least tension so that it holds as it is shown: rounded upwards."""
    return Cell(tension, "force", RESULT_DIGITS, "up", name="tension")


def at_most(tension: float) -> str:
    """Return a largest tension so that it holds as it is shown: rounded down."""
    return Cell(tension, "force", RESULT_DIGITS, "down", name="tension")


def divides_anew(result: DriveResult | TrainResult) -> bool:
    """Whether another tension divides the load anew, as drums do that turn as given."""
    return isinstance(result, TrainResult) and not all(c.case.pulls_given for c in result)


def _none(found: LeastTension, result: DriveResult | TrainResult) -> str:
    governs, top = found.governing, found.highest
    if math.isinf(governs.tension) and governs.name == "design_standard":
        return (
            f"No {least_name(result)} keeps every binding check: {governs.title} cannot be applied "
            f"({governs.place})."
        )
    if math.isinf(governs.tension) or top is None:
        return (
            f"No {least_name(result)} with wrap pressures in the tested range keeps "
            f"{RULES[governs.name].what} ({governs.place})."
        )
    asked, most = at_least(governs.tension), at_most(top.tension)
    return (
        f"No {least_name(result)} keeps every binding check: "
        f"{RULES[governs.name].what} asks for {asked} "
        f"({governs.place}), and {RULES[top.name].what} allows {most} ({top.place})."
    )


def least_table(result: DriveResult | TrainResult) -> Table | None:
    """Return what each check asks of the slack side; None where nothing is pulled."""
    found = least_tension(result)
    if found is None:
        return None
    rows, place = [], _place(result)
    if not math.isinf(found.tension):
        weight = Cell(found.counterweight, "mass", RESULT_DIGITS, "up")
        given = f"given {named('tension', found.given)}"
        least = at_least(found.tension)
        symbol = "" if place else "T2_min"
        rows.append(Row(f"Least {least_name(result)}", (least,), symbol, given))
        rows.append(Row("Counterweight for it", (weight,), "", "if the take-up is a weight"))
    for figure in sorted(found.figures, key=lambda f: (not f.at_least, -f.tension)):
        bound = "at least" if figure.at_least else "at most"
        shown = at_least if figure.at_least else at_most
        text = "none" if math.isinf(figure.tension) else shown(figure.tension)
        counts = figure in found.required or not figure.at_least
        note = "" if counts else "not counted, as no tension keeps all"
        note = "governs" if figure is found.governing else note
        note = ", ".join(part for part in (note, str(figure.place)) if part)
        rows.append(Row(f"{figure.title}, {bound}", (text,), "", note))
    where = place or "of the slack side behind the drives"
    note = f"Tension {where} with which each check is kept, every pulley pulling as it does."
    return Table(f"Least {least_name(result)}", tuple(rows), note=note, name="least")


def _place(result: DriveResult | TrainResult) -> str:
    one = result.drive_result() if isinstance(result, TrainResult) else result
    return one.drive.take_up_place


def least_name(result: DriveResult | TrainResult) -> str:
    """Return the name of the tension that the take-up holds, after "Least"."""
    return tension_at(_place(result))


def tension_at(place: str) -> str:
    """Return the name of the tension at a `Drive.take_up_place`."""
    return f"tension {place}" if place else "slack-side tension"


def margins_table(result: DriveResult, arc: ArcResult) -> Table | None:
    """Return how much more pull an arc could take until it slides, by what the take-up holds."""
    if not arc.status.solved or abs(arc.arc.effective_tension) <= 1e-6 * arc.arc.entry_tension:
        return None
    if math.isnan(arc.capacities.gross_slip_capacity):
        return None
    found, take_up = margins_of(result, arc), result.drive.criteria.take_up
    said = "" if take_up.kind else ", as no take-up is given"
    rows, after = [], take_up.after
    where = f"Tension behind pulley {after}" if after else "Slack side"
    for title, value, own in (
        (f"{where} held (gravity take-up, winch)", found.slack_held, not take_up.fixed),
        ("Sum of both sides held (fixed take-up)", found.both_held, take_up.fixed),
        ("Tight side held", found.tight_held, False),
    ):
        text = "never" if math.isinf(value) else f"{quantity(value, 'number')} times the pull"
        rows.append(Row(title, (text,), note=f"this drive{said}" if own else ""))
    slides = quantity(SLIDES, "length")
    note = (
        f"Pull at which the belt slides: a creep of {slides}, the end of the tested slip or the "
        "largest friction, whichever comes first."
    )
    return Table("Margin to gross slip", tuple(rows), note=note, name="margins")


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
