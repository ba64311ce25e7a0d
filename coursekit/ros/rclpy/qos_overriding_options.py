"""QoS policies that parameters may override: `qos_overrides./topic.publisher.depth`. In ROS 2: the same module."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult

from rclpy import qos as _qos
from rclpy.duration import Duration
from rclpy.exceptions import ParameterAlreadyDeclaredException
from rclpy.qos import QoSPolicyKind, QoSProfile

if TYPE_CHECKING:
    from rclpy.node import Node

_CHOICES = {
    QoSPolicyKind.LIVELINESS: _qos.LivelinessPolicy,
    QoSPolicyKind.RELIABILITY: _qos.ReliabilityPolicy,
    QoSPolicyKind.HISTORY: _qos.HistoryPolicy,
    QoSPolicyKind.DURABILITY: _qos.DurabilityPolicy,
}
_DURATIONS = (QoSPolicyKind.LIFESPAN, QoSPolicyKind.DEADLINE, QoSPolicyKind.LIVELINESS_LEASE_DURATION)


QosCallbackResult = SetParametersResult
QosCallbackType = Callable[[QoSProfile], QosCallbackResult]


class InvalidQosOverridesError(Exception):
    """The validation callback refused the profile with its overrides."""


class QoSOverridingOptions:
    """The policies of an entity that become read-only parameters of its node.

    `callback` accepts or refuses the resulting profile by returning a SetParametersResult. `entity_id` distinguishes
    two publishers (or subscriptions) of the same topic.
    """

    def __init__(
        self,
        policy_kinds: Iterable[QoSPolicyKind],
        *,
        callback: QosCallbackType | None = None,
        entity_id: str | None = None,
    ) -> None:
        self._policy_kinds = policy_kinds
        self._callback = callback
        self._entity_id = entity_id

    @property
    def policy_kinds(self) -> Iterable[QoSPolicyKind]:
        """The policies that get a parameter."""
        return self._policy_kinds

    @property
    def callback(self) -> QosCallbackType | None:
        """The function that accepts or refuses the profile."""
        return self._callback

    @property
    def entity_id(self) -> str | None:
        """The word that distinguishes entities of one topic."""
        return self._entity_id

    @classmethod
    def with_default_policies(
        cls, *, callback: QosCallbackType | None = None, entity_id: str | None = None
    ) -> QoSOverridingOptions:
        """Return options for history, depth and reliability."""
        kinds = (QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY)
        return cls(kinds, callback=callback, entity_id=entity_id)


def _declare_qos_parameters(
    entity_type: type, node: Any, topic_name: str, qos: QoSProfile, options: QoSOverridingOptions
) -> None:
    """Declare the parameters of a publisher or subscription and apply their values to `qos`.

    `entity_type` is Publisher or Subscription or derived from one. Raises TypeError for another class,
    InvalidQosOverridesError if the callback refuses the profile, and RuntimeError for an unknown word.
    """
    kind = _entity_name(entity_type)
    suffix = "" if options.entity_id is None else f"_{options.entity_id}"
    whose = f"for {kind} `{topic_name}` with id `{options.entity_id}`"
    for policy in options.policy_kinds:
        if policy is QoSPolicyKind.LIFESPAN and kind == "subscription":
            continue
        word = policy.name.lower()
        name = f"qos_overrides.{topic_name}.{kind}{suffix}.{word}"
        descriptor = ParameterDescriptor(description=f"{word} {whose}", read_only=True)
        setattr(
            qos, word, _from_parameter(policy, _declared(node, name, _get_qos_policy_parameter(qos, policy), descriptor))
        )
    if options.callback is not None:
        verdict = options.callback(qos)
        if not verdict.successful:
            raise InvalidQosOverridesError(f"Provided QoS overrides {whose}, are not valid: {verdict.reason}")


def _entity_name(entity_type: type) -> str:
    from rclpy.publisher import Publisher
    from rclpy.subscription import Subscription

    if issubclass(entity_type, Publisher):
        return "publisher"
    if issubclass(entity_type, Subscription):
        return "subscription"
    raise TypeError("Argument `entity_type` should be a subclass of Publisher or Subscription")


def _declared(node: Node, name: str, value: Any, descriptor: ParameterDescriptor) -> Any:
    try:
        return node.declare_parameter(name, value, descriptor).value
    except ParameterAlreadyDeclaredException:
        return node.get_parameter(name).value


def _get_qos_policy_parameter(qos: QoSProfile, policy: QoSPolicyKind) -> Any:
    value = getattr(qos, policy.name.lower())
    if policy in _DURATIONS:
        return value.nanoseconds
    if policy not in _CHOICES:
        return value
    if value.short_key == "unknown":
        raise ValueError("User provided QoS profile is invalid")
    return value.short_key


def _from_parameter(policy: QoSPolicyKind, value: Any) -> Any:
    if policy in _DURATIONS:
        return Duration(nanoseconds=value)
    if policy not in _CHOICES:
        return value
    try:
        return _CHOICES[policy][value.upper()]
    except KeyError:
        known = ", ".join(_CHOICES[policy].short_keys())
        text = f"Unexpected QoS override for policy `{policy.name.lower()}`: `{value}` (known: {known})"
        raise RuntimeError(text) from None
