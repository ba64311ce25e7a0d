import threading
import time

import pytest
from action_msgs.msg import GoalStatus
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from test_msgs.action import Fibonacci
from unique_identifier_msgs.msg import UUID


def execute(goal_handle):
    feedback = Fibonacci.Feedback(sequence=[0, 1])
    for _ in range(goal_handle.request.order):
        goal_handle.publish_feedback(feedback)
    goal_handle.succeed()
    return Fibonacci.Result(sequence=[goal_handle.request.order])


@pytest.fixture
def pair(world):
    node = world.node()
    server = ActionServer(node, Fibonacci, "fibonacci", execute)
    client = ActionClient(node, Fibonacci, "fibonacci")
    assert client.wait_for_server(timeout_sec=8.0)
    yield world, client
    client.destroy()
    server.destroy()


def goal(order=1):
    return Fibonacci.Goal(order=order)


def test_a_goal_is_accepted(pair):
    world, client = pair
    handle = world.result(client.send_goal_async(goal()))
    assert handle.accepted
    assert handle.stamp.sec > 0
    assert len(handle.goal_id.uuid) == 16


def test_the_result_arrives_with_its_status(pair):
    world, client = pair
    handle = world.result(client.send_goal_async(goal(3)))
    response = world.result(handle.get_result_async())
    assert response.status == GoalStatus.STATUS_SUCCEEDED
    assert list(response.result.sequence) == [3]
    assert handle.status == GoalStatus.STATUS_SUCCEEDED


@pytest.fixture
def waiting(world):
    """A client, and the goals that its server has accepted and not begun."""
    node, goals = world.node(), []
    server = ActionServer(node, Fibonacci, "fibonacci", execute, handle_accepted_callback=goals.append)
    client = ActionClient(node, Fibonacci, "fibonacci")
    assert client.wait_for_server(timeout_sec=8.0)
    yield world, client, goals
    client.destroy()
    server.destroy()


def test_feedback_arrives(waiting):
    world, client, goals = waiting
    heard = []
    handle = world.result(client.send_goal_async(goal(), feedback_callback=heard.append))
    world.spin_until(lambda: goals)
    for number in range(4):
        goals[0].publish_feedback(Fibonacci.Feedback(sequence=[number]))
    world.spin_until(lambda: len(heard) == 4)
    assert [list(message.feedback.sequence) for message in heard] == [[0], [1], [2], [3]]
    assert bytes(heard[0].goal_id.uuid) == bytes(handle.goal_id.uuid)


def test_feedback_of_other_goals_is_not_passed_on(waiting):
    world, client, goals = waiting
    one, two = [], []
    kept = [
        world.result(client.send_goal_async(goal(), feedback_callback=heard.append)) for heard in (one, two)
    ]
    world.spin_until(lambda: len(goals) == 2)
    for each in goals:
        each.publish_feedback(Fibonacci.Feedback(sequence=[1]))
    world.spin_until(lambda: one and two)
    world.spin_for(0.1)
    assert (len(one), len(two), len(kept)) == (1, 1, 2)


def test_a_coroutine_may_hear_feedback(waiting):
    world, client, goals = waiting
    heard = []

    async def hear(message):
        heard.append(message)

    kept = world.result(client.send_goal_async(goal(), feedback_callback=hear))
    world.spin_until(lambda: goals)
    goals[0].publish_feedback(Fibonacci.Feedback())
    world.spin_until(lambda: heard)
    assert kept.accepted


def test_who_has_the_result_hears_no_more_feedback(pair):
    world, client = pair
    heard = []
    speaker = world.nodes[0].create_publisher(Fibonacci.Impl.FeedbackMessage, "fibonacci/_action/feedback", 10)
    handle = world.result(client.send_goal_async(goal(), feedback_callback=heard.append))
    world.result(handle.get_result_async())
    heard.clear()
    speaker.publish(Fibonacci.Impl.FeedbackMessage(goal_id=handle.goal_id))
    world.spin_for(0.3)
    assert heard == []


def test_an_id_may_be_given(pair):
    world, client = pair
    uuid = UUID(uuid=list(range(16)))
    handle = world.result(client.send_goal_async(goal(), goal_uuid=uuid))
    assert list(handle.goal_id.uuid) == list(range(16))


def test_an_id_is_accepted_once(pair):
    world, client = pair
    uuid = UUID(uuid=[5] * 16)
    futures = [client.send_goal_async(goal(), goal_uuid=uuid) for _ in range(2)]
    assert sorted(world.result(future).accepted for future in futures) == [False, True]


@pytest.mark.parametrize("other", [1, None, "goal", Fibonacci.Result(), Fibonacci.Feedback()])
def test_another_type_is_no_goal(pair, other):
    _, client = pair
    with pytest.raises(TypeError):
        client.send_goal_async(other)
    with pytest.raises(TypeError):
        client.send_goal(other)


def test_a_goal_that_has_ended_is_not_cancelled(pair):
    world, client = pair
    handle = world.result(client.send_goal_async(goal()))
    world.result(handle.get_result_async())
    response = world.result(handle.cancel_goal_async())
    assert (response.return_code, response.goals_canceling) == (3, [])


def test_send_goal_waits_for_the_result(pair):
    world, client = pair
    results = []
    thread = threading.Thread(target=lambda: results.append(client.send_goal(goal(2))), daemon=True)
    thread.start()
    world.spin_until(lambda: results)
    thread.join(timeout=5)
    assert list(results[0].result.sequence) == [2]


def test_no_server_is_not_waited_for_when_told_so(world):
    client = ActionClient(world.node(), Fibonacci, "absent")
    before = time.monotonic()
    assert not client.wait_for_server(timeout_sec=0.0)
    assert not client.server_is_ready()
    assert not client.wait_for_server(timeout_sec=0.3)
    assert time.monotonic() - before < 5
    client.destroy()


def test_a_server_that_goes_is_not_ready(world):
    node = world.node()
    server = ActionServer(node, Fibonacci, "fibonacci", execute)
    client = ActionClient(node, Fibonacci, "fibonacci")
    assert client.wait_for_server(timeout_sec=8.0)
    server.destroy()
    world.spin_until(lambda: not client.server_is_ready())
    client.destroy()


def test_a_rejected_goal_says_so(world):
    node = world.node()
    server = ActionServer(node, Fibonacci, "f", execute, goal_callback=lambda g: GoalResponse.REJECT)
    client = ActionClient(node, Fibonacci, "f")
    assert client.wait_for_server(timeout_sec=8.0)
    assert not world.result(client.send_goal_async(goal())).accepted
    client.destroy()
    server.destroy()


def test_cancelling_works_while_executing(make_world):
    world = make_world(executor_class=lambda context: MultiThreadedExecutor(3, context=context))
    node = world.node()

    def until_cancelled(handle):
        end = time.monotonic() + 8
        while not handle.is_cancel_requested and time.monotonic() < end:
            time.sleep(0.01)
        handle.canceled()
        return Fibonacci.Result(sequence=[9])

    group = ReentrantCallbackGroup()
    server = ActionServer(
        node,
        Fibonacci,
        "f",
        until_cancelled,
        callback_group=group,
        cancel_callback=lambda handle: CancelResponse.ACCEPT,
    )
    client = ActionClient(node, Fibonacci, "f", callback_group=group)
    assert client.wait_for_server(timeout_sec=8.0)
    handle = world.result(client.send_goal_async(goal()))
    response = world.result(handle.cancel_goal_async())
    assert response.return_code == 0
    assert bytes(response.goals_canceling[0].goal_id.uuid) == bytes(handle.goal_id.uuid)
    result = world.result(handle.get_result_async())
    assert (result.status, list(result.result.sequence)) == (GoalStatus.STATUS_CANCELED, [9])
    client.destroy()
    server.destroy()


def test_the_handle_shows_itself(pair):
    world, client = pair
    handle = world.result(client.send_goal_async(goal()))
    assert "ClientGoalHandle <id=" in repr(handle)
    assert "accepted=True" in repr(handle)


@pytest.mark.parametrize("name", ["a b", "a/", ""])
def test_a_bad_name_is_refused(world, name):
    with pytest.raises(ValueError, match="Failed to create action client due to invalid topic name"):
        ActionClient(world.node(), Fibonacci, name)
