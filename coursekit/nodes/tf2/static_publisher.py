"""`static_transform_publisher`: one transform on /tf_static, from the command line."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field

import rclpy
from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.utilities import remove_ros_args
from tf2_ros import StaticTransformBroadcaster
from tf_transformations import quaternion_from_euler

from coursekit.nodes.running import spin_to_the_end, terminate
from coursekit.processes.session import current

USAGE = """\
usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw QW] \
[--roll ROLL] [--pitch PITCH] [--yaw YAW] --frame-id FRAME_ID --child-frame-id CHILD_FRAME_ID

Publishes a transform that never changes.

Without translation or rotation it is the identity. Translations are in metres; the rotation is given as angles in
radians (roll, pitch, yaw) or as a quaternion.

required arguments:
  --frame-id FRAME_ID   parent frame
  --child-frame-id CHILD_FRAME_ID
                        child frame

optional arguments:
  --x X --y Y --z Z     translation
  --qx QX --qy QY --qz QZ --qw QW
                        rotation as quaternion
  --roll ROLL --pitch PITCH --yaw YAW
                        rotation as angles"""

_TRANSLATION = ("x", "y", "z")
_QUATERNION = ("qx", "qy", "qz", "qw")
_ANGLES = ("roll", "pitch", "yaw")
_FRAMES = ("frame-id", "child-frame-id")
_LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"


class BadArguments(Exception):
    """The command line is invalid; the text gives the reason."""


@dataclass
class Wanted:
    """The transform that the command line specifies."""

    numbers: dict[str, float] = field(default_factory=dict)
    frames: dict[str, str] = field(default_factory=dict)

    def seen(self, names: tuple[str, ...]) -> bool:
        """Whether any of these options was given."""
        return any(name in self.numbers or name in self.frames for name in names)

    def number(self, name: str, text: str) -> None:
        """Store a number; raises BadArguments."""
        try:
            self.numbers[name] = float(text)
        except ValueError:
            option = f"--{name}"
            raise BadArguments(f"Failed to parse {option} argument as float") from None

    def rotation(self) -> tuple[float, float, float, float]:
        """The quaternion x, y, z, w."""
        if self.seen(_ANGLES):
            roll, pitch, yaw = (self.numbers.get(name, 0.0) for name in _ANGLES)
            return quaternion_from_euler(roll, pitch, yaw)
        x, y, z = (self.numbers.get(name, 0.0) for name in _QUATERNION[:3])
        return x, y, z, self.numbers.get("qw", 1.0)


def parse(args: list[str]) -> Wanted | None:
    """Parse new-style or old-style arguments; None for --help. Raises BadArguments."""
    wanted, bare = Wanted(), []
    words = iter(args)
    for word in words:
        name = word.removeprefix("--")
        if word in ("-h", "--help"):
            return None
        if not word.startswith("--") or name not in (*_TRANSLATION, *_QUATERNION, *_ANGLES, *_FRAMES):
            bare.append(word)
            continue
        value = next(words, None)
        if value is None:
            raise BadArguments(f"Not enough arguments for {word}")
        if name in _FRAMES:
            wanted.frames[name] = value
        else:
            wanted.number(name, value)
    if wanted.seen(_ANGLES) and wanted.seen(_QUATERNION):
        raise BadArguments("Cannot specify both quaternion and Euler rotations")
    _take_old_style(wanted, bare)
    for name, title in zip(_FRAMES, ("Frame id", "Child frame id"), strict=True):
        if not wanted.frames.get(name):
            raise BadArguments(f"{title} must not be empty")
    return wanted


def _take_old_style(wanted: Wanted, bare: list[str]) -> None:
    """Parse x y z yaw pitch roll frame child, or x y z qx qy qz qw frame child."""
    if not bare:
        return
    if len(bare) not in (8, 9):
        raise BadArguments("Extra unparsed arguments on command-line")
    RcutilsLogger().warning("Old-style arguments are deprecated; see --help for new-style arguments")
    if wanted.numbers or wanted.frames:
        raise BadArguments("Cannot specify both new-style (flags) and old-style (arguments)")
    names = (*_TRANSLATION, *(reversed(_ANGLES) if len(bare) == 8 else _QUATERNION))
    for name, text in zip(names, bare, strict=False):
        wanted.number(name, text)
    wanted.frames = dict(zip(_FRAMES, bare[-2:], strict=True))


class SameFrame(RuntimeError):
    """A frame cannot be its own parent."""


class StaticTransformPublisher(Node):
    """Publishes the transform in its parameters."""

    def __init__(self, wanted: Wanted) -> None:
        place = [wanted.numbers.get(name, 0.0) for name in _TRANSLATION]
        values: dict[str, float | str] = {f"translation.{a}": v for a, v in zip("xyz", place, strict=True)}
        values.update((f"rotation.{a}", v) for a, v in zip("xyzw", wanted.rotation(), strict=True))
        values.update(frame_id=wanted.frames["frame-id"], child_frame_id=wanted.frames["child-frame-id"])
        super().__init__(
            f"static_transform_publisher_{_suffix()}",
            parameter_overrides=[Parameter(name, value=value) for name, value in values.items()],
        )
        fixed = ParameterDescriptor(read_only=True)
        got = {name: self.declare_parameter(name, value, fixed).value for name, value in values.items()}
        if got["frame_id"] == got["child_frame_id"]:
            frame = got["frame_id"]
            self.get_logger().error(f"cannot publish static transform from '{frame}' to '{frame}', exiting")
            raise SameFrame("child_frame_id cannot equal frame_id")
        self._broadcaster = StaticTransformBroadcaster(self)
        self._broadcaster.sendTransform(self._transform(got))
        self.announcement = _announcement(got)

    def _transform(self, got: dict[str, float | str | None]) -> TransformStamped:
        msg = TransformStamped()
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.header.frame_id, msg.child_frame_id = str(got["frame_id"]), str(got["child_frame_id"])
        for part in ("translation", "rotation"):
            for axis in "xyzw" if part == "rotation" else "xyz":
                setattr(getattr(msg.transform, part), axis, got[f"{part}.{axis}"])
        return msg


def _suffix() -> str:
    """Sixteen characters that are unique to this publisher."""
    number = int.from_bytes(current().new_uuid(), "big")
    return "".join(_LETTERS[number // 62**place % 62] for place in range(16))


def _announcement(got: dict[str, float | str | None]) -> str:
    place = ", ".join(f"'{got[f'translation.{axis}']:f}'" for axis in "xyz")
    turn = ", ".join(f"'{got[f'rotation.{axis}']:f}'" for axis in "xyzw")
    return (
        f"Spinning until stopped - publishing transform\ntranslation: ({place})\nrotation: ({turn})\n"
        f"from '{got['frame_id']}' to '{got['child_frame_id']}'"
    )


def main() -> int:
    """Publish until Ctrl-C."""
    rclpy.init(args=sys.argv)
    try:
        wanted = parse(remove_ros_args(sys.argv)[1:])
    except BadArguments as error:
        RcutilsLogger().error(f"error parsing command line arguments: {error}")
        print(USAGE)
        return 1
    if wanted is None:
        print(USAGE)
        return 0
    try:
        node = StaticTransformPublisher(wanted)
    except SameFrame as error:
        return terminate(str(error))
    node.get_logger().info(node.announcement)
    return spin_to_the_end(node)


def component() -> int:
    """Publish the transform in the parameters, as the component in a container does."""
    rclpy.init()
    unnamed = dict(zip(_FRAMES, ("/frame", "/child"), strict=True))
    try:
        return spin_to_the_end(StaticTransformPublisher(Wanted(frames=unnamed)))
    except SameFrame as error:
        return terminate(str(error))
