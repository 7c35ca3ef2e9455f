"""Results, profiles and the calculation note of a drive as files."""

from collections.abc import Callable

from fastapi import Request, Response

from wraparc.web.answers import files
from wraparc.web.answers.shown import Data
from wraparc.web.answers.texts import file_stem
from wraparc.web.asked import ExportRequest, ReportRequest
from wraparc.web.routes.parts import client_of, refuses, router, state_of, waited

api = router("", "report")
_RESULTS = {"json": "application/json", "csv": "text/csv; charset=utf-8"}
_NOTES = {
    "pdf": "application/pdf",
    "xlsx": "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
    "md": "text/markdown; charset=utf-8",
}


def _content(media: dict[str, str]) -> dict[int | str, Data]:
    return {200: {"content": {kind.partition(";")[0]: {} for kind in media.values()}}}


@api.post("/report/{kind}", response_class=Response, responses=_content(_NOTES) | refuses(501))
async def note(request: Request, kind: files.NoteKind, asked: ReportRequest) -> Response:
    """The calculation note as PDF, Excel workbook or Markdown."""
    return await _file(request, files.report, asked, kind, _NOTES[kind])


@api.post("/results/{kind}", response_class=Response, responses=_content(_RESULTS))
async def results(request: Request, kind: files.ExportKind, asked: ExportRequest) -> Response:
    """Results as JSON, or profiles as CSV, as `wraparc solve` writes them."""
    return await _file(request, files.export, asked, kind, _RESULTS[kind])


async def _file(
    request: Request, make: Callable[..., bytes], asked: ExportRequest, kind: str, media: str
) -> Response:
    asked = asked.model_copy(update={"name": file_stem(asked.name)})
    work = state_of(request).workers.short(client_of(request), make, asked, kind)
    headers = {"content-disposition": f'attachment; filename="{asked.name}.{kind}"'}
    return Response(await waited(request, work), headers=headers, media_type=media)
