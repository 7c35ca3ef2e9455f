"""Requests made from the OpenAPI document, right and wrong: no fault, answers as it promises."""

import re
import tempfile
from collections.abc import Iterator
from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, settings
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import (
    response_schema_conformance,
    status_code_conformance,
)

from web.calculators import API, PATIENCE
from wraparc.web.answers import files
from wraparc.web.app import create_app
from wraparc.web.asked import ReportRequest
from wraparc.web.settings import Settings

pytestmark = pytest.mark.usefixtures("solved_once")

_HOST = {"host": "127.0.0.1:8765"}
_folder = tempfile.TemporaryDirectory(prefix="wraparc-fuzz-")
_APP = create_app(Settings(workers=0, database=f"sqlite:///{_folder.name}/designs.sqlite"))
SCHEMA = schemathesis.openapi.from_asgi(
    f"{API}/openapi.json", _APP, headers=_HOST, timeout=PATIENCE
)


@pytest.fixture(scope="module", autouse=True)
def each_note_is_made_once() -> Iterator[None]:
    """Most requests for a note differ in a header or a letter alone; a note takes a second."""
    made: dict[tuple[str, str], bytes] = {}
    make = files.report

    def once(asked: ReportRequest, kind: files.NoteKind) -> bytes:
        # a text of the longest length that is allowed stands for one shorter by a letter
        key = (re.sub(r"(.)\1{40,}", r"\1", asked.model_dump_json()), kind)
        if key not in made:
            made[key] = make(asked, kind)
        return made[key]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(files, "report", once)
        yield


@SCHEMA.parametrize()  # type: ignore[untyped-decorator]
@settings(
    max_examples=2,
    derandomize=True,
    deadline=None,
    phases=[Phase.explicit, Phase.generate],
    suppress_health_check=list(HealthCheck),
)
def test_no_request_makes_a_fault(case: Any) -> None:
    checks = [not_a_server_error, response_schema_conformance, status_code_conformance]
    case.call_and_validate(headers=_HOST, checks=checks, timeout=PATIENCE)


def test_the_document_has_every_part_of_the_calculator() -> None:
    # guards the test above against passing on an empty document
    paths = _APP.openapi()["paths"]
    for part in ("/solve", "/compare", "/train", "/tests/{session}/fit", "/designs", "/report"):
        assert any(path.startswith(API + part) for path in paths), part
