"""The sliders of joint_state_publisher_gui."""

import pytest

from coursekit.lab import joint_panel, joint_windows
from coursekit.lab.errors import BadArgument, NotThere
from coursekit.lab.joint_panel import joint_sliders
from coursekit.lab.panel import open_panels
from coursekit.nodes.robots.boards import boards
from coursekit.processes.executables import find
from coursekit.processes.patching import patch_manager
from tests.urdf.oracle import ROBOTS


@pytest.fixture
def gui(session):
    path = find("joint_state_publisher_gui", "joint_state_publisher_gui")
    started = session.start_executable(path, [str(ROBOTS / "r2d2_2.urdf")], name="gui")
    session.clock.sleep(0.2)
    return started


def test_without_the_node_it_says_what_to_start(session):
    with pytest.raises(LookupError, match="ros2 run joint_state_publisher_gui"):
        joint_sliders()


def test_the_text_names_joints_positions_and_limits(gui):
    lines = joint_sliders().text().splitlines()
    assert lines[0] == "joint sliders of /joint_state_publisher: 6"
    assert lines[-1] == "periscope_extension: 0.000  0.000 .. 0.150"


def test_a_new_panel_waits_for_the_description(session):
    file = str(ROBOTS / "r2d2_2.urdf")
    path = find("joint_state_publisher_gui", "joint_state_publisher_gui")
    session.start_executable(path, [], name="gui")

    def later():
        session.clock.sleep(0.3)
        session.start_executable(find("robot_state_publisher", "robot_state_publisher"), [file], name="robot")

    session.spawn(later)
    panel = joint_sliders()
    panel.move("head_swivel", 0.5)
    assert panel.positions["head_swivel"] == 0.5


def test_a_slider_moves_its_joint_within_the_limits(session, gui):
    panel = joint_sliders()
    panel.move("periscope_extension", 9.0)
    panel._hear(panel, {"type": "move", "name": "head_swivel", "value": 0.5}, [])
    panel._hear(panel, {"type": "move", "name": "no_such_joint", "value": 0.5}, [])
    panel._hear(panel, {"type": "move", "name": "head_swivel", "value": "far"}, [])
    assert panel.positions["periscope_extension"] == 0.15
    assert panel.positions["head_swivel"] == 0.5
    with pytest.raises(NotThere, match="Did you mean 'head_swivel'"):
        panel.move("head_swivl", 1.0)
    with pytest.raises(BadArgument, match="The joint 'head_swivel' cannot be put to 'left': give a number, rad or m"):
        panel.move("head_swivel", "left")


def test_the_buttons_center_and_randomize(session, gui):
    patch_manager.renew()  # pytest changes sys.stderr between a fixture and its test
    panel = joint_sliders()
    panel._hear(panel, {"type": "randomize"}, [])
    assert all(panel.positions.values())
    panel.center()
    assert not any(panel.positions.values())
    session.clock.sleep(0.1)
    assert "Randomizing" in gui.output and "Centering" in gui.output


def test_the_browser_sees_what_moves(session, gui, monkeypatch):
    panel = joint_sliders()
    sent = []
    monkeypatch.setattr(panel, "send", lambda message, buffers=None: sent.append(message))
    panel._hear(panel, {"type": "ready"}, [])
    panel.move("head_swivel", 0.5)
    session.clock.sleep(0.5)
    rows = {row["name"]: row for row in sent[-1]["rows"]}
    assert rows["head_swivel"]["value"] == 0.5
    gui.interrupt()
    gui.wait(2)
    session.clock.sleep(0.5)
    assert sent[-1]["running"] is False
    assert "ended" in panel.text()


def test_a_window_that_opens_while_a_cell_takes_over_does_not_stay(session):
    """The window waits for the robot's description; a cell shows the sliders before it comes."""
    session.start_executable(find("joint_state_publisher_gui", "joint_state_publisher_gui"), [], name="gui")
    session.clock.sleep(0.2)
    (board,) = boards.running(session)
    joint_windows._windows.show(board)
    session.clock.sleep(0.1)
    for listener in joint_panel.shown:
        listener(board)
    path = find("robot_state_publisher", "robot_state_publisher")
    session.start_executable(path, [str(ROBOTS / "r2d2_2.urdf")], name="robot")
    session.clock.sleep(4.0)
    assert open_panels() == []
