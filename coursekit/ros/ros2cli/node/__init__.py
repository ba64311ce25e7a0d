"""The nodes with which commands query the graph."""

NODE_NAME_PREFIX = "_ros2cli"
