"""Joining, refusing, being lost, leaving: each in bounded time, and nothing of it moves a robot unasked."""

import os
import re
import subprocess
import sys
import threading

import pytest
from geometry_msgs.msg import Twist
from std_msgs.msg import String

from coursekit.core.qos import Qos
from coursekit.joined.ghosts import Named
from coursekit.net import joining, zenoh_session
from coursekit.net.errors import NoNetwork
from coursekit.net.joining import join, leave, link_of
from coursekit.net.report import report
from coursekit.net.zenoh_session import Credentials, open_client, open_router
from coursekit.processes.session import Session
from tests.needs import posix

from .listening import LOOPBACK, listening
from .sides import LIMIT, Inbox, free_port, network

UNKNOWN = "@ros2_lv/0/ffee/1/2/MP/%/%/robot/%thing/my_msgs::msg::dds_::Thing_/RIHS01_ab/::,10:,:,:,,"


def seen_by(side, holds):
    """Wait until somebody else sees it."""
    watch = side()
    watch.until(lambda: holds(watch.graph))


def hearers(side):
    """Who gets what is published on /chatter, as this side knows it: nobody, as long as no publisher is announced."""
    return [target for publisher in side.graph.publishers.get("/chatter", ()) for target in publisher.targets]


def test_nothing_is_joined_and_zenoh_is_not_imported_unless_asked():
    code = (
        "import sys, rclpy; from coursekit.lab import kernel; rclpy.init(); rclpy.create_node('n'); "
        "print([one for one in sys.modules if one.split('.')[0] in ('zenoh', 'xxhash') or one.startswith('coursekit.net')])"
    )
    env = {name: value for name, value in os.environ.items() if name != "COURSEKIT_NETWORK"}
    done = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, text=True, timeout=60)
    assert done.stdout.strip() in ("['coursekit.net']", "[]"), done.stderr


def test_the_virtual_clock_refuses_in_one_sentence():
    session = Session(virtual=True)
    with pytest.raises(NoNetwork) as refused:
        join(session, 0, "tcp/127.0.0.1:7447")
    assert str(refused.value).count(".") == 1 and "virtual clock" in str(refused.value)


@pytest.mark.parametrize("text", ["", "udp/robot:1", "robot:99999", "a b", "tcp/robot:7447/x", "http://robot"])
def test_what_is_no_address_is_told(session, text):
    with pytest.raises(NoNetwork, match="is no address"):
        join(session, 0, text)


def test_where_nobody_listens_is_told(session):
    with pytest.raises(NoNetwork, match="Nobody listens at tcp/127"):
        join(session, 0, f"127.0.0.1:{free_port()}")


def test_who_does_not_know_the_password_is_kept_out_in_bounded_time(session, tmp_path):
    users, port = tmp_path / "users.txt", free_port()
    users.write_text("class:secret\n", encoding="utf-8")
    router = open_router([f"tcp/127.0.0.1:{port}"], users)
    try:
        for credentials in (Credentials(), Credentials("class", "wrong"), Credentials("other", "secret")):
            with pytest.raises(NoNetwork, match="does not let"):
                open_client(f"tcp/127.0.0.1:{port}", credentials, seconds=1.0)
        open_client(f"tcp/127.0.0.1:{port}", Credentials("class", "secret")).close()
    finally:
        router.close()


def test_a_port_that_is_no_routers_is_given_up(session):
    import socket

    with socket.create_server(("127.0.0.1", 0)) as server:
        address = f"tcp/127.0.0.1:{server.getsockname()[1]}"
        with pytest.raises(NoNetwork, match="does not let this side in"):
            open_client(address, seconds=1.0)


@pytest.mark.skipif(not os.path.exists("/proc/net/tcp"), reason="sockets are looked up where Linux tells them")
@posix("there is no /proc/net that lists ports")
def test_a_client_opens_no_port_and_the_router_only_its_own():
    before = listening()
    with network() as side:
        side()
        assert listening() - before == {("tcp", LOOPBACK, int(side.address.rpartition(":")[2]))}


def test_what_would_move_a_robot_is_told_before_anybody_knows_of_this_side(side, session):
    robot = side()
    robot.graph.add_node("base", "/r1").subscription("/cmd_vel", Twist, Qos())
    graph = session.graph(0)
    graph.add_node("teleop", "/").publisher("/cmd_vel", Twist, Qos())
    asked = []
    seen_by(side, lambda graph: "/cmd_vel" in graph.subscriptions)
    with pytest.raises(NoNetwork, match="/teleop publishes /cmd_vel, /r1/base listens"):
        join(session, 0, side.address, confirm=lambda moves: asked.extend(moves) or False)
    assert asked == ["/teleop publishes /cmd_vel, /r1/base listens"]
    robot.link.settle()
    assert robot.names() == ["/r1/base"] and link_of(session, 0) is None
    join(session, 0, side.address, confirm=lambda moves: True)
    robot.until(lambda: "/teleop" in robot.names())


def test_goals_of_actions_are_among_what_moves(side, session):
    action = "/navigate_to_pose/_action/send_goal"
    kind = Named("nav2_msgs/action/NavigateToPose_SendGoal")
    robot = side()
    robot.graph.add_node("bt_navigator", "/").server(action, kind, Qos())
    seen_by(side, lambda graph: action in graph.servers)
    session.graph(0).add_node("commander", "/").client(action, kind, Qos())
    with pytest.raises(NoNetwork, match="/commander sends goals to /navigate_to_pose, /bt_navigator carries them out"):
        join(session, 0, side.address)
    join(session, 0, side.address, listen_only=True)


def test_leaving_takes_the_others_out_and_joining_again_works(side, session):
    other = side()
    other.graph.add_node("robot", "/")
    seen_by(side, lambda graph: graph.nodes)
    for _ in range(2):
        join(session, 0, side.address)
        assert [node.full_name for node in session.graph(0).nodes] == ["/robot"]
        assert leave(session, 0) and session.graph(0).nodes == []
    assert not leave(session, 0)


def test_a_session_that_closes_leaves(side):
    other, session = side(), Session()
    join(session, 0, side.address)
    session.graph(0).add_node("guest", "/")
    other.until(lambda: other.names() == ["/guest"])
    session.close()
    other.until(lambda: other.names() == [])


def test_two_nodes_of_the_same_name_are_told_on_both_sides(side):
    one, two = side(), side()
    for each in (one, two):
        each.graph.add_node("talker", "/")
    for each in (one, two):
        assert "__node:=talker_2" in each.until_told("Two nodes are called /talker")
    assert "Two nodes are called /talker" in report(one.link)


def test_an_unknown_type_is_listed_and_it_is_said_what_to_build(side):
    here = side()
    here.link.visitors.came(UNKNOWN)
    assert here.graph.topics() == [("/thing", ["my_msgs/msg/Thing"])]
    said = report(here.link)
    assert "Unknown here: my_msgs/msg/Thing (/thing)" in said and "%colcon build --packages-select my_msgs" in said


def test_the_report_tells_who_is_there_and_what_is_carried(side):
    one, two = side(), side()
    inbox = Inbox(two.graph.add_node("listener", "/").subscription("/chatter", String, Qos()))
    publisher = one.graph.add_node("talker", "/").publisher("/chatter", String, Qos())
    one.until(lambda: publisher.targets)
    one.link.settle()
    two.until(lambda: hearers(two) == [inbox.source])
    two.link.settle()
    publisher.publish(String(data="hello"))
    inbox.take()
    said = report(two.link)
    assert re.search(r"  /chatter  0.0 a second  1 message  \d+.\d ms on the way  from /talker  std_msgs/msg/String\b", said)
    assert "  /chatter  0.0 a second  1 message  from /talker  std_msgs/msg/String" in report(one.link)
    assert "Others: 1" in report(one.link) and "/listener" in report(one.link)
    assert report(None).startswith("No network")


def test_a_lost_link_is_told_and_comes_back_with_all_that_was_there():
    from .sides import Side

    address = f"tcp/127.0.0.1:{free_port()}"
    router = open_router([address])
    one, two = Side(address), Side(address)
    try:
        one.link.begin()
        two.link.begin()
        publisher = one.graph.add_node("talker", "/").publisher("/chatter", String, Qos())
        inbox = Inbox(two.graph.add_node("listener", "/").subscription("/chatter", String, Qos()))
        one.until(lambda: publisher.targets)
        router.close()
        two.until_told(f"The link to {address} is gone")
        two.until(lambda: two.names() == ["/listener"])
        one.until(lambda: not publisher.targets)
        one.link.settle()
        publisher.publish(String(data="while nobody could hear"))
        assert "THE LINK IS GONE" in report(two.link)
        router = open_router([address])
        two.until_told("is there again")
        one.until(lambda: publisher.targets)
        one.link.settle()
        two.until(lambda: hearers(two) == [inbox.source])
        two.link.settle()
        publisher.publish(String(data="after"))
        assert inbox.take()[0].data == "after" and inbox.source.take() is None
    finally:
        one.link.close()
        two.link.close()
        router.close()


def test_an_engine_that_is_not_installed_is_told(monkeypatch, session):
    monkeypatch.setitem(sys.modules, "zenoh", None)
    with pytest.raises(NoNetwork, match=r'pip install "coursekit\[network\]"'):
        join(session, 0, "127.0.0.1")
    assert joining.link_of(session, 0) is None and zenoh_session.OPEN_SECONDS < LIMIT


def test_a_call_that_never_returns_is_given_up():
    with pytest.raises(NoNetwork, match="no"):
        zenoh_session._within(threading.Event().wait, 0.01, "no")
