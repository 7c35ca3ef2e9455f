"""Designs in the bin, and saves that are sent twice."""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Add what says when a design was thrown away, and which request saved a version."""
    op.add_column("designs", sa.Column("binned", sa.DateTime(timezone=True), nullable=True))
    op.create_index("ix_designs_listed", "designs", ["binned", "changed", "id"])
    op.add_column("versions", sa.Column("request", sa.String(200), nullable=True))
    op.create_index("ix_versions_request", "versions", ["request"], unique=True)


def downgrade() -> None:
    """Take both away."""
    op.drop_index("ix_versions_request", "versions")
    op.drop_column("versions", "request")
    op.drop_index("ix_designs_listed", "designs")
    op.drop_column("designs", "binned")
