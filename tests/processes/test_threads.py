"""What the threading module waits with takes session time, no more and no less."""

from __future__ import annotations

import _thread
import queue
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest

from coursekit.processes.locks import VirtualLock, VirtualRLock
from coursekit.processes.session import Session


def on_condition() -> None:
    condition = threading.Condition()
    with condition:
        assert not condition.wait_for(lambda: False, timeout=3.0)


def on_semaphore() -> None:
    assert not threading.Semaphore(0).acquire(timeout=3.0)


def on_queue() -> None:
    with pytest.raises(queue.Empty):
        queue.Queue().get(timeout=3.0)


def on_event() -> None:
    assert not threading.Event().wait(3.0)


@pytest.mark.parametrize("wait", [on_condition, on_semaphore, on_queue, on_event])
def test_a_wait_in_vain_takes_as_long_as_was_asked_for_on_the_virtual_clock(wait: Callable[[], None]) -> None:
    def main() -> None:
        before = time.monotonic()
        wait()
        print(time.monotonic() - before)

    with Session(virtual=True).use() as session:
        process = session.start(main, name="waiter")
        assert process.wait() == 0 and process.output == "3.0\n"


@pytest.mark.timeout(30)
def test_a_wait_in_vain_ends_whenever_it_begins() -> None:
    """What is left of a wait may be less than a nanosecond, as seconds are floats: time goes on all the same."""

    def main() -> None:
        condition = threading.Condition()
        with condition:
            for _ in range(500):
                time.sleep(0.012345679)
                assert not condition.wait_for(lambda: False, timeout=0.3)

    with Session(virtual=True).use() as session:
        assert session.start(main, name="waiter").wait() == 0


def test_a_compiler_that_measures_its_own_time_takes_none_on_the_virtual_clock() -> None:
    """Else a course that has just been installed, whose loops are not compiled yet, would give other results."""

    def main() -> None:
        import numba

        before = time.monotonic_ns()
        assert numba.njit(lambda x: [x, x + 1])(1)[1] == 2
        print(time.monotonic_ns() - before)

    with Session(virtual=True).use() as session:
        process = session.start(main, name="compiling")
        assert process.wait() == 0 and process.output == "0\n"


def test_a_lock_that_a_real_thread_opens_at_the_worst_moment_is_taken() -> None:
    """The execution context has found it taken, and does not wait yet: nobody is there to be woken."""
    lock = VirtualLock()
    lock.acquire()

    class Waiters(list[Any]):
        def append(self, waiter: Any) -> None:
            done = _thread.allocate_lock()
            done.acquire()
            _thread.start_new_thread(lambda: (lock.release(), done.release()), ())
            done.acquire()
            super().append(waiter)

    lock._waiters = Waiters()
    with Session(virtual=True).use() as session:
        process = session.start(lambda: print(lock.acquire(timeout=5.0), time.monotonic()), name="taker")
        assert process.wait() == 0 and process.output == "True 0.0\n"


def test_a_lock_that_one_may_take_twice_says_whether_it_is_taken_as_python_3_14_asks() -> None:
    lock = VirtualRLock()
    assert not lock.locked()
    with lock, lock:
        assert lock.locked()
    assert not lock.locked()


@pytest.mark.timeout(30)
@pytest.mark.parametrize("virtual", [True, False], ids=["virtual", "wall"])
def test_a_pool_that_is_never_shut_down_does_its_work_and_ends_with_its_program(virtual: bool) -> None:
    """As at the exit of Python; somebody may still refer to it, and its threads wait for more."""
    kept: list[Any] = []

    def main() -> None:
        kept.append(ThreadPoolExecutor(1))
        kept[0].submit(time.sleep, 0.1)
        kept[0].submit(print, "done")

    with Session(virtual=virtual).use() as session:
        process = session.start(main, name="pool")
        assert process.wait(5) == 0 and process.output == "done\n"
