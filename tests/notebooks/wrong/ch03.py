"""Chapter 3."""

_PACKAGE = "src/s3_py_srvcli/s3_py_srvcli"


def _lift(*lines: str) -> str:
    return "state = {'holding': False}\n\ndef lift(request, response):\n" + "".join(f"    {line}\n" for line in lines)


def _client(*lines: str) -> str:
    head = f"%%write {_PACKAGE}/client_main.py\nimport sys\n\nimport rclpy\n"
    head += "from s3_py_srvcli.py_client_async_node import PyClientAsync\n\n\ndef main():\n"
    return head + "".join(f"    {line}\n" for line in lines)


_USAGE = ("if len(sys.argv) != 3:", "    print('usage: client_exe A B')", "    return 1")
_ASK = (
    "rclpy.init()",
    "node = PyClientAsync()",
    "a, b = int(sys.argv[1]), int(sys.argv[2])",
    "future = node.ask(a, b)",
)


def _gate(client: str, *callback: str) -> str:
    head = f"""%%write {_PACKAGE}/py_gate_node.py
from example_interfaces.srv import AddTwoInts
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node


class PyGate(Node):
    def __init__(self):
        super().__init__("py_gate_node")
        self.client = self.create_client(AddTwoInts, "py_add_two_ints_service"{client})
        self.create_service(AddTwoInts, "py_gate_service", self.count)

"""
    return head + "".join(f"    {line}\n" for line in callback)


def _switch(*lines: str) -> str:
    head = f"""%%write {_PACKAGE}/py_switch_node.py
from rclpy.node import Node
from std_msgs.msg import Bool
from std_srvs.srv import SetBool


class Switch(Node):
    def __init__(self):
        super().__init__("horn")
        self.on = False
        self.horn = self.create_publisher(Bool, "horn", 10)
        self.create_timer(0.5, lambda: self.horn.publish(Bool(data=self.on)))
        self.create_service(SetBool, "switch_horn", self.switch)

"""
    return head + "".join(f"    {line}\n" for line in lines)


WRONG = {
    "ch03.q1": [
        _lift("response.success = request.data != state['holding']", "response.message = 'done'"),
        _lift("state['holding'] = request.data", "response.success = True", "response.message = 'ok'", "return response"),
        _lift(
            "response.success = request.data != state['holding']",
            "state['holding'] = request.data",
            "return response",
        ),
    ],
    "ch03.q2": [
        _client(*_ASK, "rclpy.spin_until_future_complete(node, future)", "print(future.result().sum)"),
        _client(
            "if len(sys.argv) != 3:",
            "    print('usage: client_exe A B')",
            "    return",
            *_ASK,
            "rclpy.spin_until_future_complete(node, future)",
        ),
        _client(*_USAGE, *_ASK, "rclpy.spin(node)"),
        _client(*_USAGE, *_ASK, "node.get_logger().info(f'{a} + {b} = {future.result().sum}')"),
        _client(*_USAGE, "a, b = sys.argv[1:]", "rclpy.init()", "print(f'{a} + {b} = {int(a) + int(b)}')"),
        _client(
            *_USAGE,
            *_ASK,
            "rclpy.spin_until_future_complete(node, future)",
            "node.get_logger().info(f'{a} + {b} = {a + b}')",
        ),
    ],
    "ch03.q3": [
        _gate(
            "",
            "def count(self, request, response):",
            "    response.sum = self.client.call(request).sum + 10",
            "    return response",
        ),
        _gate(
            "",
            "async def count(self, request, response):",
            "    response.sum = (await self.client.call_async(request)).sum + 10",
            "    return response",
        ),
        _gate(
            "",
            "def count(self, request, response):",
            "    response.sum = request.a + request.b + 10",
            "    return response",
        ),
        _gate(
            ", callback_group=ReentrantCallbackGroup()",
            "async def count(self, request, response):",
            "    return await self.client.call_async(request)",
        ),
        _gate(
            ", callback_group=ReentrantCallbackGroup()",
            "async def count(self, request, response):",
            "    await self.client.call_async(request)",
            "    response.sum = request.a + request.b + 10",
            "    return response",
        ),
    ],
    "ch03.q4": [
        _switch(
            "def switch(self, request, response):",
            "    self.on = request.data",
            "    return response",
        ),
        _switch(
            "def switch(self, request, response):",
            "    response.success, response.message = True, 'on' if request.data else 'off'",
            "    return response",
        ),
        _switch(
            "def switch(self, request, response):",
            "    self.on, response.success, response.message = True, True, 'toot'",
            "    return response",
        ),
        _switch(
            "def switch(self, request, response):",
            "    response.success, response.message = True, 'on' if request.data else 'off'",
            "    return response",
        ).replace("Bool(data=self.on)", "UInt64(data=self.get_clock().now().nanoseconds)")
        .replace("(Bool, ", "(UInt64, ").replace("import Bool\n", "import UInt64\n"),
    ],
    "ch03.q5": [
        """%%write -a src/s3_cpp_srvcli/src/cpp_gripper_node.cpp

void CppGripper::lift(const SetBool::Request & request, SetBool::Response & response) {
  response.success = request.data != holding_;
  holding_ = true;
  response.message = "done, or not";
}
""",
        """%%write -a src/s3_cpp_srvcli/src/cpp_gripper_node.cpp

void CppGripper::lift(const SetBool::Request & request, SetBool::Response & response) {
  response.success = request.data != holding_;
  if (response.success) holding_ = request.data;
}
""",
    ],
}
_SAYS = "def switch(self, request, response):", "    self.on = request.data", (
    "    return SetBool.Response(success=True, message=f'it is {self.on}')"
)
RIGHT = {
    "ch03.q1": ["""state = {"holding": False}

def lift(request, response):
    global state
    response.success, response.message = state["holding"] != request.data, "done, or not"
    state = {"holding": request.data}
    return response"""],
    "ch03.q4": [
        _switch(*_SAYS)
        .replace("Bool(data=self.on)", "String(data=f'{self.on} at {self.get_clock().now().nanoseconds}')")
        .replace("(Bool, ", "(String, ").replace("import Bool\n", "import String\n"),
    ],
}
