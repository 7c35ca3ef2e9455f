"""Bodies of requests: JSON, the text of a drive file, files; what is none is told in a sentence.

Nothing here that grows with a body runs on the event loop: JSON is read in a thread, which cannot
be long at what `wraparc.schema.bounds` lets through, and TOML, which takes longer, in a process.
"""

import asyncio
import io
import json
from email.message import Message
from typing import Any

from fastapi import Request
from pydantic import BaseModel, ValidationError
from starlette.datastructures import FormData, Headers, UploadFile

from wraparc.errors import InputError
from wraparc.schema.bounds import check_json
from wraparc.web.answers.documents import toml_as_json
from wraparc.web.errors import ApiError, refused, request_problems
from wraparc.web.turns import Turns
from wraparc.web.work import QUICK, Workers

_TOML = ("application/toml", "text/x-toml", "text/toml")
_FILES = "multipart/form-data"
_PASSED = ("application/json", _FILES)
#: Bodies beyond this [bytes] are read one after the other, so that many do not add up.
_LARGE = 50_000
#: Most parts of a body of files, and most bytes of the head of one.
_MOST_PARTS, _LONGEST_HEAD = 100, 8_000
_MOST_WAITING = 200


class Readers:
    """Who reads bodies: the processes, and a place for one large body at a time."""

    def __init__(self, workers: Workers) -> None:
        self.workers = workers
        self.large = Turns(1, 1, _MOST_WAITING)


class Body(Request):
    """A request whose body is read here, whatever its type.

    Parameters
    ----------
    request
        As it came.
    readers
        Who reads.
    model
        What its JSON must have the form of, if anything.
    """

    def __init__(self, request: Request, readers: Readers, model: Any = None) -> None:
        kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
        scope = dict(request.scope)
        if not (kind.startswith(_PASSED) or kind.endswith("+json")):
            headers = request.headers.mutablecopy()
            headers["content-type"] = "application/json"  # so that it is asked for below
            scope["headers"] = headers.raw
        super().__init__(scope, request.receive)
        self._kind, self._readers, self._client = kind, readers, request.client
        is_model = isinstance(model, type) and issubclass(model, BaseModel)
        self._model: type[BaseModel] | None = model if is_model else None

    async def json(self) -> Any:
        """Return the body as plain data, or as what it must have the form of."""
        content = await self.body()
        if self._kind in _TOML:
            content = await self._from_toml(content)
        elif self._kind and "json" not in self._kind:
            message = f"a body of type {self._kind[:80]} cannot be read"
            remedy = (
                "Send JSON with -H 'Content-Type: application/json', "
                "or a drive file with -H 'Content-Type: application/toml'."
            )
            raise refused(415, message, remedy)
        if len(content) <= _LARGE:
            return await asyncio.to_thread(_read, content, self._model)
        async with self._readers.large.turn(self._client.host if self._client else ""):
            return await asyncio.to_thread(_read, content, self._model)

    async def _from_toml(self, content: bytes) -> bytes:
        client = self._client.host if self._client else ""
        try:
            return await self._readers.workers.short(client, toml_as_json, content, queue=QUICK)
        except InputError as error:
            raise ApiError(422, error.problems) from None

    async def form(self, **_: Any) -> FormData:  # type: ignore[override]
        """Return files and fields as they came; they stay in memory, whatever their size."""
        if not self._kind.startswith(_FILES):
            return FormData()
        content = await self.body()
        return await asyncio.to_thread(_parts, content, self.headers["content-type"])


def _read(content: bytes, model: type[BaseModel] | None) -> Any:
    try:
        found = _json(content)
    except InputError as error:
        raise ApiError(422, error.problems) from None
    if model is None:
        return found
    try:
        return model.model_validate(found)
    except ValidationError as error:
        raise ApiError(422, request_problems(error.errors(include_url=False))) from None


def _json(content: bytes) -> Any:
    try:
        text = content.decode("utf-8-sig")
        check_json(text)
        found = json.loads(text)
        if "\\u" in text:  # what is written so may be half of a character
            json.dumps(found, ensure_ascii=False).encode("utf-8")
    except UnicodeEncodeError:
        raise refused(422, "contains half of a character (a lone surrogate)") from None
    except UnicodeDecodeError:
        raise refused(422, "the body is not UTF-8") from None
    except (RecursionError, ValueError) as error:
        if isinstance(error, json.JSONDecodeError | InputError):
            raise
        raise refused(400, "the body cannot be read", "Send a drive document.") from None
    return found


def _parts(content: bytes, kind: str) -> FormData:
    """Return the parts of a body of files (RFC 7578), cut out of it as they are."""
    said = Message()
    said["content-type"] = kind
    boundary = str(said.get_param("boundary", "")).encode("latin-1", "replace")
    if not boundary:
        raise refused(400, "the body names no boundary of its parts", "Send it as a form does.")
    mark = b"\r\n--" + boundary
    if content.count(mark) > _MOST_PARTS:
        raise refused(413, f"more than {_MOST_PARTS} parts", "Send fewer files at a time.")
    first, *pieces = content.split(mark)
    if first.startswith(mark[2:]):
        pieces.insert(0, first.removeprefix(mark[2:]))
    if not pieces or not pieces.pop().startswith(b"--"):
        raise refused(400, "the body ends before its last part", "Send it again.")
    return FormData([_part(piece) for piece in pieces])


def _part(piece: bytes) -> tuple[str, UploadFile | str]:
    end = piece.find(b"\r\n\r\n", 0, _LONGEST_HEAD)
    if end < 0:
        raise refused(400, "a part of the body has no head", "Send it as a form does.")
    said, headers = Message(), {}
    for line in piece[:end].decode("utf-8", "replace").split("\r\n"):
        key, _, value = line.partition(":")
        headers[key.strip().lower()] = value.strip()
    said["content-disposition"] = headers.get("content-disposition", "")
    name = said.get_param("name", header="content-disposition")
    file = said.get_param("filename", header="content-disposition")
    data = piece[end + 4 :]
    if file is None:
        return _named(name), data.decode("utf-8", "replace")
    return _named(name), UploadFile(
        io.BytesIO(data), size=len(data), filename=_named(file), headers=Headers(headers)
    )


def _named(given: Any) -> str:
    """Return a name in the head of a part: in quotes, or with its alphabet (RFC 2231)."""
    if isinstance(given, tuple):
        alphabet, _, text = given
        try:
            return str(text).encode("latin-1").decode(alphabet or "utf-8", "replace")
        except (LookupError, UnicodeEncodeError):
            return str(text)
    return str(given or "")
