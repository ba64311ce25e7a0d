"""`ros2 run ... &` in a real bash on a real terminal goes on, takes no keys, and comes back with `fg`."""

import contextlib
import os
import select
import shlex
import subprocess
import sys
import time

import pytest

pty = pytest.importorskip("pty", exc_type=ImportError)  # Windows has none

pytestmark = [pytest.mark.slow, pytest.mark.timeout(180)]
RUN = f"{shlex.quote(sys.executable)} -m coursekit.cli.ros2 run"


class Shell:
    """An interactive bash on a terminal of its own."""

    def __init__(self, env):
        self.ours, theirs = pty.openpty()
        command = ["bash", "--norc", "--noprofile", "-i"]
        around = {"stdin": theirs, "stdout": theirs, "stderr": theirs, "env": env, "preexec_fn": lambda: _lead(theirs)}
        self.bash = subprocess.Popen(command, **around)
        os.close(theirs)
        self.said = ""

    def type(self, text):
        os.write(self.ours, text.encode())

    def until(self, text, patience=60.0):
        """Wait until this was said since the last time; what was said."""
        give_up = time.monotonic() + patience
        while text not in self.said:
            assert time.monotonic() < give_up, self.said
            if select.select([self.ours], [], [], 0.1)[0]:
                self.said += os.read(self.ours, 65536).decode(errors="replace")
        before, _, self.said = self.said.partition(text)
        return before + text

    def close(self):
        with contextlib.suppress(OSError):
            os.write(self.ours, b"\x03\nkill %1; exit\n")
        with contextlib.suppress(subprocess.TimeoutExpired):
            self.bash.wait(20)
        self.bash.kill()
        self.bash.wait()
        os.close(self.ours)


def _lead(number):
    import fcntl
    import termios

    os.setsid()
    fcntl.ioctl(number, termios.TIOCSCTTY, 0)


@pytest.fixture
def shell(tmp_path):
    env = {key: value for key, value in os.environ.items() if not key.startswith(("COURSEKIT_", "ROS_"))}
    interactive_shell = Shell(
        env | {"COURSEKIT_RUNTIME_DIR": str(tmp_path), "ROS_DOMAIN_ID": "81", "PS1": "> ", "PYTHONUNBUFFERED": "1"}
    )
    yield interactive_shell
    interactive_shell.close()


def test_a_node_in_the_background_goes_on_and_the_shell_keeps_the_keys(shell):
    shell.type(f"{RUN} demo_nodes_py talker &\n")
    shell.until("Hello World: 2")
    shell.type("jobs; echo to the $((40 + 2)) shell\n")
    said = shell.until("to the 42 shell")
    assert "Running" in said and "Stopped" not in said
    shell.until("Hello World: 4")
    shell.type("fg\n")
    shell.until("demo_nodes_py talker")
    shell.type("\x03")
    shell.type("echo over with $?\n")
    assert "Traceback" not in shell.until("over with")


def test_a_program_of_keys_takes_them_once_it_is_in_front(shell):
    shell.type(f"{RUN} turtlesim turtle_teleop_key &\n")
    shell.until("quit")
    shell.type("jobs; stty -a | grep -o ' icanon'\n")
    assert "Stopped" not in shell.until(" icanon\r\n")
    shell.type("fg\n")
    shell.until("turtle_teleop_key")
    time.sleep(0.6)  # three turns of a job that waits for the front
    shell.type("q")
    shell.until("> ")
    shell.type("echo over $((1 + 1))\n")
    shell.until("over 2")
    shell.type("stty -a | grep -o ' icanon'\n")
    shell.until(" icanon\r\n")
