"""`python -m tests.net.gateway_scene REAL_PYTHON`: robot, gateway and notebook in a network of their own; prints the facts.

Run by test_gateway.py, below `unshare -n`. Each wait ends when what it waits for happens, or after LIMIT.
"""

import json
import os
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.srv import GetParameters
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci

from coursekit.net import gateway_file
from coursekit.net.joining import join, leave
from coursekit.processes.session import current

HERE = Path(__file__).parent
LIMIT = 30.0
ADDRESS = "tcp/127.0.0.1:17447"
DOMAIN = int(os.environ.get("ROS_DOMAIN_ID") or 0)
REAL = sys.argv[-1]
OF_THE_ROBOT = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"} | {
    "FASTDDS_DEFAULT_PROFILES_FILE": str(HERE / "fast_loopback.xml"),
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
}


class Child:
    """A program, and the lines that it has said."""

    def __init__(self, *words):
        self.process = subprocess.Popen(
            [REAL, *map(str, words)], env=OF_THE_ROBOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
        )
        self.lines = []
        self.news = threading.Condition()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self.process.stdout:
            with self.news:
                self.lines.append(line.strip())
                self.news.notify_all()

    def until(self, holds):
        with self.news:
            return self.news.wait_for(lambda: holds(self.lines), LIMIT)

    def said(self, start):
        return [line for line in self.lines if line.startswith(start)]


def spin_until(node, holds):
    give_up = time.monotonic() + LIMIT
    while not holds() and time.monotonic() < give_up:
        rclpy.spin_once(node, timeout_sec=0.05)
    return bool(holds())


def result(node, future):
    rclpy.spin_until_future_complete(node, future, timeout_sec=LIMIT)
    return future.result()


class Notebook:
    """The notebook's node, and what it has heard."""

    def __init__(self):
        self.node = node = Node("notebook", namespace="/class")
        self.scans, self.latched, self.both = [], [], []
        node.create_subscription(LaserScan, "/scan", lambda msg: self.scans.append(msg.range_max), qos_profile_sensor_data)
        keeps = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        node.create_subscription(String, "/description", lambda msg: self.latched.append(msg.data), keeps)
        node.create_subscription(String, "/both", lambda msg: self.both.append(msg.data), 100)
        self.command = node.create_publisher(String, "/command", 10)
        self.speaker = node.create_publisher(String, "/both", 100)
        self.velocity = node.create_publisher(Twist, "/cmd_vel", 10)
        node.create_service(Trigger, "/notebook_trigger", self.trigger)

    def trigger(self, _request, response):
        response.success, response.message = True, "done by the notebook"
        return response

    def names(self):
        return sorted(name for name in self.node.get_node_names())

    def until(self, holds):
        return spin_until(self.node, holds)

    def ask(self, robot, word, holds):
        """Have the robot do something until it has said it."""
        give_up = time.monotonic() + LIMIT
        while not holds(robot.lines) and time.monotonic() < give_up:
            self.command.publish(String(data=word))
            spin_until_once = time.monotonic() + 0.5
            while not holds(robot.lines) and time.monotonic() < spin_until_once:
                rclpy.spin_once(self.node, timeout_sec=0.05)
        return holds(robot.lines)


def scene(folder):
    facts = {}
    file = Path(folder, "gateway.pyz")
    gateway_file.write(file)
    robot = Child(HERE / "gateway_robot.py")
    robot.until(lambda lines: "ready" in lines)
    gateway = Child(file, "--listen", ADDRESS)
    facts["gateway listens"] = gateway.until(lambda lines: any("Ctrl-C" in line for line in lines))
    second = Child(file, "--listen", "tcp/127.0.0.1:17448")
    facts["second's exit code"] = second.process.wait(LIMIT)
    second.until(lambda lines: any("already" in line for line in lines))
    facts["second says"] = " ".join(second.said("[gateway]"))
    rclpy.init()
    notebook = Notebook()
    node = notebook.node
    join(current(), DOMAIN, ADDRESS, confirm=lambda moves: bool(facts.setdefault("moves", moves)))
    facts["robot is seen"] = notebook.until(lambda: "robot" in notebook.names())
    facts["scans"] = notebook.until(lambda: len(notebook.scans) >= 5)
    facts["scans once and in order"] = notebook.scans == sorted(set(notebook.scans))
    notebook.until(lambda: notebook.latched)
    facts["latched"] = list(notebook.latched)
    trigger = node.create_client(Trigger, "/trigger")
    facts["service is ready"] = trigger.wait_for_service(LIMIT)
    facts["service"] = result(node, trigger.call_async(Trigger.Request())).message
    parameters = node.create_client(GetParameters, "/r1/robot/get_parameters")
    parameters.wait_for_service(LIMIT)
    answer = result(node, parameters.call_async(GetParameters.Request(names=["speed"])))
    facts["parameter"] = answer.values[0].double_value
    action, feedback = ActionClient(node, Fibonacci, "/fibonacci"), []
    action.wait_for_server(LIMIT)

    def act(order):
        goal = result(node, action.send_goal_async(Fibonacci.Goal(order=order), feedback_callback=feedback.append))
        return list(result(node, goal.get_result_async()).result.sequence)

    notebook.until(lambda: act(1) and feedback)  # DDS finds the way of the feedback while the first goals are carried out
    feedback.clear()
    facts["action"] = act(4)
    facts["feedback"] = [
        len(feedback_message.feedback.sequence) for feedback_message in feedback
    ]  # what comes after the result is not heard
    facts["robot calls"] = notebook.ask(robot, "call", lambda lines: "answer done by the notebook" in lines)
    notebook.ask(robot, "who", lambda lines: any("notebook" in line for line in lines if line.startswith("nodes")))
    facts["robot sees"] = [line for line in robot.said("nodes") if "notebook" in line][:1]
    # The same words from both sides at once: each is heard once by each.
    notebook.until(lambda: notebook.speaker.get_subscription_count() >= 2)
    notebook.both.clear()
    for number in range(20):
        notebook.speaker.publish(String(data=f"same {number % 2}"))
    robot.until(lambda lines: len([line for line in lines if line.startswith("both")]) >= 20)
    notebook.command.publish(String(data="publish"))
    facts["robot hears all"] = robot.until(lambda lines: len([line for line in lines if line.startswith("both")]) >= 40)
    facts["notebook hears all"] = notebook.until(lambda: len(notebook.both) >= 40)
    # What came twice would be there by the time of the next answer.
    result(node, trigger.call_async(Trigger.Request()))
    heard = len(notebook.scans)
    notebook.until(lambda: len(notebook.scans) > heard + 2)
    facts["heard on both"] = [len(robot.said("both")), len(notebook.both)]
    # The robot's restart, then the gateway's.
    robot.process.kill()
    facts["robot's end is seen"] = notebook.until(lambda: "robot" not in notebook.names())
    robot = Child(HERE / "gateway_robot.py")
    notebook.scans.clear()
    facts["robot's restart"] = notebook.until(lambda: "robot" in notebook.names() and len(notebook.scans) >= 3)
    gateway.process.kill()
    facts["gateway's end is seen"] = notebook.until(lambda: "robot" not in notebook.names())
    gateway = Child(file, "--listen", ADDRESS)
    notebook.scans.clear()
    facts["gateway's restart"] = notebook.until(lambda: "robot" in notebook.names() and len(notebook.scans) >= 3)
    # Who drives leaves: the robot is stopped.
    twist = Twist()
    twist.linear.x = 0.5
    notebook.until(lambda: notebook.velocity.publish(twist) or "velocity 0.5" in robot.lines)
    leave(current())
    facts["stopped"] = robot.until(lambda lines: lines[-1:] == ["velocity 0.0"])
    facts["notebook's end is seen"] = not current().graph(DOMAIN).find_nodes("robot", "/r1")
    for child in (robot, gateway):
        child.process.kill()
    facts["gateway says"] = gateway.lines
    return facts


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        print("FACTS", json.dumps(scene(folder)), flush=True)
    os._exit(0)
