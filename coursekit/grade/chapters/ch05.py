"""Chapter 5: a lamp's parameters in both languages, a file for a fleet, two cameras, tracking a ball."""

from __future__ import annotations

import math
import statistics
from random import Random
from typing import Any

from coursekit.grade.chapters.measures.lamps import Ask, calls_that_set, judge_answers, judge_range, no_colour
from coursekit.grade.exercise import exercise
from coursekit.grade.figures.sightings import seen_at
from coursekit.grade.outputs import expect_node, heard, last_words, said
from coursekit.grade.plain import field, fields, shown
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

PACKAGE, USERS, CPP = "s5_py_camera", "s5_py_camera_usr", "s5_cpp_camera"
LAMP, CPP_LAMP = "/py_lamp_node", "/cpp_lamp_node"
INTEGER = 2
"""The parameter type in rcl_interfaces/msg/ParameterType."""
PICTURES = 12
"""The number of images of each size shown to the tracker."""


@exercise(
    "ch05.q1",
    "The warning lamp",
    points=2,
    hints=(
        "Three names are imported for you: the range goes into a list in the descriptor, the descriptor is the third "
        "thing that declare_parameter takes.",
        "judge gets a list; look at each one's .name first, because a new period comes here too.",
    ),
)
def lamp(work: Work) -> None:
    """Check that range and callback reject invalid values, also one of several, and that accepted ones take effect."""
    work.built(PACKAGE, "py_lamp_node", "lamp_settings")
    no_lamp = no_colour(work.dice("ch05.q1"))
    asks: list[Ask] = [
        ("lamp.period 5.0", {"lamp.period": 5.0}, False),
        ("lamp.period 0.05", {"lamp.period": 0.05}, False),
        (f"lamp.colour {no_lamp}", {"lamp.colour": no_lamp}, False),
        ("lamp.colour red", {"lamp.colour": "red"}, True),
        (f"lamp.period 0.4 and lamp.colour {no_lamp} at once", {"lamp.period": 0.4, "lamp.colour": no_lamp}, False),
        (f"lamp.colour {no_lamp} and lamp.period 0.4 at once", {"lamp.colour": no_lamp, "lamp.period": 0.4}, False),
        ("lamp.period 0.2 and lamp.colour amber at once", {"lamp.period": 0.2, "lamp.colour": "amber"}, True),
    ]
    describe = (0.5, f"{LAMP}/describe_parameters", "rcl_interfaces/srv/DescribeParameters", {"names": ["lamp.period"]})
    calls = [describe, *calls_that_set(LAMP, asks)]
    seen = work.try_out(f"run {PACKAGE} lamp_exe", record=["/lamp"], call=calls, seconds=5.0)
    expect_node(seen, LAMP)
    colours = [(when, field(message, "data", str, "/lamp")) for when, message in heard(seen, "/lamp")]
    early = [colour for when, colour in colours if when < 1.1]
    if early != ["green", "green"]:
        raise Wrong("green twice in the first second, as the defaults say", f"{shown(early)}", "Are name and default right?")
    judge_range(seen.responses[0])
    judge_answers(asks, seen.responses[1:])
    late = [colour for when, colour in colours if when > 3.0]
    if set(late) != {"amber"}:
        raise Wrong("the colour that was set last: amber", ", ".join(sorted(set(late))) or "none", share=0.5, hint=1)
    if not 9 <= len(late) <= 11:
        raise Wrong("10 colours in 2 s after lamp.period was set to 0.2", f"{len(late)}", share=0.5, hint=1)


@exercise(
    "ch05.q2",
    "One file for the fleet",
    points=2,
    hints=(
        "Three entries, each with a line ros__parameters: below it.",
        "From the general to the special: the later entry wins.",
    ),
)
def fleet(work: Work) -> None:
    """Check with ROS's own parser that the file gives each node its values, in any namespace."""
    small = work.variant("width", 320), work.variant("height", 240)
    large, gate = (work.variant("gate_width", 1280), work.variant("gate_height", 720)), work.variant("gate", "gate")
    chance = work.dice("ch05.q2")
    hall, room = (f"{word}{chance.randint(2, 99)}" for word in ("hall", "room"))
    cameras = dict.fromkeys(("", f"/{hall}", "/hall/north", f"/a/{hall}/{room}", f"/{gate}/east", f"/{hall}/{gate}"), small)
    nodes = {f"{where}/py_camera_node": size for where, size in (cameras | {f"/{gate}": large}).items()}
    others = ("/turtlesim", f"/{gate}/py_lamp_node", f"/{hall}/node_{room}")
    read = work.parameters(f"src/{PACKAGE}/config/fleet.yaml", [*nodes, *others])
    for node, size in nodes.items():
        for name, wanted in zip(("camera.width", "camera.height"), size, strict=True):
            _expect_value(node, name, wanted, read[node])
        _expect_value(node, "use_sim_time", False, read[node])
    for node in others:
        _expect_value(node, "use_sim_time", False, read[node])
        if any(name.startswith("camera.") for name in read[node]):
            got = shown(read[node])
            raise Wrong(f"nothing about cameras for {node}", got, "A wildcard for the name too?", share=0.5, hint=0)


def _expect_value(node: str, name: str, wanted: Any, got: dict[str, Any]) -> None:
    value = got.get(name)
    if name in got and type(value) is not type(wanted):
        cause = f"{_a(type(value))} is written there; {_a(type(wanted))} is wanted."
        raise Wrong(f"{name} {wanted!r} for {node}", shown(value), cause, hint=NO_HINT)
    if value != wanted:
        raise Wrong(
            f"{name} {wanted!r} for {node}",
            shown(value) if name in got else f"{node} has {', '.join(got) or 'no parameters'}",
            "When two entries fit, the later one in the file wins." if name in got else "Does one of the names fit it?",
            hint=1 if name in got else 0,
        )


def _a(kind: type) -> str:
    """Return the name of a parameter type in ROS, with its article."""
    return {bool: "a bool", int: "an integer", float: "a double", str: "a string"}.get(kind, "an array")


@exercise(
    "ch05.q3",
    "Two eyes",
    points=2,
    hints=(
        "The value of camera.width is not known yet when the file is read: a LaunchConfiguration stands for it.",
        "Three things in the list of the LaunchDescription: the argument's declaration and two nodes.",
    ),
)
def two_eyes(work: Work) -> None:
    """Check for two cameras in two namespaces, with their width from the command line."""
    work.built(PACKAGE, "two_cameras", "py_camera_node")
    other = 16 * work.dice("ch05.q3").randint(5, 18)
    for argument, width in (("", 320), (f" width:={other}", other)):
        command = f"launch {PACKAGE} two_cameras.launch.py{argument}"
        nodes = [f"/{side}/py_camera_node" for side in ("left", "right")]
        names = {"names": ["camera.width", "camera.height"]}
        calls = [(1.0, f"{node}/get_parameters", "rcl_interfaces/srv/GetParameters", names) for node in nodes]
        seen = work.try_out(command, call=calls, seconds=2.0)
        for node, answer in zip(nodes, seen.responses, strict=True):
            expect_node(seen, node)
            values = field(answer, "values", list, f"an answer of {node}")
            size = [(field(message, "type", int), field(message, "integer_value", int)) for message in values]
            if size != [(INTEGER, width), (INTEGER, 240)]:
                sizes = " x ".join(str(value) for _, value in size) or "nothing"
                raise Wrong(f"{width} x 240 for {node} with: ros2 {command}", sizes, share=0.5, hint=0)
        cameras = [node for node in seen.nodes if not node.startswith("/launch_ros_")]
        if sorted(cameras) != nodes:
            raise Wrong("two nodes", ", ".join(cameras), share=0.5, hint=1)


@exercise(
    "ch05.q4",
    "Where is the ball?",
    points=3,
    hints=(
        "A mask of what is red: the hue near 0 or near 180, and colourful enough that grey is not red.",
        "Then one place from many pixels: cv2.moments, or cv2.connectedComponentsWithStats for the largest patch.",
    ),
)
def ball(work: Work) -> None:
    """Check that the ball is found in small and large images, at random times of the scene."""
    work.built(USERS)
    chance = work.dice("ch05.q4")
    for width, height in ((320, 240), (200, 150)):
        moments = _moments(chance)
        pictures = [_picture(number, moment, width, height) for number, moment in enumerate(moments, 1)]
        spoken = [
            (0.5 + 0.1 * k, "/camera/image_raw", "sensor_msgs/msg/Image", picture) for k, picture in enumerate(pictures)
        ]
        seconds = 1.0 + 0.1 * len(pictures)
        seen = work.try_out(f"run {USERS} tracker_exe", publish=spoken, record=["/ball/pixel"], seconds=seconds)
        expect_node(seen, "/py_tracker_node")
        _judge_places(work, seen, _places(moments, width, height), width, height)
    _expect_none(work, chance)


def _expect_none(work: Work, chance: Random) -> None:
    """Check that a grey image without a ball gives no position, and that the program continues with the next image."""
    grey = _picture(1, 0.0, 160, 120) | {"data": [128] * (3 * 160 * 120)}
    spoken = [(0.5 + 0.1 * number, "/camera/image_raw", "sensor_msgs/msg/Image", picture)
              for number, picture in enumerate((grey, _picture(2, _moments(chance)[0], 160, 120)))]
    seen = work.try_out(f"run {USERS} tracker_exe", publish=spoken, record=["/ball/pixel"], seconds=1.2)
    stamps = [field(message, "header.stamp.sec", int, "/ball/pixel") for _, message in heard(seen, "/ball/pixel")]
    if stamps != [2]:
        wanted = "of a grey picture and one with the ball, a place for the second alone"
        got = f"places for {' and '.join(f'picture {stamp}' for stamp in stamps) or 'neither'}"
        raise Wrong(wanted, got, "find_ball returns None where nothing is red.", share=0.75, hint=NO_HINT)


def _moments(chance: Random) -> list[float]:
    """Return times of the scene at which the robot does not hide the ball."""
    from coursekit.sim.camera import Scene

    moments: list[float] = []
    while len(moments) < PICTURES:
        moment = chance.uniform(0.0, 10_000.0)
        if math.dist(Scene.robot(moment)[:2], Scene.balls(moment)[0].centre[:2]) > 0.7:
            moments.append(moment)
    return moments


def _picture(number: int, moment: float, width: int, height: int) -> dict[str, Any]:
    from coursekit.sim.camera import Scene

    data = Scene().render(moment, width, height).ravel().tolist()
    header = {"frame_id": "camera", "stamp": {"sec": number}}
    return {"header": header, "width": width, "height": height, "encoding": "bgr8", "step": 3 * width, "data": data}


def _places(moments: list[float], width: int, height: int) -> dict[int, tuple[float, float]]:
    """Return the ball's position in each image, by the image's stamp."""
    from coursekit.sim.camera import Scene

    scene = Scene()
    return {
        number: scene.pixel(scene.balls(moment)[0].centre, width, height) for number, moment in enumerate(moments, 1)
    }


def _judge_places(work: Work, seen: Seen, places: dict[int, tuple[float, float]], width: int, height: int) -> None:
    said_of: dict[int, float] = {}
    answers: dict[int, tuple[float, float]] = {}
    work.illustrate(seen_at, places, answers, (width, height), 0.04 * width)
    for _, message in heard(seen, "/ball/pixel"):
        number = field(message, "header.stamp.sec", int, "/ball/pixel")
        if number in places:
            x, y = fields(message, ("point.x", "point.y"), "/ball/pixel")
            answers[number], far = (x, y), math.dist((x, y), places[number])
            said_of[number] = max(far, said_of.get(number, 0.0))
    if len(said_of) < 0.6 * len(places):
        got = f"places with {len(said_of)} of their stamps; the program said: {last_words(said(seen))}"
        cause = "Does it see the ball in small pictures, too?"
        raise Wrong(f"a place for nearly each of {len(places)} pictures", got, cause)
    off = sorted(said_of.values())
    middle, most = statistics.median(off), off[int(0.9 * len(off))]
    if not middle <= 0.006 * width:
        raise Wrong(
            f"at {width}x{height}, half of the places within {0.006 * width:.1f} pixels of the ball's centre",
            f"half are more than {middle:.1f} pixels off",
            "x is the column and y the row. Is it red that you look for, at both ends of the hue?",
            share=0.25 if middle < 0.05 * width else 0.0,
            hint=0,
        )
    if not most <= 0.04 * width:
        raise Wrong(
            f"nine of ten places within {0.04 * width:.0f} pixels",
            f"the tenth part is {most:.0f} pixels off or more",
            "Other things in the hall are a little red too; take the largest patch only.",
            share=0.5,
            hint=1,
        )


@exercise(
    "ch05.q5",
    "A lamp in C++",
    points=0,
    hints=(
        "parameter.get_name() is the name, parameter.as_string() the value. Look at the name first: others come here, too.",
        "A loop over all of them, `for (const auto & parameter : parameters)`, and one result for all together.",
    ),
)
def lamp_in_cpp(work: Work) -> None:
    """Check that unknown colours are rejected with a reason, also one of several, and that accepted ones take effect."""
    work.compiled(CPP, "cpp_lamp_node")
    no_lamp = no_colour(work.dice("ch05.q5"))
    asks: list[Ask] = [
        (f"lamp.colour {no_lamp}", {"lamp.colour": no_lamp}, False),
        ("lamp.colour red", {"lamp.colour": "red"}, True),
        ("lamp.note checked", {"lamp.note": "checked"}, True),
        (f"lamp.note new and lamp.colour {no_lamp} at once", {"lamp.note": "new", "lamp.colour": no_lamp}, False),
        (f"lamp.colour {no_lamp} and lamp.note new at once", {"lamp.colour": no_lamp, "lamp.note": "new"}, False),
        ("lamp.note new and lamp.colour amber at once", {"lamp.note": "new", "lamp.colour": "amber"}, True),
    ]
    calls = calls_that_set(CPP_LAMP, asks)
    seen = work.try_out(f"run {CPP} lamp_exe", record=["/lamp"], call=calls, seconds=4.0)
    expect_node(seen, CPP_LAMP)
    judge_answers(asks, seen.responses)
    late = {field(message, "data", str, "/lamp") for when, message in heard(seen, "/lamp") if when > 2.5}
    if late != {"amber"}:
        raise Wrong("the colour that was set last: amber", ", ".join(sorted(late)) or "none", hint=1)
