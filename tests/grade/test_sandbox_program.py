"""The shell inside of the sandbox does what the notebook's does, on a clock of its own."""

import json
import os
import subprocess
import sys

import pytest

from tests.needs import posix

PROGRAM = """
import json, os, sys
from coursekit.grade.sandbox_program import Runner
runner = Runner()
told = [runner.run(cell, 5.0) for cell in json.loads(sys.argv[1])]
print(json.dumps([told, runner.shell.user_ns.get("said")]), file=sys.__stdout__, flush=True)
os._exit(0)
"""


def run(folder, *cells):
    """What went wrong in each cell, and the variable `said` afterwards."""
    surroundings = {"COURSEKIT_COURSE": str(folder), "COURSEKIT_WORKSPACE": str(folder / "ros2_ws"), "HOME": str(folder)}
    surroundings["PYTHONUNBUFFERED"] = ""  # IPython 8, Python 3.10's last, keeps only the end of what comes in pieces
    (folder / "ros2_ws" / "src").mkdir(parents=True)
    ours = [sys.executable, "-c", PROGRAM, json.dumps(cells)]
    done = subprocess.run(ours, env={**os.environ, **surroundings}, capture_output=True, cwd=folder, check=True)
    told, said = json.loads(done.stdout.splitlines()[-1])
    return [output["error"] for output in told], said


@posix("there is no bash there")
@pytest.mark.parametrize(
    "cell",
    ["%%bash --out said\necho hi", "%%sh --out said\necho hi", "%%python --out said\nprint('hi')"],
)
def test_a_cell_for_another_program_ends_as_it_does_in_the_notebook(tmp_path, cell):
    """IPython waits for it in a thread of its own, which never ran on the virtual clock."""
    assert run(tmp_path, cell) == ([""], "hi\n")


@posix("there is no bash there")
def test_what_such_a_program_fails_with_is_told_and_the_cells_below_run(tmp_path):
    errors, said = run(tmp_path, "%%bash\nexit 3", "said = 'after'")
    assert "exit status 3" in errors[0] and (errors[1], said) == ("", "after")


STUBBORN = """
import time
for _ in range(4):
    try:
        while True:
            time.monotonic()
    except BaseException:
        pass
while True:
    time.monotonic()
"""


def test_what_swallows_the_end_is_ended_again(tmp_path):
    surroundings = {"COURSEKIT_COURSE": ".", "COURSEKIT_WORKSPACE": "ros2_ws", "HOME": str(tmp_path)}
    (tmp_path / "ros2_ws" / "src").mkdir(parents=True)
    program = PROGRAM.replace("runner.run(cell, 5.0)", "runner.run(cell, 0.2)")
    ours = [sys.executable, "-c", program, json.dumps([STUBBORN])]
    env = {**os.environ, **surroundings}
    done = subprocess.run(ours, env=env, capture_output=True, cwd=tmp_path, check=True, timeout=40)
    ((answer,), _) = json.loads(done.stdout.splitlines()[-1])
    assert answer["timed_out"] and "took too long" in answer["error"]
