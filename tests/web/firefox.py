"""Firefox without a window, driven by its own Marionette, for pages opened from the disk."""

import contextlib
import json
import os
import shutil
import signal
import socket
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from web.calculators import PATIENCE, wait_for

_NAMES = ("firefox-esr", "firefox")
#: It asks nobody for updates or news; a free port is chosen, and told in a file.
_SETTINGS = {
    "marionette.port": 0,
    "app.update.enabled": False,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "network.proxy.type": 1,  # a proxy that is not there: nothing leaves this machine
    "network.proxy.http": "127.0.0.1",
    "network.proxy.http_port": 9,
    "network.proxy.ssl": "127.0.0.1",
    "network.proxy.ssl_port": 9,
}


class Firefox:
    """One window; scripts run in its page."""

    def __init__(self, port: int) -> None:
        self._line = socket.create_connection(("127.0.0.1", port), timeout=PATIENCE)
        self._stream = self._line.makefile("rb")
        self._count = 0
        self._read()  # its greeting
        self._ask("WebDriver:NewSession", {})
        self._ask("WebDriver:SetTimeouts", {"script": int(1e3 * PATIENCE)})

    def open(self, address: str) -> None:
        """Go to a page."""
        self._ask("WebDriver:Navigate", {"url": address})

    def run(self, script: str, *given: Any) -> Any:
        """Return what a script returns; `arguments` are what it is given."""
        asked = {"script": script, "args": given}
        return self._ask("WebDriver:ExecuteScript", asked)["value"]

    def close(self) -> None:
        """End the session."""
        self._stream.close()
        self._line.close()

    def _ask(self, command: str, given: dict[str, Any]) -> Any:
        self._count += 1
        text = json.dumps([0, self._count, command, given]).encode("utf-8")
        self._line.sendall(b"%d:%b" % (len(text), text))
        _, _, error, found = self._read()
        assert error is None, f"{command}: {error}"
        return found

    def _read(self) -> Any:
        digits = b""
        while not digits.endswith(b":"):
            byte = self._stream.read(1)
            assert byte, "Firefox has gone"
            digits += byte
        return json.loads(self._stream.read(int(digits[:-1])))


@contextlib.contextmanager
def firefox(profile: Path) -> Iterator[Firefox]:
    """Run Firefox for a while, with a profile of its own."""
    program = next(filter(None, map(shutil.which, _NAMES)), None)
    assert program, "no Firefox: `make system` installs it"
    lines = (f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in _SETTINGS.items())
    (profile / "user.js").write_text("".join(lines), "utf-8")
    command = [program, "--headless", "--marionette", "--no-remote", "--profile", str(profile)]
    told = profile / "MarionetteActivePort"
    with (
        (profile / "log").open("wb") as log,
        subprocess.Popen(
            command,
            stdout=log,
            stderr=log,
            env={**os.environ, "HOME": str(profile)},
            start_new_session=True,
        ) as process,
    ):
        try:
            wait_for(lambda: told.is_file() and told.read_text("ascii").strip())
            found = Firefox(int(told.read_text("ascii")))
            try:
                yield found
            finally:
                found.close()
        finally:
            os.killpg(process.pid, signal.SIGKILL)  # its own processes go with it
