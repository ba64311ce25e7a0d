"""Programs that read single keys, as every teleop node does: termios, tty and select on a process's standard input."""

import pytest

from coursekit.processes.session import Session

pytest.importorskip("termios")


def teleop():
    """The loop of a teleop program: raw while it waits a moment for a key, as before in between."""
    import select
    import sys
    import termios
    import tty

    settings = termios.tcgetattr(sys.stdin)
    input()
    key = ""
    while key != "\x03":
        tty.setraw(sys.stdin.fileno())
        ready, _, _ = select.select([sys.stdin], [], [], 0.1)
        key = sys.stdin.read(1) if ready else ""
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
        if key:
            print(repr(key), end=" ")
    print("bye")


@pytest.mark.parametrize("virtual", [True, False])
def test_keys_come_one_by_one_and_ctrl_c_is_a_key(virtual):
    with Session(virtual=virtual).use() as session:
        asked = []
        process = session.start(teleop, name="teleop")
        process.on_wants_keys = lambda: asked.append(True)
        process.write_stdin("\n")
        session.clock.sleep(0.25)
        process.write_stdin("w")
        session.clock.sleep(0.25)
        process.write_stdin("xy")
        session.clock.sleep(0.45)
        process.interrupt()
        assert process.wait(5) == 0
        assert process.output == "'w' 'x' 'y' '\\x03' bye\n"
        assert asked == [True]


def test_a_second_ctrl_c_ends_a_program_that_does_not_look_for_the_key():
    def deaf():
        import sys
        import time
        import tty

        tty.setraw(sys.stdin)
        time.sleep(100)

    with Session(virtual=True).use() as session:
        process = session.start(deaf, name="deaf")
        session.clock.sleep(1)
        process.interrupt()
        assert process.wait(1) is None
        process.interrupt()
        assert process.wait(1) is not None


def test_a_program_that_only_looks_at_the_settings_gets_whole_lines():
    def ask():
        import sys
        import termios

        settings = termios.tcgetattr(sys.stdin)
        word = input("name: ")
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
        print("hello", word, sys.stdin.fileno())

    with Session(virtual=True).use() as session:
        asked = []
        process = session.start(ask, name="ask")
        process.on_wants_keys = lambda: asked.append(True)
        process.write_stdin("Ann\n")
        assert process.wait(5) == 0 and process.output == "name: hello Ann 0\n" and asked == []


def test_select_waits_by_the_session_clock_and_leaves_real_files_alone():
    import os
    import select

    def wait():
        import select
        import sys

        print(select.select([sys.stdin.fileno()], [], [], 2.0), select.select([], [], [], 1.0))

    with Session(virtual=True).use() as session:
        process = session.start(wait, name="wait")
        assert process.wait(2.9) is None and process.wait(0.2) == 0
        assert process.output == "([], [], []) ([], [], [])\n"
    read, write = os.pipe()
    os.write(write, b"x")
    assert select.select([read], [], [], 0) == ([read], [], [])


def test_a_program_that_does_not_want_to_wait_reads_what_is_there():
    def look():
        import fcntl
        import os
        import sys
        import time

        flags = fcntl.fcntl(sys.stdin.fileno(), fcntl.F_GETFL)
        fcntl.fcntl(sys.stdin, fcntl.F_SETFL, flags | os.O_NONBLOCK)
        print(repr(sys.stdin.read(1)), bool(fcntl.fcntl(0, fcntl.F_GETFL) & os.O_NONBLOCK))
        time.sleep(1.0)
        print(repr(sys.stdin.read()))
        fcntl.fcntl(sys.stdin, fcntl.F_SETFL, flags)
        print(input())

    with Session(virtual=True).use() as session:
        process = session.start(look, name="look")
        session.clock.sleep(0.5)
        process.write_stdin("\x1b[A")
        session.clock.sleep(1.0)
        process.write_stdin("line\n")
        assert process.wait(5) == 0 and process.output == "'' True\n'\\x1b[A'\nline\n"
