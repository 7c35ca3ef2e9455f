"""Saved designs in a database: SQLite, or PostgreSQL by URL."""
