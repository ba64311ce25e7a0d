"""What a student sees of an error of the lab's functions."""

import pytest
from IPython.core.interactiveshell import InteractiveShell

from coursekit.lab.errors import BadArgument, NotNow, NotThere


@pytest.mark.parametrize(
    ("kind", "builtin"), [(BadArgument, ValueError), (NotThere, LookupError), (NotNow, RuntimeError)]
)
def test_programs_catch_them_as_what_they_are(kind, builtin):
    with pytest.raises(builtin, match="what to type"):
        raise kind("what to type")


def test_a_cell_shows_the_call_and_the_cure_and_nothing_of_our_inside(capsys):
    shell = InteractiveShell()
    shell.run_cell("from coursekit.lab.log_console import LogConsole\nnumber = 1\nLogConsole('LOUD')")
    shown = capsys.readouterr().out
    assert shown.splitlines() == [
        "LogConsole('LOUD')",
        "There is no level 'LOUD'. Levels are: DEBUG, INFO, WARN, ERROR, FATAL",
    ]
