from __future__ import annotations

from pathlib import Path

import pytest
from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, SetLaunchConfiguration, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import (
    Node,
    PushRosNamespace,
    SetROSLogDir,
)
from launch_ros.descriptions import ParameterValue
from launch_ros.substitutions import ExecutableInPackage, FindPackagePrefix, FindPackageShare

from coursekit.systems import operating_system
from tests.launch.show import SHOW, Arguments, node


def test_a_plain_node_gets_no_names(show: Arguments) -> None:
    assert show(node()) == ["--ros-args"]


def test_names_remappings_and_arguments_become_ros_arguments(show: Arguments) -> None:
    (arguments,) = show(
        SetLaunchConfiguration("n", "tom"),
        node(
            name=LaunchConfiguration("n"),
            namespace="ns",
            arguments=["-x", LaunchConfiguration("n")],
            ros_arguments=["--log-level", "debug"],
            remappings=[("a", "b"), (["/c", "d"], LaunchConfiguration("n"))],
        ),
    )
    assert arguments == (
        "-x tom --ros-args --log-level debug --ros-args -r __node:=tom -r __ns:=/ns -r a:=b -r /cd:=tom"
    )


def test_the_process_may_have_a_name_of_its_own(launch, workspace) -> None:
    workspace.executable("demo", "show", SHOW)
    result = launch([node(exec_name="other")])
    assert result.lines[-1] == "[INFO] [other-1]: process has finished cleanly [pid 1001]"


@pytest.mark.parametrize(
    ("pushed", "own", "expected"),
    [
        ([], None, None),
        ([], "node_ns", "/node_ns"),
        ([], "/abs", "/abs"),
        ([], "", "/"),
        (["ns"], None, "/ns"),
        (["ns"], "node_ns", "/ns/node_ns"),
        (["ns"], "/abs", "/abs"),
        (["ns"], "", "/ns"),
        (["/ns"], "node_ns", "/ns/node_ns"),
        (["rel", "second"], "node_ns", "/rel/second/node_ns"),
        (["rel", "/abs"], "node_ns", "/abs/node_ns"),
        (["ns", "/"], "node_ns", "/node_ns"),
        (["ns/"], "node_ns", "/ns/node_ns"),
        (["one/two"], "three/", "/one/two/three"),
    ],
)
def test_namespaces_are_put_together(
    show: Arguments, pushed: list[str], own: str | None, expected: str | None
) -> None:
    (arguments,) = show(*[PushRosNamespace(name) for name in pushed], node(namespace=own))
    assert arguments == ("--ros-args" if expected is None else f"--ros-args -r __ns:={expected}")


def test_a_pushed_namespace_ends_with_its_group(show: Arguments) -> None:
    assert show(GroupAction([PushRosNamespace("a"), node()]), node()) == [
        "--ros-args -r __ns:=/a",
        "--ros-args",
    ]


@pytest.mark.parametrize(
    "entities", [[PushRosNamespace("not valid")], [node(name="not valid")], [node(namespace="1/2")]]
)
def test_invalid_names_are_errors(launch, workspace, entities) -> None:
    workspace.executable("demo", "show", SHOW)
    assert launch(entities).code == 1


def test_the_log_folder_of_nodes_can_be_set(launch, workspace) -> None:
    workspace.executable("demo", "show", SHOW)
    folder = Path(workspace.prefix.anchor, "x/y").as_posix()
    assert f"[show-1] LOG {folder}" in launch([SetROSLogDir("/x/y"), node()]).lines


def test_packages_and_executables_are_found(context: LaunchContext, workspace) -> None:
    path = workspace.executable("demo", "show", SHOW)
    assert FindPackagePrefix("demo").perform(context) == str(workspace.prefix)
    assert FindPackageShare(["de", "mo"]).perform(context) == str(workspace.prefix / "share/demo")
    assert ExecutableInPackage("show", "demo").perform(context) == str(path)


def test_what_is_not_found_is_an_error_that_names_the_alternatives(launch, workspace) -> None:
    workspace.executable("demo", "show", SHOW)
    assert "package 'demmo' not found" in launch([Node(package="demmo", executable="x")]).text.replace("\\", "")
    text = launch([Node(package="demo", executable="sho")]).text
    assert "executable 'sho' not found on the libexec directory" in text
    assert "the package has: show" in text


def test_a_program_that_was_not_compiled_is_told_and_the_others_start(launch, workspace) -> None:
    workspace.executable("demo", "show", SHOW)
    skipped = workspace.prefix / "share" / "ament_index" / "resource_index" / "coursekit_skipped" / "demo"
    skipped.parent.mkdir(parents=True)
    skipped.write_text("fast\n")
    result = launch([Node(package="demo", executable="fast", name="quick"), node()])
    (told,) = [line for line in result.lines if "fast" in line]
    assert told == (
        "[ERROR] [launch_ros.actions.node]: 'fast' is written in C++, which the last build of 'demo' skipped: "
        "`colcon build` shows why; the launch goes on without it"
    )
    assert result.code == 0 and "[INFO] [show-1]: process has finished cleanly [pid 1001]" in result.lines


def test_a_package_of_windows_runs_inside_by_its_script(launch, workspace, monkeypatch) -> None:
    """setuptools writes NAME.exe and NAME-script.py there; the first is what a launch starts, and what it names."""
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    workspace.executable("demo", "show-script.py", SHOW)
    workspace.executable("demo", "show.exe", "MZ: no program for Linux")
    result = launch([node()])
    assert "[INFO] [show.exe-1]: process has finished cleanly [pid 1001]" in result.lines
    assert "the package has: show.exe\n" in launch([Node(package="demo", executable="sho")]).text + "\n"


def test_two_nodes_of_one_name_are_warned_of(launch, workspace) -> None:
    workspace.executable("demo", "show", SHOW)
    result = launch([node(name="a", namespace="n"), node(name="a", namespace="n")])
    assert (
        "[WARNING] [launch_ros.actions.node]: there are now at least 2 nodes with the name /n/a created "
        "within this launch context"
    ) in result.lines


def test_the_full_name_is_known_after_it_was_carried_out(launch, workspace) -> None:
    workspace.executable("demo", "show", SHOW)
    action = node(name="a", namespace="n")
    with pytest.raises(RuntimeError, match="cannot access 'node_name' before executing action"):
        _ = action.node_name
    launch([action])
    assert action.node_name == "/n/a"


def test_an_executable_may_be_a_path(launch, workspace) -> None:
    path = workspace.executable("demo", "show", SHOW)
    assert "[show-1] ARGV --ros-args" in launch([Node(executable=str(path), output="screen")]).lines


def test_parameters_remappings_and_namespaces_reach_the_node(launch, talker) -> None:
    result = launch(
        [
            DeclareLaunchArgument("rate", default_value="2"),
            GroupAction(
                [
                    PushRosNamespace("robot1"),
                    Node(
                        package="demo",
                        executable="talker",
                        name="tom",
                        output="screen",
                        parameters=[
                            {
                                "text": "hi",
                                "rate": ParameterValue(LaunchConfiguration("rate"), value_type=float),
                            }
                        ],
                        remappings=[("chatter", "gossip")],
                    ),
                ]
            ),
        ],
        interrupt_after=0.6,
    )
    assert result.lines[1] == (
        '[talker-1] [INFO] [1700000000.500000000] [robot1.tom]: Publishing: "hi 0" on /robot1/gossip'
    )


def test_a_node_can_start_later(launch, talker, session) -> None:
    result = launch(
        [TimerAction(period=10.0, actions=[Node(package="demo", executable="talker", output="screen")])],
        interrupt_after=11.5,
    )
    assert "1700000011.000000000" in result.lines[1]


def test_a_description_may_be_made_of_nodes_without_launching(workspace) -> None:
    description = LaunchDescription([node(name="a")])
    assert len(description.entities) == 1
