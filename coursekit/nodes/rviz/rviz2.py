"""`ros2 run rviz2 rviz2 -d FILE`: the viewer, in the notebook if there is one; else a node that logs its displays."""

from __future__ import annotations

import argparse
import sys

import rclpy
from rclpy.exceptions import NameValidationException
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.utilities import remove_ros_args
from rclpy.validate_topic_name import validate_topic_name

from coursekit.files import is_file
from coursekit.interfaces import load
from coursekit.nodes.running import spin_to_the_end
from coursekit.processes.current_process import program_folder
from coursekit.processes.session import current

from .config import Config, DisplayConfig, make_config
from .config_file import read
from .kinds import KINDS
from .windows import windows

LOOK_SECONDS = 2.0
"""The time before it warns of topics without publishers [s]."""
BEST_EFFORT = ReliabilityPolicy.BEST_EFFORT
LOG = get_logger("rviz2")
"""RViz logs under this name, whatever the name of its node (`rviz` by default)."""


class Rviz(Node):
    """A window's node."""

    def __init__(self, config: Config) -> None:
        super().__init__("rviz")
        self.session = current()
        self.config = config
        self.running = True
        self.full_name = self.get_fully_qualified_name()
        for display in config.displays:
            self._settle_topic(display)
        for skipped in config.skipped:
            LOG.warning(f"Not known here, left out: {skipped}")
        if windows.add(self):
            LOG.info("Shown in the notebook; in a cell, viewer() shows it too.")
        else:
            self._tell()
            self._look = self.create_timer(LOOK_SECONDS, self._complain)
        self._listen()

    def _settle_topic(self, display: DisplayConfig) -> None:
        """Resolve a display's topic with the node's namespace and remappings; an invalid topic disables the display."""
        if not display.topic:
            return
        try:
            validate_topic_name(display.topic)
            display.topic = self.resolve_topic_name(display.topic)
        except NameValidationException as error:
            display.enabled = False
            LOG.error(f"{display.name}: Error subscribing: {error}")

    def _listen(self) -> None:
        """Subscribe to the shown topics, for the graph only; the pictures are made from the viewer's own subscriptions."""
        shown = [(display.topic, KINDS[display.kind].type) for display in self.config.displays if display.enabled]
        frames = [("/tf", "tf2_msgs/msg/TFMessage"), ("/tf_static", "tf2_msgs/msg/TFMessage")]
        for topic, kind in dict.fromkeys([*frames, *shown]):
            if kind:
                self.create_subscription(load(kind), topic, lambda _: None, QoSProfile(depth=1, reliability=BEST_EFFORT))

    def _tell(self) -> None:
        frame = self.config.fixed_frame or "the root of the tree"
        LOG.info(f"No notebook shows this window. Fixed frame: {frame}. Displays:")
        for display in self.config.displays:
            LOG.info(f"  {describe(display)}")

    def _complain(self) -> None:
        self._look.cancel()
        for display in self.config.displays:
            if display.enabled and KINDS[display.kind].type and not self.count_publishers(display.topic):
                LOG.warning(f"{display.name}: no node publishes {display.topic}")

    def destroy_node(self) -> None:
        """Close the window."""
        self.running = False
        windows.remove(self)
        super().destroy_node()


def describe(display: DisplayConfig) -> str:
    """A display as one line of text.

    >>> from coursekit.nodes.rviz.config import display_config
    >>> describe(display_config("LaserScan /scan"))
    'LaserScan: /scan [sensor_msgs/msg/LaserScan]'
    """
    kind = KINDS[display.kind]
    name = display.name if display.name == display.kind else f"{display.name} ({display.kind})"
    where = f": {display.topic} [{kind.type}]" if kind.type else ""
    return f"{name}{where}{'' if display.enabled else ', off'}"


def _config(argv: list[str]) -> Config:
    parser = argparse.ArgumentParser(prog="rviz2", description="Shows robots, frames and messages")
    parser.add_argument("-d", "--display-config", metavar="FILE", help="what to show: our YAML or an .rviz file")
    parser.add_argument("-f", "--fixed-frame", default="", help="the fixed frame")
    parser.add_argument("-s", "--splash-screen", help=argparse.SUPPRESS)
    args = parser.parse_args(argv)
    config = make_config(displays=["Grid", "RobotModel", "TF"])
    if args.display_config:
        file = program_folder() / args.display_config
        if is_file(file):
            config = read(file, rooted=False)
        else:
            LOG.warning(f"{args.display_config}: there is no such file; the default view is shown")
    config.fixed_frame = args.fixed_frame or config.fixed_frame
    return config


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    words = sys.argv if args is None else args
    try:
        config = _config(remove_ros_args(words)[1:])
    except (OSError, ValueError) as error:
        print(f"rviz2: {error}", file=sys.stderr)
        return 1
    rclpy.init(args=args)
    node = Rviz(config)
    return spin_to_the_end(node)


__all__ = ["Rviz", "describe", "main"]
