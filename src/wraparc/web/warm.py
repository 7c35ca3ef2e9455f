"""What a worker does before its first answer: import and solve once, so that nobody waits."""


def warm() -> None:
    """Solve an example."""
    from wraparc.web.answers.drives import solve_all, solve_fast
    from wraparc.web.examples import examples

    for example in examples()[:1]:
        request = {
            "document": example.document,
            "pulley": None,
            "load_case": None,
            "points": 60,
            "sequence": 0,
            "tables": False,
        }
        solve_fast(request)
        solve_all(request)
