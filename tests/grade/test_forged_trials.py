"""Programs that are tried out cannot answer in the trial's place, nor change what watches them unnoticed."""

import os
import sys

import pytest

from coursekit.grade import sandbox
from coursekit.grade.mark import _environment
from coursekit.grade.remote import Line, RemoteWork
from coursekit.grade.seal import Seal
from coursekit.grade.trial import Plan, TrialFailed, answered, try_out
from coursekit.grade.verdict import Wrong

ANSWER = r"""
import json, os
forged = json.dumps({"outputs": ["I heard"], "exit_codes": [0], "nodes": ["/forged"]}).encode()
for number in range(64):
    try: os.write(number, forged)
    except OSError: pass
os._exit(0)
"""
AT_ONCE = "import time\ntime.sleep(0.5)\n"
WATCHER = AT_ONCE + """
import __main__
__main__.Watcher._look = lambda self: self.seen.nodes.append('/forged')
time.sleep(9)
"""
MESSAGES = AT_ONCE + """
import rosidl_runtime_py
rosidl_runtime_py.message_to_ordereddict = lambda msg: {}
time.sleep(9)
"""
CODE = AT_ONCE + """
import __main__
__main__.Watcher._look.__code__ = (lambda self: None).__code__
time.sleep(9)
"""
MEMORY = AT_ONCE + """
import gc
for one in gc.get_objects():
    if type(one).__name__ == 'Seen': one.nodes.append('/forged')
"""
SEALER = """
import coursekit.grade as package, coursekit.grade.seal as seal
for one in (seal, getattr(package, 'seal', seal)):
    one.Seal.broken = lambda self: ''
    one._functions = lambda: iter(())
""" + WATCHER
FORGERIES = {
    "writes an answer on every pipe": (ANSWER, "ended the trial|answered for it"),
    "replaces the watcher": (WATCHER, "interfered with the trial: __main__.Watcher._look was replaced"),
    "replaces how messages are read": (MESSAGES, "interfered"),
    "replaces code inside a function": (CODE, "interfered with the trial: __main__.Watcher._look was replaced"),
    "searches the memory": (MEMORY, r"interfered with the trial: gc.get_objects\(\) was called"),
}


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Try a program out: as a check in the notebook does."""
    (tmp_path / "share/ament_index/resource_index/packages").mkdir(parents=True)
    (tmp_path / "share/ament_index/resource_index/packages/forger").touch()
    (tmp_path / "lib/forger").mkdir(parents=True)
    program = tmp_path / "lib/forger/forge"
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))

    def run(text):
        program.write_text(f"#!/usr/bin/env python3\n{text}")
        program.chmod(0o755)
        return try_out(Plan(run=[["run", "forger", "forge"]], seconds=1.0))

    return run


@pytest.mark.parametrize("name", FORGERIES)
def test_a_forgery_is_told(run, name):
    text, told = FORGERIES[name]
    with pytest.raises(TrialFailed, match=told) as failure:
        run(text)
    print(f"{name}: {failure.value}")


def test_a_seal_that_is_told_to_be_whole_is_none(run):
    with pytest.raises(TrialFailed, match="interfered"):
        run(SEALER)


def test_an_honest_program_breaks_no_seal(run):
    assert run("print('hello')").outputs == ["hello\n"]


def test_an_answer_without_the_key_counts_for_nothing():
    with pytest.raises(TrialFailed, match="answered for it"):
        answered("right", b'wrong\n{"nodes": []}')
    with pytest.raises(TrialFailed, match="ended while it told"):
        answered("right", b'right\n{"nod')
    with pytest.raises(TrialFailed, match="ended while it told"):
        answered("right", b'right\n{"unknown": 1}')


def test_the_seal_sees_what_was_replaced_and_forgives_what_was_put_back(monkeypatch):
    seal = Seal()
    assert seal.broken() == ""
    with monkeypatch.context() as patch:
        patch.setattr("coursekit.grade.trial.Watcher._look", lambda self: None)
        assert seal.broken() == "coursekit.grade.trial.Watcher._look was replaced"
    assert seal.broken() == ""


def test_modules_in_the_student_s_folder_do_not_stand_in_for_ours(tmp_path):
    workspace = tmp_path / "course" / "ros2_ws"
    (workspace / "src").mkdir(parents=True)
    for name in ("secrets.py", "json.py", "sitecustomize.py"):
        (workspace.parent / name).write_text("import os\nos.write(1, b'mine')\nos._exit(0)\n")
    env, limits = _environment(workspace), sandbox.Limits(seconds=30)
    env["PYTHONPATH"] = os.pathsep.join([str(workspace.parent), env.get("PYTHONPATH", "")])
    running = sandbox.start([sys.executable, "-I", "-c", "input()"], workspace.parent, env, limits)
    try:
        work = RemoteWork(Line(running, limits), workspace, env, limits)
        work.complete = True
        seen = work.try_out("run demo_nodes_py talker", seconds=1.5)
        assert seen.nodes == ["/talker"] and "Hello World" in seen.outputs[0]
        with pytest.raises(Wrong, match="quotes"):
            work.try_out("run 'x")
    finally:
        running.end()
