from __future__ import annotations

import argparse

import pytest

from coursekit.cli.verbs import launch as verb

FILE = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, LogInfo
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value=['1', '.5'], description='metres per second'),
        DeclareLaunchArgument('name'),
        GroupAction([DeclareLaunchArgument('extra', default_value='')], condition=IfCondition('false')),
        LogInfo(msg=[LaunchConfiguration('name'), ' at ', LaunchConfiguration('speed')]),
    ])
"""


@pytest.fixture
def ros2(session, workspace, capsys: pytest.CaptureFixture[str]):
    workspace.file("demo", "launch/go.launch.py", FILE)
    workspace.file("demo", "launch/two.launch.xml", "<launch/>")
    workspace.file("demo", "other/two.launch.xml", "<launch/>")

    def run(*words: str) -> tuple[int, str, str]:
        parser = argparse.ArgumentParser()
        verb.register(parser.add_subparsers())
        args = parser.parse_args(["launch", *words])
        process = session.start(lambda: args.main(args), name="ros2", argv=words)
        code = process.wait()
        return code, process.out.text("stdout"), process.out.text("stderr")

    return run


def test_a_file_of_a_package_is_launched_with_its_arguments(ros2) -> None:
    code, out, _ = ros2("demo", "go.launch.py", "name:=tom", "name:=tim")
    assert code == 0
    assert out.splitlines()[2:] == ["[INFO] [launch.user]: tim at 1.5"]


def test_a_file_is_launched_by_its_path(ros2, workspace) -> None:
    path = str(workspace.prefix / "share/demo/launch/go.launch.py")
    for words in ([path, "name:=tom"], [path, "name:=tom", "speed:=2"]):
        code, out, _ = ros2(*words)
        assert code == 0
        assert "[launch.user]: tom at" in out


def test_a_missing_argument_fails_the_launch(ros2) -> None:
    code, out, _ = ros2("demo", "go.launch.py")
    assert code == 1
    assert "missing required argument 'name' (description: 'no description given'), given: []" in out


def test_the_arguments_are_shown(ros2) -> None:
    code, out, _ = ros2("demo", "go.launch.py", "--show-args")
    assert (code, out) == (
        0,
        """\
Arguments (pass arguments as '<name>:=<value>'):

    'speed':
        metres per second
        (default: '1' + '.5')

    'name':
        no description given

    'extra':*
        no description given
        (default: '')

* argument(s) which are only used if specific conditions occur
""",
    )
    assert ros2("-s", "demo", "go.launch.py")[1] == out


def test_no_arguments_are_said_to_be_none(ros2, workspace) -> None:
    path = str(workspace.prefix / "share/demo/launch/two.launch.xml")
    assert ros2(path, "-s")[1] == "Arguments (pass arguments as '<name>:=<value>'):\n\n  No arguments.\n"


def test_the_description_is_printed(ros2) -> None:
    code, out, _ = ros2("-p", "demo", "go.launch.py")
    assert code == 0
    assert "└── LogInfo(LaunchConfig('name') + ' at ' + LaunchConfig('speed'))" in out


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["demmo", "go.launch.py"], ["Package 'demmo' not found", "did you mean demo?"]),
        (
            ["demo", "gone.launch.py"],
            [
                "file 'gone.launch.py' was not found in the share directory of package 'demo' which is at",
                "its launch files: go.launch.py",
            ],
        ),
        (
            ["demo", "two.launch.xml"],
            ["file 'two.launch.xml' was found more than once in the share directory"],
        ),
        (["demo"], ["No launch file supplied", "go.launch.py"]),
        (["./none.launch.py"], ["No launch file supplied", "./none.launch.py"]),
        (
            ["demo", "go.launch.py", "name=x"],
            ["malformed launch argument 'name=x', expected format '<name>:=<value>'"],
        ),
        (["demo", "go.launch.py", ":=x"], ["malformed launch argument ':=x'"]),
        (["demo", "go.launch.py", "name:="], ["malformed launch argument 'name:='"]),
    ],
)
def test_what_cannot_be_launched_is_an_error_on_stderr(ros2, words: list[str], expected: list[str]) -> None:
    code, out, err = ros2(*words)
    assert (code, out) == (1, "")
    for text in expected:
        assert text in err


def test_a_syntax_error_is_an_error_of_the_launch_file(ros2, workspace) -> None:
    workspace.file("demo", "launch/bad.launch.py", "def generate(:\n")
    code, out, _ = ros2("demo", "bad.launch.py")
    assert code == 1
    assert "Caught exception when trying to load file of format [py]: invalid syntax" in out
    assert ros2("demo", "bad.launch.py", "-s")[0] == 1


def test_all_output_and_prefixes_can_be_asked_for(ros2, workspace) -> None:
    workspace.file("demo", "launch/echo.launch.xml", '<launch><executable cmd="echo a"/></launch>')
    assert "[echo-1] a" not in ros2("demo", "echo.launch.xml")[1]
    assert "[echo-1] a" in ros2("demo", "echo.launch.xml", "-a")[1]
    assert "[echo-1] echo a" in ros2("demo", "echo.launch.xml", "-a", "--launch-prefix", "echo")[1]


def test_names_are_completed(workspace, tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    workspace.file("demo", "launch/go.launch.py", FILE)
    assert verb.complete_file_name("g", argparse.Namespace(package_name="demo")) == ["go.launch.py"]
    assert verb.complete_file_name("", argparse.Namespace(package_name="none such")) == []
    (tmp_path / "here.launch.xml").touch()
    monkeypatch.chdir(tmp_path)
    assert verb.complete_package_or_file("he") == ["here.launch.xml"]
    assert "demo" in verb.complete_package_or_file("de")
