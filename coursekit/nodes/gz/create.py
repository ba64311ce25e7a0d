"""`ros2 run ros_gz_sim create -topic robot_description -name NAME ...`: spawns a model in the newer Gazebo."""

from __future__ import annotations

import argparse
import re
import sys
from typing import Any

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.utilities import remove_ros_args
from ros_gz_interfaces.msg import EntityFactory
from ros_gz_interfaces.srv import SpawnEntity
from std_msgs.msg import String

from coursekit.nodes.gazebo.spawn_entity import pose_of

from .transport import gz_context

TEXTS = ("world", "file", "param", "string", "topic", "name")
NUMBERS = ("x", "y", "z", "R", "P", "Y")
ANSWER = 5.0
"""Seconds to wait for the simulator's response before asking again."""


def arguments(argv: list[str]) -> tuple[argparse.Namespace, list[str]]:
    """Return the known arguments, with one dash or two, and the unknown ones; an invalid number exits the program."""
    parser = argparse.ArgumentParser(prog="create", description="Put a model into Gazebo's world.", allow_abbrev=False)
    for name in TEXTS:
        parser.add_argument(f"--{name}", default="")
    for name in NUMBERS:
        parser.add_argument(f"--{name}", type=float, default=0.0)
    parser.add_argument("--allow_renaming", nargs="?", const="true", default="false")
    options = [re.sub(r"^-(?=[A-Za-z])", "--", word) for word in argv]  # argparse would read -param as -p
    told, rest = parser.parse_known_args(options)
    return told, [re.sub("^--", "-", word) for word in rest]


class Creator:
    """Calls the simulator; its node is in ROS, its client in Gazebo's graph."""

    def __init__(self, told: argparse.Namespace) -> None:
        self.node = Node("ros_gz_sim")
        self.log = self.node.get_logger()
        self.told = told
        for name in TEXTS:
            if name != "param":
                setattr(told, name, self.node.declare_parameter(name, "").value or getattr(told, name))
        for name in NUMBERS:
            setattr(told, name, self.node.declare_parameter(name, 0.0).value or getattr(told, name))
        renaming = self.node.declare_parameter("allow_renaming", False).value
        self.renaming = bool(renaming) or told.allow_renaming.lower() in ("true", "1")
        self.gz = gz_context()
        self.asker = rclpy.create_node("create", context=self.gz)
        self.executor = SingleThreadedExecutor(context=self.gz)
        self.executor.add_node(self.asker)

    def run(self) -> int:
        """Do what the arguments say. Returns 0, or 255 or 1 on failure."""
        world = self.told.world or self._world()
        wish = EntityFactory(name=self.told.name, allow_renaming=self.renaming, pose=pose_of(self.told))
        if not self._describe(wish):
            return 255
        return self._ask(f"/world/{world}/create", wish)

    def _world(self) -> str:
        while True:
            self.log.info("Requesting list of world names.")
            for name, types in self.asker.get_service_names_and_types():
                words = name.split("/")
                if "ros_gz_interfaces/srv/SpawnEntity" in types and len(words) == 4 and words[3] == "create":
                    return words[2]
            self.executor.spin_once(timeout_sec=ANSWER / 5)

    def _describe(self, wish: EntityFactory) -> bool:
        told = self.told
        if told.file:
            wish.sdf_filename = told.file
        elif told.param:
            wish.sdf = str(self.node.declare_parameter(told.param, "").value)
            if not wish.sdf:
                self.log.error(f"Failed to get XML from param [{told.param}].")
        elif told.string:
            wish.sdf = told.string
        elif told.topic:
            wish.sdf = self._heard(told.topic)
        else:
            self.log.error("Must specify either -file, -param, -string or -topic")
        return bool(wish.sdf or wish.sdf_filename)

    def _heard(self, topic: str) -> str:
        texts: list[str] = []
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.node.create_subscription(String, topic, lambda msg: texts.append(msg.data), latched)
        while rclpy.ok() and not texts:
            self.log.info(f"Waiting messages on topic [{topic}].")
            until = self.node.get_clock().now().nanoseconds + 1_000_000_000
            while not texts and (left := until - self.node.get_clock().now().nanoseconds) > 0:
                rclpy.spin_once(self.node, timeout_sec=left * 1e-9)
        return texts[-1] if texts else ""

    def _ask(self, service: str, wish: EntityFactory) -> int:
        client = self.asker.create_client(SpawnEntity, service)
        while not client.wait_for_service(timeout_sec=ANSWER):
            self.log.warning(f"Waiting for service [{service}] to become available ...")
        asked = client.call_async(SpawnEntity.Request(entity_factory=wish))
        self.log.info("Requested creation of entity.")
        self.executor.spin_until_future_complete(asked)
        if asked.result().success:
            self.log.info("OK creation of entity.")
            return 0
        self.log.error(f"Failed request to create entity.\n name: {wish.name!r}: the simulator tells why.")
        return 1


def main(args: list[str] | None = None) -> Any:
    """Create the entity. Returns the exit code."""
    told, rest = arguments(remove_ros_args(args if args is not None else sys.argv)[1:])
    rclpy.init(args=args)
    creator = None
    try:
        creator = Creator(told)
        if rest:
            creator.log.warning(f"create has no option for: {' '.join(rest)}; roll, pitch and yaw are -R, -P and -Y")
        return creator.run()
    except KeyboardInterrupt:
        return 130
    finally:
        if creator is not None:
            creator.gz.try_shutdown()
        rclpy.try_shutdown()
