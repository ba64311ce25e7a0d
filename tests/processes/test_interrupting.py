"""Signals reach a program as the system would deliver them, and break nothing that other threads need."""

import contextlib
import contextvars
import signal
import subprocess
import sys
import threading
import time

import pytest

from coursekit.processes.process import current_process
from coursekit.processes.session import Session
from tests.processes.programs import run

PROGRAM = """
import _imp, importlib, threading
from coursekit.processes.interrupting import raise_in_thread

class Stop(BaseException):
    pass

def work(begun):
    try:
        begun.set()
        while True:
            %s
    except Stop:
        pass

for _ in range(30):
    begun = threading.Event()
    thread = threading.Thread(target=work, args=[begun])
    thread.start()
    begun.wait()
    while not raise_in_thread(thread.ident, Stop):
        pass
    thread.join()
    assert not _imp.lock_held()
import colorsys
print("imports go on")
"""


@pytest.mark.parametrize("importing", ["_find_spec('sys', None)", "_get_module_lock('x')"])
def test_the_import_lock_is_free_after_an_import_was_interrupted(importing):
    program = PROGRAM % f"importlib._bootstrap.{importing}; sum(range(50))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, encoding="utf-8", timeout=60, check=False)
    assert done.stdout == "imports go on\n", done.stderr


def test_ctrl_c_ends_a_sleep_with_a_keyboard_interrupt(session):
    def main():
        try:
            time.sleep(1000)
        except KeyboardInterrupt:
            print("interrupted")

    process = session.start(main, name="sleeper")
    session.clock.sleep(0.01)
    process.interrupt()
    assert process.wait(10) == 0 and process.output == "interrupted\n"


def test_ctrl_c_that_is_not_caught_ends_it_like_signal_2(session):
    process = session.start(lambda: time.sleep(1000), name="sleeper")
    session.clock.sleep(0.01)
    process.interrupt()
    assert process.wait(10) == -2
    assert process.output.endswith("KeyboardInterrupt\n")


def test_ending_one_does_not_end_another(session):
    one = session.start(lambda: time.sleep(1000), name="one")
    other = session.start(lambda: time.sleep(1000), name="other")
    session.clock.sleep(0.01)
    one.kill()
    assert one.wait(10) == -9 and other.state == "running"


def test_terminate_ends_it_like_signal_15(session):
    process = session.start(lambda: time.sleep(1000), name="sleeper")
    session.clock.sleep(0.01)
    process.terminate()
    assert process.wait(10) == -signal.SIGTERM


def test_a_program_may_handle_its_signals_itself(session):
    def main():
        caught = []
        signal.signal(signal.SIGINT, lambda number, frame: caught.append(number))
        while not caught:
            time.sleep(0.01)
        print("caught", caught, signal.getsignal(signal.SIGTERM) == signal.SIG_DFL)

    process = session.start(main, name="handler")
    session.clock.sleep(0.05)
    process.interrupt()
    assert process.wait(10) == 0 and process.output == "caught [2] True\n"
    assert signal.getsignal(signal.SIGINT) is not None


def test_killing_ends_a_program_that_swallows_ctrl_c(session):
    refused = session.clock.new_event()

    def main():
        while True:
            try:
                time.sleep(1000)
            except KeyboardInterrupt:
                print("no")
                refused.set()

    process = session.start(main, name="stubborn")
    session.clock.sleep(0.01)
    process.interrupt()
    refused.wait()
    assert process.state == "running" and process.output == "no\n"
    process.kill()
    assert process.wait(10) == -9 and not process.abandoned


def test_busy_code_is_interrupted_on_the_wall_clock():
    with Session().use() as session:

        def main():
            while True:
                pass

        process = session.start(main, name="busy")
        process.interrupt()
        assert process.wait(10) == -2


def test_what_a_busy_programs_handler_prints_and_raises_is_the_programs():
    with Session().use() as session:
        ready = session.clock.new_event()

        def main():
            def end(number, _frame):
                print("caught", number, current_process().name)
                sys.exit("at once")

            signal.signal(signal.SIGTERM, end)
            ready.set()
            while True:
                pass

        process = session.start(main, name="busy")
        assert ready.wait(10)
        process.terminate()
        assert process.wait(10) == 1
        assert process.output == "caught 15 busy\nat once\n"


def test_a_slow_handler_of_a_busy_program_keeps_no_other_waiting():
    with Session().use() as session:
        ready, handling, go_on = (session.clock.new_event() for _ in range(3))

        def main():
            signal.signal(signal.SIGINT, lambda *_: (handling.set(), go_on.wait(10)))
            ready.set()
            while not go_on.is_set():
                pass

        busy = session.start(main, name="busy")
        assert ready.wait(10)
        busy.interrupt()
        assert handling.wait(10)
        sleeper = session.start(lambda: time.sleep(0.01), name="sleeper")
        rung = session.clock.new_event()
        session.clock.call_at(session.clock.steady(), rung.set)
        assert rung.wait(5) and sleeper.wait(5) == 0
        go_on.set()
        assert busy.wait(10) == 0


def test_a_ctrl_c_that_comes_after_the_end_hits_no_thread_that_took_its_number():
    with Session().use() as session:
        _, process = run(session, lambda: None)
        process._main_context.post(lambda: process._receive(signal.SIGINT))  # it was pressed twice
        process._main_context.ident = threading.get_ident()  # as a later thread's may be
        contextvars.copy_context().run(process._reach_busy, process._main_context)
        assert sum(range(1000)) == 499500  # a KeyboardInterrupt would come at one of these steps


def test_what_cannot_be_stopped_is_cut_off_and_said_to_be():
    release, began = threading.Lock(), threading.Event()
    release.acquire()

    def wait_for_ever():
        while True:
            with contextlib.suppress(BaseException):  # the kill may come before the lock is asked for
                began.set()
                release.acquire()
                return

    with Session().use() as session:
        process = session.start(wait_for_ever, name="stuck")
        assert began.wait(10)
        process.kill()
        assert process.wait(10) == -9 and process.abandoned
        assert "process stuck" in process.output and "does not answer" in process.output
    release.release()


def test_a_signal_whose_handler_returns_does_not_shorten_a_sleep(session):
    def sleeper():
        signal.signal(signal.SIGINT, lambda *_: print("handled", end=" "))
        before = session.clock.steady()
        time.sleep(0.4)
        print(session.clock.steady() - before >= 400_000_000)

    process = session.start(sleeper, name="sleeper")
    session.clock.sleep(0.1)
    process.interrupt()
    assert process.wait(10) == 0 and process.output == "handled True\n"


def test_an_exception_reaches_a_program_that_has_begun_to_wait():
    """It was too busy to be asked, and waits for good when the exception comes."""
    with Session().use() as session:
        process = session.start(lambda: session.clock.new_event().wait(), name="waits")
        while (context := process._main_context) is None or context.blocked_on is None:
            session.clock.sleep(0.01)
        process._raise(context, KeyboardInterrupt)
        assert process.wait(10.0) is not None
