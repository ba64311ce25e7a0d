"""Real programs as children of a session: what they write, what they are told, and how time passes meanwhile."""

import sys

import pytest

from coursekit.processes.child import ChildProcess
from coursekit.processes.session import Session
from tests.needs import posix

shell_program = posix("a program of /bin/sh is none")


@pytest.fixture
def program(tmp_path):
    """A way to make programs."""

    def add(name, text):
        path = tmp_path / name
        path.write_text(text)
        path.chmod(0o755)
        return path

    return add


@shell_program
def test_other_programs_run_as_children_with_their_output_and_exit_code(program, session):
    path = program("shell", "#!/bin/sh\necho out $1\necho err >&2\nexit 3\n")
    process = session.start_executable(path, ["word"])
    assert process.wait(20) == 3
    assert process.out.text("stdout") == "out word\n" and process.out.text("stderr") == "err\n"


@shell_program
def test_a_child_can_be_typed_to_and_interrupted(program, session):
    process = session.start_executable(program("cat", "#!/bin/sh\nread line; echo got $line; exec sleep 1000\n"))
    heard = session.clock.new_event()
    process.on_output(lambda _stream, _text: heard.set())
    process.write_stdin("hello\n")
    assert heard.wait(20) and process.output == "got hello\n"
    process.interrupt()
    assert process.wait(20) == -2


@shell_program
def test_time_stands_still_until_all_know_that_a_child_has_ended(program):
    path = program("short", "#!/bin/sh\nread line\n")
    with Session(virtual=True).use() as session:
        child = session.launch(ChildProcess(session, [str(path)], name="short", takes_time=False))
        frozen, tell = [], child._ended.set
        child._ended.set = lambda: (frozen.append(session.clock.frozen), tell())
        child.on_exit(lambda _: frozen.append(session.clock.frozen))
        child.close_stdin()
        child.wait()
    assert frozen == [1, 1]


@shell_program
def test_a_child_that_takes_no_time_stops_the_virtual_clock_while_it_lives(program):
    path = program("slow", "#!/bin/sh\nsleep 0.3\n")
    with Session(virtual=True).use() as session:
        ticks = []

        def tick():
            while True:
                session.clock.sleep(0.001)
                ticks.append(1)

        session.start(tick, name="ticker")
        child = session.launch(ChildProcess(session, [str(path)], name="slow", takes_time=False))
        child.wait()
        assert len(ticks) == 0
        session.clock.sleep(0.0105)
        assert len(ticks) == 10


@shell_program
def test_time_passes_for_a_process_that_waits_beside_a_child_that_writes(program):
    path = program("slow", "#!/bin/sh\nfor i in 1 2 3 4 5 6 7 8 9; do echo $i; sleep 0.2; done\n")
    with Session(virtual=True).use() as session:
        child = session.launch(ChildProcess(session, [str(path)], name="slow"))
        ended = []

        def main():
            woken = session.clock.new_event()
            child.on_output(lambda _stream, _text: woken.set())
            give_up = session.clock.steady() + 500_000_000
            while session.clock.steady() < give_up:
                woken.wait(0.3)
                woken.clear()
            ended.append(child.exit_code)

        assert session.start(main, name="waiting").wait(10) == 0
        assert ended == [None], "the child still lives"
        child.kill()
        child.wait()


def test_errors_of_a_child_stand_where_it_wrote_them(tmp_path):
    code = "import sys\nfor i in range(300): print(i, file=(sys.stdout, sys.stderr)[i % 2], flush=True)"
    with Session(virtual=True).use() as session:
        child = session.launch(ChildProcess(session, [sys.executable, "-c", code], name="both", one_stream=True))
        assert child.wait(60) == 0
        assert child.output == "".join(f"{i}\n" for i in range(300))
