"""What the tests of action servers share."""

from action_msgs.msg import GoalInfo
from action_msgs.srv import CancelGoal
from rclpy.action import (
    ActionClient,
    ActionServer,
    CancelResponse,
)
from test_msgs.action import Fibonacci


class Setup:
    """An action server and a client of one node."""

    def __init__(self, world, execute, **options):
        self.world = world
        self.node = world.node("n")
        self.server = ActionServer(self.node, Fibonacci, "f", execute, **options)
        self.client = ActionClient(self.node, Fibonacci, "f")
        assert self.client.wait_for_server(timeout_sec=8.0)

    def send(self, order=1):
        return self.world.result(self.client.send_goal_async(Fibonacci.Goal(order=order)))

    def outcome(self, handle):
        response = self.world.result(handle.get_result_async())
        return response.status, list(response.result.sequence)

    def cancel(self, **info):
        if not hasattr(self, "canceller"):
            self.canceller = self.node.create_client(CancelGoal, "f/_action/cancel_goal")
            assert self.canceller.wait_for_service(timeout_sec=8.0)
        request = CancelGoal.Request(goal_info=GoalInfo(**info))
        return self.world.result(self.canceller.call_async(request))

    def close(self):
        self.client.destroy()
        self.server.destroy()


def defer(handles):
    """A callback that keeps accepted goals for later."""
    return {
        "handle_accepted_callback": handles.append,
        "cancel_callback": lambda handle: CancelResponse.ACCEPT,
    }


def succeed(handle):
    handle.succeed()
    return Fibonacci.Result(sequence=[handle.request.order])
