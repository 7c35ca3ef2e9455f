"""What a file says is there again when it is written, or stands below with its reason.

The documents have every key of the tables that read them: a key that is added is asked about too.
"""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tomllib import loads
from typing import Any

import pytest

from checks.test_every_key import BELT, BLOCKS, DOCUMENTS, HEAD, LAWS
from judgement.rows import TANDEM
from wraparc import Drive
from wraparc.calibrate.calibration import calibrate
from wraparc.calibrate.file import calibrated_lagging, measured_from_document
from wraparc.files import (
    drive_from_document,
    drive_text,
    lagging_from_text,
    lagging_text,
    load_lagging_conditions,
)
from wraparc.files.drive_keys import DRIVE
from wraparc.files.lagging_keys import LAGGING_FILE
from wraparc.schema.kinds import Kind
from wraparc.schema.overrides import put_over
from wraparc.schema.tables import Table
from wraparc.train.file import drive_or_train_from_document, train_from_document
from wraparc.web.opening import opened

Data = dict[str, Any]
SOURCE = '{ kind = "published", source = "ours", date = "2020", note = "p. 4" }'
#: Keys that are words, with the sources of numbers, and what excludes the keys of others.
WORDED = loads(
    HEAD.replace(
        "format = 1\n",
        'format = 1\ntitle = "Head"\ndescription = "two lines\\nof it"\ncovered = true\n'
        'creep_limit = "5 mm"\n',
    )
    .replace("[belt]\n", '[belt]\nname = "ours"\nkind = "fabric"\nmodulus_test = "dynamic"\n'
             'modulus_loads = ["2 %", "10 %"]\n')
    .replace('mass = "20 kg/m"', f'mass = "20 kg/m"\nprovenance = {SOURCE}\n'
             f"sources.modulus = {SOURCE}")
    .replace('overrun = "0.2 mm"', f'overrun = "formula"\nrecovery = false\nside = "carry"\n'
             f"sources.diameter = {SOURCE}")
    .replace('kind = "gravity"', 'kind = "winch"\nafter = "head"')
    .replace("start_factor = 1.4", 'start_factor = 1.4\ncondition = "wet"\nbinding = true')
    .replace("running = 1.25", 'running = 1.3\nsource = "ours"')
    .replace("share = 0.02", "share = 0.03")
    .replace("sheave_ratio = 2", "sheave_ratio = 3")
    + '[[load_case]]\nname = "start"\ndescription = "of a full belt"\nkind = "starting"\n'
    'pulley.head = { entry_tension = "130 kN", exit_tension = "75 kN" }\n'
)  # fmt: skip
#: Keys of drives that are not written as they were given, and why.
WRITTEN_OTHERWISE = {
    "condition": "the law in that condition is written, and dry is what is left out",
    "effective_tension": "the tensions that follow are written", "power": "the same",
    "elongation": "the modulus that follows is written", "torque": "the same",
    "belt_path": "the wrap angle that follows is written",
    "preset": "the table is written where a number differs", "lagging": "written in its pulley",
}  # fmt: skip


def leaves(value: Any, at: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Yield what a document holds, by keys and names of rows."""
    if isinstance(value, dict):
        for key, part in value.items():
            yield from leaves(part, (*at, key))
    elif isinstance(value, list):
        for number, part in enumerate(value):
            named = isinstance(part, dict) and part.get("name")
            yield from leaves(part, (*at, str(named or number)))
    else:
        yield at, value


def in_pulleys(document: Data) -> Data:
    """Return a document with its laggings in their pulleys, as they are written."""
    own = document.get("lagging", {})
    pulleys = [
        {**p, "lagging": {"name": p["lagging"], **own[p["lagging"]]}} if p["lagging"] in own else p
        for p in document["pulley"]
    ]
    rest = {key: value for key, value in document.items() if key != "lagging"}
    return {**rest, "pulley": pulleys}


def lost(document: Data, written: Data) -> set[str]:
    """Return the paths of a document that are not written."""
    there = {path for path, _ in leaves(written)}
    return {".".join(path) for path, _ in leaves(in_pulleys(document)) if path not in there}


def keys_of(kind: Kind, depth: int = 0) -> Iterator[str]:
    """Yield every key below a kind."""
    if isinstance(kind, Table):
        for entry in kind.entries:
            yield entry.key
            yield from keys_of(entry.kind, depth + 1)
    elif depth < 14:
        for value in vars(kind).values():
            parts = value.values() if isinstance(value, dict) else value
            some = parts if isinstance(parts, list | tuple) or parts is not value else (value,)
            yield from (key for p in some if isinstance(p, Kind) for key in keys_of(p, depth + 1))


DRIVES = {"worded": WORDED} | {
    name: document
    for name, document in DOCUMENTS.items()
    if not {"train", "motion"} & document.keys()
}


@pytest.mark.parametrize("name", DRIVES)
def test_a_drive_is_written_with_all_that_was_read(name: str) -> None:
    document = DRIVES[name]
    drive = drive_from_document(document)
    written = loads(drive_text(drive))
    assert drive_from_document(written) == drive
    gone = {path for path in lost(document, written) if not said_otherwise(path)}
    # what is left out says the same as its absence
    assert drive_from_document(without(document, gone)) == drive


def said_otherwise(path: str) -> bool:
    return any(step in WRITTEN_OTHERWISE for step in path.split("."))


def without(document: Data, paths: set[str]) -> Data:
    """Return a document without some of its keys."""

    def left(value: Any, at: tuple[str, ...]) -> Any:
        if isinstance(value, dict):
            inner = {
                k: left(v, (*at, k)) for k, v in value.items() if ".".join((*at, k)) not in paths
            }
            return {k: v for k, v in inner.items() if v != {}}
        if isinstance(value, list):
            return [
                left(v, (*at, str((isinstance(v, dict) and v.get("name")) or n)))
                for n, v in enumerate(value)
            ]
        return value

    found: Data = left(document, ())
    return found


def test_the_written_drive_keeps_the_words_of_its_load_cases() -> None:
    written = loads(drive_text(drive_from_document(WORDED)))
    assert written["load_case"][0]["description"] == "of a full belt"
    text = TANDEM + '[[load_case]]\nname = "start"\ndescription = "full"\n'
    train = train_from_document(loads(text))
    assert [case.description for case in train.cases] == ["", "full"]
    # left out is what stands for the same
    assert lost(WORDED, written) <= {
        "condition", "pulley.head.overrun", "safety_factor.starting", "safety_factor.braking",
    }  # fmt: skip


#: Keys of rows that no document here has, and why they are not lost.
ELSEWHERE = {
    "x": "of a belt path: the wrap angle that follows is written", "y": "the same",
    "turn": "the same", "friction_factor": "of a condition: the law in it is written",
    "friction_factors": "the same", "standard": "the same",
}  # fmt: skip


def test_every_key_of_a_drive_is_in_a_document_or_stands_here() -> None:
    given = {step for document in DRIVES.values() for path, _ in leaves(document) for step in path}
    of_laggings = set(keys_of(LAGGING_FILE))
    left = set(keys_of(DRIVE)) - of_laggings - given - set(ELSEWHERE) - set(WRITTEN_OTHERWISE)
    across = {"entry_profile", "strips", "depth", "on", "uncertainty"}  # as the others of [across]
    assert left - across == {"train", "motion", "learned", "load_case", "drive_at"} & left


LAGGING = loads(BLOCKS)["lagging"]["plain"]
LAGGING_WORDS = {
    "format": 1, "name": "ours", "title": "Ours", "description": "a sheet", "notes": ["one", "two"],
    "sources": {"bond_strength": {"kind": "published", "source": "peel test"}},
    "provenance": {"kind": "measured", "source": "laboratory", "date": "2024", "note": "n"},
}  # fmt: skip
LAGGING_TEXTS = [LAGGING | LAGGING_WORDS] + [
    {**LAGGING, **LAGGING_WORDS, **loads(f"law = {{ {law}")} for law in LAWS.values()
]


@pytest.mark.parametrize("document", LAGGING_TEXTS, ids=["constant", *LAWS])
def test_a_lagging_is_written_with_all_that_was_read(document: Data) -> None:
    import tomli_w

    laggings = lagging_from_text(tomli_w.dumps(document))
    written = loads(lagging_text(laggings))
    there = {path for path, _ in leaves(written)}
    assert {path for path, _ in leaves(document)} <= there
    assert lagging_from_text(lagging_text(laggings)) == laggings


def test_a_drive_opened_for_the_page_has_its_lagging_file_in_it(tmp_path: Path) -> None:
    import tomli_w

    (tmp_path / "ours.toml").write_text(tomli_w.dumps(LAGGING_TEXTS[0]), "utf-8")
    document = {**loads(HEAD), "pulley": [{**loads(HEAD)["pulley"][0], "lagging": "ours.toml"}]}
    path = tmp_path / "drive.toml"
    path.write_text(tomli_w.dumps(document), "utf-8")
    found = opened(str(path))
    assert {**found, "lagging": None, "pulley": None} == {
        **document, "lagging": None, "pulley": None,
    }  # fmt: skip
    assert {**found["pulley"][0], "lagging": "ours.toml"} == document["pulley"][0]
    told = {path for path, _ in leaves(LAGGING_TEXTS[0]) if path[0] not in ("format", "name")}
    assert told <= {path for path, _ in leaves(found["lagging"]["ours"])}
    (dry,) = load_lagging_conditions(tmp_path / "ours.toml")
    drive = drive_or_train_from_document(found)
    assert isinstance(drive, Drive)
    assert drive.pulleys[0].lagging == dry


@pytest.mark.parametrize("document", [WORDED, loads(BELT)], ids=["head", "conveyor"])
def test_one_set_value_leaves_everything_else(document: Data) -> None:
    changed = put_over(document, ["belt.width=1400 mm"], DRIVE)
    assert changed == {**document, "belt": {**document["belt"], "width": "1400 mm"}}


def test_a_calibrated_lagging_keeps_what_was_not_calibrated(tmp_path: Path) -> None:
    import tomli_w

    still = HEAD.replace('overrun = "0.2 mm"\n', "")
    drive = {**loads(still), "lagging": {"plain": {**LAGGING, **LAGGING_WORDS}}}
    for key in ("format", "name"):
        drive["lagging"]["plain"].pop(key)
    (tmp_path / "drive.toml").write_text(tomli_w.dumps(drive), "utf-8")
    number = {"quantity": "exit_creep", "value": "6 mm", "sd": "0.1 mm"}
    document = {"format": 1, "drive": "drive.toml", "parameters": ["friction"], "number": [number]}
    document["errors"] = {"slip_axis": "5 %"}
    measured = measured_from_document(document, folder=str(tmp_path))
    before = measured.problem.drive.pulleys[0].lagging
    found = calibrate(measured.problem)
    after = calibrated_lagging(found, measured)
    same = replace(after, law=before.law, name=before.name, title=before.title, uncertainty={},
                   provenance=before.provenance, sources=before.sources)  # fmt: skip
    assert same == before
    # the interval of what was found, and 1.96 of the standard deviation that the file states
    (friction,) = found.estimates
    assert friction.value is not None
    assert friction.low is not None
    assert friction.high is not None
    off = max(friction.high / friction.value, friction.value / friction.low) - 1.0
    assert after.uncertainty == pytest.approx({"friction": off, "slip": 0.098}, abs=2e-4)
    for part in ("bond_strength", "fatigue_limit", "wear_coefficient", "thickness"):
        assert after.source_of(part) == before.source_of(part), part
