"""Conversion of quality of service between the graph and the network's text."""

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
"""Upper limit for the depth of a remote endpoint."""


def core_qos(quality: Quality) -> Qos:
    """Convert a remote endpoint's QoS; unknown values become the middleware's defaults.

    >>> core_qos(Quality(depth=3)).depth, core_qos(Quality(history=77)).history == KEEP_LAST
    (3, True)
    """
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
    """Convert a local QoS to the form that peers read.

    >>> wire_quality(Qos(depth=5, durability=TRANSIENT_LOCAL)).text()
    ':1:,5:,:,:,,'
    """
    resolved = qos.resolved()
    return Quality(
        resolved.reliability,
        resolved.durability,
        resolved.history,
        resolved.depth,
        resolved.deadline,
        resolved.lifespan,
        resolved.liveliness,
        resolved.lease,
    )
