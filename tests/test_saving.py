"""Files are written whole or not at all, and told beforehand where they cannot be."""

import os
import stat
import sys
import threading
from pathlib import Path

import pytest

from wraparc import InputError
from wraparc.saving import alone, interrupted, replacing, save_file, saving_problems


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
        f"{target}: cannot be written: No space left on device. Choose another place."
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
    assert sentence(tmp_path) == f"{tmp_path}: is a folder. Name a file in it."
    assert sentence(tmp_path / "no" / "a") == (
        f"{tmp_path}/no/a: its folder does not exist. Make the folder first."
    )
    assert sentence(given, inputs=[given], key="--json") == (
        f'--json: must not be a file that is read, got "{given}". Choose another name.'
    )
    assert sentence("a.jpg", suffixes=(".svg", ".png")) == (
        'a.jpg: must end in .svg or .png. Write for example "a.svg".'
    )
    assert "cannot be written" in sentence("a\x00b")


def test_a_place_that_refuses_drafts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "touch", refuse)
    assert sentence(tmp_path / "a", key="--csv") == (
        f'--csv: cannot be written: Permission denied, got "{tmp_path}/a". Choose another place.'
    )


def test_a_file_of_which_the_disk_took_only_a_part_is_not_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Some drives tell only when asked whether all is on the disk (quota, network)."""
    target = tmp_path / "a"

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(InputError, match="No space left"):
        save_file(target, "new")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(sys.platform == "win32", reason="no such limit there")
def test_what_is_larger_than_may_be_written_is_not_there(tmp_path: Path) -> None:
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, hard))
    try:
        with pytest.raises(InputError, match="cannot be written: File too large"):
            save_file(tmp_path / "a", b"x" * 5000)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert list(tmp_path.iterdir()) == []


def test_two_threads_that_write_one_file_leave_one_of_both_whole(tmp_path: Path) -> None:
    target, begun = tmp_path / "a", threading.Barrier(2)

    def write(content: bytes) -> None:
        with replacing(target) as draft:
            draft.write_bytes(content)
            begun.wait()  # both have a draft

    threads = [threading.Thread(target=write, args=(bytes([i]) * 9,)) for i in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert target.read_bytes() in (b"\0" * 9, b"\1" * 9)
    assert list(tmp_path.iterdir()) == [target]


def test_a_long_name_beyond_latin_has_a_draft_too(tmp_path: Path) -> None:
    target = tmp_path / ("鼓" * 84)
    save_file(target, "x")
    assert list(tmp_path.iterdir()) == [target]


def test_two_runs_do_not_write_one_file(tmp_path: Path) -> None:
    target = tmp_path / "a.csv"
    with alone(target, "--csv"), pytest.raises(InputError) as caught, alone(target, "--csv"):
        raise AssertionError("both write it")
    assert str(caught.value) == (
        f'--csv: another run is writing this file, got "{target}". Wait until it has ended, '
        "or name another file."
    )
    with alone(target):  # the first has ended
        pass
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_takes_no_lock_keeps_nobody_away(tmp_path: Path) -> None:
    with alone(tmp_path / "none" / "a"):
        pass


def test_an_interrupt_says_what_is_kept() -> None:
    with pytest.raises(KeyboardInterrupt) as caught, interrupted(lambda: "all of it"):
        raise KeyboardInterrupt
    assert caught.value.__notes__ == ["all of it"]
