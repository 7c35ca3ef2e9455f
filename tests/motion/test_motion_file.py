"""The [motion] table, and the commands that read it: every door to drives in time."""

import csv
import math
import re
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from cli.running import Ran
from cli.running import wraparc as run_command
from wraparc import Constant, InputError, load_drive, load_motion, load_train
from wraparc.answer.motion_sheet import run_sheet, stability_sheet
from wraparc.answer.sheet import shown
from wraparc.checks import Level, judge_run
from wraparc.drive.criteria import Sag
from wraparc.friction.base import TestedRange
from wraparc.motion import (
    Droop,
    ExactSpeed,
    Follower,
    Start,
    Stop,
    simulate,
    stability,
    stability_map,
)
from wraparc.motion.event import Event, LoadStep
from wraparc.motion.file import motion_from_text, read_record
from wraparc.motion.result import Peak, RunResult
from wraparc.plot.motion import plot_run, plot_stability, plot_stability_map
from wraparc.train import Motor, solve_train
from wraparc.units import in_units

TANDEMS = ["examples/tandem-fabric.toml", "examples/tandem-steel-cord.toml"]
INERTIA = 'inertia = "2200 kg m2"'
QUICK = ["motion.event.start.duration=3 s"]


@pytest.mark.parametrize("file", TANDEMS)
def test_the_shipped_tandems_have_events(file: str) -> None:
    motion = load_motion(file)
    assert [e.name for e in motion.events] == [
        "start", "start and stop", "run-out", "splice", "wet patch",
    ]  # fmt: skip
    assert isinstance(motion.station.drums[1].control, ExactSpeed)
    assert "illustrative" in motion.station.source
    assert load_train(file) == motion.station.train


def test_a_file_without_motion_says_what_to_write() -> None:
    with pytest.raises(InputError) as told:
        load_motion("examples/triple-steel-cord.toml")
    # every drum by its name, with the key that is needed, as it stands in a file
    assert 'motion.drum."head 1".inertia: missing. Write [motion.drum."head 1"]' in str(told.value)
    assert str(told.value).count("inertia: missing") == 3


def test_a_file_without_events_has_the_usual_ones() -> None:
    text = Path(TANDEMS[0]).read_text("utf-8").partition("[[motion.event]]")[0]
    motion = motion_from_text(text)
    assert motion.assumed
    assert [e.name for e in motion.events] == ["start", "start and stop"]
    assert motion.event().from_rest
    assert not load_motion(TANDEMS[0]).assumed


def test_a_start_beyond_the_torque_of_the_motors_is_refused_with_the_time_it_needs() -> None:
    limited = '{kind="droop", torque_limit=1.5}'
    settings = [f"motion.drum.{drum}.control={limited}" for drum in ("first", "second")]
    motion = load_motion(TANDEMS[0], overrides=settings)
    with pytest.raises(InputError, match=r"Start in [\d.]+ s, or raise torque_limit") as told:
        simulate(motion.station, replace(motion.events[0], happenings=(Start(time=5.0),)))
    # closed form: M = 100 t and J/R^2 = 2 x 13.4 t, steepest pi/2 V/t, 1.5 times 105 kN to give
    radius = motion.station.train.pulleys[0].radius
    moved = 100e3 + 2.0 * 2200.0 / radius**2
    least = moved * math.pi / 2.0 * 3.0 / (0.5 * 105e3)
    found = re.search(r"Start in ([\d.]+) s", str(told.value))
    assert found is not None
    assert float(found[1]) == pytest.approx(least, rel=0.04)


def test_a_drive_file_may_have_it_too(tmp_path: Path) -> None:
    path = tmp_path / "drive.toml"
    text = Path("examples/head-drive-fabric.toml").read_text("utf-8")
    name = load_drive("examples/head-drive-fabric.toml").pulleys[0].name
    path.write_text(text + f'\n[motion.drum."{name}"]\ninertia = "2000 kg m2"\n', "utf-8")
    motion = load_motion(path)
    assert isinstance(motion.station.drums[0].control, Droop)
    load_drive(path)  # what does not look at it reads past it


def test_every_fault_is_told_at_once() -> None:
    text = Path(TANDEMS[0]).read_text("utf-8")
    text = text.replace('width = "1200 mm"', 'width = "-1 m"')
    text = text.replace('inertia = "2200 kg m2"', 'inertia = "5 kg"', 1)
    text = text.replace('carry_run = "50 m"', 'winch_sped = "1 m/s"')
    text = text.replace('shape = "s-curve"', 'shape = "s-kurve"')
    text = text.replace('pulley = "second", run_out', 'puley = "second", run_out')
    with pytest.raises(InputError) as told:
        motion_from_text(text)
    said = str(told.value)
    for part in (
        "belt.width",
        "where a moment of inertia is needed",
        'Did you mean "winch_speed"?',
        'Did you mean "s-curve"?',
        'Did you mean "pulley"?',
    ):
        assert part in said


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('control = { kind = "exact-speed" }', 'control = { kind = "speed-loop" }', "bandwidth"),
        ('control = { kind = "exact-speed" }', 'control = { kind = "induction" }', "starting_rat"),
        ("[motion.drum.second]", "[motion.drum.third]", "no such pulley"),
        ('source = "', 'take_up = "fixed"\nconveyor_mas = "1 t"\nsource = "', "conveyor_mass"),
        ('shape = "s-curve", time', 'file = "a.csv", time', "unknown key"),
        (INERTIA, f'{INERTIA}\nmotor_inertia = "8 kg m2"', "gear_ratio: missing: motor_inertia"),
        (INERTIA, f"{INERTIA}\ngear_ratio = 25", "gear_ratio: needs motor_in"),
    ],
)
def test_bad_input_is_told(old: str, new: str, sentence: str) -> None:
    text = Path(TANDEMS[0]).read_text("utf-8")
    assert old in text
    with pytest.raises(InputError, match=sentence):
        motion_from_text(text.replace(old, new))


def test_inertia_of_the_motors_goes_through_the_gear() -> None:
    """J = J_drum + J_motor i^2: by a gear ratio given, or by that of the motor in the train."""
    text = Path(TANDEMS[0]).read_text("utf-8")
    geared = f'{INERTIA}\nmotor_inertia = "3.2 kg m2"\ngear_ratio = 25'
    first, second = motion_from_text(text.replace(INERTIA, geared, 1)).station.drums
    assert (first.inertia, second.inertia) == (2200.0 + 3.2 * 25.0**2, 2200.0)
    text = Path("examples/triple-steel-cord.toml").read_text("utf-8")
    train = load_train("examples/triple-steel-cord.toml")
    motors = train.cases[0].division.motors  # type: ignore[union-attr]
    tables = [
        f'[motion.drum."{p.name}"]\ninertia = "1 t m2"\nmotor_inertia = "2 kg m2"'
        for p in train.pulleys
    ]
    drums = motion_from_text("\n".join([text, *tables])).station.drums
    for drum, motor in zip(drums, motors, strict=True):
        assert isinstance(motor, Motor)
        assert motor.gear_ratio > 1.0
        assert drum.inertia == pytest.approx(1000.0 + 2.0 * motor.gear_ratio**2, rel=1e-12)


def test_a_record_is_read_with_its_units(tmp_path: Path) -> None:
    path = tmp_path / "record.csv"
    path.write_text("time [ms],speed [rpm]\n0,60\n500,120\n", "utf-8")
    record = read_record(path, "first")
    assert record.times == (0.0, 0.5)
    assert record.values[1] == pytest.approx(12.566370614)
    for text, sentence in (
        ("time,speed\n0,1\n", "with their units"),
        ("time [s],speed [rpm]\n0,1\n1,\n", "line 3: a value is missing"),
        ("time [s],speed [rpm]\n0,1\n1,x\n", "line 3"),
        ("time [s],speed [rpm]\n1,1\n0,1\n", "must ascend"),
    ):
        path.write_text(text, "utf-8")
        with pytest.raises(InputError, match=sentence):
            read_record(path, "first")


def test_a_record_drives_an_event(tmp_path: Path) -> None:
    text = Path(TANDEMS[0]).read_text("utf-8")
    text += '\n[[motion.event]]\nname = "as measured"\nduration = "1 s"\n'
    text += 'happens = [{ kind = "measured", pulley = "first", file = "record.csv" }]\n'
    (tmp_path / "record.csv").write_text("time [s],torque [kN m]\n0,20\n1,22\n", "utf-8")
    path = tmp_path / "drive.toml"
    path.write_text(text, "utf-8")
    event = load_motion(path).event("as measured")
    assert event.happenings[0].values == (20e3, 22e3)  # type: ignore[attr-defined]
    with pytest.raises(InputError, match=r"cannot be a path here, got .record\.csv"):
        motion_from_text(text)
    lines = "time [s],torque [kN m]\\n0,20\\n1,22\\n"
    inside = text.replace('file = "record.csv"', f'record = "{lines}"')
    assert motion_from_text(inside).event("as measured") == event
    with pytest.raises(InputError, match=r"happens\[1\].record: a value is missing"):
        motion_from_text(inside.replace("1,22", "1,"))
    with pytest.raises(InputError, match="must be either file or record"):
        motion_from_text(inside.replace("record = ", 'file = "a.csv", record = '))


def test_no_such_event_is_told() -> None:
    with pytest.raises(InputError, match='Did you mean "start"'):
        load_motion(TANDEMS[0]).event("strat")


@pytest.fixture(scope="module")
def short_start() -> Ran:
    return run_command("run", TANDEMS[0], "--quiet", "--points", "30", "--set", QUICK[0])


def test_the_command_run_tells_the_worst_first(short_start: Ran) -> None:
    assert short_start.code == 0
    assert "The drives" in short_start.out
    assert "Peak creep at exit" in short_start.out


def test_the_command_run_streams_files(tmp_path: Path) -> None:
    table, columns = tmp_path / "run.csv", tmp_path / "run.parquet"
    done = run_command(
        "run", TANDEMS[0], "--quiet", "--points", "20", "--set", QUICK[0], "--every", "0.1 s",
        "--csv", str(table), "--parquet", str(columns),
    )  # fmt: skip
    assert done.code == 0, done.err
    rows = list(csv.reader(table.read_text("utf-8").splitlines()))
    assert rows[0][:3] == ["time [s]", "belt speed [m/s]", "first: entry tension [N]"]
    assert len(rows) == pytest.approx(31, abs=2)
    assert float(rows[-1][0]) == pytest.approx(3.0, abs=0.05)
    import pyarrow.parquet as pq

    assert pq.read_table(columns).num_rows == len(rows) - 1


def test_the_commands_refuse_before_they_work(tmp_path: Path) -> None:
    bad = run_command("run", TANDEMS[0], "--step", "0 s", "--quiet")
    assert bad.code == 2
    assert "must be more than 0" in bad.err
    coarse = run_command("run", TANDEMS[0], "--event", "run-out", "--step", "0.2 s", "--quiet")
    assert coarse.code == 2
    assert "too coarse for 1.19 Hz" in coarse.err


def test_the_command_stability_answers_the_question() -> None:
    done = run_command("stability", TANDEMS[0])
    assert done.code == 0
    assert (
        "ATTENTION  Te ripple 3.3 % exceeds the 2 % limit (second, 0.5 mm run-out, 1.19 Hz)."
        in done.out
    )
    assert "What other controls would make of it" in done.out


def test_pictures_and_words_of_a_run_and_of_a_follower() -> None:
    motion = load_motion(
        TANDEMS[0],
        overrides=['motion.drum.second.control={kind="follower", master="first"}', *QUICK],
    )
    assert isinstance(motion.station.drums[1].control, Follower)
    run = simulate(motion.station, motion.event("start"), points=20)
    assert plot_run(run).to_bytes("png")[:4] == b"\x89PNG"
    assert judge_run(run).level in (Level.OK, Level.ATTENTION, Level.FAILS)
    assert shown(run_sheet(run), "si").tables
    found = stability(motion.station)
    verdict = shown(stability_sheet(found), "si").verdict
    assert verdict is not None
    assert verdict.text.startswith("Self-excited oscillation at 2.78 Hz, doubling time ")
    assert "damping" in verdict.sentences[0]
    assert plot_stability(found).to_bytes("png")[:4] == b"\x89PNG"
    assert plot_stability_map(stability_map(motion.station, points=4)).to_bytes("png")


def test_the_note_follows_the_events_that_ask_for_it(tmp_path: Path) -> None:
    note = tmp_path / "note.md"
    asked = ("--set", "motion.event.start.report=true", "--set", QUICK[0])
    done = run_command("report", TANDEMS[0], "-o", str(note), *asked)
    text = note.read_text("utf-8")
    assert "In time: events and vibrations" in text
    assert "The drives: start" in text
    assert "Te ripple 3.3 % exceeds the 2 % limit" in " ".join(text.split())
    worst = judge_run(short_run())
    # its checks count: they stand among the others, and in the headline where they are the worst
    assert in_units(worst.text) in " ".join(text.split())
    assert done.code in (0, 1)
    plain = tmp_path / "plain.md"
    run_command("report", TANDEMS[0], "-o", str(plain))
    assert "In time" not in plain.read_text("utf-8")
    bad = run_command("report", TANDEMS[0], "-o", "-", "--set", 'motion.event.start.report="yes"')
    assert bad.code == 2
    assert "motion.event.start.report" in bad.err


@pytest.mark.parametrize(("creep", "level"), [(63e-3, "ATTENTION"), (64e-3, "FAILS")])
def test_a_belt_that_slides_through_an_event_fails_it(creep: float, level: str) -> None:
    """Ten customary limits of 6.35 mm: gross slip that a run can follow to its end."""
    run = short_run()
    first, *others = run.drums
    most = replace(first.extremes, creep=Peak(creep, 1.0))
    slid = whole(replace(run, drums=(replace(first, extremes=most), *others)))
    verdict = judge_run(slid)
    assert verdict.level.value == level
    slides = "Gross slip: creep 64 mm exceeds 63.5 mm (first, start, 1 s)."
    passes = "Creep 63 mm exceeds the 6.35 mm limit (first, start, 1 s)."
    assert in_units(verdict.text) == (slides if level == "FAILS" else passes)


def test_peaks_and_verdict_do_not_hang_on_the_rows_that_are_kept() -> None:
    """A tenth of a second may decide; identity, and the rows of every step."""
    motion = load_motion(TANDEMS[0], overrides=[*QUICK, "creep_limit=0.5 mm"])
    rows: list[Sequence[float]] = []
    event = motion.event("start")
    for step in (None, 8e-3):  # in parts where much happens, or all alike
        rows.clear()
        fine = simulate(motion.station, event, points=30, step=step, sink=rows.append)
        coarse = simulate(motion.station, event, points=30, step=step, every=1.0)
        assert len(coarse.time) < 5
        assert [d.extremes for d in coarse] == [d.extremes for d in fine]
        assert [d.over_limit for d in coarse] == [d.over_limit for d in fine]
        assert judge_run(coarse).text == judge_run(fine).text
    table = np.abs(np.array(rows))  # of the first drum: T1, T2, speed, torque, creep, slip, shear
    most = fine.drums[0].extremes
    found = [p.value for p in (most.most_entry_tension, most.torque, most.creep, most.shear)]
    assert found == table[:, [2, 5, 6, 8]].max(axis=0).tolist()
    assert most.least_exit_tension.value == table[:, 3].min()
    assert most.pull.value == np.abs(table[:, 2] - table[:, 3]).max()
    assert most.creep.time == table[table[:, 6].argmax(), 0]
    assert most.slip.value >= table[:, 7].max()
    # creep goes straight from row to row: it rises through the limit once
    over = np.flatnonzero(table[:, 6] > 0.5e-3)
    (t0, low), (t1, high) = (table[i, [0, 6]] for i in (over[0] - 1, over[0]))
    assert np.array_equal(over, np.arange(over[0], len(table)))
    since = t0 + (0.5e-3 - low) / (high - low) * (t1 - t0)
    assert 0.1 < table[-1, 0] - since < 2.9
    assert fine.drums[0].over_limit == pytest.approx(table[-1, 0] - since, rel=1e-9)
    # slip is about the same through a wrap at a start: it goes as fast as it grows at the exit
    rates = np.diff(table[:, 7]) / np.diff(table[:, 0])
    assert rates.max() <= most.slip_speed.value * (1.0 + 1e-9)


def whole(run: RunResult) -> RunResult:
    """A start as if it were over."""
    speed = run.station.train.belt.speed
    assert speed is not None
    return replace(run, belt_speed=np.append(run.belt_speed[:-1], speed))


def limited(run: RunResult, what: str, part: float) -> RunResult:
    """A run whose drive bears a part of what the event asks of it."""
    train, most = run.station.train, run.drums[0].extremes
    belt, first = train.belt, train.pulleys[0]
    lagging = first.lagging
    pressure = 2.0 / (belt.width * first.diameter)
    tested = TestedRange(pressure_min=500.0, pressure_max=1e7, slip_max=0.3, slip_speed=0.3)
    if what == "bond_stress":
        lagging = replace(lagging, bond_strength=part * most.shear.value)
    elif what == "tested_slip":
        tested = replace(tested, slip_max=part * most.slip.value)
    elif what == "tested_slip_speed":
        tested = replace(tested, slip_speed=part * most.slip_speed.value)
    elif what == "tested_pressure_max":
        tested = replace(tested, pressure_max=part * pressure * most.most_tension.value)
    elif what == "tested_pressure_min":
        tested = replace(tested, pressure_min=pressure * most.least_tension.value / part)
    elif what == "face_pressure":
        belt = replace(belt, largest_wrap_pressure=part * pressure * most.most_tension.value)
    elif what == "momentary_tension":
        belt = replace(belt, rating=part * run.peak_tension.value / belt.width)
    elif what == "pulley_diameter":
        belt = replace(belt, least_pulley_diameter=first.diameter / part)
    sag = None
    if what == "sag":  # a parabola: T = m' g l/(8 h)
        tension = min(
            most.least_entry_tension.value, run.drums[1].extremes.least_exit_tension.value
        )
        sag = Sag(spacing=3.0, line_mass=tension / part * 8.0 * 0.02 / (9.80665 * 3.0), share=0.02)
    pulleys = tuple(
        replace(p, lagging=replace(lagging, law=Constant(friction_coefficient=0.4, tested=tested)))
        for p in train.pulleys
    )
    criteria = replace(train.criteria, sag=sag)
    train = replace(train, belt=belt, pulleys=pulleys, criteria=criteria, creep_limit=0.06)
    return replace(run, station=replace(run.station, train=train))


@pytest.mark.parametrize(
    ("what", "level"),
    [
        ("bond_stress", "ATTENTION"),
        ("tested_slip", "ATTENTION"),
        ("tested_slip_speed", "ATTENTION"),
        ("tested_pressure_max", "ATTENTION"),
        ("tested_pressure_min", "ATTENTION"),
        ("face_pressure", "ATTENTION"),
        ("momentary_tension", "FAILS"),
        ("pulley_diameter", "FAILS"),
        ("sag", "ATTENTION"),
    ],
)
def test_an_event_is_held_against_every_limit_that_it_can_miss(what: str, level: str) -> None:
    """Each alone: just kept it is OK, just missed it governs."""
    run = whole(short_run())
    assert judge_run(limited(run, what, 1.02)).level.value == "OK"
    missed = judge_run(limited(run, what, 0.98))
    assert missed.level.value == level
    assert missed.governing is not None
    assert missed.governing.name == what


def test_an_event_that_fails_leads_the_note_and_its_exit_code(tmp_path: Path) -> None:
    path, note = tmp_path / "drive.toml", tmp_path / "note.md"
    text = Path(TANDEMS[0]).read_text("utf-8").partition("[[motion.event]]")[0]
    back = '{ kind = "load-step", at = "0.5 s", factor = -2.0, time = "0.5 s" }'
    text += (
        f'[[motion.event]]\nname = "back"\nduration = "2 s"\nreport = true\nhappens = [{back}]\n'
    )
    path.write_text(text, "utf-8")
    done = run_command("report", str(path), "-o", str(note))
    assert done.code == 1
    said = note.read_text("utf-8")
    lead = next(line for line in said.splitlines() if line.startswith("- **"))
    assert re.fullmatch(
        r"- \*\*FAILS\*\* Belt goes slack before first at 1\.3\d* s \(back\)\.", lead
    )
    assert re.search(r"\| Event completed \|.*\| FAILS \| back ", said)  # among the checks


def test_a_start_that_is_not_over_asks_to_look_longer() -> None:
    """Its peaks are still to come: no OK stands over them."""
    run = short_run()
    unsettled = judge_run(run)
    assert unsettled.governing is not None
    assert (unsettled.level, unsettled.governing.name) == (Level.ATTENTION, "run")
    assert judge_run(whole(run)).level is Level.OK
    assert in_units(unsettled.text).startswith("Belt speed ")
    assert "at the end, not 3 m/s (start)." in in_units(unsettled.text)
    assert unsettled.governing.action_text == "Give the event a longer duration."
    # a stop is over when the belt stands
    stopping = replace(run.event, happenings=(Stop(time=1.0),))
    v = run.station.train.belt.speed
    assert v is not None
    for end, level in ((0.09 * v, "OK"), (0.11 * v, "ATTENTION"), (v, "ATTENTION")):
        speeds = np.append(run.belt_speed[:-1], end)
        stopped = judge_run(replace(run, event=stopping, belt_speed=speeds))
        assert stopped.level.value == level


def test_exit_codes_are_those_of_the_verdicts(tmp_path: Path) -> None:
    weak = "belt.rating=60 kN/m"
    fast = [*QUICK, weak]
    settings = [part for setting in fast for part in ("--set", setting)]
    done = run_command("run", TANDEMS[0], "--event", "start", "--points", "20", *settings)
    assert done.code == 1
    assert "FAILS" in done.out
    follower = 'motion.drum.second.control={kind="follower", master="first", lag="0.1 s"}'
    hunts = run_command("stability", TANDEMS[0], "--set", follower)
    assert (hunts.code, "Self-excited oscillation at" in hunts.out) == (1, True)


def test_steps_that_lead_nowhere_are_refused() -> None:
    for step, sentence in (
        ("5 s", r"too coarse for a wrap of 1260 mm, got 5 s. Take 0.10 s or less"),
        ("1e-9 s", r"3,000,000,000 steps, more than 20,000,000"),
    ):
        done = run_command("run", TANDEMS[0], "--step", step, "--set", QUICK[0])
        assert done.code == 2
        assert re.search(sentence, done.err), done.err


def test_only_what_starts_or_stops_may_use_the_momentary_rating() -> None:
    start = limited(whole(short_run()), "momentary_tension", 0.98)
    train = start.station.train
    train = replace(train, belt=replace(train.belt, momentary_factor=1.5))
    start = replace(start, station=replace(start.station, train=train))
    assert judge_run(start).level is Level.OK
    load = replace(start.event, happenings=(LoadStep(at=1.0, factor=1.2),))
    lasting = judge_run(replace(start, event=load))
    assert lasting.governing is not None
    assert (lasting.level, lasting.governing.name) == (Level.FAILS, "belt_tension")


@cache
def short_run() -> RunResult:
    motion = load_motion(TANDEMS[0], overrides=QUICK)
    return simulate(motion.station, motion.event("start"), points=60)


def test_a_run_has_the_friction_of_its_load_case() -> None:
    """Expected: `solve_train` of the load case, which is wet; so is what moves, from the start."""
    text = Path("examples/tandem-fabric.toml").read_text("utf-8")
    wet = 'name = "empty"\ncondition = "wet"'
    whole = motion_from_text(text.replace('name = "empty"', wet, 1).replace(
        "[motion]", '[motion]\nload_case = "empty"', 1))  # fmt: skip
    station = whole.station
    still = Event(duration=0.05, happenings=(LoadStep(at=0.01, factor=1.0),))
    found = simulate(station, still)
    case = next(c for c in solve_train(station.train).cases if c.case.name == "empty")
    dry = solve_train(motion_from_text(text).station.train).cases[1]
    for name, drum in zip(("first", "second"), found, strict=True):
        peak = drum.extremes.creep.value
        assert peak == pytest.approx(case[name].arc.exit_creep, rel=2e-4)
        assert peak > 1.05 * dry[name].arc.exit_creep


def test_a_brake_is_slack_where_the_belt_enters() -> None:
    """T1 is 3 % of T2 there, as steady as elsewhere: the belt goes slack at a part of T1."""
    text = """format = 1
[belt]
width = "1.8 m"
speed = "1 m/s"
modulus = "45 MN/m"
[[pulley]]
name = "head"
diameter = "800 mm"
wrap_angle = "210 deg"
lagging = "full-ceramic"
entry_tension = "7.2 kN"
exit_tension = "240 kN"
[motion]
conveyor_mass = "100 t"
[motion.drum.head]
inertia = "900 kg m2"
control = { kind = "exact-speed" }
[[motion.event]]
name = "still"
duration = "0.1 s"
happens = [{ kind = "load-step", at = "0.05 s", factor = 1.0 }]
"""
    motion = motion_from_text(text)
    found = simulate(motion.station, motion.events[0])
    assert found.outcome.whole
    (drum,) = found
    assert drum.entry_tension[-1] == pytest.approx(7.2e3, rel=1e-3)
