"""What judges read of a student's work, besides variables and functions: files, programs, and dice of their own."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

from .trial import Seen
from .verdict import Wrong

if TYPE_CHECKING:
    from coursekit.interfaces.model import Message
    from coursekit.urdf import Robot

    from .work import Work

_DELAYED = Sequence[tuple[float, str]]


@dataclass
class Watched(Seen):
    """What was seen of a trial; `outputs` and `exit_codes` are the student's programs, `beside` what the course's wrote."""

    beside: list[str] = field(default_factory=list)

    def of_course(self, topic: str) -> list[tuple[float, dict[str, Any]]]:
        """The messages of a topic that the course's own programs published."""
        return self.messages.get(topic, [])


def try_out(
    work: Work,
    *commands: str,
    beside: Sequence[str] = (),
    later: _DELAYED = (),
    record: Sequence[str] = (),
    publish: Sequence[tuple[float, str, str, dict[str, Any]]] = (),
    call: Sequence[tuple[float, str, str, dict[str, Any]]] = (),
    seconds: float = 3.0,
) -> Watched:
    """Run the student's `commands` and `later`, and `beside` them programs of the course."""
    plan: dict[str, Any] = {"record": list(record), "publish": list(publish), "call": list(call)}
    seen = work.try_out(*commands, *beside, seconds=seconds, later=list(later), **plan)
    first, last = len(commands), len(commands) + len(beside)
    made = Watched(**{one.name: getattr(seen, one.name) for one in fields(Seen)})
    made.beside = seen.outputs[first:last]
    made.outputs = seen.outputs[:first] + seen.outputs[last:]
    made.exit_codes = seen.exit_codes[:first] + seen.exit_codes[last:]
    return made


def dice(work: Work, name: str) -> random.Random:
    """Dice for a judge's random inputs: here the same in every run."""
    return random.Random(f"coursekit {name}")


def exists(work: Work, path: str) -> bool:
    """Whether a file is in the workspace."""
    try:
        return work.file(path).is_file()
    except Wrong:
        return False


def robot(work: Work, path: str) -> Robot:
    """A URDF or xacro file of the workspace; Wrong, with place and cure, when ROS would not take it."""
    from coursekit.urdf import UrdfError, load

    file = work.file(path)
    try:
        return load(file)
    except UrdfError as error:
        place = f"{file.name}:{error.line}" if error.line else file.name
        raise Wrong("a description that ROS takes", f"{place}: {error.what}", error.cure.split("\n")[0]) from None


def message(work: Work, path: str) -> Message:
    """A message definition of the workspace; Wrong when it cannot be read."""
    from coursekit.interfaces.errors import InterfaceError
    from coursekit.interfaces.model import Message
    from coursekit.interfaces.parser import parse_file

    file = work.file(path)
    try:
        found = parse_file(file.parents[1].name, file)
    except InterfaceError as error:
        raise Wrong(f"{file.name} that can be read", str(error).replace(str(work.workspace), "~/ros2_ws")) from None
    if not isinstance(found, Message):
        raise Wrong(f"a message definition in {file.name}", "something else")
    return found


def parameters(work: Work, path: str, nodes: Sequence[str]) -> dict[str, dict[str, Any]]:
    """What a parameter file gives each of these nodes, by ROS's own reading; Wrong when ROS cannot read it."""
    from coursekit.core.arguments import parse_ros_arguments

    file = work.file(path)
    try:
        read = parse_ros_arguments(["--ros-args", "--params-file", str(file)])
        return {node: read.parameters_for(node) for node in nodes}
    except Exception as error:
        said = str(error).replace(str(file), file.name)
        raise Wrong("a parameter file that ROS can read", said, "Two underscores in ros__parameters?") from None
