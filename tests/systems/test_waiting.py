"""Waits of the main thread: on Windows in slices, so that a Ctrl-C is seen between them; lines of a socket come whole."""

import socket
import threading

import pytest

from coursekit.core.clock import WallClock
from coursekit.core.virtual_clock import VirtualClock
from coursekit.systems import operating_system, waiting


class Lock:
    """Lets itself be taken at the asked attempt; notes how long each one waits."""

    def __init__(self, opens_at):
        self.opens_at = opens_at
        self.waits = []

    def acquire(self, timeout=-1):
        self.waits.append(timeout)
        return len(self.waits) >= self.opens_at


@pytest.fixture
def windows(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)


def test_on_windows_no_wait_of_the_main_thread_is_longer_than_a_slice(windows):
    lock = Lock(opens_at=4)
    assert waiting.acquire(lock)
    assert lock.waits == [waiting.SLICE] * 4


def test_on_windows_a_wait_ends_at_its_time(windows, monkeypatch):
    times = iter([0.0, 0.0, 0.1, 0.2])
    monkeypatch.setattr(waiting, "_now", lambda: next(times))
    lock = Lock(opens_at=99)
    assert not waiting.acquire(lock, 0.25)
    assert lock.waits == pytest.approx([0.1, 0.1, 0.05])


def test_a_thread_that_gets_no_ctrl_c_waits_in_one_go(windows):
    lock = Lock(opens_at=1)
    thread = threading.Thread(target=waiting.acquire, args=(lock,))
    thread.start()
    thread.join()
    assert lock.waits == [-1]


def test_both_clocks_wait_through_this_room(windows, monkeypatch):
    waits = []

    def taken(lock, seconds=None):
        waits.append(seconds)
        return True

    monkeypatch.setattr(waiting, "acquire", taken)
    assert WallClock().new_waiter().wait()
    assert VirtualClock()._wait_outside(None)
    assert waits == [None, None]


def test_lines_come_whole_however_they_are_cut(windows):
    here, there = socket.socketpair()
    with here, there:
        text = "é one\ntwo\n".encode()
        here.sendall(text[:1])
        got = waiting.lines(there)
        here.sendall(text[1:])
        assert [next(got), next(got)] == ["é one", "two"]
