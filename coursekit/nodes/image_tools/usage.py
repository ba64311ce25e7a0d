"""`-h` of the image_tools programs: prints their parameters without creating a node."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence

from rclpy.utilities import remove_ros_args

QOS = {
    "reliability": "'reliable' (the default) or 'best_effort'",
    "history": "'keep_last' (the default) or 'keep_all'",
    "depth": "how many messages 'keep_last' keeps (10)",
}
"""The parameters that both programs share."""


def told(name: str, what: str, parameters: Mapping[str, str], args: Sequence[str] | None = None) -> bool:
    """Print the usage if the arguments contain `-h` or `--help`. Returns whether they do."""
    words = remove_ros_args(list(sys.argv if args is None else args))
    if not {"-h", "--help"} & set(words):
        return False
    print(f"Usage: {name} [-h] [--ros-args [-p param:=value] ...]\n{what}\n\nOptions:\n  -h, --help\tShow this and exit\n")
    print("\n".join(["Parameters:", *(f"  {parameter:<12}{text}" for parameter, text in (QOS | dict(parameters)).items())]))
    return True
