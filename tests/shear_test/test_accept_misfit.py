"""A law that does not describe its tests is written only where the misfit is accepted."""

import shutil
from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc.cli.demo import examples_folder
from wraparc.errors import InputError
from wraparc.files import load_lagging
from wraparc.files.write import lagging_text
from wraparc.shear_test.analysis import checked_reason
from wraparc.web.answers.shear_tests import MachineFile, fit
from wraparc.web.asked import FitRequest, TestFileRequest

EXAMPLE = examples_folder() / "shear_tests"
FILES = {"dry-0034kPa-1.csv": "34 kPa", "dry-0207kPa-1.csv": "207 kPa"}
REASON = "for a comparison only; the rig is mended next week"
#: The tests have 0.5 mm of lash.
RIG = {"sample_area": "400 cm2", "largest_lash": "0.1 mm"}


@pytest.fixture(scope="module")
def plan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("laboratory")
    rig = "".join(f'{key} = "{value}"\n' for key, value in RIG.items())
    text = f'format = 1\n[lagging]\nname = "mine"\nsurface = "rubber"\n[rig]\n{rig}'
    for name, pressure in FILES.items():
        shutil.copy(EXAMPLE / name, folder)
        text += f'[[test]]\nfile = "{name}"\npressure = "{pressure}"\n'
    path = folder / "plan.toml"
    path.write_text(text, "utf-8")
    return path


@pytest.fixture(scope="module")
def accepted(plan: Path) -> Path:
    """The lagging file, written with a reason."""
    file = plan.parent / "accepted.toml"
    ran = wraparc("fit", plan, "-o", file, "--accept-misfit", REASON, "--full")
    assert ran.code == 0
    assert f"Misfit accepted: {REASON}." in ran.words
    return file


def test_without_a_reason_the_report_is_written_and_the_lagging_is_not(plan: Path) -> None:
    lagging, report = plan.parent / "lagging.toml", plan.parent / "fit.html"
    ran = wraparc("fit", plan, "-o", lagging, "--report", report)
    assert ran.code == 1
    assert not lagging.exists()
    assert "more than the 0.1 mm the rig can have" in report.read_text("utf-8")
    words = " ".join(ran.err.split())
    assert f"{lagging} not written: fit rejected (3 remarks)." in (words)
    assert '--accept-misfit "reason".' in words


def test_the_reason_travels_with_the_lagging(accepted: Path) -> None:
    lagging = load_lagging(accepted)
    assert lagging.fit is not None
    assert lagging.fit.misfit_accepted == REASON
    assert f'misfit_accepted = "{REASON}"' in lagging_text([lagging])
    assert f"Misfit accepted: {REASON}" in wraparc("lagging", accepted).words


def test_a_drive_that_is_solved_with_it_says_so(accepted: Path) -> None:
    text = (examples_folder() / "head-drive-fabric.toml").read_text("utf-8")
    text = text.replace('lagging = "diamond-rubber"', f'lagging = "{accepted.name}"')
    drive = accepted.parent / "drive.toml"
    drive.write_text(text, "utf-8")
    words = wraparc("solve", drive, "--load-case", "design", "--full").words
    assert "Friction fit: test[1] (dry-0034kPa-1.csv): the curve requires a lash" in words
    assert f"The laboratory wrote it nevertheless: {REASON}." in words


@pytest.mark.parametrize("reason", ["", "   ", "x" * 501, "one\nline"])
def test_a_reason_must_say_something(reason: str, tmp_path: Path) -> None:
    ran = wraparc("fit", tmp_path / "nowhere.toml", "--accept-misfit", reason)
    assert ran.code == 2
    assert "--accept-misfit" in ran.err
    assert "must be text of 1 to 500 printable characters" in ran.err
    with pytest.raises(InputError):
        checked_reason(reason)


def test_a_law_that_fits_needs_no_reason_and_keeps_none(plan: Path) -> None:
    good = plan.parent / "good.toml"
    good.write_text(plan.read_text("utf-8").replace('"0.1 mm"', '"3 mm"'), "utf-8")
    file = plan.parent / "good-lagging.toml"
    assert wraparc("fit", good, "-o", file, "--accept-misfit", REASON).code == 0
    lagging = load_lagging(file)
    assert lagging.fit is not None
    assert lagging.fit.misfit_accepted == ""


def test_the_calculator_does_the_same() -> None:
    files = [
        MachineFile(id=name, name=name, data=(EXAMPLE / name).read_bytes(), said=said)
        for name, pressure in FILES.items()
        for said in [TestFileRequest(pressure=pressure)]
    ]
    asked = FitRequest(lagging={"name": "mine"}, rig=RIG)
    answer = fit(asked, files)
    assert answer.name == "mine"
    assert answer.lagging is None
    assert answer.toml is None
    assert answer.conditions[0].misfit
    answer = fit(asked.model_copy(update={"accept_misfit": REASON}), files)
    assert answer.lagging is not None
    assert answer.toml is not None
    assert answer.lagging.keys().isdisjoint({"format", "name"})
    assert f'misfit_accepted = "{REASON}"' in answer.toml
