"""Two notebooks, each in a kernel of its own, at the router of `coursekit network serve`: what students type."""

import contextlib
import re
import subprocess
import sys

import pytest

from tests.kernels import run, surround, two_kernels

from .sides import free_port, network

pytestmark = [pytest.mark.slow, pytest.mark.timeout(240)]
START = """
from coursekit.lab import *
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node({name!r})
publisher = node.create_publisher(String, "chatter", 10)
heard = rclpy.task.Future()
def hear(message):
    if message.data != {name!r} and not heard.done():
        heard.set_result(message.data)
subscription = node.create_subscription(String, "chatter", hear, 10)
timer = node.create_timer(0.05, lambda: publisher.publish(String(data={name!r})))
"""
HEAR = "rclpy.spin_until_future_complete(node, heard, timeout_sec=30.0); print(heard.result())"


@contextlib.contextmanager
def router(*words):
    """A router of its own process; its first lines, and its end."""
    command = [sys.executable, "-m", "coursekit.cli.coursekit", "network", "serve", *map(str, words)]
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    said = []
    for line in child.stdout:
        said.append(line.strip())
        if line.startswith("Ctrl-C"):
            break
    try:
        yield child, said
    finally:
        child.kill()
        child.communicate()


@pytest.fixture
def notebooks(tmp_path, monkeypatch):
    surround(monkeypatch, tmp_path, 78)

    def prepare(name):
        monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / name / "ros2_ws"))

    with two_kernels(prepare, START) as opened:
        yield opened


def test_two_notebooks_meet_and_one_is_shut_down_though_it_did_not_leave(notebooks, tmp_path):
    users, port = tmp_path / "users.txt", free_port()
    users.write_text("class:secret\n", encoding="utf-8")
    (one_manager, one), (_, two) = notebooks
    with router("--listen", f"tcp/127.0.0.1:{port}", "--users", users) as (child, said):
        assert said == [
            f"The router listens. Notebooks join it with: %network tcp/127.0.0.1:{port} --user NAME",
            "Ctrl-C ends it.",
        ]
        assert "does not let" in run(one, f"%network 127.0.0.1:{port}")
        for client in (one, two):
            run(client, "import os; os.environ['COURSEKIT_NETWORK_PASSWORD'] = 'secret'")
            run(client, "os.environ['COURSEKIT_NETWORK_USER'] = 'class'")
            assert "domain 78: joined" in run(client, f"%network 127.0.0.1:{port}")
        hears = run(two, "import threading; threading.Thread(target=lambda: rclpy.spin(node), daemon=True).start()")
        assert run(one, HEAR) == "two\n", hears
        assert "/two" in run(one, "%ros2 node list") and "/two (network)" in run(one, "print(graph().text())")
        assert re.search(r"/chatter .*from /two +std_msgs/msg/String", run(one, "%network"))
        one.shutdown()  # a kernel that hangs at its end is waited for in vain
        one_manager.provisioner.process.wait(30)
        assert child.poll() is None
        run(two, "%network off")
        assert "/one" not in run(two, "%ros2 node list")


def test_a_router_says_what_is_not_safe(capsys):
    from coursekit.cli.router_text import welcome

    assert len(welcome(["tcp/127.0.0.1:7447"], 0)) == 2
    assert "Anybody in the network can join" in "\n".join(welcome(["tcp/0.0.0.0:7447"], 0))
    assert "can be read on the way" in "\n".join(welcome(["tcp/0.0.0.0:7447"], 3))
    assert len(welcome(["tls/0.0.0.0:7447"], 3)) == 2
    assert "0.0.0.0" not in welcome(["tls/0.0.0.0:7447"], 3)[0]


@pytest.mark.parametrize(("text", "wrong"), [("", "names nobody"), ("anna\n", "Line 1"), ("a:b\n c : d\n", "Line 2")])
def test_a_file_of_users_that_is_none_is_told(tmp_path, text, wrong):
    users = tmp_path / "users.txt"
    users.write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "coursekit.cli.coursekit", "network", "serve", "--users", str(users)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 1 and wrong in done.stderr and "Traceback" not in done.stderr


def test_an_address_that_is_taken_is_told():
    with network() as side:
        command = [sys.executable, "-m", "coursekit.cli.coursekit", "network", "serve", "--listen", side.address]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
        assert done.returncode == 1 and "Nobody can listen at" in done.stderr


def test_a_router_with_a_certificate_is_joined_by_who_trusts_it(tmp_path):
    from coursekit.net.errors import NoNetwork
    from coursekit.net.zenoh_session import Credentials, open_client

    certificate, key = certificate_for_this_computer(tmp_path)
    port = free_port()
    with router("--listen", f"tls/localhost:{port}", "--certificate", certificate, "--key", key):
        open_client(f"tls/localhost:{port}", Credentials(certificate=str(certificate))).close()
        with pytest.raises(NoNetwork, match="a certificate that it does not show"):
            open_client(f"tls/localhost:{port}", seconds=1.0)


def certificate_for_this_computer(folder):
    """A certificate that vouches for itself, and its key, by the system's openssl."""
    certificate, key = folder / "cert.pem", folder / "key.pem"
    words = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost"]
    words += ["-addext", "subjectAltName=DNS:localhost", "-addext", "basicConstraints=critical,CA:FALSE"]
    try:
        subprocess.run([*words, "-keyout", str(key), "-out", str(certificate)], check=True, capture_output=True)
    except FileNotFoundError:
        pytest.skip("there is no openssl to make a certificate with")
    return certificate, key
