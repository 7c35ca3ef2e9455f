"""What a rule says of tensions is what its words advise, and what the least tension asks for.

Expected values are the words of the checks, and the same drives at another tension.
"""

import pytest

from checks.test_least_tension import with_slack
from checks.test_of_rows import CASES, QUICK, random_pairs
from judgement.test_advised import LESS, MORE, unevened
from wraparc import Drive, solve
from wraparc.checks import Check, judge, least_tension
from wraparc.checks.judge import EVEN, LOWERING, RAISING
from wraparc.checks.of_arc import EXIT_CREEP
from wraparc.checks.rules import ACROSS_RULES, OF_PULLEY, RULES

DRIVES = [of for _, of in CASES]
ALONE = [of for of in random_pairs(30) if len(of.pulleys) == 1]


def every_check() -> list[Check]:
    uneven = [unevened(of, number) for number, of in enumerate(ALONE[:3])]
    solved = (solve(of, method=QUICK, raise_on_failure=False) for of in (*DRIVES, *ALONE, *uneven))
    return [check for result in solved for check in judge(result).checks]


def test_a_check_that_advises_a_tension_says_so_in_its_rule() -> None:
    """Else more and less tension could be advised in one answer: no check knows of another."""
    seen = set()
    for check in every_check():
        if check.miss is None:
            continue
        asks = {way for way, asked in (("raise", MORE), ("lower", LESS))
                if asked.search(check.miss.remedy)}  # fmt: skip
        rule = RULES.get(check.name) or ACROSS_RULES[check.name]
        assert asks <= {rule.tension}, check.name
        assert not MORE.search(check.miss.otherwise)
        assert not LESS.search(check.miss.otherwise)
        seen |= {check.name} if asks else set()
    # the others are missed by none of these drives, or advise something else first
    unseen = {"creep_interval", "cover_creep", "edge_tension", "wet_creep"}
    assert (RAISING | LOWERING) - seen <= unseen


@pytest.mark.parametrize("number", range(len(ALONE)))
def test_another_tension_does_what_the_rule_says(number: int) -> None:
    of = ALONE[number]
    tensions = of.load_cases[0].tensions["head"]
    slack = min(tensions.entry, tensions.exit)
    before, after = (
        {c.name: c for c in judge(solve(one, method=QUICK, raise_on_failure=False)).checks}
        for one in (of, with_slack(of, 1.2 * slack))
    )
    for name, check in before.items():
        if check.miss is None or name == "belt_mass":  # a line of the size of m v2 over T2
            continue
        there = after[name]
        if name in RAISING and check.missed:
            assert not there.missed or there.margin > check.margin, name
        if name in LOWERING:
            assert not check.missed or there.margin < check.margin, name


@pytest.mark.parametrize("of", ALONE[:6])
def test_the_least_tension_asks_each_check_that_a_tension_decides(of: Drive) -> None:
    """At what a check asks for it is just kept: its value is its limit."""
    found = least_tension(solve(of))
    assert found is not None
    asked = {figure.name: figure for figure in found.figures}
    for check in judge(solve(of, method=QUICK)).checks:
        rule = RULES.get(check.name, EXIT_CREEP)
        compares = rule.tension and (rule.result or rule.value) and rule in OF_PULLEY
        if not (compares and rule.binding and rule.firm is None) or check.limit != check.limit:
            continue
        if check.name == "tested_slip" and check.limit >= of.creep_limit:
            continue  # a slip is never more than the creep
        tension = asked.pop(check.name).tension
        if check.name in ("creep", "tested_slip"):
            continue  # solved for: `test_least_tension`
        at = judge(solve(with_slack(of, max(tension, 1.0)), method=QUICK, raise_on_failure=False))
        (there,) = (c for c in at.checks if c.name == check.name)
        assert tension < 1.0 or there.value == pytest.approx(there.limit, rel=1e-9)
    assert asked.keys() <= {"gross_slip", "design_standard", "wet_creep"}


def test_what_a_strip_may_miss_is_checked_across_the_width() -> None:
    """The even belt keeps a limit that the worst strip of an uneven one may miss."""
    found = {rule.name for rule in OF_PULLEY if rule.result}
    # of tests only their pressure is: a slip is never more than the creep of its strip
    assert found - set(EVEN.values()) == {"tested_slip", "tested_slip_speed"}
    assert set(EVEN) <= set(ACROSS_RULES)
