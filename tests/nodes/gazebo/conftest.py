"""A node beside the simulator, and robots in it."""

from pathlib import Path

import pytest
import rclpy
from geometry_msgs.msg import Twist

ROBOT = Path(__file__).parents[3] / "robots" / "urdf" / "rdk_x3_robot.urdf"


class Friend:
    """A node beside the simulator."""

    def __init__(self, session):
        self.session = session
        self.context = rclpy.context.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node("friend", context=self.context)
        self.executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.drive = self.node.create_publisher(Twist, "cmd_vel", 10)

    def hear(self, kind, topic):
        heard = []
        self.node.create_subscription(kind, topic, heard.append, 10)
        return heard

    def spin(self, seconds):
        until = self.session.clock.steady() + round(seconds * 1e9)
        while self.session.clock.steady() < until:
            self.executor.spin_once(timeout_sec=(until - self.session.clock.steady()) * 1e-9)

    def go(self, seconds, forward, turn=0.0):
        twist = Twist()
        twist.linear.x, twist.angular.z = forward, turn
        self.drive.publish(twist)
        self.spin(seconds)

    def ask(self, kind, service, /, **request):
        client = self.node.create_client(kind, service)
        assert client.wait_for_service(timeout_sec=5.0)
        asked = client.call_async(kind.Request(**request))
        self.executor.spin_until_future_complete(asked, timeout_sec=5.0)
        return asked.result()


@pytest.fixture
def friend(session):
    return Friend(session)


@pytest.fixture
def spawn(run):
    def spawn(*more, file=ROBOT, name="rdk"):
        process = run("gazebo_ros", "spawn_entity.py", "-file", str(file), "-entity", name, *more)
        process.wait(40)
        return process

    return spawn
