"""The practice robot: who may join it, what is sent to it through a weak link, and when it ends."""

import contextlib
import os
import signal
import subprocess
import sys
import time

import pytest
from geometry_msgs.msg import Twist

from coursekit.core.qos import Qos
from coursekit.lab.errors import NotNow
from coursekit.lab.magics import terminal
from coursekit.lab.practice_robot import practice_robot, weak_link
from coursekit.net.errors import NoNetwork
from coursekit.net.joining import credentials_from_the_environment, join, link_of
from coursekit.net.zenoh_session import open_client
from coursekit.processes import current_session
from coursekit.processes.session import Session
from coursekit.systems.children import apart, send_signal
from coursekit.systems.ports import free_port
from tests.kernels import run, surround, two_kernels
from tests.needs import posix
from tests.net.listening import LOOPBACK, listening
from tests.net.sides import LIMIT

pytestmark = [pytest.mark.slow, pytest.mark.timeout(240)]


@pytest.fixture
def session(monkeypatch, tmp_path):
    surround(monkeypatch, tmp_path, 0)
    own_session = Session()
    monkeypatch.setattr(current_session, "session", own_session)
    yield own_session
    own_session.close()


@pytest.fixture
def vera(session):
    robot = practice_robot()
    yield robot
    robot.stop()


def until(session, holds):
    give_up = time.monotonic() + LIMIT
    while not holds():
        assert time.monotonic() < give_up
        session.clock.sleep(0.02)


def joined(session, address):
    return join(session, 0, address, credentials=credentials_from_the_environment(), confirm=lambda _moves: True)


def names(session):
    return {node.full_name for node in session.graph(0).nodes}


def test_only_who_has_the_password_joins_it_and_it_is_forgotten_when_it_ends(vera, session):
    assert terminal("practice_robot") is vera and repr(vera) == "[practice_robot: running]"
    with pytest.raises(NoNetwork, match="does not let this side in"):
        open_client(vera.address, seconds=1.0)
    joined(session, vera.address)
    assert {"/base", "/robot_state_publisher", "/screen", "/meter"} <= names(session)
    vera.stop()
    until(session, lambda: "/base" not in names(session))
    assert credentials_from_the_environment().user == "" and vera.process.exit_code is not None


def test_a_second_one_takes_the_place_of_the_first(vera, session):
    again = practice_robot()
    assert vera.process.exit_code is not None and again.process.exit_code is None
    joined(session, again.address)
    again.stop()


def test_a_robot_stops_when_the_link_is_cut_and_drives_again_when_told_to(vera, session):
    link = weak_link(vera.address)
    assert repr(link) == "[weak link: good]"
    joined(session, link.address)
    wheels = session.graph(0).add_node("teleop", "/").publisher("/cmd_vel", Twist, Qos(depth=1))
    until(session, lambda: wheels.targets)
    link_of(session, 0).settle()
    forward = Twist()
    forward.linear.x = 0.2
    wheels.publish(forward)
    until(session, lambda: "No command for 0.5 s: stopped" in vera.text)
    link.cut()
    assert repr(link) == "[weak link: cut]"
    until(session, lambda: not link_of(session, 0).is_up and not wheels.targets)
    link.mend()
    until(session, lambda: link_of(session, 0).is_up and wheels.targets)
    link.close()


def test_one_that_cannot_start_says_why(session):
    with pytest.raises(NotNow, match="there is no world 'nowhere'"):
        practice_robot("nowhere")
    assert session.processes == []


def test_on_the_virtual_clock_and_without_the_packages_it_is_refused(session, monkeypatch):
    monkeypatch.setitem(sys.modules, "zenoh", None)
    with pytest.raises(NotNow, match="pip install"):
        practice_robot()
    monkeypatch.setattr(current_session, "session", Session(virtual=True))
    with pytest.raises(NotNow, match="use the wall clock"):
        practice_robot()


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="needs signals of POSIX")
def test_it_ends_though_the_kernel_is_killed(monkeypatch, tmp_path):
    surround(monkeypatch, tmp_path, 79)
    with two_kernels(lambda _name: None, "from coursekit.lab import *") as ((manager, client), _):
        pid = int(run(client, "vera = practice_robot(); print(vera.process._child.pid)", timeout=120).splitlines()[-1])
        os.kill(manager.provisioner.process.pid, signal.SIGKILL)
        give_up = time.monotonic() + LIMIT
        with contextlib.suppress(ProcessLookupError):
            while time.monotonic() < give_up:
                os.kill(pid, 0)
                if "Z" in subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True).stdout:
                    return
                time.sleep(0.05)
            pytest.fail("it lives on")


@posix("its sockets are not in /proc, which in Wine is that of Linux")
@pytest.mark.skipif(not os.path.exists("/proc/net/tcp"), reason="sockets are looked up where Linux tells them")
def test_nothing_listens_beyond_loopback(vera, session):
    before = listening()
    link = weak_link(vera.address)
    joined(session, link.address)
    ports = [int(endpoint.address.rpartition(":")[2]) for endpoint in (link, vera)]
    assert listening() - before == {("tcp", LOOPBACK, ports[0])}
    assert listening(vera.process._child.pid) == {("tcp", LOOPBACK, ports[1])}
    link.close()


def test_the_command_ends_with_ctrl_c_and_tells_of_a_port_that_is_taken(vera, tmp_path):
    command = [sys.executable, "-m", "coursekit.cli.coursekit", "network", "robot", "--listen"]
    taken = subprocess.run([*command, vera.address], capture_output=True, text=True, timeout=60)
    assert taken.returncode == 1 and "Nobody can listen at" in taken.stderr
    command.append(f"127.0.0.1:{free_port()}")
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **apart())
    try:
        said = [next(line for line in child.stdout if "Wheels and laser are ready" in line)]
        send_signal(child, signal.SIGINT)
        said += child.communicate(timeout=LIMIT)[0].splitlines()
        assert child.returncode is not None and not [line for line in said if "Traceback" in line]
    finally:
        child.kill()
        child.communicate()
