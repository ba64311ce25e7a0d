"""Two notebooks are open: terminals speak to the one in which a cell was run last, and say so."""

import os
import subprocess
import sys

import pytest
from jupyter_client.manager import start_new_kernel

from coursekit.cli import endpoint

pty = pytest.importorskip("pty", reason="Windows has no terminals of this kind")
pytestmark = [pytest.mark.slow, pytest.mark.timeout(240)]
DOMAIN = 79
START = "from coursekit.lab import *\nimport rclpy\nrclpy.init()\nnode = rclpy.create_node('{}')"


@pytest.fixture
def surroundings(tmp_path, monkeypatch):
    for name in [one for one in os.environ if one.startswith("COURSEKIT_")]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", str(tmp_path))
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    monkeypatch.setenv("ROS_DOMAIN_ID", str(DOMAIN))


@pytest.fixture
def notebooks(surroundings, monkeypatch):
    """Kernels of two notebooks; the second was opened last."""
    opened = []
    for name in ("one", "two"):
        monkeypatch.setenv("JPY_SESSION_NAME", f"/course/{name}.ipynb")
        manager, client = start_new_kernel(kernel_name="python3", startup_timeout=60)
        opened.append((manager, client))
        run(client, START.format(name))
    yield opened
    for manager, client in opened:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def run(client, code):
    said = []
    reply = client.execute_interactive(code, timeout=60, output_hook=lambda message: said.append(message["content"]))
    assert reply["content"]["status"] == "ok", reply["content"]
    return "".join(one.get("text", "") for one in said)


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
