"""Appendix A: command lines that query, act and measure."""

from __future__ import annotations

import math
import re
from itertools import pairwise

from coursekit.grade.command_advice import has_word_ros2, why_refused
from coursekit.grade.exercise import exercise
from coursekit.grade.outputs import exit_code, heard, said, way_of, wrote
from coursekit.grade.plain import fields, near, shown, texts
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

TURTLESIM = "run turtlesim turtlesim_node"
CMD_VEL, POSE, TWIST = "/turtle1/cmd_vel", "/turtle1/pose", "geometry_msgs/msg/Twist"
CTRL_C = 2
"""The exit status of a command ended by Ctrl-C."""
BROKEN = {
    "there is no node /turtlesim (this one is called /mule)": "-r __node:=mule",
    "/spawn is not served (here it is /hatch)": "-r spawn:=hatch",
}
"""Scenes in which something is missing, and the arguments of turtlesim for them."""


@exercise(
    "appa.q1",
    "Where is it?",
    points=1,
    hints=("Which verb of `ros2 topic` shows messages?", "`ros2 topic echo -h` lists what it can leave out."),
)
def where(work: Work) -> None:
    """Check that a command that ends prints one number, the turtle's x."""
    command = _command(work.value("command", str), "command")
    _of_this_exercise(command, "topic pub", 2)
    chance = work.dice("appa.q1")
    twist = {"linear": {"x": chance.uniform(1.5, 3.0)}, "angular": {"z": chance.choice((-1, 1)) * chance.uniform(0.5, 0.9)}}
    drive = (0.5, CMD_VEL, TWIST, twist)
    seen = work.try_out(beside=[TURTLESIM], seconds=4.0, publish=[drive], record=[POSE], later=[(3.0, command)])
    output, x = said(seen), way_of(seen, POSE)[-1][0]
    _understood(command, output)
    lines = [line for line in output.splitlines() if line.strip() and line.strip() != "---"]
    if exit_code(seen) not in (0, None, CTRL_C):
        raise Wrong("a command that ends without an error", wrote(seen), gave=shown(command), hint=NO_HINT)
    if len(lines) > 20 or exit_code(seen) != 0:
        raise Wrong(
            "a command that ends by itself, without an error",
            f"after a second it had printed {len(lines)} lines and ended with {exit_code(seen)}",
            "Is there an option for just one message?",
            hint=1,
        )
    if len(lines) != 1:
        got = f"{len(lines)} lines: {shown(output.strip())}"
        raise Wrong("one line with one number", got, "Show one field only.", hint=1)
    if not _close(lines[0], x):
        raise Wrong(f"the x of the pose, {x:.3f}", lines[0][:80], "Which field is printed, of which topic?", hint=0)


@exercise(
    "appa.q2",
    "Round and round",
    points=2,
    hints=(
        "`ros2 topic pub -h` lists the option for the rate.",
        "Counter-clockwise is positive. Mind the quotes around the braces.",
    ),
)
def drive_on(work: Work) -> None:
    """Check for a stream of velocities to the right, four times a second."""
    command = _command(work.value("command", str), "command")
    _of_this_exercise(command, "topic echo", 1)
    seen = work.try_out(beside=[TURTLESIM], seconds=5.0, record=[CMD_VEL], later=[(1.0, command)])
    _understood(command, said(seen))
    spoken = heard(seen, CMD_VEL)
    if not spoken:
        cause = why_refused(said(seen)) or "Which topic?"
        raise Wrong(f"velocities on {CMD_VEL}", f"none; it said {shown(said(seen).strip())}", cause)
    speeds = {fields(message, ("linear.x", "angular.z"), CMD_VEL) for _, message in spoken}
    for forward, turn in sorted(speeds):
        if not near(forward, 1.5, 1e-6) or not near(abs(turn), 0.75, 1e-6):
            got, many = f"linear.x = {forward}, angular.z = {turn}", abs(turn) > math.tau
            cause = "Turns are in radians a second, not in degrees." if many else "Which fields are forward and turn?"
            raise Wrong("1.5 m/s forward and 0.75 rad/s of turn", got, cause, hint=NO_HINT)
    gaps = [after - before for (before, _), (after, _) in pairwise(spoken)]
    if len(gaps) < 8 or not all(near(gap, 0.25, 0.01) for gap in gaps):
        raise Wrong(
            "a message every 0.25 s until Ctrl-C",
            f"{len(spoken)} in four seconds" + (f", {gaps[-1]:.2f} s apart" if gaps else ""),
            "Without an option it is one a second.",
            share=0.5,
            hint=0,
        )
    if not all(turn < 0 for _, turn in speeds):
        raise Wrong("a turn to the right", "angular.z = 0.75", "Positive turns go to the left.", share=0.5, hint=1)


@exercise(
    "appa.q3",
    "Prove it",
    points=2,
    hints=(
        "Which commands need the running node to answer, and which only read files?",
        "`ros2 node`, `ros2 service` and `ros2 topic` ask the graph; `hz` measures.",
    ),
)
def prove(work: Work) -> None:
    """Check that the rate is measured, and that outputs differ if the node or its service is missing."""
    commands = work.value("commands", list)
    if len(commands) != 3:
        raise Wrong("a list of three texts", gave=shown(commands), hint=NO_HINT)
    commands = texts(commands, "a list of three texts")
    commands = [_command(given, "commands") for given in commands]
    well = _answers(work, commands, "")
    for command, output in zip(commands, well, strict=True):
        _understood(command, output)
    rates = [float(rate) for rate in re.findall(r"average rate: ([0-9.]+)", "\n".join(well))]
    if not any(60 < rate < 65 for rate in rates):
        raise Wrong("a measured rate of about 62 Hz", f"rates: {rates or 'none'}", "Which verb measures?", share=0.25)
    for fault, option in BROKEN.items():
        if _answers(work, commands, option) == well:
            raise Wrong(
                f"other answers in a scene where {fault}",
                "the same three as when all is well",
                "A file is the same whether the node runs or not, and a number may stay the same by chance.",
                share=0.5,
            )


def _answers(work: Work, commands: list[str], option: str) -> list[str]:
    scene = f"{TURTLESIM} --ros-args {option}" if option else TURTLESIM
    later = [(1.0 + place, command) for place, command in enumerate(commands)]
    return work.try_out(beside=[scene], seconds=6.0, later=later).outputs


def _command(text: str, variable: str) -> str:
    words = text.split()
    if has_word_ros2(text):
        raise Wrong(f"`{variable}` without the word ros2", gave=shown(text), hint=NO_HINT)
    if not words or words == ["..."]:
        raise Wrong(f"a command line in `{variable}`", gave=shown(text), hint=NO_HINT)
    return text


def _of_this_exercise(command: str, other: str, number: int) -> None:
    """Raise Wrong if `command` is still that of the other exercise: both use the same name."""
    if " ".join(command.split()).startswith(other):
        cause = f"That looks like exercise {number}'s: run the cell above this check again."
        raise Wrong("the `command` of this exercise", gave=shown(command), cause=cause, hint=NO_HINT)


def _understood(command: str, said: str) -> None:
    if said.startswith("usage:"):
        last = said.strip().splitlines()[-1][:160]
        raise Wrong("a command that ros2 knows", last, why_refused(said), gave=shown(command), hint=NO_HINT)


def _close(text: str, x: float) -> bool:
    try:
        return near(float(text), x, 0.01)
    except ValueError:
        return False
