"""`coursekit lab` is JupyterLab itself."""

import subprocess
import sys

import pytest

BECOMES = """
import os, sys
from coursekit.cli.coursekit import _become
print(os.getpid())
_become([sys.executable, "-c", "import os; print(os.getpid())"], dict(os.environ))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there it stays a parent")
def test_who_ends_the_command_ends_the_server() -> None:
    done = subprocess.run([sys.executable, "-c", BECOMES], capture_output=True, text=True, check=True)
    before, after = done.stdout.split()
    assert before == after
