"""Checks of what the numbers rest on: tests, fits, conditions that were scaled, weak data."""

from __future__ import annotations

from collections.abc import Iterator

from wraparc.checks.check import Amount, Check, Level, Place, escaped
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
        factor = lagging.scaled_by
        used = "dry friction scaled"
        if factor is not None:  # the name of a condition may have several words
            several = " " in lagging.condition
            used = f"dry friction times {factor:.3g}{'' if several else ' used'}"
        full = f"Source of the factor: {origin(lagging.sources[SCALED])}."
        yield _untested(of, lagging.condition, SCALED, used, full)
    if WORN in lagging.sources:
        yield _untested(of, WORN, WORN, "unworn friction used", "")


def _untested(of: Spot, state: str, part: str, used: str, full: str) -> Check:
    lagging = of.pulley.lagging
    return Check(
        name=CONDITION.name,
        title=f"Friction, {state}",
        noun=f"friction, {state}",
        level=CONDITION.missed,
        place=of.place,
        source=origin(lagging.sources[part]),
        label=f"not tested {state}",
        headline=escaped(f"{lagging.name} not tested {state}: {used}"),
        action=f"Test lagging {escaped(lagging.name)} {escaped(state)}.",
        full=escaped(full),
        binding=False,
    )


CONDITION = Rule(
    "condition",
    "friction that was not tested in the condition",
    binding=False,
    find_checks=_condition,
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
        title="Friction fit",
        noun="friction fit",
        level=FIT.missed,
        place=of.place,
        source=origin(lagging.sources.get("law", lagging.provenance)),
        label="friction fit",
        headline=escaped(f"Friction law of {lagging.name} deviates from its tests"),
        action="Repeat these tests and refit (wraparc fit).",
        full=escaped(f"{first.rstrip('.')}{others}.{_accepted(lagging.fit.misfit_accepted)}"),
        binding=False,
    )


FIT = Rule("fit", "friction that does not fit its tests", binding=False, find_checks=_fit)
OF_LAW = (CONDITION, FIT)


def _accepted(reason: str) -> str:
    return f" The laboratory wrote it nevertheless: {reason.rstrip('.')}." if reason else ""


def data(drive: Drive, pulley: Pulley) -> Check:
    """Return the weak inputs that the answer for a pulley is based on."""
    lagging = pulley.lagging
    sources: dict[str, list[str]] = {}
    weak: list[tuple[str, str, str]] = []
    grounds, sentences = law_words(lagging)
    weak += [(kind, "friction", "friction") for kind in grounds if kind in GROUNDS]
    for kind, key, owner in weak_sources(drive, pulley):
        word = key_word(key)
        owned = owner == "belt" and word.startswith(owner)
        sources.setdefault(kind, []).append(word if owned else f"{word} of {owner}")
        weak.append((kind, key, word))
    sentences += [
        f"{kind.capitalize()}: {', '.join(dict.fromkeys(sources[kind]))}."
        for kind in WEAK_KINDS
        if kind in sources
    ]
    return Check(
        name="data",
        title="Data line",
        level=Level.OK,
        place=Place(pulley.name),
        full=escaped(" ".join(sentences)),
        weak=tuple(weak),
        binding=False,
    )


#: Symbols and words of inputs, in the place of their keys.
SYMBOLS = {
    "shear_modulus": "G", "compression_modulus": "E_c",
    "in_plane_shear_stiffness": "in-plane shear stiffness", "modulus": "belt modulus",
    "rating": "belt rating", "least_pulley_diameter": "minimum pulley",
}  # fmt: skip


def key_word(key: str) -> str:
    """Return how an input is called in the line on the data."""
    return SYMBOLS.get(key, key.replace("_", " "))


#: Part of the slack-side tension from which an unknown m v^2 is told [-].
LEAST_FLUNG = 0.02


def belt_mass(drive: Drive) -> Iterator[Check]:
    """Yield how large m v^2 of a belt is whose mass is not known, by the usual mass of its kind.

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
        title="Belt m v2",
        noun="belt m v2",
        level=Level.NOT_CHECKED,
        place=place,
        source="carcasses of the catalogue and usual covers",
        missing="belt.mass",
        full="Belt mass missing: m v2 {least} to {most} (estimated) is left out, up to {share} % "
        f"of T2{escaped(place.bracket)}.",
        more={
            "least": Amount(least, "force"),
            "most": Amount(most, "force"),
            "share": Amount(100.0 * most / slack, "number"),
        },
        binding=False,
    )


def law_words(lagging: Lagging) -> tuple[list[str], list[str]]:
    """Return on what grounds the friction of a lagging stands, and the sentences about them."""
    law, friction = str(lagging.source_of("law").kind), f"The friction of {lagging.name} is"
    words = [f"{friction} {_LAWS[law]}."] if law in _LAWS else []
    untested = lagging.law.tested is None
    words += [f"{friction} without tests."] if untested else []
    return [law, *(["untested"] if untested else [])], words


def weak_sources(drive: Drive, pulley: Pulley) -> Iterator[tuple[str, str, str]]:
    """Yield each input that is illustrative, calibrated or estimated: kind, key and owner."""
    lagging, belt = pulley.lagging, drive.belt
    owners = (
        (lagging.name, {k: v for k, v in lagging.sources.items() if k != "law"}),
        ("belt", belt.sources),
        (f"pulley {pulley.name}", pulley.sources),
    )
    stated = [(key, owner, source) for owner, of in owners for key, source in of.items()]
    if pulley.across is not None and belt.in_plane_shear_stiffness is None:
        yield "estimated", "in_plane_shear_stiffness", "belt"
    if covered(belt) and belt.cover_shear_modulus is None:
        yield "estimated", "cover_shear_modulus", "belt"
    for key, owner, source in (*stated, ("belt", "belt", belt.provenance)):
        yield from ((kind, key, owner) for kind in weaknesses(source))


def weak_inputs(lagging: Lagging) -> Iterator[tuple[str, str, str]]:
    """Yield each weak input of a lagging: class, key and word, as of the line on the data."""
    for kind in law_words(lagging)[0]:
        if kind in GROUNDS:
            yield kind, "friction", "friction"
    for key, source in lagging.sources.items():
        if key != "law":
            yield from ((kind, key, key_word(key)) for kind in weaknesses(source))


def weaknesses(source: Provenance) -> Iterator[str]:
    """Yield in what ways a number from a source is weak."""
    if source.note.startswith("estimated"):
        yield "estimated"
    if source.kind in (Kind.ILLUSTRATIVE, Kind.CALIBRATED):
        yield str(source.kind)


#: In the order in which they are told.
WEAK_KINDS = ("illustrative", "calibrated", "estimated")
#: In what ways friction may be weak, the worst first.
GROUNDS = ("illustrative", "untested", "estimated", "calibrated")
_LAWS = {
    "illustrative": "illustrative: it describes no real product",
    "calibrated": "calibrated: it was fitted to a known result",
}
