"""Studies: started, followed, cancelled, looked at."""

import json
from base64 import b64decode

from fastapi import APIRouter, Request, Response

from wraparc.web import answer_models as told
from wraparc.web import models
from wraparc.web.errors import Data, json_bytes, refused
from wraparc.web.jobs import Job
from wraparc.web.routes.parts import json_answer, state_of

router = APIRouter(prefix="/api/v1/studies", tags=["studies"])
_ANSWERS = "wraparc.web.answers.studies"
_FILES = {
    "report.html": ("html", "text/html; charset=utf-8"),
    "results.parquet": ("parquet", "application/vnd.apache.parquet"),
}


@router.post("", status_code=202, summary="Start a study", responses=told.answers(told.Job, 202))
async def start(request: Request, body: models.StudyRequest) -> Response:
    """Check a study and start it; what is wrong is told at once."""
    state = state_of(request)
    asked = body.model_dump()
    told = json.loads(await state.workers.long(f"{_ANSWERS}:check", asked))
    task = state.workers.task
    job = state.jobs.start(told["title"], lambda tell: task(f"{_ANSWERS}:run", asked, tell))
    job.total = told["rows"]
    return json_answer(json_bytes(job.told()), 202)


@router.get(
    "", summary="All studies of this server, the newest first", responses=told.answers(told.Jobs)
)
def listed(request: Request) -> Response:
    """Return how every study stands."""
    jobs = [job.told() for job in state_of(request).jobs.listed()]
    return json_answer(json_bytes({"jobs": jobs}))


@router.get(
    "/{study}",
    summary="How a study stands, and its results",
    responses=told.answers(told.Job, 200, 404),
)
def one(request: Request, study: str) -> Response:
    """Return a study, with tables and the names of pictures once it is done."""
    job = state_of(request).jobs.get(study)
    data = job.told()
    if job.state == "done":
        result = json.loads(job.result)
        files = [name for name, (key, _) in _FILES.items() if result[key]]
        kept = {k: v for k, v in result.items() if k not in ("html", "parquet", "pictures")}
        data |= {**kept, "title": job.title, "pictures": list(result["pictures"]), "files": files}
    return json_answer(json_bytes(data))


@router.delete("/{study}", status_code=204, summary="Cancel a study at work, forget another")
def end(request: Request, study: str) -> Response:
    """Cancel or forget a study."""
    state_of(request).jobs.end(study)
    return Response(status_code=204)


@router.get("/{study}/pictures/{name}", summary="A picture, SVG", response_class=Response)
def picture(request: Request, study: str, name: str) -> Response:
    """Return a picture of a study that is done."""
    found = _result(state_of(request).jobs.get(study))["pictures"].get(name)
    if found is None:
        raise refused(404, "there is no such picture")
    # what is drawn carries its styles in attributes; it is shown as an image, where nothing runs
    policy = "default-src 'none'; style-src 'unsafe-inline'"
    headers = {"content-security-policy": policy}
    return Response(found, media_type="image/svg+xml", headers=headers)


@router.get("/{study}/files/{name}", summary="Results to keep", response_class=Response)
def download(request: Request, study: str, name: str) -> Response:
    """Return the report as HTML, or all results as Parquet."""
    if name not in _FILES:
        raise refused(404, "there is no such file")
    key, media = _FILES[name]
    found = _result(state_of(request).jobs.get(study))[key]
    if not found:
        message = "these results are too large to be kept here"
        raise refused(404, message, "Run the study on the command line.")
    content = b64decode(found) if key == "parquet" else found
    headers = {"content-disposition": f'attachment; filename="{name}"'}
    return Response(content, media_type=media, headers=headers)


def _result(job: Job) -> Data:
    if job.state != "done":
        raise refused(409, "the study is not done", "Wait for it.")
    found: Data = json.loads(job.result)
    return found
