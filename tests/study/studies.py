"""Study files for tests."""

from pathlib import Path
from typing import Any

from wraparc.study.file import StudyFile, study_from_document

EXAMPLES = Path(__file__).parents[2] / "examples"
FOLDER = str(EXAMPLES / "studies")


def study_of(*axes: dict[str, Any], **keys: Any) -> StudyFile:
    """Return the study of the head drive with some axes."""
    document = {"format": 1, "drive": "head-drive.toml", "axis": list(axes), **keys}
    return study_from_document(document, file="study.toml", folder=FOLDER)


TAKE_UP = {
    "field": "pulley.head.exit_tension", "from": "40 kN", "to": "90 kN", "count": 6
}  # fmt: skip
FRICTION = {
    "field": "pulley.head.lagging.friction_factor",
    "distribution": "uniform",
    "from": 0.6,
    "to": 1.1,
}
SAMPLING = {"samples": 100, "seed": 4}
