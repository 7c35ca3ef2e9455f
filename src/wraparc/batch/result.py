"""Results of many arcs by column."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from wraparc.arc import Status
from wraparc.arc.quantities import BREAKAWAY, REFUSED, SOLVED, UNSOLVED
from wraparc.arrays import Array, Flags, Integers
from wraparc.batch import row
from wraparc.batch.arcs import Arcs
from wraparc.batch.setting import Setting
from wraparc.errors import pandas
from wraparc.glossary import RENAMED

if TYPE_CHECKING:
    import pandas as pd


REFUSAL = (
    "The friction law is unfit for this arc: it falls so steeply past its peak, or the overrun is "
    "so large, that slip is not unique. Solve the arc alone to read which."
)
#: what each number of the column ``status`` says
STATUSES: Mapping[int, str] = {
    SOLVED: Status.SOLVED.value,
    BREAKAWAY: Status.BREAKAWAY.value,
    UNSOLVED: Status.UNSOLVED.value,
    REFUSED: REFUSAL,
}


@dataclass(frozen=True, eq=False, repr=False)
class BatchResult(Mapping[str, Array]):
    """What many arcs have to say, a column a quantity, shape (n,) each [SI].

    Columns have the names that `wraparc.arc.ArcResult.scalars` uses and are worked out when they
    are asked for. ``status`` is 0 solved, 1 breakaway, 2 unsolved, 3 refused, see `STATUSES`. What
    describes the operating point is nan where the arc is not solved; capacities and margins are
    there on a breakaway too. ``gross_slip_safety`` is the number of the check "Safety against gross
    slip"; the arcs are solved again for it.

    Attributes
    ----------
    arcs
        What was solved.
    found
        Rows of results, in the order of `row`, shape (n, 23).
    setting
        How accurately they were solved.
    friction_factor, slip_factor
        Factors on the friction and the slips of the laws, shape (n,); None for 1 [-].
    tight_rise, slack_rise
        Growth of the tight and the slack side per growth of the pull, shape (n,) [N]; None where
        the slack side is held, as by a gravity take-up behind one pulley.
    known
        What was worked out once, by name.
    """

    arcs: Arcs
    found: Array
    setting: Setting = Setting.ENGINEERING
    friction_factor: Array | None = None
    slip_factor: Array | None = None
    tight_rise: Array | None = None
    slack_rise: Array | None = None
    known: dict[str, Any] = field(default_factory=dict, init=False)

    def rows(self, which: Integers) -> BatchResult:
        """Return some of the arcs; what was worked out is left."""
        columns = ("friction_factor", "slip_factor", "tight_rise", "slack_rise")
        every = {name: getattr(self, name) for name in columns}
        some = {name: None if c is None else c[which] for name, c in every.items()}
        arcs, found = self.arcs.rows(which), self.found[which]
        return BatchResult(arcs, found, setting=self.setting, **some)

    def growing(self, tight_rise: Array, slack_rise: Array) -> BatchResult:
        """Return the same arcs with tensions that grow so with the pull [N]."""
        if self.tight_rise is tight_rise and self.slack_rise is slack_rise:
            return self
        return replace(self, tight_rise=tight_rise, slack_rise=slack_rise)

    def __getitem__(self, name: str) -> Array:
        if name in RENAMED:
            raise KeyError(RENAMED[name])
        column: Array = COLUMNS[name](self)
        return column

    def __iter__(self) -> Iterator[str]:
        return iter(COLUMNS)

    def __len__(self) -> int:
        return len(COLUMNS)

    def __repr__(self) -> str:
        counts = np.bincount(self.found[:, row.OUTCOME].astype(int), minlength=len(STATUSES))
        parts = zip(counts, ("solved", "breakaway", "unsolved", "refused"), strict=True)
        said = ", ".join(f"{count} {word}" for count, word in parts if count)
        return f"<BatchResult: {len(self.arcs)} arcs, {said}>"

    @property
    def solved(self) -> Flags:
        """Which arcs carry their load, shape (n,)."""
        flags: Flags = self.found[:, row.OUTCOME] == SOLVED
        return flags

    @property
    def breakaway(self) -> Flags:
        """Which arcs cannot, shape (n,)."""
        flags: Flags = self.found[:, row.OUTCOME] == BREAKAWAY
        return flags

    @property
    def largest_slip(self) -> Array:
        """Largest slip along each arc, shape (n,) [m]."""
        slip: Array = self.found[:, row.LARGEST_SLIP]
        return slip

    @property
    def slip_speed(self) -> Array:
        """Largest speed of the belt on the lagging, shape (n,) [m/s].

        Of laws without a tested slip speed a bound from below: at the points of a mesh.
        """
        shell = 1.0 + self.arcs.pitch_offset / (0.5 * self.arcs.diameter)  # runs by so much less
        speed: Array = self.arcs.belt_speed / shell * self.found[:, row.STEEPEST_SLIP]
        return speed

    def to_frame(self) -> pd.DataFrame:
        """Return the columns as a pandas DataFrame.

        Raises
        ------
        MissingExtraError
            If pandas is not installed.
        """
        frame: pd.DataFrame = pandas().DataFrame(dict(self))
        return frame


def _place(place: int) -> Callable[[BatchResult], Array]:
    return lambda r: r.found[:, place]


def _of_solved(formula: Callable[[Arcs], Array]) -> Callable[[BatchResult], Array]:
    """A column that follows from the given tensions, nan where they are not reached."""
    return lambda r: np.where(r.solved, formula(r.arcs), np.nan)


def _global(r: BatchResult) -> Array:
    return r["entry_creep_ratio"] * 0.5 * r.arcs.diameter * r.arcs.wrap_angle


def _recovery_share(r: BatchResult) -> tuple[Array, Array, Array]:
    """Share of the recovery in 1/EA', creep by what is distributed, and the overrun."""
    given = r.arcs.inputs()
    a = r.arcs
    pressure = (a.entry_tension - a.centrifugal_force) / (a.belt_width * 0.5 * a.diameter)
    overrun = given[:, 6] + given[:, 7] * pressure**1.5
    compliance = a.compliance
    share = np.divide(
        a.recovery_compliance, compliance, out=np.zeros_like(compliance), where=compliance > 0.0
    )
    return share, r["exit_creep"] - overrun - _global(r), overrun


def _shrinkage(r: BatchResult) -> Array:
    share, distributed, _ = _recovery_share(r)
    return (1.0 - share) * distributed


def _compression(r: BatchResult) -> Array:
    share, distributed, overrun = _recovery_share(r)
    return share * distributed + overrun


def _pull(arcs: Arcs) -> Array:
    return arcs.entry_tension - arcs.exit_tension


def _log_actual(arcs: Arcs) -> Array:
    return np.abs(np.log(arcs.entry_tension / arcs.exit_tension))


def _shear_energy(r: BatchResult) -> Array:
    """Shear energy given up at the exit, per area and pass [J/m2]."""
    leaving, entering = r.found[:, row.EXIT_STRESS], r.found[:, row.ENTRY_STRESS]
    return 0.5 * r.arcs.shear_compliance * (leaving**2 - entering**2)


def _surface_speed(r: BatchResult) -> Array:
    g = r["entry_creep_ratio"]
    return np.where(g < 1.0, r.arcs.belt_speed / np.where(g < 1.0, 1.0 - g, 1.0), np.nan)


def _efficiency(r: BatchResult) -> Array:
    pull = _pull(r.arcs)
    loaded = np.abs(pull) > 1e-6 * r.arcs.entry_tension
    loss = r.arcs.traction_width * (r.found[:, row.WORK] + _shear_energy(r))
    part = loss / np.where(loaded, np.abs(pull), np.nan)
    return np.where(pull > 0.0, 1.0 - part, 1.0 / (1.0 + part))


def _power(energy: Callable[[BatchResult], Array]) -> Callable[[BatchResult], Array]:
    """Power of an energy per area and pass [J/m2]."""
    return lambda r: _surface_speed(r) * r.arcs.traction_width * energy(r)


def _carried(r: BatchResult, place: int) -> Array:
    """Ln of a capacity, tight over slack side, by that of the tensions above m v^2."""
    carried, lift = r.found[:, place], r.arcs.centrifugal_force
    tight = np.maximum(r.arcs.entry_tension, r.arcs.exit_tension)
    with np.errstate(all="ignore"):
        heavy = -np.log((1.0 - lift / tight) * np.exp(-carried) + lift / tight)
    return np.where(lift == 0.0, carried, heavy)


def _ratio(place: int) -> Callable[[BatchResult], Array]:
    return lambda r: np.exp(_carried(r, place))


def _margin(place: int) -> Callable[[BatchResult], Array]:
    return lambda r: np.exp(_carried(r, place) - _log_actual(r.arcs))


def _resultant(arcs: Arcs) -> tuple[Array, Array]:
    """Resultant of the tensions across and along the line of the entry, `drive.resultant` [N]."""
    leaving, wrap = arcs.exit_tension, arcs.wrap_angle
    return leaving * np.sin(wrap), arcs.entry_tension - leaving * np.cos(wrap)


COLUMNS: dict[str, Callable[[BatchResult], Any]] = {
    "status": lambda r: r.found[:, row.OUTCOME].astype(np.int8),
    "entry_tension": lambda r: r.arcs.entry_tension,
    "exit_tension": lambda r: r.arcs.exit_tension,
    "tension_ratio": lambda r: r.arcs.entry_tension / r.arcs.exit_tension,
    "effective_tension": lambda r: _pull(r.arcs),
    "exit_creep": _place(row.EXIT_CREEP),
    "creep_shrinkage": _shrinkage,
    "creep_compression": _compression,
    "creep_global": _global,
    "exit_slip": _place(row.EXIT_SLIP),
    "entry_creep_ratio": _place(row.CREEP_RATIO),
    "exit_creep_ratio": lambda r: r.found[:, row.CREEP_RATIO] + _pull(r.arcs) * r.arcs.compliance,
    "peak_shear_stress": _place(row.PEAK_STRESS),
    "peak_shear_angle": lambda r: np.arctan(r.found[:, row.PEAK_STRESS] / r.arcs.shear_modulus),
    "peak_shear_position": lambda r: r.found[:, row.PEAK_AT] / (0.5 * r.arcs.diameter),
    "mean_friction": _of_solved(lambda arcs: _log_actual(arcs) / arcs.wrap_angle),
    "active_arc": lambda r: r.found[:, row.ACTIVE] / (0.5 * r.arcs.diameter),
    "outside_tested_share": _place(row.OUTSIDE),
    "stuck_arc": lambda r: r.found[:, row.STUCK_LENGTH] / (0.5 * r.arcs.diameter),
    "creep_limit_capacity": _ratio(row.CREEP_CAPACITY),
    "creep_limit_margin": _margin(row.CREEP_CAPACITY),
    "equivalent_friction": lambda r: (
        np.maximum(_carried(r, row.CREEP_CAPACITY), 0.0) / r.arcs.wrap_angle
    ),
    "least_exit_tension": lambda r: r.found[:, row.LEAST_SLACK] + r.arcs.centrifugal_force,
    "largest_effective_tension": lambda r: np.maximum(r.found[:, row.MOST_PULL], 0.0),
    "tested_slip_capacity": _ratio(row.SLIP_CAPACITY),
    "tested_slip_margin": _margin(row.SLIP_CAPACITY),
    "gross_slip_capacity": _ratio(row.GROSS_CAPACITY),
    "extrapolated_gross_slip_margin": _margin(row.GROSS_CAPACITY),
    "gross_slip_creep": _place(row.GROSS_CREEP),
    "drum_torque": lambda r: 0.5 * r.arcs.diameter * _pull(r.arcs),
    "resultant_force": lambda r: np.hypot(*_resultant(r.arcs)),
    "resultant_angle": lambda r: np.arctan2(*_resultant(r.arcs)),
    "transmitted_power": lambda r: _surface_speed(r) * _pull(r.arcs),
    "sliding_power": _power(_place(row.WORK)),
    "shear_loss": _power(_shear_energy),
    "power_loss": _power(lambda r: r.found[:, row.WORK] + _shear_energy(r)),
    "efficiency": _efficiency,
    "frictional_energy": _place(row.WORK),
    "wear_rate": lambda r: 1e6 * r.arcs.wear_coefficient * r.found[:, row.WORK],
}
