"""Packages under the names of C++ tutorials do what those tell."""

import pytest


def test_the_action_tutorial_speaks_as_the_cpp_nodes(session, run):
    server = run("action_tutorials_cpp", "fibonacci_action_server")
    client = run("action_tutorials_cpp", "fibonacci_action_client")
    assert client.wait(20) == 0
    said = [line.split("]: ", 1)[1] for line in client.output.splitlines()]
    assert said[:3] == [
        "Sending goal",
        "Goal accepted by server, waiting for result",
        "Next number in sequence received: 0 1 1 ",
    ]
    assert said[-1] == "Result received: 0 1 1 2 3 5 8 13 21 34 55 "
    assert "Received goal request with order 10" in server.output and "Goal succeeded" in server.output


@pytest.mark.parametrize("file", ["turtle_tf2_demo", "turtle_tf2_fixed_frame_demo", "turtle_tf2_dynamic_frame_demo"])
def test_turtles_follow_frames_under_the_cpp_name(session, ros2, file):
    output = ros2("launch", "turtle_tf2_cpp", f"{file}.launch.py", seconds=4.0)
    assert "[turtle_tf2_broadcaster-2]: process started" in output
    assert "Successfully spawned" in output and "died" not in output


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("snail", "1"), "Invalid number of parameters\nusage: ros2 run turtle_tf2_cpp static_turtle_tf2_"),
        (("world", *"000000"), "Your static turtle name cannot be 'world'"),
    ],
)
def test_a_static_frame_that_cannot_be_is_refused_in_the_log(run, words, told):
    process = run("turtle_tf2_cpp", "static_turtle_tf2_broadcaster", *words)
    assert process.wait(5) == 1 and f"[logger]: {told}" in process.output
