"""Tensions at the pulleys from what a file gives, by the rules of `drive.tension_rules`."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from wraparc.drive import Tensions, tension_rules
from wraparc.drive.tension_rules import DrumAt, LoadFault, LoadGiven, NipTensions, RunsGain
from wraparc.errors import InputError
from wraparc.schema.problems import Place, Report
from wraparc.schema.tables import Record
from wraparc.schema.uncertain import UNCERTAINTY
from wraparc.units import display

KEYS = LoadGiven._fields
ENTRY, EXIT = KEYS[:2]
NO_RUNS = RunsGain()


@dataclass(frozen=True)
class Given:
    """What is given of the tensions of one pulley in one load case.

    Parameters
    ----------
    name
        The pulley.
    place
        Where the table stands in the file.
    values
        What is given [SI].
    raw
        The table as the user wrote it.
    diameter
        Diameter of the pulley [m], or None if it could not be read.
    inherited
        Keys that a load case takes over from its pulley.
    """

    name: str
    place: Place
    values: LoadGiven
    raw: Mapping[str, object]
    diameter: float | None
    inherited: tuple[str, ...] = ()

    @classmethod
    def of(cls, name: str, record: Record, diameter: float | None) -> "Given":
        """Return what a table of a file gives."""
        values = LoadGiven(*(record.get(key) for key in KEYS))
        return cls(name, record.place, values, record.raw, diameter)

    def at(self, speed: float | None) -> DrumAt:
        """Return what turns torques and powers into pulls, at a belt speed [m/s] or None."""
        return DrumAt(self.diameter, speed)

    def overridden(
        self,
        record: Record,
        *,
        fixed: bool = False,
        speed: float | None = None,
        runs: RunsGain = NO_RUNS,
    ) -> "Given":
        """Return these tensions with those of a load case put over them.

        See `drive.tension_rules.overridden`.
        """
        over = Given.of(self.name, record, self.diameter)
        values = tension_rules.overridden(self.values, over.values, fixed, self.at(speed), runs)
        own = zip(KEYS, values, self.values, strict=True)
        kept = tuple(key for key, now, before in own if now is not None and now is before)
        return Given(self.name, over.place, values, over.raw, self.diameter, kept)

    def less_runs(self, runs: float, speed: float | None) -> "Given":
        """Return what is given with the pull between the outer tensions, without the runs' [N]."""
        return replace(self, values=tension_rules.less_runs(self.values, runs, self.at(speed)))


def report_uncertain_twice(record: Record, report: Report) -> None:
    """Report uncertainties of the tensions of pulleys beside those of all together."""
    for table in ("train", "conveyor"):
        every = record.get(table)
        if not isinstance(every, Record) or not every.get(UNCERTAINTY):
            continue
        for pulley in record.get("pulley") or ():
            if not isinstance(pulley, Record):
                continue
            given: Any = pulley.raw.get(UNCERTAINTY, {})
            for key in pulley.get(UNCERTAINTY, {}):
                if key in KEYS:
                    message = f"contradicts those of [{table}]"
                    place = (*pulley.place, UNCERTAINTY, key)
                    report.add(place, message, "Remove one of them.", given[key])


def resolve(
    given: Sequence[Given], speed: float | None, report: Report, *, sure: bool = True
) -> dict[str, Tensions]:
    """Return the tensions of every pulley; a pulley whose tensions are wrong is left out.

    Parameters
    ----------
    given
        What is given, in belt order. An entry tension that is not given is the exit
        tension of the pulley before, an exit tension the entry tension of the one after.
    speed
        Belt speed [m/s], or None.
    report
        Takes what is wrong.
    sure
        False if something could not be read, so that nothing may be called missing.
    """
    # what could not be read would have stood in the place of what is inherited
    wrong = [_wrong(item, speed, report) for item in given if sure or not item.inherited]
    if any(wrong):
        return {}
    for item in given if sure else ():
        fault = tension_rules.speed_missing(item.values, item.at(speed))
        if fault:
            place = item.place if fault.lacks in item.inherited else (*item.place, fault.lacks)
            report.add(place, fault.message, fault.remedy)
            sure = False
    if any(item.diameter is None and item.values.torque is not None for item in given):
        sure = False  # it is the diameter that is missing
    tensions = {}
    for item, (entry, exit_) in zip(given, spread(given, speed), strict=True):
        if entry is None or exit_ is None:
            if sure:
                fault = tension_rules.too_few(item.values)
                report.add(item.place, fault.message, fault.remedy, code="few_tensions")
        elif made := _made(item, entry, exit_, report):
            tensions[item.name] = made
    return tensions


def complete(given: Sequence[Given], speed: float | None) -> bool:
    """Whether all tensions follow from what is given."""
    return all(None not in pair for pair in spread(given, speed))


def spread(given: Sequence[Given], speed: float | None) -> list[NipTensions]:
    """Return entry and exit tensions as far as pulls and neighbours give them.

    Only adds, subtracts, multiplies and divides: arrays of numbers will do as well.
    """
    pairs = [NipTensions(item.values.entry_tension, item.values.exit_tension) for item in given]
    pulls = [tension_rules.pull_given(item.values, item.at(speed)) for item in given]
    for _ in range(2 * len(pairs)):
        for i, pull in enumerate(pulls):
            entry, leaving = tension_rules.filled(*pairs[i], pull)
            if entry is None and i > 0:
                entry, leaving = tension_rules.filled(pairs[i - 1].exit, leaving, pull)
            if leaving is None and i + 1 < len(pairs):
                entry, leaving = tension_rules.filled(entry, pairs[i + 1].entry, pull)
            pairs[i] = NipTensions(entry, leaving)
    return pairs


def _wrong(item: Given, speed: float | None, report: Report) -> LoadFault | None:
    """Report more than two independent quantities, or the same one twice."""
    fault = tension_rules.fault_of(item.values, bool(item.inherited), item.at(speed), _force)
    if fault:
        report.add(item.place, fault.message, fault.remedy)
    return fault


def _force(value: float) -> str:
    return display(value, "force")


_SIDES = {"entry": ENTRY, "exit": EXIT}


def _made(item: Given, entry: float, exit_: float, report: Report) -> Tensions | None:
    pulls = tension_rules.effective_keys(item.values)
    try:
        told = " and ".join(
            f"{key.replace('_', ' ')} {item.raw.get(key, '')}".strip() for key in pulls
        )
        why = f"computed from {told}" if told else "that of the neighbouring pulley"
        made = {key: why for key, name in _SIDES.items() if getattr(item.values, name) is None}
        return Tensions(entry=entry, exit=exit_, computed=made)
    except InputError:
        side, tension = ("exit", exit_) if exit_ <= 0.0 else ("entry", entry)
        key = next((k for k in pulls if k not in item.inherited), "")
        place = (*item.place, key) if key else item.place
        message = f"leaves an {side} tension of {display(tension, 'force')}"
        remedy = "Lower Te, or raise T2."
        report.add(place, message, remedy, *([item.raw[key]] if key else []))
        return None
