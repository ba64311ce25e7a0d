"""What the controller manager says and does with the hardware of a workspace, and what a script asks of it meanwhile."""

from __future__ import annotations

import re
import textwrap

from tests.packages.test_cpp_workspace import scripted

STAGE = """
from pathlib import Path
import rclpy
from controller_manager_msgs.srv import SetHardwareComponentState
from coursekit.cli.parser import run as run_cli
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session
from geometry_msgs.msg import Twist
from sensor_msgs.msg import JointState

share = Path("install/k_cart/share/k_cart")
text = (share / "urdf" / "cart.urdf").read_text()
for old, new in CHANGES.items():
    assert old in text
    text = text.replace(old, new)
Path("changed.urdf").write_text(text)
with (session := Session(virtual=VIRTUAL)).use():
    def run(package, name, *words):
        return session.launch(make_process(session, find(package, name), words, name=name))

    def spawn(*names):
        spawner = run("controller_manager", "spawner", *names)
        print("spawned", spawner.wait(30.0))

    def drive(speed):
        message = Twist()
        message.linear.x = speed
        while not joints or abs(joints[-1].velocity[0] - 20 * speed) > 1e-6:
            publisher.publish(message)
            rclpy.spin_once(node)

    def bring(label):
        client = node.create_client(SetHardwareComponentState, "/controller_manager/set_hardware_component_state")
        client.wait_for_service(5.0)
        request = SetHardwareComponentState.Request(name="cart")
        request.target_state.label = label
        future = client.call_async(request)
        rclpy.spin_until_future_complete(node, future, timeout_sec=15)
        print(label, future.result().ok, future.result().state.label)

    def ros2(*words):
        process = session.start(lambda: run_cli(list(words)), name="ros2")
        print(process.wait(20.0), process.output)

    run("robot_state_publisher", "robot_state_publisher", "changed.urdf")
    words = ["--ros-args", "--params-file", str(share / "config" / "controllers.yaml"), *WORDS]
    control = run("controller_manager", "ros2_control_node", *words)
    rclpy.init()
    node = rclpy.create_node("driver")
    joints = []
    node.create_subscription(JointState, "/joint_states", joints.append, 10)
    publisher = node.create_publisher(Twist, "/drive/cmd_vel_unstamped", 10)
    BODY
    control.interrupt()
    print("ended", control.wait(10.0))
print(control.output)
"""


def told(folder, body="pass", *, virtual=True, words=(), changes=None):
    """What the script prints, and then the controller manager, without stamps."""
    text = STAGE.replace("BODY", textwrap.indent(textwrap.dedent(body), "    ").strip())
    head = f"CHANGES = {changes or {}!r}\nVIRTUAL = {virtual}\nWORDS = {list(words)!r}\n"
    done = scripted(folder, head + text)
    assert done.returncode == 0, done.stdout + done.stderr
    return re.sub(r"\[\d+\.\d+\] ", "", done.stdout)


def faulty(fault):
    """A change of the description: the cart does something wrong."""
    gain = '<param name="gain">2.0</param>'
    return {gain: f'{gain}<param name="fault">{fault}</param>'}


def resources(text):
    """The lines of the resource manager and the driver."""
    return re.findall(r"^\[(?:INFO|WARN|ERROR)\] \[(?:resource_manager|Cart)\]: (.*?) *$", text, re.MULTILINE)
