"""A table of commands whose rows run; and that every row of the command reference does."""

import nbformat
import pytest

from coursekit.lab.command_table import CommandMagics, CommandTable, Row, read_rows
from coursekit.lab.magics import CourseMagics, workspace
from coursekit.processes.executables import find
from coursekit.processes.session import Session
from tests.notebooks.running import NOTEBOOKS

SCENE = (
    ("demo_nodes_py", "talker"),
    ("demo_nodes_py", "listener"),
    ("turtlesim", "turtlesim_node"),
    ("demo_nodes_py", "add_two_ints_server"),
    ("tf2_ros", "static_transform_publisher", "--frame-id", "map", "--child-frame-id", "shelf"),
)
ENDED = (0, 2, 130, -2)
"""By itself, or by Ctrl-C."""
WITHOUT_A_ROBOT = {
    "ros2 run nav2_map_server map_saver_cli -f room --free 0.196": "No map came on 'map'",
    "ros2 lifecycle get /map_server": "Node not found",
}
"""What these say where no map is made and no map server runs."""
BIG = tuple(f"ros2 launch {package} " for package in ("coursekit_robots", "gazebo_ros", "slam_toolbox", "nav2_bringup"))
ENDS = ("check_urdf", "xacro", "rosdep", "coursekit", "printenv")
"""Programs with an interpreter of their own that end by themselves: on a slow computer it takes seconds to start."""


@pytest.fixture
def session(tmp_path, monkeypatch):
    (tmp_path / "ros2_ws/src").mkdir(parents=True)
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    monkeypatch.chdir(tmp_path)
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


def table(text):
    return CommandTable(read_rows(text), CourseMagics(None))


def test_a_table_prints_as_one_and_a_line_without_a_meaning_is_refused():
    command_table = CommandMagics(None).commands(
        "", "ros2 node list | all nodes\n\nros2 topic list -t | topics with types\n"
    )
    assert repr(command_table).splitlines() == ["ros2 node list      all nodes", "ros2 topic list -t  topics with types"]
    assert read_rows("ros2 topic echo /a | grep b | with a pipe")[0] == Row("ros2 topic echo /a | grep b", "with a pipe")
    with pytest.raises(ValueError, match="line 2 of %%commands is no row: 'ros2 node list'"):
        read_rows("ros2 topic list | topics\nros2 node list")


def test_a_click_runs_the_row_as_it_is_then_and_a_second_one_runs_it_anew(session):
    (row,) = table("ros2 interface show std_msgs/msg/Empty | a type").rows
    row.line.value = "ros2 interface show std_msgs/msg/Bool"
    row.button.click()
    first = row.terminal
    assert first.wait(5.0) == 0 and "bool data" in first.text
    assert row.children[1] is first
    row.button.click()
    assert row.terminal is not first and row.terminal.wait(5.0) == 0


def test_what_only_a_shell_can_do_has_no_button_and_an_unknown_program_is_told(session):
    one, other = table("export ROS_DOMAIN_ID=7 | another conversation\nrose2 node list | a slip").rows
    assert one.button.disabled
    other.button.click()
    assert other.children[1].value.startswith("There is no program 'rose2'")


def reference():
    return [cell.source for cell in nbformat.read(NOTEBOOKS / "A_commands.ipynb", 4).cells]


def rows_of_the_reference():
    """The rows that run, each as a case; systems that take long are only asked for their arguments."""
    cells = [source.partition("\n")[2] for source in reference() if source.startswith("%%commands")]
    rows = [row for cell in cells for row in read_rows(cell) if row.runs]
    assert len(rows) > 80
    return rows


def set_the_scene(session):
    for source in reference():
        if source.startswith("%%write "):
            (workspace() / source.split()[1]).write_text(source.partition("\n")[2])
    (row,) = table("ros2 pkg create appa_hello --node-name hello_exe --destination-directory src | a package").rows
    assert run(row)[0] == 0
    for names in SCENE:
        session.start_executable(find(names[0], names[1]), names[2:], name=names[1])
    session.clock.sleep(0.5)


def run(row):
    """Press the row's button, and Ctrl-C if it does not end; the exit code and what it printed."""
    seconds = 60.0 if row.row.command.startswith(ENDS) else 3.0
    row.button.click()
    assert row.terminal is not None, row.children[1].value
    code = row.terminal.wait(seconds)
    if code is None:
        row.terminal.interrupt()
        code = row.terminal.wait(5.0)
    return code, row.terminal.text


@pytest.mark.slow
def test_every_command_of_the_reference_runs_from_its_row(session, monkeypatch):
    monkeypatch.chdir(workspace())
    set_the_scene(session)
    failed = {}
    for row in CommandTable(rows_of_the_reference(), CourseMagics(None)).rows:
        if row.row.command.startswith(BIG):
            row.line.value += " --show-args"
        code, output = run(row)
        expected = WITHOUT_A_ROBOT.get(row.row.command)
        if "Traceback" in output or (expected not in output if expected else code not in ENDED):
            failed[row.row.command] = (code, output[-300:])
    assert failed == {}
