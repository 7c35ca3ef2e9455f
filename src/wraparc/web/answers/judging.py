"""What the drive page needs to judge a drive of one pulley itself, its numbers moved."""

from wraparc.arc import ArcResult, DriveResult, Status
from wraparc.checks import idle
from wraparc.schema.source import Document
from wraparc.web.answers.prepared import Plain, Prepared, elsewhere, prepared


class JudgedCase(Plain):
    """One load case: its arc as numbers, and what it has nothing from."""

    load_case: str
    prepared: Prepared
    elsewhere: list[list[str | int]]


class Judging(Plain):
    """A drive of one pulley."""

    cases: list[JudgedCase]


def judging(document: Document, result: DriveResult) -> Judging | None:
    """Return what a page judges a drive by; None where it needs more than the page has."""
    drive = result.drive
    if len(drive.pulleys) > 1 or drive.pulleys[0].across or any(map(_servers, result)):
        return None
    cases = []
    for case in drive.load_cases:
        ready = prepared(document, drive, drive.pulleys[0], case)
        if ready is None:
            return None
        at = elsewhere(document, drive, case)
        cases.append(JudgedCase(load_case=case.name, prepared=ready, elsewhere=at))
    return Judging(cases=cases)


def _servers(result: ArcResult) -> bool:
    """Whether an arc has numbers that only the server finds."""
    fitted = result.arc.fit is not None and bool(result.arc.fit.knots)
    return result.status is Status.UNSOLVED or idle(result.arc) or fitted
