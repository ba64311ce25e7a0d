"""Ctrl-C in `ros2 action send_goal` cancels the goal."""

from coursekit.cli.parser import run
from coursekit.processes.session import Session


def started(session, *argv):
    return session.start(lambda: run(argv), name="ros2", argv=list(argv))


def test_ctrl_c_cancels_the_goal_and_says_so():
    with Session(virtual=True).use() as session:
        server = started(session, "run", "turtlesim", "turtlesim_node")
        session.clock.sleep(0.5)
        kind = "turtlesim/action/RotateAbsolute"
        client = started(session, "action", "send_goal", "/turtle1/rotate_absolute", kind, "{theta: 3.0}")
        session.clock.sleep(0.5)
        client.interrupt()
        assert client.wait(5) == 0
        assert client.output.endswith("Canceling goal...\nGoal canceled.\n")
        server.interrupt()
        server.wait(5)
