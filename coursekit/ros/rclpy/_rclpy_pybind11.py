"""The names of rclpy's C module that programs use, in plain Python over `coursekit.core`."""

from __future__ import annotations

from typing import Any

from coursekit.core.ready_queue import Source
from coursekit.core.time_base import TimeBase
from coursekit.core.timer import Timer as CoreTimer
from coursekit.processes.session import current
from rclpy._one_type import TOPIC_ENDS, check_type
from rclpy._rclpy_info import RequestInfo, as_bytes, message_info, service_info
from rclpy._rclpy_names import ClockChange as ClockChange
from rclpy._rclpy_names import ClockType as ClockType
from rclpy._rclpy_names import InvalidHandle as InvalidHandle
from rclpy._rclpy_names import NodeNameNonExistentError as NodeNameNonExistentError
from rclpy._rclpy_names import RCLError as RCLError
from rclpy._rclpy_names import RCLInvalidROSArgsError as RCLInvalidROSArgsError
from rclpy._rclpy_names import RMWError as RMWError
from rclpy._rclpy_names import SignalHandlerOptions as SignalHandlerOptions
from rclpy._rclpy_names import TimerCancelledError as TimerCancelledError
from rclpy._rclpy_names import UnknownROSArgsError as UnknownROSArgsError
from rclpy._rclpy_names import UnsupportedEventTypeError as UnsupportedEventTypeError
from rclpy._wait_set import WaitSet as WaitSet


class Handle:
    """The type of `entity.handle`: valid until destroyed, usable in a `with` block."""

    def __init__(self, core: Any) -> None:
        self.core = core
        self.valid = True

    def __enter__(self) -> Any:
        self.check()
        return self

    def __exit__(self, *_error: object) -> None:
        """Nothing is held."""

    def check(self) -> None:
        """Raise InvalidHandle once destroyed."""
        if not self.valid:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")

    def destroy_when_not_in_use(self) -> None:
        """Destroy it."""
        if self.valid:
            self.valid = False
            self.close()

    def close(self) -> None:
        """Called once, on destruction."""
        if hasattr(self.core, "close"):
            self.core.close()

    @property
    def pointer(self) -> int:
        """A unique number."""
        return id(self)


class GuardCondition(Handle):
    """A flag that wakes an executor."""

    def __init__(self, context: Any = None) -> None:
        super().__init__(FlagSource())

    def trigger_guard_condition(self) -> None:
        """Raise the flag."""
        self.check()
        self.core.raise_flag()


class FlagSource(Source):
    """A source that is ready once its flag was raised."""

    __slots__ = ("raised",)

    def __init__(self) -> None:
        super().__init__()
        self.raised = False

    def has_work(self) -> bool:
        return self.raised

    def raise_flag(self) -> None:
        self.raised = True
        self.signal()

    def take(self) -> bool:
        raised, self.raised = self.raised, False
        return raised


class Clock(Handle):
    """A clock's handle."""

    def __init__(self, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        super().__init__(TimeBase(int(clock_type), current().clock))
        self.clock_type = clock_type


class Timer(Handle):
    """A timer's handle, with the methods that waitables call."""

    def __init__(self, clock: Any, context: Any, period_nanoseconds: int, *_more: Any) -> None:
        super().__init__(CoreTimer(clock.core, period_nanoseconds))
        self.clock = clock

    def is_timer_ready(self) -> bool:
        """Whether the timer is due."""
        return self.core.has_work()

    def is_timer_canceled(self) -> bool:
        """Whether it was cancelled."""
        return self.core.canceled

    def call_timer(self) -> None:
        """Count a call."""
        self.core.call()

    def cancel_timer(self) -> None:
        """Cancel the timer."""
        self.core.cancel()

    def reset_timer(self) -> None:
        """Restart the period."""
        self.core.reset()

    def time_until_next_call(self) -> int | None:
        """Nanoseconds until the next call; None when cancelled."""
        return self.core.time_until_next_call()

    def time_since_last_call(self) -> int:
        """Nanoseconds since the last call."""
        return self.core.base.now() - self.core.last

    def get_timer_period(self) -> int:
        """The period [ns]."""
        return self.core.period

    def change_timer_period(self, period_nanoseconds: int) -> None:
        """Set the period [ns] from the next call on."""
        self.core.period = period_nanoseconds

    def close(self) -> None:
        self.core.cancel()


class Endpoint(Handle):
    """The handle of a publisher, subscription, service or client."""

    def get_topic_name(self) -> str:
        """The resolved name."""
        return self.core.name

    @property
    def name(self) -> str:
        """The resolved service name."""
        return self.core.name


def _qos_of(profile: Any) -> Any:
    if not hasattr(profile, "get_c_qos_profile"):
        return profile
    from rclpy._node_graph import core_qos

    return core_qos(profile)


class Publisher(Endpoint):
    """Sends on a topic."""

    def __init__(self, node: Any, msg_type: Any, topic: str, qos: Any) -> None:
        super().__init__(node.core.publisher(node.name_for("publisher", topic, msg_type), msg_type, _qos_of(qos)))

    def publish(self, msg: Any) -> None:
        """Send a copy."""
        self.check()
        self.core.publish(msg)


class Subscription(Endpoint):
    """Receives from a topic."""

    def __init__(self, node: Any, msg_type: Any, topic: str, qos: Any, *_more: Any) -> None:
        super().__init__(node.core.subscription(node.name_for("subscription", topic, msg_type), msg_type, _qos_of(qos)))

    def take_message(self, msg_type: Any = None, raw: bool = False) -> tuple[Any, dict[str, Any]] | None:
        """The oldest message and its info; None when there is none."""
        self.check()
        entry = self.core.take()
        if entry is None:
            return None
        msg = as_bytes(entry[0]) if raw else entry[0]
        return msg, message_info(entry)


class Service(Endpoint):
    """Answers requests."""

    def __init__(self, node: Any, srv_type: Any, name: str, qos: Any) -> None:
        super().__init__(node.core.server(node.name_for("service", name, srv_type), srv_type, _qos_of(qos)))

    def service_take_request(self, _request_type: Any = None) -> tuple[Any, Any]:
        """The oldest request and its header; (None, None) when there is none."""
        self.check()
        taken = self.core.take()
        return (None, None) if taken is None else (taken[0], service_info(taken[1]))

    def service_send_response(self, response: Any, header: Any) -> None:
        """Answer the request that `header` identifies."""
        self.check()
        self.core.respond(getattr(header, "request_id", header), response)


class Client(Endpoint):
    """Sends requests."""

    def __init__(self, node: Any, srv_type: Any, name: str, qos: Any) -> None:
        super().__init__(node.core.client(node.name_for("client", name, srv_type), srv_type, _qos_of(qos)))

    def send_request(self, request: Any) -> int:
        """Send a copy; return the request's number."""
        self.check()
        return self.core.send(request)

    def service_server_is_available(self) -> bool:
        """Whether the service has a server."""
        self.check()
        return self.core.server_is_ready()

    def take_response(self, _response_type: Any = None) -> tuple[Any, Any]:
        """(header, response); (None, None) when there is none."""
        self.check()
        taken = self.core.take()
        return (None, None) if taken is None else (service_info(RequestInfo(taken[0])), taken[1])


class NodeHandle(Handle):
    """A node's handle: its names, and how it resolves other names."""

    def __init__(self, core: Any, resolve: Any, logger_name: str) -> None:
        super().__init__(core)
        self.resolve = resolve
        self._logger_name = logger_name

    def name_for(self, kind: str, name: str, msg_type: Any) -> str:
        """The resolved name of a new endpoint, such as a "publisher"; RCLError if the name has another type."""
        resolved: str = self.resolve(name, "topic" if kind in TOPIC_ENDS else "service")
        check_type(self.core, kind, resolved, msg_type)
        return resolved

    def get_node_name(self) -> str:
        """The name."""
        self.check()
        return self.core.name

    def get_namespace(self) -> str:
        """The namespace."""
        self.check()
        return self.core.namespace

    def get_fully_qualified_name(self) -> str:
        """Namespace and name."""
        self.check()
        return self.core.full_name

    def logger_name(self) -> str:
        """For example 'robot1.camera'."""
        self.check()
        return self._logger_name


def __getattr__(name: str) -> Any:
    """Names defined in higher-level modules: functions, Humble's QoSEvent (later EventHandle) and the QoS profiles."""
    if name.startswith("rclpy_"):
        from rclpy import _rclpy_functions

        if hasattr(_rclpy_functions, name):
            return getattr(_rclpy_functions, name)
    if name in ("QoSEvent", "EventHandle"):
        from rclpy.event_handler import QoSEvent

        return QoSEvent
    if name == "rmw_qos_profile_t":
        from rclpy.qos import PredefinedProfiles

        return PredefinedProfiles
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
