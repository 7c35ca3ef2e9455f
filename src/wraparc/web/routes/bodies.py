"""Bodies of requests: JSON, or the text of a drive file; what neither is, is told in a sentence."""

import json
from typing import Any

from fastapi import Request

from wraparc.errors import InputError
from wraparc.schema.source import parse
from wraparc.web.answers.documents import json_like
from wraparc.web.errors import ApiError, refused

_TOML = ("application/toml", "text/x-toml", "text/toml")
_PASSED = ("application/json", "multipart/form-data")
#: Tables within tables; those of a drive file are not a tenth as deep.
_DEEPEST = 60


class Body(Request):
    """A request whose body is read here, whatever its type."""

    def __init__(self, request: Request) -> None:
        kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
        scope = dict(request.scope)
        if not (kind.startswith(_PASSED) or kind.endswith("+json")):
            headers = request.headers.mutablecopy()
            headers["content-type"] = "application/json"  # so that it is asked for below
            scope["headers"] = headers.raw
        super().__init__(scope, request.receive)
        self._kind = kind

    async def json(self) -> Any:
        """Return the body as plain data."""
        content = await self.body()
        if self._kind in _TOML:
            return {"document": json_like(_toml(content))}
        if self._kind and "json" not in self._kind:
            message = f"a body of type {self._kind[:80]} cannot be read"
            remedy = (
                "Send JSON with -H 'Content-Type: application/json', "
                "or a drive file with -H 'Content-Type: application/toml'."
            )
            raise refused(415, message, remedy)
        return _json(content)


def _toml(content: bytes) -> Any:
    try:
        return parse(content.decode("utf-8"))
    except UnicodeDecodeError:
        raise refused(422, "the text is not UTF-8", "Save the file as UTF-8.") from None
    except InputError as error:
        raise ApiError(422, error.problems) from None


def _json(content: bytes) -> Any:
    try:
        text = content.decode("utf-8-sig")
        found = json.loads(text)
        deep = _depth(found) > _DEEPEST
        if "\\u" in text:  # what is written so may be half of a character
            json.dumps(found, ensure_ascii=False).encode("utf-8")
    except RecursionError:
        deep = True
    except UnicodeEncodeError:
        raise refused(422, "holds half of a character (a lone surrogate)") from None
    except UnicodeDecodeError:
        raise refused(422, "the body is not UTF-8") from None
    if deep:
        raise refused(422, "lists and tables lie too deep in each other", "Send a drive document.")
    return found


def _depth(value: Any) -> int:
    """Return how deep lists and tables lie in each other, at most a little beyond the limit."""
    level: list[Any] = [value]
    depth = 0
    while level and depth <= _DEEPEST:
        inner = [
            t.values() if isinstance(t, dict) else t for t in level if isinstance(t, dict | list)
        ]
        level = [value for values in inner for value in values]
        depth += 1
    return depth
