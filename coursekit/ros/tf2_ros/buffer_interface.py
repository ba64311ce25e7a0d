"""The interface of every source of transforms, and the register of types that can be transformed."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any

from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time
from std_msgs.msg import Header

DoTransform = Callable[[Any, TransformStamped], Any]


class TypeException(Exception):
    """Nobody has registered how this type is transformed or converted."""

    def __init__(self, errstr: str) -> None:
        super().__init__(errstr)
        self.errstr = errstr


class NotImplementedException(Exception):
    """A subclass of BufferInterface lacks a lookup."""

    def __init__(self) -> None:
        self.errstr = "CanTransform or LookupTransform not implemented"
        super().__init__(self.errstr)


class BufferInterface:
    """Transforms messages by the lookups that a subclass offers."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self, object_stamped: Any, target_frame: str, timeout: Duration = Duration(), new_type: type | None = None
    ) -> Any:
        """A stamped message in another frame, at its own time; perhaps as another type.

        Raises TypeException for a type that nobody registered (import tf2_geometry_msgs), and as a lookup does.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout)
        return _as(do_transform(object_stamped, found), new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),
        new_type: type | None = None,
    ) -> Any:
        """A stamped message in another frame at another time, by way of a frame that does not move."""
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform_full(target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout)
        return _as(do_transform(object_stamped, found), new_type)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()
    ) -> TransformStamped:
        """The transform from source to target."""
        raise NotImplementedException()

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),
    ) -> TransformStamped:
        """The transform from source at its time to target at its time."""
        raise NotImplementedException()

    def can_transform(self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()) -> bool:
        """Whether `lookup_transform` would succeed."""
        raise NotImplementedException()

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),
    ) -> bool:
        """Whether `lookup_transform_full` would succeed."""
        raise NotImplementedException()


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:
    """The object with a header."""
    obj.header = Header(frame_id=frame_id, stamp=stamp)
    return obj


class TransformRegistration:
    """How each type is transformed; one register for all."""

    _types: dict[type, DoTransform] = {}

    def print_me(self) -> None:
        """Print the register."""
        print(self._types)

    def add(self, key: type, callback: DoTransform) -> None:
        """`callback(message, transform)` transforms messages of type `key`."""
        self._types[key] = callback

    def get(self, key: type) -> DoTransform:
        """The function for a type; TypeException when there is none."""
        if key not in self._types:
            raise TypeException(f"Type {key} is not loaded or supported")
        return self._types[key]


class ConvertRegistration:
    """How types become messages and the other way round; one register for all."""

    _to_msg: dict[Any, Callable[[Any], Any]] = {}
    _from_msg: dict[Any, Callable[[Any], Any]] = {}
    _convert: dict[Any, Callable[[Any], Any]] = {}

    def add_from_msg(self, key: type, callback: Callable[[Any], Any]) -> None:
        """`callback(msg)` makes a `key` of a message."""
        self._from_msg[key] = callback

    def add_to_msg(self, key: type, callback: Callable[[Any], Any]) -> None:
        """`callback(obj)` makes a message of a `key`."""
        self._to_msg[key] = callback

    def add_convert(self, key: tuple[type, type], callback: Callable[[Any], Any]) -> None:
        """`callback(obj)` makes a `key[1]` of a `key[0]`."""
        self._convert[key] = callback

    def get_from_msg(self, key: type) -> Callable[[Any], Any]:
        """The function for a type."""
        return _registered(self._from_msg, key)

    def get_to_msg(self, key: type) -> Callable[[Any], Any]:
        """The function for a type."""
        return _registered(self._to_msg, key)

    def get_convert(self, key: tuple[type, type]) -> Callable[[Any], Any]:
        """The function for a pair of types."""
        return _registered(self._convert, key)


def _registered(functions: dict[Any, Callable[[Any], Any]], key: Any) -> Callable[[Any], Any]:
    if key not in functions:
        raise TypeException(f"Type {key} is not loaded or supported")
    return functions[key]


def convert(a: Any, b_type: type) -> Any:
    """`a` as another type: by a registered function, a copy, or by way of a message."""
    register = ConvertRegistration()
    if (type(a), b_type) in register._convert:
        return register.get_convert((type(a), b_type))(a)
    if type(a) is b_type:
        return deepcopy(a)
    return register.get_from_msg(b_type)(register.get_to_msg(type(a))(a))


def _as(result: Any, new_type: type | None) -> Any:
    return result if new_type is None else convert(result, new_type)
