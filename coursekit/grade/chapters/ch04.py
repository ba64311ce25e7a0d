"""Chapter 4: a message type, its listener, an action that can be cancelled, a type of one's own."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work
from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.model import Message
from coursekit.interfaces.parser import parse_file

TYPES = "s4_custom_interface"
APPS = "s4_py_apps"


def _message(work: Work, name: str) -> Message:
    """A message type as it stands in src/, which also has to be in install/ like that."""
    source = work.file(f"src/{TYPES}/msg/{name}.msg")
    try:
        message = parse_file(TYPES, source)
    except InterfaceError as error:
        raise Wrong(f"{name}.msg that can be read", str(error).replace(str(work.workspace), "~/ros2_ws")) from None
    assert isinstance(message, Message)
    _expect_installed(work.built(TYPES), source, name)
    return message


def _expect_installed(prefix: Path, source: Path, name: str) -> None:
    installed = prefix / "share" / TYPES / "msg" / f"{name}.msg"
    if not installed.is_file() or installed.read_text(encoding="utf-8") != source.read_text(encoding="utf-8"):
        build = f"%colcon build --packages-select {TYPES}"
        raise Wrong(f"{name}.msg, built as it is in src/", "not in install/", f"Look at what this prints: {build}")


@exercise(
    "ch04.q1",
    "A sphere",
    points=1,
    hints=(
        "Two lines, each with the type first and the name after it.",
        "A type of another package is written package/Name.",
    ),
)
def sphere(work: Work) -> None:
    """The fields have these types, names and this order; the unit is told."""
    message = _message(work, "Sphere")
    names = [field.name for field in message.fields]
    if names != ["center", "radius"]:
        raise Wrong("the fields center and radius, in this order", ", ".join(names) or "no fields")
    kinds = [(field.type.base, field.type.is_primitive) for field in message.fields]
    if kinds[0][0].split("/")[-1] != "Point" or not kinds[0][0].startswith("geometry_msgs/"):
        raise Wrong("center of the type Point of geometry_msgs", kinds[0][0])
    if kinds[1][0] not in ("float64", "double"):
        raise Wrong("radius of the type float64", kinds[1][0], "float32 has only seven digits.")
    if "#" not in work.text(f"src/{TYPES}/msg/Sphere.msg"):
        raise Wrong("a comment with the unit of the radius", "no comment", "A comment begins with #.", share=0.5)


@exercise(
    "ch04.q2",
    "The mechanic listens",
    points=2,
    hints=(
        "Two create_subscription lines, each with its own callback.",
        "math.pi, and r to the power of three: r**3.",
    ),
)
def mechanic(work: Work) -> None:
    """Statuses and spheres are logged in the words that were asked for."""
    work.built(APPS)
    states = [(17 + 9 * at, at % 2 == 0) for at in range(3)]
    radii = [0.5, 1.0, 2.25]
    publish: list[tuple[float, str, str, dict[str, Any]]] = [
        (1.0 + at, "/py_hs_topic", f"{TYPES}/msg/HardwareStatus", {"temperature": degrees, "are_motors_up": up})
        for at, (degrees, up) in enumerate(states)
    ]
    publish += [(1.5 + at, "/py_sphere_topic", f"{TYPES}/msg/Sphere", {"radius": r}) for at, r in enumerate(radii)]
    seen = work.try_out(f"run {APPS} subscriber_exe", publish=publish, seconds=5.0)
    if "/py_subscriber_node" not in seen.nodes:
        raise Wrong("a node named /py_subscriber_node", ", ".join(seen.nodes) + _last_words(seen))
    _expect_subscribed(seen, "/py_hs_topic", "/py_sphere_topic")
    for degrees, up in states:
        _expect_line(seen, f"{degrees} degrees, motors {'up' if up else 'down'}", "a status")
    for radius in radii:
        _expect_line(seen, f"volume {4 / 3 * math.pi * radius**3:.2f}", f"a sphere of radius {radius}")


def _expect_subscribed(seen: Seen, *topics: str) -> None:
    for topic in topics:
        if not seen.subscriptions.get(topic):
            raise Wrong(f"a subscription to {topic}", "none" + _last_words(seen), "Is the topic's name right?")


def _expect_line(seen: Seen, line: str, what: str) -> None:
    said = [one.partition("]: ")[2] for one in seen.outputs[0].splitlines()]
    if line not in said:
        raise Wrong(f"{what} is logged as: {line}", "; ".join(said[:6]) or "nothing" + _last_words(seen), share=0.25)


def _last_words(seen: Seen) -> str:
    lines = seen.outputs[0].strip().splitlines()
    return f"; the program's last line: {lines[-1]}" if lines else ""


@exercise(
    "ch04.q3",
    "Fetch boxes",
    points=3,
    hints=(
        "A loop over the boxes: look whether to stop, sleep, count, publish the feedback.",
        "goal_handle.canceled() and goal_handle.succeed() only say how it ended; the Result is returned after them.",
    ),
)
def fetch(work: Work) -> None:
    """Feedback box by box, a result at the end, and a cancelled goal that ends early."""
    work.built(APPS)
    goal = f'action send_goal --feedback /fetch {TYPES}/action/Fetch "{{boxes: %d}}"'
    for boxes in (1, 4):
        seen = work.try_out(f"run {APPS} fetch_exe", goal % boxes, seconds=4.0)
        said = seen.outputs[1]
        feedback = _numbers(said, "brought_yet:")
        if feedback != list(range(1, boxes + 1)):
            raise Wrong(f"with {boxes} boxes the feedback 1 to {boxes}", f"{feedback}{_last_words(seen)}")
        if f"brought: {boxes}" not in said:
            raise Wrong(f"the result brought: {boxes}", f"{_numbers(said, 'brought:')}{_last_words(seen)}", share=0.4)
        if "status: SUCCEEDED" not in said:
            raise Wrong("a goal that succeeded", _ending(said), "goal_handle.succeed()", share=0.4)
    _expect_cancelled(work, goal % 40)
    seen = work.try_out(f"run {APPS} fetch_exe", goal % 4, seconds=1.7)
    if len(_numbers(seen.outputs[1], "brought_yet:")) != 3:
        raise Wrong("one box each half second", "another pace", "time.sleep(0.5) for each box", share=0.75)


def _expect_cancelled(work: Work, goal: str) -> None:
    empty: dict[str, Any] = {}
    cancel = [(1.7, "/fetch/_action/cancel_goal", "action_msgs/srv/CancelGoal", empty)]
    seen = work.try_out(f"run {APPS} fetch_exe", goal, call=cancel, seconds=4.0)
    said = seen.outputs[1]
    if "Goal finished with status" not in said:
        raise Wrong("a goal that ends soon after it is cancelled", "it went on", "is_cancel_requested", share=0.5)
    if "status: CANCELED" not in said:
        raise Wrong("a cancelled goal that ends as canceled", _ending(said), "goal_handle.canceled()", share=0.5)
    done = _numbers(said, "brought_yet:")
    if _numbers(said, "brought:") != done[-1:]:
        got = f"brought {_numbers(said, 'brought:')} after the feedback {done}"
        raise Wrong("a result that says how many boxes were brought until then", got, share=0.75)


def _numbers(text: str, label: str) -> list[int]:
    words = (line.split() for line in text.splitlines() if line.split()[:1] == [label])
    return [int(found[1]) for found in words]


def _ending(said: str) -> str:
    return next((line for line in said.splitlines() if "finished with status" in line), "it did not end")


@exercise(
    "ch04.q4",
    "A message of your own",
    points=2,
    hints=(
        "Constants are written with `=` and in capitals, defaults without: `uint8 FULL=100`, `uint8 battery 100`.",
        "Keep one message in the node, change it in the timer's callback, publish it.",
    ),
)
def report(work: Work) -> None:
    """A rich message type, published with values that change."""
    for missing in _missing(_message(work, "Report")):
        raise Wrong(missing, "Report.msg has none or too few")
    work.built(APPS)
    seen = work.try_out(f"run {APPS} report_exe", record=["/vera_report"], seconds=4.0)
    types = seen.topics.get("/vera_report", [])
    if types != [f"{TYPES}/msg/Report"]:
        raise Wrong("/vera_report with your type", (", ".join(types) or "no such topic") + _last_words(seen), share=0.5)
    messages = [message for _, message in seen.messages.get("/vera_report", [])]
    if len(messages) < 3:
        raise Wrong("a report at least once a second", f"{len(messages)} in 4 seconds", share=0.5)
    if all(message == messages[0] for message in messages):
        raise Wrong("values that change", f"always {messages[0]}", share=0.75)


def _missing(message: Message) -> Iterator[str]:
    """What the message type lacks, in words."""
    if len(message.fields) < 4:
        yield f"at least four fields (there are {len(message.fields)}; constants are not fields)"
    if len({str(field.type) for field in message.fields}) < 3:
        yield "fields of at least three different types"
    if not any(field.type.is_array for field in message.fields):
        yield "an array: brackets behind the type, float64[]"
    if not message.constants:
        yield "a constant: in capitals, with ="
    if all(field.default is None for field in message.fields):
        yield "a field with a default value: after its name"
