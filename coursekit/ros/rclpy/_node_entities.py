"""The part of Node that creates and destroys its entities."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy import _rclpy_pybind11 as _rclpy
from rclpy._node_graph import core_qos
from rclpy.callback_groups import CallbackGroup, ReentrantCallbackGroup
from rclpy.client import Client
from rclpy.clock import Clock
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.guard_condition import GuardCondition
from rclpy.impl.rcl_log import entity_made
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile, qos_profile_services_default
from rclpy.qos_overriding_options import QoSOverridingOptions, _declare_qos_parameters
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.timer import Rate, Timer
from rclpy.type_support import check_is_valid_msg_type, check_is_valid_srv_type

if TYPE_CHECKING:
    from rclpy.executors import Executor


class NodeEntities:
    """Publishers, subscriptions, services, clients, timers and the rest of a node."""

    _rclpy_handle: Any
    _context: Any
    _clock: Clock
    _rate_group: Any
    _rclpy_publishers: list[Publisher]
    _rclpy_subscriptions: list[Subscription]
    _rclpy_clients: list[Client]
    _rclpy_services: list[Service]
    _rclpy_timers: list[Timer]
    _rclpy_guards: list[GuardCondition]
    _rclpy_waitables: list[Any]
    _rclpy_rates: dict[Any, Timer]
    _rclpy_executor: Any
    _rclpy_remap: Callable[[str, str], str]
    _rclpy_checked: Callable[[str, str], str]
    _default_callback_group: Any

    @property
    def executor(self) -> Any:
        """The executor that serves this node, or None."""
        return self._rclpy_executor() if self._rclpy_executor is not None else None

    @executor.setter
    def executor(self, new_executor: Any) -> None:
        old = self.executor
        if old is new_executor:
            return
        if old is not None:
            self._rclpy_executor = None
            self._rclpy_detach()
            old.remove_node(self)
        if new_executor is None:
            self._rclpy_executor = None
        else:
            self._rclpy_executor = weakref.ref(new_executor)
            new_executor.add_node(self)

    @property
    def default_callback_group(self) -> Any:
        """The callback group of all entities that are created without one: mutually exclusive."""
        return self._default_callback_group

    @property
    def handle(self) -> Any:
        """The node's handle."""
        return self._rclpy_handle

    def _rclpy_own(self, kept: list[Any], entity: Any, group: Any) -> Any:
        group.add_entity(entity)
        kept.append(entity)
        executor = self.executor
        if executor is not None and self in executor.get_nodes():
            executor._attach(entity)
        return entity

    def _rclpy_attach(self, executor: Executor) -> None:
        for entity in self._rclpy_entities():
            executor._attach(entity)

    def _rclpy_detach(self) -> None:
        for entity in self._rclpy_entities():
            for source in entity._sources():
                source.attach(None, None)

    def _rclpy_entities(self) -> list[Any]:
        return [
            *self._rclpy_timers,
            *self._rclpy_subscriptions,
            *self._rclpy_guards,
            *self._rclpy_clients,
            *self._rclpy_services,
            *self._rclpy_waitables,
        ]

    def create_publisher(
        self,
        msg_type: type[Any],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher] = Publisher,
    ) -> Any:
        """Create a publisher; `qos_profile` may be just the queue depth.

        >>> from std_msgs.msg import String
        >>> publisher = node.create_publisher(String, "chatter", 10)
        >>> publisher.publish(String(data="hello"))
        >>> publisher.topic_name
        '/chatter'
        """
        profile = _validated_qos(qos_profile)
        group = callback_group or self.default_callback_group
        check_is_valid_msg_type(msg_type)
        full = self._rclpy_checked(topic, "topic")  # type: ignore[attr-defined]
        profile = self._rclpy_overridden(Publisher, full, profile, qos_overriding_options)
        handle = _rclpy.Publisher(self.handle, msg_type, full, core_qos(profile))
        publisher = publisher_class(
            handle, msg_type, topic, profile, event_callbacks or PublisherEventCallbacks(), group
        )
        publisher._context_ok = self._context.ok
        entity_made("publisher", "topic", topic, self._rclpy_remap(full, "topic"))
        self._rclpy_publishers.append(publisher)
        for handler in publisher.event_handlers:
            self.add_waitable(handler)
        return publisher

    def create_subscription(
        self,
        msg_type: type[Any],
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription:
        """Create a subscription; `callback(msg)` runs in the node's executor. With `raw`, it receives bytes.

        >>> from std_msgs.msg import String
        >>> subscription = node.create_subscription(String, "chatter", lambda msg: print(msg.data), 10)
        >>> node.create_publisher(String, "chatter", 10).publish(String(data="hello"))
        >>> rclpy.spin_once(node)
        hello
        """
        profile = _validated_qos(qos_profile)
        group = callback_group or self.default_callback_group
        check_is_valid_msg_type(msg_type)
        full = self._rclpy_checked(topic, "topic")  # type: ignore[attr-defined]
        profile = self._rclpy_overridden(Subscription, full, profile, qos_overriding_options)
        handle = _rclpy.Subscription(self.handle, msg_type, full, core_qos(profile))
        subscription = Subscription(
            handle, msg_type, topic, callback, group, profile, raw, event_callbacks or SubscriptionEventCallbacks()
        )
        entity_made("subscription", "topic", topic, self._rclpy_remap(full, "topic"))
        self._rclpy_own(self._rclpy_subscriptions, subscription, group)
        for handler in subscription.event_handlers:
            self.add_waitable(handler)
        return subscription

    def _rclpy_overridden(
        self, kind: type, full_name: str, profile: QoSProfile, options: QoSOverridingOptions | None
    ) -> QoSProfile:
        if options is None:
            return profile
        copied = QoSProfile(**{name.lstrip("_"): getattr(profile, name) for name in profile.__slots__})
        _declare_qos_parameters(kind, self, self._rclpy_remap(full_name, "topic"), copied, options)
        return copied

    def create_client(
        self,
        srv_type: type[Any],
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client:
        """Create a service client.

        >>> from example_interfaces.srv import AddTwoInts
        >>> client = node.create_client(AddTwoInts, "add_two_ints")
        >>> client.wait_for_service(timeout_sec=1.0)  # its server does not run
        False
        """
        group = callback_group or self.default_callback_group
        check_is_valid_srv_type(srv_type)
        full = self._rclpy_checked(srv_name, "service")  # type: ignore[attr-defined]
        handle = _rclpy.Client(self.handle, srv_type, full, core_qos(qos_profile))
        entity_made("client", "service", srv_name, self._rclpy_remap(full, "service"))
        client = Client(self._context, handle, srv_type, srv_name, qos_profile, group)
        return self._rclpy_own(self._rclpy_clients, client, group)

    def create_service(
        self,
        srv_type: type[Any],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service:
        """Create a service; `callback(request, response)` fills and returns the response.

        >>> from example_interfaces.srv import AddTwoInts
        >>> def add(request, response):
        ...     response.sum = request.a + request.b
        ...     return response
        >>> service = node.create_service(AddTwoInts, "add_two_ints", add)
        >>> future = node.create_client(AddTwoInts, "add_two_ints").call_async(AddTwoInts.Request(a=1, b=2))
        >>> rclpy.spin_until_future_complete(node, future)
        >>> future.result().sum
        3
        """
        group = callback_group or self.default_callback_group
        check_is_valid_srv_type(srv_type)
        full = self._rclpy_checked(srv_name, "service")  # type: ignore[attr-defined]
        handle = _rclpy.Service(self.handle, srv_type, full, core_qos(qos_profile))
        entity_made("service", "service", srv_name, self._rclpy_remap(full, "service"))
        service = Service(handle, srv_type, srv_name, callback, group, qos_profile)
        return self._rclpy_own(self._rclpy_services, service, group)

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[..., Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer that calls `callback` every `timer_period_sec` seconds.

        >>> timer = node.create_timer(0.5, lambda: print("tick"))
        >>> rclpy.spin_once(node)  # returns after half a second
        tick
        """
        group = callback_group or self.default_callback_group
        period_ns = int(float(timer_period_sec) * 1_000_000_000)
        timer = Timer(
            callback, group, period_ns, clock or self._clock, context=self._context, autostart=autostart
        )
        self._rclpy_own(self._rclpy_timers, timer, group)
        timer._begin_period()
        return timer

    def create_guard_condition(
        self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None
    ) -> GuardCondition:
        """Create a guard condition; its callback runs when it is triggered.

        >>> guard = node.create_guard_condition(lambda: print("triggered"))
        >>> guard.trigger()
        >>> rclpy.spin_once(node)
        triggered
        """
        group = callback_group or self.default_callback_group
        return self._rclpy_own(self._rclpy_guards, GuardCondition(callback, group, context=self._context), group)

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate; its `sleep` returns `frequency` times a second, while another thread spins the node.

        >>> import threading
        >>> spinning = threading.Thread(target=rclpy.spin, args=[node], daemon=True)
        >>> spinning.start()
        >>> rate = node.create_rate(2.0)
        >>> begin = node.get_clock().now()
        >>> rate.sleep()
        >>> (node.get_clock().now() - begin).nanoseconds
        500000000
        """
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        self._rate_group = self._rate_group or ReentrantCallbackGroup()
        timer = self.create_timer(1.0 / frequency, None, self._rate_group, clock)
        rate = Rate(timer, context=self._context)
        self._rclpy_rates[rate] = timer
        return rate

    def add_waitable(self, waitable: Any) -> None:
        """Have the executor serve a waitable."""
        self._rclpy_own(self._rclpy_waitables, waitable, waitable.callback_group)

    def remove_waitable(self, waitable: Any) -> None:
        """Stop serving a waitable."""
        self._rclpy_waitables.remove(waitable)
        for source in waitable._sources():
            source.attach(None, None)

    def _rclpy_destroy(self, kept: list[Any], entity: Any) -> bool:
        if entity not in kept:
            return False
        kept.remove(entity)
        for handler in getattr(entity, "event_handlers", ()):
            if handler in self._rclpy_waitables:
                self.remove_waitable(handler)
        for source in getattr(entity, "_sources", list)():
            source.attach(None, None)
        entity.destroy()
        return True

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """Destroy a publisher; False if it is not this node's."""
        return self._rclpy_destroy(self._rclpy_publishers, publisher)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """Destroy a subscription; False if it is not this node's."""
        return self._rclpy_destroy(self._rclpy_subscriptions, subscription)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client; False if it is not this node's."""
        return self._rclpy_destroy(self._rclpy_clients, client)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service; False if it is not this node's."""
        return self._rclpy_destroy(self._rclpy_services, service)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer; False if it is not this node's."""
        return self._rclpy_destroy(self._rclpy_timers, timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; False if it is not this node's."""
        return self._rclpy_destroy(self._rclpy_guards, guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate; threads that sleep in it wake up."""
        timer = self._rclpy_rates.pop(rate, None)
        if timer is None:
            return False
        self.destroy_timer(timer)
        rate.destroy()
        return True


def _validated_qos(qos: Any) -> QoSProfile:
    """A profile from a profile or a depth."""
    if isinstance(qos, QoSProfile):
        return qos
    if not isinstance(qos, int):
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos)!r}")
    if qos < 0:
        raise ValueError("history depth must be greater than or equal to zero")
    return QoSProfile(depth=qos)
