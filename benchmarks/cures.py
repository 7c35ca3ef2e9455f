"""What the button of the verdict cures: python benchmarks/cures.py [drives].

Draws drives from the examples that are not in order, opens each in a browser and presses what the
page offers, twice at most. Prints how they end: in order, by the text that nothing tried passes, by
one that names the data that are missing, with no way offered, or with more presses to make. The
gate presses on few (tests/web/test_cures.py).
"""

import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path[0] = str(Path(__file__).parents[1] / "tests")


def main() -> None:
    from web.browser import Visitor, browser
    from web.calculators import Process
    from web.cures import failing, pressed

    count = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    ends = Counter[str]()
    with tempfile.TemporaryDirectory() as folder, browser() as chrome:
        database = f"{folder}/designs.sqlite"
        server = Process("--no-open", "--workers", "1", "--database", database)
        visitor = Visitor(chrome, server.address)
        page = visitor.open("drive", unfold=False)
        for seed, document in failing(count):
            end, presses, said = pressed(visitor, page, document)
            ends[end] += 1
            if end != "OK" or len(presses) > 1:
                print(f"{seed}: {end} after {presses}: {said}", flush=True)
        visitor.close()
        server.kill()
        print(*visitor.wrong, sep="\n")
    for end, number in ends.most_common():
        print(f"{number:5} {end}")


if __name__ == "__main__":
    main()
