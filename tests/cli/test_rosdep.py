"""`rosdep`, as tutorials type it before they build."""

import shlex

import pytest

from coursekit.cli.rosdep import main

MANIFEST = """<package format="3">
  <name>{name}</name><version>0.0.0</version><description>d</description>
  <maintainer email="a@example.com">a</maintainer><license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  {depends}
  <export><build_type>ament_cmake</build_type></export>
</package>"""
TUTORIAL = "install -i --from-path src --rosdistro humble -y"


@pytest.fixture
def workspace(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def make(**packages):
        for name, depends in packages.items():
            folder = tmp_path / "src" / name
            folder.mkdir(parents=True)
            lines = "".join(f"<depend>{key}</depend>" for key in depends.split())
            (folder / "package.xml").write_text(MANIFEST.format(name=name, depends=lines))

    return make


@pytest.mark.parametrize("line", [TUTORIAL, "install --from-paths src -y --ignore-src", "install -r -i --from-paths src"])
def test_all_is_there_in_the_words_of_the_tutorial(workspace, capsys, line):
    workspace(mine="rclpy rclcpp std_msgs python3-numpy python3-opencv libopencv-dev other", other="geometry_msgs")
    assert main(shlex.split(line)) == 0
    assert capsys.readouterr().out == "#All required rosdeps installed successfully\n"


def test_the_keys_of_the_official_tutorials_packages_are_there(workspace, capsys):
    """What turtlesim, demos, examples, image_tools and geometry_tutorials name."""
    compiling = "qt5-qmake qtbase5-dev libqt5-core rosidl_default_generators rmw_implementation_cmake urdf"
    checking = "ament_lint_auto ament_lint_common launch_testing_ament_cmake ros_testing osrf_testing_tools_cpp"
    drawing = "rviz_common rviz_default_plugins rviz_rendering rosbag2_cpp rosbag2_storage"
    collections = "desktop ros_base python3-colcon-common-extensions"
    workspace(mine=f"{compiling} {checking} {drawing} {collections} python_cmake_module example_interfaces")
    assert main(shlex.split(TUTORIAL)) == 0, capsys.readouterr().err


def test_what_is_missing_is_told_with_who_needs_it_and_what_to_do(workspace, capsys):
    workspace(mine="rclpy nope_msgs python3-nowhere")
    assert main(shlex.split(TUTORIAL)) == 1
    told = capsys.readouterr()
    assert told.out.startswith("ERROR: the following packages/stacks could not have their rosdep keys resolved\n")
    assert "mine: Cannot locate rosdep definition for [nope_msgs]\n  nope_msgs is not part of coursekit" in told.err
    assert "[python3-nowhere]\n  If a node imports it, install" in told.err and "pip install nowhere\n" in told.err


def test_keys_can_be_listed_and_skipped(workspace, capsys):
    workspace(mine="rclpy nope_msgs", other="mine")
    assert main(["keys", "--from-paths", "src"]) == 0
    assert capsys.readouterr().out.split() == ["ament_cmake", "nope_msgs", "rclpy"]
    assert main(["check", "--from-paths", "src", "--skip-keys", "nope_msgs"]) == 0


def test_init_and_update_have_nothing_to_do(capsys):
    assert (main(["init"]), main(["update"])) == (0, 0)
    assert "rosdep install --from-paths src" in capsys.readouterr().out


def test_a_folder_that_is_not_there_and_a_bad_manifest_are_told(workspace, capsys):
    assert main(shlex.split(TUTORIAL)) == 1
    assert capsys.readouterr().err == "ERROR: given path 'src' does not exist\n"
    workspace(mine="rclpy</depend><oops>")
    assert main(shlex.split(TUTORIAL)) == 1
    assert capsys.readouterr().err.startswith("ERROR: ")
