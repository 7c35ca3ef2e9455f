"""A pulley that brakes is said to, in the first lines, and pulleys on one belt must meet."""

from dataclasses import replace

from checks.test_rows import quiet
from wraparc import Drive, Tensions, load_train, solve
from wraparc.checks import Level, judge
from wraparc.drive import LoadCase
from wraparc.train import Train, solve_train
from wraparc.units import in_units


def cases(*pairs: tuple[float, float]) -> Drive:
    of = quiet()
    made = tuple(
        LoadCase(name=f"case {i}", tensions={"head": Tensions(entry=a, exit=b)})
        for i, (a, b) in enumerate(pairs)
    )
    return replace(of, load_cases=made)


def test_t1_below_t2_brakes() -> None:
    said = judge(solve(cases((60e3, 100e3)))).full
    assert said[-1:] == ("head brakes in 1 of 1 load cases.",)
    some = judge(solve(cases((60e3, 100e3), (100e3, 60e3), (60e3, 60e3)))).full
    assert some[-2:] == (
        "head brakes in 1 of 3 load cases.",
        "head transmits no tension in 1 of 3 load cases.",
    )
    assert judge(solve(cases((100e3, 60e3)))).full == ()


def test_what_is_said_is_no_check_that_is_counted() -> None:
    told = judge(solve(cases((60e3, 100e3))))
    assert "sense" in {c.name for c in told.listed}
    kept = [c for c in told.listed if c.level is Level.OK and c.name not in ("data", "sense")]
    assert in_units(told.text).startswith(f"All {len(kept)} checks pass.")


def two(leaves: float, enters: float) -> Drive:
    of = quiet()
    second = replace(of.pulleys[0], name="second")
    tensions = {
        "head": Tensions(entry=leaves + 40e3, exit=leaves),
        "second": Tensions(entry=enters, exit=enters - 40e3),
    }
    case = LoadCase(name="design", tensions=tensions)
    return replace(of, pulleys=(of.pulleys[0], second), load_cases=(case,))


def test_neighbours_whose_tensions_do_not_meet_are_asked_about() -> None:
    # 100 kN leaves the first, 160 kN enters the second; 1 % apart is rounding
    found = judge(solve_train(Train.of(two(100e3, 160e3))))
    assert found.level is Level.ATTENTION
    assert in_units(found.text) == (
        "Belt leaves head at 100 kN but enters second at 160 kN (second, design)."
    )
    alike = judge(solve_train(Train.of(two(100e3, 101e3))))
    assert "meeting" not in {c.name for c in alike.checks}
    # what a [train] table says that a run adds is not asked about
    given = judge(solve_train(load_train("examples/triple-steel-cord.toml")))
    assert "meeting" not in {c.name for c in given.checks}
