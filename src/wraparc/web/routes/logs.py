"""Logs of a plant: uploads, learning from them, its progress and end. All of it is in memory."""

from typing import Annotated

from fastapi import File, Request, Response, UploadFile

from wraparc.web.answers import logs
from wraparc.web.answers.shown import Answer, Data, Table, Text, Verdict
from wraparc.web.asked import LearnRequest
from wraparc.web.errors import refused
from wraparc.web.jobs import Job
from wraparc.web.progress import Tell
from wraparc.web.routes.parts import Standing, client_of, picture_of, refuses, router, state_of
from wraparc.web.sessions import LIFE, MOST_FILES, MOST_LOG, shown_name
from wraparc.web.work import JOB_LIMIT

api = router("/logs", "logs of a plant")


class LogFile(Answer):
    """A log that was dropped."""

    id: str
    name: str
    bytes: int


class LogFiles(Answer):
    """All logs of a session, and how long it lives [s]."""

    session: str
    expires_in: float
    files: list[LogFile]


class LearningAnswer(Standing):
    """How learning stands, and what came out once it is done."""

    title: Text | None = None
    subtitle: Text | None = None
    verdict: Verdict | None = None
    tables: list[Table] | None = None
    remarks: list[Text] | None = None
    table_sources: list[str] | None = None
    summary: Data | None = None
    findings: list[logs.LogFinding] | None = None
    pictures: list[str] | None = None
    toml: str | None = None
    name: str | None = None


@api.post("", status_code=201, responses=refuses(429))
async def create(request: Request) -> LogFiles:
    """Begin: a place for logs, in memory, for a while."""
    session = state_of(request).sessions.create()
    return LogFiles(session=session.id, expires_in=LIFE, files=[])


@api.post("/{session}/files")
async def add(
    request: Request,
    session: str,
    files: Annotated[list[UploadFile], File(max_length=MOST_FILES, description="Logs.")],
) -> LogFiles:
    """Drop logs; they are read when something is learned from them."""
    sessions = state_of(request).sessions
    place = sessions.get(session)
    for file in files:
        sessions.add(place, shown_name(file.filename), await file.read(), MOST_LOG)
        await file.close()
    return _listed(request, session)


@api.delete("/{session}/files/{number}")
async def remove(request: Request, session: str, number: str) -> LogFiles:
    """Take a log away."""
    sessions = state_of(request).sessions
    place = sessions.get(session)
    del place.uploads[sessions.upload(place, number).id]
    return _listed(request, session)


def _listed(request: Request, session: str) -> LogFiles:
    uploads = state_of(request).sessions.get(session).uploads.values()
    files = [LogFile(id=one.id, name=one.name, bytes=len(one.data)) for one in uploads]
    return LogFiles(session=session, expires_in=LIFE, files=files)


@api.post("/{session}/learn", status_code=202, responses=refuses(429))
async def learn(request: Request, session: str, asked: LearnRequest) -> LearningAnswer:
    """Learn the drive from the logs; what is wrong is in the answer of its state."""
    state, client = state_of(request), client_of(request)
    files = [upload.file for upload in state.sessions.get(session).uploads.values()]
    if not files:
        raise refused(422, "there is no log", "Drop the logs of the drive first.")

    async def work(tell: Tell) -> logs.LearnedResult:
        result = await state.workers.apart(
            client, logs.run, asked, files, limit=JOB_LIMIT, tell=tell
        )
        return logs.LearnedResult.model_validate_json(result)

    return _answer(state.learning.start(client, "", 100, work))


@api.get("/jobs/{job}", response_model_exclude_unset=True)
async def one(request: Request, job: str) -> LearningAnswer:
    """How learning stands, and its results."""
    return _answer(state_of(request).learning.get(job))


@api.delete("/jobs/{job}", status_code=204)
async def end(request: Request, job: str) -> None:
    """Cancel learning, or forget what came out."""
    state_of(request).learning.end(job)


@api.get("/jobs/{job}/pictures/{name}", response_class=Response, responses=refuses(409))
async def picture(request: Request, job: str, name: str) -> Response:
    """A picture of what was learned, SVG."""
    result: logs.LearnedResult = state_of(request).learning.result(job)
    return picture_of(result.pictures, name)


def _answer(job: Job) -> LearningAnswer:
    told = Standing.model_validate(job).model_dump()
    if job.state == "done":
        result: logs.LearnedResult = job.result
        told |= {**result.model_dump(exclude={"pictures"}), "pictures": list(result.pictures)}
    return LearningAnswer(**told)
