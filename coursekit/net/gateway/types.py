"""The robot's own interface classes and quality of service."""

from __future__ import annotations

import importlib
from typing import Any

from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy

from ..wire.quality import FOREVER, Quality

MOST_KEPT = 1000
"""Depth for a publisher that keeps all messages."""


def class_of(name: str) -> Any:
    """Return the class of a type, including an action's parts; ImportError or AttributeError where it is not installed."""
    package, kind, short = name.split("/")
    module = importlib.import_module(f"{package}.{kind}")
    if kind != "action":
        return getattr(module, short)
    action, _, part = short.rpartition("_")
    parts = getattr(module, action).Impl
    return getattr(parts, {"SendGoal": "SendGoalService", "GetResult": "GetResultService"}.get(part, part))


def profile_of(quality: Quality) -> QoSProfile:
    """Convert a token's QoS to rclpy's."""
    profile = QoSProfile(
        depth=min(quality.depth, 100_000),
        history=HistoryPolicy(quality.history if quality.history in (1, 2) else 1),
        reliability=ReliabilityPolicy(quality.reliability if quality.reliability in (1, 2) else 1),
        durability=DurabilityPolicy(quality.durability if quality.durability in (1, 2) else 2),
    )
    for name in ("deadline", "lifespan"):
        span = getattr(quality, name)
        if 0 < span < FOREVER:
            setattr(profile, name, Duration(nanoseconds=span))
    return profile


def quality_of(profile: Any) -> Quality:
    """Convert rclpy's QoS of an endpoint to a token's; unknown policies get defaults."""
    return Quality(
        reliability=2 if int(profile.reliability) == 2 else 1,
        durability=1 if int(profile.durability) == 1 else 2,
        history=2 if int(profile.history) == 2 else 1,
        depth=profile.depth or 10,
        deadline=_span(profile.deadline),
        lifespan=_span(profile.lifespan),
    )


def _span(duration: Any) -> int:
    return duration.nanoseconds if 0 < duration.nanoseconds < FOREVER else FOREVER


def is_latched(profile: Any) -> bool:
    """Whether messages are kept for late joiners."""
    return int(profile.durability) == 1


def kept(profile: Any) -> int:
    """Return how many messages are kept."""
    return MOST_KEPT if int(profile.history) == 2 else max(1, min(profile.depth, MOST_KEPT))
