"""`gz` and `ign` without a command."""

import pytest

from coursekit.cli import gz_commands


@pytest.mark.parametrize("words", [["--help"], ["-h"], ["help"], []])
def test_the_help_of_gz_names_its_own_commands(capsys, words):
    assert gz_commands.run_inside(words) == 0
    told = capsys.readouterr().out
    assert "gz <command> [options]" in told and "topic:" in told and "ros2" not in told


def test_an_unknown_command_of_gz_is_told(capsys):
    assert gz_commands.run_inside(["model"]) == 255
    assert "gz model: not part of coursekit" in capsys.readouterr().err
