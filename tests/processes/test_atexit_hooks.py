"""What a process says last."""

import atexit
import os
import sys
import tempfile
import weakref

from coursekit.processes import atexit_hooks
from coursekit.processes.session import Session


def said_by(main) -> str:
    with Session(virtual=True).use() as session:
        process = session.start(main, name="speaker")
        process.wait()
        return process.output


def test_what_a_process_registers_runs_when_it_ends_the_last_first() -> None:
    def main() -> None:
        atexit.register(print, "first", end=".\n")
        atexit.register(print, "second")
        print("works")

    assert said_by(main) == "works\nsecond\nfirst.\n"


def test_it_runs_after_an_error_and_after_sys_exit_too() -> None:
    def fail() -> None:
        atexit.register(print, "stop the motors")
        raise ValueError("dizzy")

    def leave() -> None:
        atexit.register(print, "stop the motors")
        sys.exit(3)

    assert said_by(fail).endswith("ValueError: dizzy\nstop the motors\n")
    assert said_by(leave) == "stop the motors\n"


def test_what_is_taken_back_does_not_run() -> None:
    def main() -> None:
        atexit.register(print, "gone")
        atexit.unregister(print)

    assert said_by(main) == ""


def test_a_killed_process_says_nothing() -> None:
    with Session(virtual=True).use() as session:
        def main() -> None:
            atexit.register(print, "stop the motors")
            session.clock.sleep(10.0)

        process = session.start(main, name="speaker")
        session.clock.sleep(1.0)
        process.kill()
        process.wait()
        assert process.output == ""


def test_what_a_library_registers_is_the_interpreter_s(monkeypatch) -> None:
    kept: list[object] = []
    monkeypatch.setattr(atexit_hooks, "_register", kept.append)
    code = compile("atexit.register(print)", "library", "exec")
    library = {"atexit": atexit, "__file__": tempfile.__file__}
    assert said_by(lambda: exec(code, library)) == ""
    assert kept == [print]


def test_finalizers_of_others_outlive_a_process() -> None:
    with tempfile.TemporaryDirectory() as folder:
        said_by(lambda: weakref.finalize(main_thread_thing, print))
        assert os.path.isdir(folder)
    assert not os.path.isdir(folder)


def main_thread_thing() -> None:
    """Something that can be referred to weakly."""
