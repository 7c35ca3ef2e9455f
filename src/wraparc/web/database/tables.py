"""Tables of the database."""

from datetime import UTC, datetime
from typing import Any

from sqlalchemy import (
    DateTime,
    ForeignKey,
    Index,
    Integer,
    String,
    Text,
    TypeDecorator,
    UniqueConstraint,
)
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column, relationship


class Moment(TypeDecorator[datetime]):
    """A moment in UTC; SQLite keeps no zone."""

    impl = DateTime(timezone=True)
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Any) -> datetime | None:
        """Store in UTC."""
        return None if value is None else value.astimezone(UTC)

    def process_result_value(self, value: datetime | None, dialect: Any) -> datetime | None:
        """Return with its zone."""
        if value is None:
            return None
        return value.replace(tzinfo=UTC) if value.tzinfo is None else value.astimezone(UTC)


class Base(DeclarativeBase):
    """All tables."""


class Design(Base):
    """A design under its name."""

    __tablename__ = "designs"
    __table_args__ = (Index("ix_designs_listed", "binned", "changed", "id"),)

    id: Mapped[int] = mapped_column(Integer, primary_key=True)
    name: Mapped[str] = mapped_column(String(200), index=True)
    kind: Mapped[str] = mapped_column(String(20))
    created: Mapped[datetime] = mapped_column(Moment)
    changed: Mapped[datetime] = mapped_column(Moment, index=True)
    newest: Mapped[int] = mapped_column(Integer)
    binned: Mapped[datetime | None] = mapped_column(Moment)
    versions: Mapped[list["Version"]] = relationship(
        back_populates="design", order_by="Version.number", passive_deletes=True
    )


class Version(Base):
    """A design as it was saved once; never changed afterwards."""

    __tablename__ = "versions"
    __table_args__ = (UniqueConstraint("design_id", "number"),)

    id: Mapped[int] = mapped_column(Integer, primary_key=True)
    design_id: Mapped[int] = mapped_column(ForeignKey("designs.id", ondelete="CASCADE"), index=True)
    number: Mapped[int] = mapped_column(Integer)
    created: Mapped[datetime] = mapped_column(Moment)
    who: Mapped[str] = mapped_column(String(200))
    note: Mapped[str] = mapped_column(Text)
    document: Mapped[str] = mapped_column(Text)
    program: Mapped[str] = mapped_column(String(40))
    request: Mapped[str | None] = mapped_column(String(200), index=True, unique=True)
    design: Mapped[Design] = relationship(back_populates="versions")
