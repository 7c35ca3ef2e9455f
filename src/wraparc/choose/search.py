"""What is searched: candidates, limits, load cases and conditions of one pulley."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from wraparc.arc.wrap_arc import of_belt
from wraparc.arrays import Array, Integers
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.checks.least_tension import taut
from wraparc.choose.cost import Costing, price_problems
from wraparc.drive import Belt, Drive, Lagging, LoadCase, Pulley, Sag, Tensions
from wraparc.drive.conditions import DRY, Condition
from wraparc.drive.pitch import centrifugal_of, pitch_offset
from wraparc.errors import InputError, Problem
from wraparc.friction import FrictionLaw
from wraparc.units import display

#: Most designs of one search.
MOST_DESIGNS = 2_000_000


@dataclass(frozen=True, kw_only=True)
class Limits:
    """What a design must keep, in every load case and condition.

    Attributes
    ----------
    creep
        Largest creep at the exit [m], or None for that of the drive.
    bond_stress
        Largest shear stress at the bond of the lagging [Pa], or None.
    creep_limit_margin, tested_slip_margin, gross_slip_margin
        Least margins to the three capacities [-], or None.
    tested_pressure
        Whether wrap pressures must lie in the range the lagging was tested in.
    rating
        Tension allowed as a multiple of the belt rating by load case, 1 where not named [-];
        None to leave the rating out.
    least_pulley_diameter
        Whether the least pulley diameter of the belt must be kept.
    sag
        Sag of the slack belt between idlers, or None to leave it out.
    """

    creep: float | None = None
    bond_stress: float | None = None
    creep_limit_margin: float | None = None
    tested_slip_margin: float | None = None
    gross_slip_margin: float | None = None
    tested_pressure: bool = True
    rating: Mapping[str, float] | None = field(default_factory=dict, hash=False)
    least_pulley_diameter: bool = True
    sag: Sag | None = None

    @property
    def needs_capacities(self) -> bool:
        """Whether a margin is limited."""
        margins = (self.creep_limit_margin, self.tested_slip_margin, self.gross_slip_margin)
        return any(m is not None for m in margins)


@dataclass(frozen=True, kw_only=True)
class Search:
    """Designs of one pulley of a drive: every combination of the candidates.

    Attributes
    ----------
    drive, pulley
        The drive and the name of the pulley; other pulleys stay as they are, and pull as they do.
    laggings, belts
        Candidates.
    thicknesses
        Thicknesses of the lagging [m]; empty for each lagging's own.
    diameters, wrap_angles
        Over the lagging [m] and [rad].
    slack_tensions
        Tensions at the take-up (`Drive.take_up_tension`): of the slack side behind the drives, or
        where it stands; the same in every load case [N]. None for the tensions of the load cases,
        empty for the least that each design can do with.
    conditions
        States in which every limit must hold.
    limits, costing
        What must be kept, and how it is priced.
    title
        What is decided.

    Raises
    ------
    InputError
        With every candidate that cannot be priced, and if there are too many designs.
    """

    drive: Drive
    pulley: str
    laggings: tuple[Lagging, ...]
    belts: tuple[Belt, ...]
    thicknesses: tuple[float, ...] = ()
    diameters: tuple[float, ...]
    wrap_angles: tuple[float, ...]
    slack_tensions: tuple[float, ...] | None = None
    conditions: tuple[Condition, ...] = (Condition(name=DRY),)
    limits: Limits = field(default_factory=Limits)
    costing: Costing
    title: str = ""

    def __post_init__(self) -> None:
        problems = price_problems(
            self.costing, [lag.name for lag in self.laggings], [b.name for b in self.belts]
        )
        if self.costing.tariff and any(b.speed is None for b in self.belts):
            message = "needed to price the energy lost to creep"
            problems.append(
                Problem(key="belt.speed", message=message, remedy="Add it to the drive file.")
            )
        problems += self._pushed()
        if len(self) > MOST_DESIGNS:
            problems.append(
                Problem(
                    key="candidates",
                    value=f"{len(self)} designs",
                    message=f"more than {MOST_DESIGNS}",
                    remedy="Search a coarser grid first.",
                )
            )
        if problems:
            raise InputError(problems)

    def _pushed(self) -> Iterator[Problem]:
        """Yield what tensions at the take-up leave a belt that would have to push."""
        drive, beyond = self.drive, {}
        for case in drive.load_cases:
            own = min(min(t.entry, t.exit) for t in case.tensions.values())
            beyond[case.name] = own - drive.take_up_tension(case)
        if drive.conveyor is not None:
            ends = taut(drive.conveyor)
            beyond[ends.place.load_case] = -ends.tension
        slackest = min(beyond, key=lambda name: beyond[name])
        for tension in self.slack_tensions or ():
            left = tension + beyond[slackest]
            if left <= 0.0:
                yield Problem(
                    key="candidates.slack_tensions",
                    value=display(tension, "force"),
                    message=f"leaves a belt tension of {display(left, 'force')} in load case "
                    f"{slackest}, and a belt cannot push",
                    remedy="Give a larger tension.",
                )

    @property
    def shape(self) -> tuple[int, ...]:
        """Candidates by kind: lagging, thickness, belt, diameter, wrap angle, slack tension."""
        return (
            len(self.laggings),
            max(1, len(self.thicknesses)),
            len(self.belts),
            len(self.diameters),
            len(self.wrap_angles),
            max(1, len(self.slack_tensions or ())),
        )

    def __len__(self) -> int:
        return int(np.prod(self.shape, dtype=np.int64))

    @property
    def least_slack(self) -> bool:
        """Whether every design gets the least slack-side tension it can do with."""
        return self.slack_tensions == ()

    @property
    def creep_limit(self) -> float:
        """Creep that is accepted [m]."""
        if self.limits.creep is not None:
            return self.limits.creep
        return self.drive.creep_limit_of(self.base)

    @property
    def base(self) -> Pulley:
        """The pulley as it is in the drive."""
        return self.drive.pulley(self.pulley)

    def pulls(self) -> Array:
        """T1 - T2 by load case [N]."""
        return np.array([c.tensions[self.pulley].effective for c in self.drive.load_cases])

    def conditioned(self) -> tuple[Lagging, ...]:
        """Every lagging in every condition, condition by condition."""
        return tuple(c.lagging(lag) for c in self.conditions for lag in self.laggings)


@dataclass(frozen=True, eq=False)
class Grid:
    """The designs of a search by number: places of their candidates and their values.

    Attributes
    ----------
    places
        Place of each design in the lists of candidates, shape (6, n).
    thickness, diameter, wrap_angle, slack
        Values [m, m, rad, N]; slack is that at the take-up, nan where the load cases have their
        own.
    others
        Tension at the take-up that the other pulleys ask for [N].
    """

    search: Search
    places: Integers
    thickness: Array
    diameter: Array
    wrap_angle: Array
    slack: Array
    others: float = 0.0

    @classmethod
    def of(cls, search: Search) -> Grid:
        """Return the designs in the order of the candidates, the last kind counting fastest."""
        n = len(search)
        places = np.stack(np.unravel_index(np.arange(n), search.shape)).astype(np.int64)
        own = np.array([lag.thickness for lag in search.laggings])
        thick = np.array(search.thicknesses)[places[1]] if search.thicknesses else own[places[0]]
        tensions = search.slack_tensions
        slack = np.array(tensions)[places[5]] if tensions else np.full(n, np.nan)
        return cls(
            search,
            places,
            thick,
            np.array(search.diameters)[places[3]],
            np.array(search.wrap_angles)[places[4]],
            slack,
        )

    def __len__(self) -> int:
        return len(self.thickness)

    def with_slack(self, slack: Array) -> Grid:
        """Return the same designs at other tensions of the take-up."""
        return replace(self, slack=slack)

    def tensions(self, case: LoadCase) -> tuple[Array, Array]:
        """Entry and exit tension of every design in a load case [N]."""
        t = case.tensions[self.search.pulley]
        end, own = self.search.drive.take_up_tension(case), np.isnan(self.slack)
        exit_side = np.where(own, t.exit, self.slack + (t.exit - end))
        entry_side = np.where(own, t.entry, self.slack + (t.entry - end))
        return entry_side, exit_side

    def ends(self, case: LoadCase) -> tuple[Array, Array]:
        """Tension at the take-up of the whole drive, and the largest at any pulley [N]."""
        end = self.search.drive.take_up_tension(case)
        most = max(max(t.entry, t.exit) for t in case.tensions.values())
        own = np.isnan(self.slack)
        slack = np.where(own, end, self.slack)
        return slack, np.where(own, most, slack + (most - end))

    def drive(self, design: int, condition: int = 0) -> Drive:
        """Return one design as a drive of its pulley alone, in a condition."""
        s, i = self.search, design
        lagging = s.conditions[condition].lagging(s.laggings[int(self.places[0, i])])
        pulley = replace(
            s.base, lagging=lagging.with_thickness(float(self.thickness[i])), conditions=(),
            diameter=float(self.diameter[i]), wrap_angle=float(self.wrap_angle[i]),
        )  # fmt: skip
        cases = []
        for case in s.drive.load_cases:
            entry, leaving = (float(tension[i]) for tension in self.tensions(case))
            pair = {pulley.name: Tensions(entry=entry, exit=leaving)}
            cases.append(replace(case, condition="", tensions=pair))
        belt, criteria = s.belts[int(self.places[2, i])], s.drive.criteria
        alone = replace(criteria, take_up=replace(criteria.take_up, after=""))
        conveyor, held = s.drive.conveyor, float(self.slack[i])
        if conveyor is not None and not np.isnan(held):
            conveyor = replace(conveyor, take_up_tension=held, counterweight=None)
        return replace(
            s.drive, belt=belt, pulleys=(pulley,), load_cases=tuple(cases), criteria=alone,
            conveyor=conveyor,
        )  # fmt: skip

    def whole(self, design: int, condition: int = 0) -> Drive:
        """Return one design in its drive: other pulleys as they are, and pulling as they do."""
        alone, of = self.drive(design, condition), self.search
        cases = []
        for case, own in zip(of.drive.load_cases, alone.load_cases, strict=True):
            rise = own.tensions[of.pulley].exit - case.tensions[of.pulley].exit
            ends = {
                name: Tensions(entry=t.entry + rise, exit=t.exit + rise)
                for name, t in case.tensions.items()
            }
            cases.append(replace(own, tensions=ends))
        pulleys = (alone.pulleys[0] if p.name == of.pulley else p for p in of.drive.pulleys)
        return replace(
            alone, pulleys=tuple(pulleys), load_cases=tuple(cases), criteria=of.drive.criteria
        )

    def _compression_modulus(self) -> Array:
        """E_c of every design, by the shape of its blocks at its thickness [Pa]."""
        search = self.search
        table: list[Array] = [
            lagging.compression_modulus_at(np.array(search.thicknesses or (lagging.thickness,)))
            for lagging in search.laggings
        ]
        moduli: Array = np.stack(table)[self.places[0], self.places[1]]
        return moduli

    def _of_belts(self, of: Callable[[Belt, FrictionLaw], float]) -> Array:
        """A number of every design by its belt and its law."""
        s = self.search
        table = np.array([[of(b, lagging.law) for b in s.belts] for lagging in s.laggings])
        return np.asarray(table[self.places[0], self.places[2]])

    @property
    def offset(self) -> Array:
        """E of every design, 0 where its belt is not known that well [m]."""
        side = self.search.base.side
        return self._of_belts(lambda belt, law: pitch_offset(belt, side) or 0.0)

    def arcs(self, case: LoadCase, condition: int) -> Arcs:
        """Return the arcs of every design in one load case and condition."""
        s = self.search
        entry, leaving = self.tensions(case)
        base = s.base
        modulus = np.array([b.modulus for b in s.belts])[self.places[2]]
        speed = np.array([np.nan if b.speed is None else b.speed for b in s.belts])
        columns = {
            "lagging": self.places[0] + condition * len(s.laggings),
            "entry_tension": entry,
            "exit_tension": leaving,
            "diameter": self.diameter,
            "wrap_angle": self.wrap_angle,
            "lagging_thickness": self.thickness,
            "compression_modulus": self._compression_modulus(),
            "belt_width": s.drive.belt.width,
            "belt_modulus": modulus,
            "creep_limit": s.creep_limit,
            "belt_speed": speed[self.places[2]],
            "overrun": np.nan if base.overrun is None else base.overrun,
            "recovery": float(base.recovery),
            "pitch_offset": self.offset,
            "cover_compliance": self._of_belts(
                lambda belt, law: of_belt(belt, base.side, law)["cover_compliance"]
            ),
            "centrifugal_force": self._of_belts(lambda belt, law: centrifugal_of(belt)),
        }
        return arcs_of_table(columns, s.conditioned())
