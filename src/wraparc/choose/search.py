"""What is searched: candidates, limits, load cases and conditions of one pulley."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike

from wraparc.arc.wrap_arc import of_belt
from wraparc.arrays import Array, Integers
from wraparc.batch.arcs import Arcs, arcs_of_table
from wraparc.checks.least_tension import taut
from wraparc.choose.cost import Costing, price_problems
from wraparc.drive import Belt, Drive, Lagging, LoadCase, Pulley, Sag, Tensions
from wraparc.drive.conditions import DRY, Condition
from wraparc.drive.criteria import is_wet
from wraparc.drive.drive import covered_problems
from wraparc.drive.pitch import centrifugal_of, pitch_offset
from wraparc.errors import InputError, Problem
from wraparc.friction import FrictionLaw
from wraparc.train import Train
from wraparc.units import display

#: Most designs of one search.
MOST_DESIGNS = 2_000_000


#: Checks of what the rating of a belt allows.
RATING = ("belt_tension", "momentary_tension", "belt_safety")


@dataclass(frozen=True, kw_only=True)
class Limits:
    """What a design must pass by other numbers than those of its drive, or need not pass.

    Attributes
    ----------
    creep
        Largest creep at the exit [m], or None for that of the drive.
    bond_stress
        Largest shear stress at the bond of the lagging [Pa], or None for that of the lagging.
    gross_slip_safety
        Least safety factor against gross slip [-], or None for those of the drive.
    creep_limit_margin, tested_slip_margin
        Least margins to these capacities [-], or None.
    tested_pressure
        Whether wrap pressures must lie in the range the lagging was tested in.
    rating
        Tension allowed as a multiple of the belt rating by load case, as in the drive where not
        named [-]; None to leave the rating out.
    least_pulley_diameter
        Whether the least pulley diameter of the belt must be kept.
    sag
        Sag of the slack belt between idlers, or None for that of the drive.
    """

    creep: float | None = None
    bond_stress: float | None = None
    gross_slip_safety: float | None = None
    creep_limit_margin: float | None = None
    tested_slip_margin: float | None = None
    tested_pressure: bool = True
    rating: Mapping[str, float] | None = field(default_factory=dict, hash=False)
    least_pulley_diameter: bool = True
    sag: Sag | None = None

    @property
    def left_out(self) -> frozenset[str]:
        """Names of the checks that no design must pass."""
        rating = () if self.rating is not None else RATING
        pressure = () if self.tested_pressure else ("tested_pressure_max", "tested_pressure_min")
        diameter = () if self.least_pulley_diameter else ("pulley_diameter",)
        return frozenset((*rating, *pressure, *diameter))

    @property
    def stated(self) -> frozenset[str]:
        """Names of the checks that have another limit than in the drive, or none."""
        own = {
            "creep": self.creep is not None,
            "bond_stress": self.bond_stress is not None,
            "gross_slip": self.gross_slip_safety is not None,
            "sag": self.sag is not None,
            **dict.fromkeys(RATING, bool(self.rating)),
        }
        return self.left_out | {name for name, other in own.items() if other}

    @property
    def needs_capacities(self) -> bool:
        """Whether a margin to a capacity is limited."""
        return self.creep_limit_margin is not None or self.tested_slip_margin is not None


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
    train
        What `drive` is of: the load of what is recommended divides anew by it.

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
    train: Train | None = None

    def __post_init__(self) -> None:
        problems = price_problems(self.costing, [b.name for b in self.belts])
        if self.costing.tariff and any(b.speed is None for b in self.belts):
            message = "needed to price the energy lost to creep"
            problems.append(
                Problem(key="belt.speed", message=message, remedy="Add it to the drive file.")
            )
        problems += self._pushed()
        problems += covered_problems(self.drive.criteria, (c.name for c in self.conditions), ())
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
                    message=f"leaves {display(left, 'force')} in load case {slackest}",
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
    def unpriced(self) -> dict[str, str]:
        """Laggings without a price in the currency, and in which they are priced.

        Where there is one, no lagging is in the costs: sums of some parts tell nothing.
        """
        return self.costing.unpriced(lagging.name for lagging in self.laggings)

    @property
    def is_wet(self) -> bool:
        """Whether one of the conditions is wet."""
        return any(is_wet(condition.name) for condition in self.conditions)

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
    """

    search: Search
    places: Integers
    thickness: Array
    diameter: Array
    wrap_angle: Array
    slack: Array

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
        """Entry and exit tension of every pulley of every design, (pulleys, n) each [N]."""
        end, own = self.search.drive.take_up_tension(case), np.isnan(self.slack)
        pairs = [case.tensions[p.name] for p in self.search.drive.pulleys]
        entry = np.stack([np.where(own, t.entry, self.slack + (t.entry - end)) for t in pairs])
        leaving = np.stack([np.where(own, t.exit, self.slack + (t.exit - end)) for t in pairs])
        return entry, leaving

    def index(self, pulley: str) -> int:
        """Place of a pulley among those of the drive."""
        return [p.name for p in self.search.drive.pulleys].index(pulley)

    def ends(self, case: LoadCase) -> tuple[Array, Array]:
        """Tension at the take-up of the whole drive, and the largest at any pulley [N]."""
        end = self.search.drive.take_up_tension(case)
        most = max(max(t.entry, t.exit) for t in case.tensions.values())
        own = np.isnan(self.slack)
        slack = np.where(own, end, self.slack)
        return slack, np.where(own, most, slack + (most - end))

    def drive(self, design: int, condition: int = 0) -> Drive:
        """Return the drive of one design in a condition.

        The other pulleys are as they are, and pull as they do. Where a condition of the search is
        wet, wet is not estimated from dry friction too.
        """
        s, i = self.search, design
        lagging = s.conditions[condition].lagging(s.laggings[int(self.places[0, i])])
        pulley = replace(
            s.base, lagging=lagging.with_thickness(float(self.thickness[i])), conditions=(),
            diameter=float(self.diameter[i]), wrap_angle=float(self.wrap_angle[i]),
        )  # fmt: skip
        cases = []
        for case in s.drive.load_cases:
            ends = zip(
                s.drive.pulleys, *(t[:, i].tolist() for t in self.tensions(case)), strict=True
            )
            pairs = {p.name: Tensions(entry=entry, exit=leaving) for p, entry, leaving in ends}
            cases.append(replace(case, condition="", tensions=pairs))
        conveyor, held, criteria = s.drive.conveyor, float(self.slack[i]), s.drive.criteria
        if conveyor is not None and not np.isnan(held):
            conveyor = replace(conveyor, take_up_tension=held, counterweight=None)
        pulleys = tuple(pulley if p.name == s.pulley else p for p in s.drive.pulleys)
        laggings = (lag for p in pulleys for lag in (p.lagging, *p.conditions))
        if s.is_wet and not any(is_wet(lag.condition) for lag in laggings):
            criteria = replace(criteria, covered=True)
        return replace(
            s.drive, belt=s.belts[int(self.places[2, i])], pulleys=pulleys,
            load_cases=tuple(cases), conveyor=conveyor, criteria=criteria,
        )  # fmt: skip

    def described(self, condition: int) -> tuple[list[Drive], Integers]:
        """Return the drives that differ in lagging or belt, and which each design is, (n,)."""
        key = self.places[0] * len(self.search.belts) + self.places[2]
        _, first, which = np.unique(key, return_index=True, return_inverse=True)
        drives = [self.drive(int(i), condition) for i in first]
        sag = self.search.limits.sag
        if sag is not None:
            drives = [replace(d, criteria=replace(d.criteria, sag=sag)) for d in drives]
        return drives, np.ravel(which)

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
        return self._of_belts(lambda belt, law: pitch_offset(belt, self.search.base.side) or 0.0)

    def arcs(self, case: LoadCase, condition: int) -> Arcs:
        """Return the arcs of the pulley of every design in one load case and condition."""
        s = self.search
        columns: dict[str, ArrayLike] = {
            "lagging": self.places[0] + condition * len(s.laggings),
            "diameter": self.diameter,
            "wrap_angle": self.wrap_angle,
            "lagging_thickness": self.thickness,
            "compression_modulus": self._compression_modulus(),
            "creep_limit": s.creep_limit,
            "pitch_offset": self.offset,
            "cover_compliance": self._of_belts(
                lambda belt, law: of_belt(belt, s.base.side, law)["cover_compliance"]
            ),
        }
        return self._arcs(s.base, case, columns, s.conditioned())

    def arcs_beside(self, pulley: Pulley, case: LoadCase) -> Arcs:
        """Return the arcs of another pulley, which is as it is in every design."""
        drive, law = self.search.drive, pulley.lagging.law
        columns: dict[str, ArrayLike] = {
            "diameter": pulley.diameter,
            "wrap_angle": pulley.wrap_angle,
            "creep_limit": drive.creep_limit_of(pulley),
            "pitch_offset": self._of_belts(lambda belt, _: pitch_offset(belt, pulley.side) or 0.0),
            "cover_compliance": self._of_belts(
                lambda belt, _: of_belt(belt, pulley.side, law)["cover_compliance"]
            ),
        }
        return self._arcs(pulley, case, columns, (pulley.lagging,))

    def _arcs(
        self,
        pulley: Pulley,
        case: LoadCase,
        columns: Mapping[str, ArrayLike],
        laggings: Sequence[Lagging],
    ) -> Arcs:
        """Return arcs of a pulley of every design, with what belt and tensions say of them."""
        s, at = self.search, self.index(pulley.name)
        entry, leaving = self.tensions(case)
        speed = np.array([np.nan if b.speed is None else b.speed for b in s.belts])
        table = {
            **columns,
            "entry_tension": entry[at],
            "exit_tension": leaving[at],
            "belt_width": s.drive.belt.width,
            "belt_modulus": np.array([b.modulus for b in s.belts])[self.places[2]],
            "belt_speed": speed[self.places[2]],
            "overrun": np.nan if pulley.overrun is None else pulley.overrun,
            "recovery": float(pulley.recovery),
            "centrifugal_force": self._of_belts(lambda belt, law: centrifugal_of(belt)),
        }
        return arcs_of_table(table, laggings)
