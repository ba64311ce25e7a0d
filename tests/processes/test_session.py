"""The session that a program has when it is in none: its clock is the environment's word."""

import os
import subprocess
import sys

import pytest

from coursekit.processes.session import Session
from coursekit.systems import operating_system

ASK = "import sys; from coursekit.processes.session import current; print(current().clock.virtual)"


def said(time: str) -> subprocess.CompletedProcess[str]:
    environment = dict(os.environ) | {"COURSEKIT_TIME": time}
    return subprocess.run([sys.executable, "-c", ASK], env=environment, capture_output=True, encoding="utf-8")


@pytest.mark.parametrize(("time", "virtual"), [("", "False"), ("wall", "False"), ("virtual", "True")])
def test_the_environment_says_which_clock_and_an_empty_word_is_none(time, virtual):
    assert said(time).stdout.strip() == virtual


def test_a_clock_that_does_not_exist_is_refused_with_the_two_that_do():
    done = said("warp")
    assert done.returncode == 1
    assert "COURSEKIT_TIME is 'warp', which is no clock. Set it to 'wall' or 'virtual'." in done.stderr


def test_ctrl_c_where_nothing_runs_interrupts_the_interpreter_and_does_not_end_it(monkeypatch):
    """On Windows os.kill with SIGINT ends the program: it is not asked there."""
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    monkeypatch.delattr(os, "kill")
    with Session().use() as session, pytest.raises(KeyboardInterrupt):
        session.interrupt_all()
