"""QoS events: callbacks for a missed deadline, a publisher that falls silent, or two incompatible endpoints."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from coursekit.core import status as core_status
from rclpy._rclpy_pybind11 import Handle, UnsupportedEventTypeError
from rclpy.logging import get_logger
from rclpy.qos import QoSPolicyKind, qos_policy_name_from_kind
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from rclpy._wait_set import WaitSet
    from rclpy.callback_groups import CallbackGroup


@dataclass
class QoSRequestedDeadlineMissedInfo:
    """A subscription's deadline was missed."""

    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSOfferedDeadlineMissedInfo:
    """A publisher's deadline was missed."""

    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSLivelinessLostInfo:
    """A publisher's lease expired."""

    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSLivelinessChangedInfo:
    """Publishers of a subscription came, went, or fell silent."""

    alive_count: int = 0
    not_alive_count: int = 0
    alive_count_change: int = 0
    not_alive_count_change: int = 0


@dataclass
class QoSMessageLostInfo:
    """Messages were lost."""

    total_count: int = 0
    total_count_change: int = 0


@dataclass
class QoSRequestedIncompatibleQoSInfo:
    """A publisher offers less than a subscription requests."""

    total_count: int = 0
    total_count_change: int = 0
    last_policy_kind: QoSPolicyKind = QoSPolicyKind.INVALID


QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo


@dataclass
class QoSSubscriptionMatchedInfo:
    """Matched publishers came or went."""

    total_count: int = 0
    total_count_change: int = 0
    current_count: int = 0
    current_count_change: int = 0


QoSPublisherMatchedInfo = QoSSubscriptionMatchedInfo


class QoSPublisherEventType(IntEnum):
    """Events of publishers."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class QoSSubscriptionEventType(IntEnum):
    """Events of subscriptions."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


def _counts(info: Callable[..., Any]) -> Callable[[dict[str, Any]], Any]:
    return lambda taken: info(taken["total"], taken["change"])


def _incompatible(taken: dict[str, Any]) -> Any:
    return QoSRequestedIncompatibleQoSInfo(
        taken["total"], taken["change"], QoSPolicyKind(taken["last_policy"])
    )


def _liveliness(taken: dict[str, Any]) -> Any:
    return QoSLivelinessChangedInfo(
        taken["total"], taken["not_alive"], taken["change"], taken["not_alive_change"]
    )


def _matched(taken: dict[str, Any]) -> Any:
    change = taken["change"]
    return QoSSubscriptionMatchedInfo(taken["total"], max(0, change), taken["total"], change)


_KINDS: dict[Any, tuple[str, Callable[[dict[str, Any]], Any]]] = {
    ("p", 0): (core_status.DEADLINE, _counts(QoSOfferedDeadlineMissedInfo)),
    ("p", 1): (core_status.LIVELINESS, _counts(QoSLivelinessLostInfo)),
    ("p", 2): (core_status.INCOMPATIBLE, _incompatible),
    ("p", 4): (core_status.MATCHED, _matched),
    ("s", 0): (core_status.DEADLINE, _counts(QoSRequestedDeadlineMissedInfo)),
    ("s", 1): (core_status.LIVELINESS, _liveliness),
    ("s", 2): (core_status.INCOMPATIBLE, _incompatible),
    ("s", 3): (core_status.MESSAGE_LOST, _counts(QoSMessageLostInfo)),
    ("s", 5): (core_status.MATCHED, _matched),
}


class QoSEvent(Handle):
    """One kind of event of one endpoint; UnsupportedEventTypeError if the endpoint has no such event."""

    def __init__(self, parent: Any, event_type: Any) -> None:
        side = "p" if isinstance(event_type, QoSPublisherEventType) else "s"
        if (side, int(event_type)) not in _KINDS:
            raise UnsupportedEventTypeError(f"Failed to create event: {event_type!r} is not supported")
        kind, self._read = _KINDS[side, int(event_type)]
        super().__init__(parent.core.status(kind))

    def take_event(self) -> Any:
        """The changes since the last call."""
        return self._read(self.core.take())


class EventHandler(Waitable):
    """Calls a callback on one kind of event of one endpoint."""

    def __init__(
        self, *, callback_group: CallbackGroup, callback: Callable[[Any], Any], event_type: Any, parent_impl: Any
    ) -> None:
        super().__init__(callback_group)
        self.event_type = event_type
        self.callback = callback
        self._event = QoSEvent(parent_impl, event_type)

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Whether an event has occurred."""
        return self._event.core.has_work()

    def take_data(self) -> Any:
        """The event."""
        return self._event.take_event()

    async def execute(self, taken_data: Any) -> None:
        """Run the callback."""
        from rclpy.executors import await_or_execute

        await await_or_execute(self.callback, taken_data)

    def get_num_entities(self) -> NumberOfEntities:
        """One event."""
        return NumberOfEntities(num_events=1)

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Add the event."""
        wait_set.add_event(self._event)

    def destroy(self) -> None:
        """Invalidate the event and detach it from the executor."""
        self._event.valid = False
        self._event.core.attach(None, None)


QoSEventHandler = EventHandler


def _warn(logger_name: str, text: str) -> Callable[[Any], None]:
    def callback(event: Any) -> None:
        policy = qos_policy_name_from_kind(event.last_policy_kind)
        get_logger(logger_name).warn(text.format(policy))

    return callback


class _EventCallbacks:
    """The common part of publishers and subscriptions."""

    _warning = ""
    _names: tuple[tuple[str, Any], ...] = ()
    use_default_callbacks = True

    def create_event_handlers(self, callback_group: CallbackGroup, handle: Any, topic_name: str) -> list[EventHandler]:
        """The handlers of the given callbacks, and of the default callback."""
        handlers = []
        for name, event_type in self._names:
            callback = getattr(self, name)
            if callback is None and name == "incompatible_qos" and self.use_default_callbacks:
                logger_name = handle.core.node.logger_name
                callback = _warn(logger_name, self._warning.replace("TOPIC", topic_name))
            if callback is not None:
                handlers.append(
                    EventHandler(
                        callback_group=callback_group, callback=callback, event_type=event_type, parent_impl=handle
                    )
                )
        return handlers


class SubscriptionEventCallbacks(_EventCallbacks):
    """Callbacks for the events of a subscription."""

    _warning = (
        "New publisher discovered on topic 'TOPIC', offering incompatible QoS. No messages will be received "
        "from it. Last incompatible policy: {}"
    )
    _names = (
        ("deadline", QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED),
        ("incompatible_qos", QoSSubscriptionEventType.RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS),
        ("liveliness", QoSSubscriptionEventType.RCL_SUBSCRIPTION_LIVELINESS_CHANGED),
        ("message_lost", QoSSubscriptionEventType.RCL_SUBSCRIPTION_MESSAGE_LOST),
        ("matched", QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED),
    )

    def __init__(
        self,
        *,
        deadline: Callable[[Any], Any] | None = None,
        incompatible_qos: Callable[[Any], Any] | None = None,
        liveliness: Callable[[Any], Any] | None = None,
        message_lost: Callable[[Any], Any] | None = None,
        matched: Callable[[Any], Any] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.incompatible_qos = incompatible_qos
        self.liveliness = liveliness
        self.message_lost = message_lost
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks


class PublisherEventCallbacks(_EventCallbacks):
    """Callbacks for the events of a publisher."""

    _warning = (
        "New subscription discovered on topic 'TOPIC', requesting incompatible QoS. No messages will be sent "
        "to it. Last incompatible policy: {}"
    )
    _names = (
        ("deadline", QoSPublisherEventType.RCL_PUBLISHER_OFFERED_DEADLINE_MISSED),
        ("liveliness", QoSPublisherEventType.RCL_PUBLISHER_LIVELINESS_LOST),
        ("incompatible_qos", QoSPublisherEventType.RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS),
        ("matched", QoSPublisherEventType.RCL_PUBLISHER_MATCHED),
    )

    def __init__(
        self,
        *,
        deadline: Callable[[Any], Any] | None = None,
        liveliness: Callable[[Any], Any] | None = None,
        incompatible_qos: Callable[[Any], Any] | None = None,
        matched: Callable[[Any], Any] | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.incompatible_qos = incompatible_qos
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks
