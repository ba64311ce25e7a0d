"""nav2_common.launch: parameter files made of others."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml
from launch import LaunchContext
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from nav2_common.launch import HasNodeParams, ParseMultiRobotPose, ReplaceString, RewrittenYaml

SOURCE = """
amcl: {ros__parameters: {use_sim_time: false, alpha1: 0.2, frame: <robot>/odom}}
map_server: {ros__parameters: {use_sim_time: false, yaml_filename: '', layers: {inflation: {radius: 0.5}}}}
"""


@pytest.fixture
def source(tmp_path: Path) -> str:
    path = tmp_path / "params.yaml"
    path.write_text(SOURCE)
    return str(path)


def rewritten(source: str, **arguments: Any) -> Any:
    context = LaunchContext()
    context.launch_configurations["map"] = "office.yaml"
    return yaml.safe_load(Path(RewrittenYaml(source, **arguments).perform(context)).read_text(encoding="utf-8"))


def test_a_key_is_rewritten_wherever_it_stands_and_only_there(source: str) -> None:
    parameters = rewritten(source, param_rewrites={"use_sim_time": "True", "yaml_filename": LaunchConfiguration("map")})
    assert parameters["amcl"]["ros__parameters"] == {"use_sim_time": True, "alpha1": 0.2, "frame": "<robot>/odom"}
    assert parameters["map_server"]["ros__parameters"]["yaml_filename"] == "office.yaml"
    assert yaml.safe_load(Path(source).read_text(encoding="utf-8")) == yaml.safe_load(SOURCE)


def test_nothing_to_rewrite_may_be_an_empty_text(source: str) -> None:
    """As nav2's tutorials write it."""
    assert rewritten(source, param_rewrites="", root_key="") == yaml.safe_load(SOURCE)


def test_a_path_names_one_key(source: str) -> None:
    parameters = rewritten(source, param_rewrites={"amcl.ros__parameters.use_sim_time": "true"})
    assert parameters["amcl"]["ros__parameters"]["use_sim_time"] is True
    assert parameters["map_server"]["ros__parameters"]["use_sim_time"] is False


@pytest.mark.parametrize(
    ("text", "as_they_are", "converted"),
    [("3", "3", 3), ("0.25", "0.25", 0.25), ("TRUE", True, True), ("false", False, False), ("fast", "fast", "fast")],
)
def test_types(source: str, text: str, as_they_are: Any, converted: Any) -> None:
    for convert, wanted in ((False, as_they_are), (True, converted)):
        parameters = rewritten(source, param_rewrites={"radius": text}, convert_types=convert)
        radius = parameters["map_server"]["ros__parameters"]["layers"]["inflation"]["radius"]
        assert radius == wanted and type(radius) is type(wanted)


def test_a_root_key_and_renamed_keys(source: str) -> None:
    parameters = rewritten(source, param_rewrites={}, root_key="robot1", key_rewrites={"amcl": "my_amcl"})
    assert list(parameters) == ["robot1"]
    assert set(parameters["robot1"]) == {"my_amcl", "map_server"}
    assert set(rewritten(source, param_rewrites={}, root_key="")) == {"amcl", "map_server"}


def test_words_are_replaced_while_the_condition_holds(source: str) -> None:
    context = LaunchContext()
    path = ReplaceString(source, {"<robot>": "robot1"}).perform(context)
    assert "robot1/odom" in Path(path).read_text(encoding="utf-8")
    assert ReplaceString(source, {"<robot>": "x"}, IfCondition("false")).perform(context) == source


def test_a_file_is_asked_for_a_node(source: str) -> None:
    context = LaunchContext()
    assert HasNodeParams(source, "amcl").perform(context) == "True"
    assert HasNodeParams(source, "planner_server").perform(context) == "False"


def test_the_command_line_names_robots_and_their_poses(monkeypatch: pytest.MonkeyPatch) -> None:
    robots = "robots:=one={x: 1, yaw: 1.57}; two = {y: -2.5, z: 0.1};nonsense"
    monkeypatch.setattr("sys.argv", ["ros2", "launch", "my_robots", "many.launch.py", "gui:=false", robots])
    zero = dict.fromkeys(("x", "y", "z", "roll", "pitch", "yaw"), 0.0)
    poses = {"one": zero | {"x": 1, "yaw": 1.57}, "two": zero | {"y": -2.5, "z": 0.1}}
    assert ParseMultiRobotPose("robots").value() == poses
    assert ParseMultiRobotPose("others").value() == {}
