"""Client libraries in Python: publisher and subscriber, service and client, interfaces, parameters, actions."""

import pytest

from tests.needs import ON_WINDOWS
from tests.tutorials.conftest import colcon


def lines(process):
    """What a process logged, without stamps."""
    return [line.split("]: ", 1)[1] for line in process.output.splitlines() if "]: " in line]


def test_publisher_and_subscriber(terminal):
    listener = terminal("ros2 run path_py listener")
    talker = terminal("ros2 run path_py talker", 1.6)
    assert lines(talker) == ["Taking step 0", "Taking step 1", "Taking step 2"]
    assert lines(listener) == ["Heard step 0", "Heard step 1", "Heard step 2"]


def test_service_and_client(terminal):
    asker = terminal("ros2 run path_py asker 2 3 1", 1.5)
    adder = terminal("ros2 run path_py adder", 1.0)
    assert lines(asker) == ["nobody adds yet, asking again...", "It makes 6"] and asker.exit_code == 0
    assert lines(adder) == ["Asked for 2 + 3 + 1"]


def test_own_interfaces(said):
    assert said("ros2 interface show path_interfaces/msg/Step") == "int64 count\n"
    assert said("ros2 interface show path_interfaces/msg/Ball") == (
        "geometry_msgs/Point middle\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z\nfloat64 radius\n"
    )
    assert said("ros2 interface show path_interfaces/srv/SumOfThree") == ("int64 a\nint64 b\nint64 c\n---\nint64 sum\n")
    assert said("ros2 interface show path_interfaces/action/Walk") == "int32 steps\n---\nint32[] done\n---\nint32[] so_far\n"


def test_parameters_in_a_class(terminal, said):
    polite = terminal("ros2 run path_py polite", 1.1)
    assert lines(polite) == ["Good day, world!"]
    assert said("ros2 param list") == "/polite:\n  use_sim_time\n  whom\n"
    assert said("ros2 param describe /polite whom") == (
        "Parameter name: whom\n  Type: string\n  Description: Whom to greet\n  Constraints:\n"
    )
    assert said("ros2 param set /polite whom earth") == "Set parameter successful\n"
    polite.wait(2.0)
    assert "Good day, earth!" in lines(polite) and lines(polite)[-1] == "Good day, world!"


def test_parameters_from_a_launch_file(said):
    output = said("ros2 launch path_py polite.launch.py", 1.5)
    assert "[custom_polite]: Good day, earth!" in output


def test_parameters_are_monitored(terminal, said):
    watcher = terminal("ros2 run path_py watcher")
    terminal("ros2 run path_py polite", 0.5)
    said("ros2 param set /watcher size 43")
    said("ros2 param set /polite whom moon")
    watcher.wait(2.0)
    assert {"My size is now 43", "Their whom is now moon"} <= set(lines(watcher))


def test_action_server_and_client(terminal, said):
    walker = terminal("ros2 run path_py walker", 0.2)
    sent = said("ros2 action send_goal --feedback walk path_interfaces/action/Walk '{steps: 2}'")
    assert sent.startswith("Waiting for an action server to become available...\nSending goal:\n     steps: 2\n")
    assert "Feedback:\n    so_far:\n- 0\n" in sent and sent.endswith("Goal finished with status: SUCCEEDED\n")
    sender = terminal("ros2 run path_py sender")
    sender.wait(10)
    assert lines(sender)[0] == "Goal accepted" and lines(sender)[-1] == "Result: [0, 1, 2]"
    assert lines(walker) == ["Walking..."] * 2


def test_a_bag_is_written_and_read_by_nodes(terminal, said):
    terminal("ros2 run path_py talker")
    keeper = terminal("ros2 run path_py keeper", 2.1)
    keeper.interrupt()
    keeper.wait(5)
    assert "Topic: steps | Type: path_interfaces/msg/Step | Count: 4" in said("ros2 bag info kept")
    reader = terminal("ros2 run path_py reader kept")
    reader.wait(5)
    assert lines(reader)[-4:] == [f"steps: {count}" for count in range(4)] and reader.exit_code == 0


def test_the_package_has_its_executables_and_manifest(said):
    assert f"path_py talker{'.exe' * ON_WINDOWS}\n" in said("ros2 pkg executables path_py")
    assert "<name>path_py</name>" in said("ros2 pkg xml path_py")


def test_tests_of_a_package_are_run_and_reported(workspace):
    """Testing, from the command line and in Python: one test fails on purpose."""
    done = colcon(workspace, "test", "--packages-select", "path_py", "--event-handlers", "console_cohesion+")
    assert "test_that_fails_on_purpose" in done.stdout + done.stderr
    result = colcon(workspace, "test-result", "--verbose")
    assert result.returncode == 1 and "Summary: 2 tests, 0 errors, 1 failure, 0 skipped" in result.stdout
    assert "test_that_fails_on_purpose" in result.stdout


@pytest.mark.parametrize("kind", ["ament_python", "ament_cmake"])
def test_a_package_is_created_and_built(said, tmp_path, kind):
    name = f"my_{kind}"
    assert "going to create a new package" in said(f"ros2 pkg create --build-type {kind} --license Apache-2.0 {name}")
    built = colcon(tmp_path, "build", "--symlink-install", "--packages-select", name)
    assert built.returncode == 0 and "Summary: 1 package finished" in built.stdout


def test_ctrl_c_shows_where_a_student_s_node_was(terminal):
    talker = terminal("ros2 run path_py talker", 0.6)
    talker.interrupt()
    assert talker.wait(5.0) is not None
    assert "Traceback (most recent call last):\n" in talker.output, talker.output
    assert "in main\n" in talker.output and "\nKeyboardInterrupt\n" in talker.output


def test_ctrl_c_shows_no_inside_of_the_course_s_nodes(terminal):
    talker = terminal("ros2 run demo_nodes_py talker", 1.1)
    talker.interrupt()
    assert talker.wait(5.0) is not None
    assert "Traceback" not in talker.output
