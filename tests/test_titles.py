"""Titles of commits: what is refused, what never is, and clones in which nothing can be said."""

import os
import shutil
import subprocess
from datetime import timedelta
from pathlib import Path

import pytest

import titles

ROOT = Path(__file__).parents[1]


@pytest.mark.parametrize(
    ("title", "fault"),
    [
        ("A" + "dd" * 36, "it has 73 characters, 72 at most"),
        ("Add a check.", "it ends in a full stop"),
        ("Added a check", 'it begins with "Added"'),
        ("Adds a check", 'it begins with "Adds"'),
        ("Adding a check", 'it begins with "Adding"'),
        ("The check is added", 'it begins with "The"'),
        ("Tests: what waits is ended", 'it begins with "what"'),
        ("   ", "it is empty"),
    ],
)
def test_a_title_is_refused_with_what_is_wrong(title: str, fault: str) -> None:
    (told,) = titles.faults(title)
    assert told.startswith(fault)


@pytest.mark.parametrize(
    "title",
    [
        "Add" + "é" * 69, "Bring the fit to rest", "Embed the fonts", "Need no token",
        "Press a key", "Focus the first field", "No longer count what is left", "No-op",
        "Always round a minimum up", "During a start, write no record", "Don't ask twice",
        "units: read tons", "2 cores do",
        "Merge branch 'main' into a branch whose name is as long as the names of branches may be.",
        'Revert "Added a check."', "Stop at ...",
    ],
)  # fmt: skip
def test_an_imperative_is_never_accused(title: str) -> None:
    assert list(titles.faults(title)) == []


def test_a_comment_of_git_is_no_title() -> None:
    assert titles.title_of("\n# Please enter\nAdd a check  \n\nBecause.\n") == "Add a check"


def test_the_titles_of_this_clone_are_in_order() -> None:
    assert titles.main([]) == 0


def git(folder: Path, *arguments: str, at: str = "2026-12-01T00:00:00Z") -> str:
    """Return what git prints, without the settings of whoever runs the tests."""
    environment = {
        "PATH": os.environ["PATH"], "HOME": str(folder), "GIT_CONFIG_NOSYSTEM": "1",
        "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@example.org", "GIT_AUTHOR_DATE": at,
        "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@example.org", "GIT_COMMITTER_DATE": at,
    }  # fmt: skip
    command = ("git", "-C", str(folder), *arguments)
    ran = subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=60, check=False
    )
    return ran.stdout + ran.stderr


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """Return a clone with a title of before, one that is in order and one that is not."""
    if shutil.which("git") is None:
        pytest.skip("git is not installed")
    git(tmp_path, "init", "-q", "-b", "main", "made")
    made = tmp_path / "made"
    before = (titles.SINCE - timedelta(days=1)).isoformat()
    git(made, "commit", "-q", "--allow-empty", "-m", "The first.", at=before)
    git(made, "commit", "-q", "--allow-empty", "-m", "Add a check")
    git(made, "commit", "-q", "--allow-empty", "-m", "Mended.")
    return made


def test_only_titles_since_the_fixed_point_are_read(
    clone: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(titles, "ROOT", clone)
    assert titles.main([]) == 1
    told = capsys.readouterr().err.splitlines()
    assert [line.partition(": ")[2].partition(":")[0] for line in told] == [
        "it ends in a full stop",
        'it begins with "Mended" and not with an imperative ("Add", not "Added", "Adds")',
    ]


def test_a_shallow_clone_or_none_fails_nobody(
    clone: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    git(clone, "commit", "-q", "--allow-empty", "-m", "Add another")
    git(tmp_path, "clone", "-q", "--depth", "1", clone.as_uri(), "shallow")
    empty = tmp_path / "elsewhere"
    empty.mkdir()
    git(tmp_path, "init", "-q", "fresh")
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path))
    for folder, known in (("shallow", ["Add another"]), ("elsewhere", []), ("fresh", [])):
        monkeypatch.setattr(titles, "ROOT", tmp_path / folder)
        assert [title for _, title in titles.commits()] == known
        assert titles.main([]) == 0


def test_the_hook_refuses_a_commit_before_it_is_made(clone: Path) -> None:
    for name in ("tools/titles.py", "tools/hooks/commit-msg"):
        target = clone / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes((ROOT / name).read_bytes())
        target.chmod(0o755)
    git(clone, "config", "core.hooksPath", "tools/hooks")
    told = git(clone, "commit", "--allow-empty", "-m", "Adds a check")
    assert 'it begins with "Adds"' in told
    assert "No commit was made" in told
    git(clone, "commit", "--allow-empty", "-m", "Add a third")
    assert git(clone, "log", "-2", "--format=%s").split("\n")[:2] == ["Add a third", "Mended."]
