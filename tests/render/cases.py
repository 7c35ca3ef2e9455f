"""Trains solved once for all tests of a note."""

from functools import cache
from pathlib import Path

from wraparc import DriveResult
from wraparc.cli.solve import solved
from wraparc.train import TrainResult
from wraparc.train.file import load_drive_or_train

EXAMPLES = Path(__file__).parents[2] / "examples"


@cache
def train(name: str) -> tuple[TrainResult, list[DriveResult]]:
    """An example train and its pulleys, by both methods."""
    read = load_drive_or_train(EXAMPLES / f"{name}.toml")
    results, whole = solved(read, "both", None, None, name)
    assert whole is not None
    return whole, results
