"""Every door asked about drives that are drawn, and where one differs from the library."""

from __future__ import annotations

import time
import traceback
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import tomli_w

from doors import columns, commands, page, web
from doors.draw import document
from doors.record import Case, Record, differences

#: What answers many drives at once, each with what it says or nothing where it is not for them.
Door = Callable[[Sequence[Case], Path], list[Record | None]]


def each(command: Callable[[Case, Path], Record | None]) -> Door:
    """Return a door that is asked drive by drive; what it raises is what it says."""

    def door(cases: Sequence[Case], folder: Path) -> list[Record | None]:
        return [answer(command, case, folder) for case in cases]

    return door


def answer(
    command: Callable[[Case, Path], Record | None], case: Case, folder: Path
) -> Record | None:
    try:
        return command(case, folder)
    except Exception as error:  # noqa: BLE001 - that is what is counted
        place = traceback.extract_tb(error.__traceback__)[-1]
        raised = f"{type(error).__name__}: {error} ({Path(place.filename).name}:{place.lineno})"
        return Record(refusal=(raised,))


DOORS: dict[str, Door] = {
    "solve": each(commands.solve),
    "rows": columns.rows,
    "study": each(columns.study),
    "choose": each(commands.choose),
    "what-if": each(commands.what_if),
    "compare": web.compare,
    "trim": each(commands.trim),
    "run": each(commands.run),
    "report": each(commands.report),
    "API": web.api,
    "page": page.kernel,
    "file": page.file,
}


@dataclass
class Net:
    """What came of it: how drives end, differences by drive, answers and seconds by door."""

    cases: list[Case]
    found: dict[int, list[str]] = field(default_factory=dict)
    ends: Counter[str] = field(default_factory=Counter)
    asked: Counter[str] = field(default_factory=Counter)
    seconds: dict[str, float] = field(default_factory=lambda: defaultdict(float))

    def add(self, other: Net) -> None:
        """Take the counts of another one."""
        self.found |= other.found
        self.ends += other.ends
        self.asked += other.asked
        for door, seconds in other.seconds.items():
            self.seconds[door] += seconds


#: Of how many drives a door is asked about one: quick for a test, and for very many.
IN_A_TEST = {
    "solve": 2, "study": 4, "choose": 5, "what-if": 5, "compare": 5, "report": 6, "API": 6,
    "run": 4, "trim": 30,
}  # fmt: skip
OF_MANY = {"trim": 10}


def cast(
    seed: int,
    numbers: Sequence[int],
    folder: Path,
    doors: Sequence[str] = (),
    one_of: Mapping[str, int] | None = None,
) -> Net:
    """Draw drives, write their files into a folder and ask every door about them.

    `one_of` is of how many drives a door is asked about one, each door about others.
    """
    cases = []
    for number in numbers:
        path = folder / f"drive-{seed}-{number}.toml"
        drawn = document(seed, number)
        path.write_text(tomli_w.dumps(drawn), "utf-8")
        cases.append(Case(number, drawn, path))
    net = Net(cases)
    begin = time.monotonic()
    for case in cases:
        net.ends[end_of(case)] += 1
        _ = case.record
    net.seconds["library"] += time.monotonic() - begin
    for place, name in enumerate(doors or DOORS):
        begin, every = time.monotonic(), (one_of or {}).get(name, 1)
        some = [case for case in cases if (case.number + place) % every == 0]
        records = DOORS[name](some, folder)
        net.seconds[name] = time.monotonic() - begin
        net.asked[name] = sum(record is not None for record in records)
        for case, record in zip(some, records, strict=True):
            for difference in differences(case.record, record) if record else ():
                net.found.setdefault(case.number, []).append(f"{name}: {difference}")
    return net


def differences_told(net: Net) -> Iterator[str]:
    """Yield each difference with its drive file."""
    for case in net.cases:
        for difference in net.found.get(case.number, ()):
            yield f"{case.path.name}: {difference}"


def end_of(case: Case) -> str:
    if case.refusal:
        return "refused"
    if not case.result.solved:
        return "slip"
    return "miss a limit" if case.verdict.missed else "pass"


def summary(net: Net) -> Iterator[str]:
    """Yield how drives end, how often each door answered, how long it took, and how many differ."""
    drives = sum(net.ends.values())
    yield ", ".join(f"{count} {word}" for word, count in sorted(net.ends.items()))
    yield ", ".join(f"{door} {count}" for door, count in net.asked.items())
    times = ", ".join(f"{door} {seconds:.1f}" for door, seconds in net.seconds.items())
    yield f"{drives / sum(net.seconds.values()):.2f} drives a second; seconds: {times}"
    yield f"{len(net.found)} of {drives} differ"
