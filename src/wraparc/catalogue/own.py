"""A catalogue of one's own: laggings and belts in a folder, by name in every door.

The environment variable ``WRAPARC_CATALOGUE`` names the folder. ``laggings/NAME.toml`` in it are
lagging files, which may have a cost in any currency; ``belts.toml`` lists belts.
"""

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from wraparc.catalogue.belt_modulus import MODULUS_TESTS
from wraparc.errors import input_error, shown
from wraparc.provenance import Provenance
from wraparc.schema.kinds import Choice, Name, Percent, Quantity, Rows
from wraparc.schema.limits import Limit
from wraparc.schema.origins import own_provenance
from wraparc.schema.shared_keys import FORMAT_ENTRY, PROVENANCE
from wraparc.schema.source import parse, read_text, read_whole
from wraparc.schema.tables import Entry, Table, need

#: What names the folder.
VARIABLE = "WRAPARC_CATALOGUE"
BELTS_FILE, LAGGINGS_FOLDER = "belts.toml", "laggings"
#: What a lagging of one's own may be called.
NAME = re.compile(r"[A-Za-z0-9][\w-]{0,59}", re.ASCII)
_SUFFIX = ".toml"
_PER_WIDTH = Quantity("force_per_width", Limit("force_per_width", open=True))
#: How a modulus was measured, in a drive file too.
MODULUS_KEYS = (
    Entry(
        "modulus_test",
        "How the modulus was measured: dynamic (elastic elongation after load cycles, ISO 9856) or "
        "static (first stretch, ISO 283, DIN 22102); not stated if left out.",
        Choice(MODULUS_TESTS),
    ),
    Entry(
        "modulus_loads",
        "Lowest and highest load of that measurement, of the breaking strength.",
        Rows(Percent(), 2, 2),
    ),
)

BELTS = Table(
    "Belts of one's own",
    FORMAT_ENTRY,
    need(
        "belt",
        kind=Rows(
            Table(
                "Belt",
                need("name", "As drive files name it.", Name(60)),
                need("kind", kind=Choice(("fabric", "steel cord"))),
                need("rating", "Rated tension per unit width.", _PER_WIDTH),
                need("modulus", "Per unit width.", _PER_WIDTH),
                *MODULUS_KEYS,
                Entry(
                    "least_pulley_diameter",
                    "Smallest drive pulley at 75-100 % of the rating.",
                    Quantity("length", Limit("length", open=True)),
                ),
                Entry(
                    "carcass",
                    "Thickness of the carcass, or diameter of the cords.",
                    Quantity("length", Limit("length", open=True, most=0.06)),
                ),
                Entry("provenance", "Where its numbers came from.", PROVENANCE),
            ),
            1,
            1000,
        ),
        example="a [[belt]] table",
    ),
)


def own_folder() -> Path | None:
    """Return the folder of the user's own catalogue; None without one.

    Raises
    ------
    InputError
        If it is named and not there.
    """
    given = os.environ.get(VARIABLE)
    if not given:
        return None
    folder = Path(given).expanduser().absolute()
    if not folder.is_dir():
        raise input_error(
            key=VARIABLE,
            value=shown(given),
            message="the folder of your own catalogue is not there",
            remedy="Make it, or clear this environment variable.",
        )
    return folder


def own_laggings(folder: Path) -> dict[str, Path]:
    """Return the lagging files of a folder by name, sorted."""
    inside = folder / LAGGINGS_FOLDER
    found = sorted(inside.glob(f"*{_SUFFIX}")) if inside.is_dir() else []
    return {path.stem: path for path in found if not path.name.startswith(".")}


def own_belts(folder: Path) -> Iterator[tuple[dict[str, Any], Provenance]]:
    """Yield the belts of a folder, each with where its numbers came from.

    Raises
    ------
    InputError
        With everything that is wrong with its file.
    """
    path = folder / BELTS_FILE
    if not path.exists():
        return
    record, report = read_whole(BELTS, parse(read_text(path), str(path)), str(path))
    for row in record["belt"]:
        yield dict(row), own_provenance(row, report) or Provenance()
