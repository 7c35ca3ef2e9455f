"""What `print` shows of a result: its answer and one table, not all that it holds."""

from wraparc import load_drive, load_train, solve, solve_train
from wraparc.checks import judge


def test_a_printed_result_is_a_short_table_led_by_its_verdict() -> None:
    result = solve(load_drive("examples/head-drive-fabric.toml"))
    train = solve_train(load_train("examples/tandem-fabric.toml"))
    for of in (result, train, result.arcs[0], result.drive, result.arcs[0].profile):
        text = str(of)
        assert len(text) < 2000
        assert "Provenance(" not in text
        assert "Provenance(" in repr(of) or "array(" in repr(of)
    headline = judge(result).headline()
    assert str(result).splitlines()[1] == f"ATTENTION: {headline}"
    creep = next(line for line in str(result).splitlines() if line.startswith("Creep at exit"))
    assert creep.split("  ")[-1].strip() == "ATTENTION"
