"""Load cases whose name says that the belt starts or stops, and whose kind is running."""

from __future__ import annotations

from collections.abc import Iterator

from wraparc.checks.check import Check, Place, escaped
from wraparc.checks.rule import Rule
from wraparc.drive import Drive, LoadCase
from wraparc.drive.case_names import named_kinds

CASE_KIND = Rule("case_kind", "the kind of a load case", binding=False)


def named_kind(case: LoadCase) -> str:
    """Return the kind that the name of a running load case says; empty where it says none."""
    kinds = named_kinds(case.name) if case.kind == "running" else []
    return kinds[0] if kinds else ""


def case_kinds(drive: Drive) -> Iterator[Check]:
    """Ask about each load case that is judged as running and is named as another kind."""
    for case in drive.load_cases:
        kind = named_kind(case)
        if not kind:
            continue
        place = Place(load_case=case.name)
        yield Check(
            name=CASE_KIND.name,
            title="Kind of load case",
            noun="kind of load case",
            level=CASE_KIND.missed,
            place=place,
            is_placed=False,
            source="name and kind of the load case, as given",
            label="kind of load case",
            headline=f"Load case {escaped(str(place))} is judged as running",
            action=f'Set kind = "{kind}" in load case {escaped(str(place))}.',
            full=f"Its name says {kind}: safety factors and belt ratings of running are compared.",
            binding=False,
        )
