"""The calculation note."""

from typing import Literal

from fastapi import APIRouter, Request, Response

from wraparc.web import models
from wraparc.web.answers.texts import file_stem
from wraparc.web.routes.parts import state_of

router = APIRouter(prefix="/api/v1/report", tags=["report"])
_MEDIA = {
    "pdf": "application/pdf",
    "xlsx": "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
    "md": "text/markdown; charset=utf-8",
}


@router.post(
    "/{kind}",
    summary="The calculation note as PDF, Excel workbook or Markdown",
    response_class=Response,
    responses={200: {"content": {media.partition(";")[0]: {} for media in _MEDIA.values()}}},
)
async def report(
    request: Request, kind: Literal["pdf", "xlsx", "md"], body: models.ReportRequest
) -> Response:
    """Solve the drive and return its note."""
    stem = file_stem(body.name)
    task = {**body.model_dump(), "kind": kind, "name": stem}
    workers = state_of(request).workers
    content = await workers.short("wraparc.web.answers.reports:report", task)
    headers = {"content-disposition": f'attachment; filename="{stem}.{kind}"'}
    return Response(content, headers=headers, media_type=_MEDIA[kind])
