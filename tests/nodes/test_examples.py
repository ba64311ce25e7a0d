"""examples_rclpy_* and examples_rclcpp_*: what each says."""

import pytest


def lines(process):
    """What a process logged, without the stamps."""
    return [line.split("]: ", 1)[-1] for line in process.output.splitlines()]


@pytest.mark.parametrize("flavour", ["rclpy", "rclcpp"])
def test_a_publisher_and_a_subscriber_talk_twice_a_second(session, run, flavour):
    listener = run(f"examples_{flavour}_minimal_subscriber", "subscriber_member_function")
    talker = run(f"examples_{flavour}_minimal_publisher", "publisher_member_function")
    session.clock.sleep(1.2)
    said = {"rclpy": '"Hello World: 1"', "rclcpp": "'Hello, world! 1'"}[flavour]
    assert lines(talker)[1] == f"Publishing: {said}"
    assert lines(listener)[1] == f"I heard: {said}"
    talker.interrupt()
    assert talker.wait(5) == 0


@pytest.mark.parametrize("client", ["client", "client_async", "client_async_callback", "client_async_member_function"])
def test_every_client_waits_for_the_service_and_gets_its_sum(session, run, client):
    asking = run("examples_rclpy_minimal_client", client, "41", "1")
    session.clock.sleep(1.5)
    service = run("examples_rclpy_minimal_service", "service")
    assert asking.wait(10) == 0
    assert lines(asking) == ["service not available, waiting again...", "Result of add_two_ints: for 41 + 1 = 42"]
    assert lines(service) == ["Incoming request", "a: 41 b: 1"]


def test_the_cpp_client_and_service_speak_as_theirs(session, run):
    service = run("examples_rclcpp_minimal_service", "service_main")
    asking = run("examples_rclcpp_minimal_client", "client_main")
    assert asking.wait(10) == 0
    assert lines(asking)[-1] == "result of 41 + 1 = 42"
    assert lines(service) == ["request: 41 + 1"]


@pytest.mark.parametrize("server", ["server", "server_defer", "server_queue_goals", "server_single_goal"])
def test_every_action_server_counts_to_its_result(session, run, server):
    serving = run("examples_rclpy_minimal_action_server", server)
    asking = run("examples_rclpy_minimal_action_client", "client")
    assert asking.wait(30) == 0
    assert lines(asking)[-1] == "Goal succeeded! Result: array('i', [0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55])"
    assert "Returning result: array('i', [0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55])" in lines(serving)


def test_a_goal_is_cancelled_after_two_seconds(session, run):
    serving = run("examples_rclpy_minimal_action_server", "server")
    asking = run("examples_rclpy_minimal_action_client", "client_cancel")
    assert asking.wait(30) == 0
    assert lines(asking)[-2:] == ["Canceling goal", "Goal successfully canceled"]
    session.clock.sleep(2)
    assert lines(serving)[-2:] == ["Received cancel request", "Goal canceled"]


def test_a_second_goal_aborts_the_first_where_there_is_one_at_a_time(session, run):
    run("examples_rclpy_minimal_action_server", "server_single_goal")
    first = run("examples_rclpy_minimal_action_client", "client")
    session.clock.sleep(1.5)
    second = run("examples_rclpy_minimal_action_client", "client")
    assert first.wait(30) == 0 and second.wait(30) == 0
    assert lines(first)[-1] == "Goal failed with status: 6"
    assert "Goal succeeded!" in lines(second)[-1]


def test_goals_in_a_queue_succeed_one_after_the_other(session, run):
    serving = run("examples_rclpy_minimal_action_server", "server_queue_goals")
    clients = [run("examples_rclpy_minimal_action_client", "client") for _ in range(2)]
    assert [client.wait(60) for client in clients] == [0, 0]
    assert all("Goal succeeded!" in lines(client)[-1] for client in clients)
    assert {"Goal put in the queue", "Next goal pulled from the queue"} <= set(lines(serving))


@pytest.mark.parametrize("executable", ["composed", "callback_group", "custom_executor"])
def test_nodes_of_one_process_hear_each_other(session, run, executable):
    both = run("examples_rclpy_executors", executable)
    session.clock.sleep(2.3)
    assert 'I heard: "Hello World: 1"' in "\n".join(lines(both))
    both.interrupt()
    assert both.wait(5) == 0


def test_a_throttled_group_lets_ten_through_and_then_two_a_second(session, run):
    talker = run("examples_rclpy_executors", "custom_callback_group")
    session.clock.sleep(4.95)
    assert 17 <= len(lines(talker)) <= 20


def test_a_guard_condition_ends_the_program(session, run):
    node = run("examples_rclpy_guard_conditions", "trigger_guard_condition")
    assert node.wait(10) == 0
    said = [line for line in lines(node) if "spin_once" not in line and line]
    assert said == ["timer callback triggered guard condition", "guard callback called shutdown"]


def test_the_wave_is_a_cloud_of_ten_thousand_points(session, run, ros2):
    run("examples_rclpy_pointcloud_publisher", "pointcloud_publisher")
    assert ros2("topic", "echo", "--once", "--field", "width", "/test_cloud").startswith("10000\n")


def test_a_publisher_tells_at_its_end_that_all_has_arrived(session, run):
    listener = run("examples_rclcpp_minimal_subscriber", "subscriber_member_function")
    talker = run("examples_rclcpp_minimal_publisher", "publisher_wait_for_all_acked")
    session.clock.sleep(1.2)
    talker.interrupt()
    assert talker.wait(5) == 0
    assert lines(talker) == [
        "Publishing: 'Hello, world! 0'", "Publishing: 'Hello, world! 1'", "All subscribers acknowledge messages",
    ]  # fmt: skip
    assert lines(listener) == ["I heard: 'Hello, world! 0'", "I heard: 'Hello, world! 1'"]
