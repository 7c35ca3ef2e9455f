"""Designs saved, listed, opened: the only place that asks the database."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from typing import Annotated, cast

from pydantic import PlainSerializer
from sqlalchemy import ColumnElement, Engine, func, select
from sqlalchemy.exc import DBAPIError, IntegrityError, SQLAlchemyError
from sqlalchemy.orm import Session

from wraparc.errors import Problem
from wraparc.version import __version__
from wraparc.web.answers.shown import Answer, Data, DriveKind
from wraparc.web.database.engine import WRITES, open_engine, reason
from wraparc.web.database.tables import Design, Version
from wraparc.web.errors import ApiError


def _text(moment: datetime) -> str:
    return moment.astimezone(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")


Moment = Annotated[datetime, PlainSerializer(_text, return_type=str)]


class VersionRow(Answer):
    """A version without its document."""

    version: int
    created: Moment
    who: str
    note: str
    program: str


class VersionAnswer(VersionRow):
    """A version with its document."""

    id: int
    name: str
    kind: DriveKind
    document: Data


class DesignRow(Answer):
    """A design in the list."""

    id: int
    name: str
    kind: DriveKind
    versions: int
    created: Moment
    changed: Moment
    who: str
    note: str


class DesignAnswer(Answer):
    """A design and its versions."""

    id: int
    name: str
    kind: DriveKind
    versions: list[VersionRow]
    newest: int
    created: Moment
    changed: Moment
    who: str
    note: str


class Designs(Answer):
    """A part of the list."""

    total: int
    designs: list[DesignRow]


class NoSuchDesignError(ApiError):
    """There is no such design, or version of it."""

    def __init__(self) -> None:
        problem = Problem(message="there is no such design", remedy="Choose one of the list.")
        super().__init__(404, problem)


class NewerVersionError(ApiError):
    """Somebody has saved another version meanwhile."""

    def __init__(self, newest: int) -> None:
        message = f"version {newest} of this design was saved meanwhile"
        remedy = "Open it, or save this one under another name."
        super().__init__(409, Problem(message=message, remedy=remedy, key="base"))
        self.newest = newest


class Store:
    """The saved designs.

    Parameters
    ----------
    engine
        See `open_engine`.
    """

    def __init__(self, engine: Engine) -> None:
        self._engine = engine

    @classmethod
    def open(cls, url: str, shown: str = "") -> "Store":
        """Return the designs of a database; its tables are made where they are missing."""
        return cls(open_engine(url, shown))

    def close(self) -> None:
        """Give back the connections."""
        self._engine.dispose()

    @contextmanager
    def _session(self, *, writes: bool = False) -> Iterator[Session]:
        options, committing = {WRITES: writes}, False
        try:
            with Session(self._engine.execution_options(**options)) as session, session.begin():
                yield session
                committing = writes
        except IntegrityError:
            raise
        except SQLAlchemyError as error:
            raise _unavailable(error, writes=writes, committing=committing) from None

    def listed(
        self, query: str = "", offset: int = 0, limit: int = 50, *, binned: bool = False
    ) -> Designs:
        """Return designs, last changed first, whose name contains a text; or those in the bin."""
        chosen: list[ColumnElement[bool]] = [
            Design.binned.is_not(None) if binned else Design.binned.is_(None)
        ]
        if query:
            chosen.append(Design.name.icontains(query, autoescape=True))
        newest = (Version.design_id == Design.id) & (Version.number == Design.newest)
        rows = (
            select(Design, Version.who, Version.note)
            .join(Version, newest)
            .where(*chosen)
            .order_by(Design.changed.desc(), Design.id.desc())
            .offset(offset)
            .limit(limit)
        )
        with self._session() as session:
            total = session.scalar(select(func.count()).select_from(Design).where(*chosen)) or 0
            found = [DesignRow(**_summary(*row)) for row in session.execute(rows)]
        return Designs(total=total, designs=found)

    def create(
        self,
        name: str,
        kind: str,
        document: Data,
        *,
        note: str,
        who: str,
        request: str | None = None,
    ) -> VersionAnswer:
        """Save a new design; return its first version, the same one if it is sent twice."""
        now = datetime.now(UTC)
        try:
            with self._session(writes=True) as session:
                design = Design(name=name, kind=kind, created=now, changed=now, newest=1)
                version = _version(1, now, document, note, who, request)
                design.versions.append(version)
                session.add(design)
                session.flush()
                return _opened(design, version)
        except IntegrityError:
            before = self._saved_before(request, document)
            if before is None:
                raise
            return before

    def design(self, number: int) -> DesignAnswer:
        """Return a design with all its versions, without their documents."""
        with self._session() as session:
            found = _get(session, number)
            newest = found.versions[-1]
            versions = [VersionRow(**_version_data(version)) for version in found.versions]
            summary = _summary(found, newest.who, newest.note)
        return DesignAnswer(**{**summary, "newest": summary["versions"], "versions": versions})

    def version(self, design: int, number: int) -> VersionAnswer:
        """Return one version with its document."""
        with self._session() as session:
            found = _get(session, design)
            chosen = select(Version).where(Version.design_id == design, Version.number == number)
            version = session.scalar(chosen)
            if version is None:
                raise NoSuchDesignError
            return _opened(found, version)

    def add(
        self,
        design: int,
        base: int,
        kind: str,
        document: Data,
        *,
        note: str,
        who: str,
        name: str | None = None,
        request: str | None = None,
    ) -> VersionAnswer:
        """Save a new version made from version `base`, under another name if one is given.

        Raises
        ------
        NewerVersionError
            If `base` is not the newest any more; then the name stays as well.
        """
        now = datetime.now(UTC)
        try:
            with self._session(writes=True) as session:
                found = _get(session, design, lock=True)
                if found.newest != base:
                    raise NewerVersionError(found.newest)
                found.newest, found.kind, found.changed = base + 1, kind, now
                found.name = name or found.name
                version = _version(base + 1, now, document, note, who, request)
                found.versions.append(version)
                session.flush()
                return _opened(found, version)
        except (NewerVersionError, IntegrityError) as error:
            before = self._saved_before(request, document)
            if before is None:
                newest = error.newest if isinstance(error, NewerVersionError) else base + 1
                raise NewerVersionError(newest) from None
            return before

    def _saved_before(self, request: str | None, document: Data) -> VersionAnswer | None:
        """Return the version that this very request has saved before, None if there is none."""
        if request is None:
            return None
        with self._session() as session:
            version = session.scalar(select(Version).where(Version.request == request))
            if version is None:
                return None
            if json.loads(version.document) != document:
                message = "another design was saved with this key"
                remedy = "Send a new key with every new save."
                raise ApiError(422, Problem(message=message, remedy=remedy, key="Idempotency-Key"))
            return _opened(version.design, version)

    def rename(self, design: int, name: str) -> None:
        """Give a design another name."""
        with self._session(writes=True) as session:
            _get(session, design, lock=True).name = name

    def throw_away(self, design: int) -> None:
        """Put a design into the bin."""
        with self._session(writes=True) as session:
            _get(session, design, lock=True).binned = datetime.now(UTC)

    def take_back(self, design: int) -> None:
        """Take a design out of the bin."""
        with self._session(writes=True) as session:
            _get(session, design, lock=True, binned=True).binned = None

    def delete(self, design: int) -> None:
        """Delete a design that is in the bin, with all its versions, for good."""
        with self._session(writes=True) as session:
            session.delete(_get(session, design, lock=True, binned=True))


def _unavailable(error: SQLAlchemyError, *, writes: bool, committing: bool) -> ApiError:
    """Return what a database in trouble means for the user."""
    text = reason(error)
    if committing and isinstance(error, DBAPIError) and error.connection_invalidated:
        problem = Problem(
            message=f"the saved designs went out of reach ({text})",
            remedy="See whether it is listed before you save again.",
        )
        return ApiError(503, problem, {"retry-after": "5"})
    saved = "Leave the page open, or save the design as a file."
    if "is full" in text or "No space left" in text:
        problem = Problem(message="the disk with the saved designs is full", remedy=saved)
        return ApiError(507, problem)
    problem = Problem(
        message=f"the saved designs cannot be reached ({text})",
        remedy=saved if writes else "Try again in a moment.",
    )
    return ApiError(503, problem, {"retry-after": "5"})


def _get(session: Session, design: int, *, lock: bool = False, binned: bool = False) -> Design:
    found = session.get(Design, design, with_for_update=lock)
    if found is None or (found.binned is not None) != binned:
        raise NoSuchDesignError
    return found


def _version(
    number: int, now: datetime, document: Data, note: str, who: str, request: str | None
) -> Version:
    text = json.dumps(document, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return Version(
        number=number,
        created=now,
        who=who,
        note=note,
        document=text,
        program=__version__,
        request=request,
    )


def _summary(design: Design, who: str, note: str) -> Data:
    return {
        "id": design.id,
        "name": design.name,
        "kind": design.kind,
        "versions": design.newest,
        "created": design.created,
        "changed": design.changed,
        "who": who,
        "note": note,
    }


def _version_data(version: Version) -> Data:
    return {
        "version": version.number,
        "created": version.created,
        "who": version.who,
        "note": version.note,
        "program": version.program,
    }


def _opened(design: Design, version: Version) -> VersionAnswer:
    return VersionAnswer(
        id=design.id,
        name=design.name,
        kind=cast(DriveKind, design.kind),
        document=json.loads(version.document),
        **_version_data(version),
    )
