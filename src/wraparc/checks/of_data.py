"""Checks of what the numbers rest on: tests, fits, conditions that were scaled, weak data."""

from __future__ import annotations

from collections.abc import Iterator

from wraparc.checks.check import Check, Level, Place, escaped
from wraparc.checks.rule import Rule, Spot, origin
from wraparc.drive import Drive, Lagging, Pulley
from wraparc.drive.belt_mass import usual_mass
from wraparc.drive.changes import WORN
from wraparc.drive.conditions import SCALED
from wraparc.drive.pitch import centrifugal_force, covered
from wraparc.provenance import Kind, Provenance


def _condition(of: Spot) -> Iterator[Check]:
    """Ask for attention where a law stands for a surface that it was not tested on."""
    lagging = of.pulley.lagging
    if SCALED in lagging.sources:
        grounds, _ = law_words(lagging)
        law = "one without tests" if "untested" in grounds else "a tested one"
        law = "an illustrative one" if "illustrative" in grounds else law
        says = f"its law is {law} scaled as a whole ({lagging.notes[-1]})"
        yield _untested(of, lagging.condition, SCALED, says)
    if WORN in lagging.sources:
        says = "its law is that of before, and what wear takes off the friction is not known"
        yield _untested(of, WORN, WORN, says)


def _untested(of: Spot, state: str, part: str, says: str) -> Check:
    lagging = of.pulley.lagging
    return Check(
        name=CONDITION.name,
        title=f"Friction of {lagging.name}, {state}",
        level=CONDITION.missed,
        place=of.place,
        source=origin(lagging.sources[part]),
        short=f"not tested {state}",
        says=escaped(f"Lagging {lagging.name} was not tested {state}: {says}."),
        remedy=f"Test the lagging {escaped(state)}.",
        binding=False,
    )


CONDITION = Rule(
    "condition", "friction that was not tested in the condition", binding=False, asked=_condition
)


def _fit(of: Spot) -> Iterator[Check]:
    """Ask for attention where the fit of a law left word that it does not describe its tests."""
    lagging = of.pulley.lagging
    if lagging.fit is None or not lagging.fit.misfit:
        return
    first, *more = lagging.fit.misfit
    others = f" (and {len(more)} more of its lagging file)" if more else ""
    yield Check(
        name=FIT.name,
        title=f"Friction of {lagging.name}, fit to its tests",
        level=FIT.missed,
        place=of.place,
        source=origin(lagging.sources.get("law", lagging.provenance)),
        short="does not fit its tests",
        says=escaped(
            f"The friction law of lagging {lagging.name} does not describe its tests: "
            f"{first.rstrip('.')}{others}.{_accepted(lagging.fit.misfit_accepted)}"
        ),
        remedy="Mend or repeat those tests and fit again.",
        binding=False,
    )


FIT = Rule("fit", "friction that does not fit its tests", binding=False, asked=_fit)
OF_LAW = (CONDITION, FIT)


def _accepted(reason: str) -> str:
    return f" The laboratory wrote it nevertheless: {reason.rstrip('.')}." if reason else ""


def data(drive: Drive, pulley: Pulley) -> Check:
    """Say on what data the answer for a pulley stands; the weakest decides."""
    lagging = pulley.lagging
    found: dict[str, list[str]] = {}
    for kind, what in weak_sources(drive, pulley):
        found.setdefault(kind, []).append(what)
    grounds, words = law_words(lagging)
    words += [
        f"{kind.capitalize()}: {', '.join(dict.fromkeys(found[kind]))}."
        for kind in WEAK_KINDS
        if kind in found
    ]
    worst = next((word for kind, word in GROUNDS.items() if kind in (*grounds, *found)), "")
    return Check(
        name="data",
        title="Data that the answer stands on",
        level=Level.OK,
        place=Place(pulley.name),
        short=worst,
        says=escaped(" ".join(words)),
        binding=False,
    )


#: Part of the slack-side tension from which an unknown m v^2 is told [-].
LEAST_FLUNG = 0.02


def belt_mass(drive: Drive) -> Iterator[Check]:
    """Say how large m v^2 of a belt is whose mass is not known, by the usual mass of its kind.

    Where it may be more than 2 % of the slack-side tension; nothing is computed with it.
    """
    belt = drive.belt
    if belt.mass is not None or belt.speed is None:
        return
    tensions = [
        (min(of.entry, of.exit), name, case.name)
        for case in drive.load_cases
        for name, of in case.tensions.items()
    ]
    slack, pulley, case = min(tensions, key=lambda of: of[0])
    least, most = (centrifugal_force(mass, belt.speed) for mass in usual_mass(belt))
    if most <= LEAST_FLUNG * slack:
        return
    place = Place(pulley, case)
    yield Check(
        name="belt_mass",
        title="Mass of the belt",
        level=Level.OK,
        place=place,
        source="carcasses of the catalogue and usual covers",
        says="Belt mass missing: m v2 {least} to {most} (estimated), up to {share} % of T2 "
        f"({escaped(pulley)}, {escaped(case)}).",
        more={
            "least": (least, "force"),
            "most": (most, "force"),
            "share": (100.0 * most / slack, "number"),
        },
        binding=False,
    )


def law_words(lagging: Lagging) -> tuple[list[str], list[str]]:
    """Return on what grounds the friction of a lagging stands, and the sentences about them."""
    law, friction = str(lagging.source_of("law").kind), f"The friction of {lagging.name} is"
    words = [f"{friction} {_LAWS[law]}."] if law in _LAWS else []
    untested = lagging.law.tested is None
    words += [f"{friction} given without tests."] if untested else []
    return [law, *(["untested"] if untested else [])], words


def weak_sources(drive: Drive, pulley: Pulley) -> Iterator[tuple[str, str]]:
    """Yield each number that is illustrative, calibrated or estimated, with its kind."""
    lagging, belt = pulley.lagging, drive.belt
    owners = (
        (lagging.name, {k: v for k, v in lagging.sources.items() if k != "law"}),
        ("the belt", belt.sources),
        (f"pulley {pulley.name}", pulley.sources),
    )
    told = [(f"{k.replace('_', ' ')} of {owner}", v) for owner, of in owners for k, v in of.items()]
    if pulley.across is not None and belt.in_plane_shear_stiffness is None:
        yield "estimated", "in-plane shear stiffness of the belt"
    if covered(belt) and belt.cover_shear_modulus is None:
        yield "estimated", "cover shear modulus of the belt"
    for what, source in (*told, ("the belt", belt.provenance)):
        yield from ((kind, what) for kind in weaknesses(source))


def weaknesses(source: Provenance) -> Iterator[str]:
    """Yield in what ways a number from a source is weak."""
    if source.note.startswith("estimated"):
        yield "estimated"
    if source.kind in (Kind.ILLUSTRATIVE, Kind.CALIBRATED):
        yield str(source.kind)


#: In the order in which they are told.
WEAK_KINDS = ("illustrative", "calibrated", "estimated")
#: What the answer then stands on, the weakest first.
GROUNDS = {
    "illustrative": "on illustrative data",
    "untested": "on friction without tests",
    "estimated": "on estimated data",
    "calibrated": "on calibrated data",
}
_LAWS = {
    "illustrative": "illustrative: it describes no real product",
    "calibrated": "calibrated: it was fitted to a known result",
}
