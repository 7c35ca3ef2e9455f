"""How long a list of 10,000 saved designs takes, as a client sees it.

python benchmarks/web_designs.py
"""

import json
import statistics
import sys
import tempfile
import time
from datetime import UTC, datetime
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from web.calculators import API, client, document
from wraparc.web.database.store import Store
from wraparc.web.database.tables import Design, Version

COUNT = 10_000
ASKED = ("", "?limit=200", "?query=99&limit=200", "?limit=200&offset=9000", "?bin=true")


def main() -> None:
    """Fill a file, ask for lists of it, print the median of each."""
    text, now = json.dumps(document()), datetime.now(UTC)
    with tempfile.TemporaryDirectory() as folder:
        url = f"sqlite:///{folder}/designs.sqlite"
        store = Store.open(url)
        with store._session(writes=True) as session:
            for number in range(COUNT):
                design = Design(
                    name=f"drive {number}", kind="drive", created=now, changed=now, newest=1
                )
                design.versions.append(
                    Version(
                        number=1, created=now, who="", note="", document=text, program="benchmark"
                    )
                )
                session.add(design)
        store.close()
        with client(database=url) as api:
            for query in ASKED:
                times = []
                for _ in range(9):
                    begin = time.perf_counter()
                    assert api.get(f"{API}/designs{query}").status_code == 200
                    times.append(1e3 * (time.perf_counter() - begin))
                print(f"/designs{query:<24} {statistics.median(times):7.1f} ms")


if __name__ == "__main__":
    main()
