"""Whatever is in a machine file, the answer is a record or sentences: nothing else is raised."""

import random
from collections.abc import Callable

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from shear_test.virtual import rubber
from wraparc.errors import InputError
from wraparc.shear_test import (
    DIALECTS,
    Choices,
    Sample,
    VirtualRig,
    read_machine_bytes,
    reduce_record,
    run_virtual_test,
)

TEST = run_virtual_test(VirtualRig(law=rubber(), points=160, wander=0.01), 207e3, 2)
FILES = [(d.write(TEST), dict(d.units)) for d in DIALECTS.values()]
SWAPS = [(b",", b";"), (b".", b","), (b",", b"."), (b"\n", b"\r"), (b'"', b""), (b"\t", b" "),
         (b";", b"\t"), (b"mm", b"mN"), (b"N", b"Q"), (b"0", b"")]  # fmt: skip
WORDS = [b"nan", b"1e999", b"_1", b"--", b"inf", b"0x1", b"1 "]


def cut(data: bytes, rng: random.Random) -> bytes:
    return data[: rng.randrange(len(data))]


def behead(data: bytes, rng: random.Random) -> bytes:
    return data[rng.randrange(len(data)) :]


def flip(data: bytes, rng: random.Random) -> bytes:
    changed = bytearray(data)
    for _ in range(rng.randrange(1, 30)):
        changed[rng.randrange(len(changed))] = rng.randrange(256)
    return bytes(changed)


def remove(data: bytes, rng: random.Random) -> bytes:
    start = rng.randrange(len(data))
    return data[:start] + data[start + rng.randrange(200) :]


def insert(data: bytes, rng: random.Random) -> bytes:
    place = rng.randrange(len(data))
    return data[:place] + rng.randbytes(rng.randrange(50)) + data[place:]


def swap(data: bytes, rng: random.Random) -> bytes:
    return data.replace(*rng.choice(SWAPS))


def shuffle(data: bytes, rng: random.Random) -> bytes:
    lines = data.split(b"\n")
    rng.shuffle(lines)
    return b"\n".join(lines)


def spoil(data: bytes, rng: random.Random) -> bytes:
    return data.replace(b"1", rng.choice(WORDS), rng.randrange(1, 40))


MUTATIONS: list[Callable[[bytes, random.Random], bytes]] = [
    cut, behead, flip, remove, insert, swap, shuffle, spoil,
]  # fmt: skip


def use(data: bytes, choices: Choices) -> None:
    try:
        record = read_machine_bytes(data, "fuzz", choices)
    except InputError:
        return
    assert np.isfinite(record.travel).all()
    assert np.isfinite(record.force).all()
    assert len(record.travel) == len(record.force) == len(record.lines)
    try:
        reduce_record(record, Sample(area=0.04, normal_force=8000.0))
    except InputError:
        return


@settings(max_examples=100, suppress_health_check=[HealthCheck.too_slow])
@given(st.integers(0, 2**32), st.sampled_from(FILES), st.integers(1, 3))
def test_mutated_files(seed: int, file: tuple[bytes, dict[str, str]], times: int) -> None:
    rng = random.Random(seed)  # noqa: S311 - mutations, not secrets
    data, units = file
    for _ in range(times):
        data = rng.choice(MUTATIONS)(data, rng) if data else data
    use(data, Choices(units=units))


@settings(max_examples=75)
@given(
    st.binary(max_size=400)
    | st.text("0123456789.,;:-+eE \t\n\"'mNk()", max_size=400).map(str.encode)
)
def test_any_bytes(data: bytes) -> None:
    use(data, Choices())


@settings(max_examples=50)
@given(
    st.sampled_from(FILES),
    st.text(max_size=8) | st.integers(-3, 20),
    st.text(max_size=5),
    st.sampled_from([None, "utf-8", "utf-16", "cp437", "nonsense", "\0"]),
    st.sampled_from([None, "tab", "comma", "x", ""]),
)
def test_any_choices(
    file: tuple[bytes, dict[str, str]],
    column: str | int,
    unit: str,
    encoding: str | None,
    delimiter: str | None,
) -> None:
    choices = Choices(
        travel=column,
        units={"Load": unit, str(column): unit},
        encoding=encoding,
        delimiter=delimiter,
    )
    use(file[0], choices)
