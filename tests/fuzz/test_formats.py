"""Whatever is done to a file of a stranger, its reader answers, or raises what it says that it raises.

`COURSEKIT_FUZZ=2000 python -m pytest tests/fuzz` tries each format 2000 times; without it, as often as CI has time for.
"""

import os
import tempfile
import warnings
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from .formats import FORMATS

EXAMPLES = int(os.environ.get("COURSEKIT_FUZZ", "100"))
DAMAGES = st.lists(
    st.tuples(st.sampled_from(["bytes", "cut", "end", "piece", "double", "swap", "number"]),
              st.floats(0, 1), st.integers(0, 40),
              st.binary(max_size=12)), min_size=1, max_size=4,
)  # fmt: skip
NUMBERS = (b"-", b"1e309", b"99999999999999999999", b"nan")


def damaged(data, damages, pieces):
    """The bytes after each damage: (way, where as a share of the length, how many bytes, noise)."""
    for way, where, count, noise in damages:
        data = damage(data, way, int(where * len(data)), count, noise, pieces)
    return data


def damage(data, way, at, count, noise, pieces):
    """The bytes with one damage."""
    before, after = data[:at], data[at:]
    if way == "bytes":
        return before + noise + after[len(noise) :]
    if way == "cut":
        return before + after[count:]
    if way == "end":
        return before
    if way == "piece" and pieces:
        return before + pieces[(count + len(noise)) % len(pieces)].encode("utf-8", "surrogatepass") + after
    if way == "double":
        return before + data[max(0, at - 8 * count) :]
    if way == "swap":
        return after[:count] + before + after[count:]
    skipped = next((k for k, byte in enumerate(after) if chr(byte).isdigit()), 0)
    return before + after[:skipped] + NUMBERS[count % 4] + after[skipped:]


def read(format_, data):
    """What a reader makes of these bytes; None where it says that it cannot."""
    with tempfile.TemporaryDirectory(prefix="fuzz-") as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        path = Path(folder, f"stranger{format_.ending}")
        path.write_bytes(data)
        try:
            return format_.read(path)
        except format_.faults() as fault:
            assert str(fault), f"{type(fault).__name__} says nothing"
            assert "Traceback" not in str(fault)
            return None


@pytest.mark.parametrize("format_", FORMATS, ids=[file_format.name for file_format in FORMATS])
def test_a_sound_file_is_read(format_):
    assert read(format_, format_.sound()) is not None


@pytest.mark.parametrize("format_", FORMATS, ids=[file_format.name for file_format in FORMATS])
def test_a_damaged_file_is_read_or_refused(format_):
    @settings(max_examples=EXAMPLES, suppress_health_check=list(HealthCheck), derandomize=EXAMPLES <= 100)
    @given(DAMAGES)
    def try_it(damages):
        read(format_, damaged(format_.sound(), damages, format_.pieces))

    try_it()


@pytest.mark.parametrize("format_", FORMATS, ids=[file_format.name for file_format in FORMATS])
@pytest.mark.parametrize("data", [b"", b"\0", b"\xff\xfe", b"[" * 100_000, b"<a>" * 30_000, b"(" * 50_000, b"a: " * 20_000],
                         ids=["empty", "zero", "no UTF-8", "brackets", "elements", "parentheses", "keys"])  # fmt: skip
def test_nonsense_is_read_or_refused(format_, data):
    read(format_, data)
