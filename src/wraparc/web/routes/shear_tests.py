"""Shear tests: machine files dropped, described, fitted. Nothing is kept on the disk."""

import base64
import json
from typing import Annotated, Any

from fastapi import APIRouter, File, Request, Response, UploadFile

from wraparc.web import models
from wraparc.web.errors import ApiError, Data, json_bytes, problems_data
from wraparc.web.routes.parts import State, json_answer, state_of
from wraparc.web.sessions import (
    LIFE,
    MOST_FILE,
    MOST_FILES,
    MOST_SESSION,
    Session,
    Upload,
    shown_name,
)

router = APIRouter(prefix="/api/v1/tests", tags=["shear tests"])
_ANSWERS = "wraparc.web.answers.shear_tests"
_READ_LIMIT, _FIT_LIMIT = 60.0, 300.0


@router.post("", status_code=201, summary="Begin: a place for files, in memory, for a while")
def create(request: Request) -> Response:
    """Return the name of a new session."""
    session = state_of(request).sessions.create()
    limits = {"files": MOST_FILES, "file_bytes": MOST_FILE, "session_bytes": MOST_SESSION}
    data = {"session": session.id, "expires_in": LIFE, "limits": limits}
    return json_answer(json_bytes(data), 201)


@router.get("/{session}", summary="The files and what was read of them")
def listed(request: Request, session: str) -> Response:
    """Return everything known of the files of a session."""
    return json_answer(json_bytes(_all(state_of(request).sessions.get(session))))


@router.post("/{session}/files", summary="Drop files")
async def add(
    request: Request,
    session: str,
    files: Annotated[list[UploadFile], File(max_length=MOST_FILES, description="Machine files.")],
) -> Response:
    """Take files and say what was understood of each."""
    state = state_of(request)
    place = state.sessions.get(session)
    uploads = [
        state.sessions.add(place, shown_name(file.filename), await file.read()) for file in files
    ]
    await _read(state, uploads)
    return json_answer(json_bytes({"files": [_data(upload) for upload in uploads]}))


@router.put("/{session}/files/{number}", summary="Say what a file does not: pressure, columns")
async def describe(
    request: Request, session: str, number: str, body: models.TestFileRequest
) -> Response:
    """Take what the user says about a file, and read it again."""
    state = state_of(request)
    upload = state.sessions.upload(state.sessions.get(session), number)
    upload.said = body.model_dump()
    await _read(state, [upload])
    return json_answer(json_bytes(_data(upload)))


@router.delete("/{session}/files/{number}", status_code=204, summary="Take a file away")
def remove(request: Request, session: str, number: str) -> Response:
    """Forget a file."""
    sessions = state_of(request).sessions
    sessions.remove(sessions.get(session), number)
    return Response(status_code=204)


@router.delete("/{session}", status_code=204, summary="Forget all files")
def forget(request: Request, session: str) -> Response:
    """Forget a session."""
    state_of(request).sessions.forget(session)
    return Response(status_code=204)


@router.post("/{session}/example", summary="Fill in virtual tests, for trying")
async def example(request: Request, session: str) -> Response:
    """Add virtual tests of a known law."""
    state = state_of(request)
    place = state.sessions.get(session)
    made = json.loads(await state.workers.short(f"{_ANSWERS}:virtual_files", {}))
    uploads = []
    for file in made["files"]:
        upload = state.sessions.add(place, file["name"], base64.b64decode(file["data"]))
        upload.said = {**file["said"], "illustrative": True}
        uploads.append(upload)
    await _read(state, uploads)
    return json_answer(json_bytes({"files": [_data(upload) for upload in uploads]}))


@router.post("/{session}/fit", summary="Fit the lagging")
async def fit(request: Request, session: str, body: models.FitRequest) -> Response:
    """Fit the friction law; tests that cannot be used are named, the others go on."""
    state = state_of(request)
    place = state.sessions.get(session)
    uploads = list(place.uploads.values())
    files = [{"id": u.id, "name": u.name, "data": u.data, "said": u.said} for u in uploads]
    illustrative = bool(uploads) and any(u.said.get("illustrative") for u in uploads)
    task = {**body.model_dump(), "files": files, "illustrative": illustrative}
    return json_answer(await state.workers.long(f"{_ANSWERS}:fit", task, _FIT_LIMIT))


async def _read(state: State, uploads: list[Upload]) -> None:
    """Read files in a process of their own; if one file ends it, each in its own."""
    files = [{"name": u.name, "data": u.data, "said": u.said} for u in uploads]
    try:
        answer = await state.workers.long(f"{_ANSWERS}:read_files", {"files": files}, _READ_LIMIT)
        for upload, found in zip(uploads, json.loads(answer)["files"], strict=True):
            upload.read = found
    except ApiError as error:
        if len(uploads) == 1:
            uploads[0].read = {"read": False, "problems": problems_data(error.problems)}
            return
        for upload in uploads:
            await _read(state, [upload])


def _all(session: Session) -> Data:
    return {"files": [_data(u) for u in session.uploads.values()], "expires_in": LIFE}


def _data(upload: Upload) -> Data:
    said: dict[str, Any] = {key: upload.said.get(key) for key in ("pressure", "normal_force")}
    said |= {key: upload.said.get(key, "") for key in ("repeat", "sample")}
    return {
        "id": upload.id,
        "name": upload.name,
        "bytes": len(upload.data),
        "tables": [],
        "columns": [],
        "notes": [],
        "preview": None,
        "pressure_guess": None,
        "place": "",
        **said,
        "condition": upload.said.get("condition") or "dry",
        "choices": upload.said.get("choices") or {},
        "illustrative": bool(upload.said.get("illustrative")),
        **upload.read,
    }
