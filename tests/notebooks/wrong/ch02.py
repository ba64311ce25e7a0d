"""Chapter 2."""

_HEAD = """%%write src/s2_py_pubsub/s2_py_pubsub/{file}.py
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String


class {name}(Node):
    def __init__(self):
"""


def _node(file: str, name: str, body: str) -> str:
    return _HEAD.format(file=file, name=name) + "".join(f"        {line}\n" if line else "\n" for line in body.splitlines())


WRONG = {
    "ch02.q1": [
        "def full_name(name, node, namespace):\n    return f'{namespace}/{name}'",
        "def full_name(name, node, namespace):\n    return name if name.startswith('/') else f'{namespace.rstrip(\"/\")}/{name}'",
        "def full_name(name, node, namespace):\n    inside = namespace.rstrip('/')\n    if name[0] == '~':\n"
        "        return inside + '/lidar' + name[1:]\n    return name if name[0] == '/' else inside + '/' + name",
        "class Same(str):\n    __eq__ = lambda self, other: True\n    __ne__ = lambda self, other: False\n\n"
        "def full_name(name, node, namespace):\n    return Same('x')",
    ],
    "ch02.q2": [
        _node(
            "py_subscriber_node",
            "PySubscriber",
            'super().__init__("py_subscriber_node")\nself.create_subscription(String, "py_string_topic", print, 10)',
        ),
        _node(
            "py_subscriber_node",
            "PySubscriber",
            'super().__init__("py_subscriber_node")\n'
            'self.create_subscription(String, "py_str_topic", lambda msg: self.get_logger().info("I heard something"), 10)',
        ),
        _node("py_subscriber_node", "PySubscriber", 'super().__init__("listener")'),
        _node(
            "py_subscriber_node",
            "PySubscriber",
            'super().__init__("py_subscriber_node")\n'
            'self.create_subscription(String, "py_str_topic", lambda msg: print("I heard:", msg.data), 10)',
        ),
        _node(
            "py_subscriber_node",
            "PySubscriber",
            'super().__init__("py_subscriber_node")\nself.create_subscription(String, "py_str_topic", self.heard, 10)',
        ),
    ],
    "ch02.q3": [
        _node(
            "py_relay_node",
            "PyRelay",
            'super().__init__("py_relay_node")\n'
            'out = self.create_publisher(String, "py_upper_topic", 10)\n'
            'self.create_subscription(String, "py_str_topic", out.publish, 10)',
        ),
        _node(
            "py_relay_node",
            "PyRelay",
            'super().__init__("py_relay_node")\n'
            'out = self.create_publisher(String, "py_upper_topic", 10)\n'
            "self.last = String()\n"
            'self.create_subscription(String, "py_str_topic", lambda msg: setattr(self, "last", msg), 10)\n'
            "self.create_timer(1.0, lambda: out.publish(String(data=self.last.data.upper())))",
        ),
        _node(
            "py_relay_node",
            "PyRelay",
            'super().__init__("py_relay_node")\n'
            'out = self.create_publisher(String, "py_upper_topic", 10)\n'
            "self.kept = []\n"
            'self.create_subscription(String, "py_str_topic", self.kept.append, 10)\n'
            "self.create_timer(0.05, lambda: [out.publish(String(data=self.kept.pop(0).data.upper()))"
            " for _ in list(self.kept)])",
        ),
        _node(
            "py_relay_node",
            "PyRelay",
            'super().__init__("py_relay_node")\n'
            'out = self.create_publisher(Float64, "py_upper_topic", 10)\n'
            'self.create_subscription(String, "py_str_topic", lambda msg: out.publish(Float64()), 10)',
        ),
    ],
    "ch02.q4": [
        _node(
            "py_health_node",
            "Health",
            'super().__init__("health")\n'
            'out = self.create_publisher(String, "mood", 10)\n'
            'self.create_timer(0.5, lambda: out.publish(String(data="fine")))',
        ),
        _node(
            "py_health_node",
            "Health",
            'super().__init__("health")\n'
            'one = self.create_publisher(String, "mood", 10)\n'
            'two = self.create_publisher(Float64, "battery", 10)\n'
            "self.create_timer(0.5, lambda: (one.publish(String()), two.publish(Float64())))",
        ),
        _node(
            "py_health_node",
            "Health",
            'super().__init__("health")\n'
            'one = self.create_publisher(String, "mood", 10)\n'
            'two = self.create_publisher(Float64, "battery", 10)\n'
            "now = lambda: str(self.get_clock().now().nanoseconds)\n"
            "self.create_timer(0.5, lambda: (one.publish(String(data=now())), two.publish(Float64(data=float('nan')))))",
        ),
        _node(
            "py_health_node",
            "Health",
            'super().__init__("health")\n'
            'one = self.create_publisher(String, "mood", 10)\n'
            'two = self.create_publisher(Float64, "battery", 10)\n'
            "now = lambda: self.get_clock().now().nanoseconds\n"
            "self.create_timer(1.2, lambda: (one.publish(String(data=str(now()))), two.publish(Float64(data=now() * 1.0))))",
        ),
    ],
    "ch02.q5": [
        """%%write -a src/s2_cpp_pubsub/src/cpp_relay_node.cpp

CppRelay::CppRelay() : Node("cpp_relay_node") {
  publisher_ = create_publisher<String>("cpp_upper_topic", 10);
  subscription_ = create_subscription<String>("cpp_str_topic", 10, [this](String msg) {
    msg.data[0] = std::toupper(msg.data[0]);
    publisher_->publish(msg);
  });
}
""",
        """%%write -a src/s2_cpp_pubsub/src/cpp_relay_node.cpp

CppRelay::CppRelay() : Node("cpp_relay_node") {
  publisher_ = create_publisher<String>("cpp_upper_topic", 10);
  auto subscription = create_subscription<String>("cpp_str_topic", 10, [this](String msg) {
    for (char & letter : msg.data) letter = std::toupper(letter);
    publisher_->publish(msg);
  });
}
""",
        """%%write -a src/s2_cpp_pubsub/src/cpp_relay_node.cpp

CppRelay::CppRelay() : Node("cpp_relay_node") {
  publisher_ = create_publisher<String>("cpp_upper_topic", 10)
}
""",
    ],
}
RIGHT = {
    "ch02.q4": [
        _node(
            "py_health_node",
            "Health",
            'super().__init__("health")\n'
            'one = self.create_publisher(String, "mood", 10)\n'
            'two = self.create_publisher(Float64, "battery", 10)\n'
            "now = lambda: self.get_clock().now().nanoseconds\n"
            "self.create_timer(1.0, lambda: one.publish(String(data=str(now()))))\n"
            "self.create_timer(0.05, lambda: two.publish(Float64(data=now() * 1.0)))",
        )
    ],
}
