"""Quality of service in bags: as text in the metadata, as a recorder's request and as a player's offer."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

from coursekit.bag.errors import BagError
from coursekit.bag.metadata_file import dump, load_yaml

DEFAULT_DEPTH = 10
_DURATIONS = ("deadline", "lifespan", "liveliness_lease_duration")
_POLICIES: dict[str, Any] = {
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}
_INFINITE = 2**63 - 1
_SAME = ("reliability", "durability", "deadline", "liveliness", "liveliness_lease_duration")


def default_profile(**policies: Any) -> QoSProfile:
    """A reliable, volatile profile that keeps the last ten messages; arguments override policies."""
    return QoSProfile(depth=DEFAULT_DEPTH, **policies)


# -- as text


def offers_text(profiles: Iterable[QoSProfile]) -> str:
    """The profiles of publishers as rosbag2 writes them. DDS does not transmit history and depth: 3 (unknown) and 0."""
    offers = [_as_dict(profile) for profile in profiles]
    return dump(offers) if offers else ""


def _as_dict(profile: QoSProfile) -> dict[str, Any]:
    policies: dict[str, Any] = {"history": int(HistoryPolicy.UNKNOWN), "depth": 0}
    policies |= {name: int(getattr(profile, name)) for name in ("reliability", "durability")}
    policies |= {name: _seconds(getattr(profile, name)) for name in ("deadline", "lifespan")}
    policies["liveliness"] = int(profile.liveliness)
    policies["liveliness_lease_duration"] = _seconds(profile.liveliness_lease_duration)
    policies["avoid_ros_namespace_conventions"] = False
    return policies


def _seconds(duration: Duration) -> dict[str, int]:
    sec, nsec = divmod(duration.nanoseconds, 10**9)
    return {"sec": sec, "nsec": nsec}


def parse_offers(text: str) -> list[QoSProfile]:
    """The profiles in the metadata of any version of ROS 2; raises BagError if the text is not a list of profiles."""
    loaded = load_yaml(text, "offered_qos_profiles") if text else []
    if loaded is None:
        return []
    if not isinstance(loaded, list) or not all(isinstance(profile, dict) for profile in loaded):
        raise BagError("offered_qos_profiles is no list of QoS profiles")
    return [_profile(profile) for profile in loaded]


def _profile(values: dict[str, Any]) -> QoSProfile:
    policies: dict[str, Any] = {name: _policy(kind, values.get(name)) for name, kind in _POLICIES.items()}
    policies |= {name: _duration(values.get(name)) for name in _DURATIONS}
    return default_profile(**policies)


def _policy(kind: Any, value: Any) -> Any:
    """The policy of a number (up to version 8) or a word (since version 9); SYSTEM_DEFAULT for an unknown value."""
    try:
        return kind[value.upper()] if isinstance(value, str) else kind(value)
    except (KeyError, ValueError, TypeError):
        return kind.SYSTEM_DEFAULT


def _duration(value: Any) -> Duration:
    try:
        nanoseconds = int(value["sec"]) * 10**9 + int(value["nsec"])
    except (KeyError, TypeError, ValueError, OverflowError):
        return Duration()
    return Duration(nanoseconds=min(max(0, nanoseconds), _INFINITE))


# -- requests and offers


def request_for(topic: str, offers: list[QoSProfile], warn: Callable[[str], Any]) -> QoSProfile:
    """A recorder's request, compatible with all publishers of a topic."""
    reliable = sum(offer.reliability == ReliabilityPolicy.RELIABLE for offer in offers)
    latched = sum(offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers)
    if 0 < reliable < len(offers):
        warn(
            f'Some, but not all, publishers on topic "{topic}" are offering RMW_QOS_POLICY_RELIABILITY_RELIABLE. '
            "Falling back to RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT as it will connect to all publishers. "
            "Some messages from Reliable publishers could be dropped."
        )
    if 0 < latched < len(offers):
        warn(
            f'Some, but not all, publishers on topic "{topic}" are offering RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL. '
            "Falling back to RMW_QOS_POLICY_DURABILITY_VOLATILE as it will connect to all publishers. "
            "Previously-published latched messages will not be retrieved."
        )
    all_reliable, all_latched = reliable == len(offers), bool(offers) and latched == len(offers)
    return default_profile(
        reliability=ReliabilityPolicy.RELIABLE if all_reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if all_latched else DurabilityPolicy.VOLATILE,
    )


def offer_for(topic: str, recorded: list[QoSProfile], warn: Callable[[str], Any]) -> QoSProfile:
    """A player's offer: that of the recorded publishers if they agree, else the default."""
    if not recorded:
        return default_profile()
    first = recorded[0]
    if all(getattr(profile, name) == getattr(first, name) for profile in recorded for name in _SAME):
        return first
    warn(
        f"Not all original publishers on topic {topic} offered the same QoS profiles. Rosbag2 cannot yet choose an "
        "adapted profile to offer for this mixed case. Falling back to the rosbag2_transport default publisher offer."
    )
    return default_profile()
