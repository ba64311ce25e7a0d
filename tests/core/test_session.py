"""The session that a program has when it is in none: its clock is the environment's word."""

import os
import subprocess
import sys

import pytest

ASK = "import sys; from coursekit.core.session import current; print(current().clock.virtual)"


def said(time: str) -> subprocess.CompletedProcess[str]:
    environment = dict(os.environ) | {"COURSEKIT_TIME": time}
    return subprocess.run([sys.executable, "-c", ASK], env=environment, capture_output=True, text=True)


@pytest.mark.parametrize(("time", "virtual"), [("", "False"), ("wall", "False"), ("virtual", "True")])
def test_the_environment_says_which_clock_and_an_empty_word_is_none(time, virtual):
    assert said(time).stdout.strip() == virtual


def test_a_clock_that_does_not_exist_is_refused_with_the_two_that_do():
    done = said("warp")
    assert done.returncode == 1
    assert "COURSEKIT_TIME is 'warp', which is no clock. Set it to 'wall' or 'virtual'." in done.stderr
