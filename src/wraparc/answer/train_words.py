"""The answer for a train in words: who carries more and why, and how exactly speeds must match."""

from collections.abc import Iterator, Sequence
from math import floor, isfinite, isnan, log10, nan

from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.sheet import Verdict, named, percent
from wraparc.answer.words import (
    action_of,
    format_verdict,
    minimum_sentences,
    under,
    whole_verdict,
)
from wraparc.checks import Level, Place, idle
from wraparc.checks.action import Action
from wraparc.checks.numbers import pull_against
from wraparc.glossary import GLOSSARY
from wraparc.train import (
    CaseResult,
    MarkKind,
    Matching,
    MemberResult,
    ShareCurve,
    TrainResult,
    TrainStatus,
)
from wraparc.train.turning import surface_sentence

#: Differences of shares that count as none.
_ALIKE = 0.005
#: Difference of speeds that shows as none [-].
_AS_FAST = 5e-6
#: How far a share may be off before somebody minds.
_TOLERATED = 0.05


def train_verdict(result: TrainResult, *, search: bool = True) -> Verdict:
    """Return the answer for a train in all its load cases.

    Parameters
    ----------
    result
        The solved train.
    search
        Whether changes of the drive are tried for the action.
    """
    worst, judged = result.governing, judge_uncertain(result)
    governing = [*case_sentences(worst, result.cases)]
    others = [s for case in result if case is not worst for s in short_sentences(case)]
    sentences = [*minimum_sentences(result), *judged.full, *governing, *others]
    action = action_of(result, search=search)
    return format_verdict(judged, sentences, action)


def _fights(case: CaseResult) -> bool:
    """Whether drives work against each other."""
    return _against(case) > 0.0


def _against(case: CaseResult) -> float:
    return pull_against([m.arc.effective_tension for m in case.members])


def case_sentences(case: CaseResult, cases: Sequence[CaseResult]) -> Iterator[str]:
    """Tell of the load case that governs: who carries what, how the drums turn, what is lost."""
    if case.status is not TrainStatus.SOLVED:
        yield f"Load case {case.case.name}: {case.reason}"
        return
    yield f"Load case {case.case.name}: {_shares(case)}."
    if len(case.other_splits) > 0:
        listed = "; ".join(", ".join(percent(s) for s in split) for split in case.other_splits)
        yield (
            f"Friction falls with slip here: the same speeds are also met by the shares {listed}, "
            "which are unstable; the stable split is shown."
        )
    if _fights(case):
        yield _fight(case)
    if len(case.members) > 1:
        for m in case.members[1:]:
            if not idle(m.arc.arc):
                yield _speed_sentence(case, m)
        yield from surface_speeds(case)
        yield from _matching(case, cases)
    loss = percent(case.loss_ratio)
    power = "" if isnan(case.power_loss) else f" {named('power_loss', case.power_loss)},"
    yield f"Creep costs{power} {loss} of the power."
    yield from _motor_losses(case)


def _motor_losses(case: CaseResult) -> Iterator[str]:
    """Say what is lost between the mains and the drums, and what the mains give."""
    points = [m.motor for m in case.members if m.motor is not None]
    turned = sum(abs(p.motor_power) for p in points)
    parts = []
    for name, what in (
        ("coupling_loss", "fluid couplings"),
        ("gear_loss", "gears"),
        ("motor_loss", "motors"),
    ):
        values = [getattr(p, name) for p in points]
        lost = sum(v for v in values if not isnan(v))
        if lost > 1e-9 * turned:
            parts.append(f"{named(name, lost)} in the {what}")
    if len(parts) == 0:
        return
    electrical = sum(p.electrical_power for p in points)
    if isnan(electrical):
        tail = "; motor losses need motor_efficiency"
    else:
        mains = named("electrical_power", electrical)
        tail = f"; the motors take {mains} from the mains"
    are = "is" if len(parts) == 1 else "are"
    yield f"Between mains and pulleys {', '.join(parts)} {are} lost{tail}."


def short_sentences(case: CaseResult) -> Iterator[str]:
    """Tell of another load case who carries what."""
    if case.status is not TrainStatus.SOLVED:
        yield f"Load case {case.case.name}: {case.reason}"
        return
    tail = ", the drives working against each other" if _fights(case) else ""
    yield f"Load case {case.case.name}: {_shares(case)}{tail}."


def _shares(case: CaseResult) -> str:
    if any(isnan(m.share) for m in case.members):
        pulls = ", ".join(
            f"{m.name} {named('effective_tension', m.arc.effective_tension)}" for m in case.members
        )
        return f"nothing is shared; the Te of the drives is {pulls}"
    return ", ".join(
        f"{m.name} is not driven" if idle(m.arc.arc) else f"{m.name} takes {percent(m.share)}"
        for m in case.members
    )


def _fight(case: CaseResult) -> str:
    loaded = [m for m in case.members if not idle(m.arc.arc)]
    forward = [m.name for m in loaded if m.arc.effective_tension > 0.0]
    back = [m.name for m in loaded if m.arc.effective_tension < 0.0]
    lost = _against(case)
    drive = "drives" if len(forward) == 1 else "drive"
    brake = "brakes" if len(back) == 1 else "brake"
    return (
        f"The drives oppose each other: {' and '.join(forward)} {drive} while {' and '.join(back)} "
        f"{brake}, by {named('effective_tension', lost)}."
    )


def _speed_sentence(case: CaseResult, m: MemberResult) -> str:
    """Say how fast a drum turns against the first one, and which term decides."""
    first = case.members[0].name
    ratio = m.drum_ratio - 1.0
    asked = case.case.pulls_given
    verb = "must turn" if asked else "turns"
    way = "faster" if ratio > 0.0 else "slower"
    terms = (
        f"belt contraction {_signed(m.contraction_term)} %, lagging compression "
        f"{_signed(m.compression_term)} %, extra creep {_signed(m.creep_term)} %"
    )
    if m.arc.arc.pitch_offset is not None:
        terms += f", belt thickness {_signed(m.thickness_term)} %"
    if abs(ratio) < _AS_FAST:
        return f"{m.name} {verb} as fast as {first}, at equal diameters: {terms}."
    rule = _rule(ratio) if asked and m.creep_term > 0.0 else ""
    return (
        f"{m.name} {verb} {abs(100.0 * ratio):.3f} % {way} than {first}, at "
        f"equal diameters ({terms}): {_reason(m, ratio)}{rule}."
    )


def surface_speeds(case: CaseResult) -> Iterator[str]:
    """Say that the speeds of drums are without the thickness of the belt, if that is not known."""
    for m in case.members:
        if m.arc.arc.pitch_offset is None:
            yield surface_sentence(m.arc.arc.diameter)
            return


def _signed(term: float) -> str:
    """Return a term in percent, without a sign where nothing of it is shown."""
    text = f"{100.0 * term:+.3f}"
    return "0" if text in ("+0.000", "-0.000") else text


def _rule(ratio: float) -> str:
    """Say whether the rule of the slightly faster second drive holds."""
    applies = "applies" if ratio > 0.0 else "does not apply"
    return f", and the rule of the slightly faster second drive {applies}"


def _reason(m: MemberResult, ratio: float) -> str:
    """Say which of the terms makes a drum faster or slower."""
    others = m.contraction_term + m.compression_term + m.creep_term
    if m.arc.arc.pitch_offset is not None and abs(m.thickness_term) > abs(others):
        way = "farther out" if m.thickness_term < 0.0 else "closer in"
        return f"its tension member runs {way} than on the first pulley"
    shorter = m.contraction_term + m.compression_term + m.thickness_term
    if ratio > 0.0 and m.creep_term > 0.0 and shorter <= 0.0:
        return "its extra creep outweighs contraction and compression"
    if ratio <= 0.0 < m.creep_term and shorter < 0.0:
        return "contraction and compression outweigh its extra creep"
    if shorter < 0.0:
        return "contraction, compression and a smaller creep all require it"
    return "the belt is as tight there as at the first drive, or tighter"


def _matching(case: CaseResult, cases: Sequence[CaseResult]) -> Iterator[str]:
    """Say how much load a trim moves, in the condition where it moves most."""
    own_way = case.case.on_motors
    for i, m in enumerate(case.members):
        slope = _steepest(case, cases, i)
        if i == 0 or slope == 0.0 or idle(m.arc.arc):
            continue
        how = " with its motors as they are" if own_way else ""
        yield (
            f"A trim of 0.1 % on {m.name} moves {percent(slope, 2)} of the load{how}: for a "
            f"share within {percent(_TOLERATED)}, speeds and diameters must match within "
            f"{_needed(slope)} %."
        )


def matching_verdict(result: TrainResult, matching: Matching) -> Verdict:
    """Return how exactly the drives of a train must be matched, under the verdict on it."""
    case, drive = matching.case, matching.drive
    member, fair = case.members[drive], 1.0 / len(case.members)
    place = Place(member.name, case.case.name).bracket
    equal = abs(member.share - fair) < _ALIKE
    level, text = Level.OK, f"Equal load sharing{place}."
    if equal and not case.case.on_motors:
        text = f"Equal load sharing at trim {_trim(member.speed_trim)}{place}."
    elif not equal:
        level = Level.ATTENTION
        text = (
            f"Load share of {member.name} is {percent(member.share)}, equal share {percent(fair)} "
            f"({case.case.name})."
        )
    what = GLOSSARY[matching.trim.quantity].title.lower()
    sentences = [
        *_who_and_why(matching),
        *surface_speeds(case),
        *_range(matching.trim, member.name, what.split()[-1]),
        *_against_load(matching.load),
        *_changes(matching),
        *_losses(matching),
    ]
    action = _setting(result, matching, equal)
    own = Verdict(
        level, text, tuple(sentences), name="trim",
        action=Action(action) if action else None,
    )  # fmt: skip
    return under(own, whole_verdict(result, search=own.action is None))


def _trim(ratio: float) -> str:
    return f"{100.0 * ratio:.3f} %"


def _setting(result: TrainResult, matching: Matching, equal: bool) -> str:
    """Return what to set for equal shares, and within what; empty where nothing is known."""
    case, drive = matching.case, matching.drive
    slope = _steepest(case, result.cases, drive)
    within = f"±{percent(_TOLERATED)} load share"
    span = f" ± {_needed(slope)} %" if slope > 0.0 else ""
    if case.case.on_motors:
        change = nan if equal else _motor_change(matching)
        if isnan(change):
            return f"Match speeds within {_needed(slope)} % for {within}." if span and equal else ""
        way = "faster" if change > 0.0 else "slower"
        return f"Set the motor of {case.members[drive].name} {abs(change):.2f} % {way}."
    if not matching.equal.status.solved:
        return ""
    now, even = (of.members[drive].speed_trim for of in (case, matching.equal))
    (_, before), (share, after) = _largest_creep(case), _largest_creep(matching.equal)
    if not equal and share > 1.0 and after > (1.0 + _ALIKE) * before:
        return (
            f"Leave trim at {_trim(now)}: equal sharing at {_trim(even)} raises creep from "
            f"{named('exit_creep', before)} to {named('exit_creep', after)}."
        )
    if abs(now - even) < _AS_FAST:
        if not span:
            return f"Leave trim at {_trim(even)}."
        return f"Set trim to {100.0 * even:.3f}{span} for {within}."
    return f"Set trim from {_trim(now)} to {_trim(even)}."


def _largest_creep(case: CaseResult) -> tuple[float, float]:
    """Largest creep of the drums over its limit [-], and that creep, whichever way it pulls [m]."""
    share, most = 0.0, 0.0
    for member in case.members:
        if member.arc.share_of_limit > share:
            share, most = member.arc.share_of_limit, abs(member.arc.exit_creep)
    return share, most


def _steepest(of: CaseResult, cases: Sequence[CaseResult], drive: int) -> float:
    """Share that a trim of 0.1 % moves at most of a load, in any condition [-]; 0 if not known."""
    most = 0.0
    for one in cases:
        solved = one.status is TrainStatus.SOLVED and _load(one) == _load(of)
        slope = abs(one.share_per_trim(drive)) if solved else 0.0
        if isfinite(slope):
            most = max(most, slope)
    return most


def _load(case: CaseResult) -> str:
    """Tensions at both ends of a train, in the digits that loads are told apart by."""
    last = case.members[len(case.members) - 1]
    return f"{case.members[0].arc.entry_tension:.6e} {last.arc.exit_tension:.6e}"


def _needed(slope: float) -> str:
    """How well speeds must match for a tolerated share, rounded down [%]."""
    needed = 0.1 * _TOLERATED / slope
    step = 10.0 ** (floor(log10(needed)) - 1)
    return f"{floor(needed / step + 1e-9) * step:.2g}"


def _who_and_why(matching: Matching) -> Iterator[str]:
    """Say which drive carries more and why, and what trim equalises."""
    case, equal, drive = matching.case, matching.equal, matching.drive
    m, even = case.members[drive], equal.members[drive]
    fair = 1.0 / len(case.members)
    gap = 100.0 * (m.speed_trim - even.speed_trim)
    trims = f"at a trim of {100.0 * m.speed_trim:.3f} %"
    more = "more" if m.share > fair else "less"
    if abs(m.share - fair) < _ALIKE:
        yield f"{m.name} takes its equal share {trims}."
    elif case.case.on_motors:
        yield f"{m.name} takes {more} than its equal share{_other_setting(matching)}."
    elif equal.status.solved:
        yield (
            f"{m.name} takes {more} than its equal share because it turns {abs(gap):.3f} % "
            f"{'faster' if gap > 0 else 'slower'} than equal shares need: {trims}, where "
            f"{100.0 * even.speed_trim:.3f} % equalises."
        )
    if equal.status.solved and drive > 0:
        yield f"With equal shares: {_speed_sentence(equal, even)}"


def _other_setting(matching: Matching) -> str:
    """Say what change of a motor makes the share of its drive equal, if one on the curve does."""
    change = _motor_change(matching)
    if isnan(change):
        return ""
    way = "faster" if change > 0.0 else "slower"
    return f": a motor set {abs(change):.2f} % {way} would equalise it"


def _motor_change(matching: Matching) -> float:
    """Return the change of a motor's speed that makes the share of its drive equal [%], or nan."""
    speeds = matching.trim.at(MarkKind.EQUAL, matching.drive)
    return 100.0 * (min(speeds, key=lambda v: abs(v - 1.0)) - 1.0) if speeds else nan


def _range(curve: ShareCurve, name: str, what: str) -> Iterator[str]:
    """Say between which trims no drive brakes, and where the limits of the drives are."""
    idle = curve.at(MarkKind.UNLOADED)
    if len(idle) >= 2:
        low, high = idle[0], idle[-1]
        yield (
            f"No drive brakes while the {what} of {name} is between {100.0 * low:.3f} % and "
            f"{100.0 * high:.3f} %; outside, one brakes against the others."
        )
    parts = []
    for kind in (MarkKind.CREEP_LIMIT, MarkKind.BREAKAWAY):
        for mark in curve.marks:
            if mark.kind is kind:
                who = curve.case.members[mark.drive].name
                parts.append(f"{who} {kind.value} at {100.0 * mark.value:.3f} %")
    if parts:
        yield f"As the {what} of {name} changes, {', '.join(parts)}."


def _against_load(curve: ShareCurve) -> Iterator[str]:
    """Say below which load a drive brakes though it pulls now."""
    for mark in curve.marks:
        if mark.kind is MarkKind.UNLOADED:
            who = curve.case.members[mark.drive].name
            yield (
                f"With these speeds {who} transmits nothing at {percent(mark.value)} of the "
                "load; on the other side of it the drives oppose each other."
            )


def _changes(matching: Matching) -> Iterator[str]:
    before = [m.share for m in matching.case.members]
    for change in matching.changes:
        index = [m.name for m in matching.case.members].index(change.pulley)
        if change.lagging is None:
            what = f"With {named('lagging_thickness', change.wear)} worn off {change.pulley}"
        else:
            what = f"With {change.pulley} {change.lagging.condition}"
        if not change.after.status.solved:
            yield f"{what}: {change.after.reason}"
            continue
        after = change.after.members[index].share
        note = _condition_note(change.lagging.notes) if change.lagging else ""
        yield f"{what}{note} its share goes from {percent(before[index])} to {percent(after)}."


def _condition_note(notes: tuple[str, ...]) -> str:
    """Return the last note on a lagging, which tells how it came to its condition."""
    return f" ({notes[-1]})" if notes else ""


def _losses(matching: Matching) -> Iterator[str]:
    """Say what creep costs, and how that changes with the split."""
    case, equal = matching.case, matching.equal
    if not isfinite(case.loss_ratio):
        return
    costs = [f"{percent(case.loss_ratio)} of the power now"]
    fair = 1.0 / len(case.members)
    alike = all(abs(m.share - fair) < _ALIKE for m in case)
    if not alike and equal.status.solved and isfinite(equal.loss_ratio):
        costs.append(f"{percent(equal.loss_ratio)} with equal shares")
    curve, name = matching.trim, case.members[matching.drive].name
    for mark in curve.marks:
        if mark.kind is MarkKind.UNLOADED:
            who = case.members[mark.drive].name
            costs.append(f"{percent(mark.loss_ratio)} where {who} transmits nothing")
    known = [
        (loss, s[matching.drive]) for loss, s in zip(curve.loss_ratio, curve.shares, strict=True)
    ]
    known += [(mark.loss_ratio, mark.shares[matching.drive]) for mark in curve.marks]
    least, share = min(found for found in known if isfinite(found[0]))
    best = f"{percent(float(least))} with {percent(float(share), 2)} on {name}"
    yield f"Creep costs {', '.join(costs)}; the minimum by trimming is {best}."
