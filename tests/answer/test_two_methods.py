"""Two methods on different sides of a limit are told, both and why."""

from dataclasses import replace

from wraparc import PaperMarch, load_drive, solve
from wraparc.answer.arc_tables import answer_table
from wraparc.answer.drive_sheet import drive_sheet
from wraparc.answer.sheet import shown
from wraparc.checks import Level
from wraparc.render.note import NoteHead, make_note


def test_methods_on_different_sides_of_the_creep_limit_are_told() -> None:
    drive = load_drive("examples/head-drive-fabric.toml")
    drive = replace(drive, load_cases=(drive.load_case("design"),))
    mine, paper = (solve(drive), solve(drive, method=PaperMarch()))
    creeps = [mine.arcs[0].exit_creep, paper.arcs[0].exit_creep]
    assert abs(creeps[0] - creeps[1]) > 1e-4  # they differ by how the contraction is taken
    between = replace(drive, creep_limit=sum(creeps) / 2.0)
    results = [solve(between), solve(between, method=PaperMarch())]
    said = shown(drive_sheet(results), "si").verdict
    assert said is not None
    assert said.sentences[0].startswith("The methods differ in whether creep passes the limit")
    assert "(distributed) and " in said.sentences[0]
    assert "(paper's integration)" in said.sentences[0]
    assert make_note(results, NoteHead()).told.sentences[0] == said.sentences[0]
    (creep, *_) = answer_table(tuple(result.arcs[0] for result in results)).rows
    assert creep.level is Level.ATTENTION  # the colour of both numbers
    agreed = shown(drive_sheet([mine, paper]), "si").verdict
    assert agreed is not None
    assert "different sides" not in " ".join(agreed.sentences)
