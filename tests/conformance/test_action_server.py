import pytest
from action_msgs.msg import GoalStatus, GoalStatusArray
from action_setup import defer, succeed
from rclpy.action import (
    ActionServer,
    GoalResponse,
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from rclpy.qos import qos_profile_action_status_default
from test_msgs.action import Fibonacci
from unique_identifier_msgs.msg import UUID


def test_the_services_and_topics_have_their_names(setup):
    node = setup(succeed).node
    services = {name for name, _ in node.get_service_names_and_types()}
    assert {"/f/_action/send_goal", "/f/_action/cancel_goal", "/f/_action/get_result"} <= services
    topics = dict(node.get_topic_names_and_types())
    assert topics["/f/_action/feedback"] == ["test_msgs/action/Fibonacci_FeedbackMessage"]
    assert topics["/f/_action/status"] == ["action_msgs/msg/GoalStatusArray"]


def test_actions_are_found_in_the_graph(setup):
    node = setup(succeed).node
    expected = [("/f", ["test_msgs/action/Fibonacci"])]
    assert get_action_names_and_types(node) == expected
    assert get_action_server_names_and_types_by_node(node, "n", "/") == expected
    assert get_action_client_names_and_types_by_node(node, "n", "/") == expected


def test_a_goal_succeeds(setup):
    action = setup(succeed)
    assert action.outcome(action.send(7)) == (GoalStatus.STATUS_SUCCEEDED, [7])


def test_a_goal_may_be_aborted(setup):
    def abort(handle):
        handle.abort()
        return Fibonacci.Result(sequence=[1])

    action = setup(abort)
    assert action.outcome(action.send()) == (GoalStatus.STATUS_ABORTED, [1])


def test_an_exception_aborts(setup, capfd):
    def fail(handle):
        raise ValueError("broken arm")

    action = setup(fail)
    assert action.outcome(action.send()) == (GoalStatus.STATUS_ABORTED, [])
    shown = capfd.readouterr().err
    assert "Error raised in execute callback: broken arm" in shown


def test_no_terminal_state_aborts(setup, capfd):
    action = setup(lambda handle: Fibonacci.Result())
    assert action.outcome(action.send()) == (GoalStatus.STATUS_ABORTED, [])
    assert "Goal state not set, assuming aborted. Goal ID:" in capfd.readouterr().err


def test_a_coroutine_may_execute(setup):
    async def later(handle):
        handle.succeed()
        return Fibonacci.Result(sequence=[3])

    action = setup(later)
    assert action.outcome(action.send()) == (GoalStatus.STATUS_SUCCEEDED, [3])


@pytest.mark.parametrize("answer", [GoalResponse.REJECT, None, 1, True])
def test_what_is_no_acceptance_rejects(setup, answer):
    assert not setup(succeed, goal_callback=lambda goal: answer).send().accepted


def test_the_goal_callback_sees_the_goal(setup):
    seen = []

    def look(goal):
        seen.append(goal)
        return GoalResponse.ACCEPT

    action = setup(succeed, goal_callback=look)
    assert action.send(4).accepted
    assert seen == [Fibonacci.Goal(order=4)]


def test_callbacks_may_be_coroutines(setup):
    async def accept(goal):
        return GoalResponse.ACCEPT

    action = setup(succeed, goal_callback=accept)
    assert action.outcome(action.send(2))[0] == GoalStatus.STATUS_SUCCEEDED


def test_execution_can_be_deferred(setup):
    handles = []
    action = setup(succeed, **defer(handles))
    client_handle = action.send(6)
    action.world.spin_until(lambda: handles)
    assert handles[0].status == GoalStatus.STATUS_ACCEPTED
    assert handles[0].is_active
    handles[0].execute()
    assert action.outcome(client_handle) == (GoalStatus.STATUS_SUCCEEDED, [6])
    assert not handles[0].is_active


def test_a_deferred_goal_may_have_its_own_callback(setup):
    handles = []
    action = setup(succeed, **defer(handles))
    client_handle = action.send()

    def other(handle):
        handle.abort()
        return Fibonacci.Result(sequence=[8])

    action.world.spin_until(lambda: handles)
    handles[0].execute(other)
    assert action.outcome(client_handle) == (GoalStatus.STATUS_ABORTED, [8])


@pytest.mark.parametrize("event", ["succeed", "abort", "canceled"])
def test_a_goal_that_is_not_executed_does_not_end(setup, event):
    handles = []
    action = setup(succeed, **defer(handles))
    action.send()
    action.world.spin_until(lambda: handles)
    with pytest.raises(RuntimeError, match="attempted invalid transition from state ACCEPTED"):
        getattr(handles[0], event)()


def test_a_goal_ends_once(setup):
    errors = []

    def twice(handle):
        handle.succeed()
        try:
            handle.abort()
        except RuntimeError as error:
            errors.append(str(error))
        return Fibonacci.Result()

    action = setup(twice)
    assert action.outcome(action.send())[0] == GoalStatus.STATUS_SUCCEEDED
    assert "from state SUCCEEDED with event ABORT" in errors[0]


def test_only_a_goal_that_was_asked_to_is_canceled(setup):
    errors = []

    def cancel(handle):
        try:
            handle.canceled()
        except RuntimeError as error:
            errors.append(str(error))
        handle.succeed()
        return Fibonacci.Result()

    action = setup(cancel)
    action.outcome(action.send())
    assert "from state EXECUTING with event CANCELED" in errors[0]


def test_an_unknown_goal_has_no_result(setup):
    action = setup(succeed)
    service = Fibonacci.Impl.GetResultService
    client = action.node.create_client(service, "f/_action/get_result")
    assert client.wait_for_service(timeout_sec=8.0)
    future = client.call_async(service.Request(goal_id=UUID(uuid=[1] * 16)))
    assert action.world.result(future).status == GoalStatus.STATUS_UNKNOWN


def test_results_expire(setup):
    action = setup(succeed, result_timeout=1)
    handle = action.send()
    assert action.outcome(handle)[0] == GoalStatus.STATUS_SUCCEEDED
    action.world.spin_for(1.6)
    assert action.outcome(handle)[0] == GoalStatus.STATUS_UNKNOWN


def test_the_status_is_kept_for_late_joiners(setup):
    action, heard = setup(succeed), []
    action.outcome(action.send())
    action.node.create_subscription(
        GoalStatusArray, "f/_action/status", heard.append, qos_profile_action_status_default
    )
    action.world.spin_until(lambda: heard)
    assert [each.status for each in heard[-1].status_list] == [GoalStatus.STATUS_SUCCEEDED]


@pytest.mark.parametrize("other", [1, None, Fibonacci.Result()])
def test_another_type_is_no_feedback(setup, other):
    errors = []

    def execute(handle):
        try:
            handle.publish_feedback(other)
        except TypeError as error:
            errors.append(error)
        handle.succeed()
        return Fibonacci.Result()

    action = setup(execute)
    action.outcome(action.send())
    assert errors


def test_callbacks_can_be_changed(setup):
    action = setup(succeed)
    action.server.register_goal_callback(lambda goal: GoalResponse.REJECT)
    assert not action.send().accepted
    action.server.register_goal_callback(None)
    assert action.send().accepted
    with pytest.raises(TypeError, match="Failed to register goal execution callback: not callable"):
        action.server.register_execute_callback("no")


def test_the_server_knows_its_type(setup):
    assert setup(succeed).server.action_type is Fibonacci


@pytest.mark.parametrize("name", ["a b", "a/", ""])
def test_a_bad_name_is_refused(world, name):
    with pytest.raises(ValueError, match="Failed to create action server due to invalid topic name"):
        ActionServer(world.node(), Fibonacci, name, succeed)


def test_feedback_of_a_goal_that_ends_at_once_is_heard_before_the_answer(world):
    """Server and client of one executor: topics come before responses."""

    def execute(handle):
        handle.publish_feedback(Fibonacci.Feedback(sequence=[1, 1]))
        return succeed(handle)

    heard = []
    node = world.node("n")
    server = ActionServer(node, Fibonacci, "f", execute)
    node.create_subscription(Fibonacci.Impl.FeedbackMessage, "f/_action/feedback", heard.append, 1)
    client = node.create_client(Fibonacci.Impl.SendGoalService, "f/_action/send_goal")
    assert client.wait_for_service(timeout_sec=8.0)
    request = Fibonacci.Impl.SendGoalService.Request(goal_id=UUID(uuid=[1] * 16))
    world.executor.spin_until_future_complete(client.call_async(request), timeout_sec=8.0)
    assert [list(message.feedback.sequence) for message in heard] == [[1, 1]]
    server.destroy()
