"""The interface of every source of transforms, and the registry of types that can be transformed."""

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
    """No function that transforms or converts this type is registered."""

    def __init__(self, errstr: str) -> None:
        super().__init__(errstr)
        self.errstr = errstr


class NotImplementedException(Exception):
    """A subclass of BufferInterface lacks a lookup."""

    def __init__(self) -> None:
        self.errstr = "CanTransform or LookupTransform not implemented"
        super().__init__(self.errstr)


class BufferInterface:
    """Transforms messages with the lookups of a subclass."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self, object_stamped: Any, target_frame: str, timeout: Duration = Duration(), new_type: type | None = None
    ) -> Any:
        """A stamped message in another frame, at its own time, optionally converted to `new_type`.

        Raises TypeException for a type that is not registered (import tf2_geometry_msgs), and the errors of a lookup.

        >>> import tf2_geometry_msgs  # teaches the buffer to transform the messages of geometry_msgs
        >>> from geometry_msgs.msg import PointStamped, TransformStamped
        >>> from tf2_ros import Buffer
        >>> camera = TransformStamped()
        >>> camera.header.frame_id, camera.child_frame_id = "base_link", "camera"
        >>> camera.transform.translation.x = 0.1  # m
        >>> buffer = Buffer()
        >>> buffer.set_transform_static(camera, "example")
        >>> point = PointStamped()
        >>> point.header.frame_id, point.point.x = "camera", 2.0
        >>> buffer.transform(point, "base_link").point.x
        2.1
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        transform = self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout)
        return _as(do_transform(object_stamped, transform), new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),
        new_type: type | None = None,
    ) -> Any:
        """A stamped message in another frame at another time, through a frame that does not move."""
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        transform = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout
        )
        return _as(do_transform(object_stamped, transform), new_type)

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
    """Set the object's header and return the object."""
    obj.header = Header(frame_id=frame_id, stamp=stamp)
    return obj


class TransformRegistration:
    """The function that transforms each type; all instances share one registry."""

    _types: dict[type, DoTransform] = {}

    def print_me(self) -> None:
        """Print the registry."""
        print(self._types)

    def add(self, key: type, callback: DoTransform) -> None:
        """Register `callback(message, transform)`, which transforms messages of type `key`."""
        self._types[key] = callback

    def get(self, key: type) -> DoTransform:
        """The function for a type; raises TypeException if there is none."""
        if key not in self._types:
            raise TypeException(f"Type {key} is not loaded or supported")
        return self._types[key]


class ConvertRegistration:
    """The functions that convert types to messages and back; all instances share one registry."""

    _to_msg: dict[Any, Callable[[Any], Any]] = {}
    _from_msg: dict[Any, Callable[[Any], Any]] = {}
    _convert: dict[Any, Callable[[Any], Any]] = {}

    def add_from_msg(self, key: type, callback: Callable[[Any], Any]) -> None:
        """Register `callback(msg)`, which converts a message to a `key`."""
        self._from_msg[key] = callback

    def add_to_msg(self, key: type, callback: Callable[[Any], Any]) -> None:
        """Register `callback(obj)`, which converts a `key` to a message."""
        self._to_msg[key] = callback

    def add_convert(self, key: tuple[type, type], callback: Callable[[Any], Any]) -> None:
        """Register `callback(obj)`, which converts a `key[0]` to a `key[1]`."""
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
    """Convert `a` to another type: with a registered function, as a copy, or through a message."""
    register = ConvertRegistration()
    if (type(a), b_type) in register._convert:
        return register.get_convert((type(a), b_type))(a)
    if type(a) is b_type:
        return deepcopy(a)
    return register.get_from_msg(b_type)(register.get_to_msg(type(a))(a))


def _as(result: Any, new_type: type | None) -> Any:
    return result if new_type is None else convert(result, new_type)
