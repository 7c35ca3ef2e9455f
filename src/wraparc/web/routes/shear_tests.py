"""Shear tests: machine files dropped, described, fitted. Nothing is kept on the disk."""

import pickle
from typing import Annotated

from fastapi import File, Query, Request, Response, UploadFile

from wraparc.web.answers import shear_tests
from wraparc.web.answers.shear_tests import MachineFile, ReadFile, ReadFiles
from wraparc.web.answers.shown import Answer, Data
from wraparc.web.answers.texts import PlanAnswer
from wraparc.web.asked import FileChoices, FitRequest, TestFileRequest
from wraparc.web.errors import ApiError, told
from wraparc.web.routes.parts import (
    client_of,
    json_answer,
    refuses,
    router,
    state_of,
    waited,
)
from wraparc.web.sessions import (
    LIFE,
    MOST_FILE,
    MOST_FILES,
    MOST_SESSION,
    Upload,
    shown_name,
)

api = router("/tests", "shear tests")
_READ_LIMIT, _FIT_LIMIT = 60.0, 300.0


class SessionAnswer(Answer):
    """A place for files, how long it is kept [s], and its limits."""

    session: str
    expires_in: float
    limits: dict[str, int]


class FileAnswer(ReadFile):
    """A file, what is said of it and what was understood."""

    id: str
    name: str
    bytes: int
    pressure: str | None
    normal_force: str | None
    condition: str
    repeat: str
    sample: str
    use: bool
    reason: str
    choices: FileChoices
    curve_pressures: dict[str, str]
    more: Data
    illustrative: bool

    @classmethod
    def of(cls, upload: Upload) -> "FileAnswer":
        """Return what is known of an upload."""
        known = {"id": upload.id, "name": upload.name, "bytes": len(upload.data)}
        said = upload.said.model_dump()
        said["condition"] = said["condition"] or "dry"
        return cls(**upload.read.model_dump(), **known, **said)


class FilesAnswer(Answer):
    """Files just taken."""

    files: list[FileAnswer]


class SessionFiles(FilesAnswer):
    """All files of a session."""

    expires_in: float


@api.post("", status_code=201, responses=refuses(429))
async def create(request: Request, response: Response) -> SessionAnswer:
    """Begin: a place for files, in memory, for a while."""
    session = state_of(request).sessions.create()
    response.headers["location"] = f"{api.prefix}/{session.id}"
    limits = {"files": MOST_FILES, "file_bytes": MOST_FILE, "session_bytes": MOST_SESSION}
    return SessionAnswer(session=session.id, expires_in=LIFE, limits=limits)


@api.get("/{session}")
async def listed(request: Request, session: str) -> SessionFiles:
    """The files and what was read of them."""
    uploads = state_of(request).sessions.get(session).uploads.values()
    return SessionFiles(files=[FileAnswer.of(upload) for upload in uploads], expires_in=LIFE)


@api.post("/{session}/files")
async def add(
    request: Request,
    session: str,
    files: Annotated[list[UploadFile], File(max_length=MOST_FILES, description="Machine files.")],
    named: Annotated[bool, Query(description="Take condition and pressure of the names.")] = (
        False
    ),
) -> FilesAnswer:
    """Drop files; what was understood of each is answered."""
    state = state_of(request)
    place = state.sessions.get(session)
    uploads = []
    for file in files:
        upload = state.sessions.add(place, shown_name(file.filename), await file.read())
        if named:
            upload.said = shear_tests.said_by_name(upload.name)
        uploads.append(upload)
        await file.close()  # else it is held twice until it was read
    return await _read(request, uploads)


@api.put("/{session}/files/{number}")
async def describe(
    request: Request, session: str, number: str, asked: TestFileRequest
) -> FileAnswer:
    """Say what a file does not: pressure, columns."""
    sessions = state_of(request).sessions
    upload = sessions.upload(sessions.get(session), number)
    upload.said = asked
    return (await _read(request, [upload])).files[0]


@api.delete("/{session}/files/{number}", status_code=204)
async def remove(request: Request, session: str, number: str) -> None:
    """Take a file away."""
    sessions = state_of(request).sessions
    place = sessions.get(session)
    del place.uploads[sessions.upload(place, number).id]


@api.delete("/{session}", status_code=204)
async def forget(request: Request, session: str) -> None:
    """Forget all files."""
    state_of(request).sessions.forget(session)


@api.post("/{session}/example")
async def example(request: Request, session: str) -> FilesAnswer:
    """Fill in virtual tests of a known law, for trying."""
    state = state_of(request)
    place = state.sessions.get(session)
    answer = await state.workers.short(client_of(request), shear_tests.virtual_files)
    made: list[MachineFile] = pickle.loads(answer)  # noqa: S301 - of our own process
    uploads = [state.sessions.add(place, file.name, file.data) for file in made]
    for upload, file in zip(uploads, made, strict=True):
        upload.said = file.said
    return await _read(request, uploads)


@api.post("/{session}/fit", response_model=shear_tests.FitAnswer, responses=refuses(501))
async def fit(request: Request, session: str, asked: FitRequest) -> Response:
    """Fit the friction law; tests that cannot be used are named, the others go on."""
    state = state_of(request)
    files = [upload.file for upload in state.sessions.get(session).uploads.values()]
    client = client_of(request)
    work = state.workers.long(client, shear_tests.fit, asked, files, limit=_FIT_LIMIT)
    return json_answer(await waited(request, work))


@api.post("/{session}/plan", response_model=PlanAnswer)
async def plan(request: Request, session: str, asked: FitRequest) -> Response:
    """The test plan as a file, as `wraparc fit` reads it beside the files of the machine."""
    state = state_of(request)
    files = [upload.file for upload in state.sessions.get(session).uploads.values()]
    work = state.workers.short(client_of(request), shear_tests.plan_file, asked, files)
    return json_answer(await work)


async def _read(request: Request, uploads: list[Upload]) -> FilesAnswer:
    """Read files in a process of their own; if one file ends it, each in its own."""
    await _read_in(request, uploads)
    return FilesAnswer(files=[FileAnswer.of(upload) for upload in uploads])


async def _read_in(request: Request, uploads: list[Upload]) -> None:
    workers, client = state_of(request).workers, client_of(request)
    files = [upload.file for upload in uploads]
    try:
        work = workers.read(client, shear_tests.read_files, files, limit=_READ_LIMIT)
        answer = await waited(request, work)
        found = ReadFiles.model_validate_json(answer).files
        for upload, read in zip(uploads, found, strict=True):
            upload.read = read
    except ApiError as error:
        if len(uploads) == 1:
            uploads[0].read = ReadFile(problems=told(error.problems))
            return
        for upload in uploads:
            await _read_in(request, [upload])
