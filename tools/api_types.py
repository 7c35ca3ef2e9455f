"""The types of what the page asks and is answered: those of the API's own document."""

import json
from typing import Any

from pydantic import TypeAdapter

from wraparc.units import Dimension, cell
from wraparc.web.answers.shown import Text
from wraparc.web.app import create_app
from wraparc.web.settings import Settings

_ALIASES: dict[str, Any] = {"Text": Text, "Dimension": Dimension, "CellForm": cell.Form}
_PLAIN = {"integer": "number", "number": "number", "string": "string", "boolean": "boolean"}


def _type(schema: dict[str, Any]) -> str:
    """Return a schema as a type of TypeScript."""
    if "$ref" in schema:
        return str(schema["$ref"]).rpartition("/")[2]
    if "anyOf" in schema:
        return " | ".join(dict.fromkeys(_type(one) for one in schema["anyOf"]))
    if "const" in schema or "enum" in schema:
        return " | ".join(json.dumps(v) for v in schema.get("enum") or [schema["const"]])
    kind = schema.get("type")
    if kind == "array" and "prefixItems" in schema:
        return f"[{', '.join(_type(one) for one in schema['prefixItems'])}]"
    if kind == "array":
        return f"({_type(schema.get('items', {}))})[]"
    if kind == "object":
        values = schema.get("additionalProperties")
        return f"Record<string, {_type(values) if isinstance(values, dict) else 'any'}>"
    return "null" if kind == "null" else _PLAIN.get(str(kind), "any")


def _interface(name: str, schema: dict[str, Any]) -> str:
    if "properties" not in schema:
        return f"export type {name} = {_type(schema)};\n"
    needed, lines = schema.get("required", ()), list[str]()
    for key, value in schema["properties"].items():
        if told := value.get("description"):
            lines.append(f"/** {told} */")
        lines.append(f"{json.dumps(key)}{'' if key in needed else '?'}: {_type(value)};")
    return "export interface {} {{\n{}\n}}\n".format(name, "\n".join(lines))


def types_of_api() -> str:
    """Return the module of all types."""
    schemas = create_app(Settings()).openapi()["components"]["schemas"]
    text = "".join(_interface(name, schemas[name]) for name in sorted(schemas))
    for name, of in _ALIASES.items():  # what the document writes out wherever it stands
        whole = _type(TypeAdapter(of).json_schema(ref_template="#/components/schemas/{model}"))
        text = text.replace(whole, name) + f"export type {name} = {whole};\n"
    return "// Made by `make kernel` from the document of the API. No code.\n" + text
