"""A press that makes several drives of one, or one of several, loses nothing without a word.

Expected values are the tensions of the drive before, read from its file, and the document itself,
which comes back when the drive that was added is removed.
"""

import json
import subprocess
from copy import deepcopy
from pathlib import Path
from tomllib import loads
from typing import Any

import pytest

from checks.test_every_key import DOCUMENTS
from judgement.rows import BASE, CONVEYOR, MOTION, TANDEM, TURNED
from wraparc import Drive, Train, solve_train
from wraparc.train.file import drive_or_train_from_document, train_from_document
from wraparc.web.answers.form import form

Data = dict[str, Any]
EXAMPLES = Path(__file__).parents[2] / "examples"
TENSIONS = ("entry_tension", "exit_tension", "effective_tension", "power", "torque")
CASES = loads(
    BASE.replace('entry_tension = "120 kN"', 'effective_tension = "45 kN"')
    + '[[load_case]]\nname = "start"\ndescription = "full belt"\nkind = "starting"\n'
    'condition = "wet"\npulley.head.effective_tension = "60 kN"\n'
    '[[load_case]]\nname = "level"\npulley.head = {}\n' + TURNED.format(entry="57 kN", exit="75 kN")
)
TORQUE = loads(
    BASE.replace('entry_tension = "120 kN"', 'torque = "18 kN m"')
    + '[[load_case]]\nname = "start"\npulley.head.torque = "20 kN m"\n'
)
FIXED = loads(
    BASE + '[take_up]\nkind = "fixed"\n[[load_case]]\nname = "start"\n'
    'pulley.head.effective_tension = "60 kN"\n'
)
#: Of one pulley whose load stands in the file.
SINGLE = {"cases": CASES, "fixed": FIXED} | {
    name: document
    for name, document in DOCUMENTS.items()
    if len(document["pulley"]) == 1 and not {"conveyor", "train"} & document.keys()
}
SINGLE.pop("torque")


def pressed(*cases: Data) -> list[Data]:
    """Return documents after a press, and what is named as removed."""
    given = {"form": form().model_dump(mode="json"), "cases": cases}
    done = subprocess.run(
        ["node", str(Path(__file__).with_name("conversions.mjs"))],
        input=json.dumps(given, default=str),
        capture_output=True, text=True, encoding="utf-8", check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[Data] = json.loads(done.stdout)
    return found


def added(*documents: Data) -> list[Data]:
    return pressed(*({"doc": document, "press": "add"} for document in documents))


def ends(found: Drive | Train) -> dict[str, tuple[float, float]]:
    """Return the tensions of the whole in every load case."""
    if isinstance(found, Train):
        return {c.name: (c.entry_tension, c.exit_tension) for c in found.cases}
    names = [p.name for p in found.pulleys]
    return {
        c.name: (c.tensions[names[0]].entry, c.tensions[names[-1]].exit) for c in found.load_cases
    }


def test_a_second_drive_takes_over_every_load_case() -> None:
    documents = [*SINGLE.values(), TORQUE]
    for document, after in zip(documents, added(*documents), strict=True):
        assert after["lost"] == []
        train = train_from_document(after["doc"])
        before = drive_or_train_from_document(document)
        assert isinstance(before, Drive)
        assert ends(train).keys() == ends(before).keys()
        for name, tensions in ends(before).items():
            assert ends(train)[name] == pytest.approx(tensions, rel=1e-8), name
        told = {c.name: (c.kind, c.condition) for c in train.cases}
        assert told == {c.name: (c.kind, c.condition) for c in before.load_cases}


def test_removing_it_again_brings_the_drive_back() -> None:
    documents = list(SINGLE.values())
    after = added(*documents)
    back = pressed(*({"doc": a["doc"], "press": "remove", "with": 1} for a in after))
    for document, found in zip(documents, back, strict=True):
        assert found["doc"] == json.loads(json.dumps(document, default=str))
        named = [name for name in found["lost"] if not name.startswith("pulley second")]
        assert named == ["train share"]


def test_a_torque_on_a_belt_of_layers_is_named() -> None:
    """The pull that it makes depends on the radius that the belt pulls at."""
    (after,) = added(DOCUMENTS["torque"])
    assert after["lost"] == ["pulley head torque"]


def test_a_conveyor_gives_its_load_cases_and_is_named() -> None:
    before = drive_or_train_from_document(loads(CONVEYOR))
    assert isinstance(before, Drive)
    arcs = [
        {"load_case": name, "numbers": {"entry_tension": entry, "exit_tension": leaving}}
        for name, (entry, leaving) in ends(before).items()
    ]
    (after,) = pressed({"doc": loads(CONVEYOR), "press": "add", "with": arcs})
    assert after["lost"] == ["conveyor"]
    train = train_from_document(after["doc"])
    for name, tensions in ends(before).items():
        assert ends(train)[name] == pytest.approx(tensions, rel=1e-8)
    assert [c.kind for c in train.cases] == [c.kind for c in before.load_cases]


OVERLAND = loads((EXAMPLES / "overland-head-tail.toml").read_text("utf-8"))


def arcs_of(train: Train) -> list[Data]:
    """Return what the page knows of the arcs of a train."""
    return [
        {
            "load_case": case.case.name,
            "pulley": member.name,
            "numbers": {
                "entry_tension": member.arc.arc.entry_tension,
                "exit_tension": member.arc.arc.exit_tension,
            },
        }
        for case in solve_train(train).cases
        for member in case.members
    ]


def test_a_conveyor_with_flights_gives_its_drives_what_it_gave_them() -> None:
    """Expected: the tensions at every drum that the flights gave, of starts and stops too."""
    before = train_from_document(OVERLAND)
    arcs = arcs_of(before)
    (after,) = pressed({"doc": OVERLAND, "press": "tensions", "with": arcs})
    assert after["lost"] == ["conveyor"]
    train = train_from_document(after["doc"])
    assert [c.kind for c in train.cases] == [c.kind for c in before.cases]
    for was, now in zip(arcs, arcs_of(train), strict=True):
        assert (now["load_case"], now["pulley"]) == (was["load_case"], was["pulley"])
        assert now["numbers"] == pytest.approx(was["numbers"], rel=1e-7)


@pytest.mark.parametrize("removed", [1, 2])  # without the head drive the belt goes slack
def test_a_drive_more_and_a_drive_less_have_their_places_on_the_conveyor(removed: int) -> None:
    (more,) = added(OVERLAND)
    assert len(train_from_document(more["doc"]).pulleys) == 3
    assert more["lost"] == []
    (less,) = pressed({"doc": more["doc"], "press": "remove", "with": removed})
    names = [p["name"] for p in less["doc"]["pulley"]]
    assert [d["pulley"] for d in less["doc"]["conveyor"]["drive"]] == names
    assert [p.name for p in train_from_document(less["doc"]).pulleys] == names


IN_TRAIN = loads(
    TANDEM.replace(
        'share = ["50 %", "50 %"]',
        'share = ["50 %", "50 %"]\ndiameters = ["790 mm", "800 mm"]\nrun.two = "1 kN"',
    )
    + '[[load_case]]\nname = "start"\ntrain.effective_tension = "80 kN"\n'
    'train.share = ["60 %", "40 %"]\n'
)


def test_a_third_drive_counts_in_every_list_of_a_train() -> None:
    (after,) = added(IN_TRAIN)
    assert after["lost"] == []
    train = train_from_document(after["doc"])
    before = train_from_document(IN_TRAIN)
    assert ends(train) == ends(before)
    for case, one in zip(train.cases, before.cases, strict=True):
        assert case.division.fractions == (*one.division.fractions, 0.0)  # type: ignore[union-attr]
    (back,) = pressed({"doc": after["doc"], "press": "remove", "with": 2})
    assert back["doc"] == IN_TRAIN


def test_the_shares_of_the_drives_that_are_left_add_up() -> None:
    three = deepcopy(IN_TRAIN)
    three["pulley"].append({**three["pulley"][1], "name": "three"})
    three["train"] |= {"share": ["50 %", "30 %", "20 %"], "diameters": ["790 mm"] * 3}
    three["load_case"][0]["train"]["share"] = [0.2, 0.2, 0.6]
    for gone, shares, of_case in ((0, (0.6, 0.4), (0.25, 0.75)), (2, (0.625, 0.375), (0.5, 0.5))):
        (after,) = pressed({"doc": three, "press": "remove", "with": gone})
        train = train_from_document(after["doc"])
        found = [case.division.fractions for case in train.cases]  # type: ignore[union-attr]
        assert found[0] == pytest.approx(shares, abs=1e-4)
        assert found[1] == pytest.approx(of_case, abs=1e-4)
        assert ("train run two" in after["lost"]) is (gone == 0)


def test_a_drum_and_motors_go_with_their_drive_and_are_named() -> None:
    document = loads(MOTION)
    (after,) = pressed({"doc": document, "press": "remove", "with": 1})
    assert after["doc"]["motion"]["drum"].keys() == {"one"}
    assert {"pulley two", "motion drum two"} <= set(after["lost"])


def test_pulleys_that_each_give_their_tensions_get_one_that_idles() -> None:
    several = loads(BASE)
    several["pulley"].append(
        {**several["pulley"][0], "name": "tail", "entry_tension": "75 kN", "exit_tension": "70 kN"}
    )
    several["load_case"] = [{"name": "start", "pulley": {"head": {"entry_tension": "150 kN"}}}]
    (after,) = added(several)
    assert after["lost"] == []
    found = drive_or_train_from_document(after["doc"])
    assert len(found.pulleys) == 3
    assert ends(found) == ends(drive_or_train_from_document(several))
    (back,) = pressed({"doc": after["doc"], "press": "remove", "with": 2})
    assert back["doc"] == several
