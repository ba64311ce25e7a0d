"""Two notebooks are open: terminals speak to the one in which a cell was run last, and say so."""

import os
import subprocess
import sys

import pytest

from coursekit.cli import endpoint
from tests.kernels import run, surround, two_kernels

pty = pytest.importorskip("pty", reason="Windows has no terminals of this kind")
pytestmark = [pytest.mark.slow, pytest.mark.timeout(240)]
DOMAIN = 79
START = "from coursekit.lab import *\nimport rclpy\nrclpy.init()\nnode = rclpy.create_node('{name}')"


@pytest.fixture
def surroundings(tmp_path, monkeypatch):
    surround(monkeypatch, tmp_path, DOMAIN)
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))


@pytest.fixture
def notebooks(surroundings, monkeypatch):
    """Kernels of two notebooks; the second was opened last."""
    with two_kernels(lambda name: monkeypatch.setenv("JPY_SESSION_NAME", f"/course/{name}.ipynb"), START) as opened:
        yield opened


def ros2(*words):
    command = [sys.executable, "-m", "coursekit.cli.ros2", *words]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60, check=True).stdout.split()


def nodes_in_terminal():
    """`ros2 node list` as a person sees it."""
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "coursekit.cli.ros2", "node", "list"]
    subprocess.run(command, timeout=60, check=True, stdout=theirs, stderr=theirs, stdin=theirs)
    os.close(theirs)
    said = os.read(ours, 65536).decode()
    os.close(ours)
    return said.splitlines()


def test_terminals_follow_the_notebook_that_was_run_last_and_say_which(notebooks):
    (_, one), (_, two) = notebooks
    assert ros2("node", "list") == ["/two"]
    run(one, "None")
    assert ros2("node", "list") == ["/one"]
    assert nodes_in_terminal() == ["(in the session of one.ipynb, the notebook in which a cell was run last)", "/one"]
    run(two, "reset(); rclpy.init(); node = rclpy.create_node('anew')")
    assert ros2("node", "list") == ["/anew"]


def test_when_that_notebook_is_closed_or_dies_they_speak_to_the_other(notebooks):
    (_, one), (manager, _) = notebooks
    manager.shutdown_kernel(now=True)
    assert ros2("node", "list") == ["/one"]
    assert nodes_in_terminal() == ["/one"]  # there is no other now
    assert endpoint.live_sessions(DOMAIN) == 1 and len(endpoint.sessions(DOMAIN)) == 1
    run(one, "None")
    assert ros2("node", "list") == ["/one"]
