"""The calculation note."""

from typing import Literal

from fastapi import Request, Response

from wraparc.web.answers.reports import report
from wraparc.web.answers.shown import Data
from wraparc.web.answers.texts import file_stem
from wraparc.web.asked import ReportRequest
from wraparc.web.routes.parts import client_of, refuses, router, state_of, waited

api = router("/report", "report")
_MEDIA = {
    "pdf": "application/pdf",
    "xlsx": "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
    "md": "text/markdown; charset=utf-8",
}
_CONTENT: Data = {"content": {media.partition(";")[0]: {} for media in _MEDIA.values()}}


@api.post("/{kind}", response_class=Response, responses={200: _CONTENT, **refuses(501)})
async def note(
    request: Request, kind: Literal["pdf", "xlsx", "md"], asked: ReportRequest
) -> Response:
    """The calculation note as PDF, Excel workbook or Markdown."""
    asked = asked.model_copy(update={"name": file_stem(asked.name)})
    work = state_of(request).workers.short(client_of(request), report, asked, kind)
    headers = {"content-disposition": f'attachment; filename="{asked.name}.{kind}"'}
    return Response(await waited(request, work), headers=headers, media_type=_MEDIA[kind])
