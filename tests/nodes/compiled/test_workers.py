"""A callback for which the program has no thread waits for one, and gets it however early or late it comes."""

from __future__ import annotations

import threading

import pytest

from coursekit.nodes.compiled.channel import Gone
from coursekit.nodes.compiled.workers import Workers
from coursekit.processes.session import Session


class Thread:
    """Stands for a thread of the program, with a number."""

    def __init__(self, number):
        self.number = number

    def begin_worker(self):
        pass

    def close(self):
        pass


class Control:
    """Stands for the connection by which threads are asked for: each comes at once, in a thread of its own."""

    def __init__(self, come):
        self.come, self.asked = come, 0

    def sendall(self, _wish):
        self.asked += 1
        threading.Thread(target=self.come, args=(Thread(self.asked),)).start()

    def close(self):
        pass


@pytest.fixture
def workers():
    with (session := Session(virtual=False)).use():
        yield Workers(session.clock, lambda: pytest.fail("nobody waits on the wall clock like that"))


def test_none_that_comes_early_is_missed(workers):
    workers.ask_by(Control(workers.welcome))
    assert [workers.take().number for _ in range(300)] == list(range(1, 301))
    assert workers._idle == [] and workers._wishes == []


def test_several_callbacks_get_one_each(workers):
    workers.ask_by(Control(workers.welcome))
    got = []
    threads = [threading.Thread(target=lambda: got.append(workers.take().number)) for _ in range(30)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(got) == list(range(1, 31))


def test_the_end_of_the_program_ends_the_wait(workers):
    workers.ask_by(Control(lambda _thread: workers.end()))
    with pytest.raises(Gone):
        workers.take()
    with pytest.raises(Gone):
        workers.take()  # nor does a later one wait
