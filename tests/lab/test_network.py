"""`%network` and the pad, as a notebook has them; the network itself is tested in tests/net."""

import pytest
from geometry_msgs.msg import Twist
from IPython.core.interactiveshell import InteractiveShell

from coursekit.core.qos import Qos
from coursekit.lab.errors import BadArgument
from coursekit.lab.network import NetworkMagics
from coursekit.lab.network_panel import network_panel
from coursekit.lab.teleop_pad import pad
from coursekit.net.report import NOT_JOINED
from coursekit.processes import current_session
from coursekit.processes.session import Session
from coursekit.view.graph import GraphPicture
from tests.net.sides import free_port, network


@pytest.fixture
def session(monkeypatch):
    monkeypatch.setenv("ROS_DOMAIN_ID", "0")
    for name in ("", "_USER", "_PASSWORD", "_CERTIFICATE"):
        monkeypatch.delenv(f"COURSEKIT_NETWORK{name}", raising=False)
    own_session = Session()
    monkeypatch.setattr(current_session, "session", own_session)
    yield own_session
    own_session.close()


@pytest.fixture
def side():
    with network() as make:
        yield make


@pytest.fixture
def magic(session, capsys):
    magics = NetworkMagics(InteractiveShell())

    def run(line):
        capsys.readouterr()
        magics.network(line)
        return capsys.readouterr().out

    return run


def robot_of(side):
    robot = side()
    robot.graph.add_node("base", "/r1").subscription("/cmd_vel", Twist, Qos())
    watch = side()
    watch.until(lambda: "/cmd_vel" in watch.graph.subscriptions)
    return robot


def test_without_a_network_it_says_how_to_join_one(magic):
    assert magic("").startswith("No network: messages stay in this notebook. Join one: %network ADDRESS")
    assert magic("off") == "No network was joined.\n"


def test_a_network_is_joined_shown_and_left(magic, side, session):
    robot_of(side)
    said = magic(side.address)
    assert f"Network {side.address}, domain 0: joined" in said and "/r1/base" in said
    assert magic("--listen-only " + side.address).splitlines()[0].endswith("joined, you only listen")
    assert "/r1/base (network)" in GraphPicture(session.graph(0)).text()
    assert ">network<" in GraphPicture(session.graph(0)).svg()
    assert magic("off") == "Left the network.\n" and session.graph(0).nodes == []


def test_the_panel_shows_the_network_and_leaves_it(magic, side, session):
    panel = network_panel()
    assert (panel.shown()["joined"], str(panel)) == (False, NOT_JOINED)
    robot_of(side)
    magic(side.address)
    shown = panel.shown()
    assert (shown["joined"], shown["up"], shown["address"], shown["domain"]) == (True, True, side.address, 0)
    assert "/r1/base" in [node for other in shown["others"] for node in other["nodes"]]
    assert str(panel).startswith(f"Network {side.address}, domain 0: joined")
    panel.on_leave({})
    assert not panel.shown()["joined"]
    panel.close()


def test_what_is_wrong_is_said_without_a_traceback(magic):
    assert magic(f"127.0.0.1:{free_port()}").startswith("Nobody listens at")
    assert magic("what/is/this").startswith("'what/is/this' is no address")
    with pytest.raises(BadArgument, match="%network ADDRESS"):
        magic("--nonsense")


@pytest.mark.parametrize(("answer", "joined"), [("yes", True), ("no", False), ("", False)])
def test_it_asks_before_it_moves_a_robot(magic, side, session, monkeypatch, answer, joined):
    robot_of(side)
    session.graph(0).add_node("teleop", "/").publisher("/cmd_vel", Twist, Qos())
    monkeypatch.setattr("builtins.input", lambda _question: answer)
    said = magic(side.address)
    assert "/teleop publishes /cmd_vel, /r1/base listens" in said
    assert ("domain 0: joined" in said) == joined and ("Not joined" in said) != joined


def test_where_nobody_can_be_asked_it_does_not_join(magic, side, session, monkeypatch):
    robot_of(side)
    session.graph(0).add_node("teleop", "/").publisher("/cmd_vel", Twist, Qos())

    def nobody(_question):
        raise NotImplementedError

    monkeypatch.setattr("builtins.input", nobody)
    assert "--yes" in magic(side.address)
    assert "domain 0: joined" in magic(side.address + " --yes")


def test_a_password_is_asked_for_and_not_shown(magic, monkeypatch):
    asked = []
    monkeypatch.setattr("getpass.getpass", lambda question: asked.append(question) or "secret")
    assert "secret" not in magic(f"127.0.0.1:{free_port()} --user class")
    assert asked == ["Password of class: "]


def test_a_pad_says_when_the_robot_does_not_hear_it_any_more_and_stops(magic, side, session):
    robot = robot_of(side)
    magic(side.address)
    here = pad()
    robot.until(lambda: "/cmd_vel" in robot.graph.publishers)
    assert here.lost == "" and "GONE" not in repr(here)
    here.drive(1.0)
    assert here._driver.moving
    magic("off")
    assert here.lost == side.address and f"THE LINK TO {side.address} IS GONE" in repr(here)
    assert not here._driver.moving
    magic(side.address + " --yes")
    assert here.lost == ""
    here.close()
