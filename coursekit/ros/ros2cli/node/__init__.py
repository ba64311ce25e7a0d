"""The nodes through which commands ask the graph."""

NODE_NAME_PREFIX = "_ros2cli"
