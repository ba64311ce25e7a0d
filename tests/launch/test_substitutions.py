from __future__ import annotations

import os
import sys

import pytest
from launch import LaunchContext
from launch.substitutions import (
    AllSubstitution,
    AndSubstitution,
    AnonName,
    AnySubstitution,
    Command,
    EnvironmentVariable,
    EqualsSubstitution,
    FileContent,
    FindExecutable,
    IfElseSubstitution,
    LaunchConfiguration,
    LaunchLogDir,
    LocalSubstitution,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
    PathJoinSubstitution,
    PathSubstitution,
    PythonExpression,
    StringJoinSubstitution,
    SubstitutionFailure,
    TextSubstitution,
    ThisLaunchFile,
    ThisLaunchFileDir,
)
from launch_ros.substitutions import FindPackageShare

from tests.needs import posix
from tests.paths.workspace import HOSTILE


def test_text_stands_for_itself_and_must_be_text(context: LaunchContext) -> None:
    assert TextSubstitution(text="a").perform(context) == "a"
    with pytest.raises(TypeError, match="TextSubstitution expected 'Text' object got"):
        TextSubstitution(text=1)  # type: ignore[arg-type]


def test_a_launch_configuration_gives_its_value_or_its_default(context: LaunchContext) -> None:
    context.launch_configurations["a"] = "1"
    assert LaunchConfiguration("a").perform(context) == "1"
    assert LaunchConfiguration("b", default=5).perform(context) == "5"
    assert LaunchConfiguration("b", default=["x", LaunchConfiguration("a")]).perform(context) == "x1"


def test_an_unset_launch_configuration_fails_by_name(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure, match="launch configuration 'b' does not exist"):
        LaunchConfiguration("b").perform(context)


def test_environment_variables_are_read_when_performed(
    context: LaunchContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SET_HERE", "yes")
    assert EnvironmentVariable("SET_HERE").perform(context) == "yes"
    assert EnvironmentVariable("NOT_SET", default_value="no").perform(context) == "no"
    with pytest.raises(SubstitutionFailure, match="environment variable 'NOT_SET' does not exist"):
        EnvironmentVariable("NOT_SET").perform(context)


def test_paths_are_joined_and_parts_may_be_lists(context: LaunchContext) -> None:
    context.launch_configurations["robot"] = "r2"
    path = PathJoinSubstitution(["/a", "b", [LaunchConfiguration("robot"), ".urdf"]])
    assert path.perform(context) == os.path.join("/a", "b", "r2.urdf")
    assert StringJoinSubstitution(["a", "b"], delimiter="-").perform(context) == "a-b"


def test_a_slash_extends_a_path(context: LaunchContext, tmp_path) -> None:
    context.launch_configurations.update(base="/a", robot="r2")
    base = PathSubstitution(LaunchConfiguration("base"))
    file = base / "b" / [LaunchConfiguration("robot"), ".urdf"]
    assert file.perform(context) == os.path.join("/a", "b", "r2.urdf")
    assert (base / "c").perform(context) == os.path.join("/a", "c")  # the base stays what it was
    assert PathSubstitution(["/a", "b"]).perform(context) == os.path.join("/a", "b")
    assert (PathJoinSubstitution(["/a", "b"]) / "c").perform(context) == os.path.join("/a", "b", "c")
    assert (base / "/c").perform(context) == os.path.join("/a", "/c")


def test_a_slash_extends_the_folders_of_a_launch_and_of_a_package(context: LaunchContext, tmp_path) -> None:
    context.extend_locals({"current_launch_file_directory": "/a"})
    assert (ThisLaunchFileDir() / "b" / "c.py").perform(context) == os.path.join("/a", "b", "c.py")
    assert (LaunchLogDir() / "x.log").perform(context) == os.path.join(LaunchLogDir().perform(context), "x.log")
    share = FindPackageShare("urdf_tutorial")
    assert (share / "urdf").perform(context) == os.path.join(share.perform(context), "urdf")


@posix("there is no sh, env, nor an end by a signal")
def test_executables_are_found_on_the_path_and_beside_python(context: LaunchContext) -> None:
    assert os.path.basename(FindExecutable(name="sh").perform(context)) == "sh"
    python = os.path.basename(sys.executable)
    assert FindExecutable(name=python).perform(context)
    with pytest.raises(SubstitutionFailure, match="executable 'no-such-thing' not found on the PATH"):
        FindExecutable(name="no-such-thing").perform(context)


def test_a_command_gives_what_it_prints(context: LaunchContext) -> None:
    assert Command(["echo ", "'a  b'"]).perform(context) == "a  b\n"


@posix("there is no sh, env, nor an end by a signal")
@pytest.mark.parametrize(
    ("mode", "expected"), [("ignore", "out\n"), ("warn", "out\n"), ("capture", "err\nout\n")]
)
def test_error_output_of_a_command_is_dealt_with_as_asked(
    context: LaunchContext, mode: str, expected: str
) -> None:
    assert Command('sh -c "echo err >&2; echo out"', on_stderr=mode).perform(context) == expected


@pytest.mark.parametrize("command", ['sh -c "echo oops >&2"', 'sh -c "exit 3"', "no-such-program", ""])
def test_a_command_that_goes_wrong_is_a_failure(context: LaunchContext, command: str) -> None:
    with pytest.raises(SubstitutionFailure):
        Command(command).perform(context)


def test_an_unknown_way_to_deal_with_errors_is_a_failure(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure, match="on_stderr"):
        Command("true", on_stderr="shrug").perform(context)


def test_a_xacro_file_that_is_not_there_is_named(context):
    with pytest.raises(SubstitutionFailure, match="error: No such file or directory: .*nowhere.urdf.xacro") as caught:
        Command("xacro nowhere.urdf.xacro").perform(context)
    assert "AttributeError" not in str(caught.value)


def test_python_expressions_know_math_and_given_modules(context: LaunchContext) -> None:
    context.launch_configurations["n"] = "3"
    assert PythonExpression([LaunchConfiguration("n"), " * 2"]).perform(context) == "6"
    assert PythonExpression("round(cos(0.0)) + floor(pi)").perform(context) == "4"
    assert PythonExpression("math.sqrt(4)").perform(context) == "2.0"
    assert PythonExpression("sys.byteorder", ["sys"]).perform(context) == sys.byteorder


def test_a_wrong_expression_says_what_was_evaluated(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure, match='failed to evaluate the expression "a == 1"'):
        PythonExpression("a == 1").perform(context)


def test_locals_are_reached_by_name_attribute_and_item(context: LaunchContext) -> None:
    class Happened:
        reason = "because"

    context.extend_locals({"event": Happened(), "arguments": {"ns": "/a"}})
    assert LocalSubstitution("event.reason").perform(context) == "because"
    assert LocalSubstitution("arguments['ns']").perform(context) == "/a"
    for wrong in ("nothing", "event.nothing", "arguments['x']", '__import__("os")'):
        with pytest.raises(SubstitutionFailure):
            LocalSubstitution(wrong).perform(context)


def test_the_launch_file_is_known_only_inside_of_it(context: LaunchContext) -> None:
    for substitution in (ThisLaunchFile(), ThisLaunchFileDir()):
        with pytest.raises(SubstitutionFailure, match="used outside of a launch file"):
            substitution.perform(context)
    context.extend_locals({"current_launch_file_path": "/a/b", "current_launch_file_directory": "/a"})
    assert (ThisLaunchFile().perform(context), ThisLaunchFileDir().perform(context)) == ("/a/b", "/a")


def test_an_anonymous_name_is_unique_but_stays_the_same(context: LaunchContext) -> None:
    first = AnonName("node").perform(context)
    assert first.startswith("node_")
    assert AnonName("node").perform(context) == first
    assert AnonName("other").perform(context) != first
    assert AnonName("node").perform(LaunchContext()) != first


@pytest.mark.parametrize(
    ("substitution", "expected"),
    [
        (NotSubstitution("true"), "false"),
        (NotSubstitution("0"), "true"),
        (AndSubstitution("true", "1"), "true"),
        (AndSubstitution("true", "false"), "false"),
        (OrSubstitution("false", "TRUE"), "true"),
        (OrSubstitution("false", "0"), "false"),
        (AnySubstitution("false", "true", "0"), "true"),
        (AllSubstitution("true", "1", "false"), "false"),
        (EqualsSubstitution("a", "a"), "true"),
        (EqualsSubstitution("a", "b"), "false"),
        (EqualsSubstitution("1.0", "1"), "true"),
        (EqualsSubstitution(True, "true"), "true"),
        (NotEqualsSubstitution("a", "b"), "true"),
        (NotEqualsSubstitution(1, 1.0), "false"),
        (IfElseSubstitution("true", "yes", "no"), "yes"),
        (IfElseSubstitution("0", "yes", "no"), "no"),
        (IfElseSubstitution("false", if_value="yes"), ""),
    ],
)
def test_truth_substitutions(context: LaunchContext, substitution: object, expected: str) -> None:
    assert substitution.perform(context) == expected  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    "substitution",
    [NotSubstitution("maybe"), AndSubstitution("true", "x"), IfElseSubstitution("?", "a", "b")],
)
def test_what_is_neither_true_nor_false_is_a_failure(context: LaunchContext, substitution: object) -> None:
    with pytest.raises(SubstitutionFailure):
        substitution.perform(context)  # type: ignore[attr-defined]


def test_if_else_needs_a_value() -> None:
    with pytest.raises(RuntimeError, match="One of if_value and else_value must be specified"):
        IfElseSubstitution("true")


def test_a_files_content_is_read_when_performed(context: LaunchContext, tmp_path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("inside")
    assert FileContent(str(path)).perform(context) == "inside"
    with pytest.raises(SubstitutionFailure, match="Failed to read file"):
        FileContent(str(tmp_path / "b.txt")).perform(context)


def test_the_log_folder_lies_below_ros_log_dir(context: LaunchContext, tmp_path) -> None:
    assert LaunchLogDir().perform(context).startswith(str(tmp_path / "log"))


@posix("no folder there has quotes in its name")
def test_a_path_that_is_an_item_of_a_command_is_one_word_whatever_is_in_its_name(context, tmp_path):
    folder = tmp_path / HOSTILE
    folder.mkdir()
    (folder / "a b.txt").write_text("here", encoding="utf-8")
    whole = ["cat ", str(folder / "a b.txt")]
    bare, quoted = ["cat ", str(folder), "'/a b.txt'"], ['cat "', str(folder), '/a b.txt"']
    for command in (whole, bare, quoted):
        assert Command(command).perform(context) == "here"
    assert not list(tmp_path.glob("PWNED*"))


@posix("there is no sh, env, nor an end by a signal")
def test_a_command_whose_quotes_do_not_end_says_how_to_give_a_path(context):
    with pytest.raises(SubstitutionFailure, match=r"No closing quotation.*\n.*Command\(\['xacro ', path\]\)"):
        Command("xacro /home/it's/robot.urdf").perform(context)
