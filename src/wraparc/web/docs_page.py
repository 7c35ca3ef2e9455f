"""A page about the API, made from its OpenAPI document: plain HTML that loads nothing."""

from html import escape
from typing import Any

_METHODS = ("get", "post", "put", "patch", "delete")


def docs_page(document: dict[str, Any]) -> str:
    """Return the page."""
    info = document["info"]
    rows = []
    for path, item in document["paths"].items():
        for method in (m for m in _METHODS if m in item):
            operation = item[method]
            rows.append(
                f"<tr><td><code>{method.upper()}</code></td><td><code>{escape(path)}</code></td>"
                f"<td>{escape(operation.get('summary', ''))}</td></tr>"
            )
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(info['title'])} API</title></head><body><main>"
        f"<h1>{escape(info['title'])} {escape(info['version'])}: API</h1>"
        f"<p>{escape(info['description'])}</p>"
        '<p>Every request and its form: <a href="/api/v1/openapi.json">OpenAPI document</a>. '
        '<a href="/">The calculator</a>.</p>'
        f"<table><thead><tr><th>Method</th><th>Path</th><th>What it does</th></tr></thead>"
        f"<tbody>{''.join(rows)}</tbody></table></main></body></html>"
    )
