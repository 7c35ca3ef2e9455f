"""Load cases whose name says that the belt starts or stops, and whose kind is running."""

from __future__ import annotations

from collections.abc import Iterator

from wraparc.checks.check import Check, Place, escaped
from wraparc.checks.rule import Rule
from wraparc.drive import Drive, LoadCase

CASE_KIND = Rule("case_kind", "the kind of a load case", binding=False)

#: Words of a name that say that the belt starts or stops, by the kind of such a load case.
_SAYS = {
    "starting": (
        "start", "starts", "starting", "startup", "restart", "restarting", "acceleration",
        "accelerating",
    ),
    "braking": (
        "stop", "stops", "stopping", "estop", "brake", "brakes", "braking", "deceleration",
        "decelerating",
    ),
}  # fmt: skip
#: Words with which it runs nevertheless: held back all the time, before or after, or not at all.
_RUNS = (
    "running", "runs", "steady", "continuous", "downhill", "regenerative", "regenerating",
    "generating", "after", "before", "between", "no", "non", "not", "without", "released", "off",
)  # fmt: skip
_LETTERS = "abcdefghijklmnopqrstuvwxyz"


def named_kind(case: LoadCase) -> str:
    """Return the kind that the name of a running load case says; empty where it says none.

    Whole words count, of letters alone: ``start_full``, ``E-stop 2``, but no ``standstill``.
    """
    if case.kind != "running":
        return ""
    name = "".join([letter if letter in _LETTERS else " " for letter in case.name.lower()])
    words = name.split()
    if any(word in _RUNS for word in words):
        return ""
    for kind, says in _SAYS.items():
        if any(word in says for word in words):
            return kind
    return ""


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
            action=f'Set kind = "{kind}".',
            full=f"Its name says {kind}: safety factors and belt ratings of running are compared.",
            binding=False,
        )
