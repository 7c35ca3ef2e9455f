"""Results and profiles of a drive as files."""

from fastapi import Request, Response

from wraparc.web.answers.exports import ExportKind, export
from wraparc.web.answers.shown import Data
from wraparc.web.answers.texts import file_stem
from wraparc.web.asked import ExportRequest
from wraparc.web.routes.parts import client_of, router, state_of, waited

api = router("/results", "report")
_MEDIA = {"json": "application/json", "csv": "text/csv; charset=utf-8"}
_CONTENT: Data = {"content": {media.partition(";")[0]: {} for media in _MEDIA.values()}}


@api.post("/{kind}", response_class=Response, responses={200: _CONTENT})
async def results(request: Request, kind: ExportKind, asked: ExportRequest) -> Response:
    """Results as JSON, or profiles as CSV, as `wraparc solve` writes them."""
    asked = asked.model_copy(update={"name": file_stem(asked.name)})
    work = state_of(request).workers.short(client_of(request), export, asked, kind)
    headers = {"content-disposition": f'attachment; filename="{asked.name}.{kind}"'}
    return Response(await waited(request, work), headers=headers, media_type=_MEDIA[kind])
