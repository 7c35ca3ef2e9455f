"""A test plan to a lagging: the results, test by test and condition by condition, as data."""

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from wraparc.arrays import Array, Flags, Integers
from wraparc.drive import FrictionFactor, Lagging
from wraparc.errors import Problem, input_error, shown
from wraparc.friction import FrictionLaw
from wraparc.shear_test.budget import Common
from wraparc.shear_test.curve_fit import Z95, CurveFit
from wraparc.shear_test.misfit import JudgedFit
from wraparc.shear_test.plan import PlannedTest, TestPlan
from wraparc.shear_test.pressure_choice import PressureChoice
from wraparc.shear_test.pressure_fit import CurvePoints, PressureFit
from wraparc.shear_test.profile import profile_interval
from wraparc.shear_test.record import MachineRecord
from wraparc.shear_test.reduce import FrictionCurve
from wraparc.shear_test.student import chi_square_ends
from wraparc.shear_test.tails import Tails

# Error of friction, as a share of its peak, below which a prediction is good whatever the noise.
_MATTERS = 0.02
# With fewer degrees of freedom repeats do not tell the scatter.
_FEW_REPEATS = 3
_LONGEST_REASON = 500
# Standard error of ln x_pk from which the likelihood of a peak beyond the test is far from normal.
_SKEWED = 0.1


def checked_reason(reason: str, key: str = "accept_misfit") -> str:
    """Return the reason for which a misfit is accepted, or say what is wrong with it."""
    text = reason.strip()
    if text and len(text) <= _LONGEST_REASON and text.isprintable():
        return text
    raise input_error(
        message=f"must be text of 1 to {_LONGEST_REASON} printable characters",
        remedy="Give the reason to use the law.",
        key=key,
        value=shown(reason),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class TestResult:
    """One test, read, reduced and fitted.

    Parameters
    ----------
    test
        As planned.
    record
        As read.
    curve
        As reduced.
    judged
        Its fit, with what the law does not describe.
    other
        The fit with the sample's shear treated the other way: left in if it was taken off,
        taken off if it was left in; None if it is not known.
    """

    __test__ = False  # not a test class, whatever its name suggests to a test collector

    test: PlannedTest
    record: MachineRecord
    curve: FrictionCurve
    judged: JudgedFit
    other: CurveFit | None

    @property
    def fit(self) -> CurveFit:
        """Its fit."""
        return self.judged.fit

    @property
    def is_skewed(self) -> bool:
        """Whether the curvature at the best peak slip misleads about its interval."""
        return not self.fit.peak_inside and self.fit.error("ln_peak_slip") > _SKEWED

    @cached_property
    def peak_slip_interval(self) -> tuple[float, float]:
        """95 % interval of the peak slip [m], from the profile where the curvature misleads."""
        if not self.is_skewed:
            return self.fit.interval("peak_slip")
        return profile_interval(self.curve, self.fit)

    @property
    def name(self) -> str:
        """What to call it in messages."""
        return f"{self.test.place} ({self.test.label})"


@dataclass(frozen=True, kw_only=True)
class LeftOut:
    """A pressure predicted by the law of all others.

    Parameters
    ----------
    pressure
        [Pa].
    inside
        Whether other pressures were tested on both sides of it.
    error
        Root mean square of predicted less measured friction, over its curves [-].
    noise
        Standard deviation of one reading of those curves [-].
    scatter
        Standard deviation of friction between samples there, as the law has it [-].
    peak_slip, peak_friction
        Predicted [m, -].
    distance
        Of (ln x_pk, ln mu_pk) from the prediction [standard deviations of both]; NaN where the
        others are too few to know the error of the prediction.
    limit
        Distance that chance exceeds at one of the pressures in one of 50 sound laboratories.
    """

    pressure: float
    inside: bool
    error: float
    noise: float
    scatter: float
    peak_slip: float
    peak_friction: float
    distance: float
    limit: float

    @property
    def noise_levels(self) -> float:
        """Error in units of the noise."""
        return self.error / self.noise if self.noise > 0 else np.inf

    @property
    def missed(self) -> bool:
        """Whether others on both sides miss it by more than chance, and by what matters."""
        large = self.error > _MATTERS * self.peak_friction
        return self.inside and large and self.distance > self.limit


@dataclass(frozen=True, kw_only=True)
class Transition:
    """A transition pressure.

    Parameters
    ----------
    pressure
        [Pa].
    given
        Whether it was given, not found.
    in_law
        Whether the law has it, or only the best law of two pieces.
    inside
        Whether it lies inside, not at the edge of, where the pressures could show one.
    """

    pressure: float
    given: bool
    in_law: bool
    inside: bool


@dataclass(frozen=True, kw_only=True)
class Separated:
    """What speed and temperature of the tests do to friction.

    Parameters
    ----------
    by_slip_speed, by_temperature
        Factors over the tests at the reference, or None where there is no effect that they tell.
    remarks
        What was found and what could not be, as sentences.
    """

    by_slip_speed: FrictionFactor | None = None
    by_temperature: FrictionFactor | None = None
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Scatter:
    """Standard deviation of ln mu_pk between samples.

    Parameters
    ----------
    value
        [-].
    freedom
        Its degrees of freedom: few tell little, as `ends` shows.
    of
        ``"repeats"`` of one pressure, or ``"samples"`` about the law.
    """

    value: float
    freedom: int
    of: str

    @property
    def ends(self) -> tuple[float, float]:
        """Its 95 % interval [-]: value sqrt(n / q), q the quantiles of chi-square."""
        low, high = chi_square_ends(self.freedom)
        return self.value * (self.freedom / high) ** 0.5, self.value * (self.freedom / low) ** 0.5

    @property
    def words(self) -> str:
        """Its size and interval, for a sentence."""
        low, high = self.ends
        between = f"between {_percent(low)} and {_percent(high)} %, with 95 %"
        return f"{self.of} scatter by {_percent(self.value)} % in peak friction ({between})"


def _percent(share: float) -> str:
    return f"{100 * share:.2g}" if share < 0.995 else f"{100 * share:.0f}"


@dataclass(frozen=True, kw_only=True, eq=False)
class Findings:
    """What the tests of one condition have shown.

    Parameters
    ----------
    condition
        ``dry``, ``wet`` ...
    tests
        Its tests, pressures ascending.
    levels
        Number of the pressure of each test, 0, 1, ..., shape (n,).
    flagged
        Whether each test disagrees with its repeats, shape (n,).
    repeat_distances
        Distance of each from its repeats [standard deviations], NaN without one, shape (n,).
    lone_distances
        Distance of each from the trend of the others, where it has no repeat, shape (n,).
    points
        The curves as points over pressure, as the law has used them.
    choice
        Form of the pressure dependence; None for a single pressure.
    fit
        The law's fit over pressure, joint over all curves; None for a single pressure.
    transition
        Transition pressure of the law, or of the best law of two pieces; None if there are
        too few pressures.
    tails
        What follows the peak.
    left_out
        Predictions of left-out pressures.
    common
        Errors common to all tests, or None.
    separated
        Effects of speed and temperature that were taken off the curves.
    """

    condition: str
    tests: tuple[TestResult, ...]
    levels: Integers
    flagged: Flags
    repeat_distances: Array
    lone_distances: Array
    points: CurvePoints
    choice: PressureChoice | None
    fit: PressureFit | None
    transition: Transition | None
    tails: Tails
    left_out: tuple[LeftOut, ...]
    common: Common | None = None
    separated: Separated = field(default_factory=Separated)

    @property
    def scatter(self) -> Scatter | None:
        """Scatter of ln mu_pk between samples, without those that disagree with the others.

        That of repeats, with three degrees of freedom or more; else of the curves about the law,
        if there are more degrees of freedom in it; None where there are none.
        """
        squares, freedom = 0.0, 0
        good = ~self.flagged
        for k in np.unique(self.levels):
            own = self.points.value[(self.levels == k) & good, 1]
            if len(own) > 1:
                squares += float(((own - own.mean()) ** 2).sum())
                freedom += len(own) - 1
        if self.fit is not None and freedom < _FEW_REPEATS:
            of_law = int(good.sum() - 0.5 * self.fit.form.size)
            if of_law > freedom:
                off = self.points.value[:, 1] - self.fit.peaks(self.points.pressure)[:, 1]
                return Scatter(float(np.sqrt((off[good] ** 2).sum() / of_law)), of_law, "samples")
        return Scatter(float(np.sqrt(squares / freedom)), freedom, "repeats") if freedom else None

    def level_pressures(self) -> Array:
        """Mean pressure of each level [Pa]."""
        pressures = np.array([result.curve.pressure for result in self.tests])
        return np.array([pressures[self.levels == k].mean() for k in np.unique(self.levels)])


@dataclass(frozen=True, kw_only=True, eq=False)
class ConditionResult:
    """The law of one condition.

    Parameters
    ----------
    found
        What the tests have shown.
    lagging
        The lagging with this law.
    misfit
        Sentences on what the law does not describe.
    remarks
        Other sentences.
    """

    found: Findings
    lagging: Lagging
    misfit: tuple[str, ...]
    remarks: tuple[str, ...]

    def accepting(self, reason: str) -> "ConditionResult":
        """Return the result with its misfit accepted."""
        fit = self.lagging.fit
        assert fit is not None  # noqa: S101 - every fitted lagging has its statistics
        lagging = replace(self.lagging, fit=replace(fit, misfit_accepted=reason))
        return replace(self, lagging=lagging)

    @property
    def condition(self) -> str:
        """``dry``, ``wet`` ..."""
        return self.found.condition

    @property
    def tests(self) -> tuple[TestResult, ...]:
        """Its tests, pressures ascending."""
        return self.found.tests

    @property
    def fit(self) -> PressureFit | None:
        """The law's fit over pressure; None for a single pressure."""
        return self.found.fit

    @property
    def tested_law(self) -> FrictionLaw:
        """The law of the tests at their reference, without factors of speed and temperature."""
        of = self.lagging.factors
        return self.lagging.law if of is None else of.law

    def peaks_at(self, pressures: Array) -> tuple[Array, Array, Array]:
        """Peak slip [m], peak friction, half 95 % intervals of their logarithms, shape (n, 2)."""
        if self.fit is not None:
            peaks = np.exp(self.fit.peaks(pressures))
            error = self.fit.coverage_factor * self.fit.peak_errors(pressures)
            return peaks[:, 0], peaks[:, 1], error
        statistics = self.lagging.fit
        assert statistics is not None  # noqa: S101 - every fitted lagging has its statistics
        values = np.array(statistics.values)
        error = Z95 * np.sqrt(np.diag(np.array(statistics.covariance))) / values
        return np.array([values[0]]), np.array([values[1]]), error[None, :]


@dataclass(frozen=True, kw_only=True, eq=False)
class PlanResult:
    """Everything that came out of a plan.

    Parameters
    ----------
    plan
        The plan.
    conditions
        One for each condition, in the order of the plan.
    left_out
        Why tests were left out.
    date
        When it was computed.
    misfit_accepted
        Why the laws may be written although they do not describe their tests.
    """

    plan: TestPlan
    conditions: tuple[ConditionResult, ...]
    left_out: tuple[Problem, ...]
    date: str
    misfit_accepted: str = ""

    @property
    def misfit(self) -> tuple[str, ...]:
        """What the laws do not describe, in all conditions."""
        return tuple(sentence for condition in self.conditions for sentence in condition.misfit)

    @property
    def may_be_written(self) -> bool:
        """Whether the laws describe their tests, or their misfit was accepted."""
        return not self.misfit or bool(self.misfit_accepted)

    def accepting(self, reason: str) -> "PlanResult":
        """Return the result with its misfit accepted.

        Parameters
        ----------
        reason
            Why; it is kept in the laggings of the conditions that have misfit.

        Raises
        ------
        InputError
            If it says nothing, is longer than 500 characters, or cannot be printed.
        """
        text = checked_reason(reason)
        conditions = tuple(c.accepting(text) if c.misfit else c for c in self.conditions)
        return replace(self, conditions=conditions, misfit_accepted=text)

    @property
    def laggings(self) -> tuple[Lagging, ...]:
        """The lagging in every condition."""
        return tuple(condition.lagging for condition in self.conditions)
