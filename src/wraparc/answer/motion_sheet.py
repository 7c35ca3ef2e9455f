"""What drives do in time, in words and tables: a run through an event, and whether they pulsate."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from functools import lru_cache
from typing import Any

from wraparc.alike import largest, least
from wraparc.answer.checks_table import check_table
from wraparc.answer.sheet import NONE, Row, Sheet, Table, Verdict, named, percent, quantity, term
from wraparc.answer.words import format_verdict, stated_action, under
from wraparc.checks import Level, judge, judge_run
from wraparc.checks import Verdict as Judgement
from wraparc.checks.action import Action
from wraparc.checks.of_run import otherwise
from wraparc.drive.pitch import pitch_offset
from wraparc.motion.result import RunResult
from wraparc.motion.vibration import ControlAnswer, StabilityResult
from wraparc.train import Train, solve_train
from wraparc.train.turning import surface_sentence
from wraparc.units import GIVEN_DIGITS, Dimension, bare, display, display_unit, either

#: Amplitude of the pull below which run-out does no harm, and above which it is told as too much.
_CALM = 0.02


def run_sheet(run: RunResult) -> Sheet:
    """Return the answer of a run: the worst check first, then the numbers of every drum."""
    told = judge_run(run)
    own = format_verdict(told, [*told.full, *_run_sentences(run)], stated_action(told))
    return Sheet(
        title=f"{run.station.train.title or 'Drive'}: {run.event.name}",
        subtitle=f"{run.steps} steps of {quantity(run.step, 'time')}, "
        f"{quantity(float(run.time[-1]), 'time')} followed",
        verdict=under(own, format_verdict(_steady(run.station.train))),
        tables=(*run_tables(run), check_table(told)),
        remarks=(*told.remarks, *_LEFT_OUT, *_surface(run.station.train)),
        kept=(*_LEFT_OUT, *_surface(run.station.train)),
        sources=(run.station.source,) if run.station.source else (),
    )


@lru_cache(maxsize=4)  # a note tells several events of one train
def _steady(train: Train) -> Judgement:
    """Return what is judged of drives that run steadily."""
    return judge(solve_train(train, raise_on_failure=False))


def run_document(run: RunResult) -> dict[str, Any]:
    """Return a run as plain data, SI: how it ended and the largest values of every drum."""
    return {
        "event": run.event.name,
        "outcome": run.outcome.name.lower(),
        "reason": run.reason,
        "ended": float(run.time[-1]),
        "step": run.step,
        "belt_error": run.belt_error,
        "build_distance": run.build_distance,
        "drums": [
            {
                "name": drum.name,
                "over_limit": drum.over_limit,
                "friction_energy": drum.friction_energy,
                "drum_work": drum.drum_work,
                "extremes": asdict(drum.extremes),
            }
            for drum in run.drums
        ],
    }


def run_tables(run: RunResult) -> tuple[Table, ...]:
    """Return the numbers of a run: of the whole, and of every drum."""
    return _whole_table(run), _drum_table(run)


_LEFT_OUT = (
    "Not in the model: inertia of the belt on the arc, waves in the conveyor (one mass, one spring "
    "on each side), rubber that flows, friction that depends on speed or on rest.",
)


def _surface(train: Train) -> Iterator[str]:
    """Say that the speeds of drums are without the thickness of the belt, if that is not known."""
    for pulley in train.pulleys:
        if pitch_offset(train.belt, pulley.side) is None:
            yield surface_sentence(pulley.diameter)
            return


_NOT_EXCLUDED = (
    "Oscillation by friction that falls with speed or grows with rest is not modelled: it is "
    "neither shown nor excluded."
)


def _run_sentences(run: RunResult) -> Iterator[str]:
    peak, tension = run.peak_creep, run.peak_tension
    now = named("entry_tension", tension.value)
    for of in otherwise(run):
        taken, other = (quantity(v, "length", GIVEN_DIGITS) for v in (of.taken, of.other))
        then = named("entry_tension", of.tension)
        yield (
            f"{of.key} is missing: {taken} of belt is taken. With {other} the peak tension "
            f"is {then} instead of {now}."
        )
    yield (
        f"The peak creep, {named('exit_creep', peak.value)}, comes at {peak.place} "
        f"after {quantity(peak.time, 'time')}; the peak tension, "
        f"{named('entry_tension', tension.value)}, {tension.place} after "
        f"{quantity(tension.time, 'time')}."
    )
    if run.outcome.whole and not math.isnan(run.build_distance):
        travelled = quantity(run.build_distance, "length")
        yield f"Creep settles within 5 % after {travelled} of belt travel."
    if run.belt_speed[-1] < 0.01 * max(run.belt_speed):
        left = ", ".join(
            f"{name} {named('exit_creep', creep)}"
            for name, creep in zip(run.station.names, run.creep_left(), strict=True)
        )
        yield f"Creep left at rest: {left}."
        pulls = [float(d.effective_tension[-1]) for d in run]
        if min(pulls) < -0.02 * max(map(abs, pulls)) < 0.02 * max(map(abs, pulls)) < max(pulls):
            yield "At rest the drives oppose each other."


def _whole_table(run: RunResult) -> Table:
    least = run.least_tension
    rows = [
        Row(
            "Peak tension",
            (named("entry_tension", run.peak_tension.value),),
            name="peak_tension",
        ),
        Row(
            "Minimum tension",
            (named("exit_tension", least.value),),
            note=least.place,
            name="minimum_tension",
        ),
        Row(
            "Belt speed at the end",
            (quantity(float(run.belt_speed[-1]), "speed"),),
            name="belt_speed",
        ),
    ]
    return Table("The event", tuple(rows), name="event")


def _drum_table(run: RunResult) -> Table:
    drums = run.drums

    def row(name: str, title: str, values: list[str]) -> Row:
        return Row(title, tuple(values), name=name)

    def largest(title: str, name: str, dimension: Dimension) -> Row:
        peaks = [getattr(d.extremes, name).value for d in drums]
        return row(f"peak_{name}", title, [quantity(peak, dimension) for peak in peaks])

    rows = [
        largest("Peak Te", "pull", "force"),
        largest("Peak torque", "torque", "torque"),
        largest(f"Peak {term('exit_creep').title.lower()}", "creep", "length"),
        largest("Peak slip", "slip", "length"),
        largest("Peak shear stress", "shear", "pressure"),
        row("share", "Share at the end", [percent(float(d.share[-1])) for d in drums]),
        row(
            "time_over_limit",
            "Time over the creep limit",
            [quantity(d.over_limit, "time") for d in drums],
        ),
        row(
            "friction_work",
            "Friction work on the lagging",
            [work(d.friction_energy) for d in drums],
        ),
        row(
            "friction_work_per_area",
            "Friction work per area of shell",
            [quantity(run.energy_per_area(d.name), "energy_per_area") for d in drums],
        ),
    ]
    depths = [run.wear_depth(d.name) for d in drums]
    if any(d is not None for d in depths):
        rows.append(
            row("wear", "Wear of one such event", [NONE if d is None else _thin(d) for d in depths])
        )
    return Table("The drives", tuple(rows), heads=tuple(d.name for d in drums), name="drums")


def work(energy: float) -> str:
    """Return friction work [J] as it is read in each system of units."""
    return _in_small((energy / 1e3, "kJ"), (energy / display_unit("torque", "us")[1], "ft lbf"))


def _thin(depth: float) -> str:
    return _in_small((depth * 1e6, "um"), (1e3 * depth / display_unit("length", "us")[1], "mil"))


def _in_small(*told: tuple[float, str]) -> str:
    return either(*(f"{display(value, 'number', digits=3)} {unit}" for value, unit in told))


def stability_document(result: StabilityResult) -> dict[str, Any]:
    """Return what is known of vibrations as plain data, SI."""
    return {
        "stable": result.stable,
        "frequency": result.frequency,
        "decay": result.margin,
        "run_out": result.run_out,
        "softening": result.softening,
        "drums": [
            {"name": name, "sensitivity": share, "gain_margin": gain}
            for name, share, gain in zip(
                result.linear.station.names,
                (None, *result.sensitivity),  # of the first drum none
                result.gain_margins,
                strict=True,
            )
        ],
        "controls": [
            {
                "name": way.name,
                "stable": way.stable,
                "frequency": abs(way.root.imag) / math.tau,
                "decay": -way.root.real,
                "pull": way.pull,
                "pull_third": way.pull_third,
                "power_loss": way.power_loss,
            }
            for way in result.controls
        ],
    }


def stability_sheet(result: StabilityResult) -> Sheet:
    """Return the answer to: will it pulsate, why, how much, and what cures it at what cost."""
    own, train = result.controls[0], result.linear.station.train
    return Sheet(
        title=f"{train.title or 'Drive'}: stability",
        subtitle=f"run-out of the last pulley {named('exit_creep', result.run_out)}",
        verdict=under(_verdict(result, own), format_verdict(_steady(train))),
        tables=(_sensitivity_table(result), _controls_table(result)),
        remarks=(*_LEFT_OUT, _NOT_EXCLUDED, *_surface(train)),
        sources=(result.linear.station.source,) if result.linear.station.source else (),
    )


def _verdict(result: StabilityResult, own: ControlAnswer) -> Verdict:
    station, run_out = result.linear.station, result.run_out
    amplitude = own.pull * run_out
    others = [c for c in result.controls if c.stable]
    smoothest = least(others, lambda c: max(c.pull, c.pull_third)) if others else None
    ways = " and ".join(dict.fromkeys(d.control.words for d in station.drums))
    said = named("exit_creep", run_out)
    cure = "None of the usual ways to drive it is calmer."
    if smoothest is not None and smoothest is not own:
        cure = (
            f"Of the usual ways to drive it, {smoothest.name} has the smallest ripple: "
            f"{percent(smoothest.pull * run_out, 2)} of Te at one wave per revolution, "
            f"{percent(smoothest.pull_third * run_out, 2)} at three; {_cost(smoothest)}."
        )
    duty = result.linear.duties[-1]
    turn, last = duty.speed / (2.0 * math.pi), station.names[-1]
    ripple, waves = max((amplitude, 1.0), (own.pull_third * run_out, 3.0))
    forced = (
        f"A run-out of {said} of {last} makes its Te ripple by {percent(amplitude, 2)} at one wave "
        f"per revolution ({turn:.3g} Hz) and {percent(own.pull_third * run_out, 2)} at three "
        f"({3.0 * turn:.3g} Hz), with {ways}."
    )
    reasons = (*_why(result), cure, forced)
    if not result.stable:
        double = math.log(2.0) / result.root.real
        text = (
            f"Self-excited oscillation at {result.frequency:.3g} Hz, doubling time "
            f"{quantity(double, 'time', 2)}."
        )
        action = _calm_action(result, others, any_stable=True)
        return Verdict(Level.FAILS, text, reasons, action=action, name="stability")
    place = f"({last}, {said} run-out, {waves * turn:.3g} Hz)"
    if ripple <= _CALM:
        text = f"Stable: Te ripple {percent(ripple, 2)} of {percent(_CALM)} {place}."
        return Verdict(Level.OK, text, reasons, name="stability")
    shown = percent(ripple, 5 if percent(ripple, 2) == percent(_CALM, 2) else 2)
    text = f"Te ripple {shown} exceeds the {percent(_CALM)} limit {place}."
    action = _calm_action(result, others)
    return Verdict(Level.ATTENTION, text, reasons, action=action, name="stability")


def _calm_action(
    result: StabilityResult, ways: Sequence[ControlAnswer], *, any_stable: bool = False
) -> Action | None:
    """Return the way to drive it that passes at the lowest loss; none where none passes.

    Parameters
    ----------
    result
        What was asked.
    ways
        Those that are stable.
    any_stable
        Whether a ripple over its limit is taken where no way is below it.
    """

    def ripple(way: ControlAnswer) -> float:
        return max(way.pull, way.pull_third) * result.run_out

    passing = [way for way in ways if ripple(way) <= _CALM]
    if not passing and any_stable and ways:
        passing = [least(ways, ripple)]
    if not passing:
        return Action("Try a pulley with less run-out: none of the usual controls passes.")
    best = min(passing, key=lambda way: (round(way.power_loss, 6), ripple(way)))
    loss = (
        "no power loss" if best.power_loss < 1e-6 else f"{percent(best.power_loss, 2)} power loss"
    )
    return Action(f"Use {best.name}: ripple {percent(ripple(best), 2)}, {loss}.")


def _why(result: StabilityResult) -> Iterator[str]:
    from wraparc.motion.control import ExactSpeed, Follower

    drums = result.linear.station.drums
    if not result.stable and any(
        isinstance(d.control, Follower) and not d.control.damping for d in drums
    ):
        yield (
            "The torque follower answers late and has no speed feedback: against the spring of "
            "belt and lagging its lag acts as a negative damping. A droop of 1 to 5 % added to it "
            "(damping) cures that."
        )
    elif not result.stable and any(d.trim for d in drums):
        yield (
            "Load sharing trims the speed faster than the share follows: lower its gain by half, "
            "or shorten the dead time."
        )
    if any(isinstance(d.control, ExactSpeed) for d in drums[1:]) and result.sensitivity:
        worst = largest(result.sensitivity, abs)
        yield (
            f"At exact speeds 0.1 % of speed moves {percent(abs(worst) * 1e-3, 2)} of the load "
            "to another drive: nothing yields to run-out, wear or a splice."
        )
    if result.softening:
        yield (
            f"On {' and '.join(result.softening)} the friction falls with slip: past the peak "
            "an oscillation grows into gross slip, not into a limit cycle."
        )


def _cost(answer: ControlAnswer) -> str:
    if answer.power_loss < 1e-6:
        return "it costs no power"
    return f"it costs {percent(answer.power_loss, 2)} of the power in slip"


def _sensitivity_table(result: StabilityResult) -> Table:
    root = result.root
    decay = "below 0.33 s" if math.isnan(root.real) else f"{1.0 / abs(root.real):.3g} s"
    rows = [
        Row(
            "Share moved by 0.1 % of speed",
            (", ".join(percent(s * 1e-3) for s in result.sensitivity) or NONE,),
            note="all other speeds and the outer tensions constant",
            name="share_sensitivity",
        ),
        Row(
            "Vibration of minimum damping",
            (NONE if math.isnan(root.real) else quantity(result.frequency, "frequency"),),
            note=f"{'growth' if root.real > 0 else 'decay'} time constant {decay}",
            name="frequency",
        ),
    ]
    rows += [
        Row(
            f"Gain margin, {name}", (_times(margin),), note="all else unchanged", name="gain_margin"
        )
        for name, margin in zip(result.linear.station.names, result.gain_margins, strict=True)
        if not math.isnan(margin)
    ]
    return Table("Small vibrations", tuple(rows), name="vibrations")


def _times(margin: float) -> str:
    """A gain margin in words."""
    if margin >= 1.0:
        return (
            "over a thousandfold"
            if math.isinf(margin)
            else f"{bare(margin, 'number')} times as high"
        )
    return f"must fall to {bare(margin, 'number')} times" if margin > 0.0 else NONE


def _controls_table(result: StabilityResult) -> Table:
    rows = [
        Row(
            c.name,
            (
                "no"
                if c.stable
                else f"yes, {quantity(abs(c.root.imag) / (2.0 * math.pi), 'frequency')}",
                percent(c.pull * result.run_out, 2),
                percent(c.pull_third * result.run_out, 2),
                percent(c.power_loss, 2),
            ),
        )
        for c in result.controls
    ]
    heads = ("oscillates", "Te ripple, 1 per revolution", "3 per revolution", "power lost")
    return Table("What other controls would make of it", tuple(rows), heads, name="controls")
