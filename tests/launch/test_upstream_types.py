"""Numbers and text in launch files: what upstream's launch takes, and what it refuses."""

from __future__ import annotations

import io
import math
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, TimerAction
from launch.frontend import Parser
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch.utilities.type_utils import coerce_to_type, normalize_typed_substitution
from launch_ros.descriptions import ParameterValue
from launch_ros.utilities.to_parameters_list import to_parameters_list


def parse(text: str) -> LaunchDescription:
    root, parser = Parser.load(io.StringIO(text))
    return parser.parse_description(root)


@pytest.mark.parametrize(
    ("text", "value"), [("1e-3", 0.001), ("2E3", 2000.0), ("inf", math.inf), (" 5 ", 5.0), ("-.5", -0.5)]
)
def test_a_number_with_a_fraction_is_written_as_in_python(context: LaunchContext, text: str, value: float) -> None:
    assert coerce_to_type(text, float) == value
    assert ParameterValue(TextSubstitution(text=text), value_type=float).evaluate(context) == value


def test_a_whole_number_is_decimal_whatever_it_begins_with() -> None:
    assert coerce_to_type("010", int) == 10
    with pytest.raises(ValueError, match="0x10"):
        coerce_to_type("0x10", int)


@pytest.mark.parametrize("text", ["@home", "''1''", "[1, 2", "%d"])
def test_text_that_is_no_yaml_stays_text_where_text_is_allowed(text: str) -> None:
    assert coerce_to_type(text, None, can_be_str=True) == text
    with pytest.raises(ValueError):
        coerce_to_type(text)


@pytest.mark.parametrize(("value", "kind"), [(5, float), ("5", float), ("true", bool), ("5", int)])
def test_a_value_of_another_type_is_refused(value: Any, kind: type) -> None:
    with pytest.raises(TypeError, match="expected"):
        normalize_typed_substitution(value, kind)


def test_a_whole_number_is_no_period_and_the_message_says_what_is() -> None:
    with pytest.raises(TypeError, match=r"write 5\.0"):
        TimerAction(period=5, actions=[])
    with pytest.raises(TypeError, match=r"write 5\.0"):
        ParameterValue(5, value_type=float)
    with pytest.raises(Exception, match=r"write 5\.0"):
        parse("launch:\n- timer:\n    period: 5\n    children: []\n")


def test_a_period_may_be_a_text_but_that_is_deprecated() -> None:
    with pytest.warns(UserWarning, match="deprecated"):
        assert TimerAction(period="1.5", actions=[]).period == 1.5


def test_a_period_may_come_from_an_argument(launch) -> None:
    argument = DeclareLaunchArgument("wait", default_value="1e-1")
    assert launch([argument, TimerAction(period=LaunchConfiguration("wait"), actions=[])]).code == 0


def test_a_parameter_in_xml_may_be_text_that_is_no_yaml(context: LaunchContext) -> None:
    node = parse('<launch><node pkg="a" exec="b"><param name="place" value="@home"/></node></launch>').entities[0]
    ((_, value),) = node._Node__parameters[0].items()
    assert value.evaluate(context) == "@home"


def test_a_component_whose_parameter_file_is_wrong_is_told_the_file(context: LaunchContext, tmp_path: Path) -> None:
    file = tmp_path / "wrong.yaml"
    file.write_text("/***:\n  ros__parameters:\n    speed: 1\n")
    with pytest.raises(RuntimeError, match=r"invalid yaml file .*wrong\.yaml"):
        to_parameters_list(context, "node", "/", (file,))
