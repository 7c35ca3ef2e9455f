"""The drive to begin with: what it is, and its answers, solved once when the server starts."""

from fastapi import Request, Response

from wraparc.errors import InputError
from wraparc.web.answers import documents, drives
from wraparc.web.answers.shown import Answer, Data, DriveKind
from wraparc.web.asked import FastRequest, SolveRequest
from wraparc.web.errors import ApiError
from wraparc.web.examples import examples
from wraparc.web.routes.parts import State, json_answer, router, state_of
from wraparc.web.settings import Settings
from wraparc.web.work import QUICK

api = router("/start", "drives")


class StartAnswer(Answer):
    """The drive to show first, and the file it was read from."""

    name: str
    kind: DriveKind
    document: Data
    toml: str
    file: str | None


class StartSolved(Answer):
    """What a page asks of a drive that it opens."""

    quick: drives.FastAnswer
    whole: drives.SolveAnswer


def _first(settings: Settings) -> StartAnswer:
    first, file = examples()[0], settings.start_file or None
    name, document, toml = first.name, settings.start, settings.start_text
    if document is None:
        document, toml = first.document, first.text
    elif file:
        name = file.replace("\\", "/").rpartition("/")[2].removesuffix(".toml")
    kind = documents.kind_of(document)
    document = documents.json_like(document)
    return StartAnswer(name=name, kind=kind, document=document, toml=toml, file=file)


async def solve_first(state: State) -> None:
    """Have the drive to begin with solved, as a page asks for it."""
    document, workers = _first(state.settings).document, state.workers
    quick = FastRequest(document=document, governing=True, prepared=True)
    whole = SolveRequest(document=document, prepared=True)
    try:
        await workers.filled
        state.first = b'{"quick":%b,"whole":%b}' % (
            await workers.short("", drives.solve_fast, quick, queue=QUICK),
            await workers.short("", drives.solve_all, whole),
        )
    except (InputError, ApiError):
        return  # the page asks, and is told


@api.get("")
def start(request: Request) -> StartAnswer:
    """The drive that the server was started with, or the first example."""
    return _first(state_of(request).settings)


@api.get("/solved", response_model=StartSolved, responses={204: {"description": "Not yet."}})
async def start_solved(request: Request) -> Response:
    """The answers of the drive to begin with, once they are there."""
    found = state_of(request).first
    return json_answer(found) if found else Response(status_code=204)
