"""Programs' nodes have private names of their own: rclpy's nodes must not have the same ones here and others on a robot."""

import pytest
import rclpy
from nav2_simple_commander.robot_navigator import BasicNavigator
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from std_msgs.msg import String

from coursekit.processes.session import Session

HUMBLES = {
    "_allow_undeclared_parameters", "_clock", "_context", "_default_callback_group", "_descriptors", "_logger",
    "_managed_entities", "_parameter_event_publisher", "_parameter_overrides", "_parameter_service", "_parameters",
    "_parameters_callbacks", "_rate_group", "_service_change_state", "_service_get_available_states",
    "_service_get_available_transitions", "_service_get_state", "_service_get_transition_graph", "_state_machine",
    "_time_source", "_transition_event_publisher", "_amclPoseCallback", "_feedbackCallback", "_getPathImpl",
    "_setInitialPose", "_smoothPathImpl", "_waitForInitialPose", "_waitForNodeToActivate",
}  # fmt: skip
"""Private names that a node has in Humble, too."""


@pytest.fixture
def context():
    with Session(virtual=True).use() as session:
        own_context = rclpy.Context()
        rclpy.init(context=own_context)
        yield session, own_context
        rclpy.shutdown(context=own_context)


def private(names):
    return {name for name in names if name.startswith("_") and not name.startswith(("__", "_rclpy_", "_navigator_"))}


def test_a_node_has_no_private_names_but_humbles_and_its_own(context):
    for kind in (Node, LifecycleNode):
        node = kind("named", context=context[1])
        node.create_rate(1.0)
        assert private(dir(node)) - HUMBLES == set()


def test_a_navigator_has_no_names_but_humbles_and_its_own(context, monkeypatch):
    monkeypatch.setattr(rclpy.node, "get_default_context", lambda: context[1])
    navigator = BasicNavigator()
    assert private(dir(navigator)) - HUMBLES == set() and not hasattr(navigator, "action")


class Busy(Node):
    """A node with the names that programs use for what they keep and do."""

    def __init__(self, context):
        super().__init__("busy", context=context)
        self._publishers, self._clients, self._subscriptions, self._services, self._timers = {}, {}, [], {}, []
        self._graph, self._executor, self._rates, self._handle, self._entities, self._guards = {}, None, {}, 0, (), None
        self._publishers["out"] = self.create_publisher(String, "out", 1)
        self._subscriptions.append(self.create_subscription(String, "out", self._check, 1))
        self._timers.append(self.create_timer(0.1, self._apply))
        self.declare_parameter("speed", 1.0)
        self.heard = 0

    def _check(self, _msg):
        self.heard += 1

    def _apply(self):
        self._publishers["out"].publish(String(data="x"))
        self._set("speed", 2.0)

    def _set(self, name, value):
        self.set_parameters([rclpy.Parameter(name, value=value)])

    def _unknown(self, *wrong):
        raise AssertionError(f"rclpy called a method of the program with {wrong}")

    _resolve = _remap = _declare = _store = _remember = _attach = _detach = _destroy = _own = _tell = _checked = _unknown


def test_a_node_that_uses_such_names_works(context):
    session, own_context = context
    node, executor = Busy(own_context), rclpy.executors.SingleThreadedExecutor(context=own_context)
    executor.add_node(node)
    until = session.clock.steady() + 10**9
    while session.clock.steady() < until:
        executor.spin_once(timeout_sec=0.05)
    assert node.heard >= 9 and node.get_parameter("speed").value == 2.0
    assert len(list(node.publishers)) >= 2 and len(list(node.timers)) == 1
    node.destroy_node()
