"""What a press on a slider costs the browser, by kind of work, from a trace of its threads."""

from __future__ import annotations

from collections import Counter, defaultdict
from typing import Any

#: What the browser's trace must hold for it.
CATEGORIES = ["devtools.timeline", "disabled-by-default-devtools.timeline", "v8", "toplevel"]
_KINDS = {
    "FunctionCall": "script", "v8.callFunction": "script", "EventDispatch": "script",
    "FireAnimationFrame": "script", "TimerFire": "script", "RunMicrotasks": "script",
    "MinorGC": "garbage", "MajorGC": "garbage", "UpdateLayoutTree": "style",
    "Layout": "layout", "PrePaint": "pre-paint", "Paint": "paint", "Layerize": "layers",
    "Commit": "layers", "RasterTask": "raster",
}  # fmt: skip
_PAGE, _WORKER = "CrRendererMain", "DedicatedWorker thread"


def _kind(name: str) -> str | None:
    return _KINDS.get(name) or ("garbage" if name.startswith("V8.GC") else None)


def by_kind(events: list[dict[str, Any]], presses: int) -> dict[str, float]:
    """Return thread time by kind of work [ms a press].

    The page's own thread, `raster` on those beside it and `worker`, what the page has computed
    beside itself. Work inside other work counts once, as what it is: collecting garbage in a
    script is no script.
    """
    names = {
        (e["pid"], e["tid"]): e["args"]["name"]
        for e in events
        if e["ph"] == "M" and e["name"] == "thread_name"
    }
    threads = defaultdict(list)
    for e in events:
        if e["ph"] == "X":
            threads[e["pid"], e["tid"]].append(e)
    total: Counter[str] = Counter()
    for thread, found in threads.items():
        found.sort(key=lambda e: (e["ts"], -e.get("dur", 0)))
        inside: list[tuple[float, str | None]] = []  # ends and kinds of what is going on
        for e in found:
            while inside and inside[-1][0] <= e["ts"]:
                inside.pop()
            above = inside[-1][1] if inside else None
            kind = _kind(e["name"]) or above
            if names.get(thread) == _WORKER and kind:
                kind = "worker"
            elif names.get(thread) != _PAGE and kind != "raster":
                kind = None
            if kind and kind != above:
                total[kind] += e.get("tdur", 0)
                if above:
                    total[above] -= e.get("tdur", 0)
            inside.append((e["ts"] + e.get("dur", 0), kind))
    order = [*dict.fromkeys(_KINDS.values()), "worker"]
    return {kind: total[kind] / 1e3 / presses for kind in order}
