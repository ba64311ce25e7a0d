# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing


class UUID:
    def __init__(self, *, uuid: Collection[int] | numpy.typing.NDArray[Any] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def uuid(self) -> numpy.typing.NDArray[numpy.uint8]: ...
    @uuid.setter
    def uuid(self, value: Collection[int] | numpy.typing.NDArray[Any]) -> None: ...
