"""What programs log is kept in files, one for each program, where ROS_LOG_DIR and ROS_HOME say."""

import re

import pytest

from coursekit.processes.executables import find
from coursekit.processes.session import Session


@pytest.fixture
def session():
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


def talks(session, *argv, seconds=2.5, **env):
    """A talker that counts for a while; what it showed."""
    process = session.start_executable(find("demo_nodes_py", "talker"), argv, name="talker", env=env)
    session.clock.sleep(seconds)
    process.interrupt()
    process.wait(10)
    return process


def test_a_program_keeps_its_log_in_a_file_of_its_own(session, tmp_path):
    process = talks(session, ROS_LOG_DIR=str(tmp_path / "a" / "log"))
    other = talks(session, ROS_LOG_DIR=str(tmp_path / "a" / "log"))
    files = sorted((tmp_path / "a" / "log").iterdir(), key=lambda path: int(path.name.split("_")[1]))
    assert [re.fullmatch(r"talker_(\d+)_\d{13}\.log", path.name)[1] for path in files] == [str(process.pid), str(other.pid)]
    assert files[0].read_text() == process.output and process.output.count("Publishing") == 2


def test_without_ros_log_dir_it_is_the_folder_log_of_ros_home(session, tmp_path):
    process = talks(session, ROS_LOG_DIR="", ROS_HOME=str(tmp_path))
    (file,) = (tmp_path / "log").iterdir()
    assert file.read_text() == process.output


def test_a_program_that_shows_nothing_keeps_its_log_all_the_same(session, tmp_path):
    process = talks(session, "--ros-args", "--disable-stdout-logs", ROS_LOG_DIR=str(tmp_path))
    (file,) = tmp_path.iterdir()
    assert process.output == "" and file.read_text().count("[talker]: Publishing") == 2


def test_no_file_where_the_command_line_says_so(session, tmp_path):
    process = talks(session, "--ros-args", "--disable-external-lib-logs", ROS_LOG_DIR=str(tmp_path))
    assert "Publishing" in process.output and not list(tmp_path.iterdir())


def test_a_folder_that_cannot_be_made_costs_the_file_only(session, tmp_path):
    (tmp_path / "taken").write_text("a file")
    process = talks(session, ROS_LOG_DIR=str(tmp_path / "taken"))
    assert process.output.count("Publishing") == 2 and process.exit_code in (0, 1, -2)
    assert (tmp_path / "taken").read_text() == "a file"


def test_colours_are_for_the_screen(session, tmp_path):
    process = talks(session, ROS_LOG_DIR=str(tmp_path), RCUTILS_COLORIZED_OUTPUT="1")
    (file,) = tmp_path.iterdir()
    assert "\033[" in process.output and "\033[" not in file.read_text()


def test_a_second_run_on_the_virtual_clock_begins_its_file_anew(tmp_path):
    for _ in range(2):
        with Session(virtual=True).use() as session:
            process = talks(session, ROS_LOG_DIR=str(tmp_path))
    (file,) = tmp_path.iterdir()
    assert file.read_text() == process.output
