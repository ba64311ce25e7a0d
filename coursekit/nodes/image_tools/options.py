"""QoS parameters of both nodes."""

from rclpy.node import Node
from rclpy.qos import QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy

_HISTORY = {"keep_last": QoSHistoryPolicy.KEEP_LAST, "keep_all": QoSHistoryPolicy.KEEP_ALL}
_RELIABILITY = {"reliable": QoSReliabilityPolicy.RELIABLE, "best_effort": QoSReliabilityPolicy.BEST_EFFORT}


def declared_qos(node: Node) -> QoSProfile:
    """Declare `depth`, `history` and `reliability`. Raises ValueError for unknown values."""
    depth = node.declare_parameter("depth", 10).value
    history = node.declare_parameter("history", "keep_last").value
    reliability = node.declare_parameter("reliability", "reliable").value
    for name, word, known in (("history", history, _HISTORY), ("reliability", reliability, _RELIABILITY)):
        if word not in known:
            raise ValueError(f"Invalid {name} '{word}'; there are: {', '.join(known)}")
    return QoSProfile(depth=depth, history=_HISTORY[history], reliability=_RELIABILITY[reliability])
