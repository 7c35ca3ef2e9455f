"""A drive document to the answer: fast for one arc, or everything there is to say."""

import math

from wraparc.actions import find_action
from wraparc.answer.answer_data import text_data
from wraparc.answer.arc_tables import answer_table, creep_table
from wraparc.answer.checks_table import check_table
from wraparc.answer.conditions_table import conditions_table
from wraparc.answer.document import sources_of
from wraparc.answer.drive_sheet import arc_tables, input_sheet, summary_table
from wraparc.answer.least_tension import (
    least_data,
    least_sentence,
    least_table,
    shown_least,
)
from wraparc.answer.reserve_check import judge_uncertain
from wraparc.answer.sources import Sources
from wraparc.answer.train_sheet import train_input_sheet
from wraparc.answer.verdict_data import action_data
from wraparc.answer.words import (
    alone_of,
    format_verdict,
    order_in,
    short,
    stated_action,
    verdict,
)
from wraparc.arc import ArcResult, Distributed, DriveResult, WrapArc, solve
from wraparc.checks import Level, judge, least_tension
from wraparc.checks import Verdict as Judgement
from wraparc.drive import Drive
from wraparc.schema.source import parse
from wraparc.train import Train, TrainResult, solve_train
from wraparc.train.whole import Whole, by_pulley
from wraparc.web.answers.documents import asked_for, case_only, read
from wraparc.web.answers.judging import Judging, judging
from wraparc.web.answers.prepared import Prepared, prepared
from wraparc.web.answers.shown import (
    Action,
    Answer,
    Bar,
    Change,
    Data,
    DriveKind,
    Profile,
    Sheet,
    Source,
    StatusName,
    Table,
    Tested,
    Text,
    Verdict,
    bars,
    finite,
    numbers,
    outside,
    sheet,
    status_of,
    tables,
    texts,
    worded,
)
from wraparc.web.answers.solved import solved_by_paper, solved_whole
from wraparc.web.answers.trains import TrainPart, train_part
from wraparc.web.asked import ActionRequest, CheckRequest, FastRequest, SolveRequest

_PAPER_POINTS = 121


class Arc(Answer):
    """One pulley in one load case."""

    pulley: str
    load_case: str
    status: StatusName
    level: Level
    levels: dict[str, Level]
    creep_limit: float
    numbers: dict[str, float | None]
    profile: Profile
    tested: Tested | None
    outside: list[tuple[float, float]]
    tables: list[Table]


class FastAnswer(Arc):
    """One arc without capacities."""

    sequence: int
    kind: DriveKind
    verdict: Verdict
    remarks: list[Text]
    prepared: Prepared | None


class Paper(Answer):
    """The same arc by the paper's integration."""

    status: StatusName
    numbers: dict[str, float | None]
    profile: Profile


class WholeArc(Arc):
    """One arc with everything there is to say; `raise_to` is for this load case alone [N].

    Of arcs of one level that of the least `order` comes off worst.
    """

    bars: list[Bar]
    status_text: str
    short: str
    order: float
    raise_to: float | None
    unbounded: list[str]
    table_sources: list[str]
    paper: Paper


class Place(Answer):
    """Which arc; of a solved drive that which governs its verdict."""

    pulley: str
    load_case: str


class Marks(Answer):
    """What of the numbers must be known."""

    illustrative: bool
    calibrated: bool
    outside_tested: bool


class LeastTension(Answer):
    """The least slack-side tension with which every check that it helps passes [N], [kg].

    `raise_to` is that tension where it is more than given.
    """

    tension: float | None
    given: float | None
    counterweight: float | None
    governing: str
    level: Level
    raise_to: float | None
    shown: Text
    sentence: Text
    table: Table


class SolveAnswer(Answer):
    """A solved drive."""

    sequence: int
    kind: DriveKind
    title: str
    description: str
    solved: bool
    within_creep_limit: bool
    governing: Place
    verdict: Verdict
    remarks: list[Text]
    conditions: Table | None
    checks: Table
    least_tension: LeastTension | None
    summary: Table | None
    sources: list[Source]
    has: Marks
    arcs: list[WholeArc]
    train: TrainPart | None
    judging: Judging | None


class SheetAnswer(Sheet):
    """What was read of a drive."""

    kind: DriveKind


def solve_fast(asked: FastRequest) -> FastAnswer:
    """One arc without capacities, for sliders."""
    thing, whole = read(asked.document), None
    method = Distributed(points=asked.points, capacities=False)
    if isinstance(thing, Train):
        meant = thing.case().name if asked.load_case is None else asked.load_case
        name = None if asked.governing else meant
        whole = solve_train(case_only(thing, name), method=method, raise_on_failure=False)
        result = _meant(whole, asked)
        drive = whole.drive_result().drive
    elif asked.governing:
        drive = thing
        result = _meant(solve(drive, method=method, raise_on_failure=False), asked)
    else:
        drive = thing
        at = asked_for(drive, asked.pulley, asked.load_case)
        result = method.solve(WrapArc.of(drive, *at))
    pulley, load = asked_for(drive, result.arc.pulley, result.arc.load_case)
    answered = DriveResult(drive, (result,))

    if whole is None:
        told = verdict(answered, search=False)
    else:
        own = judge(whole).at(pulley.name, load.name)
        told = format_verdict(own, own.full, stated_action(own))
    wanted = asked.tables and result.status.solved
    made = {"answer": answer_table((result,)), "creep": creep_table((result,))} if wanted else {}
    return FastAnswer(
        sequence=asked.sequence,
        kind="train" if isinstance(thing, Train) else "drive",
        verdict=Verdict.of(told),
        tables=tables([*made.values()], made),
        remarks=_remarks(answered),
        prepared=prepared(asked.document, drive, pulley, load)
        if asked.prepared and drive is thing
        else None,
        **_arc(whole or answered, result),
    )


def _meant(whole: Whole, asked: FastRequest) -> ArcResult:
    """Return the arc of a solved drive or train that is asked for."""
    found = by_pulley(whole)
    if asked.governing:
        judged = judge(whole)
        return min(found, key=lambda r: _order(judged.at(r.arc.pulley, r.arc.load_case)))
    pulley, load = asked_for(found.drive, asked.pulley, asked.load_case)
    return found.arc(pulley.name, load.name)


def _order(judged: Judgement) -> tuple[int, float]:
    """Return the place of an arc among those of a drive: the least governs."""
    return -judged.level.rank, order_in(judged)


class ActionAnswer(Answer):
    """What to do about the verdict on a drive; None where every check passes."""

    sequence: int
    action: Action | None


def propose_action(asked: ActionRequest) -> ActionAnswer:
    """What to do about the verdict, each change solved and judged before it is offered."""
    action = find_action(solved_whole(asked.document, asked.load_case, Distributed().points))
    plain = None if action is None else action_data(action, text_data)
    return ActionAnswer(
        sequence=asked.sequence,
        action=None if plain is None else Action.model_validate(plain),
    )


class ReserveChange(Answer):
    """The smallest change of an input that changes the level, see `wraparc.reserve.Flip`.

    `name` and `shown` are its words; `changes` make it, in the document, as it is shown: none where
    no key does.
    """

    input: str
    pulley: str | None
    lagging: str | None
    load_case: str | None
    change: float
    level: Level
    uncertainty: float
    uncertainty_kind: str
    source: str | None
    name: Text
    shown: Text
    changes: list[Change]


class ReserveAnswer(Answer):
    """How little of an input changes the verdict: a line, and each change."""

    sequence: int
    text: Text | None
    changes: list[ReserveChange]


def nearest_changes(asked: ActionRequest) -> ReserveAnswer:
    """The smallest change of each input at which the level of the verdict changes."""
    from wraparc.answer.reserve_words import (  # solves rows
        flip_data,
        input_name,
        nearest_text,
        percent_text,
        rounded_change,
    )
    from wraparc.reserve import find_reserve
    from wraparc.reserve.keys import ReserveKeys

    whole = solved_whole(asked.document, asked.load_case, Distributed().points)
    drive, reserve, keys = by_pulley(whole).drive, find_reserve(whole), ReserveKeys.of(whole)
    return ReserveAnswer(
        sequence=asked.sequence,
        text=worded(nearest_text(reserve, drive)),
        changes=[
            ReserveChange(
                **flip_data(flip),
                name=worded(input_name(flip.input, drive)),
                shown=worded(percent_text(flip.change)),
                changes=[
                    Change({"key": c.key, "from": c.before, "to": c.after, "unit": c.unit})
                    for c in keys.changes(flip.input, 1.0 + rounded_change(flip.change))
                ],
            )
            for flip in reserve.flips
        ],
    )


def solve_all(asked: SolveRequest) -> SolveAnswer:
    """Every arc by both methods, with capacities, as ``wraparc solve --method both`` gives it."""
    train: TrainPart | None = None
    whole = solved_whole(asked.document, asked.load_case, asked.points)
    if isinstance(whole, TrainResult):
        first, train = whole.drive_result(), train_part(whole, search=asked.search)
    else:
        first = whole
    drive, second = first.drive, solved_by_paper(first.drive)
    sources = [Source(**source) for source in sources_of(drive)]
    summary = tables([summary_table((first, second), whole)], ["summary"])
    arcs = [_whole_arc(whole, first, a, b) for a, b in zip(first, second, strict=True)]
    governing = min(arcs, key=lambda arc: (-arc.level.rank, arc.order))
    return SolveAnswer(
        sequence=asked.sequence,
        kind="drive" if train is None else "train",
        title=drive.title,
        description=drive.description,
        solved=first.solved,
        within_creep_limit=first.within_creep_limit,
        governing=Place(pulley=governing.pulley, load_case=governing.load_case),
        verdict=(train and train.verdict) or Verdict.of(verdict(first, search=asked.search)),
        remarks=_remarks(first),
        conditions=_conditions(first, whole),
        checks=tables([check_table(judge_uncertain(whole))], ["checks"])[0],
        least_tension=_least(whole),
        summary=summary[0] if len(first) > 1 else None,
        sources=sources,
        has=Marks(
            illustrative=any(s.kind == "illustrative" for s in sources),
            calibrated=any(s.kind == "calibrated" for s in sources),
            outside_tested=any(a.extrapolates for a in first),
        ),
        arcs=arcs,
        train=train,
        judging=judging(asked.document, first)
        if asked.prepared and asked.load_case is None and first is whole
        else None,
    )


def _conditions(result: DriveResult, whole: Whole) -> Table | None:
    if not result.drive.conditions:
        return None
    return tables([conditions_table(result, whole)], ["conditions"])[0]


def _least(result: DriveResult | TrainResult) -> LeastTension | None:
    found = least_data(result)
    if found is None:
        return None
    return LeastTension(
        **{name: finite(found[name]) for name in ("tension", "given", "counterweight")},
        governing=found["governing"],
        level=found["level"],
        raise_to=raise_to(result),
        shown=worded(shown_least(result)),
        sentence=worded(least_sentence(result)),
        table=tables([least_table(result)], ["least"])[0],
    )


def raise_to(result: DriveResult | TrainResult) -> float | None:
    """Return the slack-side tension to raise to [N]; None where nothing is to be raised."""
    found = least_tension(result)
    return None if found is None else found.raise_to


def _alone(answered: DriveResult, result: ArcResult) -> float | None:
    """Return the tension to raise to if there were but this load case, on a single pulley."""
    return None if len(answered.drive.pulleys) > 1 else raise_to(alone_of(answered, result))


def _remarks(answered: DriveResult) -> list[Text]:
    return texts(judge(answered).remarks)


def check(asked: CheckRequest) -> SheetAnswer:
    """What is read of a drive; solves nothing."""
    thing = read(parse(asked.toml) if asked.toml is not None else asked.document or {})
    if isinstance(thing, Drive):
        return SheetAnswer(kind="drive", **sheet(input_sheet(thing)))
    return SheetAnswer(kind="train", **sheet(train_input_sheet(thing)))


def _whole_arc(
    whole: Whole, answered: DriveResult, result: ArcResult, paper: ArcResult
) -> WholeArc:
    of = Sources()
    made = arc_tables(answered, (result, paper), of)
    judged = judge(whole).at(result.arc.pulley, result.arc.load_case)
    return WholeArc(
        bars=bars(judged.listed),
        status_text=str(result.status),
        short=short(whole, result),
        order=order_in(judged),
        raise_to=_alone(answered, result),
        unbounded=[n for n, value in result.scalars().items() if math.isinf(value)],
        tables=tables([*made.values()], made),
        table_sources=list(of.listed()),
        paper=Paper(
            status=status_of(paper),
            numbers=numbers(paper.scalars()),
            profile=Profile.of(paper.profile, _PAPER_POINTS),
        ),
        **_arc(whole, result),
    )


def _arc(whole: Whole, result: ArcResult) -> Data:
    judged = judge(whole).at(result.arc.pulley, result.arc.load_case)
    return {
        "pulley": result.arc.pulley,
        "load_case": result.arc.load_case,
        "status": status_of(result),
        "level": judged.level,
        "levels": {c.name: c.level for c in judged.listed if c.level is not Level.NOT_CHECKED},
        "creep_limit": result.arc.creep_limit,
        "numbers": numbers(result.scalars()),
        "profile": Profile.of(result.profile),
        "tested": result.arc.law.tested,
        "outside": outside(result),
    }
