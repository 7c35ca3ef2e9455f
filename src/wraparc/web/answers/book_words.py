"""The words of the checks with what depends on the drive left open, from the checks themselves."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from itertools import product
from typing import Any, get_args

from wraparc.arc import ArcResult, Distributed, DriveResult, Status, solve
from wraparc.checks import Check, of_arc, of_data, of_drive
from wraparc.checks.check import Place
from wraparc.checks.design_standard import asked
from wraparc.checks.judge import (
    NO_DIVISION,
    fight,
    motor_load,
    not_working,
    operating_point,
    train_balance,
    unrated,
)
from wraparc.checks.of_arc import held_words
from wraparc.checks.usual import usual_sizes
from wraparc.drive import (
    TAKE_UPS,
    Criteria,
    DesignStandard,
    Drive,
    LoadCase,
    Pulley,
    Sag,
    TakeUp,
)
from wraparc.drive.criteria import CaseKind
from wraparc.files import drive_from_document
from wraparc.schema.source import Document
from wraparc.train import TrainStatus
from wraparc.web.answers.judging import BRAKES, Words, either, sliding_words, words_of

PULLEY, CASE = "⟦pulley⟧", "⟦case⟧"
#: A drive that nothing is special of.
PROBE: Document = {
    "format": 1,
    "belt": {"preset": "Plylon Plus 1000/4", "width": "1200 mm", "speed": "3 m/s"},
    "pulley": [
        {
            "name": PULLEY,
            "diameter": "800 mm",
            "wrap_angle": "180 deg",
            "lagging": "diamond-rubber",
            "entry_tension": "150 kN",
            "exit_tension": "60 kN",
        }
    ],
    "load_case": [{"name": CASE, "pulley": {PULLEY: {"exit_tension": "60 kN"}}}],
}
#: What a take-up can hold.
HELD: dict[str, TakeUp] = {
    "slack": TakeUp(),
    "fixed": TakeUp(kind="fixed"),
    "behind": TakeUp(after=PULLEY),
}
Found = Iterator[tuple[str, Iterable[Words]]]


@cache
def probe() -> DriveResult:
    """Return the solved drive that the words are taken from."""
    return solve(drive_from_document(PROBE), method=Distributed(points=24))


def with_criteria(result: DriveResult, **criteria: Any) -> DriveResult:
    """Return a solved drive held against other criteria."""
    return DriveResult(replace(result.drive, criteria=Criteria(**criteria)), tuple(result))


def words_by_key() -> Found:
    """Yield the words of every check by its name and by what they depend on."""
    result = probe()
    drive, case, arc = result.drive, result.drive.load_case(CASE), result.arc(PULLEY, CASE)
    yield from _grip(drive, case, arc)
    yield from _standard(drive, case, arc)
    yield from _creep(drive, arc)
    yield "cover_creep", _cover_creep(arc)
    yield from _belt_tension(drive, case)
    yield from _belt_safety(drive, case)
    yield from _sizes(drive, case)
    yield from _stresses(drive, arc)
    yield from _tested(drive, case, arc)
    yield from _take_up(drive, case)
    yield "balance", _some(of_arc.balance(arc), "solved")
    yield "sense", _some(of_drive.sense(case, drive.pulleys[0]), BRAKES)
    yield "data", _some(of_data.data(drive, drive.pulleys[0]))
    yield "usual_sizes", map(words_of, usual_sizes(drive))


def _some(check: Check | None, when: str = "", **open_: str) -> list[Words]:
    if check is None:
        raise AssertionError("the drive of the words lacks a check")
    return [_open(words_of(check, when), {text: name for name, text in open_.items()})]


def _ends(check: Callable[[ArcResult], Check], arc: ArcResult) -> Iterator[Words]:
    """Yield the words of a check of an arc, however that ends."""
    return either([check(arc)], [check(replace(arc, status=Status.BREAKAWAY))])


def _at(
    place: int, checks: Callable[..., Iterator[Check]], pulley: Pulley, arc: ArcResult
) -> Check:
    """Return one of the checks that a function yields."""
    return list(checks(pulley, arc))[place]


def _open(words: Words, open_: Mapping[str, str]) -> Words:
    """Return words with texts in them left open."""
    text = words.model_dump_json()
    for given, name in open_.items():
        text = text.replace(given, f"⟦{name}⟧")
    return Words.model_validate_json(text)


def _key(name: str, *parts: str | bool) -> str:
    return ":".join([name, *(part for part in parts if isinstance(part, str) and part)])


def _grip(drive: Drive, case: LoadCase, arc: ArcResult) -> Found:
    open_ = {
        case.kind: "kind",
        drive.pulleys[0].lagging.name: "lagging",
        held_words(TakeUp()): "take_up",
    }
    of = replace(drive, criteria=Criteria())
    yield "gross_slip", (_open(w, open_) for w in sliding_words(of, case, arc))


def _standard(drive: Drive, case: LoadCase, arc: ArcResult) -> Found:
    rules = {"own": "your own rule, friction 0.35", "": "CEMA, friction 0.35 (rubber)"}
    for (name, rule), binding, start in product(rules.items(), (False, True), (1.0, 1.375)):
        own = 0.35 if name else None
        standard = DesignStandard(name=name, friction=own, start_factor=start, binding=binding)
        found = of_arc.standard(_by(drive, standard), case, arc)
        words = name and "named", binding and "binding", start != 1.0 and "started"
        yield _key("design_standard", *words), _some(found, rule=rule, start="1.375")
    silent = replace(drive.pulleys[0].lagging, surface="")
    pulley = replace(drive.pulleys[0], lagging=silent)
    for name, binding in (("", False), ("DIN 22101", False), ("DIN 22101", True)):
        standard = DesignStandard(name=name, binding=binding)
        why = asked(standard, TakeUp(), silent, math.pi)
        found = of_arc.standard(replace(_by(drive, standard), pulleys=(pulley,)), case, arc)
        words = name and "named", binding and "binding", "silent"
        texts = {"why": why.why_not, "rule": why.rule} if why else {}
        yield _key("design_standard", *words), _some(found, **texts)


def _by(drive: Drive, standard: DesignStandard) -> Drive:
    return replace(drive, criteria=Criteria(standard=standard))


def _creep(drive: Drive, arc: ArcResult) -> Found:
    belts: dict[str, dict[str, Any]] = {
        "unknown": {"rating": None},
        "more": {"kind": "fabric", "rating": 1e6},
        "less": {"kind": "fabric", "rating": 1e4},
        "nameless": {"kind": "steel cord", "rating": 1e6, "name": "belt"},
    }
    for key, more in belts.items():
        belt = replace(drive.belt, **more)
        yield f"creep:{key}", _ends(partial(of_arc.creep, replace(drive, belt=belt)), arc)
    other = replace(arc, arc=replace(arc.arc, creep_limit=0.01))
    yield "creep:given", _ends(partial(of_arc.creep, drive), other)


def _cover_creep(arc: ArcResult) -> Iterator[Words]:
    """Yield the words of the creep with the cover, which friction carries or not."""
    for end, cover in {"carried": 1e-12, "through": 1.0}.items():
        of = replace(arc, arc=replace(arc.arc, cover_left_out=cover))
        yield from _some(of_arc.cover_creep(of), f"solved:{end}")
    yield from _some(of_arc.cover_creep(replace(of, status=Status.BREAKAWAY)), "breakaway")


def _belt_tension(drive: Drive, case: LoadCase) -> Found:
    belts: dict[str, dict[str, Any]] = {
        "none": {"rating": None},
        "ungiven": {},
        "one": {"momentary_factor": 1.0},
        "factor": {"momentary_factor": 1.375},
    }
    kinds: Sequence[CaseKind] = get_args(CaseKind)[:2]
    for kind, (key, more) in product(kinds, belts.items()):
        of = replace(drive, belt=replace(drive.belt, **more)), replace(case, kind=kind)
        check = of_drive.belt_tension(*of, drive.pulleys[0])
        yield _key("belt_tension", kind, key), _some(check, factor="1.375")


def _belt_safety(drive: Drive, case: LoadCase) -> Found:
    belts: dict[str, dict[str, Any]] = {
        "none": {"strength": None},
        "unknown": {"strength": 1e6, "rating": None, "kind": ""},
        "customary": {"strength": 1e6, "rating": None, "kind": "fabric"},
        "rated": {"strength": 1e6},
    }
    kinds: Sequence[CaseKind] = get_args(CaseKind)[:2]
    for kind, (key, more) in product(kinds, belts.items()):
        of = replace(drive, belt=replace(drive.belt, **more)), replace(case, kind=kind)
        yield _key("belt_safety", kind, key), _some(of_drive.belt_safety(*of, drive.pulleys[0]))


def _sizes(drive: Drive, case: LoadCase) -> Found:
    pulley = drive.pulleys[0]
    for key, size in {"none": None, "given": 1.0}.items():
        belt = replace(
            drive.belt, name="⟦belt⟧", largest_wrap_pressure=size, least_pulley_diameter=size
        )
        of = replace(drive, belt=belt)
        yield f"face_pressure:{key}", _some(of_drive.face_pressure(of, case, pulley))
        yield f"pulley_diameter:{key}", _some(of_drive.pulley_diameter(of, pulley))
        sag = None if size is None else Sag(spacing=3.0, line_mass=20.0, share=0.0375)
        found = of_drive.sag(replace(drive, criteria=Criteria(sag=sag)), case)
        yield f"sag:{key}", _some(found, share="3.75")


def _stresses(drive: Drive, arc: ArcResult) -> Found:
    for (key, limit), (word, speed) in product(
        {"none": None, "given": 1e5}.items(), {"moving": 3.0, "still": None}.items()
    ):
        lagging = replace(
            drive.pulleys[0].lagging, name="⟦lagging⟧", bond_strength=limit, fatigue_limit=limit
        )
        of = replace(arc, arc=replace(arc.arc, belt_speed=speed))
        pulley = replace(drive.pulleys[0], lagging=lagging)
        for place, of_key in enumerate((f"bond_stress:{key}", _key("fatigue_stress", key, word))):
            yield of_key, _ends(partial(_at, place, of_arc.lagging_stress, pulley), of)


def _tested(drive: Drive, case: LoadCase, arc: ArcResult) -> Found:
    own = drive.pulleys[0].lagging
    law: Any = own.law  # a dataclass, as every law is
    for key, speed in {"none": None, "given": 0.01}.items():
        at_speed = replace(law, tested=replace(law.tested, slip_speed=speed))
        lagging = replace(own, name="⟦lagging⟧", law=at_speed)
        pulley = replace(drive.pulleys[0], lagging=lagging)
        yield "tested_pressure:given", map(words_of, of_drive.tested_pressure(drive, case, pulley))
        for word, speed_of_belt in {"moving": 3.0, "still": None}.items():
            of = replace(arc, arc=replace(arc.arc, belt_speed=speed_of_belt))
            for place, of_key in enumerate(("tested_slip", _key("tested_slip_speed", key, word))):
                yield of_key, _ends(partial(_at, place, of_arc.tested_slip, pulley), of)
    untested = replace(own, name="⟦lagging⟧", law=replace(law, tested=None))
    pulley = replace(drive.pulleys[0], lagging=untested)
    yield "tested_pressure:none", map(words_of, of_drive.tested_pressure(drive, case, pulley))


def _take_up(drive: Drive, case: LoadCase) -> Found:
    """Yield what is said where load cases contradict the take-up."""
    tight = replace(case.tensions[PULLEY], entry=1e6, exit=5e5)
    cases = (
        replace(case, name="⟦least⟧"),
        replace(case, name="⟦most⟧", tensions={PULLEY: tight}),
    )
    for kind, after in product(TAKE_UPS, ("", PULLEY)):
        if kind == "fixed" and after:
            continue
        criteria = Criteria(take_up=TakeUp(kind=kind, after=after))
        found = of_drive.take_up(replace(drive, load_cases=cases, criteria=criteria))
        yield _key("take_up", kind, after and "behind"), map(words_of, found)


def train_words() -> dict[str, list[Words]]:
    """Return the words of what only several drives can miss, by the key that the page asks for."""
    place = Place("", CASE)
    checks = {
        "fight": fight(0.0, place),
        "fight:fights": fight(1.0, place),
        "belt_thickness": of_drive.unknown_trim("⟦first⟧", 0.0, False, Place(PULLEY, CASE)),
        "belt_thickness:opposite": of_drive.unknown_trim("⟦first⟧", 0.0, True, Place(PULLEY, CASE)),
        "train_balance": train_balance(0.0, place),
        "motor_load:none": unrated(False, Place(PULLEY, CASE)),
        "momentary_load:none": unrated(True, Place(PULLEY, CASE)),
        "motor_load": motor_load(1.0, 1.0, False, Place(PULLEY, CASE)),
        "momentary_load": motor_load(1.0, 1.0, True, Place(PULLEY, CASE)),
        "operating_point": operating_point(TrainStatus.BEYOND_MOTOR, "⟦reason⟧", place),
        "operating_point:adrift": operating_point(TrainStatus.BREAKAWAY, "⟦reason⟧", place),
        "gross_slip:adrift": of_drive.not_checked(
            "gross_slip", of_arc.GRIP.format("⟦kind⟧"), NO_DIVISION, Place(PULLEY, CASE)
        ),
        **{f"{check.name}:none": check for check in not_working(place)},
    }
    return {key: [words_of(check)] for key, check in checks.items()}
