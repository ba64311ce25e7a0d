"""A command's output is UTF-8, also where the code page has no such letters."""

import errno
import io
import sys

import pytest

from coursekit.systems import operating_system, streams


def pipe(monkeypatch):
    """Set standard output as Windows opens it for a pipe: with its code page."""
    raw = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(raw, "cp1252"))
    monkeypatch.setattr(sys, "stderr", io.TextIOWrapper(io.BytesIO(), "cp1252"))
    return raw


def test_on_windows_a_piped_command_writes_utf8(monkeypatch):
    raw = pipe(monkeypatch)
    with pytest.raises(UnicodeEncodeError):
        print("✓", flush=True)
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    streams.use_utf8()
    print("✓ ñ", flush=True)
    assert raw.getvalue().decode().splitlines() == ["✓ ñ"]


def test_elsewhere_streams_stay_as_the_user_set_them(monkeypatch):
    pipe(monkeypatch)
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    streams.use_utf8()
    assert sys.stdout.encoding == "cp1252"


def test_streams_of_another_kind_are_left_alone(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    monkeypatch.setattr(sys, "stdout", io.StringIO())
    streams.use_utf8()
    assert isinstance(sys.stdout, io.StringIO)


@pytest.mark.parametrize(("windows", "gone"), [(True, True), (False, False)])
def test_windows_says_in_other_words_that_nobody_reads_any_more(monkeypatch, windows, gone):
    monkeypatch.setattr(operating_system, "WINDOWS", windows)
    assert streams.reader_has_gone(OSError(errno.EINVAL, "Invalid argument")) == gone
    assert streams.reader_has_gone(BrokenPipeError(errno.EPIPE, "Broken pipe"))
    assert not streams.reader_has_gone(OSError(errno.EINVAL, "Invalid argument", "a?.yaml"))
    assert not streams.reader_has_gone(FileNotFoundError(errno.ENOENT, "No such file or directory"))
