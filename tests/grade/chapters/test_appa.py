"""What the checks of appendix A say of another exercise's command, and of one that ends with an error."""

import pytest

from coursekit.grade.checking import judge
from coursekit.grade.exercise import find


def verdict(name, command, tmp_path):
    return judge(find(name), {"command": command}, tmp_path, 2)


@pytest.mark.parametrize(
    ("name", "command", "number"),
    [("appa.q1", "topic  pub -r 4 /turtle1/cmd_vel geometry_msgs/msg/Twist", 2), ("appa.q2", "topic echo /turtle1/pose", 1)],
)
def test_the_other_exercise_s_command_is_told_as_such(name, command, number, tmp_path):
    said = verdict(name, command, tmp_path)
    assert said.cause == f"That looks like exercise {number}'s: run the cell above this check again."
    assert said.gave == repr(command) and not said.hint


def test_of_a_command_that_ends_with_an_error_its_words_are_shown(tmp_path):
    said = verdict("appa.q1", "topic echo /turtle1/pos --field x --once", tmp_path)
    assert said.expected == "a command that ends without an error" and "/turtle1/pos" in said.got and not said.cause


def test_of_a_command_that_does_not_end_the_option_is_asked_for(tmp_path):
    assert verdict("appa.q1", "topic echo /turtle1/pose", tmp_path).cause == "Is there an option for just one message?"


TWIST = "topic pub -r 4 /turtle1/cmd_vel geometry_msgs/msg/Twist "


@pytest.mark.parametrize(
    ("command", "cause"),
    [
        (TWIST + "'{linear: {x:1.5}, angular: {z:-0.75}}'", "a space after each colon"),
        (TWIST + "'{linear: 1.5, angular: -0.75}'", "braces of its own"),
        (TWIST + "'{linear: {x: 1.5}, angular: {z: -0.75}'", "closing brace"),
        (TWIST.replace("geometry_msgs/msg/", "") + "'{linear: {x: 1.5}}'", "in full"),
        (TWIST.replace("/turtle1", "") + "'{linear: {x: 1.5}, angular: {z: -0.75}}'", "Which topic?"),
        (TWIST + "'{linear: {x: 1.5}, angular: {z: -43.0}}'", "radians"),
    ],
)
def test_of_velocities_that_do_not_come_the_cause_is_told(tmp_path, command, cause):
    assert cause in verdict("appa.q2", command, tmp_path).cause
