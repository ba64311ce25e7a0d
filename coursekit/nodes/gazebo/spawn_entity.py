"""`ros2 run gazebo_ros spawn_entity.py -topic robot_description -entity NAME ...`: put a model into the world."""

from __future__ import annotations

import argparse
import math
import os
import sys
from typing import Any
from xml.sax.saxutils import escape

import rclpy
from gazebo_msgs.msg import ModelStates
from gazebo_msgs.srv import DeleteEntity, SetModelConfiguration, SpawnEntity
from geometry_msgs.msg import Pose
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String
from std_srvs.srv import Empty

from coursekit.files import read_text
from coursekit.urdf import UrdfError
from coursekit.urdf.xml_tree import read

INCLUDE = "<sdf version='1.6'><world name='default'><include><uri>model://{}</uri></include></world></sdf>"


def arguments(argv: list[str]) -> argparse.Namespace:
    """Return the parsed command line; invalid arguments exit with status 2."""
    parser = argparse.ArgumentParser(description="Spawn an entity in gazebo.")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("-file", metavar="FILE_NAME", help="load the description from a file")
    source.add_argument("-topic", metavar="TOPIC_NAME", help="load the description from a topic")
    source.add_argument("-database", metavar="ENTITY_NAME", help="load a model that is in GAZEBO_MODEL_PATH")
    source.add_argument("-stdin", action="store_true", help="load the description from standard input")
    parser.add_argument("-entity", required=True, metavar="ENTITY_NAME", help="name of the entity")
    parser.add_argument("-reference_frame", default="", help="entity that the pose is relative to; the world if empty")
    parser.add_argument("-gazebo_namespace", default="", help="namespace of the simulator's services")
    parser.add_argument("-robot_namespace", default="", help="namespace of the entity's topics and nodes")
    parser.add_argument("-timeout", type=float, default=30.0, help="seconds to wait for the services")
    parser.add_argument("-pause", action="store_true", help="pause the physics before")
    parser.add_argument("-unpause", action="store_true", help="let the physics go on afterwards")
    parser.add_argument("-wait", metavar="ENTITY_NAME", help="wait until that entity is there")
    parser.add_argument("-spawn_service_timeout", type=float, metavar="TIMEOUT", help="DEPRECATED: say -timeout")
    for name, what in zip("xyzRPY", ("m", "m", "m", "rad: roll", "rad: pitch", "rad: yaw"), strict=True):
        parser.add_argument(f"-{name}", type=float, default=0.0, help=f"initial {name} in {what}")
    parser.add_argument(
        "-J", dest="joints", default=[], action="append", nargs=2, metavar=("JOINT_NAME", "JOINT_POSITION"),
        help="put a joint at a position",
    )  # fmt: skip
    parser.add_argument("-package_to_model", action="store_true", help="read meshes of package:// as model://")
    parser.add_argument("-b", dest="bond", action="store_true", help="delete the entity when this program ends")
    return parser.parse_args(argv)


class SpawnEntityNode(Node):
    """Calls the simulator's services one after another."""

    def __init__(self, args: argparse.Namespace) -> None:
        super().__init__("spawn_entity")
        self.args = args
        self.log = self.get_logger()

    def run(self) -> int:
        """Do what the arguments say. Returns 0, or 1 on failure."""
        if self.args.wait:
            self._wait_for(self.args.wait)
        text = self._description()
        if text is None:
            return 1
        try:
            read(text, self.args.file or "")
        except UrdfError as error:
            self.log.error(f"Invalid XML: {error}")
            return 1
        if self.args.package_to_model:
            text = text.replace('filename="package://', 'filename="model://')
        if self.args.pause:
            self._call_empty("pause_physics")
        if not self._spawn(text):
            self.log.error("Spawn service failed. Exiting.")
            return 1
        if self.args.joints and not self._put_joints():
            self.log.error("set_joint_positions service failed. Exiting.")
            return 1
        if self.args.unpause:
            self._call_empty("unpause_physics")
        if self.args.bond:
            self._stay()
        return 0

    # -- the description

    def _wait_for(self, name: str) -> None:
        there: list[bool] = []
        space = self.args.gazebo_namespace

        def hear(msg: ModelStates) -> None:
            if name in msg.name:
                there.append(True)

        heard = self.create_subscription(ModelStates, f"{space}/model_states", hear, 10)
        self.log.info(f"Waiting for entity {name} before proceeding.")
        while rclpy.ok() and not there:
            rclpy.spin_once(self)
        self.destroy_subscription(heard)

    def _description(self) -> str | None:
        if self.args.file is not None:
            return self._from_file(self.args.file)
        if self.args.topic is not None:
            return self._from_topic(self.args.topic)
        if self.args.database is not None:
            self.log.info("Loading entity XML from Gazebo Model Database")
            return INCLUDE.format(escape(self.args.database))
        self.log.info("Loading entity XML from stdin")
        text = sys.stdin.read()
        if not text:
            self.log.error("Error: stdin buffer was empty")
            return None
        return text

    def _from_file(self, name: str) -> str | None:
        self.log.info(f"Loading entity XML from file {name}")
        if not os.path.exists(name):
            self.log.error(f"Error: specified file {name} does not exist")
            return None
        if not os.path.isfile(name):
            self.log.error(f"Error: specified file {name} is not a file")
            return None
        try:
            text = read_text(name)
        except (OSError, UnicodeDecodeError) as error:
            self.log.error(f"Error reading file {name}: {error}")
            return None
        if not text:
            self.log.error(f"Error: file {name} is empty")
            return None
        return text

    def _from_topic(self, topic: str) -> str:
        self.log.info(f"Loading entity published on topic {topic}")
        texts: list[str] = []
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, topic, lambda msg: texts.append(msg.data), latched)
        self.log.info(f"Waiting for entity xml on {topic}")
        while rclpy.ok() and not (texts and texts[-1]):
            rclpy.spin_once(self)
        return texts[-1]

    # -- services

    def _ask(self, kind: type[Any], name: str, request: object, timeout: float, module: str) -> Any:
        """Return a service's response, or None if the service is not available in time."""
        full = f"{self.args.gazebo_namespace}/{name}"
        client = self.create_client(kind, full)
        if not client.wait_for_service(timeout_sec=timeout):
            self.log.error(f"Service {full} unavailable. Was Gazebo started with {module}?")
            return None
        self.log.info(f"Calling service {full}")
        asked = client.call_async(request)
        while rclpy.ok() and not asked.done():
            rclpy.spin_once(self)
        return asked.result()

    def _call_empty(self, name: str) -> None:
        self._ask(Empty, name, Empty.Request(), self.args.timeout, "GazeboRosInit")

    def _spawn(self, text: str) -> bool:
        args, timeout = self.args, self.args.timeout
        if args.spawn_service_timeout is not None:
            self.log.warning("'-spawn_service_timeout' is deprecated, use '-timeout' instead")
            timeout = args.spawn_service_timeout
        if timeout < 0:
            self.log.error("spawn_entity timeout must be greater than zero")
            return False
        name = f"{args.gazebo_namespace}/spawn_entity"
        self.log.info(f"Waiting for service {name}, timeout = {timeout:.0f}")
        self.log.info(f"Waiting for service {name}")
        request = SpawnEntity.Request(name=args.entity, xml=text, robot_namespace=args.robot_namespace)
        request.initial_pose, request.reference_frame = pose_of(args), args.reference_frame
        answer = self._ask(SpawnEntity, "spawn_entity", request, timeout, "GazeboRosFactory")
        if answer is None:
            return False
        self.log.info(f"Spawn status: {answer.status_message}")
        return bool(answer.success)

    def _put_joints(self) -> bool:
        names, positions = zip(*self.args.joints, strict=True)
        request = SetModelConfiguration.Request(model_name=self.args.entity, joint_names=list(names))
        request.joint_positions = [float(position) for position in positions]
        answer = self._ask(SetModelConfiguration, "set_joint_positions", request, 5.0, "GazeboRosState")
        if answer is None:
            return False
        self.log.info(f"Set model configuration status: {answer.status_message}")
        return bool(answer.success)

    def _stay(self) -> None:
        name = self.args.entity
        self.log.info(f"Waiting for shutdown to delete entity [{name}]")
        try:
            rclpy.spin(self)
        except KeyboardInterrupt:
            self.log.info("Ctrl-C detected")
        self.log.info(f"Deleting entity [{name}]")
        answer = self._ask(
            DeleteEntity, "delete_entity", DeleteEntity.Request(name=name), self.args.timeout, "GazeboRosFactory"
        )
        if answer is not None:
            self.log.info(f"Deleting status: {answer.status_message}")


def pose_of(args: argparse.Namespace) -> Pose:
    """Return the pose given by the options -x to -Y."""
    (sr, cr), (sp, cp), (sy, cy) = ((math.sin(angle / 2), math.cos(angle / 2)) for angle in (args.R, args.P, args.Y))
    pose = Pose()
    pose.position.x, pose.position.y, pose.position.z = args.x, args.y, args.z
    pose.orientation.x, pose.orientation.y = sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy
    pose.orientation.z, pose.orientation.w = cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy
    return pose


def main(args: list[str] | None = None) -> int:
    """Spawn the entity. Returns the exit code."""
    told = arguments(remove_ros_args(args if args is not None else sys.argv)[1:])
    rclpy.init(args=args)
    try:
        node = SpawnEntityNode(told)
        node.log.info("Spawn Entity started")
        return node.run()
    except KeyboardInterrupt:
        return 130
    finally:
        rclpy.try_shutdown()
