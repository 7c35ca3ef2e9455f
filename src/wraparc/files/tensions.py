"""Tensions at the pulleys from any two of the quantities that fix them."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from wraparc.drive import Tensions
from wraparc.drive.load_case import pull_of_power, pull_of_torque
from wraparc.errors import InputError
from wraparc.schema.problems import Place, Report
from wraparc.schema.tables import Record
from wraparc.units import display

ENTRY, EXIT = "entry_tension", "exit_tension"
#: Keys that all fix the effective tension.
EFFECTIVE = ("effective_tension", "torque", "power")
KEYS = (ENTRY, EXIT, *EFFECTIVE)

_PAIR = "entry_tension, exit_tension and one of effective_tension, torque, power"


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
        What is given by key [SI].
    raw
        The table as the user wrote it.
    diameter
        Diameter of the pulley [m], or None if it could not be read.
    inherited
        Keys that a load case takes over from its pulley.
    """

    name: str
    place: Place
    values: Mapping[str, float]
    raw: Mapping[str, object]
    diameter: float | None
    inherited: tuple[str, ...] = ()

    @classmethod
    def of(cls, name: str, record: Record, diameter: float | None) -> "Given":
        """Return what a table of a file gives."""
        values = {key: record[key] for key in KEYS if key in record}
        return cls(name, record.place, values, record.raw, diameter)

    def overridden(
        self,
        record: Record,
        *,
        fixed: bool = False,
        speed: float | None = None,
        runs: tuple[float, float] = (0.0, 0.0),
    ) -> "Given":
        """Return these tensions with those of a load case put over them.

        Two independent quantities replace all; a single one replaces its own kind. A pull alone
        takes the exit tension with it, or under a fixed take-up the sum of both tensions; where
        that sum is not known it is not enough.

        Parameters
        ----------
        record
            What the load case gives.
        fixed
            Whether the take-up holds the sum of both tensions.
        speed
            Belt speed [m/s], or None.
        runs
            What of the pull the belt gains between the pulleys, here and in the load case [N].
        """
        over = Given.of(self.name, record, self.diameter)
        if len(over.families) >= 2:
            return over
        pull = over.pull(speed)
        if fixed and pull is not None and len(over.effective) == 1:
            entry, exit_ = spread([less_runs(self, runs[0], speed)], speed)[0]
            if entry is None or exit_ is None:
                return over
            half, between = 0.5 * (entry + exit_), 0.5 * (pull - runs[1])
            both = {ENTRY: half + between, EXIT: half - between}
            return Given(self.name, over.place, both, over.raw, self.diameter)
        replaced = {*over.values, *(EFFECTIVE if over.effective else ())}
        kept = {key: value for key, value in self.values.items() if key not in replaced}
        return Given(
            self.name, over.place, kept | dict(over.values), over.raw, self.diameter, tuple(kept)
        )

    @cached_property
    def effective(self) -> tuple[str, ...]:
        """The keys given that fix the effective tension."""
        return tuple(key for key in EFFECTIVE if key in self.values)

    @cached_property
    def families(self) -> tuple[str, ...]:
        """One key for each independent quantity given."""
        return (*(key for key in (ENTRY, EXIT) if key in self.values), *self.effective[:1])

    def pull(self, speed: float | None) -> float | None:
        """Return the effective tension [N], or None if it is not given or not computable."""
        for key in self.effective:
            value = self.values[key]
            if key == "effective_tension":
                return value
            if key == "torque":
                return None if self.diameter is None else pull_of_torque(value, self.diameter)
            return None if speed is None else pull_of_power(value, speed)
        return None


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
    fixed = [_contradiction(item, speed, report) for item in given]
    if any(fixed):
        return {}
    if sure and speed is None:
        for item in (item for item in given if item.effective == ("power",)):
            place = item.place if "power" in item.inherited else (*item.place, "power")
            remedy = 'Write speed = "3 m/s" in [belt], or give effective_tension.'
            report.add(place, "power needs the belt speed", remedy)
            sure = False
    if any(item.effective == ("torque",) and item.diameter is None for item in given):
        sure = False  # it is the diameter that is missing
    tensions = {}
    for item, (entry, exit_) in zip(given, spread(given, speed), strict=True):
        if entry is None or exit_ is None:
            if sure:
                report.add(item.place, _missing(item), f"Give two of {_PAIR}.")
        elif made := _made(item, entry, exit_, report):
            tensions[item.name] = made
    return tensions


def complete(given: Sequence[Given], speed: float | None) -> bool:
    """Whether all tensions follow from what is given."""
    return all(None not in pair for pair in spread(given, speed))


def less_runs(given: Given, runs: float, speed: float | None) -> Given:
    """Return what is given with the pull between the outer tensions: that of the pulleys less runs.

    What the pulleys pull together is entry less exit tension and what the runs between them add.
    """
    pull = given.pull(speed)
    if runs == 0.0 or pull is None:
        return given
    kept = {key: value for key, value in given.values.items() if key not in given.effective}
    return replace(given, values={**kept, "effective_tension": pull - runs})


Pair = tuple[float | None, float | None]


def spread(given: Sequence[Given], speed: float | None) -> list[Pair]:
    """Return entry and exit tensions as far as pulls and neighbours give them.

    Only adds, subtracts, multiplies and divides: arrays of numbers will do as well.
    """
    pairs: list[Pair] = [(item.values.get(ENTRY), item.values.get(EXIT)) for item in given]
    pulls = [item.pull(speed) for item in given]
    for _ in range(2 * len(pairs)):
        for i, pull in enumerate(pulls):
            entry, exit_ = _filled(pairs[i], pull)
            if entry is None and i > 0:
                entry, exit_ = _filled((pairs[i - 1][1], exit_), pull)
            if exit_ is None and i + 1 < len(pairs):
                entry, exit_ = _filled((entry, pairs[i + 1][0]), pull)
            pairs[i] = entry, exit_
    return pairs


def _filled(pair: Pair, pull: float | None) -> Pair:
    entry, exit_ = pair
    if pull is not None and exit_ is None and entry is not None:
        exit_ = entry - pull
    elif pull is not None and entry is None and exit_ is not None:
        entry = exit_ + pull
    return entry, exit_


def _contradiction(item: Given, speed: float | None, report: Report) -> bool:
    """Report more than two independent quantities, or the same one twice."""
    remedy = "Leave one of them out."
    if len(item.effective) > 1:
        message = f"{_listed(item.effective)} each fix the effective tension"
        report.add(item.place, message, remedy)
        return True
    if len(item.families) < 3:
        return False
    pull = item.pull(speed)
    message = f"{_listed(item.families)} are given, and two of them fix the third"
    between = item.values[ENTRY] - item.values[EXIT]
    if pull is not None and abs(pull - between) > 1e-6 * abs(between):
        message = (
            f"{_listed(item.families)} contradict each other: entry less exit tension is "
            f"{display(between, 'force')}, {item.effective[0]} makes {display(pull, 'force')}"
        )
    if item.inherited:
        remedy = "Give two of them in the load case: they replace those of the pulley."
    report.add(item.place, message, remedy)
    return True


def _missing(item: Given) -> str:
    if not item.families:
        return "no tensions are given"
    return f"only {item.families[0]} is given, and it takes two quantities to fix the tensions"


_SIDES = {"entry": ENTRY, "exit": EXIT}


def _made(item: Given, entry: float, exit_: float, report: Report) -> Tensions | None:
    try:
        told = " and ".join(
            f"{key.replace('_', ' ')} {item.raw.get(key, '')}".strip() for key in item.effective
        )
        why = f"computed from {told}" if told else "that of the neighbouring pulley"
        made = {key: why for key, name in _SIDES.items() if name not in item.values}
        return Tensions(entry=entry, exit=exit_, computed=made)
    except InputError:
        side, tension = ("exit", exit_) if exit_ <= 0.0 else ("entry", entry)
        key = next((k for k in item.effective if k not in item.inherited), "")
        place = (*item.place, key) if key else item.place
        what = "a belt cannot push" if tension <= 0.0 else "no belt carries that"
        message = f"leaves an {side} tension of {display(tension, 'force')}, and {what}"
        remedy = "Give a smaller pull or a larger tension on the slack side."
        report.add(place, message, remedy, *([item.raw[key]] if key else []))
        return None


def _listed(keys: Iterable[str]) -> str:
    *most, last = keys
    return f"{', '.join(most)} and {last}"
