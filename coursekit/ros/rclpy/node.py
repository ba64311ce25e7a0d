"""Nodes: the participants of the graph, with publishers, subscriptions, services, timers and parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Log, ParameterDescriptor, ParameterEvent

from coursekit.processes.components import take_for_first_node
from coursekit.processes.process import current_process
from rclpy import _rclpy_pybind11 as _rclpy
from rclpy._lent import lender
from rclpy._node_entities import NodeEntities
from rclpy._node_graph import NodeGraph, core_qos
from rclpy._node_names import NodeNames
from rclpy._node_parameters import NodeParameters
from rclpy._qualified_names import one_class
from rclpy._rclpy_pybind11 import NodeNameNonExistentError
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock, ROSClock
from rclpy.duration import Duration
from rclpy.exceptions import (
    InvalidHandle,
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    NotInitializedException,
)
from rclpy.guard_condition import GuardCondition
from rclpy.impl.rcl_log import node_made
from rclpy.impl.rcutils_logger import add_rosout, remove_rosout
from rclpy.logging import get_logger
from rclpy.parameter import Parameter
from rclpy.parameter_service import ParameterService
from rclpy.publisher import Publisher
from rclpy.qos import (
    DurabilityPolicy,
    QoSProfile,
    qos_profile_parameter_events,
)
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.time_source import TimeSource
from rclpy.timer import Timer
from rclpy.utilities import get_default_context
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name

if TYPE_CHECKING:
    from rclpy.context import Context

__getattr__ = lender(__name__)  # names that programs import from here

HIDDEN_NODE_PREFIX = "_"
_ROSOUT_QOS = QoSProfile(
    depth=1000,
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    lifespan=Duration(seconds=10),
)


@one_class
class Node(NodeEntities, NodeNames, NodeParameters, NodeGraph):
    """A participant of the ROS graph.

    Its private names begin with `_rclpy_`, except those that Humble's nodes also have. A program's node inherits them, and
    may define names such as `_check`, `_graph` and `_publishers` itself.

    >>> class Counter(rclpy.node.Node):
    ...     def __init__(self):
    ...         super().__init__("counter")
    ...         self.count = 0
    ...         self.timer = self.create_timer(0.5, self.tick)
    ...
    ...     def tick(self):
    ...         self.count += 1
    >>> counter = Counter()
    >>> rclpy.spin_once(counter)
    >>> counter.count
    1
    """

    _rclpy_handle: Any

    def __init__(
        self,
        node_name: str,
        *,
        context: Context | None = None,
        cli_args: list[str] | None = None,
        namespace: str | None = None,
        use_global_arguments: bool = True,
        enable_rosout: bool = True,
        start_parameter_services: bool = True,
        parameter_overrides: list[Parameter] | None = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
    ) -> None:
        self._rclpy_handle = None
        self._context = get_default_context() if context is None else context
        self._parameters = {}
        self._descriptors = {}
        self._rclpy_publishers: list[Publisher] = []
        self._rclpy_subscriptions: list[Subscription] = []
        self._rclpy_clients: list[Client] = []
        self._rclpy_services: list[Service] = []
        self._rclpy_timers: list[Timer] = []
        self._rclpy_guards: list[GuardCondition] = []
        self._rclpy_waitables: list[Any] = []
        self._rclpy_rates: dict[Any, Timer] = {}
        self._rclpy_executor: Any = None
        self._default_callback_group = MutuallyExclusiveCallbackGroup()
        self._parameters_callbacks = []
        self._rclpy_pre_set_callbacks = []
        self._rclpy_post_set_callbacks = []
        self._rate_group: Any = None
        self._allow_undeclared_parameters = allow_undeclared_parameters
        if not self._context.ok():
            raise NotInitializedException("cannot create node")
        if component := take_for_first_node():  # as rclcpp_components creates the nodes of a container
            cli_args, use_global_arguments = [*component.arguments, "--", *(cli_args or [])], False
            parameter_overrides = [*(parameter_overrides or []), *component.parameters]
        self._rclpy_join_graph(node_name, namespace, cli_args, use_global_arguments)
        self._logger = get_logger(self._rclpy_handle.logger_name())
        self._clock = ROSClock()
        self._rclpy_rosout: Any = None
        if enable_rosout and self._rclpy_arguments.rosout_enabled:
            self._rclpy_start_rosout()
        self._parameter_event_publisher = self.create_publisher(
            ParameterEvent, "/parameter_events", qos_profile_parameter_events
        )
        self._rclpy_read_overrides(parameter_overrides, automatically_declare_parameters_from_overrides)
        self._time_source = TimeSource(node=self)
        self._time_source.attach_clock(self._clock)
        if start_parameter_services:
            self._parameter_service = ParameterService(self)

    # -- joining the graph

    def _rclpy_join_graph(
        self, node_name: str, namespace: str | None, cli_args: list[str] | None, use_global: bool
    ) -> None:
        self._rclpy_arguments = self._rclpy_read_arguments(cli_args, use_global)
        validate_node_name(node_name)
        given = namespace or ""
        namespace = "/" + given.removeprefix("/")
        validate_namespace(namespace)
        name = self._rclpy_arguments.node_name(node_name)
        namespace = self._rclpy_arguments.node_namespace(node_name, namespace)
        handle = self._context.handle
        node = handle.graph.add_node(name, namespace, current_process(), handle)
        self._rclpy_graph_node = node
        self._rclpy_handle = _rclpy.NodeHandle(node, self._rclpy_resolve, node.logger_name)
        node_made(name, given, handle.domain_id)

    def _rclpy_start_rosout(self) -> None:
        handle = _rclpy.Publisher(self._rclpy_handle, Log, "/rosout", core_qos(_ROSOUT_QOS))
        self._rclpy_rosout = handle.core
        add_rosout(self._logger.name, self._rclpy_publish_log)

    def _rclpy_publish_log(
        self, level: int, name: str, text: str, file: str, function: str, line: int, stamp_ns: int
    ) -> None:
        log = Log(level=level, name=name, msg=text, file=file, function=function, line=line)
        log.stamp.sec, log.stamp.nanosec = divmod(stamp_ns, 1_000_000_000)
        self._rclpy_rosout.publish(log)

    def _rclpy_read_overrides(self, given: list[Parameter] | None, declare: bool) -> None:
        values = self._rclpy_arguments.parameters_for(self.get_fully_qualified_name())
        self._parameter_overrides = {name: Parameter(name, value=value) for name, value in values.items()}
        self._parameter_overrides.update({parameter.name: parameter for parameter in given or ()})
        if declare:
            known = self._parameter_overrides.items()
            wanted = [(name, parameter.value, ParameterDescriptor(dynamic_typing=True)) for name, parameter in known]
            self.declare_parameters("", wanted, ignore_override=True)

    # -- properties

    @property
    def publishers(self) -> Iterator[Publisher]:
        """The publishers created by this node."""
        yield from list(self._rclpy_publishers)

    @property
    def subscriptions(self) -> Iterator[Subscription]:
        """The subscriptions created by this node."""
        yield from list(self._rclpy_subscriptions)

    @property
    def clients(self) -> Iterator[Client]:
        """The service clients created by this node."""
        yield from list(self._rclpy_clients)

    @property
    def services(self) -> Iterator[Service]:
        """The services created by this node."""
        yield from list(self._rclpy_services)

    @property
    def timers(self) -> Iterator[Timer]:
        """The timers created by this node."""
        yield from list(self._rclpy_timers)

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """The guard conditions created by this node."""
        yield from list(self._rclpy_guards)

    @property
    def waitables(self) -> Iterator[Any]:
        """The waitables added to this node."""
        yield from list(self._rclpy_waitables)

    @property
    def context(self) -> Any:
        """The node's context."""
        return self._context

    def get_clock(self) -> Clock:
        """The node's clock: ROS time.

        >>> begin = node.get_clock().now()
        >>> timer = node.create_timer(2.0, lambda: None)
        >>> rclpy.spin_once(node)
        >>> (node.get_clock().now() - begin).nanoseconds
        2000000000
        """
        return self._clock

    def get_logger(self) -> Any:
        """The node's logger."""
        return self._logger

    # -- leaving

    def destroy_node(self) -> None:
        """Destroy the node and its entities; later calls have no effect."""
        if self._rclpy_handle is None or not self._rclpy_handle.valid:
            return
        if self.executor is not None:
            self.executor.wake()
        for rate in list(self._rclpy_rates):
            self.destroy_rate(rate)
        everything: tuple[tuple[Callable[[Any], bool], list[Any]], ...] = (
            (self.destroy_publisher, self._rclpy_publishers),
            (self.destroy_subscription, self._rclpy_subscriptions),
            (self.destroy_client, self._rclpy_clients),
            (self.destroy_service, self._rclpy_services),
            (self.destroy_timer, self._rclpy_timers),
            (self.destroy_guard_condition, self._rclpy_guards),
        )
        for destroy, kept in everything:
            for entity in list(kept):
                destroy(entity)
        if self._rclpy_rosout is not None:
            remove_rosout(self._logger.name)
        self._rclpy_handle.destroy_when_not_in_use()

    def __enter__(self) -> Node:
        return self

    def __exit__(self, *_error: object) -> None:
        self.destroy_node()


__all__ = [
    "HIDDEN_NODE_PREFIX",
    "InvalidHandle",
    "InvalidNamespaceException",
    "InvalidNodeNameException",
    "InvalidServiceNameException",
    "InvalidTopicNameException",
    "Node",
    "NodeNameNonExistentError",
]
