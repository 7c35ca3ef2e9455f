"""Trains solved once for all tests of a note."""

from functools import cache
from pathlib import Path

from wraparc import DriveResult
from wraparc.cli.solve import solve_as_train
from wraparc.train import TrainResult
from wraparc.train.file import load_drive_or_train

EXAMPLES = Path(__file__).parents[2] / "examples"


@cache
def train(name: str) -> tuple[TrainResult, list[DriveResult]]:
    """An example train and its pulleys, by both methods."""
    read = load_drive_or_train(EXAMPLES / f"{name}.toml")
    return solve_as_train(read, "both", None, None, name)
