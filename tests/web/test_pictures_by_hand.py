"""Where the page's pictures put things: places by hand, from the scales that a reader takes off."""

import json
import math
import re
import subprocess
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).parent
#: Margins of a chart of the page [px]: those of plots that stand under each other, and the top.
LEFT, RIGHT, TOP = 62.0, 50.0, 8.0


def drawn(*cases: dict[str, Any]) -> list[Any]:
    done = subprocess.run(
        ["node", str(HERE / "picture_cases.mjs")],
        input=json.dumps(cases), capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found: list[Any] = json.loads(done.stdout)
    return found


def numbers(text: str) -> list[float]:
    return [float(n) for n in re.findall(r"-?[\d.]+(?:e-?\d+)?", text)]


def points(course: str) -> list[tuple[float, float]]:
    n = numbers(course)
    return list(zip(n[::2], n[1::2], strict=False))  # a height or width may end it


LOOK = {"title": "T", "height": 190, "stacked": True, "numbered": True, "xlabel": "x"}
#: Foot of a plot of this height that has numbers and a name on its axis.
FLOOR = 190.0 - 36.0


def chart(**data: Any) -> dict[str, Any]:
    more = {k: data.pop(k) for k in ("picks", "cursor", "names", "look", "width") if k in data}
    base = {"x": [0.0, 90.0, 180.0], "lines": [], "ylabel": "y"}
    return {"kind": "chart", "width": 480, "look": LOOK, "data": base | data} | more


def x_of(part: float, width: float = 480.0) -> float:
    return LEFT + part * (width - LEFT - RIGHT)


def y_of(value: float, lo: float, hi: float) -> float:
    return TOP + (hi - value) / (hi - lo) * (FLOOR - TOP)


def test_a_line_runs_where_its_numbers_are() -> None:
    # by hand: 0 to 10 in steps of 2 from the foot to the top, 0 to 180 from margin to margin; a
    # number that is not there parts the line
    line = {"cls": "blue", "y": [0.0, 5.0, 10.0]}
    gap = {"cls": "red", "y": [1.0, None, 3.0]}
    own = {"cls": "green", "x": [45.0, 135.0], "y": [2.5, 7.5]}
    (found,) = drawn(chart(lines=[line, gap, own], zero=True, picks=[0, x_of(0.25), 479]))
    whole, parted, apart = (points(course) for course in found["lines"])
    for got, part, value in zip(whole, (0.0, 0.5, 1.0), (0.0, 5.0, 10.0), strict=True):
        assert got == pytest.approx((x_of(part), y_of(value, 0, 10)), abs=0.051)
    assert found["lines"][0].count("M") == 1
    assert found["lines"][1].count("M") == 2
    assert parted[1] == pytest.approx((x_of(1.0), y_of(3.0, 0, 10)), abs=0.051)
    assert apart[0] == pytest.approx((x_of(0.25), y_of(2.5, 0, 10)), abs=0.051)
    # the pointer is read on the same scale, and held at its ends
    assert found["picked"] == pytest.approx([0.0, 0.25, 1.0])
    assert points(found["cursor"])[0] == pytest.approx((x_of(0.5), TOP), abs=0.051)
    # of an axis that begins elsewhere too
    (part,) = drawn(chart(x=[90.0, 180.0], lines=[{"cls": "c", "y": [1.0, 2.0]}], cursor=0.25))
    assert points(part["cursor"])[0] == pytest.approx((x_of(0.25), TOP), abs=0.051)


def test_zones_points_and_a_limit_stand_at_their_values() -> None:
    line = {"cls": "blue", "y": [0.0, 5.0, 10.0]}
    more = {"zones": [[45.0, 90.0, "out"]], "points": [[135.0, 4.0]], "zero": True}
    near, far, under = drawn(
        chart(lines=[line], limit={"y": 12.0, "label": "limit"}, **more),
        chart(lines=[line], limit={"y": 30.0, "label": "limit"}, **more),
        chart(lines=[{"cls": "blue", "y": [-1.0, -5.0, -10.0]}], limit={"y": -12.0, "label": "l"}),
    )
    # 12 is within 2.2 times the largest value: the axis reaches to 12.5 for it
    assert points(near["limit"].replace("H", " "))[0] == pytest.approx(
        (x_of(0.0), y_of(12.0, 0, 12.5)), abs=0.051
    )
    assert numbers(near["limit"])[2] == x_of(1.0)
    assert far["limit"] == ""
    assert under["limit"] != ""
    (zone,) = near["zones"]
    assert float(zone["x"]) == pytest.approx(x_of(0.25))
    assert float(zone["width"]) == pytest.approx(x_of(0.5) - x_of(0.25))
    assert (float(zone["y"]), float(zone["height"])) == (TOP, FLOOR - TOP)
    (mark,) = near["marks"]
    place = float(mark["cx"]), float(mark["cy"])
    assert place == pytest.approx((x_of(0.75), y_of(4.0, 0, 12.5)), abs=0.051)


def test_numbers_of_the_axes_are_round_and_at_their_places() -> None:
    (found,) = drawn(chart(lines=[{"cls": "blue", "y": [0.0, 5.0, 10.0]}], zero=True, angles=True))
    across = [(float(e["x"]), e["text"]) for e in found["axis"] if e.get("class") == "tx"]
    assert [x for x, _ in across] == pytest.approx([x_of(float(t) / 180) for _, t in across])
    assert [t for _, t in across] == ["0", "30", "60", "90", "120", "150", "180"]
    up = [(float(e["y"]), e["text"]) for e in found["axis"] if e.get("class") == "ty"]
    assert [y for y, _ in up] == pytest.approx([y_of(float(t), 0, 10) + 3.5 for _, t in up])
    assert [t for _, t in up] == ["0", "2", "4", "6", "8", "10"]


def test_names_are_put_where_nothing_is() -> None:
    # expected: its first place, 72 % along the line and 5 px above it, if that is free; else
    # somewhere that covers neither line nor name, within the axes
    flat = {"cls": "blue", "label": "low", "y": [2.0] * 121}
    high = {"cls": "red", "label": "high", "y": [2.15] * 121}
    x = [1.5 * i for i in range(121)]
    alone, both = drawn(
        chart(x=x, lines=[flat, {"cls": "grey", "y": [10.0] * 121}], zero=True, names=True),
        chart(x=x, lines=[flat, high], limit={"y": 2.6, "label": "limit"}, zero=True, names=True),
    )
    (name,) = [e for e in alone["names"] if e["text"]]
    assert float(name["x"]) + 3 * 6 / 2 == pytest.approx(x_of(86 / 120), abs=0.1)
    assert float(name["y"]) == pytest.approx(points(alone["lines"][0])[0][1] - 5, abs=0.1)
    boxes = []
    for one in both["names"]:
        left, foot = float(one["x"]), float(one["y"])
        boxes.append((left, foot - 9, left + 6 * len(one["text"]), foot))
        assert LEFT < left < x_of(1.0) - 6 * len(one["text"])
    assert [one["text"] for one in both["names"]] == ["low", "high", "limit"]
    levels = [points(course)[0][1] for course in both["lines"]] + [numbers(both["limit"])[1]]
    for i, (left, top, right, foot) in enumerate(boxes):
        assert not any(top < level < foot for level in levels)
        for a, b, c, d in boxes[:i]:
            assert right < a or c < left or foot < b or d < top


def test_names_keep_to_their_plot_and_off_the_limit_and_each_other() -> None:
    # by hand: at the top of the plot a name goes below its line, a long one ends within the axes,
    # one under a limit 7 px above it goes below, those of two lines at one place stand apart
    x = [1.5 * i for i in range(121)]

    def lines(*named: tuple[str, float]) -> list[dict[str, Any]]:
        return [{"cls": "c", "label": name, "y": [y] * 121} for name, y in named]

    top, long, under, same = drawn(
        chart(x=x, lines=lines(("top", 10.0)), zero=True, names=True),
        chart(x=x, lines=lines(("a" * 40, 5.0), ("", 10.0)), zero=True, names=True),
        chart(x=x, lines=lines(("a", 2.0)), limit={"y": 2.15, "label": ""}, zero=True, names=True),
        chart(x=x, lines=lines(("one", 5.0), ("two", 5.0), ("", 10.0)), zero=True, names=True),
    )
    assert float(top["names"][0]["y"]) == pytest.approx(TOP + 14, abs=0.1)
    assert float(long["names"][0]["x"]) + 40 * 6 <= x_of(1.0) - 3
    assert float(under["names"][0]["y"]) > points(under["lines"][0])[0][1]
    one, two = ((float(e["x"]), float(e["y"])) for e in same["names"][:2])
    assert abs(one[1] - two[1]) >= 12 or abs(one[0] - two[0]) >= 3 * 6 + 4


def test_names_that_find_no_room_cover_the_least() -> None:
    # five lines 9 px from each other: a name between two of them cannot be free of both, one above
    # all is
    lines = [
        {"cls": "c", "label": "a name" if i == 2 else "", "y": [3.0 + 0.6 * i] * 121}
        for i in range(5)
    ]
    x = [1.5 * i for i in range(121)]
    (found,) = drawn(chart(x=x, lines=lines, zero=True, names=True))
    name = next(e for e in found["names"] if e["text"])
    levels = sorted(points(course)[0][1] for course in found["lines"])
    foot = float(name["y"])
    crossed = sum(foot - 9 - 2 < level < foot + 3 for level in levels)
    around = [
        sum(levels[2] + dy - 11 < level < levels[2] + dy + 3 for level in levels)
        for dy in (-5, 14, -16, 25)
    ]
    assert crossed == min(around)


def test_a_belt_in_time_runs_with_its_drum() -> None:
    """Travels of 0.3 and 0.6 m on a drum of 0.5 m of radius drawn with 164, marks every 150."""
    some = [{"kind": "stage", "radius": 0.5, "turn": [s, math.pi / 2]} for s in (0.3, 0.6)]
    for found, offset in zip(drawn(*some), (-98.4, -(2 * 98.4 - 150.0)), strict=True):
        assert float(found["marks"]["stroke-dashoffset"]) == pytest.approx(offset, abs=0.06)
        assert found["spoke"]["transform"] == "rotate(90 490 250)"


def test_parts_of_the_creep_are_laid_end_to_end_and_against_each_other() -> None:
    # by hand: 3 and 1 to the right of zero one after the other, -2 to its left; limit 6 within 2.5
    # times the largest sum: the axis runs from -2 to 6
    near, far = drawn(
        {"kind": "budget", "width": 500, "bars": [{"label": "", "parts": [3, -2, 1]}], "limit": 6},
        {"kind": "budget", "width": 500, "bars": [{"label": "", "parts": [3, -2, 1]}], "limit": 60},
    )
    a, b, c = [(float(p["x"]), float(p["x"]) + float(p["width"])) for p in near["parts"]]
    scale = (c[1] - a[0]) / 4
    assert a[1] - a[0] == pytest.approx(3 * scale, abs=0.2)
    assert c == pytest.approx((a[1], a[1] + scale), abs=0.2)
    assert b == pytest.approx((a[0] - 2 * scale, a[0]), abs=0.2)
    assert numbers(near["limit"]["d"])[0] == pytest.approx(a[0] + 6 * scale, abs=0.3)
    assert far["limit"]["d"] == ""
    (row,) = drawn(
        {"kind": "budget", "width": 500, "bars": [{"label": "", "parts": [3, 1, 2]}], "limit": 60}
    )
    starts = [float(p["x"]) for p in row["parts"]]
    assert (starts[2] - starts[0]) / (starts[1] - starts[0]) == pytest.approx(4 / 3, abs=0.01)


def spread(**more: Any) -> dict[str, Any]:
    told = {
        "result": "exit_creep", "where": "", "edges": [1e-3 * i for i in range(9)],
        "counts": [1, 2, 4, 8, 8, 4, 2, 1], "limit": 5.5e-3, "at_most": True, "beyond": 0.1,
        "limit_told": "creep limit 5.5 mm", "without": 0, "told": "told",
    }  # fmt: skip
    return {"kind": "spread", "width": 600, "spread": told | more}


def bars(found: list[Any]) -> list[tuple[float, float, float, bool]]:
    """Left end, width and height of every bar, and whether it is drawn as beyond the limit."""
    return [
        (float(e["x"]), float(e["width"]), float(e["height"]), "red" in e["stroke"])
        for e in found
        if e["tag"] == "rect" and "stroke" in e
    ]


def test_a_histogram_has_its_bars_at_their_values_and_marks_those_beyond() -> None:
    # by hand: heights as the counts, side by side, hatched where the middle lies beyond the limit
    upper, least, braking, far, without = drawn(
        spread(),
        spread(result="creep_limit_margin", at_most=False, limit=2.5e-3),
        spread(edges=[-8e-3 + 2e-3 * i for i in range(9)], limit=5.5e-3),
        spread(limit=0.1),
        spread(without=16),
    )
    seen = bars(upper)
    assert [b[2] / seen[3][2] for b in seen] == pytest.approx(
        [n / 8 for n in (1, 2, 4, 8, 8, 4, 2, 1)]
    )
    assert seen[3][2] == bars(without)[-1][2] == 200 - 26  # the largest fills the plot
    for a, b in pairwise(seen):
        assert a[0] + a[1] == pytest.approx(b[0])
    assert [b[3] for b in seen] == [False] * 5 + [False, True, True]
    (line,) = [e for e in upper if e.get("class") == "limit"]
    assert numbers(line["d"])[0] == pytest.approx(seen[0][0] + 5.5 * seen[0][1])
    said = next(e for e in upper if e["text"] == "creep limit 5.5 mm" and e["tag"] == "text")
    assert said["class"] == "ty"  # right of the middle: its words end at the line
    assert [b[3] for b in bars(least)] == [True, True, False] + [False] * 5
    # of a braking drive a limit is one for both senses
    assert [b[3] for b in bars(braking)] == [True] + [False] * 6 + [True]
    assert sum(e.get("class") == "limit" for e in braking) == 2
    # one that is far off is not drawn, what has no number is a bar of its own beyond all
    assert sum(e.get("class") == "limit" for e in far) == 0
    one = bars(without)[-1]
    assert one[3]
    assert one[0] > bars(without)[-2][0] + bars(without)[-2][1]
    assert bars(without)[3][2] == pytest.approx(one[2] / 2)


def drive(name: str, t1: float, t2: float, **more: Any) -> dict[str, Any]:
    return {
        "pulley": name, "entry_tension": t1, "exit_tension": t2, "share": 0.5,
        "wrap_angle": math.pi, "exit_creep": 1e-3, "status": "solved",
    } | more  # fmt: skip


def chain(*drives: dict[str, Any]) -> dict[str, Any]:
    return {"kind": "train", "load_case": {"load_case": "design", "drives": list(drives)}}


def circles(found: list[Any]) -> list[tuple[float, float]]:
    return [(e["cx"], e["cy"]) for e in found if e.get("class") == "steel shell-ring"]


def test_drums_say_which_side_of_the_belt_lies_on_them_where_they_differ() -> None:
    one, both = drawn(
        chain(*(drive(name, 120e3, 80e3, side="pulley") for name in "ab")),
        chain(drive("a", 120e3, 80e3, side="pulley"), drive("b", 80e3, 40e3, side="carry")),
    )
    sides = [
        [e["text"] for e in f if e["tag"] == "text" and "side" in e["text"]] for f in (one, both)
    ]
    assert sides == [[], ["pulley side", "carry side"]]
    titles = [e["text"] for e in both if e["tag"] == "title"]
    assert [t.rpartition(", ")[2] for t in titles] == [
        "pulley side of the belt", "carry side of the belt",
    ]  # fmt: skip


def test_a_belt_runs_over_its_drums_in_alternate_senses() -> None:
    # by hand: it comes at height 0, turns half about a drum of radius 100 below it, comes out 200
    # lower and back, and passes over the next drum in the other sense
    found, slip = drawn(
        chain(drive("a", 120e3, 80e3), drive("b", 80e3, 40e3)),
        chain(drive("a", 120e3, 80e3), drive("b", 60e3, 40e3, share=-0.25)),
    )
    (x1, y1), (x2, y2) = circles(found)
    assert (x1, y1) == pytest.approx((0.0, 100.0))
    assert x2 < x1 - 200  # back, beyond the first drum
    assert y2 == pytest.approx(300.0)
    widths = [float(e["stroke-width"]) for e in found if e.get("stroke") == "var(--belt)"]
    assert max(widths) == pytest.approx(12.0)
    assert min(widths) == pytest.approx(3 + 9 / 3, abs=0.1)
    wraps = [e for e in found if e["tag"] == "path" and "A100 100" in str(e.get("d"))]
    assert len(wraps) == 2 * 24
    assert all(" 0 0 1 " in e["d"] for e in wraps[:24])  # clockwise, then the other way
    assert all(" 0 0 0 " in e["d"] for e in wraps[24:])
    ends = [numbers(e["d"])[-2:] for e in wraps]
    assert max(x for x, _ in ends[:24]) == pytest.approx(x1 + 100, abs=0.3)  # about its right side
    assert min(x for x, _ in ends[24:]) == pytest.approx(x2 - 100, abs=0.3)
    first = [float(e["stroke-width"]) for e in wraps[:24]]
    assert all(a >= b for a, b in pairwise(first))
    told = [e["text"] for e in found if e["tag"] == "text"]
    assert {"carrying strand 120 kN", "80 kN", "return strand", "40 kN", "50.0 %"} <= set(told) | {
        t.replace("50 %", "50.0 %") for t in told
    }
    # a run of the conveyor between them is told by both tensions, what brakes is marked
    told = [e["text"] for e in slip if e["tag"] == "text"]
    assert "80 kN → 60 kN" in told
    assert "120 kN" in told
    assert [t for t in told if "°" in t] == ["180° wrap", "180° brakes"]
    marks = [str(e.get("class", "")).split() for e in slip]
    assert [m for m in marks if m[:1] == ["wrapped"]] == [["wrapped"]] * 24 + [
        ["wrapped", "brakes"]
    ] * 24


def test_belts_that_wrap_far_do_not_cross() -> None:
    # by hand: of 240 degrees each, the span between them is 55 / tan(30 deg) long
    far = {"wrap_angle": math.radians(240)}
    (found,) = drawn(chain(drive("a", 120e3, 80e3, **far), drive("b", 80e3, 40e3, **far)))
    spans = [points(e["d"].replace("L", " ")) for e in found if "L" in str(e.get("d"))]
    lengths = [math.dist(*span) for span in spans if len(span) == 2]
    assert lengths[1] == pytest.approx(55 / math.tan(math.radians(30)), abs=0.2)


def test_the_lagging_under_the_belt_is_drawn_from_entry_to_exit() -> None:
    # by hand: half circles of radius 93 from the top of each drum, clockwise and the other way
    (found,) = drawn(chain(drive("a", 120e3, 80e3), drive("b", 80e3, 40e3)))
    rings = [e for e in found if str(e.get("class", "")).startswith("wrapped")]
    halves = rings[:24], rings[24:]  # pieces, each coloured by the shear in its middle
    for pieces, (x, y), turn in zip(halves, circles(found), ("1", "0"), strict=True):
        assert numbers(pieces[0]["d"])[:2] == pytest.approx([x, y - 93], abs=0.05)
        assert numbers(pieces[-1]["d"])[-2:] == pytest.approx([x, y + 93], abs=0.05)
        assert all(f"A93 93 0 0 {turn} " in e["d"] for e in pieces)


def test_a_drum_that_slips_is_hatched_and_has_no_share() -> None:
    (found,) = drawn(chain(drive("a", 120e3, 80e3), drive("b", 80e3, 40e3, status="breakaway")))
    assert sum("url(" in str(e.get("fill")) for e in found if e["tag"] == "circle") == 1
    assert sum(str(e.get("class", "")).startswith("wrapped") for e in found) == 24
    told = [e["text"] for e in found if e["tag"] == "text"]
    assert "slips" in told
    assert sum("%" in text for text in told) == 1


def test_steps_and_ticks_are_round() -> None:
    # by hand: the smallest of 1, 2, 2.5 and 5 times a power of ten for at most so many parts
    steps, marks, colours = drawn(
        {"kind": "steps", "spans": [[10, 5], [10, 4], [7, 5], [0.03, 5], [1e4, 3], [26, 5]]},
        {"kind": "ticks", "of": [[0, 1, 0.25], [-0.3, 0.7, 0.5], [0.1, 0.7, 0.2]]},
        {"kind": "ramp", "of": [0, 1, -1, 2, 0.5]},
    )
    assert steps == pytest.approx([2, 2.5, 2, 0.01, 5e3, 10])
    assert marks == [[0, 0.25, 0.5, 0.75, 1], [0, 0.5], [0.2, 0.4, 0.6]]
    # the ramp has four colours, the last for all that is more
    assert colours[0] == colours[2] == "color-mix(in srgb, var(--q1) 0%, var(--q0))"
    assert colours[1] == colours[3] == "color-mix(in srgb, var(--q3) 100%, var(--q2))"
    assert colours[4] == "color-mix(in srgb, var(--q2) 50%, var(--q1))"
