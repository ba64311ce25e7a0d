"""`ros2 run robot_state_publisher robot_state_publisher`: joint states and a URDF in, frames on /tf and /tf_static out."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rclpy.utilities import remove_ros_args
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from tf2_py._convert import nanoseconds

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.gazebo.sdf_description import described
from coursekit.nodes.robots.joint_frames import JointFrames
from coursekit.nodes.running import spin_to_the_end, terminate
from coursekit.urdf import UrdfError, load_text
from coursekit.urdf.texts import error_text

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
_TYPES = {
    "robot_description": (Parameter.Type.STRING, "URDF must be a string"),
    "use_tf_static": (Parameter.Type.BOOL, "use_tf_static must be a boolean"),
    "frame_prefix": (Parameter.Type.STRING, "frame_prefix must be a string"),
    "ignore_timestamp": (Parameter.Type.BOOL, "ignore_timestamp must be a boolean"),
    "publish_frequency": (Parameter.Type.DOUBLE, "publish_frequency must be a double"),
}


class RobotStatePublisher(CppNode):
    """Publishes the frames of a robot's links.

    Raises UrdfError for an invalid description, RuntimeError for other invalid parameters, OSError for a missing file.
    """

    def __init__(self, file: str | None = None) -> None:
        super().__init__("robot_state_publisher")
        text = self._description(file)
        self._source = file if file is not None and not self.get_parameter("robot_description").value else ""
        interval = self._checked_interval(self.declare_parameter("publish_frequency", 20.0).value)
        self._interval_ns = interval
        self._prefix = self.declare_parameter("frame_prefix", "").value
        self._ignore_timestamp = self.declare_parameter("ignore_timestamp", False).value
        self._use_static = self.declare_parameter("use_tf_static", True).value
        self._published: dict[str, int] = {}
        self._last_call = 0
        self._tf = self.create_publisher(TFMessage, "/tf", 100)
        self._tf_static = self.create_publisher(TFMessage, "/tf_static", LATCHED)
        self._topic = self.create_publisher(String, "robot_description", LATCHED)
        self._set_robot(text)
        self.create_subscription(JointState, "joint_states", self._joint_states, qos_profile_sensor_data)
        self._publish_fixed()
        if not self._use_static:
            self.create_timer(max(interval, 1_000_000) / 1e9, self._publish_fixed)
        self.add_on_set_parameters_callback(self._judge)

    # -- the robot

    def _description(self, file: str | None) -> str:
        text: str = self.declare_parameter("robot_description", "").value
        if text:
            return text
        if file is None:
            raise RuntimeError("robot_description parameter must not be empty")
        self.get_logger().warning(
            "No robot_description parameter, but command-line argument available.  Assuming argument is name of URDF "
            "file.  This backwards compatibility fallback will be removed in the future."
        )
        return load_text(file)

    def _set_robot(self, text: str) -> None:
        robot = described(text, self._source or "robot_description")
        for fault in robot.faults:
            print(error_text(fault), end="", file=sys.stderr)
        root = robot.links[robot.root]
        if root.inertial is not None:
            self.get_logger().get_child("kdl_parser").warning(
                f"The root link {robot.root} has an inertia specified in the URDF, but KDL does not support a root link "
                "with an inertia.  As a workaround, you can add an extra dummy link to your URDF."
            )
        self._frames = JointFrames(robot, self._prefix)
        self._published.clear()
        for name in sorted(robot.links):
            self.get_logger().info(f"got segment {name}")
        self._topic.publish(String(data=text))

    def _checked_interval(self, frequency: float) -> int:
        if not 0.0 <= frequency <= 1000.0:
            raise RuntimeError("publish_frequency must be between 0 and 1000")
        return round(1e9 / frequency) if frequency else 2**62

    # -- publishing

    def _publish_fixed(self) -> None:
        stamp = self.get_clock().now().nanoseconds
        (self._tf_static if self._use_static else self._tf).publish(TFMessage(transforms=self._frames.fixed(stamp)))

    def _joint_states(self, msg: JointState) -> None:
        names, positions = msg.name, msg.position
        if len(names) != len(positions):
            if positions:
                self.get_logger().error("Robot state publisher ignored an invalid JointState message")
            else:
                self.get_logger().warning(
                    "Robot state publisher ignored a JointState message about joint(s) "
                    f'"{names[0]}"(,...) whose position member was empty.'
                )
            return
        sent = nanoseconds(msg.header.stamp)
        if self._is_due(names, sent):
            self._tf.publish(TFMessage(transforms=self._frames.moving(names, positions, sent)))

    def _is_due(self, names: Sequence[str], sent: int) -> bool:
        """Whether the interval has elapsed since the joint that was published longest ago."""
        now = self.get_clock().now().nanoseconds
        if self._last_call > now:
            self.get_logger().warning("Moved backwards in time, re-publishing joint transforms!")
            self._published.clear()
        self._last_call = now
        published = self._published
        oldest = min([published.get(name, 0) for name in names], default=now)
        if not self._ignore_timestamp and sent < min(oldest, now) + self._interval_ns and oldest:
            return False
        for name in names:
            published[name] = sent
        return True

    # -- parameters that change

    def _judge(self, parameters: Iterable[Parameter]) -> SetParametersResult:
        for parameter in parameters:
            reason = self._change(parameter)
            if reason:
                return SetParametersResult(successful=False, reason=reason)
        return SetParametersResult(successful=True)

    def _change(self, parameter: Parameter) -> str:
        """Apply a changed parameter. Return the reason if it is rejected, else ''."""
        kind, reason = _TYPES.get(parameter.name, (parameter.type_, ""))
        if parameter.type_ != kind:
            return reason
        value = parameter.value
        if parameter.name == "robot_description":
            return self._reload(value)
        if parameter.name == "publish_frequency":
            try:
                self._interval_ns = self._checked_interval(value)
            except RuntimeError as error:
                return str(error)
        elif parameter.name == "frame_prefix":
            self._prefix = self._frames.prefix = value
        elif parameter.name == "ignore_timestamp":
            self._ignore_timestamp = value
        elif parameter.name == "use_tf_static":
            self._use_static = value
        return ""

    def _reload(self, text: str) -> str:
        if not text:
            return "Empty URDF is not allowed"
        try:
            self._source = ""
            self._set_robot(text)
        except UrdfError as error:
            print(error_text(error), end="", file=sys.stderr)
            self.get_logger().warning(
                "Failed to parse new URDF: Unable to initialize urdf::model from robot description"
            )
            return f"Failed to parse new URDF: {error}"
        self._publish_fixed()
        return ""


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C; an invalid description ends it as in ROS 2."""
    words = remove_ros_args(sys.argv if args is None else args)[1:]
    rclpy.init(args=args)
    try:
        node = RobotStatePublisher(words[0] if words else None)
    except (UrdfError, RuntimeError, OSError) as error:
        return terminate(_complaint(error))
    return spin_to_the_end(node)


def _complaint(error: Exception) -> str:
    """Print the fault of a description. Return the text of the exception."""
    if not isinstance(error, UrdfError):
        return str(error)
    print(error_text(error), end="", file=sys.stderr)
    print("Failed to parse robot description using: urdf_xml_parser/URDFXMLParser", file=sys.stderr)
    return "Unable to initialize urdf::model from robot description"
