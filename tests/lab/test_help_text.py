"""Shift-Tab in a kernel: signatures are easy to read."""

import pytest
from IPython.core.interactiveshell import InteractiveShell
from traitlets.config import Config

from coursekit.lab import help_text
from coursekit.lab.messages import echo


@pytest.fixture
def shell():
    shell = InteractiveShell(config=Config(HistoryManager={"enabled": False}))
    help_text.install(shell)
    yield shell
    for patch in help_text.patches():
        patch.take_back()


def test_types_of_parameters_stand_without_quotes_and_defaults_as_they_are(shell):
    shown = shell.inspector.info(echo, oname="echo")["definition"]
    assert shown.strip() == "echo(topic: str, n: int = 1, timeout_sec: float = 10.0) -> None"


def test_functions_of_others_are_shown_as_before(shell):
    def turn(angle: float, how: str = "left", *more): ...

    assert shell.inspector.info(turn, oname="turn")["definition"].strip() == "turn(angle: float, how: str = 'left', *more)"
    assert shell.inspector.info(3, oname="number")["definition"] is None
