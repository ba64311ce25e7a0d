"""A process that runs asyncio keeps the session's time, and a Ctrl-C ends it."""

import asyncio
import selectors

import pytest

from coursekit.processes.session import Session
from tests.needs import posix


async def greet(seconds):
    await asyncio.sleep(seconds)
    print("slept")


def say_after(clock, seconds):
    clock.sleep(seconds)
    print("in between")


def test_asyncio_sleeps_on_the_virtual_clock_while_others_go_on():
    with Session(virtual=True).use() as session:
        sleeper = session.start(lambda: asyncio.run(greet(6.0)), name="sleeper")
        other = session.start(lambda: say_after(session.clock, 3.0), name="other")
        session.clock.sleep(5.9)
        assert (sleeper.output, other.output) == ("", "in between\n")
        assert sleeper.wait(0.2) == 0 and sleeper.output == "slept\n"


def test_a_task_of_another_thread_wakes_the_loop():
    async def wait_for_it():
        loop, done = asyncio.get_running_loop(), asyncio.Event()
        here.append((loop, done))
        await done.wait()
        print("woken")

    here = []
    with Session(virtual=True).use() as session:
        waiter = session.start(lambda: asyncio.run(wait_for_it()), name="waiter")
        session.clock.sleep(1.0)
        loop, done = here[0]
        loop.call_soon_threadsafe(done.set)
        assert waiter.wait(1.0) == 0 and waiter.output == "woken\n"


@pytest.mark.parametrize("virtual", [True, False])
def test_ctrl_c_ends_a_loop_that_waits(virtual):
    with Session(virtual=virtual).use() as session:
        started = session.clock.new_event()

        async def forever():
            started.set()
            await asyncio.sleep(3600.0)

        process = session.start(lambda: asyncio.run(forever()), name="forever")
        assert started.wait(30)
        process.interrupt()
        assert process.wait(30) == -2
        assert "KeyboardInterrupt" in process.output


@posix("a selector of no sockets is refused")
def test_outside_of_processes_waiting_is_as_it_was():
    with Session(virtual=True).use() as session:
        before = session.clock.steady()
        assert selectors.DefaultSelector().select(0.01) == []
        assert session.clock.steady() == before
