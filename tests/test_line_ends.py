"""A checkout with the line ends of Windows: files are read alike, a shell reads its own."""

import shutil
import subprocess
from pathlib import Path

import pytest

from wraparc import load_drive

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "examples"


@pytest.mark.parametrize("name", ["head-drive-fabric", "downhill-braking", "uphill-conveyor"])
def test_a_drive_file_with_other_line_ends_is_the_same_drive(name: str, tmp_path: Path) -> None:
    text = (EXAMPLES / f"{name}.toml").read_text("utf-8").replace("\r\n", "\n")
    other = tmp_path / f"{name}.toml"
    other.write_bytes(text.replace("\n", "\r\n").encode())
    assert load_drive(other) == load_drive(EXAMPLES / f"{name}.toml")


def test_what_a_shell_or_make_reads_has_the_line_ends_of_linux_everywhere() -> None:
    if shutil.which("git") is None or not (ROOT / ".git").exists():
        pytest.skip("no clone of git")
    shell = ["Makefile", ".ci/run", "tools/hooks/commit-msg"]
    command = ["git", "check-attr", "eol", "--", *shell]
    told = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert told.splitlines() == [f"{name}: eol: lf" for name in shell]
    for name in shell:
        assert b"\r" not in (ROOT / name).read_bytes()
