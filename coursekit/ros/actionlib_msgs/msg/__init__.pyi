# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import actionlib_msgs.msg
import builtin_interfaces.msg
import std_msgs.msg

class GoalID:
    def __init__(self, *, stamp: builtin_interfaces.msg.Time = ..., id: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def stamp(self) -> builtin_interfaces.msg.Time: ...
    @stamp.setter
    def stamp(self, value: builtin_interfaces.msg.Time) -> None: ...
    @property
    def id(self) -> str: ...
    @id.setter
    def id(self, value: str) -> None: ...

class GoalStatus:
    PENDING: ClassVar[int]
    ACTIVE: ClassVar[int]
    PREEMPTED: ClassVar[int]
    SUCCEEDED: ClassVar[int]
    ABORTED: ClassVar[int]
    REJECTED: ClassVar[int]
    PREEMPTING: ClassVar[int]
    RECALLING: ClassVar[int]
    RECALLED: ClassVar[int]
    LOST: ClassVar[int]
    def __init__(self, *, goal_id: actionlib_msgs.msg.GoalID = ..., status: int = ..., text: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def goal_id(self) -> actionlib_msgs.msg.GoalID: ...
    @goal_id.setter
    def goal_id(self, value: actionlib_msgs.msg.GoalID) -> None: ...
    @property
    def status(self) -> int: ...
    @status.setter
    def status(self, value: int) -> None: ...
    @property
    def text(self) -> str: ...
    @text.setter
    def text(self, value: str) -> None: ...

class GoalStatusArray:
    def __init__(self, *, header: std_msgs.msg.Header = ..., status_list: Collection[actionlib_msgs.msg.GoalStatus] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def header(self) -> std_msgs.msg.Header: ...
    @header.setter
    def header(self, value: std_msgs.msg.Header) -> None: ...
    @property
    def status_list(self) -> list[actionlib_msgs.msg.GoalStatus]: ...
    @status_list.setter
    def status_list(self, value: Collection[actionlib_msgs.msg.GoalStatus]) -> None: ...
