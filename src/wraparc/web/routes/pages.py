"""The pages and their files."""

import hmac
from importlib.util import find_spec
from pathlib import Path

from fastapi import APIRouter, Request, Response
from fastapi.responses import HTMLResponse

from wraparc.version import __version__
from wraparc.web.answers.shown import Answer
from wraparc.web.docs_page import docs_page
from wraparc.web.errors import refused
from wraparc.web.routes.parts import router, state_of
from wraparc.web.static_files import Static

#: What `make kernel` builds of the modules beside it.
FOLDER = Path(__file__).parents[1] / "static" / "built"
#: Addresses that all show the one page; the page itself tells them apart.
PAGES = ("/", "/compare", "/tests", "/train", "/study", "/designs", "/about")
pages = APIRouter(include_in_schema=False)
api = router("", "server")
_static = Static(FOLDER)
_LONGEST = 100  # of what a page thinks of for a proof
_EXTRAS = {"fit": "scipy", "report": "typst", "study": "scipy"}


def send_file(request: Request, name: str) -> Response:
    """Return a file of the package, packed where the browser can unpack it."""
    found = _static.get(name)
    if found is None:
        raise refused(404, "there is no such page", "Start at the first page.")
    headers = {"etag": found.tag, "cache-control": "no-cache", "vary": "accept-encoding"}
    if found.tag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=headers)
    body = found.plain
    if "gzip" in request.headers.get("accept-encoding", ""):
        body, headers["content-encoding"] = found.packed, "gzip"
    headers["content-type"] = found.kind
    return Response(body, headers=headers)


async def _index(request: Request) -> Response:
    return send_file(request, "index.html")


for _page in PAGES:
    pages.add_api_route(_page, _index, methods=["GET"])


@pages.get("/static/{name:path}")
async def static_file(request: Request, name: str) -> Response:
    """Return a file of the pages."""
    return send_file(request, name)


@pages.get("/favicon.ico")
async def favicon(request: Request) -> Response:
    """Return the icon."""
    return send_file(request, "icon.svg")


@pages.get("/api/v1/same/{nonce}")
async def same(request: Request, nonce: str) -> Response:
    """Prove to a page that this is the server which it was opened from, before it sends anything.

    HMAC-SHA256 of what the page has thought of, by the token of this start.
    """
    token = state_of(request).settings.start_token
    proof = hmac.digest(token.encode(), nonce[:_LONGEST].encode(), "sha256")
    headers = {"wraparc-version": __version__}
    return Response(proof, headers=headers, media_type="application/octet-stream")


@pages.get("/api/v1/once/{link}")
async def once(request: Request, link: str) -> Response:
    """Return what a link of one use leads to."""
    return state_of(request).links.use(link)


@pages.get("/docs")
async def docs(request: Request) -> Response:
    """Return the page about the API."""
    return HTMLResponse(docs_page(request.app.openapi()))


class About(Answer):
    """What the server is and can do."""

    name: str
    version: str
    database: str
    extras: dict[str, bool]
    token: bool


@api.get("/about")
async def about(request: Request) -> About:
    """Version and abilities of the server."""
    settings = state_of(request).settings
    return About(
        name="wraparc",
        version=__version__,
        database=settings.database.partition(":")[0].partition("+")[0],
        extras={name: find_spec(library) is not None for name, library in _EXTRAS.items()},
        token=bool(settings.token),
    )
