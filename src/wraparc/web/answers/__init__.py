"""Requests as plain data to answers as plain data: what the worker processes run."""
