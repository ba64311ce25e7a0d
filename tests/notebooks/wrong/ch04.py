"""Chapter 4."""

_TYPES = "src/s4_custom_interface/msg"
_APPS = "src/s4_py_apps/s4_py_apps"


def _type(name: str, *lines: str) -> str:
    return f"%%write {_TYPES}/{name}.msg\n" + "\n".join(lines) + "\n"


def _listener(status: str, sphere: str) -> str:
    return f"""%%write {_APPS}/py_subscriber_node.py
import math
from rclpy.node import Node
from s4_custom_interface.msg import HardwareStatus, Sphere

class PySubscriber(Node):
    def __init__(self):
        super().__init__("py_subscriber_node")
        log = self.get_logger().info
        self.create_subscription(HardwareStatus, "py_hs_topic", lambda msg: log({status}), 10)
        self.create_subscription(Sphere, "py_sphere_topic", lambda msg: log({sphere}), 10)
"""


def _work(*lines: str) -> str:
    head = f"%%write {_APPS}/fetching.py\nimport time\nfrom s4_custom_interface.action import Fetch\n\n"
    return head + "def work(goal_handle):\n" + "".join(f"    {line}\n" for line in lines)


_UP = "f\"{msg.temperature} degrees, motors {'up' if msg.are_motors_up else 'down'}\""
_VOLUME = 'f"volume {4 / 3 * math.pi * msg.radius**3:.2f}"'

WRONG = {
    "ch04.q1": [
        _type("Sphere", "geometry_msgs/Point center", "double radius  # metres"),
        _type("Sphere", "Point center", "float64 radius  # metres"),
        _type("Sphere", "float64 radius  # metres", "geometry_msgs/Point center"),
        _type("Sphere", "geometry_msgs/Point center", "float64 radius"),
        _type("Sphere", "geometry_msgs/Point center", "float64 radius  # how large it is"),
        _type("Sphere", "# metres", "", "geometry_msgs/Point center", "float64 radius"),
        _type("Sphere", "geometry_msgs/msg/Point center", "float64 radius  # metres"),
    ],
    "ch04.q2": [
        _listener(_UP, 'f"volume {4 / 3 * math.pi * msg.radius**2:.2f}"'),
        _listener('f"{msg.temperature} degrees, motors {msg.are_motors_up}"', _VOLUME),
        _listener(_UP, 'f"volume {4 / 3 * math.pi * msg.center.radius**3:.2f}"'),
    ],
    "ch04.q3": [
        _work(
            "time.sleep(0.5 * goal_handle.request.boxes)",
            "goal_handle.succeed()",
            "return Fetch.Result(brought=goal_handle.request.boxes)",
        ),
        _work(
            "for brought in range(goal_handle.request.boxes):",
            "    time.sleep(0.5)",
            "    goal_handle.publish_feedback(Fetch.Feedback(brought_yet=brought + 1))",
            "goal_handle.succeed()",
            "return Fetch.Result(brought=goal_handle.request.boxes)",
        ),
        _work(
            "for brought in range(goal_handle.request.boxes):",
            "    if goal_handle.is_cancel_requested:",
            "        goal_handle.canceled()",
            "        return Fetch.Result()",
            "    time.sleep(0.5)",
            "    goal_handle.publish_feedback(Fetch.Feedback(brought_yet=brought + 1))",
            "goal_handle.succeed()",
            "return Fetch.Result(brought=goal_handle.request.boxes)",
        ),
        _work(
            "for brought in range(goal_handle.request.boxes):",
            "    time.sleep(0.5)",
            "    goal_handle.publish_feedback(Fetch.Feedback(brought_yet=brought + 1))",
            "return Fetch.Result(brought=goal_handle.request.boxes)",
        ),
    ],
    "ch04.q4": [
        _type("Report", "uint8 battery 100", "string driver", "float64[] shelves", "uint32 boxes_today"),
        _type("Report", "uint8 EMPTY=0", "uint8 battery 100", "string driver", "float64[] shelves"),
        _type("Report", "uint8 EMPTY=0", "uint8 battery=100", "string driver", "float64[] shelves", "uint32 boxes_today"),
        _type("Report", "uint8 EMPTY=0", "uint8 battery", "string driver", "float64[] shelves", "uint32 boxes_today"),
    ],
    "ch04.q5": [
        """%%write -a src/s4_cpp_apps/src/cpp_alarm_node.cpp

CppAlarm::CppAlarm() : Node("cpp_alarm_node") {
  alarms_ = create_publisher<HardwareStatus>("cpp_alarm_topic", 10);
  statuses_ = create_subscription<HardwareStatus>("cpp_hs_topic", 10, [this](HardwareStatus status) {
    status.debug_message = "too hot";
    if (status.temperature >= 60) alarms_->publish(status);
  });
}
""",
        """%%write -a src/s4_cpp_apps/src/cpp_alarm_node.cpp

CppAlarm::CppAlarm() : Node("cpp_alarm_node") {
  alarms_ = create_publisher<HardwareStatus>("cpp_alarm_topic", 10);
  statuses_ = create_subscription<HardwareStatus>("cpp_hs_topic", 10, [this](const HardwareStatus & status) {
    if (status.temperature > 60) alarms_->publish(status);
  });
}
""",
    ],
}
RIGHT = {
    "ch04.q1": [
        _type("Sphere", "geometry_msgs/Point center", "float64 radius  # [m]"),
        _type("Sphere", "geometry_msgs/Point center", "# half of its width, in meters", "float64 radius"),
    ],
}
