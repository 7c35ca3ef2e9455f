"""What `print` shows of a result: the short answer that the command line gives, nothing else."""

import pytest

from cli.running import wraparc
from wraparc import load_drive, load_train, solve, solve_train

pytestmark = pytest.mark.usefixtures("solved_once")


def test_a_printed_result_is_the_short_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only how the rest is asked for differs between the doors."""
    monkeypatch.setenv("COLUMNS", "80")
    for name in ("head-drive-fabric", "tandem-fabric"):
        file = f"examples/{name}.toml"
        result = solve_train(load_train(file)) if "tandem" in name else solve(load_drive(file))
        told = wraparc("solve", file).out.replace(" (--table constant)", "").splitlines()
        assert told[-1].split() == ["More", "--full,", "--table", "NAME"]
        assert str(result).splitlines() == [*told[:-1], "More  .full()"]
        assert result.full() == wraparc("solve", file, "--full").out.rstrip("\n")


def test_what_is_printed_is_no_repr() -> None:
    result = solve(load_drive("examples/head-drive-fabric.toml"))
    train = solve_train(load_train("examples/tandem-fabric.toml"))
    for of in (result, train, result.arcs[0], result.drive, result.arcs[0].profile):
        text = str(of)
        assert len(text.splitlines()) <= 40
        assert max(map(len, text.splitlines())) <= 80
        assert "Provenance(" not in text
        assert "Provenance(" in repr(of) or "array(" in repr(of)
