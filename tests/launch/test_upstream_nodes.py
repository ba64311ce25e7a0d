"""What programs and their tests expect of launch_ros beyond launch files."""

from __future__ import annotations

import asyncio
import io
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.actions import EmitEvent, RegisterEventHandler, TimerAction
from launch.frontend import Parser
from launch.substitutions import TextSubstitution
from launch.utilities import perform_substitutions
from launch_ros.actions import LifecycleNode, LifecycleTransition, Node, SetParametersFromFile, SetRosLogDir
from launch_ros.descriptions import Parameter, ParameterValue
from launch_ros.ros_adapters import ROSAdapter
from osrf_pycommon.process_utils import get_loop


def node(**kwargs: Any) -> Node:
    return Node(package="demo", executable="show", name="n", namespace="ns", **kwargs)


def read(text: str) -> LaunchDescription:
    root, parser = Parser.load(io.StringIO(text))
    return parser.parse_description(root)


def test_a_node_keeps_what_its_parameters_became(context: LaunchContext, tmp_path: Path) -> None:
    file = tmp_path / "p.yaml"
    file.write_text("/**: {ros__parameters: {a: 1}}")
    action = node(parameters=[file, {"b": 2}, Parameter("c", [1.5]), str(tmp_path / "nothing.yaml")])
    action._perform_substitutions(context)
    (first, second, third) = action._Node__expanded_parameter_arguments  # type: ignore[attr-defined]
    assert first == (str(file), True)
    told = Path(second[0]).read_text(encoding="utf-8")
    assert second[1] and yaml.safe_load(told) == {"/ns/n": {"ros__parameters": {"b": 2}}}
    assert third == ("c:=[1.5]", False)


def test_a_parameter_file_is_looked_for_by_the_nodes_that_come_after(context: LaunchContext) -> None:
    SetParametersFromFile("./nowhere.yaml").execute(context)
    assert context.launch_configurations["global_params"] == ["./nowhere.yaml"]
    with pytest.raises(FileNotFoundError, match="nowhere"):
        node()._perform_substitutions(context)


def test_a_lifecycle_node_needs_name_and_namespace() -> None:
    for given in ({"name": "n"}, {"namespace": "ns"}):
        with pytest.raises(TypeError):
            LifecycleNode(package="a", executable="b", **given)  # type: ignore[call-arg,arg-type]


def test_a_lifecycle_transition_takes_numbers_as_text_and_waits_for_each(context: LaunchContext) -> None:
    actions = LifecycleTransition(lifecycle_node_names=["n"], transition_ids=["1"]).execute(context) or []
    assert [type(action) for action in actions] == [RegisterEventHandler, EmitEvent]
    for names, transitions in ((["n"], []), ([], [1])):
        with pytest.raises(ValueError):
            LifecycleTransition(lifecycle_node_names=names, transition_ids=transitions)


def test_text_is_no_number() -> None:
    with pytest.raises(TypeError, match="without quotes"):
        ParameterValue("1", value_type=int)
    assert ParameterValue(TextSubstitution(text="1"), value_type=int).evaluate(LaunchContext()) == 1


@pytest.mark.parametrize(("kind", "value"), [("list_of_int", [1, 2]), ("list_of_str", ["1", "2"])])
def test_types_of_lists_are_named_as_in_launch(context: LaunchContext, kind: str, value: list[Any]) -> None:
    element = f'<param name="a" value="1,2" value-sep="," type="{kind}"/>'
    (action,) = read(f'<launch><node pkg="p" exec="e">{element}</node></launch>').entities
    assert next(iter(action._Node__parameters[0].values())).evaluate(context) == value  # type: ignore[attr-defined]


def test_a_parameter_for_all_nodes_has_substitutions_as_value(context: LaunchContext) -> None:
    (action,) = read('<launch><set_parameter name="a" value="$(env PATH)/x"/></launch>').entities
    action.execute(context)
    assert perform_substitutions(context, action.value) == context.launch_configurations["global_params"][0][1]


def test_a_relative_log_folder_lies_in_the_one_before(context: LaunchContext, tmp_path: Path) -> None:
    context.environment["ROS_LOG_DIR"] = str(tmp_path)
    SetRosLogDir("a").visit(context)
    (action,) = read('<launch><set_ros_log_dir new_log_dir="b"/></launch>').entities
    action.visit(context)
    assert context.environment["ROS_LOG_DIR"] == str(tmp_path / "a" / "b")


def test_an_adapter_can_be_started_again(session) -> None:
    def main() -> None:
        adapter = ROSAdapter()
        before = adapter.ros_context, adapter.ros_executor
        adapter.shutdown()
        assert adapter.ros_node is None
        adapter.start()
        assert adapter.ros_node is not None and adapter.ros_context not in before
        adapter.shutdown()

    assert session.start(main, name="main").wait(5) == 0


def test_a_launch_on_a_loop_of_ones_own_ends_by_a_task_of_its_shutdown() -> None:
    loop, service = get_loop(), LaunchService()
    service.include_launch_description(LaunchDescription([TimerAction(period=1000.0, actions=[])]))
    task = loop.create_task(service.run_async())
    loop.run_until_complete(asyncio.sleep(0.01))
    loop.create_task(service.shutdown())
    assert loop.run_until_complete(task) == 0


def test_who_has_imported_launch_reaches_the_loop_through_osrf_pycommon_alone() -> None:
    program = "import launch, osrf_pycommon; osrf_pycommon.process_utils.get_loop().close()"
    subprocess.run([sys.executable, "-c", program], check=True, timeout=60)


@pytest.mark.parametrize("package", ["launch", "launch_ros", "launch_xml", "launch_yaml", "rclpy"])
def test_packages_of_launch_and_rclpy_are_found(package: str) -> None:
    assert (Path(get_package_share_directory(package)) / "package.xml").is_file()
