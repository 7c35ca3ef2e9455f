"""The first screen of every command on every shipped example, counted in words and lines.

Expected: 15 words of a sentence and 20 of an action at most, a number with its unit one word, level
and label none; eight lines above the tables. Actions that are searched for are counted in
`tests/actions`; here each is what its check states, so that the walk is quick.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from cli.running import wraparc
from learn.plant import Made, readings, written
from wraparc import actions
from wraparc.answer.words import stated_action
from wraparc.catalogue import lagging_names
from wraparc.checks import Level, judge
from wraparc.cli.group import COMMANDS
from wraparc.units import DIMENSION_TEXT

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples"
ONE = (
    "downhill-braking", "head-drive-fabric", "steel-cord-drive", "test-pulley-calibrated",
    "uphill-conveyor", "studies/head-drive", "wet-season/wet-season-drive",
    "worn-head-drive-fabric", "worn-head-drive-steel-cord",
)  # fmt: skip
TRAINS = ("tandem-fabric", "tandem-steel-cord", "triple-steel-cord")
LABELS = ("Action", "Change", "Also", "Wet", "Reserve", "Probability", "Data")
#: Most words of a line by its label; of a level as of another sentence.
MOST = {
    "Action": 20, "Wet": 8, "Reserve": 20, "Probability": 15, "Change": 15, "Also": 15, "Data": 15,
}  # fmt: skip


class Line(NamedTuple):
    """A line of a first screen: level or label, and what it says."""

    label: str
    text: str


def _units() -> str:
    units = {d.si_unit for d in DIMENSION_TEXT.values()}
    units |= {"%", "mm", "kN", "kN/m", "kPa", "MPa", "kW", "deg", "lbf", "in", "psi", "AUD", "t"}
    return "|".join(re.escape(unit) for unit in sorted(filter(None, units), key=len, reverse=True))


_NUMBER = re.compile(rf"[-±]?\d[\d,.]*(?: (?:{_units()}))?(?![\w/])")


def count(text: str) -> int:
    """Return the words of a text, a number with its unit as one."""
    return len(_NUMBER.sub("0", text).replace("=", " ").split())


def first_screen(out: str) -> list[Line]:
    """Return the lines of the block above the tables, those that are wrapped put together."""
    block = next(b for b in out.split("\n\n")[1:] if b) if "\n\n" in out else ""
    levels = "|".join(sorted((re.escape(str(level)) for level in Level), key=len, reverse=True))
    head = re.compile(rf"(?:({levels})(?: \(dry\)|, [\w ,]+?)?|({'|'.join(LABELS)}))  +(.*)")
    lines: list[Line] = []
    for row in block.splitlines():
        found = head.match(row)
        if found:
            lines.append(Line(found[1] or found[2], found[3]))
        else:
            assert lines, block
            assert row.startswith("  "), row  # a line that is wrapped
            lines[-1] = Line(lines[-1].label, f"{lines[-1].text} {row.strip()}")
    return lines


def asked(folder: Path) -> Iterator[tuple[str, ...]]:
    """Yield every command on the examples that it reads."""
    for name in (*ONE, *TRAINS):
        file = f"{name}.toml"
        yield "solve", file
        yield "check", file
        yield "field", file
        yield "family", file, "--ratios", "1.5,3"
    for name in ("downhill-braking", "head-drive-fabric"):
        yield (
            "what-if", f"{name}.toml", "--lagging", "full-ceramic", "--bare", "CEMA", "--wet",
            "DIN 22101", "--worn", "6 mm", "--belt", "Flexsteel ST1000", "--thickness", "10 mm",
        )  # fmt: skip
        yield "report", f"{name}.toml", "-o", str(folder / "note.md"), "--date", "-"
    for value in ("6 mm", "1 mm"):
        yield (
            "seek", "head-drive-fabric.toml", "--vary", "pulley.head.wrap_angle",
            "--result", "exit_creep", "--value", value,
        )  # fmt: skip
    yield "trim", "tandem-steel-cord.toml", "--points", "3"
    yield "stability", "tandem-steel-cord.toml"
    yield "run", "tandem-fabric.toml", "--event", "run-out", "--points", "20"
    yield "choose", "wet-season/choose.toml"
    yield "fit", "shear_tests/plan.toml"
    yield "read", "shear_tests/dry-0034kPa-1.csv"
    yield "read", "shear_tests/wet-0138kPa-2.MTR", "--unit", "Elongation=mm", "--unit", "Force=N"
    yield "learn", str(written(folder, readings(Made(days=4.0))))
    for name in ("test-pulley/published-pair", "wet-season/wet-day-record"):
        yield "calibrate", f"{name}.toml"
        yield "overlay", f"{name}.toml"
    for name, samples in (
        ("load-cases", 0), ("take-up-grid", 0), ("sensitivity", 64), ("tolerances", 64),
        ("wet-dry", 32),
    ):  # fmt: skip
        fewer = ("--set", f"sampling.samples={samples}") if samples else ()
        yield "study", f"studies/{name}.toml", "-o", str(folder / f"{name}.parquet"), *fewer

    few = ("--set", "axis[1].count=2", "--set", "points=20")
    yield "study", "studies/start-ramp.toml", "-o", str(folder / "start-ramp.csv"), *few


#: Commands that write, list or show, and have no verdict; of the last two see other tests.
SILENT = {
    "laggings", "belts", "lagging", "rig", "profile", "import", "virtual-record", "serve", "page",
    "demo",
}  # fmt: skip


def test_first_screens_are_short(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(EXAMPLES)
    monkeypatch.setenv("COLUMNS", "110")
    stated: Callable[[Any], Any] = lambda result: stated_action(judge(result))  # noqa: E731
    monkeypatch.setattr(actions, "find_action", stated)
    wrong, seen = [], set()
    for arguments in asked(tmp_path):
        ran = wraparc(*arguments)
        assert ran.code in (0, 1), (arguments, ran.err)
        seen.add(arguments[0])
        lines = first_screen(ran.out)
        where = " ".join(arguments[:2])
        if lines[0].label not in set(Level):
            wrong.append(f"{where}: begins with {lines[0]}")
        if ran.code != (lines[0].label == Level.FAILS):
            wrong.append(f"{where}: exit code {ran.code} of {lines[0].label}")
        if len(lines) > 8:
            wrong.append(f"{where}: {len(lines)} lines")
        for label, text in lines:
            words = text.partition(": ")[2] if text.startswith(tuple(Level)) else text
            if count(words) > MOST.get(label, 15):
                wrong.append(f"{where}: {count(words)} words: {label} {text}")
            if not text.endswith("."):
                wrong.append(f"{where}: no sentence: {text}")
    assert wrong == []
    assert seen | SILENT == set(COMMANDS)


def test_a_lagging_says_in_a_line_what_it_is() -> None:
    for name in lagging_names():
        block = wraparc("lagging", name).out.split("\n\n")[1].splitlines()
        assert [row.split()[0] for row in block] == [name, "Data"]
        assert all(count(row) <= 16 for row in block), block  # its name and 15 words


def test_words_are_counted_as_a_reader_counts_them() -> None:
    assert count("Creep 11.3 mm exceeds the 6.35 mm limit (head, start).") == 8
    assert count("Wrap 231.8 deg gives creep 6 mm (head, design; now 180 deg).") == 9
    assert (
        count("Belt tension 215 kN exceeds the 210 kN rating (first, entry, start, 8.52 s).") == 11
    )
    assert count("16.7 % fail, 50 % need attention.") == 5
