"""Drives: form, catalogue, examples, solving, texts, comparison, trains."""

from collections.abc import Callable
from functools import cache
from typing import Annotated

from fastapi import File, Form, Query, Request, Response, UploadFile

from wraparc.errors import shown
from wraparc.web.answers import (
    across,
    book,
    catalogue,
    choosing,
    compare,
    documents,
    drives,
    form,
    measured,
    questions,
    seek,
    texts,
    trains,
)
from wraparc.web.answers.shown import Answer, Data, DriveKind
from wraparc.web.errors import refused
from wraparc.web.examples import examples
from wraparc.web.routes.parts import (
    client_of,
    json_answer,
    offer,
    router,
    state_of,
    waited,
)
from wraparc.web.sessions import shown_name
from wraparc.web.work import QUICK

api = router("", "drives")
# before all others, which are tried in this order: it is asked for at every step of a slider
offer(api, "/solve/fast", drives.solve_fast, queue=QUICK)


class ExampleAnswer(Answer):
    """An example as document and as text."""

    name: str
    kind: DriveKind
    document: Data
    toml: str


@cache
def _written(of: Callable[[], Answer]) -> bytes:
    """Return what is the same for every page, written once: of the form that takes 20 ms."""
    return of().model_dump_json().encode()


@api.get("/schema", response_model=form.Form)
async def schema() -> Response:
    """The drive form: sections, fields, units, glossary."""
    return json_answer(_written(form.form))


@api.get("/catalogue", response_model=catalogue.Catalogue)
async def whole_catalogue() -> Response:
    """Belts, laggings, design values, examples."""
    return json_answer(_written(catalogue.whole))


@api.get("/book", response_model=book.Book)
async def whole_book() -> Response:
    """What a page puts drives of one pulley together from itself."""
    return json_answer(_written(book.book))


@api.get("/catalogue/laggings/{name}", response_model=catalogue.LaggingAnswer)
async def one_lagging(
    request: Request,
    name: str,
    condition: Annotated[str | None, Query(max_length=60)] = None,
) -> Response:
    """One lagging and its friction curves."""
    workers = state_of(request).workers
    return json_answer(await workers.short(client_of(request), catalogue.lagging, name, condition))


@api.get("/examples/{name}")
def one_example(name: str) -> ExampleAnswer:
    """An example drive, as document and as text."""
    found = next((e for e in examples() if e.name == name), None)
    if found is None:
        there = f"There are {', '.join(e.name for e in examples())}."
        raise refused(404, "there is no such example", there, value=shown(name))
    document = documents.json_like(found.document)
    return ExampleAnswer(name=name, kind=found.kind, document=document, toml=found.text)


offer(api, "/solve", drives.solve_all)
offer(api, "/solve/action", drives.propose_action)
offer(api, "/solve/reserve", drives.nearest_changes)
offer(api, "/check", drives.check)
offer(api, "/toml/read", texts.read_toml)
offer(api, "/toml/write", texts.write_toml)
offer(api, "/lagging/read", texts.read_lagging)
offer(api, "/quantities", texts.quantities, queue=QUICK)
offer(api, "/compare", compare.compare)
offer(api, "/seek", seek.seek_value)
offer(api, "/what-if", questions.changed)
offer(api, "/field", questions.expected)
offer(api, "/measured", measured.compare_measured, long=lambda asked: True)
offer(api, "/choose", choosing.chosen, long=lambda asked: True)
offer(api, "/train", trains.train, long=lambda asked: asked.match)
offer(api, "/across", across.solve_width)
offer(api, "/across/wear", across.wear_width, long=lambda asked: True)
offer(api, "/across/thickness", across.thickness_width)


@api.post("/across/profile", response_model=across.ProfileAnswer)
async def measured_profile(
    request: Request,
    file: Annotated[UploadFile, File(description="Positions and readings over the face.")],
    width: Annotated[str, Form(max_length=60)] = "",
    unit: Annotated[str, Form(max_length=20)] = "",
    new: Annotated[str, Form(max_length=60)] = "",
) -> Response:
    """A measured profile as rows of ``[pulley.across]``, smoothed."""
    data, name = await file.read(), shown_name(file.filename)
    work = state_of(request).workers.short(
        client_of(request), across.read_profile, data, name, width, unit, new
    )
    return json_answer(await waited(request, work))
