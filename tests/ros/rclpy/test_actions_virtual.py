import time

import rclpy
from rclpy.action import ActionClient, ActionServer
from test_msgs.action import Fibonacci

from coursekit.processes.session import Session


def server():
    rclpy.init()
    node = rclpy.create_node("server")

    def execute(handle):
        for number in range(handle.request.order):
            handle.publish_feedback(Fibonacci.Feedback(sequence=[number]))
            time.sleep(60.0)
        handle.succeed()
        return Fibonacci.Result(sequence=[handle.request.order])

    ActionServer(node, Fibonacci, "slow", execute)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


def client():
    rclpy.init()
    node = rclpy.create_node("client")
    action = ActionClient(node, Fibonacci, "slow")
    action.wait_for_server()
    say = lambda message: node.get_logger().info(f"feedback {message.feedback.sequence[0]}")  # noqa: E731
    sent = action.send_goal_async(Fibonacci.Goal(order=3), feedback_callback=say)
    rclpy.spin_until_future_complete(node, sent)
    result = sent.result().get_result_async()
    rclpy.spin_until_future_complete(node, result)
    node.get_logger().info(f"result {list(result.result().result.sequence)} {sent.result().goal_id.uuid}")


def run():
    session = Session(virtual=True)
    with session.use():
        serving = session.start(server, name="server")
        asking = session.start(client, name="client")
        assert asking.wait() == 0
        serving.interrupt()
        assert serving.wait() == 0
        return asking.output


def test_minutes_of_an_action_pass_and_every_run_is_the_same():
    first = run()
    assert [line.rpartition("]: ")[2] for line in first.splitlines()][:3] == [
        f"feedback {i}" for i in range(3)
    ]
    assert "result [3]" in first
    assert run() == first
