"""The part of Node that makes and destroys what belongs to it."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import Any

from rclpy import _rclpy_pybind11 as _rclpy
from rclpy._node_graph import core_qos
from rclpy.callback_groups import ReentrantCallbackGroup
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


class NodeEntities:
    """Publishers, subscriptions, services, clients, timers and the rest of a node."""

    _handle: Any
    _context: Any
    _clock: Clock
    _rate_group: Any
    _publishers: list[Publisher]
    _subscriptions: list[Subscription]
    _clients: list[Client]
    _services: list[Service]
    _timers: list[Timer]
    _guards: list[GuardCondition]
    _waitables: list[Any]
    _rates: dict[Any, Timer]
    _executor: Any
    _remap: Callable[[str, str], str]
    _checked: Callable[[str, str], str]
    _default_callback_group: Any

    @property
    def executor(self) -> Any:
        """The executor that serves it, or None."""
        return self._executor() if self._executor is not None else None

    @executor.setter
    def executor(self, new_executor: Any) -> None:
        old = self.executor
        if old is new_executor:
            return
        if old is not None:
            self._executor = None
            self._detach()
            old.remove_node(self)
        if new_executor is None:
            self._executor = None
        else:
            self._executor = weakref.ref(new_executor)
            new_executor.add_node(self)

    @property
    def default_callback_group(self) -> Any:
        """The group of everything that is made without one: mutually exclusive."""
        return self._default_callback_group

    @property
    def handle(self) -> Any:
        """The handle."""
        return self._handle

    def _own(self, kept: list[Any], entity: Any, group: Any) -> Any:
        group.add_entity(entity)
        kept.append(entity)
        executor = self.executor
        if executor is not None and self in executor.get_nodes():
            executor._attach(entity)
        return entity

    def _attach(self, executor: Any) -> None:
        for entity in self._entities():
            executor._attach(entity)

    def _detach(self) -> None:
        for entity in self._entities():
            for source in entity._sources():
                source.attach(None, None)

    def _entities(self) -> list[Any]:
        return [
            *self._timers,
            *self._subscriptions,
            *self._guards,
            *self._clients,
            *self._services,
            *self._waitables,
        ]

    def create_publisher(
        self,
        msg_type: Any,
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: Any = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher] = Publisher,
    ) -> Any:
        """Make a publisher; `qos_profile` may be just the queue's depth."""
        profile = _validated_qos(qos_profile)
        group = callback_group or self.default_callback_group
        check_is_valid_msg_type(msg_type)
        full = self._checked(topic, "topic")  # type: ignore[attr-defined]
        profile = self._overridden(Publisher, full, profile, qos_overriding_options)
        handle = _rclpy.Publisher(self.handle, msg_type, full, core_qos(profile))
        publisher = publisher_class(
            handle, msg_type, topic, profile, event_callbacks or PublisherEventCallbacks(), group
        )
        publisher._context_ok = self._context.ok
        entity_made("publisher", "topic", topic, self._remap(full, "topic"))
        self._publishers.append(publisher)
        for handler in publisher.event_handlers:
            self.add_waitable(handler)
        return publisher

    def create_subscription(
        self,
        msg_type: Any,
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: Any = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription:
        """Make a subscription; `callback(msg)` runs in the node's executor. `raw` gives it bytes."""
        profile = _validated_qos(qos_profile)
        group = callback_group or self.default_callback_group
        check_is_valid_msg_type(msg_type)
        full = self._checked(topic, "topic")  # type: ignore[attr-defined]
        profile = self._overridden(Subscription, full, profile, qos_overriding_options)
        handle = _rclpy.Subscription(self.handle, msg_type, full, core_qos(profile))
        subscription = Subscription(
            handle, msg_type, topic, callback, group, profile, raw, event_callbacks or SubscriptionEventCallbacks()
        )
        entity_made("subscription", "topic", topic, self._remap(full, "topic"))
        self._own(self._subscriptions, subscription, group)
        for handler in subscription.event_handlers:
            self.add_waitable(handler)
        return subscription

    def _overridden(
        self, kind: type, full_name: str, profile: QoSProfile, options: QoSOverridingOptions | None
    ) -> QoSProfile:
        if options is None:
            return profile
        copied = QoSProfile(**{name.lstrip("_"): getattr(profile, name) for name in profile.__slots__})
        _declare_qos_parameters(kind, self, self._remap(full_name, "topic"), copied, options)
        return copied

    def create_client(
        self,
        srv_type: Any,
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: Any = None,
    ) -> Client:
        """Make a service client."""
        group = callback_group or self.default_callback_group
        check_is_valid_srv_type(srv_type)
        full = self._checked(srv_name, "service")  # type: ignore[attr-defined]
        handle = _rclpy.Client(self.handle, srv_type, full, core_qos(qos_profile))
        entity_made("client", "service", srv_name, self._remap(full, "service"))
        client = Client(self._context, handle, srv_type, srv_name, qos_profile, group)
        return self._own(self._clients, client, group)

    def create_service(
        self,
        srv_type: Any,
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: Any = None,
    ) -> Service:
        """Make a service; `callback(request, response)` fills and returns the response."""
        group = callback_group or self.default_callback_group
        check_is_valid_srv_type(srv_type)
        full = self._checked(srv_name, "service")  # type: ignore[attr-defined]
        handle = _rclpy.Service(self.handle, srv_type, full, core_qos(qos_profile))
        entity_made("service", "service", srv_name, self._remap(full, "service"))
        service = Service(handle, srv_type, srv_name, callback, group, qos_profile)
        return self._own(self._services, service, group)

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[..., Any] | None,
        callback_group: Any = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Make a timer that calls back every `timer_period_sec` seconds."""
        group = callback_group or self.default_callback_group
        period_ns = int(float(timer_period_sec) * 1_000_000_000)
        timer = Timer(
            callback, group, period_ns, clock or self._clock, context=self._context, autostart=autostart
        )
        self._own(self._timers, timer, group)
        timer._begin_period()
        return timer

    def create_guard_condition(self, callback: Callable[[], Any], callback_group: Any = None) -> GuardCondition:
        """Make a guard condition; its callback runs when it is triggered."""
        group = callback_group or self.default_callback_group
        return self._own(self._guards, GuardCondition(callback, group, context=self._context), group)

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Make a rate, whose `sleep` ends `frequency` times a second."""
        if frequency <= 0:
            raise ValueError("frequency must be > 0")
        self._rate_group = self._rate_group or ReentrantCallbackGroup()
        timer = self.create_timer(1.0 / frequency, None, self._rate_group, clock)
        rate = Rate(timer, context=self._context)
        self._rates[rate] = timer
        return rate

    def add_waitable(self, waitable: Any) -> None:
        """Have the executor serve a waitable."""
        self._own(self._waitables, waitable, waitable.callback_group)

    def remove_waitable(self, waitable: Any) -> None:
        """Serve it no more."""
        self._waitables.remove(waitable)
        for source in waitable._sources():
            source.attach(None, None)

    def _destroy(self, kept: list[Any], entity: Any) -> bool:
        if entity not in kept:
            return False
        kept.remove(entity)
        for handler in getattr(entity, "event_handlers", ()):
            if handler in self._waitables:
                self.remove_waitable(handler)
        for source in getattr(entity, "_sources", list)():
            source.attach(None, None)
        entity.destroy()
        return True

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """Destroy a publisher; False if it is not this node's."""
        return self._destroy(self._publishers, publisher)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """Destroy a subscription; False if it is not this node's."""
        return self._destroy(self._subscriptions, subscription)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client; False if it is not this node's."""
        return self._destroy(self._clients, client)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service; False if it is not this node's."""
        return self._destroy(self._services, service)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer; False if it is not this node's."""
        return self._destroy(self._timers, timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition; False if it is not this node's."""
        return self._destroy(self._guards, guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate; who sleeps in it wakes."""
        timer = self._rates.pop(rate, None)
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
