"""Chapter 5: a lamp's parameters, a file for a fleet, two cameras from one launch file, a ball that is followed."""

from __future__ import annotations

import statistics
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

PACKAGE, USERS = "s5_py_camera", "s5_py_camera_usr"
LAMP = "/py_lamp_node"
NOT_SET, BOOL, INTEGER, DOUBLE, STRING = range(5)


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
    """Range and callback refuse what they should, and what is taken takes effect."""
    work.built(PACKAGE)
    asks = [
        _set("lamp.period", 5.0),
        _set("lamp.period", 0.05),
        _set("lamp.colour", "violet"),
        _set("lamp.colour", "red"),
    ]
    asks += [_set("lamp.period", 0.2), _set("lamp.colour", "amber")]
    seen = work.try_out(
        f"run {PACKAGE} lamp_exe",
        record=["/lamp"],
        call=[
            (0.5, f"{LAMP}/describe_parameters", "rcl_interfaces/srv/DescribeParameters", {"names": ["lamp.period"]}),
            *[(1.1 + 0.05 * index, f"{LAMP}/set_parameters", _SET, ask) for index, ask in enumerate(asks)],
        ],
        seconds=5.0,
    )
    _expect_node(seen, LAMP)
    _judge_first_second(seen)
    described = (seen.responses[0] or {}).get("descriptors") or [{}]
    _judge_range(described[0])
    _judge_answers([((one or {}).get("results") or [{}])[0] for one in seen.responses[1:]])
    late = [message["data"] for when, message in seen.messages["/lamp"] if when > 3.0]
    if not 9 <= len(late) <= 11:
        raise Wrong("10 colours in 2 s after lamp.period was set to 0.2", f"{len(late)}", share=0.5)
    if set(late) != {"amber"}:
        raise Wrong("the colour that was set last: amber", ", ".join(sorted(set(late))), share=0.5)


_SET = "rcl_interfaces/srv/SetParameters"


def _set(name: str, value: float | str) -> dict[str, Any]:
    typed = (
        {"type": DOUBLE, "double_value": value} if isinstance(value, float) else {"type": STRING, "string_value": value}
    )
    return {"parameters": [{"name": name, "value": typed}]}


def _judge_first_second(seen: Seen) -> None:
    early = [message["data"] for when, message in seen.messages.get("/lamp", []) if when < 1.1]
    if len(early) != 2 or set(early) != {"green"}:
        raise Wrong("green twice in the first second, as the defaults say", f"{early}", "Are name and default right?")


def _judge_range(descriptor: dict[str, Any]) -> None:
    ranges = descriptor.get("floating_point_range") or []
    ends = (ranges[0]["from_value"], ranges[0]["to_value"]) if ranges else None
    if ends is None or max(abs(ends[0] - 0.1), abs(ends[1] - 2.0)) > 1e-9:
        raise Wrong(
            "lamp.period described with a floating_point_range from 0.1 to 2.0",
            f"from {ends[0]} to {ends[1]}" if ends else "it has none",
            "" if ends else "The range goes into the ParameterDescriptor, the third argument of declare_parameter.",
            share=0.25,
        )


def _judge_answers(results: list[dict[str, Any]]) -> None:
    told = ["lamp.period 5.0", "lamp.period 0.05", "lamp.colour violet", "lamp.colour red", "lamp.period 0.2"]
    for name, result, refused in zip(told, results, (True, True, True, False, False), strict=False):
        if not result:
            raise Wrong(
                f"an answer to: {name}", "none", "Does judge return a SetParametersResult in every case?", share=0.25
            )
        if result["successful"] is refused:
            seen = "taken" if refused else f"refused: {result['reason']}"
            raise Wrong(f"{name}: {'refused' if refused else 'taken'}", seen, share=0.5)
    if not results[2]["reason"]:
        raise Wrong(
            "a reason with the refused colour", "an empty one", "SetParametersResult has a field for it.", share=0.75
        )


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
    """ROS's own reading of the file gives each node what it should have."""
    from coursekit.core.arguments import parse_ros_arguments

    path = work.file(f"src/{PACKAGE}/config/fleet.yaml")
    try:
        read = parse_ros_arguments(["--ros-args", "--params-file", str(path)])
    except Exception as error:
        said = str(error).replace(str(path), path.name)
        raise Wrong("a parameter file that ROS can read", said, "Two underscores in ros__parameters?") from None
    small = work.variant("width", 320), work.variant("height", 240)
    large, gate = (work.variant("gate_width", 1280), work.variant("gate_height", 720)), work.variant("gate", "gate")
    cameras = {"/py_camera_node": small, "/hall/north/py_camera_node": small, "/a/b/c/py_camera_node": small}
    for node, size in (cameras | {f"/{gate}/py_camera_node": large, f"/{gate}/east/py_camera_node": small}).items():
        got = read.parameters_for(node)
        for name, wanted in zip(("camera.width", "camera.height"), size, strict=True):
            _expect_value(node, name, wanted, got)
        _expect_value(node, "use_sim_time", False, got)
    for node in ("/turtlesim", f"/{gate}/py_lamp_node"):
        got = read.parameters_for(node)
        _expect_value(node, "use_sim_time", False, got)
        if any(name.startswith("camera.") for name in got):
            raise Wrong(f"nothing about cameras for {node}", f"{got}", "A wildcard for the name too?", share=0.5)


def _expect_value(node: str, name: str, wanted: Any, got: dict[str, Any]) -> None:
    value = got.get(name)
    if value != wanted or type(value) is not type(wanted):
        raise Wrong(
            f"{name} {wanted!r} for {node}",
            repr(value) if name in got else f"{node} has {', '.join(got) or 'no parameters'}",
            "When two entries fit, the later one in the file wins." if name in got else "Does one of the names fit it?",
        )


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
    """Two cameras in two namespaces, their width from the command line."""
    work.built(PACKAGE)
    for argument, width in (("", 320), (" width:=160", 160)):
        command = f"launch {PACKAGE} two_cameras.launch.py{argument}"
        nodes = [f"/{side}/py_camera_node" for side in ("left", "right")]
        names = {"names": ["camera.width", "camera.height"]}
        calls = [(1.0, f"{node}/get_parameters", "rcl_interfaces/srv/GetParameters", names) for node in nodes]
        seen = work.try_out(command, call=calls, seconds=2.0)
        for node, answer in zip(nodes, seen.responses, strict=True):
            _expect_node(seen, node)
            size = [(one["type"], one["integer_value"]) for one in (answer or {"values": []})["values"]]
            if size != [(INTEGER, width), (INTEGER, 240)]:
                shown = " x ".join(str(value) for _, value in size) or "nothing"
                raise Wrong(f"{width} x 240 for {node} with: ros2 {command}", shown, share=0.5)
        if len(seen.nodes) != len(set(seen.nodes)) or len(seen.nodes) > 3:
            raise Wrong("two nodes", ", ".join(seen.nodes), share=0.5)


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
    """The ball is where the scene has it, in small and in large pictures."""
    work.built(USERS)
    for width, height, seconds in ((480, 360, 2.0), (320, 240, 5.0)):
        size = f"-p camera.width:={width} -p camera.height:={height}"
        seen = work.try_out(
            f"run {PACKAGE} camera_exe --ros-args {size}",
            f"run {USERS} tracker_exe",
            record=["/ball/pixel"],
            seconds=seconds,
        )
        _expect_node(seen, "/py_tracker_node", output=1)
        _judge_places(seen, width, height, round(30 * seconds))


def _judge_places(seen: Seen, width: int, height: int, pictures: int) -> None:
    found = [message for _, message in seen.messages.get("/ball/pixel", [])]
    if len(found) < 0.6 * pictures:
        last = (seen.outputs[1].strip().splitlines() or ["nothing was printed"])[-1]
        raise Wrong(f"a place for nearly each of {pictures} pictures", f"{len(found)}; the program said: {last}")
    off = sorted(_distance(message, width, height) for message in found)
    middle, most = statistics.median(off), off[int(0.9 * len(off))]
    if middle > 0.006 * width:
        raise Wrong(
            f"at {width}x{height}, half of the places within {0.006 * width:.0f} pixels of the ball's centre",
            f"half are more than {middle:.0f} pixels off",
            "x is the column and y the row. Is it red that you look for, at both ends of the hue?",
            share=0.25 if middle < 0.05 * width else 0.0,
        )
    if most > 0.04 * width:
        raise Wrong(
            f"nine of ten places within {0.04 * width:.0f} pixels",
            f"the tenth part is {most:.0f} pixels off or more",
            "Other things in the hall are a little red too; take the largest patch only.",
            share=0.5,
        )


def _distance(message: dict[str, Any], width: int, height: int) -> float:
    from coursekit.sim.camera import Scene

    stamp = message["header"]["stamp"]
    t = stamp["sec"] - 1_700_000_000 + stamp["nanosec"] * 1e-9  # where the virtual clock begins
    u, v = Scene().pixel(Scene.balls(t)[0].centre, width, height)
    return float(((message["point"]["x"] - u) ** 2 + (message["point"]["y"] - v) ** 2) ** 0.5)


def _expect_node(seen: Seen, name: str, output: int = 0) -> None:
    if name not in seen.nodes:
        said = seen.outputs[output].strip().splitlines()
        raise Wrong(
            f"a node named {name}",
            f"nodes: {', '.join(seen.nodes) or 'none'}" + (f"; it was said: {said[-1]}" if said else ""),
            "Does it start, and are name and namespace right? Was it built after the last change?",
        )
