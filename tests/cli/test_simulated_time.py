"""`ros2 topic ... -s` counts the seconds of /clock, not those that pass."""

import pytest
import rclpy
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

from coursekit.cli.parser import run
from coursekit.processes.session import Session


def robot():
    """Says something once a second, while simulated time goes twice as fast."""
    rclpy.init()
    node, time = rclpy.create_node("robot"), Clock()
    clock, chatter = node.create_publisher(Clock, "/clock", 10), node.create_publisher(String, "/chatter", 10)

    def tick():
        time.clock.sec += 1
        clock.publish(time)

    node.create_timer(0.5, tick)
    node.create_timer(1.0, lambda: chatter.publish(String(data="hello")))
    rclpy.spin(node)


@pytest.fixture
def ask():
    """Runs a command for some seconds of the session; what it printed."""
    with Session(virtual=True).use() as session:
        started = session.start(robot, name="robot")

        def command(words: str, seconds: float) -> str:
            process = session.start(lambda: run(words.split()), name="ros2")
            session.clock.sleep(seconds)
            process.interrupt()
            process.wait()
            return process.output

        yield command
        started.interrupt()
        started.wait()


def test_a_rate_is_that_of_simulated_time(ask):
    assert "average rate: 0.500\n" in ask("topic hz -s /chatter", 12.0)
    assert "average rate: 1.000\n" in ask("topic hz /chatter", 12.0)
    assert "average rate: 1.000\n" in ask("topic hz -s --wall-time /chatter", 12.0)


def test_a_bandwidth_is_that_of_simulated_time(ask):
    """A string of five letters takes 14 bytes, and a network sends whole words of four: 16 in two seconds.

    Of n messages n - 1 have two seconds after them: what is told comes close to 8.
    """
    told = ask("topic bw -s /chatter", 20.0)
    assert "\n8 B/s from 19 messages\n\tMessage size mean: 16 B min: 16 B max: 16 B\n" in told


def test_messages_are_published_by_simulated_time(ask):
    assert ask("topic pub -t 5 -w 0 -s /out std_msgs/msg/String", 3.0).count("publishing #") == 5
    assert ask("topic pub -t 5 -w 0 /out std_msgs/msg/String", 3.0).count("publishing #") < 5
