from __future__ import annotations

import pytest
from launch import LaunchContext
from launch.conditions import (
    IfCondition,
    InvalidConditionExpressionError,
    LaunchConfigurationEquals,
    LaunchConfigurationNotEquals,
    UnlessCondition,
)
from launch.substitutions import LaunchConfiguration


@pytest.mark.parametrize(
    ("text", "truth"),
    [
        ("true", True),
        ("True", True),
        ("TRUE", True),
        (" 1 ", True),
        ("\ttrue\n", True),
        ("false", False),
        ("False", False),
        ("0", False),
        (" fAlse ", False),
    ],
)
def test_only_true_1_false_and_0_are_understood(context: LaunchContext, text: str, truth: bool) -> None:
    assert IfCondition(text).evaluate(context) is truth
    assert UnlessCondition(text).evaluate(context) is not truth


@pytest.mark.parametrize("text", ["", "yes", "on", "2", "tru", "None"])
def test_everything_else_is_an_error(context: LaunchContext, text: str) -> None:
    for condition in (IfCondition(text), UnlessCondition(text)):
        with pytest.raises(InvalidConditionExpressionError, match="invalid condition expression"):
            condition.evaluate(context)


def test_conditions_remember_their_last_answer(context: LaunchContext) -> None:
    condition = IfCondition(["tr", LaunchConfiguration("rest")])
    assert condition.last_result is None
    context.launch_configurations["rest"] = "ue"
    condition.evaluate(context)
    assert condition.last_result is True


def test_configurations_are_compared_with_text_and_with_nothing(context: LaunchContext) -> None:
    context.launch_configurations["a"] = "x"
    assert LaunchConfigurationEquals("a", "x").evaluate(context)
    assert LaunchConfigurationEquals("b", None).evaluate(context)
    assert not LaunchConfigurationEquals("b", "x").evaluate(context)
    assert LaunchConfigurationNotEquals("a", "y").evaluate(context)
    assert LaunchConfigurationNotEquals("a", None).evaluate(context)
    assert not LaunchConfigurationNotEquals("b", None).evaluate(context)
