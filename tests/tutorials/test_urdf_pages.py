"""URDF: robots from scratch, xacro, the state publisher, files for Gazebo."""

import numpy as np
import pytest

from coursekit.urdf import Mesh
from coursekit.urdf.shapes import GREY, surfaces_of

FILES = ["01-myfirst", "02-multipleshapes", "03-origins", "04-materials", "05-visual", "06-flexible", "07-physics"]


@pytest.mark.parametrize("name", FILES)
def test_each_model_is_displayed_by_the_page_s_command(terminal, said, name):
    launch = terminal(f"ros2 launch urdf_tutorial display.launch.py model:=urdf/{name}.urdf", 2.0)
    assert "died" not in launch.output, launch.output[-500:]
    assert "/robot_state_publisher" in said("ros2 node list").split()


def test_a_model_of_macros_is_displayed(terminal, said):
    launch = terminal("ros2 launch urdf_tutorial display.launch.py model:=urdf/08-macroed.urdf.xacro", 2.0)
    assert "died" not in launch.output
    assert "/robot_description\n" in said("ros2 topic list")


def test_properties_macros_and_sums_of_xacro(session, workspace, tmp_path):
    import xacro

    text = xacro.process_file(str(workspace / "src/path_py/urdf/stick.urdf.xacro")).toprettyxml(indent="  ")
    assert 'length="0.6000000000000001"' in text and 'xyz="0 -0.22 0.25"' in text and 'name="left_leg"' in text


def test_a_state_publisher_moves_the_robot(terminal, said):
    launch = terminal("ros2 launch path_py stick.launch.py", 2.0)
    assert "died" not in launch.output, launch.output
    assert "[robot_state_publisher]: got segment arm" in launch.output
    assert "name:\n- swivel\n" in said("ros2 topic echo --once /joint_states")
    assert "- Translation: [" in said("ros2 run tf2_ros tf2_echo odom arm", 1.5)


@pytest.mark.parametrize(("name", "length"), [("l_finger", 0.1), ("l_finger_tip", 0.03)])
def test_the_meshes_that_the_page_names_are_there(name, length):
    (surface,) = surfaces_of(Mesh(f"package://urdf_tutorial/meshes/{name}.dae"))
    assert np.ptp(surface.vertices, axis=0)[0] == pytest.approx(length, abs=0.01)
    assert surface.colour != GREY
