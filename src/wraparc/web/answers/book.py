"""What a page needs to judge any drive of one pulley itself: laws, belts, rules and words.

Everything comes from the functions that the server's own answers use: what depends on the drive is
left open in the texts (``⟦pulley⟧``, ``⟦case⟧`` ...), and the numbers are those of the catalogue.
`assemble.js` of the page puts a drive together from it as `judging` does on the server.
"""

import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict, replace
from functools import cache
from typing import Any

from wraparc import catalogue
from wraparc.catalogue import design_friction
from wraparc.checks import RULES, Check, Level, judge, of_data, of_drive
from wraparc.checks.check import Place
from wraparc.checks.design_standard import MANUAL_WRAP_FACTORS, asked
from wraparc.checks.least_tension import figures
from wraparc.checks.of_arc import BALANCE, INTERVAL, held_words
from wraparc.checks.rules import CUSTOMARY_SAFETY
from wraparc.checks.usual import USUAL
from wraparc.conveyor import EMPTIEST, FULLEST, GRAVITY, STEEPEST, USUAL_CONVEYOR
from wraparc.drive import (
    CASE_KINDS,
    CREEP_LIMIT,
    DESIGN,
    DesignStandard,
    Lagging,
    SafetyFactors,
    Sag,
    TakeUp,
)
from wraparc.drive.conditions import DRY
from wraparc.drive.pitch import counts_shear
from wraparc.errors import InputError
from wraparc.files import drive_from_document
from wraparc.friction import LAGGING_SHEAR
from wraparc.present.checks_table import NOTE, check_table
from wraparc.present.least_tension import least_name, least_table
from wraparc.schema.source import Document, parse
from wraparc.web.answers.book_parts import (
    Book,
    BookCatalogue,
    BookLagging,
    BookLaw,
    BookTested,
    DesignRow,
    Heads,
    ManualRow,
    Standards,
)
from wraparc.web.answers.book_words import (
    CASE,
    HELD,
    PROBE,
    PULLEY,
    probe,
    with_criteria,
    words_by_key,
)
from wraparc.web.answers.documents import json_like
from wraparc.web.answers.judging import Ask, Words, words_of
from wraparc.web.answers.prepared import Law
from wraparc.web.answers.shown import tables, worded

_NO_INTERVAL = (
    "The interval of the creep that the fit of {} leaves is not found in this page; wraparc solve "
    "tells it."
)
#: Conditions that published values cover.
CONDITIONS = ("dry", "wet", "wet and dirty")


def book(document: Document | None = None) -> Book:
    """Return what the catalogue has, and a drive document: its laggings and conditions.

    Raises
    ------
    InputError
        If a lagging of the document cannot be read.
    """
    found = _whole()
    if document is None:
        return found
    own = document.get("lagging") or {}
    conditions = dict.fromkeys(CONDITIONS) | dict(_named_conditions(document))
    names = (*catalogue.lagging_names(), *own)
    laggings = {name: _lagging(name, own, conditions) for name in names}
    return found.model_copy(update={"laggings": laggings, "own": own})


@cache
def _whole() -> Book:
    result = probe()
    return Book(
        levels=list(Level),
        laggings={
            name: _lagging(name, {}, dict.fromkeys(CONDITIONS))
            for name in catalogue.lagging_names()
        },
        catalogue=_catalogue(),
        words={key: [_bare(w) for w in found] for key, found in words_by_key()},
        asks=_asks(),
        standards=_standards(result.drive.pulleys[0].lagging),
        grounds=dict(of_data.GROUNDS),
        weak_kinds=list(of_data.WEAK_KINDS),
        more_creep=of_drive.MORE_CREEP,
        customary_safety=CUSTOMARY_SAFETY,
        least_names={h: least_name(with_criteria(result, take_up=t)) for h, t in HELD.items()},
        held={key: held_words(take_up) for key, take_up in HELD.items()},
        heads=_heads(),
        usual={
            "creep_limit": CREEP_LIMIT,
            "gravity": GRAVITY,
            "balance": BALANCE,
            "sheave_ratio": TakeUp().sheave_ratio,
            "start_factor": DesignStandard().start_factor,
            "share": Sag.share,
            **{kind: SafetyFactors().of(kind) for kind in CASE_KINDS},
        },
        sizes={
            **{name: dict(ends) for name, ends in USUAL.items()},
            "Conveyor": {key: ends for key, *ends in USUAL_CONVEYOR} | USUAL["Conveyor"],
        },
        load=(EMPTIEST, FULLEST),
        steepest=STEEPEST,
        design=DESIGN,
        own={},
    )


def _bare(words: Words) -> Words:
    """Return words without those that the comparison of its numbers decides on."""
    if words.miss is None:
        return words
    return words.model_copy(
        update={"level": Level.OK, "short": "", "says": "", "remedy": "", "otherwise": ""}
    )


def key_of(condition: Any) -> str:
    """Return the text that a condition of a document is found by: its name, or its table."""
    if isinstance(condition, str):
        return condition
    return json.dumps(condition, separators=(",", ":"), ensure_ascii=False)


def _named_conditions(document: Document) -> Iterator[tuple[str, Any]]:
    """Yield every condition that a document names."""
    given = document.get("condition")
    rows = [*(given if isinstance(given, list) else [given])]
    rows += [t.get("condition") for t in document.get("pulley") or ()]
    rows += [t.get("condition") for t in document.get("load_case") or ()]
    yield from ((key_of(row), row) for row in rows if row is not None)


def _lagging(name: str, own: Document, conditions: Mapping[str, Any]) -> BookLagging:
    first = _read(name, own, None)
    laws = {first.condition: _law(first)}
    for key, condition in conditions.items():
        try:
            laws[key] = _law(_read(name, own, condition or key))
        except InputError:  # nothing is known of it: a drive that asks for it is refused
            continue
    return BookLagging(
        name=first.name,
        first=first.condition,
        wet=of_data.wet_factor(first),
        laws=laws,
    )


def _read(name: str, own: Document, condition: Any) -> Lagging:
    """Return a lagging as a drive file has it."""
    pulley = {**PROBE["pulley"][0], "lagging": name}
    more = {} if condition is None else {"condition": condition}
    document = {**PROBE, "pulley": [pulley], "lagging": own, **more}
    return drive_from_document(document).pulleys[0].lagging


def _interval_left() -> Check:
    """What of a fitted law a page that judges by itself leaves to the program: no bare OK."""
    return Check(
        name="creep_interval",
        title=INTERVAL,
        level=Level.ATTENTION,
        place=Place(PULLEY, CASE),
        says="By the uncertainty of the friction law the creep may be beyond its limit: this page "
        "does not find the interval.",
        remedy="Solve the file with wraparc solve, which does.",
        short="interval not found here",
        binding=False,
    )


def _law(lagging: Lagging) -> BookLaw:
    compact, tested = lagging.law.compact(), lagging.law.tested
    grounds, told = of_data.law_words(lagging)
    fitted = lagging.fit is not None and bool(lagging.fit.knots)
    drive = probe().drive
    at = drive.load_cases[-1], replace(drive.pulleys[0], lagging=lagging)
    return BookLaw(
        condition=lagging.condition,
        law=Law(
            kind=compact.kind,
            edges=list(compact.edges),
            coefficients=list(compact.coefficients),
            slips=list(compact.slips),
            onset_compliance=compact.onset_compliance,
        ),
        steepest_fall=lagging.law.steepest_fall(),
        slip_with_shear=counts_shear(lagging.law, LAGGING_SHEAR) is True,
        tested=None
        if tested is None
        else BookTested(
            pressure_min=tested.pressure_min,
            pressure_max=tested.pressure_max,
            slip_max=tested.slip_max,
            slip_speed=_number(tested.slip_speed),
        ),
        grounds=grounds,
        told=[*told, _NO_INTERVAL.format(lagging.name)] if fitted else told,
        checks=[
            *(words_of(check) for of in (of_data.condition, of_data.fit) for check in of(*at)),
            *([words_of(_interval_left())] if fitted else []),
        ],
    )


def _catalogue() -> BookCatalogue:
    """Return belts and lagging files, as documents are read with them."""
    return BookCatalogue(
        belts=[asdict(belt) for belt in catalogue.belts()],
        laggings={
            name: json_like(parse(catalogue.lagging_text(name)))
            for name in catalogue.lagging_names()
        },
    )


def _asks() -> dict[str, Ask]:
    """Return what every check asks of the slack side, but for the tension."""
    result = with_criteria(probe(), sag=Sag(spacing=3.0, line_mass=20.0))
    belt = replace(result.drive.belt, largest_wrap_pressure=1e6)
    drive = replace(result.drive, belt=belt, creep_limit=1.0)
    arcs = (replace(arc, arc=replace(arc.arc, creep_limit=1.0)) for arc in result)
    open_ = {"CEMA, friction 0.35 (rubber)": "⟦rule⟧", "1.25": "⟦safety⟧"}
    found = {}
    for figure in figures(type(result)(drive, tuple(arcs))):
        title = figure.title
        for given, place in open_.items():
            title = title.replace(given, place)
        found[figure.name] = Ask(
            name=figure.name,
            title=title,
            what=RULES[figure.name].what,
            place=str(figure.place),
            binding=figure.binding,
            at_least=figure.at_least,
        )
    return found


def _standards(lagging: Lagging) -> Standards:
    def by(standard: DesignStandard, take_up: TakeUp, wrap: float, **more: Any) -> Any:
        return asked(standard, take_up, replace(lagging, **more), wrap)

    rows = []
    for value in design_friction():
        if value.standard in ("CEMA", "DIN 22101"):
            standard, condition = DesignStandard(name=value.standard), value.condition or DRY
            rule = by(standard, TakeUp(), 3.0, surface=value.surface, condition=condition).rule
            rows.append(
                DesignRow(
                    standard=value.standard,
                    surface=value.surface,
                    condition=value.condition,
                    friction=value.friction[0],
                    rule=rule,
                )
            )
    fixed, plain = TakeUp(kind="fixed"), DesignStandard()
    manual = {
        key: [
            ManualRow(
                angle=angle,
                factor=factor,
                rule=by(plain, fixed, math.radians(angle), surface=surface).rule,
            )
            for angle, factor in MANUAL_WRAP_FACTORS[key]
        ]
        for key, surface in {"bare": "bare", "lagged": "rubber"}.items()
    }
    own = by(DesignStandard(name="own", friction=0.35), TakeUp(), 3.0).rule
    unknown = by(DesignStandard(name="DIN 22101"), TakeUp(), 3.0, condition="⟦condition⟧").why_not
    return Standards(
        rows=rows,
        manual=manual,
        own=own.replace("0.35", "⟦friction⟧"),
        silent={
            "surface": by(plain, TakeUp(), 3.0, surface="", name="⟦lagging⟧").why_not,
            "condition": unknown.replace("rubber", "⟦surface⟧"),
            "manual": by(plain, fixed, 1.0).why_not,
        },
    )


def _heads() -> Heads:
    checks = tables([check_table(judge(probe()))], ["checks"])[0]
    least = {}
    for held, take_up in HELD.items():
        of = with_criteria(probe(), take_up=take_up)
        found = tables([least_table(of)], ["least"])[0]
        least[held] = found.model_copy(update={"rows": []})
    return Heads(checks=checks.model_copy(update={"rows": [], "note": worded(NOTE)}), least=least)


def _number(value: float | None) -> float:
    return math.nan if value is None else value
