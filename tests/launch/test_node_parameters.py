from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml
from launch.actions import GroupAction, LogInfo, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, TextSubstitution
from launch_ros.actions import (
    SetParameter,
    SetParametersFromFile,
    SetRemap,
    SetUseSimTime,
)
from launch_ros.descriptions import ParameterFile, ParameterValue
from launch_ros.parameter_descriptions import Parameter as OneParameter
from launch_ros.substitutions import Parameter

from tests.launch.show import SHOW, Arguments, node


def file_of(arguments: str) -> Any:
    return yaml.load(Path(arguments.split("--params-file ")[1].split()[0]).read_text(encoding="utf-8"), yaml.FullLoader)


def test_parameters_are_written_to_a_file_for_the_node(show: Arguments) -> None:
    (arguments,) = show(
        SetLaunchConfiguration("off", "off"),
        node(
            name="n",
            namespace="/",
            parameters=[
                {
                    "a": 1,
                    "b": 2.5,
                    "c": True,
                    "d": "text",
                    "e": "off",
                    "f": LaunchConfiguration("off"),
                    "g": [1, 2.5],
                    "h": {"i": {"j": "x"}},
                    (TextSubstitution(text="k"), LaunchConfiguration("off")): 3,
                    "l": ["a", "b"],
                    "m": ParameterValue(LaunchConfiguration("off"), value_type=str),
                    "n": [[LaunchConfiguration("off"), "a"], "b"],
                    "o": ["x", LaunchConfiguration("off")],
                    "p": "1",
                }
            ],
        ),
    )
    values = file_of(arguments)["/n"]["ros__parameters"]
    assert values == {
        "a": 1,
        "b": 2.5,
        "c": True,
        "d": "text",
        "e": "off",
        "f": False,
        "g": (1.0, 2.5),
        "h.i.j": "x",
        "koff": 3,
        "l": ("a", "b"),
        "m": "off",
        "n": ("offa", "b"),
        "o": "xoff",
        "p": "1",
    }
    assert all(type(item) is float for item in values["g"])


def test_the_file_is_for_all_nodes_when_the_name_is_not_known(show: Arguments) -> None:
    (arguments,) = show(node(parameters=[{"a": 1}]))
    assert file_of(arguments) == {"/**": {"ros__parameters": {"a": 1}}}


def test_files_and_mappings_keep_their_order(show: Arguments, tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text("/**: {ros__parameters: {a: 1}}")
    (arguments,) = show(
        SetLaunchConfiguration("folder", str(tmp_path)),
        node(
            parameters=[
                {"a": 0},
                PathJoinSubstitution([LaunchConfiguration("folder"), "p.yaml"]),
                tmp_path / "p.yaml",
                OneParameter("b", "x"),
            ]
        ),
    )
    file = tmp_path / "p.yaml"
    assert arguments.endswith(f" --params-file {file} --params-file {file} -p b:=x")


def test_a_file_that_does_not_exist_is_warned_of_and_left_out(launch, workspace, tmp_path: Path) -> None:
    workspace.executable("demo", "show", SHOW)
    result = launch([node(parameters=[str(tmp_path / "none.yaml")])])
    assert (
        f"[WARNING] [launch_ros.actions.node]: Parameter file path is not a file: {tmp_path / 'none.yaml'}"
        in result.lines
    )
    assert "[show-1] ARGV --ros-args" in result.lines


def test_substitutions_in_a_parameter_file_are_performed_on_request(show: Arguments, tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/**:\n  ros__parameters:\n    robot: $(var robot)  # $(var comment)\n")
    (arguments,) = show(
        SetLaunchConfiguration("robot", "r2"), node(parameters=[ParameterFile(str(path), allow_substs=True)])
    )
    assert file_of(arguments) == {"/**": {"ros__parameters": {"robot": "r2"}}}


@pytest.mark.parametrize(
    "wrong", [[{"a": None}], [{"a": []}], ["a", 3], [{"a": object()}], [{3: "a"}], [{"a": [1, [2]]}]]
)
def test_wrong_parameters_are_type_errors_or_fail_the_launch(launch, workspace, wrong) -> None:
    workspace.executable("demo", "show", SHOW)
    try:
        action = node(parameters=wrong)
    except TypeError:
        return
    assert launch([action]).code == 1


def test_parameters_and_remappings_must_have_the_right_shape() -> None:
    with pytest.raises(TypeError):
        node(parameters={"a": 1})
    with pytest.raises(TypeError, match="'remapping' expected to be"):
        node(remappings=[["a", "b"]])
    with pytest.raises(TypeError, match="2-tuple"):
        node(remappings=[("a", "b", "c")])


def test_what_a_substitution_gives_must_be_a_parameter(launch, workspace) -> None:
    workspace.executable("demo", "show", SHOW)
    result = launch(
        [SetLaunchConfiguration("x", "{a: 1}"), node(parameters=[{"a": LaunchConfiguration("x")}])]
    )
    assert result.code == 1
    assert "Allowed value types are bytes, bool, int, float, str" in result.text
    assert "ParameterValue(value, value_type=str)" in result.text


def test_parameters_can_be_set_for_all_nodes_of_a_group(show: Arguments, tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text("/**: {ros__parameters: {a: 1}}")
    inside, outside = show(
        GroupAction(
            [
                SetParameter("speed", 1),
                SetParameter("speed", 2.5),
                SetParameter("words", ["a", "b"]),
                SetParameter("text", "1"),
                SetUseSimTime(True),
                SetParametersFromFile(str(tmp_path / "p.yaml")),
                SetRemap("a", "b"),
                node(remappings=[("c", "d")]),
            ]
        ),
        node(),
    )
    # argv is shown without quotes around the parts that hold spaces
    assert inside == (
        f"--ros-args -p speed:=1 -p speed:=2.5 -p words:=[a, b] -p text:='1' -p use_sim_time:=true "
        f"--params-file {tmp_path / 'p.yaml'} -r a:=b -r c:=d"
    )
    assert outside == "--ros-args"


def test_a_parameter_set_for_all_can_be_read_back(launch) -> None:
    result = launch(
        [SetParameter("a", 5), LogInfo(msg=[Parameter("a"), " ", Parameter("b", default="none")])]
    )
    assert result.lines == ["[INFO] [launch.user]: 5 none"]
    failed = launch([LogInfo(msg=Parameter("b"))])
    assert "parameter 'b' not found" in failed.text
