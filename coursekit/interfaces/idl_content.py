"""What an IDL file says, as `rosidl_parser` tells it: structures with members, constants, services, actions.

In ROS 2: rosidl_parser.definition. Comments are not kept.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, TypeVar

from coursekit.interfaces import definition as d
from coursekit.interfaces import model

Element = TypeVar("Element")


class Annotation:
    """A note on what follows it, such as a default."""

    def __init__(self, name: str, value: Any) -> None:
        self.name, self.value = name, value


class Annotatable:
    """Anything that may have notes."""

    def __init__(self) -> None:
        self.annotations: list[Annotation] = []

    def get_annotation_values(self, name: str) -> list[Any]:
        """The values of all notes of that name."""
        return [each.value for each in self.annotations if each.name == name]

    def get_annotation_value(self, name: str) -> Any:
        """The value of the one note of that name; ValueError for none or several."""
        values = self.get_annotation_values(name)
        if len(values) != 1:
            raise ValueError(f"Multiple '{name}' annotations" if values else f"No '{name}' annotation")
        return values[0]

    def has_annotation(self, name: str) -> bool:
        """Whether there is exactly one note of that name."""
        return len(self.get_annotation_values(name)) == 1

    def has_annotations(self, name: str) -> bool:
        """Whether there is any."""
        return bool(self.get_annotation_values(name))

    def get_comment_lines(self) -> list[str]:
        """No comments are kept."""
        return []


class Member(Annotatable):
    """A field of a structure."""

    def __init__(self, type_: d.AbstractType, name: str) -> None:
        super().__init__()
        self.type, self.name = type_, name


class Structure(Annotatable):
    """A type with its members."""

    def __init__(self, namespaced_type: d.NamespacedType, members: list[Member] | None = None) -> None:
        super().__init__()
        self.namespaced_type, self.members = namespaced_type, members or []

    def has_any_member_with_annotation(self, name: str) -> bool:
        """Whether a member has exactly one note of that name."""
        return any(member.has_annotation(name) for member in self.members)


class Constant(Annotatable):
    """A constant of a message."""

    def __init__(self, name: str, type_: d.AbstractType, value: model.Value) -> None:
        super().__init__()
        self.name, self.type, self.value = name, type_, value


class Include:
    """A file that is included."""

    def __init__(self, locator: str) -> None:
        self.locator = locator


class Message:
    """A structure and its constants."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        self.constants: list[Constant] = []


class Service:
    """A request and a response."""

    def __init__(self, namespaced_type: d.NamespacedType, request: Message, response: Message) -> None:
        self.namespaced_type, self.request_message, self.response_message = namespaced_type, request, response


class Action:
    """A goal, a result and a feedback, with the services and the message that carry them."""

    def __init__(self, namespaced_type: d.NamespacedType, goal: Message, result: Message, feedback: Message) -> None:
        self.namespaced_type, self.goal, self.result, self.feedback = namespaced_type, goal, result, feedback
        self.implicit_includes = [Include("builtin_interfaces/msg/Time.idl"), Include("unique_identifier_msgs/msg/UUID.idl")]
        accepted, stamp = d.BasicType("boolean"), d.NamespacedType(["builtin_interfaces", "msg"], "Time")
        answer = [Member(accepted, "accepted"), Member(stamp, "stamp")]
        self.send_goal_service = self._service(d.ACTION_GOAL_SERVICE_SUFFIX, [_goal_id(), _part("goal", goal)], answer)
        self.get_result_service = self._service(
            d.ACTION_RESULT_SERVICE_SUFFIX, [_goal_id()], [Member(d.BasicType("int8"), "status"), _part("result", result)]
        )
        self.feedback_message = self._message(d.ACTION_FEEDBACK_MESSAGE_SUFFIX, [_goal_id(), _part("feedback", feedback)])

    def _service(self, end: str, request: list[Member], response: list[Member]) -> Service:
        parts = (d.SERVICE_REQUEST_MESSAGE_SUFFIX, request), (d.SERVICE_RESPONSE_MESSAGE_SUFFIX, response)
        return Service(self._named(end), *(self._message(end + part, members) for part, members in parts))

    def _message(self, end: str, members: list[Member]) -> Message:
        return Message(Structure(self._named(end), members))

    def _named(self, end: str) -> d.NamespacedType:
        return d.NamespacedType(self.namespaced_type.namespaces, self.namespaced_type.name + end)


class IdlLocator:
    """Where an IDL file is."""

    def __init__(self, basepath: Path, relative_path: str | Path) -> None:
        self.basepath, self.relative_path = Path(basepath), Path(relative_path)

    def get_absolute_path(self) -> Path:
        """The path of the file."""
        return self.basepath / self.relative_path


class IdlContent:
    """All that an IDL file says, in order."""

    def __init__(self) -> None:
        self.elements: list[Any] = []

    def get_elements_of_type(self, type_: type[Element]) -> list[Element]:
        """The elements of one class, such as Message."""
        return [each for each in self.elements if isinstance(each, type_)]


class IdlFile:
    """A file, and what it says."""

    def __init__(self, locator: IdlLocator, content: IdlContent) -> None:
        self.locator, self.content = locator, content


def content_of(interface: model.Interface) -> IdlContent:
    """Return an interface as the elements of its IDL file.

    >>> from coursekit.interfaces.registry import interface_of
    >>> content = content_of(interface_of("std_msgs/msg/Header"))
    >>> [include.locator for include in content.get_elements_of_type(Include)]
    ['builtin_interfaces/msg/Time.idl']
    """
    told = [interface] if isinstance(interface, model.Message) else list(interface.messages())
    messages = [_message(each) for each in told]
    content, named = IdlContent(), d.NamespacedType([told[0].package, told[0].kind], interface.name)
    includes = [Include(f"{name}.idl") for name in dict.fromkeys(name for each in told for name in each.dependencies())]
    if isinstance(interface, model.Message):
        content.elements = [*includes, messages[0]]
    elif isinstance(interface, model.Service):
        content.elements = [*includes, Service(named, *messages)]
    else:
        action = Action(named, *messages)
        content.elements = [*includes, *action.implicit_includes, action]
    return content


def _message(told: model.Message) -> Message:
    named = d.NamespacedType([told.package, told.kind], told.name)
    message = Message(Structure(named, [_member(each) for each in told.fields]))
    message.constants = [Constant(each.name, each.type.slot_type(), each.value) for each in told.constants]
    return message


def _member(field: model.Field) -> Member:
    member = Member(field.type.slot_type(), field.name)
    if field.default is not None:
        value = str(tuple(field.default)) if isinstance(field.default, list) else field.default
        member.annotations.append(Annotation("default", {"value": value}))
    return member


def _goal_id() -> Member:
    return Member(d.NamespacedType(["unique_identifier_msgs", "msg"], "UUID"), "goal_id")


def _part(name: str, message: Message) -> Member:
    return Member(message.structure.namespaced_type, name)
