"""Drives in time: a run through an event started, followed, cancelled, looked at."""

from fastapi import Request, Response

from wraparc.web.answers import events
from wraparc.web.answers.shown import Answer, Bar, Sheet
from wraparc.web.asked import EventRequest
from wraparc.web.progress import Tell
from wraparc.web.routes.parts import client_of, picture_of, refuses, router, state_of
from wraparc.web.routes.studies import JobAnswer
from wraparc.web.work import JOB_LIMIT

api = router("/events", "events")


class RunAnswer(JobAnswer):
    """How a run stands, and what came out once it is done."""

    run: Sheet | None = None
    bars: list[Bar] | None = None
    stability: Sheet | None = None
    note: str | None = None
    played: events.Played | None = None
    pictures: list[str] | None = None


class RunsAnswer(Answer):
    """All runs."""

    jobs: list[RunAnswer]


@api.post("", status_code=202, responses=refuses(429, 501), response_model_exclude_unset=True)
async def start(request: Request, response: Response, asked: EventRequest) -> RunAnswer:
    """Start a run through an event; what is wrong is told at once."""
    state, client = state_of(request), client_of(request)
    checked = await state.workers.short(client, events.check, asked)
    named = events.Named.model_validate_json(checked)

    async def work(tell: Tell) -> events.EventResult:
        result = await state.workers.apart(client, events.run, asked, limit=JOB_LIMIT, tell=tell)
        return events.EventResult.model_validate_json(result)

    job = state.runs.start(client, named.title, events.PARTS, work)
    response.headers["location"] = f"{api.prefix}/{job.id}"
    return RunAnswer.model_validate(job)


@api.get("", response_model_exclude_unset=True)
async def listed(request: Request) -> RunsAnswer:
    """All runs of this server, the newest first."""
    return RunsAnswer(
        jobs=[RunAnswer.model_validate(job) for job in state_of(request).runs.listed()]
    )


@api.get("/{run}", response_model_exclude_unset=True)
async def one(request: Request, run: str) -> RunAnswer:
    """How a run stands, and its results."""
    job = state_of(request).runs.get(run)
    told = JobAnswer.model_validate(job).model_dump()
    if job.state == "done":
        found: events.EventResult = job.result
        told |= {**found.model_dump(), "pictures": list(found.pictures)}
    return RunAnswer(**told)


@api.delete("/{run}", status_code=204)
async def end(request: Request, run: str) -> None:
    """Cancel a run at work, forget another."""
    state_of(request).runs.end(run)


@api.get("/{run}/pictures/{name}", response_class=Response, responses=refuses(409))
async def picture(request: Request, run: str, name: str) -> Response:
    """A picture of a run that is done, SVG."""
    found: events.EventResult = state_of(request).runs.result(run)
    return picture_of(found.pictures, name)
