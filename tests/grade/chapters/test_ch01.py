"""What the checks of chapter 1 say of a type, of a way that is nearly right, and of commands that are refused."""

import pytest

from coursekit.grade.checking import judge_work
from coursekit.grade.command_advice import why_refused
from coursekit.grade.exercise import find
from coursekit.grade.plan import Seen
from tests.grade.tried import Tried, told_of

LOG = "rcl_interfaces/msg/Log"


def asked(kind):
    seen = Seen(outputs=[], topics={"/rosout": [LOG]}, publishers={"/rosout": [{"node": "/a"}, {"node": "/b"}]})
    work = Tried(seen)
    work.variables = {"rosout_type": kind, "rosout_publishers": 2}
    return judge_work(find("ch01.q1"), work, 2)


def test_spaces_around_a_type_do_not_count():
    assert asked(f" {LOG}\n").passed


@pytest.mark.parametrize(
    ("kind", "cause"), [(f"Type: {LOG}", "alone"), ("Log", "in full"), ("std_msgs/msg/String", "another topic's type")]
)
def test_what_is_wrong_with_a_type_is_told(kind, cause):
    assert cause in asked(kind).cause


@pytest.mark.parametrize(
    ("turn", "seconds", "cause"),
    [
        (0.785, 3.0, "drive for longer"),
        (1.358, 3.6, "45 degrees"),
        (0.2128, 3.6, "45 degrees"),
        (-0.785, 3.8, "positive turns go to the left"),
        (0.0, 1.0, "looks right at"),
    ],
)
def test_an_end_elsewhere_is_explained(tmp_path, turn, seconds, cause):
    moves = [(0.0, turn, 1.0), (1.5, 0.0, seconds)]
    assert cause in told_of("ch01.q2", {"moves": moves}, tmp_path).cause


@pytest.mark.parametrize("command", ["ros2 node list", "%ros2 node list", "! ros2 node list"])
def test_the_word_ros2_is_named_however_it_is_written(tmp_path, command):
    assert told_of("ch01.q3", {"commands": [command]}, tmp_path).expected == "command lines without the word ros2"


@pytest.mark.parametrize(
    ("pen", "expected", "cause"),
    [
        ("'{r: 255, width: 1}'", "a line of width 5", "has a field"),
        ("""'{r: 255, width: 5, "off": 1}'""", "turtle1 draws in red (255, 0, 0)", "`off` stays 0"),
        ("'{r: 255, width: 5, 'off': 0}'", "turtle1 draws in red (255, 0, 0)", "YAML reads off as false"),
        ("'{r: 255, width: 5, off: 0}'", "turtle1 draws in red (255, 0, 0)", "YAML reads off as false"),
        ("'{g: 255, width: 5}'", "turtle1 draws in red (255, 0, 0)", ""),
    ],
)
def test_of_a_pen_it_is_told_whether_it_is_thin_off_or_another_colour(tmp_path, pen, expected, cause):
    commands = [SPAWN + "'{x: 2.5, y: 3.5, name: bob}'", f"service call /turtle1/set_pen turtlesim/srv/SetPen {pen}"]
    said = told_of("ch01.q3", {"commands": commands}, tmp_path)
    assert said.expected == expected and cause in said.cause and bool(said.cause) == bool(cause)
    assert "(255, 255, 255)" not in said.got


SPAWN = "service call /spawn turtlesim/srv/Spawn "


@pytest.mark.parametrize(
    ("command", "cause"),
    [
        (SPAWN + "'{x:2.5, y:3.5, name:bob}'", "a space after each colon"),
        (SPAWN + "{x: 2.5, y: 3.5, name: bob}", "between quotes"),
        (SPAWN + "'{x: 2.5, y: 3.5, nam: bob}'", "ros2 interface show"),
        (SPAWN.replace("/Spawn", "/spawn") + "'{x: 2.5, y: 3.5, name: bob}'", "in full"),
        (SPAWN + "'{x: 2.5, y: 3.5, name: bob}' &", "without `&`"),
    ],
)
def test_of_a_command_that_is_refused_the_cure_is_told(tmp_path, command, cause):
    assert cause in told_of("ch01.q3", {"commands": [command]}, tmp_path).cause


PEN = "service call /turtle1/set_pen turtlesim/srv/SetPen "
BOB = SPAWN + "'{x: 2.5, y: 3.5, name: bob}'"


@pytest.mark.parametrize("spawn", [[], [BOB.replace("bob", "rob")]])
def test_a_refused_pen_does_not_explain_a_missing_turtle(tmp_path, spawn):
    said = told_of("ch01.q3", {"commands": [PEN + "'{red: 255}'", *spawn]}, tmp_path)
    assert said.expected == "a turtle named bob" and not said.cause and "set_pen" not in said.got


def test_a_refused_second_turtle_does_not_explain_a_pen(tmp_path):
    said = told_of("ch01.q3", {"commands": [SPAWN + "'{x:1.0}'", BOB]}, tmp_path)
    assert said.expected.startswith("turtle1 draws in red") and not said.cause and "said" not in said.got
    said = told_of("ch01.q3", {"commands": [SPAWN + "'{x:1.0}'", BOB, PEN + "'{red: 255}'"]}, tmp_path)
    assert "ros2 interface show" in said.cause and "has no attribute 'red'" in said.got


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("Failed to populate field: 'Twist' object has no attribute 'linaer'", True),
        ("Failed to populate message fields: AttributeError(\"'Fetch_Goal' object has no attribute 'box'\")", True),
        ("AttributeError: 'MyNode' object has no attribute 'pub'", False),
        ("AttributeError: 'MyNode' object has no attribute 'pub:x'", False),
    ],
)
def test_only_what_ros2_says_of_a_field_is_explained_by_interface_show(said, told):
    assert ("ros2 interface show" in why_refused(said)) == told and bool(why_refused(said)) == told


def test_a_turtle_elsewhere_needs_no_hint_about_services(tmp_path):
    said = told_of("ch01.q3", {"commands": [SPAWN + "'{x: 3.5, y: 2.5, name: bob}'"]}, tmp_path)
    assert said.got == "(3.50, 2.50)" and not said.hint
