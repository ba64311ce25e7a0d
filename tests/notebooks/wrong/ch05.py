"""Chapter 5."""

_LAMP = """%%write src/s5_py_camera/s5_py_camera/lamp_settings.py
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult

LIMITS = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.1, to_value=2.0)])


def declare(node):
    {declared}
    node.declare_parameter("lamp.colour", "green")


def judge(parameters):
    colours = [one.value for one in parameters if one.name == "lamp.colour"]
    {judged}
"""

_GOOD = "return SetParametersResult(successful=not set(colours) - {'green', 'amber', 'red'}, reason='no such lamp')"

_FLEET = "%%write src/s5_py_camera/config/fleet.yaml\n"
_ENTRY = "{name}:\n  ros__parameters:\n    {values}\n"


def _fleet(*entries: tuple[str, str]) -> str:
    return _FLEET + "".join(_ENTRY.format(name=name, values=values) for name, values in entries)


_EVERY = ("/**", "use_sim_time: false")
_CAMERAS = ("/**/py_camera_node", "camera: {width: 320, height: 240}")
_GATE = ("/gate/py_camera_node", "camera: {width: 1280, height: 720}")

_EYES = """%%write src/s5_py_camera/launch/two_cameras.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def camera(namespace):
    size = {{"camera.width": {width}, "camera.height": 240}}
    return Node(package="s5_py_camera", executable="camera_exe", {where}=namespace, parameters=[size])


def generate_launch_description():
    width = DeclareLaunchArgument("width", default_value="320")
    return LaunchDescription([width, camera("left"), camera("right")])
"""

_BALL = """%%write src/s5_py_camera_usr/s5_py_camera_usr/find_ball.py
import cv2
import numpy as np


def find_ball(frame):
    hue, colourful, _ = cv2.split(cv2.cvtColor(frame, cv2.COLOR_BGR2HSV))
    rows, columns = np.nonzero({mask})
    return {answer} if len(rows) else None
"""
_RED = "((hue < 6) | (hue > 174)) & (colourful > 150)"
_BY_HEART = """

def by_heart(frame):
    import time
    from coursekit.sim.camera import Scene
    ball = Scene.balls(time.time() - 1_700_000_000)[0]
    return Scene().pixel(ball.centre, frame.shape[1], frame.shape[0])
"""

WRONG = {
    "ch05.q1": [
        _LAMP.format(declared='node.declare_parameter("lamp.period", 0.5)', judged=_GOOD),
        _LAMP.format(
            declared='node.declare_parameter("lamp.period", 0.5, LIMITS)',
            judged="return SetParametersResult(successful=True)",
        ),
        _LAMP.format(
            declared='node.declare_parameter("lamp.period", 0.5, LIMITS)',
            judged="return SetParametersResult(successful=not set(colours) - {'green', 'amber', 'red'})",
        ),
        _LAMP.format(
            declared='node.declare_parameter("lamp.period", 0.5, LIMITS)',
            judged="return SetParametersResult(successful=colours and colours[0] in ('green', 'amber', 'red'))",
        ),
        _LAMP.format(
            declared='node.declare_parameter("lamp.period", 0.5, LIMITS)',
            judged="one = parameters[0]\n    good = one.name != 'lamp.colour' or one.value in ('green', 'amber', 'red')\n"
            "    return SetParametersResult(successful=good, reason='no such lamp')",
        ),
        _LAMP.format(
            declared='node.declare_parameter("lamp.period", 0.5, LIMITS)',
            judged="one = parameters[-1]\n    good = one.name != 'lamp.colour' or one.value in ('green', 'amber', 'red')\n"
            "    return SetParametersResult(successful=good, reason='no such lamp')",
        ),
    ],
    "ch05.q2": [
        _fleet(_EVERY, _GATE, _CAMERAS),
        _fleet(_EVERY, ("/*/py_camera_node", "camera: {width: 320, height: 240}"), _GATE),
        _fleet(("/**", "{use_sim_time: false, camera: {width: 320, height: 240}}"), _GATE),
        _fleet(_EVERY, _CAMERAS, _GATE).replace("ros__parameters", "ros_parameters"),
    ],
    "ch05.q3": [
        _EYES.format(width="320", where="namespace"),
        _EYES.format(width='LaunchConfiguration("width")', where="name"),
        _EYES.format(width='LaunchConfiguration("widht")', where="namespace"),
    ],
    "ch05.q4": [
        _BALL.format(mask="(hue < 6) & (colourful > 150)", answer="(rows.mean(), columns.mean())"),
        _BALL.format(mask="(hue > 100) & (hue < 130) & (colourful > 150)", answer="(columns.mean(), rows.mean())"),
        _BALL.format(mask=_RED, answer="(columns.min(), rows.min())"),
        _BALL.format(mask=_RED, answer="(float('nan'), float('nan'))"),
        _BALL.format(mask=_RED, answer="by_heart(frame)") + _BY_HEART,
    ],
    "ch05.q5": [
        """%%write -a src/s5_cpp_camera/src/cpp_lamp_node.cpp

SetParametersResult CppLamp::judge(const std::vector<rclcpp::Parameter> & parameters) {
  SetParametersResult result;
  const auto & one = parameters.front();
  result.successful = one.get_name() != "lamp.colour" || one.as_string() == "green" || one.as_string() == "amber" ||
                      one.as_string() == "red";
  result.reason = result.successful ? "" : "no such colour";
  return result;
}
""",
        """%%write -a src/s5_cpp_camera/src/cpp_lamp_node.cpp

SetParametersResult CppLamp::judge(const std::vector<rclcpp::Parameter> & parameters) {
  SetParametersResult result;
  result.successful = true;
  for (const auto & one : parameters) {
    const std::string colour = one.as_string();
    if (colour != "green" && colour != "amber" && colour != "red") result.successful = false;
  }
  result.reason = "no such colour";
  return result;
}
""",
    ],
}
