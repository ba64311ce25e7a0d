"""launch_ros as programs that look at its actions know it: names, orders, files."""

from __future__ import annotations

import asyncio
import os
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.substitutions import TextSubstitution
from launch.utilities import perform_substitutions
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes, Node, RosTimer, SetParameter, SetUseSimTime
from launch_ros.actions.load_composable_nodes import get_composable_node_load_request
from launch_ros.descriptions import ComposableNode, ParameterFile, ParameterValue
from rclpy.parameter import Parameter as NodeParameter


class Context:
    """As little as substitutions and actions need."""

    def __init__(self) -> None:
        self.launch_configurations: dict[str, Any] = {}

    def perform_substitution(self, sub: Any) -> str:
        return sub.perform(None)


@pytest.mark.parametrize("wrap", [lambda sub: sub, lambda sub: (sub,), lambda sub: [sub]])
def test_parameters_for_all_are_listed_as_they_were_set(wrap: Any) -> None:
    context: Any = Context()
    SetParameter(wrap(TextSubstitution(text="a")), wrap(TextSubstitution(text="x"))).execute(context)
    SetParameter("a", ParameterValue("y")).execute(context)
    assert context.launch_configurations["global_params"] == [("a", "x"), ("a", "y")]


def test_a_component_is_asked_with_the_parameters_for_all_before_its_own() -> None:
    context: Any = Context()
    SetParameter("a", "1").execute(context)
    SetParameter("b", "2").execute(context)
    component = ComposableNode(package="p", plugin="P", name="n", namespace="ns", parameters=[{"b": "3"}])
    request = get_composable_node_load_request(component, context)
    assert [(parameter.name, parameter.value.string_value) for parameter in request.parameters] == [
        ("a", "1"),
        ("b", "2"),
        ("b", "3"),
    ]


def test_the_copy_of_a_parameter_file_is_deleted_by_cleanup(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("/n:\n  ros__parameters:\n    a: 1\n")
    copied, plain = ParameterFile(str(path), allow_substs=True), ParameterFile(str(path))
    copy = copied.evaluate(LaunchContext())
    assert copy != path and plain.evaluate(LaunchContext()) == path
    for parameter_file in (copied, plain):
        parameter_file.cleanup()
    assert not copy.exists() and isinstance(copied.param_file, list)
    assert path.exists() and os.fspath(plain.param_file) == str(path)


def test_what_actions_were_given_is_found_under_upstreams_names() -> None:
    component = ComposableNode(package="p", plugin="P", name="n", namespace="ns")
    options: dict[str, Any] = {"package": "c", "executable": "e", "name": "m", "namespace": "", "arguments": ["x"]}
    container: Any = ComposableNodeContainer(**options, composable_node_descriptions=[component])
    loading: Any = LoadComposableNodes(target_container="/m", composable_node_descriptions=[component])
    assert container._ComposableNodeContainer__composable_node_descriptions == [component]
    assert loading._LoadComposableNodes__composable_node_descriptions == [component]
    assert perform_substitutions(LaunchContext(), loading._LoadComposableNodes__target_container) == "/m"
    for name in ("package", "node_executable", "node_name", "node_namespace", "arguments"):
        assert getattr(container, f"_Node__{name}") == options[name.removeprefix("node_")]
    for name in ("package", "node_plugin", "node_name", "node_namespace"):
        assert isinstance(getattr(component, f"_ComposableNode__{name}"), list)


def test_lists_are_tuples_in_the_parameter_file_of_a_node_which_reads_it() -> None:
    from coursekit.rcl.arguments import parse_ros_arguments

    parameters = [{"a": [1.5, 2.5], "b": {"c": ["x"]}}]
    node: Any = Node(package="p", executable="e", name="n", namespace="ns", parameters=parameters)
    node._perform_substitutions(LaunchContext())
    ((path, is_file),) = node._Node__expanded_parameter_arguments
    assert is_file and "a: !!python/tuple" in Path(path).read_text(encoding="utf-8")
    read = parse_ros_arguments(["--ros-args", "--params-file", path]).parameters_for("/ns/n")
    values = {name: NodeParameter(name, value=value).value for name, value in read.items()}
    assert {name: list(value) for name, value in values.items()} == {"a": [1.5, 2.5], "b.c": ["x"]}


def test_a_timer_of_ros_heeds_simulated_time_that_is_set_after_it(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[bool] = []

    class Asked:
        def set_parameters(self, parameters: list[Any]) -> None:
            seen.append(parameters[0].value)

        def get_clock(self) -> None: ...

        def create_timer(self, period: float, callback: Any, clock: Any) -> Any:
            asyncio.get_running_loop().call_soon(callback)
            return type("Timer", (), {"cancel": lambda self: None})()

    monkeypatch.setattr("launch_ros.actions.ros_timer.get_ros_node", lambda context: Asked())
    for after in ([], [SetUseSimTime(True)]):
        service = LaunchService()
        service.include_launch_description(LaunchDescription([RosTimer(period=1.0, actions=[]), *after]))
        assert service.run() == 0
    assert seen == [False, True]
