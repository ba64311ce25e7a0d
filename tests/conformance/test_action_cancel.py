import pytest
from action_msgs.msg import GoalStatus
from action_msgs.srv import CancelGoal
from action_setup import defer, succeed
from rclpy.action import (
    CancelResponse,
)
from test_msgs.action import Fibonacci
from unique_identifier_msgs.msg import UUID


def cancelled(handle):
    handle.canceled()
    return Fibonacci.Result(sequence=[0])


def test_an_accepted_goal_can_be_cancelled(setup):
    handles = []
    action = setup(cancelled, **defer(handles))
    client_handle = action.send()
    action.world.spin_until(lambda: handles)
    response = action.world.result(client_handle.cancel_goal_async())
    assert (response.return_code, len(response.goals_canceling)) == (0, 1)
    assert handles[0].is_cancel_requested
    handles[0].execute()
    assert action.outcome(client_handle) == (GoalStatus.STATUS_CANCELED, [0])


@pytest.mark.parametrize("answer", [CancelResponse.REJECT, None, 1])
def test_a_refused_cancel_leaves_the_goal(setup, answer):
    handles = []
    options = defer(handles) | {"cancel_callback": lambda handle: answer}
    action = setup(succeed, **options)
    client_handle = action.send()
    action.world.spin_until(lambda: handles)
    assert action.world.result(client_handle.cancel_goal_async()).goals_canceling == []
    assert not handles[0].is_cancel_requested


def test_an_unknown_goal_is_not_cancelled(setup):
    action = setup(succeed)
    response = action.cancel(goal_id=UUID(uuid=[1] * 16))
    assert response.return_code == CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID


def test_no_id_cancels_all(setup):
    handles = []
    action = setup(cancelled, **defer(handles))
    action.send()
    action.send()
    action.world.spin_until(lambda: len(handles) == 2)
    assert len(action.cancel().goals_canceling) == 2


def test_a_stamp_cancels_what_came_before(setup):
    handles = []
    action = setup(cancelled, **defer(handles))
    first = action.send()
    between = action.node.get_clock().now().to_msg()
    action.send()
    action.world.spin_until(lambda: len(handles) == 2)
    response = action.cancel(stamp=between)
    assert [bytes(info.goal_id.uuid) for info in response.goals_canceling] == [bytes(first.goal_id.uuid)]
