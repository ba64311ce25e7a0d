"""`!command` on Windows prints into its cell all that the command says, and in that order."""

import sys

import pytest
from IPython.core.interactiveshell import InteractiveShell

from coursekit.lab import cmd_words, shell_lines
from coursekit.systems import operating_system
from tests.needs import real_windows

SAYS = f"\"{sys.executable}\" -c \"import sys; print('one', flush=True); print('ñ', file=sys.stderr); sys.exit(3)\""


class Shell:
    """Of IPython's shell what a line needs; a whole one would change the environment of other tests."""

    var_expand = InteractiveShell.var_expand

    def __init__(self):
        self.user_ns = {}

    def system(self, line):
        """IPython's own way."""


@pytest.fixture
def shell(monkeypatch):
    """A shell as a notebook on Windows has it."""
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    interactive_shell = Shell()
    shell_lines.install(interactive_shell)
    return interactive_shell


def test_output_and_errors_come_in_order_and_the_exit_code_is_kept(shell, capsys):
    shell.system(SAYS)
    assert capsys.readouterr().out == "one\nñ\n"
    assert shell.user_ns["_exit_code"] == 3


def test_variables_of_the_notebook_stand_in_it(shell, capsys):
    shell.user_ns["word"] = "said"
    shell.system("echo {word}")
    assert capsys.readouterr().out.strip() == "said"


def test_elsewhere_it_is_ipythons(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    interactive_shell = Shell()
    shell_lines.install(interactive_shell)
    assert "system" not in vars(interactive_shell)


@pytest.mark.parametrize(
    ("line", "told"),
    [
        pytest.param(
            "source install/setup.bash && ros2 node list",
            "cells know what `%colcon build` has built",
            marks=real_windows("its cmd tells no exit code of a program that is not there before &&"),
        ),
        ("cd /nowhere_at_all || export ROS_DOMAIN_ID=7; exit 1", "no `export`: type `%env NAME=value`"),
    ],
)
def test_a_command_that_only_bash_has_is_told_with_what_stands_for_it(shell, capsys, line, told):
    shell.system(line)
    assert shell.user_ns["_exit_code"] != 0 and told in capsys.readouterr().out


@pytest.mark.parametrize("line", ["exit 3", "echo source"])
def test_what_fails_for_another_reason_and_what_succeeds_is_not_commented(shell, capsys, line):
    shell.system(line)
    assert "Windows' cmd" not in capsys.readouterr().out


def test_a_program_of_git_for_windows_is_there(monkeypatch):
    monkeypatch.setattr(cmd_words.shutil, "which", lambda name: f"/git/{name}.exe")
    assert cmd_words.hint("ls nothing") == ""
