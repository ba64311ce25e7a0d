# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import builtin_interfaces.msg

class Clock:
    def __init__(self, *, clock: builtin_interfaces.msg.Time = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def clock(self) -> builtin_interfaces.msg.Time: ...
    @clock.setter
    def clock(self, value: builtin_interfaces.msg.Time) -> None: ...
