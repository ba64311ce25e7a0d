"""Names that are omitted from lists. In ROS 2: the same module."""

from __future__ import annotations

from coursekit.rcl import names

HIDDEN_TOPIC_PREFIX = "_"


def topic_or_service_is_hidden(name: str) -> bool:
    """Return whether a part of the name begins with an underscore.

    >>> topic_or_service_is_hidden("/fibonacci/_action/status")
    True
    """
    return names.is_hidden(name)
