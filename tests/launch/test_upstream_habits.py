"""What programs and their tests expect of launch beyond launch files: types, arguments, locals, signals."""

from __future__ import annotations

import asyncio
import io
import signal
from pathlib import Path
from typing import Any, List  # noqa: UP035
from unittest.mock import patch
from xml.etree import ElementTree

import pytest
from launch import LaunchContext, LaunchDescription, LaunchDescriptionEntity, LaunchDescriptionSource
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo, SetLaunchConfiguration
from launch.descriptions import Executable
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO
from launch.frontend import Parser
from launch.frontend.parse_substitution import parse_substitution
from launch.launch_description_sources import load_python_launch_file_as_module
from launch.substitutions import AnonName, Command, PythonExpression, SubstitutionFailure, TextSubstitution
from launch.utilities import AsyncSafeSignalManager, is_a_subclass, visit_all_entities_and_collect_futures
from launch.utilities.type_utils import (
    coerce_list,
    coerce_to_type,
    extract_type,
    get_typed_value,
    is_instance_of,
    is_normalized_substitution,
    is_valid_scalar_type,
    normalize_typed_substitution,
    perform_typed_substitution,
)
from launch_xml import Entity as XmlEntity

from tests.needs import posix


def text(words: str) -> TextSubstitution:
    return TextSubstitution(text=words)


def test_a_list_without_items_type_is_no_type() -> None:
    with pytest.raises(ValueError, match="Unrecognized data type"):
        extract_type(List)  # noqa: UP006
    assert is_valid_scalar_type(bool) and not is_valid_scalar_type(list[bool])


@pytest.mark.parametrize("value", [[1, "2"], [True, "x"], ["a", 2.0]])
def test_text_may_stand_in_a_list_only_where_it_is_allowed(value: list[Any]) -> None:
    assert is_instance_of(value, None, True) and not is_instance_of(value, None)


@pytest.mark.parametrize("value", ["{1}", "''1''", "[1, 2.0]", "[a, 1]", "{a: b}"])
def test_what_is_no_scalar_and_no_uniform_list_is_refused(value: str) -> None:
    with pytest.raises(ValueError):
        coerce_to_type(value)


def test_only_text_is_coerced_and_only_to_what_fits() -> None:
    assert coerce_list(["1000.", "1000"], float) == [1000.0, 1000.0]
    assert coerce_list(["a", "1"], None, True) == ["a", 1]
    for wrong in (lambda: coerce_to_type([1]), lambda: coerce_list("a"), lambda: coerce_list([1])):
        with pytest.raises(TypeError):
            wrong()
    with pytest.raises(ValueError, match="several types"):
        coerce_list(["1", "1.5"])
    with pytest.raises(TypeError, match="one int"):
        get_typed_value(["1", "2"], int)


def test_each_item_of_a_list_may_be_a_substitution() -> None:
    normalized = normalize_typed_substitution([text("b"), 2], list[int])
    assert is_normalized_substitution(normalized[0]) and normalized[1] == 2
    assert len(normalize_typed_substitution([text("a"), "b"], None)) == 2
    with pytest.raises(TypeError):
        normalize_typed_substitution(["a", 2], list[int])
    with pytest.raises(TypeError):
        perform_typed_substitution(LaunchContext(), 1.0, int)


def test_an_unknown_name_in_an_expression_is_a_name_error_too(context: LaunchContext) -> None:
    expression = PythonExpression(["ceil(1.6)"], [])
    with pytest.raises(NameError):
        expression.perform(context)
    assert expression.describe() == "PythonExpr('ceil(1.6)', [])"
    assert PythonExpression(["sys.maxsize > 0"], ["sys"]).perform(context) == "True"
    assert PythonExpression(["maxsize > 0"], ["sys"]).perform(context) == "True"


def test_quotes_inside_quotes_are_characters(context: LaunchContext) -> None:
    (substitution,) = parse_substitution("""$(env "a_$(env 'b' )" 'c')""")
    assert substitution.name[1].name[0].perform(context) == "'b'"
    with pytest.raises(ValueError, match="is not closed"):
        parse_substitution('$(env "$(env a" b)')


def test_a_missing_program_is_told_as_the_system_tells_it(context: LaunchContext) -> None:
    with pytest.raises(SubstitutionFailure, match=r"file not found: \[Errno 2\] .*'no_such_program'"):
        Command("no_such_program -x").perform(context)


def test_an_anonymous_name_ends_with_two_numbers(context: LaunchContext) -> None:
    name, *numbers = AnonName("foo").perform(context).rsplit("_", 2)
    assert name == "foo" and all(number.isdigit() for number in numbers)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: OnProcessExit(target_action=5, on_exit=LogInfo(msg="")),
        lambda: OnProcessIO(target_action="x"),
        lambda: OnProcessExit(on_exit=5),
        lambda: OnExecutionComplete(on_completion="neither action nor function"),
    ],
)
def test_handlers_check_what_they_are_given(wrong: Any) -> None:
    with pytest.raises(TypeError):
        wrong()
    with pytest.raises(ValueError):
        wrong()


def test_an_include_gives_its_description_and_says_where_it_lies(context: LaunchContext, tmp_path: Path) -> None:
    description = LaunchDescription()
    source = LaunchDescriptionSource(description, str(tmp_path / "a.launch.py"))
    include = IncludeLaunchDescription(source, launch_arguments=[("a", "b")])
    setting, inner = include.visit(context) or []
    assert isinstance(setting, SetLaunchConfiguration) and inner is description
    assert context.locals.current_launch_file_directory == str(tmp_path)
    include.leave(context)
    assert context.get_locals_as_dict()["current_launch_file_directory"] is None
    IncludeLaunchDescription(LaunchDescriptionSource(description, "<script>")).visit(context)
    assert context.locals.current_launch_file_directory == "<script>"


@posix("it knows no SIGUSR1, and every path has a drive")
def test_the_including_files_place_is_known_again_after_the_include(context: LaunchContext, tmp_path: Path) -> None:
    seen = []

    class Look(LaunchDescriptionEntity):
        def visit(self, context: LaunchContext) -> None:
            seen.append(context.locals.current_launch_file_path)

    def including(path: str, *entities: LaunchDescriptionEntity) -> IncludeLaunchDescription:
        return IncludeLaunchDescription(LaunchDescriptionSource(LaunchDescription(entities), path))

    inner = including("/inner.py", Look())
    visit_all_entities_and_collect_futures(including("/outer.py", Look(), inner, Look()), context)
    assert seen == ["/outer.py", "/inner.py", "/outer.py"]


def test_a_required_argument_is_not_taken_from_the_including_file(launch) -> None:
    needy = LaunchDescription([DeclareLaunchArgument("foo")])
    include = IncludeLaunchDescription(LaunchDescriptionSource(needy))
    result = launch([SetLaunchConfiguration("foo", "FOO"), include])
    assert result.code == 1 and "missing required argument 'foo'" in result.text


@pytest.mark.parametrize("error", [ValueError, TypeError, AttributeError, RuntimeError])
def test_an_element_that_is_wrong_is_caught_as_any_error_of_a_value(error: type[Exception]) -> None:
    root, parser = Parser.load(io.StringIO('<launch><arg name="a" colour="red"/></launch>'))
    with pytest.raises(error, match="colour"):
        parser.parse_description(root)


def test_elements_of_the_standard_library_can_be_read() -> None:
    (child,) = XmlEntity(ElementTree.fromstring('<launch><tag attr="[1, 2]"/></launch>')).children
    assert child.get_attr("attr", data_type=list[int]) == [1, 2]


def test_a_yaml_group_keeps_configurations(context: LaunchContext) -> None:
    source = "launch: [{group: {forwarding: false, keep: [{name: a, value: b}], children: [{log: {message: hi}}]}}]"
    root, parser = Parser.load(io.StringIO(source))
    (group,) = parser.parse_description(root).entities
    context.launch_configurations["c"] = "d"
    for entity in group.execute(context)[:4]:
        entity.visit(context)
    assert dict(context.launch_configurations) == {"a": "b"}


@pytest.mark.parametrize(
    ("method", "group"),
    [
        ("load_launch_extensions", "launch.frontend.launch_extension"),
        ("load_parser_implementations", "launch.frontend.parser"),
    ],
)
def test_an_installed_extension_that_fails_is_told_and_left_out(method: str, group: str) -> None:
    class Broken:
        name = "Broken"

        def load(self) -> None:
            raise ValueError("no")

    class Fresh(Parser):
        extensions_loaded = False
        frontend_parsers = None

    entry_points = patch("importlib.metadata.entry_points", return_value={group: [Broken()]})
    with entry_points, pytest.warns(UserWarning, match="Failed to load .* Broken"):
        getattr(Fresh, method)()


@posix("it knows no SIGUSR1, and every path has a drive")
def test_signals_reach_their_handlers_only_while_the_manager_is_entered() -> None:
    outside: list[int] = []
    before = signal.signal(signal.SIGUSR1, lambda number, frame: outside.append(number))
    loop, inside = asyncio.new_event_loop(), []
    manager = AsyncSafeSignalManager(loop)
    manager.handle(signal.SIGUSR1, inside.append)

    async def raise_it() -> None:
        signal.raise_signal(signal.SIGUSR1)
        await asyncio.sleep(0)

    try:
        loop.run_until_complete(raise_it())
        with manager:
            loop.run_until_complete(raise_it())
            assert manager.handle(signal.SIGUSR1, None) == inside.append
            loop.run_until_complete(raise_it())
    finally:
        signal.signal(signal.SIGUSR1, before)
        loop.close()
    assert (inside, outside) == ([signal.SIGUSR1], [signal.SIGUSR1] * 2)


def test_small_things_that_tests_ask_for(tmp_path: Path) -> None:
    assert Executable(cmd=["ls"], arguments=["-l"]).arguments == ["-l"] and is_a_subclass(bool, int)
    (tmp_path / "a.launch.py").write_text("answer = 42")
    assert load_python_launch_file_as_module(tmp_path / "a.launch.py").answer == 42
