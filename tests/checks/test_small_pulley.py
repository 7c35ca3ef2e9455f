"""A fabric belt on a pulley of 800 mm whose least is 1000 mm fails, the same in every door."""

from pathlib import Path

from cli.running import wraparc
from worded import worded
from wraparc.arc import solve
from wraparc.checks import Level, judge
from wraparc.files.drive_file import load_drive
from wraparc.render import markdown
from wraparc.schema.source import parse
from wraparc.web.answers.drives import solve_all, solve_fast
from wraparc.web.asked import FastRequest, SolveRequest

FILE = """
format = 1
[belt]
preset = "Plylon Plus 1000/4"
width = "1200 mm"
speed = "3 m/s"
least_pulley_diameter = "1000 mm"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "180 deg"
lagging = "full-ceramic"
entry_tension = "110 kN"
exit_tension = "60 kN"
"""
SAID = "Pulley diameter 800 mm is below the belt minimum 1000 mm (head)."


def test_it_fails_in_every_door(tmp_path: Path) -> None:
    path = tmp_path / "drive.toml"
    path.write_text(FILE, "utf-8")
    result = solve(load_drive(path))
    assert judge(result).level is Level.FAILS
    document = parse(FILE)
    whole = solve_all(SolveRequest(document=document))
    fast = solve_fast(FastRequest(document=document))
    for told in (whole.verdict, fast.verdict):
        assert told.level is Level.FAILS
        assert SAID in worded(told.text)
    assert [a.level for a in whole.arcs] == [Level.FAILS]
    assert f"**FAILS** {SAID}" in markdown([result]).replace("\\", "")
    ran = wraparc("solve", path)
    assert ran.code == 1
    assert f"FAILS {SAID}" in ran.words
    assert SAID in wraparc("check", path).words
