"""What the graph knows of one publisher or subscription."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any


class TopicEndpointTypeEnum(IntEnum):
    """Which end of the topic."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


@dataclass
class TopicEndpointInfo:
    """Node, type, number and QoS of an endpoint."""

    node_name: str = ""
    node_namespace: str = ""
    topic_type: str = ""
    endpoint_type: TopicEndpointTypeEnum = TopicEndpointTypeEnum.INVALID
    endpoint_gid: list[int] = field(default_factory=list)
    qos_profile: Any = None
    topic_type_hash: Any = None

    def __str__(self) -> str:
        gid = ".".join(format(byte, "02x") for byte in self.endpoint_gid)
        depth = f" ({self.qos_profile.depth})" if self.qos_profile.depth else ""
        history = self.qos_profile.history.name + (depth if self.qos_profile.history.name == "KEEP_LAST" else "")
        return "\n".join(
            [
                f"Node name: {self.node_name}",
                f"Node namespace: {self.node_namespace}",
                f"Topic type: {self.topic_type}",
                f"Endpoint type: {self.endpoint_type.name}",
                f"GID: {gid}",
                "QoS profile:",
                f"  Reliability: {self.qos_profile.reliability.name}",
                f"  History (Depth): {history}",
                f"  Durability: {self.qos_profile.durability.name}",
                f"  Lifespan: {self.qos_profile.lifespan}",
                f"  Deadline: {self.qos_profile.deadline}",
                f"  Liveliness: {self.qos_profile.liveliness.name}",
                f"  Liveliness lease duration: {self.qos_profile.liveliness_lease_duration}",
            ]
        )
