"""A callback for which the program has no thread waits for one, and gets it however early or late it comes."""

from __future__ import annotations

import threading

import pytest

from coursekit.nodes.compiled.channel import Gone
from coursekit.nodes.compiled.host import Host
from coursekit.processes.session import Session


class Control:
    """Stands for the connection by which threads are asked for: each comes at once, in a thread of its own."""

    def __init__(self, host, come):
        self.host, self.come, self.asked = host, come, 0

    def sendall(self, _wish):
        self.asked += 1
        threading.Thread(target=self.come, args=(self.asked,)).start()

    def close(self):
        pass


@pytest.fixture
def host():
    with (session := Session(virtual=False)).use():
        made = object.__new__(Host)
        made.clock, made._lock = session.clock, threading.Lock()
        made._idle, made._wishes, made._workers = [], [], []
        yield made


def test_none_that_comes_early_is_missed(host):
    host._control = Control(host, host._give)
    assert [host._worker() for _ in range(300)] == list(range(1, 301))
    assert host._idle == [] and host._wishes == []


def test_several_callbacks_get_one_each(host):
    host._control = Control(host, host._give)
    got = []
    threads = [threading.Thread(target=lambda: got.append(host._worker())) for _ in range(30)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(got) == list(range(1, 31))


def test_the_end_of_the_program_ends_the_wait(host):
    host._control = Control(host, lambda _number: host._forget())
    with pytest.raises(Gone):
        host._worker()
    with pytest.raises(Gone):
        host._worker()  # nor does a later one wait
