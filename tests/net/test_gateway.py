"""The gateway beside the real rclpy on Fast DDS: a robot and a notebook, in a network that has nothing but loopback.

`make conformance` installs the real rclpy; without it, and where `unshare -n` is refused, this is skipped.
"""

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from coursekit.cli.coursekit import main
from coursekit.net import gateway_file
from tests.conformance.loopback import alone

ROOT = Path(__file__).parents[2]
REAL = ROOT / ".venv-ros" / "bin" / "python"


def test_the_file_is_one_program_and_the_same_every_time(tmp_path, capsys):
    paths = [tmp_path / "a.pyz", tmp_path / "b.pyz"]
    assert [main(["gateway", "--write", str(path)]) for path in paths] == [0, 0]
    assert paths[0].read_bytes() == paths[1].read_bytes()
    said = capsys.readouterr().out
    assert "pip install eclipse-zenoh xxhash" in said and "%network tcp/ROBOT:7447" in said
    with zipfile.ZipFile(paths[0]) as archive:
        code = {name: archive.read(name).decode() for name in archive.namelist()}
    assert "__main__.py" in code and f"{gateway_file.NAME}/wire/token.py" in code
    assert not [name for name, text in code.items() if "from coursekit." in text or "import coursekit." in text]


def test_a_place_where_it_cannot_be_written_is_told(tmp_path):
    with pytest.raises(SystemExit, match="cannot be written"):
        main(["gateway", "--write", str(tmp_path / "no" / "such" / "gateway.pyz")])


@pytest.fixture(scope="module")
def facts():
    if not REAL.exists() or "eclipse-zenoh" not in (REAL.parents[1] / ".installed").read_text(encoding="utf-8"):
        pytest.skip("THE GATEWAY WAS NOT TRIED: the real rclpy is not installed here (make conformance does that)")
    words = alone([sys.executable, "-m", "tests.net.gateway_scene", str(REAL)])
    if words is None:
        pytest.skip("THE GATEWAY WAS NOT TRIED: nothing keeps the real rclpy on loopback here (unshare -n)")
    env = dict(os.environ, ROS_DOMAIN_ID="42", COURSEKIT_ALONE="1")
    done = subprocess.run(words, env=env, cwd=ROOT, capture_output=True, text=True, timeout=240)
    facts_lines = [line for line in done.stdout.splitlines() if line.startswith("FACTS ")]
    assert facts_lines, done.stdout + done.stderr
    return json.loads(facts_lines[0].removeprefix("FACTS "))


pytestmark = pytest.mark.timeout(260)


def test_a_second_gateway_refuses(facts):
    assert facts["gateway listens"] and facts["second's exit code"] == 1
    assert "two would carry everything twice" in facts["second says"]


def test_what_would_move_the_robot_is_told(facts):
    assert facts["moves"] == ["/class/notebook publishes /cmd_vel, /r1/robot listens"]


def test_topics_of_the_robot_are_heard_once_in_order_and_latched_ones_too(facts):
    assert facts["robot is seen"] and facts["scans"] and facts["scans once and in order"]
    assert facts["latched"] == ["<robot/>"]


def test_services_both_ways_parameters_and_actions(facts):
    assert facts["service"] == "done by the robot" and facts["robot calls"] and facts["parameter"] == 1.5
    assert facts["action"] == [0, 1, 2, 3]
    assert facts["feedback"] == [1, 2, 3, 4][: len(facts["feedback"])] != []


def test_the_robot_sees_the_notebooks_node_under_its_own_name(facts):
    assert "notebook" in facts["robot sees"][0].split()


def test_the_same_words_from_both_sides_are_heard_once_by_each(facts):
    assert facts["robot hears all"] and facts["notebook hears all"] and facts["heard on both"] == [40, 40]


def test_a_restart_of_the_robot_and_one_of_the_gateway_are_survived(facts):
    assert facts["robot's end is seen"] and facts["robot's restart"]
    assert facts["gateway's end is seen"] and facts["gateway's restart"]


def test_the_robot_is_stopped_when_who_drives_it_leaves(facts):
    assert facts["stopped"], facts["gateway says"]
