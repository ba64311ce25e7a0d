"""The compatibility check of two profiles, with rmw's messages."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

_RELIABLE, _BEST_EFFORT = 1, 2
_TRANSIENT_LOCAL, _VOLATILE = 1, 2
_AUTOMATIC, _MANUAL = 1, 3


class QoSCompatibility(IntEnum):
    """The compatibility of a publisher and a subscription."""

    OK = 0
    WARNING = 1
    ERROR = 2


def check(publisher: Any, subscription: Any) -> tuple[QoSCompatibility, str]:
    """Return the compatibility of two rclpy profiles and its reasons; after an error, warnings are omitted."""
    errors = [f"ERROR: {reason};" for reason in _errors(publisher, subscription)]
    if errors:
        return QoSCompatibility.ERROR, "".join(errors)
    warnings = [f"WARNING: {reason};" for reason in _warnings(publisher, subscription)]
    verdict = QoSCompatibility.WARNING if warnings else QoSCompatibility.OK
    return verdict, "".join(warnings)


def _errors(publisher: Any, subscription: Any) -> list[str]:
    errors = []
    if (publisher.reliability, subscription.reliability) == (_BEST_EFFORT, _RELIABLE):
        errors.append("Best effort publisher and reliable subscription")
    if (publisher.durability, subscription.durability) == (_VOLATILE, _TRANSIENT_LOCAL):
        errors.append("Volatile publisher and transient local subscription")
    errors += _duration_errors(
        publisher.deadline.nanoseconds,
        subscription.deadline.nanoseconds,
        "Subscription has a deadline, but publisher does not",
        "Subscription deadline is less than publisher deadline",
    )
    if (publisher.liveliness, subscription.liveliness) == (_AUTOMATIC, _MANUAL):
        errors.append("Publisher's liveliness is automatic and subscription's is manual by topic")
    errors += _duration_errors(
        publisher.liveliness_lease_duration.nanoseconds,
        subscription.liveliness_lease_duration.nanoseconds,
        "Subscription has a liveliness lease duration, but publisher does not",
        "Subscription liveliness lease duration is less than publisher",
    )
    return errors


def _duration_errors(offered: int, wanted: int, none_offered: str, too_long: str) -> list[str]:
    if wanted and not offered:
        return [none_offered]
    return [too_long] if wanted and wanted < offered else []


def _warnings(publisher: Any, subscription: Any) -> list[str]:
    return [
        *_open_choice(publisher.reliability, subscription.reliability, _BEST_EFFORT, _RELIABLE, _RELIABILITY),
        *_open_choice(
            publisher.durability, subscription.durability, _VOLATILE, _TRANSIENT_LOCAL, _DURABILITY
        ),
        *_open_choice(publisher.liveliness, subscription.liveliness, _AUTOMATIC, _MANUAL, _LIVELINESS),
    ]


def _open_choice(offer: Any, wish: Any, weak: int, strong: int, texts: tuple[str, str, str]) -> list[str]:
    """The warning about a policy that is left to the system: it may turn out not to match."""
    both, weak_offer, strong_wish = texts
    offer_open, wish_open = not _is_said(offer), not _is_said(wish)
    if offer_open and wish_open:
        return [both.format(_name(offer), _name(wish))]
    if offer == weak and wish_open:
        return [weak_offer.format(_name(wish))]
    if offer_open and wish == strong:
        return [strong_wish.format(_name(offer))]
    return []


def _is_said(choice: Any) -> bool:
    return choice.name not in ("SYSTEM_DEFAULT", "UNKNOWN")


def _name(choice: Any) -> str:
    return choice.name.lower()


_RELIABILITY = (
    "Publisher reliability is {} and subscription reliability is {}",
    "Best effort publisher, but subscription is {}",
    "Reliable subscription, but publisher is {}",
)
_DURABILITY = (
    "Publisher durabilty is {} and subscription durability is {}",
    "Volatile publisher, but subscription is {}",
    "Transient local subscription, but publisher is {}",
)
_LIVELINESS = (
    "Publisher liveliness is {} and subscription liveliness is {}",
    "Publisher's liveliness is automatic, but subscription's is {}",
    "Subscription's liveliness is manual by topic, but publisher's is {}",
)
_CHOICES = (
    ("reliability", _BEST_EFFORT, _RELIABLE, _RELIABILITY),
    ("durability", _VOLATILE, _TRANSIENT_LOCAL, _DURABILITY),
    ("liveliness", _AUTOMATIC, _MANUAL, _LIVELINESS),
)
