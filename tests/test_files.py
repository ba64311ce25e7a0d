"""Files that other people's workspaces name by their place on a robot: /opt/ros/humble/share/..."""

import subprocess
import sys
from pathlib import Path

import pytest
from launch import LaunchContext
from launch.launch_description_sources import AnyLaunchDescriptionSource
from nav2_common.launch import RewrittenYaml

from coursekit.files import installed, is_file, read_text

ROBOT = "/opt/ros/humble"
UNDERLAY = Path(__file__).parents[1] / "coursekit"
pytestmark = pytest.mark.skipif(Path(ROBOT).exists(), reason="this computer has ROS")


def test_a_file_of_a_robot_is_the_one_of_the_same_name_here():
    place = installed(f"{ROBOT}/share/nav2_bringup/params/nav2_params.yaml")
    assert Path(place) == UNDERLAY / "share/nav2_bringup/params/nav2_params.yaml"
    assert read_text(f"{ROBOT}/share/turtlesim/package.xml") == read_text(UNDERLAY / "share/turtlesim/package.xml")
    assert is_file(f"{ROBOT}/share/turtlesim/package.xml")


@pytest.mark.parametrize("path", [f"{ROBOT}/share/nobody/x.yaml", "/opt/ros/jazzy/share/turtlesim/package.xml", "a/b"])
def test_any_other_path_is_left_as_it_is(path):
    assert installed(path) == path and not is_file(path)


def test_a_missing_file_is_told_by_the_name_that_was_given():
    with pytest.raises(FileNotFoundError, match=f"{ROBOT}/share/nobody/x.yaml"):
        read_text(f"{ROBOT}/share/nobody/x.yaml")


def test_nothing_outside_of_the_packages_is_found_so():
    path = f"{ROBOT}/share/../files.py"
    assert installed(path) == path


@pytest.mark.parametrize("ending", ["py", "xml", "yaml"])
def test_launch_files_of_a_robot_are_included(ending):
    location = f"{ROBOT}/share/demo_nodes_cpp/launch/topics/talker_listener_launch.{ending}"
    included = AnyLaunchDescriptionSource(location).get_launch_description(LaunchContext())
    assert len(included.entities) == 2


def test_parameters_of_a_robot_are_rewritten(tmp_path):
    source = f"{ROBOT}/share/nav2_bringup/params/nav2_params.yaml"
    rewritten = RewrittenYaml(source_file=source, param_rewrites={"use_sim_time": "true"}, convert_types=True)
    assert "use_sim_time: true" in Path(rewritten.perform(LaunchContext())).read_text(encoding="utf-8")


def test_a_program_takes_parameters_of_a_robot():
    code = (
        "import rclpy, sys; rclpy.init(args=sys.argv)\n"
        "node = rclpy.create_node('amcl', automatically_declare_parameters_from_overrides=True)\n"
        "print(node.get_parameter('base_frame_id').value)"
    )
    given = ["--ros-args", "--params-file", f"{ROBOT}/share/nav2_bringup/params/nav2_params.yaml"]
    done = subprocess.run([sys.executable, "-c", code, *given], capture_output=True, text=True, timeout=60)
    assert done.stdout == "base_footprint\n", done.stderr
