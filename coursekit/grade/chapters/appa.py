"""Appendix A: command lines that ask, that do, and that prove."""

from __future__ import annotations

import re
from itertools import pairwise

from coursekit.grade.exercise import exercise
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

TURTLESIM = "run turtlesim turtlesim_node"
CMD_VEL, POSE, TWIST = "/turtle1/cmd_vel", "/turtle1/pose", "geometry_msgs/msg/Twist"
BROKEN = {
    "there is no node /turtlesim (this one is called /mule)": "-r __node:=mule",
    "/spawn is not served (here it is /hatch)": "-r spawn:=hatch",
}
"""Scenes in which something is missing, and how turtlesim is started for them."""


@exercise(
    "appa.q1",
    "Where is it?",
    points=1,
    hints=("Which verb of `ros2 topic` shows messages?", "`ros2 topic echo -h` lists what it can leave out."),
)
def where(work: Work) -> None:
    """One number, the x at which the turtle stands, from a command that ends."""
    command = _command(work.value("command", str), "command")
    drive = (0.5, CMD_VEL, TWIST, {"linear": {"x": 2.0}, "angular": {"z": 0.6}})
    seen = work.try_out(TURTLESIM, seconds=4.0, publish=[drive], record=[POSE], later=[(3.0, command)])
    code, said = seen.exit_codes[1], seen.outputs[1]
    _understood(command, said)
    lines = [line for line in said.splitlines() if line.strip() and line.strip() != "---"]
    pose = seen.messages[POSE][-1][1]
    if len(lines) > 20 or code:
        raise Wrong(
            "a command that ends by itself, without an error",
            f"after a second it had printed {len(lines)} lines and ended with {code}",
            "Is there an option for just one message?",
        )
    if len(lines) != 1:
        raise Wrong("one line with one number", f"{len(lines)} lines: {said.strip()[:80]!r}", "Show one field only.")
    if not _close(lines[0], pose["x"]):
        raise Wrong(f"the x of the pose, {pose['x']:.3f}", lines[0], "Which field is printed, of which topic?")


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
    """A stream of velocities, four times a second, to the right."""
    command = _command(work.value("command", str), "command")
    seen = work.try_out(TURTLESIM, seconds=5.0, record=[CMD_VEL], later=[(1.0, command)])
    _understood(command, seen.outputs[1])
    heard = seen.messages.get(CMD_VEL, [])
    if not heard:
        raise Wrong(f"velocities on {CMD_VEL}", f"none; it said {seen.outputs[1].strip()[:120]!r}", "Which topic?")
    last = heard[-1][1]
    forward, turn = last["linear"]["x"], last["angular"]["z"]
    if abs(forward - 1.5) > 1e-6 or abs(abs(turn) - 0.75) > 1e-6:
        raise Wrong("1.5 m/s forward and 0.75 rad/s of turn", f"linear.x = {forward}, angular.z = {turn}")
    gaps = [after - before for (before, _), (after, _) in pairwise(heard)]
    if len(gaps) < 8 or any(abs(gap - 0.25) > 0.01 for gap in gaps):
        raise Wrong(
            "a message every 0.25 s until Ctrl-C",
            f"{len(heard)} in four seconds" + (f", {gaps[-1]:.2f} s apart" if gaps else ""),
            "Without an option it is one a second.",
            share=0.5,
        )
    if turn > 0:
        raise Wrong("a turn to the right", f"angular.z = {turn}", "Positive turns go to the left.", share=0.5)


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
    """The rate is measured, and what is said differs where the node or its service is missing."""
    commands = work.value("commands", list)
    if len(commands) != 3 or not all(isinstance(one, str) for one in commands):
        raise Wrong("a list of three texts", repr(commands)[:120])
    commands = [_command(one, "commands") for one in commands]
    well = _answers(work, commands, "")
    for command, said in zip(commands, well, strict=True):
        _understood(command, said)
    rates = [float(one) for one in re.findall(r"average rate: ([0-9.]+)", "\n".join(well))]
    if not any(60 < rate < 65 for rate in rates):
        raise Wrong("a measured rate of about 62 Hz", f"rates: {rates or 'none'}", "Which verb measures?", share=0.25)
    for fault, option in BROKEN.items():
        if _answers(work, commands, option) == well:
            raise Wrong(
                f"other answers in a scene where {fault}",
                "the same three as when all is well",
                "A file says the same whether the node runs or not, and a number may stay the same by chance.",
                share=0.5,
            )


def _answers(work: Work, commands: list[str], option: str) -> list[str]:
    scene = f"{TURTLESIM} --ros-args {option}" if option else TURTLESIM
    later = [(1.0 + place, command) for place, command in enumerate(commands)]
    return work.try_out(scene, seconds=6.0, later=later).outputs[1:]


def _command(text: str, variable: str) -> str:
    words = text.replace("%", " ").split()
    if words[:1] == ["ros2"] or text.lstrip().startswith("%"):
        raise Wrong(f"`{variable}` without the word ros2", text[:120])
    if not words or words == ["..."]:
        raise Wrong(f"a command line in `{variable}`", repr(text)[:120])
    return text


def _understood(command: str, said: str) -> None:
    if said.startswith("usage:"):
        raise Wrong("a command that ros2 knows", command[:120], said.strip().splitlines()[-1][:160])


def _close(text: str, number: float) -> bool:
    try:
        return abs(float(text) - number) < 0.01
    except ValueError:
        return False
