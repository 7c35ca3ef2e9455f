"""Uploaded files, in memory only, for a while, limited in size and number."""

import secrets
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from wraparc.web.answers.shear_tests import MachineFile, ReadFile
from wraparc.web.asked import TestFileRequest
from wraparc.web.errors import refused

LIFE = 1800.0
MOST_SESSIONS, MOST_FILES = 1000, 60
MOST_FILE, MOST_SESSION, MOST_IN_ALL = 20_000_000, 60_000_000, 200_000_000
#: A log of a plant may be all of its session.
MOST_LOG = MOST_SESSION


@dataclass
class Upload:
    """One file as it was sent, and what is said about it.

    Attributes
    ----------
    id
        Its number in the session; it is never found by its name.
    name
        As the browser told it, for messages only.
    data
        Its bytes.
    said
        What the user says about it: pressure, condition, choices ...
    read
        What was read.
    """

    id: str
    name: str
    data: bytes
    said: TestFileRequest = field(default_factory=TestFileRequest)
    read: ReadFile = field(default_factory=ReadFile)

    @property
    def file(self) -> MachineFile:
        """The file, to be read."""
        return MachineFile(self.id, self.name, self.data, self.said)


@dataclass
class Session:
    """The files of one visitor."""

    id: str
    used: float
    uploads: dict[str, Upload] = field(default_factory=dict)
    next: int = 1

    @property
    def size(self) -> int:
        """Bytes held."""
        return sum(len(upload.data) for upload in self.uploads.values())


class Sessions:
    """All sessions of a server."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._sessions: dict[str, Session] = {}

    def create(self) -> Session:
        """Return a new session; of too many, one without files or the one longest unused goes."""
        self._sweep()
        if len(self._sessions) >= MOST_SESSIONS:
            goes = min(self._sessions.values(), key=lambda s: (bool(s.uploads), s.used))
            del self._sessions[goes.id]
        session = Session(secrets.token_urlsafe(16), self._clock())
        self._sessions[session.id] = session
        return session

    def get(self, name: str) -> Session:
        """Return a session, which lives on from now."""
        self._sweep()
        if name not in self._sessions:
            raise refused(404, "these files are not kept any more", "Drop them again.")
        found = self._sessions[name]
        found.used = self._clock()
        return found

    def add(self, session: Session, name: str, data: bytes, most: int = MOST_FILE) -> Upload:
        """Keep a file of at most so many bytes."""
        if len(session.uploads) >= MOST_FILES:
            raise refused(413, f"more than {MOST_FILES} files", "Take some away.", name)
        if len(data) > most:
            limit = f"{most / 1e6:g} MB"
            raise refused(413, f"the file is larger than {limit}", "Send a part.", name)
        if session.size + len(data) > MOST_SESSION:
            raise refused(413, "the files together are too large", "Take some away.", name)
        self._make_room(session, len(data))
        upload = Upload(str(session.next), name, data)
        session.next += 1
        session.uploads[upload.id] = upload
        return upload

    def _make_room(self, session: Session, size: int) -> None:
        """Forget the files of others, those longest unused first, until all fit into memory."""
        others = sorted(self._sessions.values(), key=lambda s: s.used)
        for other in (s for s in others if s is not session and s.uploads):
            if sum(s.size for s in others) + size <= MOST_IN_ALL:
                return
            del self._sessions[other.id]
            other.uploads.clear()

    def upload(self, session: Session, number: str) -> Upload:
        """Return a file of a session."""
        if number not in session.uploads:
            raise refused(404, "there is no such file", "Drop it again.")
        return session.uploads[number]

    def forget(self, name: str) -> None:
        """Forget a session with its files."""
        if self._sessions.pop(name, None) is None:
            raise refused(404, "there is no such session")

    def _sweep(self) -> None:
        now = self._clock()
        for session in [s for s in self._sessions.values() if now - s.used > LIFE]:
            del self._sessions[session.id]


def shown_name(name: str | None) -> str:
    """Return the name of an upload for messages: its last part, printable, short."""
    last = (name or "").replace("\\", "/").rpartition("/")[2]
    return "".join(c for c in last if c.isprintable())[:120].strip() or "file"
