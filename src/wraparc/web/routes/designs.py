"""Saved designs."""

import asyncio
import getpass
from typing import Annotated

from fastapi import Header, Path, Query, Request, Response

from wraparc.web.answers.documents import kind_if_read
from wraparc.web.answers.shown import Data, DriveKind
from wraparc.web.asked import DesignRequest, RenameRequest, VersionRequest
from wraparc.web.database.store import DesignAnswer, Designs, VersionAnswer
from wraparc.web.routes.parts import client_of, refuses, router, state_of
from wraparc.web.settings import Settings
from wraparc.web.work import QUICK

api = router("/designs", "designs")
Number = Annotated[int, Path(ge=1, le=2**31 - 1)]


Key = Annotated[
    str | None,
    Header(
        alias="Idempotency-Key",
        min_length=1,
        max_length=200,
        pattern=r"^[\x21-\x7e]+$",
        description="Of this save: sent again with it, nothing is saved twice.",
    ),
]


@api.get("")
def listed(
    request: Request,
    query: Annotated[str, Query(max_length=200)] = "",
    offset: Annotated[int, Query(ge=0, le=10**6)] = 0,
    limit: Annotated[int, Query(ge=1, le=200)] = 50,
    binned: Annotated[bool, Query(alias="bin")] = False,
) -> Designs:
    """Saved designs whose name contains a text, last changed first; or those in the bin."""
    return state_of(request).store.listed(_storable(query), offset, limit, binned=binned)


@api.post("", status_code=201, responses=refuses(507))
async def create(
    request: Request, response: Response, asked: DesignRequest, key: Key = None
) -> VersionAnswer:
    """Save a new design that can be read; its first version."""
    kind = await _checked(request, asked.document)

    def save() -> VersionAnswer:
        state = state_of(request)
        who = _who(asked.who, state.settings)
        return state.store.create(
            asked.name, kind, asked.document, note=asked.note, who=who, request=key
        )

    return _located(response, await asyncio.to_thread(save))


@api.get("/{design}")
def one(request: Request, design: Number) -> DesignAnswer:
    """A design and its versions, without documents."""
    return state_of(request).store.design(design)


@api.get("/{design}/versions/{version}")
def one_version(request: Request, design: Number, version: Number) -> VersionAnswer:
    """One version with its document."""
    return state_of(request).store.version(design, version)


@api.post("/{design}/versions", status_code=201, responses=refuses(409, 507))
async def add(
    request: Request, response: Response, design: Number, asked: VersionRequest, key: Key = None
) -> VersionAnswer:
    """Save a new version, made from the newest one; refused if somebody was faster."""
    kind = await _checked(request, asked.document)

    def save() -> VersionAnswer:
        state = state_of(request)
        return state.store.add(
            design,
            asked.base,
            kind,
            asked.document,
            note=asked.note,
            who=_who(asked.who, state.settings),
            name=asked.name,
            request=key,
        )

    return _located(response, await asyncio.to_thread(save))


@api.patch("/{design}", status_code=204, responses=refuses(507))
def rename(request: Request, design: Number, asked: RenameRequest) -> None:
    """Give a design another name."""
    state_of(request).store.rename(design, asked.name)


@api.delete("/{design}", status_code=204, responses=refuses(507))
def delete(request: Request, design: Number, final: bool = False) -> None:
    """Put a design into the bin; with ``final``, delete it out of the bin for good."""
    store = state_of(request).store
    (store.delete if final else store.throw_away)(design)


@api.post("/{design}/restore", status_code=204, responses=refuses(507))
def restore(request: Request, design: Number) -> None:
    """Take a design out of the bin."""
    state_of(request).store.take_back(design)


def _located(response: Response, saved: VersionAnswer) -> VersionAnswer:
    response.headers["location"] = f"{api.prefix}/{saved.id}/versions/{saved.version}"
    return saved


async def _checked(request: Request, document: Data) -> DriveKind:
    """Return the kind of a document that can be read; what is saved can be opened and solved."""
    workers = state_of(request).workers
    kind = await workers.short(client_of(request), kind_if_read, document, queue=QUICK)
    return "train" if kind == b"train" else "drive"


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
