"""Launch: files in three formats, substitutions, event handlers, large projects, composable nodes."""

import pytest

MIMICKED = ["/mimic", "/turtlesim1/sim", "/turtlesim2/sim"]


@pytest.mark.parametrize("ending", ["py", "xml", "yaml"])
def test_a_turtle_mimics_another_s_path(terminal, said, ending):
    terminal(f"ros2 launch path_py mimic.launch.{ending}", 1.0)
    assert said("ros2 node list").split() == MIMICKED
    command = "ros2 topic pub -r 1 /turtlesim1/turtle1/cmd_vel geometry_msgs/msg/Twist"
    terminal(f"{command} '{{linear: {{x: 2.0, y: 0.0, z: 0.0}}, angular: {{x: 0.0, y: 0.0, z: -1.8}}}}'", 3.0)
    assert "linear_velocity: 2.0" in said("ros2 topic echo --once /turtlesim2/turtle1/pose")


def test_a_file_is_launched_by_its_path(terminal, said, workspace):
    terminal(f"ros2 launch {workspace}/src/path_py/launch/mimic.launch.py", 1.0)
    assert said("ros2 node list").split() == MIMICKED


def test_substitutions_and_conditions_decide_what_is_done(terminal, said):
    launch = terminal("ros2 launch path_py paint_main.launch.py", 1.9)
    assert said("ros2 param get /turtlesim2/sim background_r") == "Integer value is: 120\n"
    launch.wait(2.0)
    assert said("ros2 param get /turtlesim2/sim background_r") == "Integer value is: 200\n"
    assert "/turtlesim2/turtle2/pose\n" in said("ros2 topic list")


def test_arguments_are_shown_and_changed(terminal, said):
    shown = said("ros2 launch path_py paint.launch.py --show-args")
    assert "'turtlesim_ns':" in shown and "(default: 'turtlesim1')" in shown
    terminal(
        "ros2 launch path_py paint.launch.py turtlesim_ns:=turtlesim3 use_provided_red:=True new_background_r:=200", 4.0
    )
    assert said("ros2 param get /turtlesim3/sim background_r") == "Integer value is: 200\n"


def test_handlers_answer_the_events_of_processes(terminal):
    launch = terminal("ros2 launch path_py events.launch.py")
    assert launch.wait(20) == 0
    told = [
        "The window is open", "Spawning says: ", "It is there", "Painted for mario", "Launch is to end: all is done",
    ]  # fmt: skip
    places = [launch.output.index(word) for word in told]
    assert places == sorted(places)


def test_a_large_project_s_names_parameters_and_includes(terminal, said):
    terminal("ros2 launch path_py large.launch.py", 2.0)
    assert said("ros2 node list").split() == ["/inner/custom_polite", "/mario_fixed", "/plain/sim", "/sim"]
    assert said("ros2 param get /sim background_r") == "Integer value is: 150\n"
    assert said("ros2 param get /plain/sim background_g") == "Integer value is: 11\n"
    assert said("ros2 param get /plain/sim background_r") == "Integer value is: 69\n"


@pytest.mark.parametrize("ending", ["py", "xml", "yaml"])
def test_one_launch_in_three_formats(terminal, said, ending):
    terminal(f"ros2 launch path_py formats.launch.{ending} background_r:=255", 1.5)
    names = ["/chat/first/listener", "/chat/first/talker", "/listener", "/talker", "/turtlesim1/sim"]
    assert said("ros2 node list").split() == names
    assert said("ros2 param get /turtlesim1/sim background_r") == "Integer value is: 255\n"


def test_composable_nodes_are_launched_into_a_container(terminal, said):
    terminal("ros2 launch path_py composed.launch.py", 2.0)
    assert said("ros2 component list") == "/image_container\n  1  /cam2image\n  2  /showimage\n"
    assert "/burgers\n" in said("ros2 topic list")
