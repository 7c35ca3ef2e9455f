"""The calculator while it is worked on: what is served is made anew whenever its source changes.

``python tools/page_watch.py [drive.toml]`` serves until Ctrl-C. A change of the page alone is only
bundled; one of Python is translated too, and the server starts again. Then load the page again.
"""

import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

from page_kernel import BUNDLE, MADE, ROOT

SOURCE = ROOT / "src" / "wraparc"
KINDS = {".py", ".js", ".css", ".html", ".svg", ".toml"}
#: Between two looks [s].
PAUSE = 0.3


def times(folder: Path = SOURCE) -> dict[Path, int]:
    """Return when each source file was changed, without those that are made."""
    found = dict[Path, int]()
    for path in folder.rglob("*"):
        if path.suffix in KINDS and path not in MADE and "built" not in path.parts:
            with suppress(FileNotFoundError):  # an editor's, gone again
                found[path] = path.stat().st_mtime_ns
    return found


def changed(before: dict[Path, int], now: dict[Path, int]) -> set[Path]:
    """Return which files came, went or are others."""
    return {path for path, _ in before.items() ^ now.items()}


def made(of: set[Path]) -> bool:
    """Make what is served anew; return whether the server has to start again."""
    python = any(path.suffix in (".py", ".toml") for path in of)
    translate = [sys.executable, str(ROOT / "tools" / "page_kernel.py")]
    command = translate if python else ["node", str(BUNDLE)]
    wrong = subprocess.run(command, cwd=ROOT, check=False).returncode
    names = ", ".join(sorted(path.relative_to(ROOT).as_posix() for path in of))
    print(f"{'NOT made anew' if wrong else 'made anew'} for {names}", flush=True)
    return python and not wrong


def main() -> None:
    """Serve, look, make anew."""
    serve = [sys.executable, "-m", "wraparc", "serve", *sys.argv[1:]]
    server, before = subprocess.Popen(serve), times()
    try:
        while True:
            time.sleep(PAUSE)
            now = times()
            of, before = changed(before, now), now
            if of and made(of):
                server.terminate()
                server.wait()
                server = subprocess.Popen(serve)
    except KeyboardInterrupt:
        pass
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
