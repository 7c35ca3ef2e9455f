"""Drives: form, catalogue, examples, solving, texts, comparison, trains."""

from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from wraparc.errors import Problem, shown
from wraparc.web import answer_models as told
from wraparc.web import models
from wraparc.web.answers import catalogue, form
from wraparc.web.answers.texts import json_like
from wraparc.web.errors import ApiError, json_bytes
from wraparc.web.examples import examples
from wraparc.web.routes.parts import json_answer, long, short, state_of
from wraparc.web.work import QUICK

router = APIRouter(prefix="/api/v1", tags=["drives"])
_DRIVES = "wraparc.web.answers.drives"
_TEXTS = "wraparc.web.answers.texts"


@router.get("/schema", summary="The drive form: sections, fields, units, glossary")
def schema() -> Response:
    """Return what a form must know of the drive file."""
    return json_answer(json_bytes(form.form()))


@router.get("/catalogue", summary="Belts, laggings, design values, examples")
def whole_catalogue() -> Response:
    """Return everything there is to choose from."""
    return json_answer(json_bytes(catalogue.whole()))


@router.get("/catalogue/laggings/{name}", summary="One lagging and its friction curves")
async def one_lagging(
    request: Request,
    name: str,
    condition: Annotated[str | None, Query(max_length=60)] = None,
) -> Response:
    """Return a lagging of the catalogue."""
    body = {"name": name, "condition": condition}
    workers = state_of(request).workers
    return json_answer(await workers.short("wraparc.web.answers.catalogue:lagging", body))


@router.get("/examples/{name}", summary="An example drive")
def one_example(name: str) -> Response:
    """Return an example as document and as text."""
    found = next((e for e in examples() if e.name == name), None)
    if found is None:
        there = ", ".join(e.name for e in examples())
        problem = Problem(
            message="there is no such example", remedy=f"There are {there}.", value=shown(name)
        )
        raise ApiError(404, problem)
    document = json_like(found.document)
    data = {"name": name, "kind": found.kind, "document": document, "toml": found.text}
    return json_answer(json_bytes(data))


@router.get("/start", summary="The drive that the server was started with")
def start(request: Request) -> Response:
    """Return the drive to show first."""
    settings = state_of(request).settings
    if settings.start is not None:
        document, file = settings.start, settings.start_file
        several = "train" in document or len(document.get("pulley", ())) > 1  # type: ignore[arg-type]
        name = file.replace("\\", "/").rpartition("/")[2].removesuffix(".toml")
        kind = "train" if several else "drive"
        data = {"name": name, "kind": kind, "document": json_like(document), "file": file}
        return json_answer(json_bytes(data))
    first = examples()[0]
    data = {
        "name": first.name,
        "kind": first.kind,
        "document": json_like(first.document),
        "file": None,
    }
    return json_answer(json_bytes(data))


@router.post(
    "/solve/fast",
    summary="One arc without capacities, for sliders",
    responses=told.answers(told.FastAnswer),
)
async def solve_fast(request: Request, body: models.FastRequest) -> Response:
    """Solve one arc by the main solver."""
    return await short(request, f"{_DRIVES}:solve_fast", body, QUICK)


@router.post(
    "/solve",
    summary="Every arc by both methods, with capacities",
    responses=told.answers(told.SolveAnswer),
)
async def solve(request: Request, body: models.SolveRequest) -> Response:
    """Solve a drive as ``wraparc solve --method both`` does."""
    return await short(request, f"{_DRIVES}:solve_all", body)


@router.post(
    "/check", summary="Read a drive and solve nothing", responses=told.answers(told.SheetAnswer)
)
async def check(request: Request, body: models.CheckRequest) -> Response:
    """Say what was read of a drive, or everything that is wrong with it."""
    if (body.document is None) == (body.toml is None):
        problem = Problem(message="give either document or toml", remedy="Leave one out.")
        raise ApiError(422, problem)
    return await short(request, f"{_DRIVES}:check", body)


@router.post(
    "/toml/read",
    summary="Text of a drive file to its document",
    responses=told.answers(told.ReadAnswer),
)
async def read_toml(request: Request, body: models.TomlRequest) -> Response:
    """Read the text of a drive file."""
    return await short(request, f"{_TEXTS}:read_toml", body)


@router.post(
    "/toml/write",
    summary="Document to the text of a drive file",
    responses=told.answers(told.WriteAnswer),
)
async def write_toml(request: Request, body: models.DocumentRequest) -> Response:
    """Write the text of a drive file."""
    return await short(request, f"{_TEXTS}:write_toml", body)


@router.post("/lagging/read", summary="Text of a lagging file to a table for a drive document")
async def read_lagging(request: Request, body: models.LaggingRequest) -> Response:
    """Read the text of a lagging file."""
    return await short(request, f"{_TEXTS}:read_lagging", body)


@router.post(
    "/quantities",
    summary="Read and convert quantities as typed",
    responses=told.answers(told.QuantitiesAnswer),
)
async def quantities(request: Request, body: models.QuantitiesRequest) -> Response:
    """Read quantities as strictly as the drive file does."""
    return await short(request, f"{_TEXTS}:quantities", body, QUICK)


@router.post(
    "/compare",
    summary="The same drive with other laggings or belts",
    responses=told.answers(told.CompareAnswer),
)
async def compare(request: Request, body: models.CompareRequest) -> Response:
    """Solve and price the drive with each of them."""
    return await short(request, "wraparc.web.answers.compare:compare", body)


@router.post("/train", summary="Several drives on one belt")
async def train(request: Request, body: models.TrainRequest) -> Response:
    """Divide the load; with ``match``, how it moves with speed, diameter and load."""
    where = "wraparc.web.answers.trains:train"
    return await (long if body.match else short)(request, where, body)
