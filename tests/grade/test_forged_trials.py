"""Programs that are tried out can change what is seen of them only by what they do."""

import os
import sys

import pytest

from coursekit.grade import sandbox
from coursekit.grade.examiner import environment
from coursekit.grade.remote import RemoteWork
from coursekit.grade.trial import Plan, TrialFailed, answered, try_out
from coursekit.grade.verdict import Wrong

AT_ONCE = "import time\ntime.sleep(0.5)\n"
ANSWER = r"""
import json, os, struct
forged = json.dumps({"seen": {"outputs": ["I heard"], "exit_codes": [0], "nodes": ["/forged"]}}).encode()
frame = json.dumps({"now": 10**12, "next": None, "events": [["ended", ["I heard"], [0]]]}).encode()
for number in range(64):
    try: os.write(number, forged + struct.pack("<II", len(frame), 0) + frame)
    except OSError: pass
"""
PATCHES = {
    "dataclasses": """
import dataclasses
dataclasses._asdict_inner = lambda *_: {"nodes": ["/forged"]}
""",
    "json": """
import json
json.dumps = lambda *_, **__: '{"seen": {"nodes": ["/forged"]}}'
""",
    "how messages are read": """
import rosidl_runtime_py
rosidl_runtime_py.message_to_ordereddict = lambda msg: {"data": "forged"}
import coursekit.interfaces.cdr as cdr
cdr.serialize = lambda message: cdr.HEADER
""",
    "the watcher": """
import coursekit.grade.watcher as watcher, coursekit.grade.plan as plan
watcher.Watcher._look = lambda self: self.seen.nodes.append("/forged")
plan.Seen.nodes = ["/forged"]
""",
    "all that is in memory": """
import gc
for one in gc.get_objects():
    if type(one).__name__ == "Seen": one.nodes.append("/forged")
    if type(one).__name__ == "Mirror": one.graph = None
""",
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
        return try_out(Plan(run=[["run", "forger", "forge"]], beside=[["run", "demo_nodes_py", "talker"]],
                            seconds=2.5, record=["/chatter"]))  # fmt: skip

    return run


@pytest.mark.parametrize("what", PATCHES)
def test_a_program_that_patches_its_interpreter_patches_only_that(run, what):
    seen = run(AT_ONCE + PATCHES[what] + "time.sleep(9)")
    assert seen.nodes == ["/talker"]
    assert [message["data"] for _, message in seen.messages["/chatter"]] == ["Hello World: 0", "Hello World: 1"]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (ANSWER + "os._exit(0)", "ended the trial|interfered with the trial"),
        (AT_ONCE + ANSWER + "time.sleep(9)", "interfered with the trial"),
        ("import os\nos._exit(0)", "the program ended the trial"),
        ("import os, signal\nos.kill(os.getpid(), signal.SIGSEGV)", "the program ended the trial"),
    ],
    ids=["answers and ends", "answers", "ends", "crashes"],
)
def test_who_answers_in_the_trial_s_place_fails_it(run, text, told):
    with pytest.raises(TrialFailed, match=told):
        run(text)


def test_an_honest_program_is_seen_as_it_is(run):
    assert run("print('hello')").outputs == ["hello\n"]


@pytest.mark.parametrize("out", [b"", b"{", b"[]", b'{"seen": {"unknown": 1}}', b'{"seen": 3}', b'{"nodes": []}'])
def test_an_answer_that_is_none_fails_the_trial(out):
    with pytest.raises(TrialFailed, match="ended before it could say"):
        answered(out)


def test_modules_in_the_student_s_folder_do_not_stand_in_for_ours(tmp_path):
    workspace = tmp_path / "course" / "ros2_ws"
    (workspace / "src").mkdir(parents=True)
    for name in ("secrets.py", "json.py", "sitecustomize.py"):
        (workspace.parent / name).write_text("import os\nos.write(1, b'mine')\nos._exit(0)\n")
    env, limits = environment(workspace), sandbox.Limits(seconds=30)
    env["PYTHONPATH"] = os.pathsep.join([str(workspace.parent), env.get("PYTHONPATH", "")])
    running = sandbox.start([sys.executable, "-I", "-c", "input()"], workspace.parent, env, limits)
    try:
        work = RemoteWork(running, workspace, env, limits)
        work.complete = True
        seen = work.try_out("run demo_nodes_py talker", seconds=1.5)
        assert seen.nodes == ["/talker"] and "Hello World" in seen.outputs[0]
        with pytest.raises(Wrong, match="quotes"):
            work.try_out("run 'x")
    finally:
        work.end()
