"""Chapter 4: a message type, its listener, a cancellable action, an own type, an alarm in C++."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from random import Random
from typing import TYPE_CHECKING, Any

from coursekit.grade.exercise import exercise
from coursekit.grade.outputs import expect_node, expect_subscription, heard, last_words, said
from coursekit.grade.plain import field, shown
from coursekit.grade.trial import EVERY_NODE_S, Seen
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

if TYPE_CHECKING:
    from coursekit.interfaces.model import Field, Message

TYPES = "s4_custom_interface"
APPS, CPP = "s4_py_apps", "s4_cpp_apps"
METRES = re.compile(r"\b(m|met(re|er)s?|metros?|mètres?|metri)\b", re.I)
"""Spellings of the unit metre in the languages of the course."""


def _message(work: Work, name: str) -> Message:
    """Return a message type from src/, which must be the same in install/."""
    source = f"src/{TYPES}/msg/{name}.msg"
    message = work.message(source)
    work.built(TYPES)
    places = [f"install/{folder}share/{TYPES}/msg/{name}.msg" for folder in (f"{TYPES}/", "")]
    installed = [work.text(place) for place in places if work.exists(place)]
    if work.text(source) not in installed:
        build = f"%colcon build --packages-select {TYPES}"
        what = "an older one is in install/" if installed else "not in install/"
        raise Wrong(f"{name}.msg, built as it is in src/", what, f"Look at what this prints: {build}")
    return message


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
    """Check the types, names and order of the fields; the radius's unit must be in a comment beside it."""
    fields = _message(work, "Sphere").fields
    names = [field.name for field in fields]
    if names != ["center", "radius"]:
        raise Wrong("the fields center and radius, in this order", gave=", ".join(names) or "no fields", hint=0)
    center, radius = fields
    if str(center.type) != "geometry_msgs/Point":
        raise Wrong("center of the type Point of geometry_msgs", gave=str(center.type), hint=1)
    if str(radius.type) != "float64":
        raise Wrong("radius of the type float64", gave=str(radius.type), cause="float32 has only seven digits.")
    if not METRES.search(radius.comment):
        got = f"the comment: {radius.comment[:80]}" if radius.comment else "no comment beside or above it"
        cause = "Lengths in ROS are in metres." if radius.comment else "It begins with #."
        raise Wrong("a comment with the radius's unit, metres or m", gave=got, cause=cause, share=0.5, hint=NO_HINT)


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
    """Check that statuses and spheres are logged in the requested words."""
    work.built(APPS, "py_subscriber_node", "mains", "running")
    chance = work.dice("ch04.q2")
    states = [(chance.randint(-20, 90), up) for up in (True, False, chance.random() < 0.5)]
    radii = [_radius(chance) for _ in range(3)]
    publish: list[tuple[float, str, str, dict[str, Any]]] = [
        (1.0 + at, "/py_hs_topic", f"{TYPES}/msg/HardwareStatus", {"temperature": degrees, "are_motors_up": up})
        for at, (degrees, up) in enumerate(states)
    ]
    publish += [(1.5 + at, "/py_sphere_topic", f"{TYPES}/msg/Sphere", {"radius": r}) for at, r in enumerate(radii)]
    seen = work.try_out(f"run {APPS} subscriber_exe", publish=publish, seconds=5.0)
    expect_node(seen, "/py_subscriber_node")
    for topic, name in (("/py_hs_topic", "HardwareStatus"), ("/py_sphere_topic", "Sphere")):
        expect_subscription(seen, topic, f"{TYPES}/msg/{name}", hint=0)
    for degrees, up in states:
        _expect_line(seen, f"{degrees} degrees, motors {'up' if up else 'down'}", "a status")
    for radius in radii:
        _expect_line(seen, f"volume {_volume(radius):.2f}", f"a sphere of radius {radius}")


def _volume(radius: float) -> float:
    return 4 / 3 * math.pi * radius**3


def _radius(chance: Random) -> float:
    """Return a radius whose volume is not close to a rounding limit."""
    while True:
        radius = round(chance.uniform(0.3, 2.5), 2)
        if abs(_volume(radius) * 100 % 1 - 0.5) > 0.01:
            return radius


def _expect_line(seen: Seen, line: str, what: str) -> None:
    logged = re.findall(r"^\[[A-Z]+\] \[[0-9.]+\] \[py_subscriber_node\]: (.*)$", said(seen), re.M)
    if line not in logged:
        got = "; ".join(logged[:6]) or f"nothing is logged; the program said: {last_words(said(seen))}"
        printed = line in said(seen).splitlines()
        cause = "These are printed, not logged: self.get_logger().info(...) adds level, time and node." if printed else ""
        raise Wrong(f"{what} is logged as: {line}", got, cause, share=0.25, hint=_line_hint(line, bool(logged), printed))


def _line_hint(line: str, logged: bool, printed: bool) -> int:
    """Return the hint for a line that is not logged: on subscriptions if none is, on the volume if only that is wrong."""
    if printed:
        return NO_HINT
    if not logged:
        return 0
    return 1 if line.startswith("volume") else NO_HINT


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
    """Check for feedback box by box, a result at the end, and a cancelled goal that ends early."""
    work.built(APPS, "fetching", "py_fibonacci_node", "mains", "running")
    goal = f'action send_goal --feedback /fetch {TYPES}/action/Fetch "{{boxes: %d}}"'
    for boxes in (1, work.dice("ch04.q3").randint(3, 6)):
        _expect_fetched(work.try_out(f"run {APPS} fetch_exe", goal % boxes, seconds=4.5), boxes)
    _expect_cancelled(work, goal % 40)
    seen = work.try_out(f"run {APPS} fetch_exe", goal % 4, seconds=1.7)
    if len(_numbers(said(seen, 1), "brought_yet:")) != 3:
        raise Wrong("one box each half second", "another pace", "time.sleep(0.5) for each box", share=0.75, hint=0)


def _expect_fetched(seen: Seen, boxes: int) -> None:
    output, last = said(seen, 1), f"; the server's last words: {last_words(said(seen))}"
    feedback = _numbers(output, "brought_yet:")
    if feedback != list(range(1, boxes + 1)):
        wanted = f"for a goal with boxes: {boxes} the feedback {list(range(1, boxes + 1))}"
        raise Wrong(wanted, f"{feedback}{last}", _why_feedback(feedback), hint=0)
    if _numbers(output, "brought:") != [boxes]:
        raise Wrong(f"the result brought: {boxes}", f"{_numbers(output, 'brought:')}{last}", share=0.4, hint=1)
    if "status: SUCCEEDED" not in output:
        raise Wrong("a goal that succeeded", _ending(output), "goal_handle.succeed()", share=0.4, hint=1)


def _why_feedback(feedback: list[int]) -> str:
    """Return the likely cause of feedback other than 1, 2, 3, ..."""
    if feedback and feedback == list(range(len(feedback))):
        return "Count the box first, then publish how many there are."
    if len(set(feedback)) < len(feedback):
        return "Is the box counted in the loop?"
    begins = feedback[:1] in ([], [1])
    return "Does each box take half a second, and is its feedback published in the loop?" if begins else ""


def _expect_cancelled(work: Work, goal: str) -> None:
    empty: dict[str, Any] = {}
    cancel = [(1.7, "/fetch/_action/cancel_goal", "action_msgs/srv/CancelGoal", empty)]
    output = said(work.try_out(f"run {APPS} fetch_exe", goal, call=cancel, seconds=4.0), 1)
    if "Goal finished with status" not in output:
        raise Wrong("a goal that ends soon after it is cancelled", "it went on", "is_cancel_requested", share=0.5, hint=0)
    if "status: CANCELED" not in output:
        wanted = "a cancelled goal that ends as canceled"
        raise Wrong(wanted, _ending(output), "goal_handle.canceled()", share=0.5, hint=1)
    done, brought = _numbers(output, "brought_yet:"), _numbers(output, "brought:")
    if not done or brought != done[-1:]:
        got = f"brought {brought} after the feedback {done}"
        raise Wrong("a result with the number of boxes brought until then", got, share=0.75, hint=1)


def _numbers(text: str, label: str) -> list[int]:
    return [int(number) for number in re.findall(rf"^ *{label} (-?\d{{1,9}})$", text, re.M)]


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
    """Check for a rich message type, published with changing values."""
    definition = _message(work, "Report")
    for missing in _missing(definition):
        raise Wrong(missing, gave=_told(definition.fields, len(definition.constants)), hint=0)
    work.built(APPS, "py_report_node", "mains", "running")
    seen = work.try_out(f"run {APPS} report_exe", record=["/vera_report"], seconds=4.0)
    types = seen.topics.get("/vera_report", [])
    if types != [f"{TYPES}/msg/Report"]:
        others = ", ".join(name for name in seen.topics if name not in EVERY_NODE_S) or "none"
        got = f"{', '.join(types) or 'topics: ' + others}; the program said: {last_words(said(seen))}"
        raise Wrong("/vera_report with your type", got, share=0.5, hint=1)
    messages = [message for _, message in heard(seen, "/vera_report")]
    if len(messages) < 3:
        raise Wrong("a report at least once a second", f"{len(messages)} in 4 seconds", share=0.5, hint=1)
    if len({repr(message) for message in messages}) < 2:
        raise Wrong("values that change", f"always {shown(messages[0])}", share=0.75, hint=1)


def _told(fields: tuple[Field, ...], constants: int) -> str:
    kinds = ", ".join(f"{member.type} {member.name}" for member in fields)
    return f"{kinds or 'no fields'}; {constants} constant{'' if constants == 1 else 's'}"[:200]


def _missing(message: Message) -> Iterator[str]:
    """Yield the missing parts of the message type as text."""
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


@exercise(
    "ch04.q5",
    "An alarm in C++",
    points=0,
    hints=(
        "Both lines stand in this chapter's C++ nodes: create_publisher<HardwareStatus>(topic, 10), and create_subscription "
        "with a lambda. Keep what they return in the members of the class.",
        "The lambda may take the message by value, `[this](HardwareStatus status)`: then it can fill in the text.",
    ),
)
def alarm(work: Work) -> None:
    """Check that hot statuses are published again with a text, and cool ones are not."""
    work.compiled(CPP, "cpp_alarm_node")
    chance, kind = work.dice("ch04.q5"), f"{TYPES}/msg/HardwareStatus"
    degrees = [61, 60, chance.randint(62, 95), chance.randint(-20, 59), chance.randint(62, 95)]
    states = [{"temperature": degree, "are_motors_up": chance.random() < 0.5} for degree in degrees]
    publish = [(1.0 + 0.5 * at, "/cpp_hs_topic", kind, state) for at, state in enumerate(states)]
    seen = work.try_out(f"run {CPP} alarm_exe", record=["/cpp_alarm_topic"], publish=publish, seconds=4.5)
    expect_node(seen, "/cpp_alarm_node")
    expect_subscription(seen, "/cpp_hs_topic", kind, hint=0)
    alarms = [message for _, message in heard(seen, "/cpp_alarm_topic")]
    got = [(field(message, "temperature", int), field(message, "are_motors_up", bool)) for message in alarms]
    hot = [(state["temperature"], state["are_motors_up"]) for state in states if state["temperature"] > 60]
    if got != hot:
        told = f"of statuses with {', '.join(map(str, degrees))} degrees"
        came = f"alarms at {', '.join(str(temperature) for temperature, _ in got) or 'no'} degrees"
        cause = "60 degrees are not above 60." if (60, states[1]["are_motors_up"]) in got else ""
        raise Wrong(f"{told} those above 60, unchanged, on /cpp_alarm_topic", came, cause, hint=0)
    texts = {field(message, "debug_message", str) for message in alarms}
    if texts != {"too hot"}:
        raise Wrong("`too hot` in each alarm's debug_message", shown(sorted(texts)), hint=1)
