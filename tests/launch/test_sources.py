from __future__ import annotations

from pathlib import Path

import pytest
from launch import InvalidLaunchFileError, LaunchContext, LaunchDescription, LaunchIntrospector
from launch.actions import (
    DeclareLaunchArgument,
    ExecuteProcess,
    GroupAction,
    IncludeLaunchDescription,
    LogInfo,
    ResetLaunchConfigurations,
    TimerAction,
)
from launch.conditions import IfCondition
from launch.launch_description_sources import (
    InvalidPythonLaunchFileError,
    PythonLaunchDescriptionSource,
    get_launch_description_from_any_launch_file,
)
from launch.substitutions import LaunchConfiguration

USER = "[INFO] [launch.user]: "
GOOD = """
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import ThisLaunchFileDir


def generate_launch_description():
    return LaunchDescription([LogInfo(msg=['here: ', ThisLaunchFileDir()])])
"""


def write(tmp_path: Path, text: str, name: str = "a.launch.py") -> str:
    path = tmp_path / name
    path.write_text(text)
    return str(path)


def test_a_python_file_gives_its_description(launch, tmp_path: Path) -> None:
    source = PythonLaunchDescriptionSource(
        [LaunchConfiguration("folder", default=str(tmp_path)), "/a.launch.py"]
    )
    write(tmp_path, GOOD)
    assert launch([IncludeLaunchDescription(source)]).lines == [USER + f"here: {tmp_path}"]
    assert not (tmp_path / "__pycache__").exists()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("def generate(:\n", ["invalid syntax", "line 1"]),
        ("x = 1\n", ["does not contain the required function", "generate_launch_description()"]),
        ("\n\nimport no_such_module\n", ["a.launch.py:3", "ModuleNotFoundError"]),
        ("def generate_launch_description():\n    return 1 / 0\n", ["a.launch.py:2", "ZeroDivisionError"]),
        ("def generate_launch_description():\n    return [1]\n", ["must return a LaunchDescription", "list"]),
    ],
)
def test_a_wrong_python_file_says_where_and_why(tmp_path: Path, text: str, words: list[str]) -> None:
    path = write(tmp_path, text)
    with pytest.raises((InvalidLaunchFileError, InvalidPythonLaunchFileError)) as caught:
        get_launch_description_from_any_launch_file(path)
    for word in words:
        assert word in str(caught.value)


def test_a_file_that_does_not_exist_is_said_to_be(launch, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="launch file does not exist"):
        get_launch_description_from_any_launch_file(str(tmp_path / "none.launch.py"))
    assert "none.launch.py" in launch([IncludeLaunchDescription(str(tmp_path / "none.launch.py"))]).text


def test_arguments_are_found_through_includes_groups_and_conditions(tmp_path: Path) -> None:
    inner = LaunchDescription([DeclareLaunchArgument("inner")])
    description = LaunchDescription(
        [
            DeclareLaunchArgument("a", default_value="1"),
            DeclareLaunchArgument("a", default_value="2"),
            GroupAction([DeclareLaunchArgument("b")]),
            GroupAction([DeclareLaunchArgument("c")], condition=IfCondition("true")),
            IncludeLaunchDescription(inner),
            IncludeLaunchDescription(PythonLaunchDescriptionSource(LaunchConfiguration("unknown yet"))),
            ResetLaunchConfigurations(),
            DeclareLaunchArgument("unreachable"),
        ]
    )
    arguments = description.get_launch_arguments()
    assert [(argument.name, argument._conditionally_included) for argument in arguments] == [
        ("a", False),
        ("b", False),
        ("c", True),
        ("inner", False),
    ]


def test_a_deprecated_description_warns(launch) -> None:
    description = LaunchDescription([], deprecated_reason="use the new one")
    assert description.deprecated
    assert launch([description]).lines == [
        "[WARNING] [launch]: deprecated launch description: use the new one"
    ]


def test_a_description_is_shown_as_a_tree() -> None:
    text = LaunchIntrospector().format_launch_description(
        LaunchDescription(
            [
                LogInfo(msg=["a", LaunchConfiguration("b")]),
                ExecuteProcess(cmd=["echo", "x"]),
                TimerAction(period=1.0, actions=[LogInfo(msg="later")]),
            ]
        )
    )
    assert text.splitlines()[1:] == [
        "├── LogInfo('a' + LaunchConfig('b'))",
        "├── ExecuteProcess(cmd=['echo', 'x'])",
        "└── TimerAction(period=1.0, actions=<actions>)",
        "    └── ConditionalGroup(1.0 seconds pass without being canceled)",
        "        └── LogInfo('later')",
    ]


def test_locals_know_what_they_hold(context: LaunchContext) -> None:
    context.extend_globals({"everywhere": 1})
    context._push_locals()
    context.extend_locals({"here": 2})
    assert (context.locals.everywhere, context.locals.here) == (1, 2)
    with pytest.raises(AttributeError, match="known: everywhere, here"):
        _ = context.locals.there
    with pytest.raises(AttributeError, match="read-only"):
        context.locals.here = 3
    context._pop_locals()
    assert context.get_locals_as_dict() == {"everywhere": 1}


def test_markup_sources_are_also_found_under_their_own_packages() -> None:
    from launch import launch_description_sources as ours
    from launch_xml.launch_description_sources import XMLLaunchDescriptionSource
    from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource

    assert XMLLaunchDescriptionSource is ours.XMLLaunchDescriptionSource
    assert YAMLLaunchDescriptionSource is ours.YAMLLaunchDescriptionSource
