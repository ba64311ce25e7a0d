"""A program that wants keys gets each as it is typed, in a real terminal."""

import os
import select
import subprocess
import sys
import time

import pytest

fcntl = pytest.importorskip("fcntl")
pty = pytest.importorskip("pty")
termios = pytest.importorskip("termios")

ROS2 = [sys.executable, "-m", "coursekit.cli.ros2"]


@pytest.fixture
def terminal(tmp_path):
    """terminal(words) runs a command in a terminal of its own: (process, the terminal's other end)."""
    env = {**os.environ, "COURSEKIT_RUNTIME_DIR": str(tmp_path), "ROS_DOMAIN_ID": "77"}
    started = []

    def start(*words, **variables):
        ours, theirs = pty.openpty()
        process = subprocess.Popen(
            [*ROS2, *words],
            env=env | variables,
            stdin=theirs,
            stdout=theirs,
            stderr=theirs,
            start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(theirs, termios.TIOCSCTTY, 0),
        )
        started.append((process, ours, theirs))
        return process, ours

    yield start
    for process, ours, theirs in started:
        process.kill()
        process.wait()
        os.close(ours)
        os.close(theirs)


def read_until(number, text, patience=30.0):
    seen = ""
    give_up = time.monotonic() + patience
    while text not in seen and (left := give_up - time.monotonic()) > 0:
        if select.select([number], [], [], left)[0]:
            seen += os.read(number, 4096).decode(errors="replace")
    return seen


def press_until(number, key, text):
    """Press a key, and again where it was lost: `tty.setraw` discards what was typed just before, on a robot too."""
    for _ in range(10):
        os.write(number, key)
        if text in (seen := read_until(number, text, patience=3.0)):
            return
    raise AssertionError(f"{key!r} was typed, and {text!r} never came: {seen}")


@pytest.mark.slow
def test_a_key_needs_no_enter_and_the_terminal_is_as_before_afterwards(terminal):
    process, keyboard = terminal("run", "turtlesim", "turtle_teleop_key")
    before = termios.tcgetattr(keyboard)
    assert "'Q' to quit." in read_until(keyboard, "'Q' to quit.")
    give_up = time.monotonic() + 10
    while termios.tcgetattr(keyboard)[3] & termios.ICANON and time.monotonic() < give_up:
        pass
    os.write(keyboard, b"\x1b[A")
    os.write(keyboard, b"q")
    assert process.wait(20) == 0
    assert termios.tcgetattr(keyboard) == before


TELEOP = """
import select, sys, termios, tty
settings = termios.tcgetattr(sys.stdin)
print("ready")
key = ""
while key != "q":
    tty.setraw(sys.stdin.fileno())
    ready, _, _ = select.select([sys.stdin], [], [], 0.1)
    key = sys.stdin.read(1) if ready else ""
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
    if key:
        print("got", repr(key))
"""


@pytest.mark.slow
def test_a_program_of_ones_own_reads_keys_with_termios(terminal, tmp_path):
    program = tmp_path / "lib" / "my_teleop" / "teleop"
    program.parent.mkdir(parents=True)
    program.write_text("#!/usr/bin/env python3\n" + TELEOP)
    program.chmod(0o755)
    index = tmp_path / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "my_teleop").touch()
    process, keyboard = terminal("run", "my_teleop", "teleop", AMENT_PREFIX_PATH=str(tmp_path))
    before = termios.tcgetattr(keyboard)
    read_until(keyboard, "ready")
    give_up = time.monotonic() + 10
    while termios.tcgetattr(keyboard)[3] & termios.ICANON and time.monotonic() < give_up:
        pass
    press_until(keyboard, b"w", "got 'w'")
    press_until(keyboard, b"q", "got 'q'")
    assert process.wait(20) == 0
    assert termios.tcgetattr(keyboard) == before
