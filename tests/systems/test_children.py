"""Child processes: what is asked of the system so that they begin apart, and how signals reach them."""

import os
import signal
import subprocess
import sys

import psutil
import pytest

from coursekit.systems import children, operating_system
from tests.needs import real_windows


class Child:
    """Notes what it is told, as Windows' Popen would do it."""

    def __init__(self, refusal=None, ended=False):
        self.told = []
        self.refusal = refusal
        self.ended = ended

    def poll(self):
        return 0 if self.ended else None

    def send_signal(self, signum):
        if self.refusal is not None:
            raise self.refusal
        self.told.append(signum)

    def terminate(self):
        self.told.append("terminate")


@pytest.fixture
def windows(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)


def test_on_windows_ctrl_c_is_a_ctrl_break_to_the_childs_own_group(windows):
    child = Child()
    children.send_signal(child, signal.SIGINT)
    assert child.told == [children.CTRL_BREAK]
    assert children.apart() == {"creationflags": 0x200}


def test_on_windows_other_signals_end_a_child(windows):
    child = Child()
    children.send_signal(child, signal.SIGTERM)
    children.send_signal(child, 9)
    assert child.told == ["terminate", "terminate"]


@pytest.mark.parametrize("refusal", [OSError(6, "The handle is invalid"), SystemError("an exception is set")])
def test_on_windows_without_a_console_ctrl_c_ends_a_child_too(windows, refusal):
    child = Child(refusal)
    children.send_signal(child, signal.SIGINT)
    assert child.told == ["terminate"]


def test_a_child_that_has_ended_is_told_nothing(windows):
    child = Child(ended=True)
    children.send_signal(child, signal.SIGINT)
    assert child.told == []


def test_ctrl_c_in_oneself_is_a_keyboard_interrupt_and_no_end(windows):
    """Windows' os.kill with SIGINT ends the program: it is not asked."""
    with pytest.MonkeyPatch.context() as patch:
        patch.delattr(os, "kill")
        with pytest.raises(KeyboardInterrupt):
            children.interrupt_self()


def test_a_python_child_writes_utf8_whatever_the_code_page(windows):
    env = children.with_utf8({**os.environ, "PYTHONIOENCODING": ""})
    done = subprocess.run([sys.executable, "-S", "-c", "print('ñ ✓')"], env={**env, "LC_ALL": "C"}, capture_output=True)
    assert done.stdout.decode().splitlines() == ["ñ ✓"]
    assert children.with_utf8({"PYTHONUTF8": "0"}) == {"PYTHONUTF8": "0"}


PARENT = """
import subprocess, sys
child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(300)"])
print(child.pid, flush=True)
child.wait()
"""


@real_windows("its taskkill ends a program without what that has started")
def test_the_end_of_a_family_is_that_of_what_a_child_has_started_too():
    child = subprocess.Popen([sys.executable, "-c", PARENT], stdout=subprocess.PIPE, **children.apart())
    started = psutil.Process(int(child.stdout.readline()))
    children.end_family(child)
    child.communicate()
    psutil.wait_procs([started], timeout=20)
    assert not started.is_running() or started.status() == psutil.STATUS_ZOMBIE
