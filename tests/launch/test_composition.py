"""Containers in launch files: one process, whose components are loaded by its service."""

from __future__ import annotations

import pytest
from launch import LaunchContext
from launch.actions import GroupAction
from launch.conditions import IfCondition
from launch.frontend import Parser
from launch_ros.actions import (
    ComposableNodeContainer,
    LoadComposableNodes,
    PushRosNamespace,
    SetParameter,
    SetParametersFromFile,
    SetRemap,
)
from launch_ros.actions.load_composable_nodes import get_composable_node_load_request
from launch_ros.descriptions import ComposableNode, ParameterFile
from rclpy.parameter import parameter_value_to_python

LOADED = "[INFO] [launch_ros.actions.load_composable_nodes]: Loaded node "
FAILED = "[ERROR] [launch_ros.actions.load_composable_nodes]: Failed to load node "


def box(*components: ComposableNode, **kwargs: object) -> ComposableNodeContainer:
    given = {"name": "box", "namespace": "", "package": "rclcpp_components", "executable": "component_container"}
    return ComposableNodeContainer(composable_node_descriptions=list(components), **{**given, **kwargs})


def talker_named(name: str, **kwargs: object) -> ComposableNode:
    return ComposableNode(package="demo", plugin="demo::Talker", name=name, **kwargs)


def test_a_container_is_one_process_that_loads_its_components_in_order(launch, talker) -> None:
    result = launch(
        [box(talker_named("tom", parameters=[{"text": "hi"}]), talker_named("ann", parameters=[{"text": "ho"}]))],
        interrupt_after=1.5,
    )
    assert result.code == 0
    assert [line for line in result.lines if "process" in line and "started" in line] == [
        "[INFO] [component_container-1]: process started with pid [1001]"
    ]
    loaded = [line for line in result.lines if line.startswith(LOADED)]
    assert loaded == [f"{LOADED}'/{name}' in container '/box'" for name in ("tom", "ann")]
    assert '[component_container-1] [INFO] [1700000001.000000000] [tom]: Publishing: "hi 0" on /chatter' in result.lines
    assert '[ann]: Publishing: "ho 0" on /chatter' in result.text


def test_components_can_be_loaded_into_a_container_by_name(launch, talker) -> None:
    load = LoadComposableNodes(target_container="/ns/box", composable_node_descriptions=[talker_named("tom")])
    result = launch([box(namespace="ns"), load], interrupt_after=1.5)
    assert f"{LOADED}'/tom' in container '/ns/box'" in result.lines


def test_what_cannot_be_loaded_is_an_error_that_names_the_cure_and_the_launch_goes_on(launch, talker) -> None:
    camera = ComposableNode(package="demo", plugin="demo::Camera", name="cam")
    absent = ComposableNode(package="stereo_image_proc", plugin="stereo_image_proc::Disparity")
    result = launch([box(camera, absent, talker_named("tom"))], interrupt_after=1.5)
    errors = [line for line in result.lines if line.startswith(FAILED)]
    start = f"{FAILED}'cam' of type 'demo::Camera' in container '/box': Failed to find class with the requested plugin name."
    assert errors[0].startswith(start) and "called camera or camera_node" in errors[0]
    start = f"{FAILED}'' of type 'stereo_image_proc::Disparity' in container '/box': Could not find requested resource in"
    assert errors[1].startswith(start)
    assert f"{LOADED}'/tom' in container '/box'" in result.lines


def test_a_component_that_crashes_takes_the_container_along(launch, talker) -> None:
    talker.executable(
        "demo",
        "bomb",
        "import rclpy\nrclpy.init()\nnode = rclpy.create_node('bomb')\n"
        "def boom():\n    raise RuntimeError('boom')\nnode.create_timer(0.5, boom)\nrclpy.spin(node)\n",
    )
    result = launch([box(talker_named("tom"), ComposableNode(package="demo", plugin="demo::Bomb"))])
    assert "RuntimeError: boom" in result.text
    assert "[ERROR] [component_container-1]: process has died [pid 1001, exit code -6, cmd" in result.text
    assert "[tom]: Publishing" not in result.text


def test_a_container_that_nobody_started_is_waited_for_and_said(launch, talker) -> None:
    load = LoadComposableNodes(target_container="/box", composable_node_descriptions=[talker_named("tom")])
    lines = launch([load], interrupt_after=12.0).lines
    assert any("Nobody offers the '/box/_container/load_node' service yet" in line for line in lines)
    assert any("Abandoning wait for the '/box/_container/load_node' service, due to shutdown." in line for line in lines)


def test_a_name_that_is_there_twice_is_warned_of(launch, talker) -> None:
    result = launch([box(talker_named("tom"), talker_named("tom"))], interrupt_after=0.5)
    warning = "there are now at least 2 nodes with the name /tom created within this launch context"
    assert f"[WARNING] [/box]: {warning}" in result.lines


def test_a_request_holds_what_the_description_and_the_scope_say(context: LaunchContext, tmp_path) -> None:
    everywhere, own = tmp_path / "all.yaml", tmp_path / "own.yaml"
    everywhere.write_text("/**: {ros__parameters: {a: 1, b: file}}")
    own.write_text("/robot/arm/tom: {ros__parameters: {b: own}}\n/other: {ros__parameters: {c: 1}}")
    for action in (
        PushRosNamespace("robot"),
        SetRemap("x", "y"),
        SetParameter("use_sim_time", True),
        SetParametersFromFile(str(everywhere)),
    ):
        action.execute(context)
    description = talker_named(
        "tom",
        namespace="arm",
        remappings=[("chatter", "chat")],
        parameters=[ParameterFile(str(own)), {"gains": [1, 2.5]}],
        extra_arguments=[{"use_intra_process_comms": True}],
    )
    request = get_composable_node_load_request(description, context)
    assert (request.package_name, request.plugin_name) == ("demo", "demo::Talker")
    assert (request.node_name, request.node_namespace) == ("tom", "/robot/arm")
    assert request.remap_rules == ["x:=y", "chatter:=chat"]
    values = {parameter.name: parameter.value for parameter in request.parameters}
    assert (values["use_sim_time"].bool_value, values["a"].integer_value) == (True, 1)
    assert (values["b"].string_value, list(values["gains"].double_array_value)) == ("own", [1.0, 2.5])
    assert "c" not in values
    assert [(argument.name, argument.value.bool_value) for argument in request.extra_arguments] == [
        ("use_intra_process_comms", True)
    ]


def test_a_file_without_node_names_has_the_components_parameters(context: LaunchContext, tmp_path) -> None:
    file = tmp_path / "plain.yaml"
    file.write_text("some: 42\ntext: Hello\ngains: {p: 1.5, many: [1, 2]}\n")
    request = get_composable_node_load_request(talker_named("tom", parameters=[file]), context)
    values = [(parameter.name, parameter_value_to_python(parameter.value)) for parameter in request.parameters]
    assert values == [("some", 42), ("text", "Hello"), ("gains.p", 1.5), ("gains.many", [1, 2])]


def test_a_component_without_name_leaves_both_to_the_program(context: LaunchContext) -> None:
    request = get_composable_node_load_request(ComposableNode(package="a", plugin="a::B"), context)
    assert (request.node_name, request.node_namespace, request.parameters) == ("", "", [])


def test_a_condition_keeps_a_component_out(launch, talker) -> None:
    result = launch(
        [box(talker_named("tom", condition=IfCondition("false")), talker_named("ann", condition=IfCondition("true")))],
        interrupt_after=0.5,
    )
    assert [line for line in result.lines if line.startswith(LOADED)] == [f"{LOADED}'/ann' in container '/box'"]


def test_a_scope_that_is_left_before_the_loading_still_counts(launch, talker) -> None:
    load = LoadComposableNodes(target_container="/box", composable_node_descriptions=[talker_named("tom")])
    result = launch([box(), GroupAction([PushRosNamespace("robot"), load])], interrupt_after=0.5)
    assert f"{LOADED}'/robot/tom' in container '/box'" in result.lines


XML = """<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="ns">
    <composable_node pkg="demo" plugin="demo::Talker" name="tom" namespace="a">
      <param name="text" value="hi"/><remap from="chatter" to="chat"/>
      <extra_arg name="use_intra_process_comms" value="true"/>
    </composable_node>
    <composable_node pkg="demo" plugin="demo::Talker" name="no" if="false"/>
  </node_container>
  <load_composable_node target="/ns/box">
    <composable_node pkg="demo" plugin="demo::Talker" name="ann"/>
  </load_composable_node>
</launch>"""
YAML = """launch:
- node_container:
    {pkg: rclcpp_components, exec: component_container, name: box, namespace: ns, composable_node: [
      {pkg: demo, plugin: "demo::Talker", name: tom, namespace: a, param: [{name: text, value: hi}],
       remap: [{from: chatter, to: chat}], extra_arg: [{name: use_intra_process_comms, value: 'true'}]},
      {pkg: demo, plugin: "demo::Talker", name: "no", if: 'false'}]}
- load_composable_node: {target: /ns/box, composable_node: [{pkg: demo, plugin: "demo::Talker", name: ann}]}
"""


@pytest.mark.parametrize(("name", "text"), [("a.launch.xml", XML), ("a.launch.yaml", YAML)])
def test_launch_files_in_xml_and_yaml_load_components(launch, talker, tmp_path, name, text) -> None:
    path = tmp_path / name
    path.write_text(text)
    entity, parser = Parser.load(str(path))
    result = launch([parser.parse_description(entity)], interrupt_after=1.5)
    loaded = sorted(line for line in result.lines if line.startswith(LOADED))
    assert loaded == [f"{LOADED}'/a/tom' in container '/ns/box'", f"{LOADED}'/ann' in container '/ns/box'"]
    assert '[a.tom]: Publishing: "hi 0" on /a/chat' in result.text
