"""A study as JSON-like data: what is written with --json and what the server answers."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from wraparc.glossary import GLOSSARY
from wraparc.study.monte_carlo import PERCENTS, Group, Judged, Summary
from wraparc.study.sensitivity import Global, Local
from wraparc.study.share import CONFIDENCE, Share
from wraparc.units import DIMENSION_TEXT


def study_document(
    summary: Summary, *, local: Local | None = None, indices: Global | None = None
) -> dict[str, Any]:
    """Return what a study says as plain data [SI] for JSON."""
    document: dict[str, Any] = {
        "format": 1,
        "study": {key: value for key, value in summary.data.items() if key != "input"},
        "input": summary.data["input"],
        "counts": dict(summary.counts),
        "judged": _judged_data(summary.judged),
        "over_limit": _share_data(summary.over_limit),
        "confidence": CONFIDENCE,
        "percents": list(PERCENTS),
        "groups": [_group_data(group) for group in summary.groups],
        "units": {
            name: DIMENSION_TEXT[GLOSSARY[name].dimension].si_unit
            for name in summary.data["outputs"]
        },
    }
    if local is not None:
        document["local"] = [
            {"load_case": load, "condition": condition, "result": name, **asdict(swing)}
            for (load, condition), of_case in local.items()
            for name, swings in of_case.items()
            for swing in swings
        ]
    if indices is not None:
        document["global"] = [
            {"load_case": load, "condition": condition, "result": name, **asdict(found)}
            for (load, condition), of_case in indices.items()
            for name, found in of_case.items()
        ]
    return document


def _group_data(group: Group) -> dict[str, Any]:
    return {
        "levels": dict(group.levels),
        "load_case": group.load_case,
        "condition": group.condition,
        "share": group.share,
        "counts": dict(group.counts),
        "breakaway": _share_data(group.breakaway),
        "over_limit": _share_data(group.over_limit),
        "judged": _judged_data(group.judged),
        "percentiles": {name: list(values) for name, values in group.percentiles.items()},
        "known": dict(group.known),
        "convergence": [
            {
                "draws": step.draws,
                "breakaway": _share_data(step.breakaway),
                "over_limit": _share_data(step.over_limit),
            }
            for step in group.steps
        ],
    }


def _judged_data(judged: Judged) -> dict[str, Any]:
    return {"verdicts": judged.verdicts, "governing": judged.missed}


def _share_data(share: Share) -> dict[str, Any]:
    return {"value": share.value, "interval": list(share.interval), "count": share.count}
