"""Quality of service between the graph and the network's text."""

from __future__ import annotations

from coursekit.core.qos import (
    AUTOMATIC,
    BEST_EFFORT,
    KEEP_ALL,
    KEEP_LAST,
    MANUAL_BY_TOPIC,
    RELIABLE,
    TRANSIENT_LOCAL,
    VOLATILE,
    Qos,
)

from .wire.quality import Quality

MOST_KEPT = 100_000
"""A stranger's depth is taken no larger than this."""


def core_qos(quality: Quality) -> Qos:
    """A stranger's quality, with what this side does not know as the middleware's default."""
    return Qos(
        history=quality.history if quality.history in (KEEP_LAST, KEEP_ALL) else KEEP_LAST,
        depth=min(quality.depth, MOST_KEPT),
        reliability=quality.reliability if quality.reliability in (RELIABLE, BEST_EFFORT) else RELIABLE,
        durability=quality.durability if quality.durability in (TRANSIENT_LOCAL, VOLATILE) else VOLATILE,
        lifespan=quality.lifespan,
        deadline=quality.deadline,
        liveliness=quality.liveliness if quality.liveliness in (AUTOMATIC, MANUAL_BY_TOPIC) else AUTOMATIC,
        lease=quality.lease,
    )


def wire_quality(qos: Qos) -> Quality:
    """Ours, as others read it."""
    one = qos.resolved()
    return Quality(
        one.reliability, one.durability, one.history, one.depth, one.deadline, one.lifespan, one.liveliness, one.lease
    )
