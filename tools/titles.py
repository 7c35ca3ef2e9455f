"""The titles of commits: at most 72 characters, no full stop, in the imperative.

``python tools/titles.py`` reads those of the commits that are here and were written after `SINCE`,
``python tools/titles.py --message FILE`` the one that is about to be made, for
`tools/hooks/commit-msg`, which ``make hooks`` puts to use. What git writes itself (merges, reverts,
fixups) is left alone.
"""

import re
import subprocess
import sys
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MOST = 72
#: Titles before it stay as they are. A moment, no commit: a shallow clone may lack any commit.
SINCE = datetime.fromisoformat("2026-11-29T17:20:00+00:00")
_BY_GIT = re.compile(r"(Merge|Revert|Reapply|fixup!|squash!|amend!) ?")
_ROOM = re.compile(r"[\w./-]+: +")
_WORD = re.compile(r"[A-Za-z]+(?![\w'-])")
#: Words that no imperative begins with.
_OTHERS = {
    "a", "an", "the", "this", "that", "these", "those", "it", "its", "they", "their", "he", "she",
    "we", "our", "you", "your", "i", "my", "what", "which", "who", "whose", "nothing", "none",
    "nobody", "everything", "no",
}  # fmt: skip
#: Imperatives that look like another form, and words that may stand before an imperative.
_BRINGS = {"bring", "cling", "fling", "ping", "ring", "sing", "sling", "spring", "sting", "string",
           "swing", "wing", "during"}  # fmt: skip
_EMBEDS = {"bed", "embed", "shed", "shred", "sled", "wed", "instead"}
_ALWAYS = {"always", "sometimes", "afterwards", "perhaps", "besides"}


def faults(title: str) -> Iterator[str]:
    """Yield what is wrong with a title; no fault is reported that may be none."""
    if _BY_GIT.match(title):
        return
    if not title.strip():
        yield "it is empty"
        return
    if len(title) > MOST:
        yield f"it has {len(title)} characters, {MOST} at most"
    if title.endswith(".") and not title.endswith(("..", "etc.")):
        yield "it ends in a full stop"
    text = _ROOM.sub("", title, count=1).removeprefix("No longer ").removeprefix("no longer ")
    first = _WORD.match(text)
    if first and not is_imperative(first[0].lower()):
        yield f'it begins with "{first[0]}" and not with an imperative ("Add", not "Added", "Adds")'


def is_imperative(word: str) -> bool:
    """Return whether a word, in small letters, may be an imperative."""
    if word.endswith("ing") and len(word) > 4:
        return word in _BRINGS
    if word.endswith("ed") and not word.endswith("eed"):
        return word in _EMBEDS
    if word.endswith("s") and not word.endswith(("ss", "us", "is", "as", "os")):
        return word in _ALWAYS
    return word not in _OTHERS


def title_of(message: str) -> str:
    """Return the first line of a message that git would keep."""
    lines = (line.rstrip() for line in message.splitlines())
    return next((line for line in lines if line and not line.startswith("#")), "")


def commits() -> list[tuple[str, str]]:
    """Return name and title of the commits that are here and were written after `SINCE`."""
    command = ("git", "log", "--no-merges", "--format=%h%x00%at%x00%s")
    try:
        log = subprocess.run(command, cwd=ROOT, capture_output=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return []  # no git, or no clone: what is released has no commits
    rows = [line.split("\0") for line in log.stdout.decode("utf-8", "replace").splitlines()]
    return [(name, title) for name, at, title in rows if int(at) > SINCE.timestamp()]


def main(arguments: list[str]) -> int:
    """Report the faults of one message, or of the commits that are here."""
    if arguments[:1] == ["--message"]:
        message = Path(arguments[1]).read_text("utf-8", "replace")
        titles = [("title", title_of(message))]
    else:
        titles = commits()
    lines = [f"{name}: {fault}: {title}" for name, title in titles for fault in faults(title)]
    print(*lines, sep="\n", end="\n" if lines else "", file=sys.stderr)
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
