"""A pipe is waited for: with select where it knows pipes, else by looking into it."""

import os
import socket
import subprocess
import sys

import pytest

from coursekit.joined.pipe import Broken, Pipe
from coursekit.systems import operating_system, pipes


@pytest.fixture
def windows(monkeypatch):
    """Windows, where select refuses pipes; elsewhere a pipe is looked into by the system's own means."""
    looks = []
    peek, select = pipes.peek if operating_system.WINDOWS else None, pipes._select

    def look(pipe):
        looks.append(pipe)
        return peek(pipe) if peek is not None else bool(select([pipe], [], [], 0)[0])

    def refuse(*_):
        raise OSError(10038, "An operation was attempted on something that is not a socket")

    monkeypatch.setattr(operating_system, "WINDOWS", True)
    monkeypatch.setattr(pipes, "peek", look)
    monkeypatch.setattr(pipes, "_select", refuse)
    monkeypatch.setattr("select.select", refuse)
    return looks


def test_on_windows_a_frame_is_received_without_select(windows):
    there, back = os.pipe(), os.pipe()
    ours, theirs = Pipe(back[0], there[1]), Pipe(there[0], back[1])
    ours.send({"now": 5}, b"cdr")
    assert theirs.receive(1.0) == ({"now": 5}, b"cdr")
    assert windows


def test_on_windows_nobodys_silence_is_waited_for_longer_than_was_said(windows):
    read, write = os.pipe()
    with pytest.raises(Broken, match="it did not answer in time"):
        Pipe(read, write).receive(0.0)


def test_on_windows_the_end_is_seen_at_once(windows):
    read, write = os.pipe()
    os.close(write)
    with pytest.raises(Broken, match="it ended"):
        Pipe(read, read).receive(1.0)


def test_a_pipe_and_a_socket_are_waited_for_together():
    one, other = socket.socketpair()
    read, write = os.pipe()
    with one, other:
        assert pipes.wait_readable([one, read], 0.0) == []
        os.write(write, b"x")
        assert pipes.wait_readable([one, read]) == [read]
        other.send(b"x")
        assert set(pipes.wait_readable([one, read])) == {one, read}
        os.read(read, 1)
        assert pipes.wait_readable([one, read]) == [one]
        os.close(write)
        assert set(pipes.wait_readable([one, read])) == {one, read}  # the end is something, too
    os.close(read)


def test_reading_at_once_tells_nothing_yet_from_the_end():
    read, write = os.pipe()
    pipes.never_wait(read)
    with pytest.raises(BlockingIOError):
        pipes.read_now(read, 10)
    os.write(write, b"\x1a\r\n")
    assert pipes.read_now(read, 10) == b"\x1a\r\n"
    os.close(write)
    assert pipes.read_now(read, 10) == b""
    os.close(read)


LOADING = """
import threading
from coursekit.systems.pipes import wait_for_end
threading.Thread(target=wait_for_end, args=(0,), daemon=True).start()
import scipy.linalg  # Fortran's library looks at its input when it is loaded
print("loaded", flush=True)
"""


@pytest.mark.timeout(120)
def test_who_waits_for_the_end_of_its_input_can_load_libraries_that_look_at_it():
    child = subprocess.Popen(
        [sys.executable, "-c", LOADING], stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8"
    )
    with child:
        assert child.stdout.readline() == "loaded\n"


def test_on_windows_nothing_is_read_from_a_pipe_before_something_came(windows, monkeypatch):
    read, write = os.pipe()
    real, looked = os.read, []
    monkeypatch.setattr(os, "read", lambda pipe, size: looked.append(len(windows)) or real(pipe, size))
    os.write(write, b"keys")
    os.close(write)
    pipes.wait_for_end(read)
    assert looked == [1, 2]
