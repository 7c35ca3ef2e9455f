"""Studies: started, followed, cancelled, looked at."""

from fastapi import Request, Response

from wraparc.web.answers import studies
from wraparc.web.answers.shown import Answer, Data, Table, Text, Verdict
from wraparc.web.answers.texts import PlanAnswer
from wraparc.web.asked import StudyRequest
from wraparc.web.errors import refused
from wraparc.web.progress import Tell
from wraparc.web.routes.parts import (
    Standing,
    client_of,
    json_answer,
    picture_of,
    refuses,
    router,
    state_of,
)
from wraparc.web.work import JOB_LIMIT

api = router("/studies", "studies")
_FILES = {
    "report.html": ("html", "text/html; charset=utf-8"),
    "results.parquet": ("parquet", "application/vnd.apache.parquet"),
}


class JobAnswer(Standing):
    """How a study stands."""

    title: str


class StudyAnswer(JobAnswer):
    """How a study stands, and what came out once it is done, and of what."""

    study: Data | None = None
    document: Data | None = None
    subtitle: Text | None = None
    verdict: Verdict | None = None
    tables: list[Table] | None = None
    remarks: list[Text] | None = None
    table_sources: list[str] | None = None
    summary: Data | None = None
    spreads: list[studies.Spread] | None = None
    pictures: list[str] | None = None
    files: list[str] | None = None


class JobsAnswer(Answer):
    """All studies."""

    jobs: list[JobAnswer]


@api.post("", status_code=202, responses=refuses(429, 501))
async def start(request: Request, response: Response, asked: StudyRequest) -> JobAnswer:
    """Start a study; what is wrong is told at once."""
    state, client = state_of(request), client_of(request)
    checked = await state.workers.long(client, studies.check, asked)
    size = studies.Size.model_validate_json(checked)

    async def work(tell: Tell) -> studies.StudyResult:
        result = await state.workers.apart(client, studies.run, asked, limit=JOB_LIMIT, tell=tell)
        return studies.StudyResult.model_validate_json(result)

    job = state.jobs.start(client, size.title, size.rows, work)
    job.asked = asked
    response.headers["location"] = f"{api.prefix}/{job.id}"
    return JobAnswer.model_validate(job)


@api.get("")
async def listed(request: Request) -> JobsAnswer:
    """All studies of this server, the newest first."""
    return JobsAnswer(
        jobs=[JobAnswer.model_validate(job) for job in state_of(request).jobs.listed()]
    )


@api.post("/toml", response_model=PlanAnswer)
async def text(request: Request, asked: StudyRequest) -> Response:
    """The file of a study, as `wraparc study` reads it."""
    workers = state_of(request).workers
    return json_answer(await workers.short(client_of(request), studies.text, asked))


@api.get("/{study}", response_model_exclude_unset=True)
async def one(request: Request, study: str) -> StudyAnswer:
    """How a study stands, and its results."""
    job = state_of(request).jobs.get(study)
    told = JobAnswer.model_validate(job).model_dump()
    if job.state == "done":
        result: studies.StudyResult = job.result
        files = [name for name, (key, _) in _FILES.items() if getattr(result, key)]
        sheet = result.model_dump(exclude={"title", "html", "parquet", "pictures"})
        told |= {**sheet, "pictures": list(result.pictures), "files": files}
        told |= job.asked.model_dump()
    return StudyAnswer(**told)


@api.delete("/{study}", status_code=204)
async def end(request: Request, study: str) -> None:
    """Cancel a study at work, forget another."""
    state_of(request).jobs.end(study)


@api.get("/{study}/pictures/{name}", response_class=Response, responses=refuses(409))
async def picture(request: Request, study: str, name: str) -> Response:
    """A picture of a study that is done, SVG."""
    result: studies.StudyResult = state_of(request).jobs.result(study)
    return picture_of(result.pictures, name)


class LinkAnswer(Answer):
    """A link that is used once, within a minute, without a token."""

    href: str


@api.get("/{study}/files/{name}", response_class=Response, responses=refuses(409))
async def download(request: Request, study: str, name: str) -> Response:
    """Results to keep: the report as HTML, or all results as Parquet."""
    return _file(request, study, name)


@api.post("/{study}/files/{name}/link", status_code=201, responses=refuses(409))
async def link(request: Request, study: str, name: str) -> LinkAnswer:
    """A link to results to keep, for the browser: it is used once, within a minute."""
    file = _file(request, study, name)
    return LinkAnswer(href=state_of(request).links.make(lambda: file))


def _file(request: Request, study: str, name: str) -> Response:
    if name not in _FILES:
        raise refused(404, "there is no such file")
    key, media = _FILES[name]
    content = getattr(state_of(request).jobs.result(study), key)
    if not content:
        message = "these results are too large to be kept here"
        raise refused(404, message, "Run the study on the command line.")
    headers = {"content-disposition": f'attachment; filename="{name}"'}
    return Response(content, media_type=media, headers=headers)
