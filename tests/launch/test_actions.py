from __future__ import annotations

import os

import pytest
from launch import LaunchContext, LaunchDescription
from launch.actions import (
    AppendEnvironmentVariable,
    DeclareLaunchArgument,
    GroupAction,
    IncludeLaunchDescription,
    LogInfo,
    OpaqueFunction,
    PopEnvironment,
    PopLaunchConfigurations,
    PushEnvironment,
    PushLaunchConfigurations,
    ResetEnvironment,
    ResetLaunchConfigurations,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    UnsetEnvironmentVariable,
    UnsetLaunchConfiguration,
)
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import EnvironmentVariable, LaunchConfiguration, PythonExpression
from launch.utilities import visit_all_entities_and_collect_futures

USER = "[INFO] [launch.user]: "


def visit(context: LaunchContext, *entities: object) -> LaunchContext:
    for entity in entities:
        visit_all_entities_and_collect_futures(entity, context)  # type: ignore[arg-type]
    return context


def test_a_default_is_set_only_where_nothing_was_given(context: LaunchContext) -> None:
    context.launch_configurations["given"] = "mine"
    visit(
        context,
        DeclareLaunchArgument("given", default_value="x"),
        DeclareLaunchArgument("other", default_value=[LaunchConfiguration("given"), "!"]),
    )
    assert context.launch_configurations == {"given": "mine", "other": "mine!"}


def test_a_missing_argument_is_a_runtime_error_that_names_it(context: LaunchContext) -> None:
    with pytest.raises(RuntimeError, match=r"Required launch argument 'speed' \(description: 'in m/s'\)"):
        visit(context, DeclareLaunchArgument("speed", description="in m/s"))


def test_only_the_choices_may_be_given(context: LaunchContext) -> None:
    argument = DeclareLaunchArgument("mode", choices=["slow", "fast"], description="How fast")
    assert argument.description == "How fast. Valid choices are: ['slow', 'fast']"
    context.launch_configurations["mode"] = "warp"
    with pytest.raises(
        RuntimeError, match=r'Argument "mode" provided value "warp" is not valid. Valid options are'
    ):
        visit(context, argument)
    with pytest.raises(ValueError, match='Provided default_value "warp" is not in provided choices'):
        DeclareLaunchArgument("mode", default_value="warp", choices=["slow"])
    with pytest.raises(ValueError, match="empty"):
        DeclareLaunchArgument("mode", choices=[])


def test_configurations_are_set_unset_pushed_popped_and_reset(context: LaunchContext) -> None:
    visit(
        context,
        SetLaunchConfiguration("a", "1"),
        SetLaunchConfiguration(["b", "c"], LaunchConfiguration("a")),
    )
    assert context.launch_configurations == {"a": "1", "bc": "1"}
    visit(
        context,
        PushLaunchConfigurations(),
        UnsetLaunchConfiguration("a"),
        UnsetLaunchConfiguration("never set"),
    )
    assert context.launch_configurations == {"bc": "1"}
    visit(context, ResetLaunchConfigurations({"kept": LaunchConfiguration("bc")}))
    assert context.launch_configurations == {"kept": "1"}
    visit(context, PopLaunchConfigurations())
    assert context.launch_configurations == {"a": "1", "bc": "1"}
    with pytest.raises(RuntimeError, match="stack unexpectedly empty"):
        visit(context, PopLaunchConfigurations())


def test_the_environment_is_set_unset_pushed_popped_and_reset(
    context: LaunchContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("LAUNCH_TEST", raising=False)
    visit(context, PushEnvironment(), SetEnvironmentVariable("LAUNCH_TEST", "a"))
    assert os.environ["LAUNCH_TEST"] == "a"
    visit(
        context,
        AppendEnvironmentVariable("LAUNCH_TEST", "b"),
        AppendEnvironmentVariable("LAUNCH_TEST", "c", prepend=True, separator=";"),
    )
    assert os.environ["LAUNCH_TEST"] == f"c;a{os.pathsep}b"
    visit(context, UnsetEnvironmentVariable("LAUNCH_TEST"), UnsetEnvironmentVariable("LAUNCH_TEST"))
    assert "LAUNCH_TEST" not in os.environ
    visit(context, AppendEnvironmentVariable("LAUNCH_TEST", "new"))
    assert os.environ["LAUNCH_TEST"] == "new"
    visit(context, ResetEnvironment())
    assert "LAUNCH_TEST" not in os.environ
    visit(context, SetEnvironmentVariable("LAUNCH_TEST", "x"), PopEnvironment())
    assert "LAUNCH_TEST" not in os.environ
    with pytest.raises(RuntimeError, match="stack unexpectedly empty"):
        visit(context, PopEnvironment())


def test_a_group_keeps_what_it_sets_inside(context: LaunchContext, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("LAUNCH_TEST", raising=False)
    seen: list[dict[str, str]] = []
    look = OpaqueFunction(function=lambda where: seen.append(dict(where.launch_configurations)))
    context.launch_configurations["outer"] = "1"
    visit(
        context,
        GroupAction(
            [SetLaunchConfiguration("inner", "2"), SetEnvironmentVariable("LAUNCH_TEST", "x"), look],
            launch_configurations={"own": LaunchConfiguration("outer")},
        ),
    )
    assert seen == [{"outer": "1", "own": "1", "inner": "2"}]
    assert context.launch_configurations == {"outer": "1"}
    assert "LAUNCH_TEST" not in os.environ


def test_a_group_without_forwarding_sees_only_its_own_configurations(context: LaunchContext) -> None:
    seen: list[dict[str, str]] = []
    context.launch_configurations.update({"outer": "1", "other": "2"})
    visit(
        context,
        GroupAction(
            [OpaqueFunction(function=lambda where: seen.append(dict(where.launch_configurations)))],
            forwarding=False,
            launch_configurations={"own": LaunchConfiguration("outer")},
        ),
    )
    assert seen == [{"own": "1"}]
    assert context.launch_configurations == {"outer": "1", "other": "2"}


def test_a_group_without_scope_leaves_what_it_sets(context: LaunchContext) -> None:
    visit(
        context,
        GroupAction([SetLaunchConfiguration("a", "1")], scoped=False, launch_configurations={"b": "2"}),
    )
    assert context.launch_configurations == {"a": "1", "b": "2"}


def test_conditions_decide_whether_an_action_is_carried_out(context: LaunchContext) -> None:
    visit(
        context,
        SetLaunchConfiguration("a", "1", condition=IfCondition("true")),
        SetLaunchConfiguration("b", "1", condition=IfCondition("false")),
        SetLaunchConfiguration("c", "1", condition=UnlessCondition("false")),
    )
    assert context.launch_configurations == {"a": "1", "c": "1"}


def test_messages_are_logged_in_the_users_name(launch) -> None:
    result = launch([SetLaunchConfiguration("a", "b"), LogInfo(msg=["a is ", LaunchConfiguration("a")])])
    assert (result.code, result.lines) == (0, [USER + "a is b"])


def test_included_arguments_are_checked_before_anything_starts(launch) -> None:
    inner = LaunchDescription([LogInfo(msg="not reached"), DeclareLaunchArgument("need", description="it")])
    result = launch([IncludeLaunchDescription(inner, launch_arguments=[("other", "1")])])
    assert result.code == 1
    assert result.lines == [
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): Included launch description "
        "missing required argument 'need' (description: 'it'), given: [other]"
    ]


def test_what_an_include_sets_stays_unless_a_group_is_around_it(launch) -> None:
    inner = LaunchDescription(
        [DeclareLaunchArgument("a", default_value="?"), LogInfo(msg=LaunchConfiguration("a"))]
    )
    show = LogInfo(msg=["outside: ", LaunchConfiguration("a", default="nothing")])
    arguments = {"a": "1"}.items()
    grouped = launch([GroupAction([IncludeLaunchDescription(inner, launch_arguments=arguments)]), show])
    assert grouped.lines == [USER + "1", USER + "outside: nothing"]
    plain = launch([IncludeLaunchDescription(inner, launch_arguments=arguments), show])
    assert plain.lines == [USER + "1", USER + "outside: 1"]


def test_an_exception_in_an_action_is_told_and_gives_1(launch) -> None:
    result = launch([LogInfo(msg=PythonExpression("1 / 0")), LogInfo(msg="not reached")])
    assert result.code == 1
    assert len(result.lines) == 1
    assert "Caught exception in launch (see debug for traceback): failed to evaluate" in result.text


def test_the_environment_of_a_launch_does_not_leak_out_of_its_process(launch) -> None:
    result = launch([SetEnvironmentVariable("LEAK", "x"), LogInfo(msg=EnvironmentVariable("LEAK"))])
    assert result.lines == [USER + "x"]
    assert "LEAK" not in os.environ
