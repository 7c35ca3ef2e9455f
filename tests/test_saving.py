"""Files are written whole or not at all, and told beforehand where they cannot be."""

import os
import stat
import sys
from pathlib import Path

import pytest

from wraparc import InputError
from wraparc.saving import save_file, saving_problems


def sentence(path: object, **options: object) -> str:
    (problem,) = saving_problems(str(path), **options)  # type: ignore[arg-type]
    return str(problem)


def test_text_and_bytes_are_written_as_they_are(tmp_path: Path) -> None:
    save_file(tmp_path / "a", "Ω\n")
    save_file(tmp_path / "b", b"\x00\r\n")
    assert (tmp_path / "a").read_bytes() == b"\xce\xa9\n"
    assert (tmp_path / "b").read_bytes() == b"\x00\r\n"
    assert len(list(tmp_path.iterdir())) == 2


def test_what_was_there_survives_a_failure(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "a"
    target.write_text("old", "utf-8")

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(InputError) as caught:
        save_file(target, "new")
    assert str(caught.value) == (
        f'"{target}": cannot be written: No space left on device. Choose another place.'
    )
    assert target.read_text("utf-8") == "old"
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.skipif(sys.platform == "win32", reason="modes and links of POSIX")
def test_modes_and_links_are_kept(tmp_path: Path) -> None:
    target, link = tmp_path / "a", tmp_path / "link"
    target.write_text("old", "utf-8")
    target.chmod(0o640)
    link.symlink_to(target)
    save_file(link, "new")
    assert link.is_symlink()
    assert target.read_text("utf-8") == "new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


@pytest.mark.skipif(sys.platform == "win32", reason="there is no /dev/null")
def test_a_device_is_written_to_and_not_replaced() -> None:
    assert saving_problems("/dev/null") == []
    save_file("/dev/null", "x")
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


def test_a_good_place_is_left_as_it_was(tmp_path: Path) -> None:
    assert saving_problems(tmp_path / "a.json", suffixes=(".json",)) == []
    assert list(tmp_path.iterdir()) == []


def test_bad_places_in_full_sentences(tmp_path: Path) -> None:
    given = tmp_path / "in.json"
    given.write_text("", "utf-8")
    assert sentence(tmp_path) == f'"{tmp_path}": is a folder. Name a file in that folder.'
    assert sentence(tmp_path / "no" / "a") == (
        f'"{tmp_path}/no/a": there is no folder "{tmp_path}/no". Make the folder first.'
    )
    assert sentence(given, inputs=[given], key="--json") == (
        f'--json = "{given}": is the file that is read, and would be written over. Choose another '
        "name."
    )
    assert sentence("a.jpg", suffixes=(".svg", ".png")) == (
        '"a.jpg": the kind of file is told by its ending, which must be .svg or .png. Write for '
        'example "a.svg".'
    )
    assert "cannot be written" in sentence("a\x00b")


def test_a_place_that_refuses_drafts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "touch", refuse)
    assert sentence(tmp_path / "a", key="--csv") == (
        f'--csv = "{tmp_path}/a": cannot be written: Permission denied. Choose another place.'
    )
