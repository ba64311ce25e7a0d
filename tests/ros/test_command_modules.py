"""What programs and tests import of the commands: the Python modules behind `ros2`."""

import argparse
import importlib
import threading

import pytest
import rclpy
import rclpy.action
import test_msgs.action
import test_msgs.msg
import test_msgs.srv
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from ros2cli.node.daemon import DaemonNode, is_daemon_running, shutdown_daemon, spawn_daemon
from ros2cli.node.direct import DirectNode
from ros2cli.node.strategy import NodeStrategy

from coursekit.processes.session import Session

MODULES = """ros2action.api ros2bag.api ros2cli.cli ros2cli.command ros2cli.daemon ros2cli.helpers ros2cli.node ros2cli.verb
ros2component.api ros2doctor.api ros2doctor.api.topic ros2interface.api
ros2lifecycle.api ros2multicast.api ros2node.api ros2param.api ros2pkg.api
ros2launch.api ros2run.api ros2service.api ros2topic.api"""


@pytest.fixture
def session():
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


@pytest.fixture
def node(session):
    """A node with one of everything."""
    context = rclpy.context.Context()
    rclpy.init(context=context)
    test_node = rclpy.create_node("test_node", namespace="/test", context=context)
    keeps_all = QoSProfile(history=HistoryPolicy.KEEP_ALL)
    test_node.create_publisher(test_msgs.msg.Empty, "/test/topic", keeps_all)
    test_node.create_subscription(test_msgs.msg.Empty, "/test/topic", print, 8)
    test_node.create_service(test_msgs.srv.Empty, "/test/service", print)
    test_node.create_client(test_msgs.srv.Empty, "/test/service")
    rclpy.action.ActionServer(test_node, test_msgs.action.Fibonacci, "/test/action", print)
    rclpy.action.ActionClient(test_node, test_msgs.action.Fibonacci, "/test/action")
    yield test_node
    rclpy.shutdown(context=context)


@pytest.mark.parametrize("name", MODULES.split())
def test_it_can_be_imported(name):
    importlib.import_module(name)


def test_the_daemon_is_stopped_and_started(session):
    assert is_daemon_running([]) and not spawn_daemon([])
    assert shutdown_daemon([], timeout=5.0) and not is_daemon_running([]) and not shutdown_daemon([])
    assert spawn_daemon([], timeout=5.0) and is_daemon_running([])
    assert [daemon_node.name.startswith("_ros2cli_daemon_0_") for daemon_node in session.graph(0).nodes] == [True]
    assert shutdown_daemon([]) and not session.graph(0).nodes


def test_the_strategy_takes_the_daemon_where_one_runs(session):
    shutdown_daemon([])
    with NodeStrategy([]) as strategy:
        assert strategy._daemon_node is None and strategy._direct_node is not None
    assert is_daemon_running([])  # for the next command
    with NodeStrategy([]) as strategy:
        assert strategy._daemon_node is not None and strategy._direct_node is None
    with NodeStrategy(argparse.Namespace(no_daemon=True)) as strategy:
        assert strategy._daemon_node is None and strategy._direct_node is not None
    assert not rclpy.ok()


def test_the_daemon_answers_in_lists(node):
    topic = ["/test/topic", ["test_msgs/msg/Empty"]]
    service = ["/test/service", ["test_msgs/srv/Empty"]]
    action = ["/test/action", ["test_msgs/action/Fibonacci"]]
    with DaemonNode([]) as daemon:
        assert daemon.connected and "daemon" in daemon.get_name() and daemon.get_namespace() == "/"
        assert ["test_node", "/test"] in daemon.get_node_names_and_namespaces()
        assert ["test_node", "/test", "/"] in daemon.get_node_names_and_namespaces_with_enclaves()
        assert topic in daemon.get_topic_names_and_types() and service in daemon.get_service_names_and_types()
        for kind, expected in (("publisher", topic), ("subscriber", topic), ("service", service), ("client", service)):
            assert expected in getattr(daemon, f"get_{kind}_names_and_types_by_node")("test_node", "/test")
        for kind in ("server", "client"):
            assert action in getattr(daemon, f"get_action_{kind}_names_and_types_by_node")("test_node", "/test")
        (info,) = daemon.get_publishers_info_by_topic("/test/topic")
        assert info.node_name == "test_node" and info.qos_profile.history == HistoryPolicy.KEEP_ALL
        assert daemon.count_publishers("/test/topic") == daemon.count_subscribers("/test/topic") == 1
        with pytest.raises(AttributeError, match="it has .*get_name"):
            daemon.get_nothing()


def test_topics_with_one_end_only_are_warned_of(session):
    from ros2doctor.api.topic import TopicCheck, TopicReport

    assert TopicReport().report().items == [("topic", "none"), ("publisher count", 0), ("subscriber count", 0)]
    context = rclpy.context.Context()
    rclpy.init(context=context)
    one_sided = rclpy.create_node("one_sided", context=context)
    one_sided.create_publisher(test_msgs.msg.Empty, "/alone", 1)
    assert TopicReport().report().items == [("topic", "/alone"), ("publisher count", 1), ("subscriber count", 0)]
    report = TopicCheck().check()
    assert (report.error, report.warning) == (0, 1)
    rclpy.shutdown(context=context)


def test_nodes_and_what_they_do(node):
    from ros2node import api

    with DirectNode([]) as asking:
        assert api.get_node_names(node=asking) == [("test_node", "/test", "/test/test_node")]
        assert len(api.get_node_names(node=asking, include_hidden_nodes=True)) == 2
        assert ("/test/topic", ["test_msgs/msg/Empty"]) in api.get_publisher_info(
            node=asking, remote_node_name="/test/test_node"
        )
        assert api.get_action_server_info(node=asking, remote_node_name="test/test_node")[0].name == "/test/action"


def test_actions_and_who_calls_them(node):
    from ros2action.api import get_action_class, get_action_clients_and_servers, get_action_names

    with DirectNode(None) as asking:
        assert get_action_names(node=asking) == ["/test/action"]
        ends = get_action_clients_and_servers(node=asking, action_name="/test/action")
        assert ends == ([("/test/test_node", ["test_msgs/action/Fibonacci"])],) * 2
        assert get_action_clients_and_servers(node=asking, action_name="/none") == ([], [])
        assert get_action_class(asking, "/test/action") is test_msgs.action.Fibonacci


def test_classes_of_topics_and_services(node, capsys):
    from ros2service.api import get_service_class
    from ros2topic.api import get_msg_class

    with DirectNode([]) as asking:
        assert get_msg_class(asking, "/test/topic") is test_msgs.msg.Empty
        assert get_service_class(asking, "/test/service") is test_msgs.srv.Empty
        assert get_msg_class(asking, "/none") is None
        with pytest.raises(RuntimeError, match="must not contain"):
            get_msg_class(asking, "a b")
    assert capsys.readouterr().out == "WARNING: topic [/none] does not appear to be published yet\n"


def test_a_preset_with_changes_leaves_the_preset_alone():
    from ros2topic.api import qos_profile_from_short_keys

    profile = qos_profile_from_short_keys("sensor_data", reliability="reliable", durability="transient_local")
    assert (profile.reliability, profile.durability) == (ReliabilityPolicy.RELIABLE, DurabilityPolicy.TRANSIENT_LOCAL)
    assert qos_profile_sensor_data.reliability == ReliabilityPolicy.BEST_EFFORT


@pytest.mark.parametrize(
    "text, value",
    [("off", False), ("-1", -1), ("1.5", 1.5), ("[a, b]", ["a", "b"]), ("[1, a]", "[1, a]"), ("!!str off", "off")],
)
def test_texts_become_parameters_as_in_yaml(text, value):
    from ros2param.api import get_parameter_value, get_value

    assert get_value(parameter_value=get_parameter_value(string_value=text)) == value


def test_a_datagram_comes_back():
    from ros2multicast.api import receive, send

    heard = []

    def listen():
        try:
            heard.append(receive(group="225.0.0.1", port=49152, timeout=10.0)[0])
        except OSError as error:  # a computer whose network takes none
            heard.append(error)

    listener = threading.Thread(target=listen)
    listener.start()
    while listener.is_alive():
        try:
            send(b"hello", group="225.0.0.1", port=49152)
        except OSError:
            pytest.skip("this computer's network sends no multicast")
        listener.join(0.01)
    assert heard == [b"hello"] or pytest.skip(f"this computer's network takes no multicast: {heard}")


def test_managed_nodes_are_asked_and_led(session):
    from lifecycle_msgs.msg import Transition
    from rclpy.lifecycle import LifecycleNode
    from ros2lifecycle import api

    def main():
        rclpy.init()
        rclpy.spin(LifecycleNode("robot"))

    def ask():
        with DirectNode([]) as asking:
            assert [node_name.full_name for node_name in api.get_node_names(node=asking)] == ["/robot"]
            assert api.call_get_states(node=asking, node_names=["/robot", "/none"])["/none"] is None
            transition = Transition(id=Transition.TRANSITION_CONFIGURE)
            assert api.call_change_states(node=asking, transitions={"/robot": transition}) == {"/robot": True}
            assert api.call_get_states(node=asking, node_names=["/robot"])["/robot"].label == "inactive"
            transitions = api.call_get_available_transitions(node=asking, states={"/robot": None})["/robot"]
            assert {description.transition.label for description in transitions} == {"cleanup", "activate", "shutdown"}

    robot = session.start(main, name="robot")
    session.clock.sleep(1.0)
    asking = session.start(ask, name="ask")
    assert asking.wait() == 0, asking.output
    robot.interrupt()
    robot.wait()
