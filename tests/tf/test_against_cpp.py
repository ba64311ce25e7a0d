"""The same answers as C++ tf2 gives, on random trees; with `apt-get install python3-tf2`."""

import json
import re
import subprocess
from pathlib import Path

import pytest

from coursekit.geometry.pose import canonical
from coursekit.tf import FrameBuffer, TransformException
from tests.tf.trees import random_tree, times

PYTHON = "/usr/bin/python3"
SCRIPT = Path(__file__).with_name("cpp_tf2.py")


def _installed():
    try:
        done = subprocess.run([PYTHON, "-c", "import tf2_py, genpy"], capture_output=True, timeout=30, env={}, cwd="/")
    except OSError:
        return False
    return done.returncode == 0


pytestmark = pytest.mark.skipif(not _installed(), reason="C++ tf2 is not here: apt-get install python3-tf2 (Debian)")


def ours(data, questions):
    buffer = FrameBuffer()
    for parent, child, stamp, pose, static in data:
        buffer.set(parent, child, stamp, tuple(pose), static=static)
    answers = []
    for question in questions:
        try:
            pose, stamp = buffer.lookup(*question)
            answers.append([list(pose), stamp])
        except TransformException as error:
            answers.append([type(error).__name__, str(error)])
    return answers


def theirs(jobs):
    lines = "\n".join(json.dumps(job) for job in jobs)
    command = [PYTHON, str(SCRIPT)]
    done = subprocess.run(command, input=lines, capture_output=True, encoding="utf-8", env={}, cwd="/", timeout=100)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


def words(text):
    """An error's text without its numbers: ROS 1 writes nine digits after the point and how far outside the time is."""
    return " ".join(re.sub(r"[0-9]+\.[0-9]+s?", "", text).split())


def test_lookups_of_random_trees_are_those_of_cpp_tf2():
    jobs = []
    for seed in range(40):
        data = random_tree(seed, size=10)
        frames = sorted({name for parent, child, *_ in data for name in (parent, child)})
        questions = [(a, b, time) for a in frames for b in frames for time in times(seed)]
        jobs.append({"data": data, "questions": questions})
    poses = 0
    for job, expected in zip(jobs, theirs(jobs), strict=True):
        for question, our_answer, other in zip(job["questions"], ours(**job), expected, strict=True):
            if isinstance(other[0], str):
                assert our_answer[0] == other[0] and words(our_answer[1]) == words(other[1]), question
            else:
                expected_pose = canonical(tuple(other[0]))  # ROS 2 gives one of the two signs, ROS 1 either
                assert our_answer[1] == other[1] and our_answer[0] == pytest.approx(list(expected_pose), abs=1e-9), question
                poses += 1
    assert poses > 5000
