"""Transforms of points, vectors, poses, wrenches and polygons."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np
from geometry_msgs.msg import (
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    TransformStamped,
    Vector3Stamped,
    WrenchStamped,
)
from tf2_ros import ConvertRegistration, TransformRegistration

from coursekit.geometry.pose import Pose as Numbers
from coursekit.geometry.pose import Quaternion, Vector, matrix, normalized
from coursekit.tf import IDENTITY, compose, rotate

Message = TypeVar("Message")


def to_msg_msg(msg: Message) -> Message:
    """Return the message unchanged."""
    return msg


def from_msg_msg(msg: Message) -> Message:
    """Return the message unchanged."""
    return msg


def _numbers(place: Any, turn: Any) -> Numbers:
    """A position and a quaternion as a pose of coursekit.tf; a quaternion of zeros counts as no rotation."""
    pose = (place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w)
    length = sum(part * part for part in pose[3:])
    if abs(length - 1.0) < 1e-12:
        return pose
    return normalized(pose) if length > 1e-15 else (*pose[:3], *IDENTITY[3:])


def _of(transform: TransformStamped) -> Numbers:
    return _numbers(transform.transform.translation, transform.transform.rotation)


def _moved(motion: Numbers, point: Any) -> Vector:
    x, y, z = rotate(motion[3:], (point.x, point.y, point.z))
    return x + motion[0], y + motion[1], z + motion[2]


def _turn(vector: Any, rotation: Quaternion) -> None:
    vector.x, vector.y, vector.z = rotate(rotation, (vector.x, vector.y, vector.z))


def do_transform_point(point: PointStamped, transform: TransformStamped) -> PointStamped:
    """The point in the transform's frame."""
    result = PointStamped(header=transform.header)
    result.point.x, result.point.y, result.point.z = _moved(_of(transform), point.point)
    return result


def do_transform_vector3(vector3: Vector3Stamped, transform: TransformStamped) -> Vector3Stamped:
    """The vector in the transform's frame: rotated, not translated."""
    result = Vector3Stamped(header=transform.header)
    result.vector.x, result.vector.y, result.vector.z = vector3.vector.x, vector3.vector.y, vector3.vector.z
    _turn(result.vector, _of(transform)[3:])
    return result


def do_transform_pose(pose: Any, transform: TransformStamped) -> Any:
    """The Pose in the transform's frame (a PoseStamped gives a PoseStamped, as in older releases)."""
    if isinstance(pose, PoseStamped):
        return do_transform_pose_stamped(pose, transform)
    x, y, z, i, j, k, w = compose(_of(transform), _numbers(pose.position, pose.orientation))
    sign = -1.0 if w < 0.0 else 1.0
    result = Pose()
    result.position.x, result.position.y, result.position.z = x, y, z
    q = result.orientation
    q.x, q.y, q.z, q.w = sign * i, sign * j, sign * k, sign * w
    return result


def do_transform_pose_stamped(pose: PoseStamped, transform: TransformStamped) -> PoseStamped:
    """The pose in the transform's frame."""
    return PoseStamped(header=transform.header, pose=do_transform_pose(pose.pose, transform))


def transform_covariance(cov_in: Any, transform: TransformStamped) -> np.ndarray[Any, Any]:
    """The rotated 6x6 covariance (36 numbers, row by row)."""
    rotation = np.array(matrix(_of(transform)))[:3, :3]
    blocks = np.asarray(cov_in, dtype=float).reshape(2, 3, 2, 3)
    turned = [[rotation @ blocks[a, :, b, :] @ rotation.T for b in (0, 1)] for a in (0, 1)]
    return np.block(turned).reshape(36)


def do_transform_pose_with_covariance_stamped(
    pose: PoseWithCovarianceStamped, transform: TransformStamped
) -> PoseWithCovarianceStamped:
    """The pose and its covariance in the transform's frame."""
    result = PoseWithCovarianceStamped(header=transform.header)
    result.pose.pose = do_transform_pose(pose.pose.pose, transform)
    result.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    return result


def do_transform_wrench(wrench: WrenchStamped, transform: TransformStamped) -> WrenchStamped:
    """Force and torque rotated into the transform's frame; their point of action stays the same."""
    result = WrenchStamped(header=transform.header)
    for name in ("force", "torque"):
        old, new = getattr(wrench.wrench, name), getattr(result.wrench, name)
        new.x, new.y, new.z = old.x, old.y, old.z
        _turn(new, _of(transform)[3:])
    return result


def do_transform_polygon_stamped(polygon: PolygonStamped, transform: TransformStamped) -> PolygonStamped:
    """The polygon in the transform's frame."""
    result = PolygonStamped(header=transform.header)
    motion = _of(transform)
    for point in polygon.polygon.points:
        x, y, z = _moved(motion, point)
        result.polygon.points.append(Point32(x=x, y=y, z=z))
    return result


_REGISTERED: dict[Any, Any] = {
    PointStamped: do_transform_point,
    Vector3Stamped: do_transform_vector3,
    PoseStamped: do_transform_pose_stamped,
    PoseWithCovarianceStamped: do_transform_pose_with_covariance_stamped,
    WrenchStamped: do_transform_wrench,
    PolygonStamped: do_transform_polygon_stamped,
}
for _type, _do in _REGISTERED.items():
    TransformRegistration().add(_type, _do)
    ConvertRegistration().add_to_msg(_type, to_msg_msg)
    ConvertRegistration().add_from_msg(_type, from_msg_msg)
