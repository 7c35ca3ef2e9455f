"""Saved designs."""

import getpass
from typing import Annotated

from fastapi import APIRouter, Path, Query, Request, Response

from wraparc.web import answer_models as told
from wraparc.web import models
from wraparc.web.answers.documents import read
from wraparc.web.database.store import NewerVersionError, NoSuchDesignError
from wraparc.web.errors import ApiError, Data, json_bytes, refused
from wraparc.web.routes.parts import json_answer, state_of
from wraparc.web.settings import Settings

router = APIRouter(prefix="/api/v1/designs", tags=["designs"])
Number = Annotated[int, Path(ge=1, le=2**31 - 1)]


@router.get("", summary="Saved designs, last changed first", responses=told.answers(told.Designs))
def listed(
    request: Request,
    query: Annotated[str, Query(max_length=200)] = "",
    offset: Annotated[int, Query(ge=0, le=10**6)] = 0,
    limit: Annotated[int, Query(ge=1, le=200)] = 50,
) -> Response:
    """List designs whose name contains a text."""
    found = state_of(request).store.listed(_storable(query), offset, limit)
    return json_answer(json_bytes(found))


@router.post(
    "",
    status_code=201,
    summary="Save a new design",
    responses=told.answers(told.VersionAnswer, 201),
)
def create(request: Request, body: models.DesignRequest) -> Response:
    """Save a design that can be read; its first version."""
    state = state_of(request)
    kind = _checked(body.document)
    who = _who(body.who, state.settings)
    found = state.store.create(body.name, kind, body.document, note=body.note, who=who)
    return json_answer(json_bytes(found), 201)


@router.get(
    "/{design}",
    summary="A design and its versions",
    responses=told.answers(told.DesignAnswer, 200, 404),
)
def one(request: Request, design: Number) -> Response:
    """Return a design without documents."""
    try:
        return json_answer(json_bytes(state_of(request).store.design(design)))
    except NoSuchDesignError:
        raise _unknown() from None


@router.get(
    "/{design}/versions/{version}",
    summary="One version with its document",
    responses=told.answers(told.VersionAnswer, 200, 404),
)
def one_version(request: Request, design: Number, version: Number) -> Response:
    """Open a version."""
    try:
        return json_answer(json_bytes(state_of(request).store.version(design, version)))
    except NoSuchDesignError:
        raise _unknown() from None


@router.post(
    "/{design}/versions",
    status_code=201,
    summary="Save a new version",
    responses=told.answers(told.VersionAnswer, 201, 404, 409),
)
def add(request: Request, design: Number, body: models.VersionRequest) -> Response:
    """Save a version made from the newest one; refused if somebody was faster."""
    state = state_of(request)
    kind = _checked(body.document)
    who = _who(body.who, state.settings)
    try:
        found = state.store.add(design, body.base, kind, body.document, note=body.note, who=who)
    except NoSuchDesignError:
        raise _unknown() from None
    except NewerVersionError as error:
        message = f"version {error.newest} of this design was saved meanwhile"
        remedy = "Open it and look, or save this one under another name."
        raise refused(409, message, remedy, "base") from None
    return json_answer(json_bytes(found), 201)


@router.patch("/{design}", status_code=204, summary="Give a design another name")
def rename(request: Request, design: Number, body: models.RenameRequest) -> Response:
    """Rename a design."""
    try:
        state_of(request).store.rename(design, body.name)
    except NoSuchDesignError:
        raise _unknown() from None
    return Response(status_code=204)


@router.delete("/{design}", status_code=204, summary="Delete a design and its versions")
def delete(request: Request, design: Number) -> Response:
    """Delete a design."""
    try:
        state_of(request).store.delete(design)
    except NoSuchDesignError:
        raise _unknown() from None
    return Response(status_code=204)


def _checked(document: Data) -> str:
    """Return the kind of a document that can be read; what is saved can be opened and solved."""
    read(document)
    several = len(document["pulley"]) > 1
    return "train" if several or "train" in document else "drive"


def _who(given: str, settings: Settings) -> str:
    if given or not settings.local:
        return given
    try:
        return getpass.getuser()[:200]
    except (OSError, KeyError, ImportError):
        return ""


def _storable(text: str) -> str:
    """Return a text without what databases do not take."""
    return "".join(c for c in text if c.isprintable())


def _unknown() -> ApiError:
    return refused(404, "there is no such design", "Choose one of the list.")
