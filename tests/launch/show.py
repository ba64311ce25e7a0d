"""An executable that prints its arguments, for launches that are judged by what their nodes get."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch_ros.actions import Node

SHOW = """
import os
import sys

for index, word in enumerate(sys.argv):
    if index and word.startswith('/') and sys.argv[index - 1] == '--params-file':
        print('FILE', open(word).read().replace('\\n', '|'))
print('ARGV', ' '.join(sys.argv[1:]))
print('LOG', os.environ.get('ROS_LOG_DIR'))
"""

Arguments = Callable[..., list[str]]


def node(**kwargs: Any) -> Node:
    return Node(package="demo", executable="show", output="screen", **kwargs)
