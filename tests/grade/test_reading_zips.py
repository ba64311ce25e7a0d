"""Zips of strangers: their paths lead nowhere, their sizes have bounds, and what is no zip is said to be none."""

import io
import time

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as some

from coursekit.grade.archives import Archive, BadArchive, Bounds, parts_of

from .handed import TOPICS, zipped

PATHS = [
    "/etc/passwd",
    "../../x",
    "C:\\Windows\\x.ipynb",
    "a/../../b",
    "\\\\host\\share\\x",
    "./././x",
    "a//b",
    "..",
    "",
    "C:",
    "C:/",
]


@pytest.mark.parametrize("path", PATHS)
def test_paths_in_zips_lead_nowhere(path):
    parts = parts_of(path)
    assert parts and not {"", ".", ".."} & set(parts) and not any("/" in part or "\\" in part for part in parts)


def test_only_what_may_be_is_read_of_a_zip():
    data = zipped({"a": b"x" * 1000, "b": b"y" * 1000})
    for bounds in (Bounds(members=1), Bounds(directory=10)):
        with pytest.raises(BadArchive, match="holds more than"):
            Archive(io.BytesIO(data), bounds)
    with Archive(io.BytesIO(data), Bounds(file=1200, total=1500)) as opened:
        first, second = opened.members()
        assert len(opened.read(first)) == 1000
        with pytest.raises(BadArchive, match="unpacks to more than"):
            opened.read(second)


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(some.binary(max_size=3000), some.integers(0, 3000), some.integers(0, 255))
@example(b"", 609, 0)  # a file without a name
def test_bytes_that_are_no_zip_are_a_bad_archive(noise, place, value):
    data = bytearray(zipped({TOPICS: b"{}" * 50, "b/c.txt": b"x"}))
    data[place % len(data)] = value
    for content in (noise, bytes(data), bytes(data) + noise[:40], noise[:40] + bytes(data)):
        try:
            with Archive(io.BytesIO(content)) as opened:
                for member in opened.members():
                    assert member.when >= 0 and len(opened.read(member)) == member.size
        except BadArchive as error:
            assert str(error)


def test_a_zip_s_times_may_be_nonsense():
    data = zipped({TOPICS: b"{}"})
    for stamp in (b"\xff\xff\xff\xff", b"\0\0\0\0"):
        place = data.index(b"PK\1\2") + 12
        with Archive(io.BytesIO(data[:place] + stamp + data[place + 4 :])) as opened:
            (member,) = opened.members()
            assert 0 <= member.when < time.time() + 10**11
