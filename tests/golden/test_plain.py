"""What a golden file keeps of an answer; expected: written down by hand."""

import numpy as np
import pytest

from golden.plain import numbers_of_text, plain


def test_numbers_of_a_text_keep_their_units_and_leave_the_words() -> None:
    text = (
        "Creep 4.003 mm (63 %) at -180.0 deg, T2 97.50 kN [3]; on 2026-11-22, wraparc 0.1.0, ST2000"
    )
    assert numbers_of_text(text) == ["4.003 mm", "63 %", "-180.0 deg", "97.50 kN"]


def test_typed_numbers_of_a_text_are_kept_as_such() -> None:
    share = {"at": [17, 21], "value": 0.6300000000001, "unit": "1", "form": "percent"}
    creep = {"at": [6, 13], "value": 4.0034567e-3, "unit": "m", "name": "exit_creep"}
    told = {"text": "Creep 4.00 mm is 63 % in 3 of 5", "cells": [creep, share], "us": "0.158 in"}
    assert plain({"headline": told}) == {"headline": ["0.0040034567 m", "0.63", "3", "5"]}
    range_ = {"text": "312 to 125 kPa", "value": 125e3, "from": 312.5e3, "unit": "Pa"}
    noise = {"text": "0 N", "value": 3e-12, "unit": "N"}
    rows = [{"note": "as 2", "values": [range_, noise]}]
    assert plain({"tables": rows}) == {"tables": ["2", "312500 Pa", "125000 Pa", "0 N"]}


def test_a_long_row_is_thinned_and_its_sum_sees_every_number() -> None:
    row = np.linspace(0.0, 1.0, 100)
    kept = plain(row)
    assert (kept["numbers"], kept["every"], len(kept["kept"])) == (100, 9, 12)
    row[50] *= 1.0 + 1e-6  # not among those kept
    changed = plain(row)
    assert changed["kept"] == kept["kept"]
    assert changed["sum"] == pytest.approx(kept["sum"] * (1.0 + 1e-8), rel=2e-9)
    assert changed["sum"] != kept["sum"]


def test_words_stay_where_they_are_answers_and_dates_go() -> None:
    answer = {
        "level": "OK",
        "title": "a drive",
        "date": "2026-11-22",
        "none": None,
        "x": float("inf"),
    }
    assert plain(answer) == {"level": "OK", "none": None, "x": "inf"}


def test_named_tables_stand_by_their_names() -> None:
    tables = [{"key": "a", "least": 1.0}, {"key": "b", "least": 2.0}]
    assert plain(tables) == {"a": {"least": 1.0}, "b": {"least": 2.0}}
    assert plain([{"key": "a", "least": 1.0}] * 2) == [{"least": 1.0}] * 2
