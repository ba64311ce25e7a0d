"""Tab completes the words of a command: names of the running graph come from the session."""

import os
import subprocess
import sys

import pytest

ROS2 = [sys.executable, "-m", "coursekit.cli.ros2"]


@pytest.fixture
def tab(tmp_path):
    """tab(line) gives what the Tab key offers at the end of the line."""
    env = {name: value for name, value in os.environ.items() if name not in ("COURSEKIT_TIME", "COURSEKIT_STOP_AFTER")}
    env |= {"COURSEKIT_RUNTIME_DIR": str(tmp_path), "ROS_DOMAIN_ID": "77"}

    def offer(line):
        answers = tmp_path / "answers"
        asked = {
            "_ARGCOMPLETE": "1", "_ARGCOMPLETE_STDOUT_FILENAME": str(answers), "_ARGCOMPLETE_IFS": "\v",
            "_ARGCOMPLETE_SUPPRESS_SPACE": "1", "COMP_LINE": line, "COMP_POINT": str(len(line)), "COMP_TYPE": "9",
        }  # fmt: skip
        done = subprocess.run(
            ROS2, env=env | asked, capture_output=True, encoding="utf-8", timeout=60, input="not to be read"
        )
        assert "Traceback" not in done.stderr
        return [word.strip() for word in answers.read_text().split("\v")]

    offer.env = env
    return offer


@pytest.fixture
def talker(tab):
    """A talker in the session that the commands share."""
    process = subprocess.Popen(
        [*ROS2, "run", "demo_nodes_py", "talker"],
        env=tab.env,
        stdin=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
    )
    while "Publishing" not in process.stderr.readline():
        assert process.poll() is None
    yield process
    process.kill()
    process.communicate()


def test_names_of_the_graph_come_from_the_session_that_runs(tab, talker):
    assert "/chatter" in tab("ros2 topic echo /ch")
    assert "/talker" in tab("ros2 node info /ta")
    assert "/talker/get_parameters" in tab("ros2 service call /talker/get_parameters")
    assert "use_sim_time" in tab("ros2 param get /talker use_")


@pytest.mark.parametrize("line", ["ros2 topic echo /ch", "ros2 param get /talker use_", "ros2 lifecycle get /"])
def test_nothing_is_offered_nor_started_where_no_session_runs(tab, tmp_path, line):
    assert not any(tab(line))
    assert not any(path.is_socket() for path in tmp_path.rglob("*"))


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("ros2 topic pub /a std_msgs/msg/ColorRGBA ", "r: 0.0\ng: 0.0\nb: 0.0\na: 0.0"),
        ("ros2 service call /a std_srvs/srv/SetBool ", "data: false"),
        ("ros2 action send_goal /a example_interfaces/action/Fibonacci ", "order: 0"),
    ],
)
def test_values_are_offered_with_their_defaults(tab, line, offered):
    assert any(offered in word.replace("\\", "") for word in tab(line))
