"""A drive document to the answer: fast for one arc, or everything there is to say."""

import math
from dataclasses import replace

from wraparc.arc import ArcResult, Distributed, DriveResult, PaperMarch, WrapArc, solve
from wraparc.drive import Drive, LoadCase, Pulley, design_remarks
from wraparc.errors import placed
from wraparc.present.arc_tables import answer_table, capacity_table, creep_table, energy_table
from wraparc.present.design_values import comparison_table
from wraparc.present.document import sources_of
from wraparc.present.drive_sheet import summary_table
from wraparc.present.inputs import input_table
from wraparc.present.sheet import Table
from wraparc.present.sources import Sources
from wraparc.present.words import level_of, short, verdict
from wraparc.train import Train, solve_train
from wraparc.units import System
from wraparc.web.answers.documents import read
from wraparc.web.answers.shown import (
    Data,
    numbers_data,
    outside_data,
    profile_data,
    table_data,
    tables_data,
    tested_data,
    texts_data,
    verdict_data,
)
from wraparc.web.answers.solving import main_solver

_PAPER_POINTS = 121
TABLES = ("answer", "creep", "capacity", "comparison", "energy", "inputs")


def solve_fast(request: Data) -> Data:
    """Solve one arc without capacities: what a slider needs."""
    thing = read(request["document"])
    points = request["points"]
    method = main_solver(points, capacities=False)
    drive = thing if isinstance(thing, Drive) else _divided(thing, request["load_case"], points)
    pulley, case = asked_for(drive, request)
    result = method.solve(WrapArc.of(drive, pulley, case))
    answered = DriveResult(drive, (result,))
    return {
        "sequence": request["sequence"],
        "kind": "drive" if isinstance(thing, Drive) else "train",
        "pulley": pulley.name,
        "load_case": case.name,
        "verdict": verdict_data(lambda system: verdict(answered, system)),
        "tables": tables_data(_first_tables(result, "si"), _first_tables(result, "us"), TABLES[:2])
        if request["tables"] and result.status.solved
        else [],
        "remarks": _remarks(drive),
        **_arc_numbers(result),
    }


def _first_tables(result: ArcResult, system: System) -> list[Table | None]:
    return [answer_table((result,), system), creep_table((result,), system)]


def _divided(train: Train, load_case: str | None, points: int) -> Drive:
    """Return the drive of a train with the tensions that its division of the load makes."""
    train = _case_only(train, load_case or train.cases[0].name)
    method = Distributed(points=points, capacities=False)
    return solve_train(train, method=method, raise_on_failure=False).drive_result().drive


def solve_all(request: Data) -> Data:
    """Solve everything by both methods, as ``wraparc solve --method both`` does."""
    thing = read(request["document"])
    train_part = None
    if isinstance(thing, Train):
        from wraparc.web.answers.trains import train_data

        thing = _case_only(thing, request["load_case"])
        solved_train = solve_train(thing, raise_on_failure=False)
        first = solved_train.drive_result()
        train_part = train_data(solved_train)
    else:
        if request["load_case"] is not None:
            with placed("load_case"):
                case = thing.load_case(request["load_case"])
            thing = replace(thing, load_cases=(case,))
        first = solve(thing, method=main_solver(request["points"]), raise_on_failure=False)
    drive = first.drive
    second = solve(drive, method=PaperMarch(), raise_on_failure=False)
    results = (first, second)
    summary = None
    if len(first) > 1:
        summary = table_data("summary", summary_table(results, "si"), summary_table(results, "us"))
    sources = sources_of(drive)
    return {
        "sequence": request["sequence"],
        "kind": "drive" if train_part is None else "train",
        "title": drive.title,
        "description": drive.description,
        "solved": first.solved,
        "within_creep_limit": first.within_creep_limit,
        "governing": {
            "pulley": first.governing.arc.pulley,
            "load_case": first.governing.arc.load_case,
        },
        "verdict": train_part["verdict"]
        if train_part
        else verdict_data(lambda system: verdict(first, system)),
        "remarks": _remarks(drive),
        "summary": summary,
        "sources": sources,
        "has": {
            "illustrative": any(s["kind"] == "illustrative" for s in sources),
            "calibrated": any(s["kind"] == "calibrated" for s in sources),
            "outside_tested": any(a.outside_tested_share > 0.0 for a in first),
        },
        "arcs": [_arc_data(drive, a, b) for a, b in zip(first, second, strict=True)],
        "train": train_part,
    }


def _case_only(train: Train, load_case: str | None) -> Train:
    if load_case is None:
        return train
    with placed("load_case"):
        return replace(train, cases=(train.case(load_case),))


def _arc_data(drive: Drive, result: ArcResult, paper: ArcResult) -> Data:
    of = Sources()
    si = _tables(drive, result, paper, "si", of)
    return {
        "pulley": result.arc.pulley,
        "load_case": result.arc.load_case,
        "status_text": str(result.status),
        "short": short(result),
        "unbounded": [n for n, value in result.scalars().items() if math.isinf(value)],
        "tables": tables_data(si, _tables(drive, result, paper, "us", Sources()), TABLES),
        "table_sources": list(of.listed()),
        "paper": {
            "status": paper.status.name.lower(),
            "numbers": numbers_data(paper.scalars()),
            "profile": profile_data(paper.profile, _PAPER_POINTS),
        },
        **_arc_numbers(result),
    }


def _arc_numbers(result: ArcResult) -> Data:
    return {
        "status": result.status.name.lower(),
        "level": level_of(result).value,
        "creep_limit": result.arc.creep_limit,
        "numbers": numbers_data(result.scalars()),
        "profile": profile_data(result.profile),
        "tested": tested_data(result),
        "outside": outside_data(result),
    }


def _tables(
    drive: Drive, result: ArcResult, paper: ArcResult, system: System, of: Sources
) -> list[Table | None]:
    pulley = drive.pulley(result.arc.pulley)
    solved = tuple(r for r in (result, paper) if r.status.solved)
    carried = result.status.solved
    return [
        answer_table(solved, system) if solved else None,
        creep_table(solved, system) if solved else None,
        capacity_table(result, system),
        comparison_table(result, pulley.lagging, system, of),
        energy_table(result, system) if carried else None,
        input_table(drive, pulley, result.arc, system, of),
    ]


def _remarks(drive: Drive) -> list[Data]:
    return texts_data(design_remarks(drive, "si"), design_remarks(drive, "us"))


def check(request: Data) -> Data:
    """Say what was read of a drive, and solve nothing."""
    from wraparc.present.drive_sheet import input_sheet
    from wraparc.present.train_sheet import train_input_sheet
    from wraparc.schema.source import parse
    from wraparc.web.answers.shown import sheet_data

    document = request.get("document")
    thing = read(parse(request["toml"]) if document is None else document)
    if isinstance(thing, Drive):
        return {"kind": "drive", **sheet_data(lambda system: input_sheet(thing, system))}
    return {"kind": "train", **sheet_data(lambda system: train_input_sheet(thing, system))}


def asked_for(drive: Drive, request: Data) -> tuple[Pulley, LoadCase]:
    """Return the pulley and the load case of a request, the first where it names none."""
    with placed("pulley"):
        pulley = drive.pulley(request["pulley"])
    with placed("load_case"):
        return pulley, drive.load_case(request["load_case"])
