"""Quality of service: what a publisher offers, what a subscription requests, and whether the two match."""

from __future__ import annotations

from dataclasses import dataclass, replace

SYSTEM_DEFAULT = 0
KEEP_LAST, KEEP_ALL = 1, 2
RELIABLE, BEST_EFFORT = 1, 2
TRANSIENT_LOCAL, VOLATILE = 1, 2
AUTOMATIC, MANUAL_BY_TOPIC = 1, 3
INFINITE = 9223372036854775807

DURABILITY_POLICY, DEADLINE_POLICY, LIVELINESS_POLICY, RELIABILITY_POLICY = 2, 4, 8, 16
"""Numbers of the policies, as in rmw."""


@dataclass(frozen=True)
class Qos:
    """The policies of one endpoint; durations in nanoseconds, 0 for 'unspecified'.

    >>> Qos().incompatible_with(Qos(durability=TRANSIENT_LOCAL)) == DURABILITY_POLICY
    True
    """

    history: int = KEEP_LAST
    depth: int = 10
    reliability: int = RELIABLE
    durability: int = VOLATILE
    lifespan: int = 0
    deadline: int = 0
    liveliness: int = AUTOMATIC
    lease: int = 0

    def resolved(self) -> Qos:
        """Resolve the policies left to the system to the middleware's defaults.

        >>> Qos(depth=0, reliability=SYSTEM_DEFAULT).resolved().depth
        1
        """
        return replace(
            self,
            history=self.history if self.history in (KEEP_LAST, KEEP_ALL) else KEEP_LAST,
            depth=max(1, self.depth),
            reliability=self.reliability if self.reliability in (RELIABLE, BEST_EFFORT) else RELIABLE,
            durability=self.durability if self.durability in (TRANSIENT_LOCAL, VOLATILE) else VOLATILE,
            lifespan=self.lifespan or INFINITE,
            deadline=self.deadline or INFINITE,
            liveliness=self.liveliness if self.liveliness in (AUTOMATIC, MANUAL_BY_TOPIC) else AUTOMATIC,
            lease=self.lease or INFINITE,
        )

    def incompatible_with(self, requested: Qos) -> int | None:
        """Return the policy for which this offer does not satisfy `requested`; None when the two match.

        If several policies fail, it is the one that DDS reports last: reliability, liveliness, deadline, durability.

        >>> Qos(reliability=BEST_EFFORT).incompatible_with(Qos(reliability=RELIABLE)) == RELIABILITY_POLICY
        True
        >>> Qos(reliability=RELIABLE).incompatible_with(Qos(reliability=BEST_EFFORT)) is None
        True
        """
        offer, wish = self.resolved(), requested.resolved()
        if offer.reliability == BEST_EFFORT and wish.reliability == RELIABLE:
            return RELIABILITY_POLICY
        if offer.liveliness < wish.liveliness or offer.lease > wish.lease:
            return LIVELINESS_POLICY
        if offer.deadline > wish.deadline:
            return DEADLINE_POLICY
        if offer.durability == VOLATILE and wish.durability == TRANSIENT_LOCAL:
            return DURABILITY_POLICY
        return None
