"""Records of a virtual instrumented pulley: read, cut, folded; and what cannot be told."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from calibrate.coverage import DRIVE
from cli.running import wraparc
from wraparc import ArcResult, Distributed, InputError, WrapArc
from wraparc.calibrate.fold import fold
from wraparc.calibrate.record import RecordChoices, read_record, unwrapped
from wraparc.calibrate.virtual_pulley import PulleyRecord, record_text, virtual_record

EXAMPLES = Path(__file__).parents[2] / "examples"
ARC = WrapArc.of(DRIVE, DRIVE.pulleys[0], DRIVE.load_cases[0])


@pytest.fixture(scope="module")
def result() -> ArcResult:
    return Distributed(points=360, capacities=False).solve(ARC)


def close(record: PulleyRecord, result: ArcResult, within: float) -> None:
    folded = fold(record, DRIVE, "head", "design")
    for values, course in (
        (folded.displacement, result.profile.creep),
        (folded.shear_angle, result.profile.shear_angle),
    ):
        assert values is not None
        truth = np.interp(folded.position, result.profile.position, course)
        assert np.abs(values - truth).max() < within * np.abs(truth).max()


@pytest.mark.parametrize("samples", [2000, 20_000])
@pytest.mark.parametrize("entry", [0.3, 5.9])
def test_the_contact_arc_is_found(result: ArcResult, samples: int, entry: float) -> None:
    """Within a degree of where the virtual sensor passed the nip; one contact arc a turn."""
    record = virtual_record(result, samples=samples, revolutions=6.0, entry=entry, noise=0.005)
    folded = fold(record, DRIVE, "head", "design")
    apart = np.angle(np.exp(1j * (folded.entry - entry)))
    assert abs(np.degrees(apart)) < 1.0
    assert folded.revolutions in (5, 6)
    close(record, result, 0.03)


def test_sign_offset_direction_and_wrap_do_not_matter(result: ArcResult) -> None:
    plain = virtual_record(result, samples=8000, noise=0.0)
    assert plain.displacement is not None
    turned = PulleyRecord(-plain.angle, 7e-3 - plain.displacement, plain.shear_angle)
    folded = fold(turned, DRIVE, "head", "design")
    assert "turned round" in " ".join(folded.notes)
    close(turned, result, 0.02)
    assert np.allclose(unwrapped(np.mod(plain.angle, 2 * np.pi)), plain.angle)
    backwards = unwrapped(np.mod(-plain.angle, 2 * np.pi))
    assert np.allclose(backwards - backwards[0], -plain.angle)


def test_a_written_record_reads_back(result: ArcResult, tmp_path: Path) -> None:
    record = virtual_record(result, samples=500)
    path = tmp_path / "r.csv"
    path.write_text(record_text(record), "utf-8")
    back = read_record(path)
    assert np.allclose(back.angle, record.angle, atol=1e-5)
    assert back.displacement is not None
    assert record.displacement is not None
    assert np.allclose(back.displacement, record.displacement, atol=1e-7)


def german(text: str) -> str:
    heads, _, rows = text.partition("\n")
    heads = "Zeit [s];Drehwinkel [deg];Schlupf [mm];Scherwinkel [deg]"
    return heads + "\n" + rows.replace(",", ";").replace(".", ",")


def in_inches(text: str) -> str:
    rows = [line.split(",") for line in text.splitlines()[1:]]
    out = [f"{float(a) / 360}\t{float(u) / 25.4}\t{g}" for _, a, u, g in rows]
    return "\n".join(["rotation [rev]\tbelt creep [in]\tgamma [deg]", *out]) + "\n"


@pytest.mark.parametrize("written", [german, in_inches])
def test_other_units_and_number_signs(
    result: ArcResult, tmp_path: Path, written: Callable[[str], str]
) -> None:
    record = virtual_record(result, samples=2000, noise=0.002)
    path = tmp_path / "r.txt"
    path.write_text(written(record_text(record)), "utf-8")
    close(read_record(path), result, 0.03)


@pytest.mark.parametrize(
    ("heads", "sentence"),
    [
        ("time [s],rotation,belt displacement [mm],lagging shear [deg]", "has no unit"),
        ("time [s],rotation [mm],belt displacement [mm],lagging shear [deg]", "rotation"),
        ("a,b,c,d", "no column is recognised as angle"),
        (
            "time [s],rotation [deg],belt creep [mm],belt travel [mm]",
            "several columns could be the displacement",
        ),
    ],
)
def test_what_cannot_be_told_is_asked(
    result: ArcResult, tmp_path: Path, heads: str, sentence: str
) -> None:
    text = record_text(virtual_record(result, samples=200))
    path = tmp_path / "r.csv"
    path.write_text(heads + "\n" + text.partition("\n")[2], "utf-8")
    with pytest.raises(InputError) as raised:
        read_record(path)
    assert sentence in str(raised.value)


def test_what_was_asked_can_be_said(result: ArcResult, tmp_path: Path) -> None:
    text = record_text(virtual_record(result, samples=2000, noise=0.002))
    path = tmp_path / "r.csv"
    path.write_text("a,b,c,d\n" + text.partition("\n")[2], "utf-8")
    choices = RecordChoices(
        columns={"angle": 2, "displacement": "c", "shear_angle": 4},
        units={"angle": "deg", "displacement": "mm", "shear_angle": "deg"},
    )
    close(read_record(path, choices), result, 0.03)


def test_a_record_without_a_full_contact_arc(result: ArcResult) -> None:
    record = virtual_record(result, samples=2000, revolutions=0.4)
    with pytest.raises(
        InputError, match="no full contact arc: rotation 144 deg is below wrap 180 deg"
    ):
        fold(record, DRIVE, "head", "design")
    begun = virtual_record(result, samples=2000, revolutions=0.6, entry=1.0)
    with pytest.raises(InputError, match="no full contact arc"):
        fold(begun, DRIVE, "head", "design")
    noise = PulleyRecord(
        np.linspace(0, 30, 3000), np.random.default_rng(1).standard_normal(3000) * 1e-3, None
    )
    with pytest.raises(InputError, match="does not stand out of its noise"):
        fold(noise, DRIVE, "head", "design")


def test_a_sign_that_cannot_be_told_is_asked(result: ArcResult) -> None:
    record = virtual_record(result, samples=4000, noise=0.0)
    assert record.shear_angle is not None
    along = np.mod(record.angle - 1.0, 2 * np.pi)
    both = np.where(along < np.pi, np.sin(2 * along), 0.0)
    odd = PulleyRecord(record.angle, None, both)
    with pytest.raises(InputError, match=r"changes its sign under the belt\. Write 1 if positive"):
        fold(odd, DRIVE, "head", "design")
    fold(odd, DRIVE, "head", "design", choices=RecordChoices(signs={"shear_angle": 1}))


def test_the_example_finds_the_friction_it_was_made_with() -> None:
    """wet-day.csv was made with 0.78 of the dry friction."""
    ran = wraparc("calibrate", EXAMPLES / "wet-season" / "wet-day-record.toml", "--json", "-")
    assert ran.code == 0, ran.err
    (estimate,) = ran.json["estimates"]
    assert estimate["value"] == pytest.approx(0.78, abs=0.005)


def test_the_overlay_shows_both_methods(tmp_path: Path) -> None:
    file = EXAMPLES / "wet-season" / "wet-day-record.toml"
    ran = wraparc("overlay", file, "--plot", tmp_path / "o.svg")
    assert ran.code == 0, ran.err
    assert "measured distributed paper" in ran.words
    assert "contact arcs entry nip at exit nip at" in ran.words
    assert (tmp_path / "o.svg").stat().st_size > 5000


def test_a_virtual_record_is_written_by_the_command(tmp_path: Path) -> None:
    drive = EXAMPLES / "head-drive-fabric.toml"
    ran = wraparc("virtual-record", drive, tmp_path / "r.csv", "--samples", "400")
    assert ran.code == 0, ran.err
    assert len(read_record(tmp_path / "r.csv")) == 400
    assert wraparc("virtual-record", drive, tmp_path / "r.csv", "--pulley", "x").code == 2
