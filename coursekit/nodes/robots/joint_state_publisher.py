"""`ros2 run joint_state_publisher joint_state_publisher`: publishes a position for every joint of the robot."""

from __future__ import annotations

import argparse
import sys
from typing import Any

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, ParameterType
from rclpy.exceptions import ParameterAlreadyDeclaredException
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.utilities import remove_ros_args
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from coursekit.nodes.robots.joint_model import JointModel, Options, followers, read
from coursekit.urdf import UrdfError, load_text

PARAMETERS: dict[str, tuple[Any, int]] = {
    "publish_default_efforts": (False, ParameterType.PARAMETER_BOOL),
    "publish_default_positions": (True, ParameterType.PARAMETER_BOOL),
    "publish_default_velocities": (False, ParameterType.PARAMETER_BOOL),
    "rate": (10, ParameterType.PARAMETER_INTEGER),
    "source_list": ([], ParameterType.PARAMETER_STRING_ARRAY),
    "use_mimic_tags": (True, ParameterType.PARAMETER_BOOL),
    "use_smallest_joint_limits": (True, ParameterType.PARAMETER_BOOL),
    "delta": (0.0, ParameterType.PARAMETER_DOUBLE),
}


class JointStatePublisher(Node):
    """Publishes joint states; the description comes from a file or the topic robot_description."""

    def __init__(self, file: str | None = None) -> None:
        super().__init__("joint_state_publisher", automatically_declare_parameters_from_overrides=True)
        for name, (default, kind) in PARAMETERS.items():
            try:
                self.declare_parameter(name, default, ParameterDescriptor(type=kind))
            except ParameterAlreadyDeclaredException:
                pass
        self._options = self._read_options()
        self.model = JointModel(followers=dict(self._options.dependent))
        if file is not None:
            self.configure(load_text(file))
        else:
            self.get_logger().info("Waiting for robot_description to be published on the robot_description topic...")
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, "robot_description", self._described, latched)
        for source in self._value("source_list"):
            self.create_subscription(JointState, source, self._heard, 10)
        self._publisher = self.create_publisher(JointState, "joint_states", 10)
        self.create_timer(1.0 / self._value("rate"), self._publish)

    def _value(self, name: str) -> Any:
        return self.get_parameter(name).value

    def _read_options(self) -> Options:
        def below(prefix: str) -> dict[str, Any]:
            return {name: parameter.value for name, parameter in self.get_parameters_by_prefix(prefix).items()}

        return Options(
            below("zeros"),
            followers(below("dependent_joints")),
            self._value("use_mimic_tags"),
            self._value("use_smallest_joint_limits"),
            self._value("publish_default_positions"),
            self._value("publish_default_velocities"),
            self._value("publish_default_efforts"),
        )

    def configure(self, description: str) -> None:
        """Read a description; raises UrdfError."""
        self.model = read(description, self._options)
        self.changed()

    def changed(self) -> None:
        """Called when joints were read, or moved by another node; subclasses override it."""

    def _described(self, msg: String) -> None:
        try:
            self.configure(msg.data)
        except UrdfError as error:
            self.get_logger().warning(str(error))

    def _heard(self, msg: JointState) -> None:
        for number, name in enumerate(msg.name):
            joint = self.model.free.get(name)
            if joint is None:
                continue
            for kind in ("position", "velocity", "effort"):
                values = getattr(msg, kind)
                if number < len(values):
                    setattr(joint, kind, values[number])
        self.changed()

    def _publish(self) -> None:
        model, delta = self.model, self._value("delta")
        if delta > 0:
            for joint in model.free.values():
                joint.step(delta)
        msg = JointState(name=list(model.names))
        msg.header.stamp = self.get_clock().now().to_msg()
        joints = list(model.free.values())
        count = len(model.names)
        if model.followers or any(joint.position is not None for joint in joints):
            msg.position = [0.0] * count
        if any(joint.velocity is not None for joint in joints):
            msg.velocity = [0.0] * count
        if any(joint.effort is not None for joint in joints):
            msg.effort = [0.0] * count
        for number, name in enumerate(model.names):
            self._fill(msg, number, name)
        if msg.name:
            self._publisher.publish(msg)

    def _fill(self, msg: JointState, number: int, name: str) -> None:
        resolved = self.model.resolve(name)
        if resolved is None:
            return
        joint, factor, offset = resolved
        if joint.position is not None:
            msg.position[number] = joint.position * factor + offset
        if joint.velocity is not None:
            msg.velocity[number] = joint.velocity * factor
        if joint.effort is not None:
            msg.effort[number] = joint.effort


def run(make: type[JointStatePublisher], args: list[str] | None) -> int:
    """Run a node until Ctrl-C; return 1 for an invalid description or invalid parameters."""
    parser = argparse.ArgumentParser()
    parser.add_argument("description_file", help="Robot description file to use", nargs="?", default=None)
    file = parser.parse_args(remove_ros_args(sys.argv if args is None else args)[1:]).description_file
    rclpy.init(args=args)
    node = None
    try:
        node = make(file)
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except ValueError as error:  # an invalid description, or dependent joints in a cycle
        if node is not None:
            node.get_logger().error(str(error))
        else:
            print(error, file=sys.stderr)
        return 1
    finally:
        if node is not None:
            node.destroy_node()
        rclpy.try_shutdown()
    return 0


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(JointStatePublisher, args)
